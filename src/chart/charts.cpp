#include "chart/charts.h"

#include <array>
#include <stdexcept>
#include <string>

#include "core/name_key.h"
#include "core/named_value.h"

namespace emulsion {

namespace {

constexpr std::array kKinds = {
    ChartKind{"wavelengths", "wavelength strategies by number: time and error of one estimate, by light",
              ChartScenes::none, measure_wavelengths_chart},
    ChartKind{"uplift", "reflectances for RGB colours: time, round trip, and drift under other lights",
              ChartScenes::none, measure_uplift_chart},
    ChartKind{"accumulation", "sums of a pixel: time of an addition, error by the number of samples", ChartScenes::none,
              measure_accumulation_chart},
    ChartKind{"tonemap", "tone mapping operators: time, and error against their twins", ChartScenes::none,
              measure_tonemap_chart},
    ChartKind{"transfer", "transfer functions for pictures: time, and error in codes", ChartScenes::none,
              measure_transfer_chart},
    ChartKind{"dither", "dithers: time, and the error that is seen", ChartScenes::none, measure_dither_chart},
    ChartKind{"exr", "compressions of OpenEXR: time, size and loss", ChartScenes::none, measure_exr_chart},
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
