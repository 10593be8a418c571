// Transfer functions for pictures, in single precision, beside their definitions in double precision.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "chart/charts.h"
#include "chart/measure.h"
#include "core/random.h"
#include "display/transfer_encoder.h"

namespace emulsion {

namespace {

constexpr std::size_t kPixels = 1024;
constexpr double kCodes = 65535.0;

std::vector<RGB> linear_pixels(std::size_t count) {
    Pcg32 random(5);
    std::vector<RGB> pixels(count);
    for (RGB& p : pixels) p = {random.next_float(), random.next_float(), random.next_float()};
    return pixels;
}

void encode_by_definition(const TransferFunction& transfer, std::vector<RGB>& pixels) {
    const auto encoded = [&](float v) { return static_cast<float>(encode(transfer, static_cast<double>(v))); };
    for (RGB& p : pixels) p = {encoded(p.r), encoded(p.g), encoded(p.b)};
}

/// The largest error, in codes of 16 bits, over random values and over small ones of every octave.
template <class Encode>
double largest_error(const TransferFunction& transfer, int count, const Encode& encode_pixels) {
    std::vector<RGB> pixels = linear_pixels(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const float octave = std::ldexp(1.0f, -static_cast<int>(i % 24));
        pixels[i] = {octave * pixels[i].r, octave * pixels[i].g, pixels[i].b};
    }
    const std::vector<RGB> linear = pixels;
    encode_pixels(pixels);
    double largest = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (float RGB::*channel : {&RGB::r, &RGB::g, &RGB::b}) {
            const double exact = std::clamp(encode(transfer, static_cast<double>(linear[i].*channel)), 0.0, 1.0);
            largest = std::max(largest, kCodes * std::abs(static_cast<double>(pixels[i].*channel) - exact));
        }
    }
    return largest;
}

/// In-place stages get fresh pixels by a copy.
template <class Encode>
Work timed_encoding(const Encode& encode_pixels) {
    return [encode_pixels, linear = linear_pixels(kPixels), pixels = linear_pixels(kPixels)]() mutable {
        std::memcpy(pixels.data(), linear.data(), kPixels * sizeof(RGB));
        encode_pixels(pixels);
        keep(pixels[0]);
    };
}

}  // namespace

Chart measure_transfer_chart(const ChartOptions& options) {
    const int count = options.effort == ChartEffort::quick ? 2000 : 200000;
    Chart chart{.name = "transfer",
                .title = "Transfer functions for pictures",
                .note =
                    "Time of encoding 1024 pixels in place, their copy included. Error: the largest found, in codes of "
                    "16 bits, against the definition in double precision. "
                    "\"Definition\" is that, rounded to single precision. No error is drawn at 1e-4."};
    ChartPanel& panel = chart.panels.emplace_back();
    panel.x.label = "time / time of srgb for pictures";
    panel.y = {.label = "largest error", .unit = "16-bit codes", .least_drawn = 1e-4};
    std::vector<Work> works;
    for_each_alternative<TransferFunction>([&]<class Transfer>(const Transfer& transfer) {
        const auto add = [&](const char* series, const auto& encode_pixels) {
            panel.points.push_back({.series = series,
                                    .label = std::string(Transfer::kName),
                                    .y = exactly(largest_error(transfer, count, encode_pixels))});
            works.push_back(timed_encoding(encode_pixels));
        };
        add("for pictures", [encoder = TransferEncoder(transfer)](std::vector<RGB>& pixels) { encoder(pixels); });
        add("definition", [transfer](std::vector<RGB>& pixels) { encode_by_definition(transfer, pixels); });
    });
    const Work baseline =
        timed_encoding([encoder = TransferEncoder(SrgbTransfer{})](std::vector<RGB>& pixels) { encoder(pixels); });
    const std::vector<RelativeTime> times = times_relative_to(baseline, works, timing_options(options));
    set_times(panel, times, {.name = "ns a pixel", .factor = 1e9 / kPixels});
    return chart;
}

}  // namespace emulsion
