#include "chart/charts.h"

#include <array>
#include <stdexcept>
#include <string>

#include "core/name_key.h"
#include "core/named_value.h"

namespace emulsion {

namespace {

constexpr std::array kKinds = {
    ChartKind{"models", "transport models on scenes: time and CIEDE2000, at equal samples and in equal time",
              ChartScenes::needed, measure_models_chart},
    ChartKind{"wavelengths", "wavelength strategies by number: time and error of one estimate, by light",
              ChartScenes::none, measure_wavelengths_chart},
    ChartKind{"uplift", "reflectances for RGB colours: time, round trip, and drift under other lights",
              ChartScenes::none, measure_uplift_chart},
    ChartKind{"filters", "reconstruction filters, splatted and importance-sampled: time, aliasing, blur and noise",
              ChartScenes::none, measure_filters_chart},
    ChartKind{"accumulation", "sums of a pixel: time of an addition, error by the number of samples", ChartScenes::none,
              measure_accumulation_chart},
    ChartKind{"tonemap", "tone mapping operators: time, and error against their twins", ChartScenes::none,
              measure_tonemap_chart},
    ChartKind{"transfer", "transfer functions for pictures: time, and error in codes", ChartScenes::none,
              measure_transfer_chart},
    ChartKind{"dither", "dithers: time, and the error that is seen", ChartScenes::none, measure_dither_chart},
    ChartKind{"exr", "compressions of OpenEXR: time, size and loss", ChartScenes::none, measure_exr_chart},
    ChartKind{"scaling", "time, memory and error by pixels, samples, triangles and threads", ChartScenes::none,
              measure_scaling_chart},
};

}  // namespace

std::span<const ChartKind> chart_kinds() { return kKinds; }

Chart measure_chart(std::string_view name, const ChartOptions& options) {
    std::vector<std::string_view> known;
    for (const ChartKind& kind : kKinds) {
        known.push_back(kind.name);
        if (name_key(kind.name) != name_key(name)) continue;
        if (kind.scenes == ChartScenes::needed && options.scenes.empty()) {
            throw std::invalid_argument("chart " + std::string(kind.name) + ": expected at least one scene");
        }
        Chart chart = kind.measure(options);
        validate(chart);
        return chart;
    }
    throw_unknown_name("chart", name, known);
}

}  // namespace emulsion
