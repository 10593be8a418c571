// Each stage from display-relative XYZ to a PNG's code values, for 1 megapixel on one thread, beside a memory copy of
// the same XYZ picture. Each stage is verified before it is timed; ratios are for one run on one machine.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <variant>

#include <benchmark/benchmark.h>

#include "core/named_value.h"
#include "core/random.h"
#include "display/display_encoder.h"
#include "display/display_gamut.h"
#include "display/display_rgb.h"
#include "display/dither.h"
#include "display/gamut_mapper.h"
#include "display/transfer_encoder.h"
#include "support/alternatives.h"

namespace emulsion {
namespace {

constexpr int kSize_px = 1024;

/// Colours in and around the gamut, Y from 0 to 1.
const Image<XYZ>& display_xyz() {
    static const Image<XYZ> picture = [] {
        Pcg32 random(2);
        Image<XYZ> image(kSize_px, kSize_px);
        for (XYZ& p : image.pixels()) {
            const float luminance = random.next_float();
            p = {luminance * (0.8f + 0.3f * random.next_float()), luminance,
                 luminance * (0.9f + 0.4f * random.next_float())};
        }
        return image;
    }();
    return picture;
}

/// What `stages` stages after XYZ give: 1 linear RGB, 2 in the gamut, 3 encoded.
Image<RGB> picture_after(int stages) {
    Image<RGB> image(kSize_px, kSize_px);
    display_rgb(rgb_from_xyz(Display{}), display_xyz().pixels(), image.pixels());
    if (stages >= 2) benchmark::DoNotOptimize(map_gamut(GamutMapper{}, display_gamut(Display{}), image.pixels()));
    if (stages >= 3) TransferEncoder(TransferFunction{})(image.pixels());
    return image;
}

void count_pixels(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * std::int64_t{kSize_px} * kSize_px);
}

void memory_copy(benchmark::State& state) {
    Image<XYZ> copy(kSize_px, kSize_px);
    for (auto _ : state) {
        std::memcpy(copy.pixels().data(), display_xyz().pixels().data(), display_xyz().pixels().size_bytes());
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

void to_display_rgb(benchmark::State& state) {
    const RgbFromXyz conversion = rgb_from_xyz(Display{});
    Image<RGB> image(kSize_px, kSize_px);
    display_rgb(conversion, display_xyz().pixels(), image.pixels());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const XYZ& p = display_xyz().pixels()[i];
        const RGBd exact = display_rgb(conversion, XYZd{p.x, p.y, p.z});
        if (std::abs(image.pixels()[i].r - exact.r) > 4e-6) return state.SkipWithError("off its twin");
    }
    for (auto _ : state) {
        display_rgb(conversion, display_xyz().pixels(), image.pixels());
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

/// A stage that works in place is timed with the copy that gives it fresh pixels, row by row.
template <class Stage>
void time_in_place(benchmark::State& state, const Image<RGB>& before, const Stage& stage) {
    Image<RGB> image(kSize_px, kSize_px);
    for (auto _ : state) {
        for (int y = 0; y < kSize_px; ++y) {
            const std::span<RGB> row = image.row(y);
            std::memcpy(row.data(), before.row(y).data(), row.size_bytes());
            stage(row);
        }
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

void gamut(benchmark::State& state) {
    const auto mapper = alternative_of_range<GamutMapper>(state);
    const DisplayGamut srgb_gamut = display_gamut(Display{});
    const Image<RGB> before = picture_after(1);
    Image<RGB> after = before;
    benchmark::DoNotOptimize(map_gamut(mapper, srgb_gamut, after.pixels()));
    for (const RGB& p : after.pixels()) {
        for (const float v : {p.r, p.g, p.b}) {
            if (!(v >= 0.0f && v <= 1.0f) && !std::holds_alternative<GamutNone>(mapper))
                return state.SkipWithError("out of gamut");
        }
    }
    time_in_place(state, before,
                  [&](std::span<RGB> row) { benchmark::DoNotOptimize(map_gamut(mapper, srgb_gamut, row)); });
}

void transfer(benchmark::State& state) {
    const auto function = alternative_of_range<TransferFunction>(state);
    const Image<RGB> before = picture_after(2);
    Image<RGB> after = before;
    const TransferEncoder encode_row(function);
    encode_row(after.pixels());
    for (std::size_t i = 0; i < after.pixels().size(); ++i) {
        const double exact = encode(function, static_cast<double>(before.pixels()[i].r));
        if (std::abs(after.pixels()[i].r - exact) > 1.5e-7) return state.SkipWithError("off its twin");
    }
    time_in_place(state, before, [&](std::span<RGB> row) { encode_row(row); });
}

void transfer_twin(benchmark::State& state) {
    const auto function = alternative_of_range<TransferFunction>(state);
    const auto exact = [&](float v) { return static_cast<float>(encode(function, static_cast<double>(v))); };
    time_in_place(state, picture_after(2), [&](std::span<RGB> row) {
        for (RGB& p : row) p = {exact(p.r), exact(p.g), exact(p.b)};
    });
}

void dither(benchmark::State& state) {
    const auto chosen = alternative_of_range<Dither>(state);
    const Image<RGB> encoded = picture_after(3);
    Image<CodeRGB> codes = quantize(chosen, encoded.view(), {}, 1);
    double difference = 0.0;
    for (std::size_t i = 0; i < codes.pixels().size(); ++i) {
        difference += codes.pixels()[i].g / 255.0 - encoded.pixels()[i].g;
    }
    if (std::abs(difference) / (kSize_px * kSize_px) > 1e-4) return state.SkipWithError("mean not kept");
    for (auto _ : state) {
        quantize_into(chosen, encoded.view(), {}, codes.view(), 1);
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

void whole_chain(benchmark::State& state) {
    const auto chosen = alternative_of_range<Dither>(state);
    const RgbFromXyz conversion = rgb_from_xyz(Display{});
    const DisplayGamut srgb_gamut = display_gamut(Display{});
    const DisplayEncoder encode_row(Display{}, own_transfer(Display{}));
    Image<CodeRGB> codes(kSize_px, kSize_px);
    const auto make = [&](int y, int x0, std::span<RGB> pixels) {
        display_rgb(conversion, display_xyz().row(y).subspan(static_cast<std::size_t>(x0), pixels.size()), pixels);
        benchmark::DoNotOptimize(map_gamut(GamutMapper{}, srgb_gamut, pixels));
        benchmark::DoNotOptimize(encode_row(pixels));
    };
    for (auto _ : state) {
        quantize_into(chosen, make, {}, codes.view(), 1);
        benchmark::ClobberMemory();
    }
    if (codes != quantize(chosen, picture_after(3).view(), {}, 1)) state.SkipWithError("differs from its stages");
    count_pixels(state);
}

/// The numbers of all alternatives of a variant.
template <NamedVariant Variant>
void every_alternative(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgName("alternative")->DenseRange(0, static_cast<int>(std::variant_size_v<Variant>) - 1);
    benchmark->Unit(benchmark::kMicrosecond);
}

BENCHMARK(memory_copy)->Unit(benchmark::kMicrosecond);
BENCHMARK(to_display_rgb)->Unit(benchmark::kMicrosecond);
BENCHMARK(gamut)->Apply(every_alternative<GamutMapper>);
BENCHMARK(transfer)->Apply(every_alternative<TransferFunction>);
BENCHMARK(transfer_twin)->Apply(every_alternative<TransferFunction>);
BENCHMARK(dither)->Apply(every_alternative<Dither>);
BENCHMARK(whole_chain)->Apply(every_alternative<Dither>);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
