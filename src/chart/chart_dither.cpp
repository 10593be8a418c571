// Dithers: time, and what an eye sees of the error.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "chart/charts.h"
#include "chart/measure.h"
#include "chart/visual_filter.h"
#include "core/named_value.h"
#include "display/dither.h"

namespace emulsion {

namespace {

constexpr double kPixelsPerDegree = 67.0;  // 3840x2160 pixels on 27 inches at 60 cm

/// Smooth: ramps and waves, so that what a quantizer does to it is seen.
Image<float> smooth_picture(int side) {
    Image<float> picture(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(side);
            const float v = static_cast<float>(y) / static_cast<float>(side);
            picture(x, y) = 0.5f + 0.3f * std::sin(6.2831853f * u) + 0.18f * std::cos(6.2831853f * (2.0f * v + u));
        }
    }
    return picture;
}

double visible_error(const Dither& dither, const Image<float>& picture, const CodeScale& scale) {
    const Image<std::uint16_t> codes = quantize(dither, picture.view(), scale, 1);
    Image<double> error(picture.width(), picture.height());
    for (std::size_t i = 0; i < error.pixels().size(); ++i) {
        error.pixels()[i] =
            static_cast<double>(codes.pixels()[i]) / scale.white - static_cast<double>(picture.pixels()[i]);
    }
    return visible_rms(error, kPixelsPerDegree);
}

ChartPanel measured(int bits, int side, const ChartOptions& options) {
    const CodeScale scale = code_scale(bits, FullRange{});
    const Image<float> picture = smooth_picture(side);
    ChartPanel panel{.title = fmt::format("{} bit{}", bits, bits == 1 ? "" : "s"),
                     .x = {.label = "time / time of a memory copy"},
                     .y = {.label = "visible RMS error", .unit = "of white"}};
    std::vector<Work> works;
    for_each_alternative<Dither>([&]<class Kind>(const Kind& kind) {
        const Dither dither = kind;
        panel.points.push_back({.series = std::string(Kind::kName),
                                .label = std::string(Kind::kName),
                                .y = exactly(visible_error(dither, picture, scale))});
        works.push_back([dither, scale, picture, codes = Image<std::uint16_t>(side, side)]() mutable {
            quantize_into(dither, picture.view(), scale, codes.view(), 1);
            keep(codes.pixels()[0]);
        });
    });
    const Work copy = [picture, copied = Image<float>(side, side)]() mutable {
        std::memcpy(copied.pixels().data(), picture.pixels().data(), picture.pixels().size_bytes());
        keep(copied.pixels()[0]);
    };
    set_times(panel, times_relative_to(copy, works, timing_options(options)),
              {"Mpix/s", 1e-6 * side * side, TimeDetail::Kind::rate});
    return panel;
}

}  // namespace

Chart measure_dither_chart(const ChartOptions& options) {
    const int side = options.effort == ChartEffort::quick ? 128 : 512;
    Chart chart{.name = "dither",
                .title = "Dithers, and what is seen of their error",
                .note = fmt::format("{0}x{0} pixels of one channel, one thread. Error: codes minus encoded values, RMS "
                                    "behind the contrast sensitivity of Mannos & Sakrison (low-pass below its peak) at "
                                    "{1} pixels a degree: 3840x2160 on 27 inches at 60 cm.",
                                    side, kPixelsPerDegree)};
    for (const int bits : {1, 4}) chart.panels.push_back(measured(bits, side, options));
    return chart;
}

}  // namespace emulsion
