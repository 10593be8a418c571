// Compressions of OpenEXR: time of writing, size of the file, and what the picture loses.

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "chart/charts.h"
#include "chart/measure.h"
#include "chart/test_scene.h"
#include "film/exr_file.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion {

namespace {

/// A folder of this process's own, gone with this object.
class Folder {
  public:
    Folder() : path_(std::filesystem::temp_directory_path() / fmt::format("emulsion-chart-{}", ::getpid())) {
        std::filesystem::create_directory(path_);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  private:
    std::filesystem::path path_;
};

/// Mean CIEDE2000.
double lost(const Image<XYZ>& before, const Image<XYZ>& after) {
    double log_sum = 0.0;
    for (const XYZ& p : before.pixels()) log_sum += std::log(static_cast<double>(p.y));
    const auto pixels = static_cast<double>(before.pixels().size());
    const ViewingConditions viewing = {default_white(cie_1931_2deg()),
                                       white_luminance_of_log_average(std::exp(log_sum / pixels))};
    const auto lab = [&](const XYZ& p) { return lab_as_viewed(XYZd{p.x, p.y, p.z}, viewing); };
    double sum = 0.0;
    for (std::size_t i = 0; i < before.pixels().size(); ++i) {
        sum += difference(Ciede2000Difference{}, lab(before.pixels()[i]), lab(after.pixels()[i]));
    }
    return sum / pixels;
}

}  // namespace

Chart measure_exr_chart(const ChartOptions& options) {
    const bool quick = options.effort == ChartEffort::quick;
    const int side = quick ? 128 : 768;
    const Image<XYZ> scene = chart_scene(side, side);
    const double pixels = static_cast<double>(side) * side;
    Chart chart{.name = "exr",
                .title = "Compressions of OpenEXR",
                .note = fmt::format("{}x{} pixels of linear sRGB with some noise, as 32-bit floats and 16-bit halves. "
                                    "Time of the processor, one thread, without waiting for the disk. Error: mean "
                                    "CIEDE2000 of what is read, white at 1/0.18 of the "
                                    "log-average luminance; less than 1e-6 is drawn there.",
                                    side, side)};
    const ChartAxis time = {.label = "time of writing / of float without compression"};
    chart.panels = {{.title = "Size", .x = time, .y = {.label = "size", .unit = "bytes a pixel"}},
                    {.title = "Loss", .x = time, .y = {.label = "CIEDE2000", .least_drawn = 1e-6}},
                    {.title = "Size and loss",
                     .x = {.label = "size", .unit = "bytes a pixel"},
                     .y = {.label = "CIEDE2000", .least_drawn = 1e-6}}};
    const Folder folder;
    std::vector<Work> works;
    for (const PixelType type : {PixelType::float32, PixelType::half}) {
        for_each_alternative<ExrCompression>([&]<class Compression>(const Compression& compression) {
            const ExrOptions exr{.space = "sRGB", .pixel_type = type, .compression = compression, .threads = 1};
            const std::string series = type == PixelType::half ? "half" : "float", name(Compression::kName);
            const std::filesystem::path file = folder.path() / (series + name + ".exr");
            const Work write = [file, &scene, exr] { write_exr(file, scene, {}, exr); };
            write();
            const double bytes = static_cast<double>(std::filesystem::file_size(file)) / pixels;
            const double error = lost(scene, read_exr(file, {.threads = 1}).xyz);
            chart.panels[0].points.push_back(
                {.series = series, .label = name, .y = exactly(bytes), .details = {{"CIEDE2000", error}}});
            chart.panels[1].points.push_back(
                {.series = series, .label = name, .y = exactly(error), .details = {{"bytes a pixel", bytes}}});
            chart.panels[2].points.push_back(
                {.series = series, .label = name, .x = exactly(bytes), .y = exactly(error)});
            works.push_back(write);
        });
    }
    const ExrOptions plain{.space = "sRGB", .compression = NoCompression{}, .threads = 1};
    const Work baseline = [&] { write_exr(folder.path() / "baseline.exr", scene, {}, plain); };
    const std::vector<RelativeTime> times =
        times_relative_to(baseline, works, {.rounds = quick ? 1 : 5, .least_s = 1e-3});
    // A pixel as it is in memory: three floats
    const TimeDetail speed = {"MB/s", 1e-6 * sizeof(XYZ) * pixels, TimeDetail::Kind::rate};
    set_times(chart.panels[0], times, speed);
    set_times(chart.panels[1], times, speed);
    mark_front(chart.panels[2]);
    return chart;
}

}  // namespace emulsion
