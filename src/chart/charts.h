#pragma once
// The charts that there are: each measures its points when it is asked for. Seeds are fixed, so that errors are the
// same in every run; times are not.

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "chart/chart.h"

namespace emulsion {

/// Quick charts have fewer sizes and repetitions: they show that all works, and take seconds.
enum class ChartEffort { full, quick };

struct ChartOptions {
    ChartEffort effort = ChartEffort::full;
    std::vector<std::filesystem::path> scenes = {};  ///< of the models' chart, which needs at least one
    int threads = 0;                                 ///< of references; >= 0; 0: one per hardware thread
};

/// Whether a chart is of scenes.
enum class ChartScenes { none, needed };

struct ChartKind {
    std::string_view name;
    std::string_view help;  ///< one line, no full stop
    ChartScenes scenes = ChartScenes::none;
    Chart (*measure)(const ChartOptions&);
};

/// All of them, to iterate.
[[nodiscard]] std::span<const ChartKind> chart_kinds();

/// \throws std::invalid_argument for an unknown name, listing those that exist, and if scenes are needed and missing.
/// What reading of scenes throws.
[[nodiscard]] Chart measure_chart(std::string_view name, const ChartOptions& options);

[[nodiscard]] Chart measure_models_chart(const ChartOptions& options);
[[nodiscard]] Chart measure_wavelengths_chart(const ChartOptions& options);
[[nodiscard]] Chart measure_uplift_chart(const ChartOptions& options);
[[nodiscard]] Chart measure_filters_chart(const ChartOptions& options);
[[nodiscard]] Chart measure_accumulation_chart(const ChartOptions& options);
[[nodiscard]] Chart measure_tonemap_chart(const ChartOptions& options);
[[nodiscard]] Chart measure_transfer_chart(const ChartOptions& options);
[[nodiscard]] Chart measure_dither_chart(const ChartOptions& options);
[[nodiscard]] Chart measure_exr_chart(const ChartOptions& options);
[[nodiscard]] Chart measure_scaling_chart(const ChartOptions& options);

}  // namespace emulsion
