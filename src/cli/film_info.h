#pragma once
// What `emulsion info` has to say of an EXR.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/info_report.h"
#include "film/exr_info.h"
#include "film/film_state.h"
#include "tonemap/luminance_statistics.h"

namespace emulsion::cli {

struct FilmInfo {
    std::filesystem::path path;
    std::uintmax_t bytes = 0;
    ExrInfo exr;
    std::optional<FilmState> state;  ///< of a film state
    // Of a picture.
    std::optional<LuminanceStatistics> luminance;
    double dynamic_range_zones = 0.0;  ///< see dynamic_range_zones()
    double white_luminance_cdm2 = 1.0;
    std::vector<std::string> notes = {};  ///< of read_exr(), or why there is no picture
};

/// Reads all of the file. \throws IoError if it can't be read, or is damaged.
[[nodiscard]] FilmInfo read_film_info(const std::filesystem::path& path, int threads);

[[nodiscard]] InfoReport report_of(const FilmInfo& info);

}  // namespace emulsion::cli
