#include "cli/picture_output.h"

#include <optional>

#include <fmt/format.h>

#include "cli/messages.h"
#include "cli/option_checks.h"
#include "film/pfm_file.h"
#include "film/radiance_file.h"

namespace emulsion::cli {

namespace {

std::optional<PictureFormat> format_of(const std::filesystem::path& name) {
    const std::string extension = name.extension();
    if (extension == ".png" || extension == ".PNG") return PictureFormat::png;
    if (extension == ".pfm" || extension == ".PFM") return PictureFormat::pfm;
    if (extension == ".hdr" || extension == ".HDR") return PictureFormat::radiance;
    return std::nullopt;
}

void warn_of(const RadianceWriteResult& result, const std::filesystem::path& path) {
    const auto warn = [&](std::int64_t count, const char* what) {
        if (count > 0) print_warning(fmt::format("{}: {} {}", path.string(), count, what));
    };
    warn(result.negative_count, "components below 0 (colours outside Rec. 709) are stored as 0; a .pfm holds them");
    warn(result.too_high_count, "components above 1.69e38 are stored as that");
    warn(result.non_finite_count, "components that are not finite are stored as 0 or 1.69e38");
}

}  // namespace

PictureFormat picture_format(const std::filesystem::path& name) { return format_of(name).value_or(PictureFormat::png); }

std::string ends_in_picture(const std::string& name) {
    if (format_of(name)) return {};
    return found_expected(name, "a name ending in .png, .pfm or .hdr");
}

void write_scene_referred(const Image<XYZ>& scene, const std::filesystem::path& path) {
    if (picture_format(path) == PictureFormat::pfm) {
        write_pfm(path, scene);
    } else {
        warn_of(write_radiance(path, scene), path);
    }
}

}  // namespace emulsion::cli
