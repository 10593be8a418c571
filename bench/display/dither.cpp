// Dithering of an 8-megapixel picture beside a memory copy of it: three channels to 8 bits by every dither, error
// diffusion beside its plain twin and on two threads, and one channel to one bit. Codes are verified before they are
// timed; ratios are for one run on one machine. Megapixels per CPU-second are "items" where CPU time is printed.

#include "display/dither.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <variant>

#include <benchmark/benchmark.h>

#include "core/named_value.h"
#include "core/random.h"
#include "display/diffuse_plainly.h"
#include "support/alternatives.h"

namespace emulsion {
namespace {

constexpr int kWidth_px = 4096, kHeight_px = 2048;
constexpr CodeScale kOneBit{0, 1};

/// A ramp with some noise.
const Image<RGB>& rgb_picture() {
    static const Image<RGB> picture = [] {
        Pcg32 random(3);
        Image<RGB> image(kWidth_px, kHeight_px);
        for (int y = 0; y < kHeight_px; ++y) {
            for (int x = 0; x < kWidth_px; ++x) {
                const float ramp = 0.9f * static_cast<float>(x) / kWidth_px;
                image(x, y) = {ramp + 0.1f * random.next_float(), 1.0f - ramp, 0.1f * random.next_float()};
            }
        }
        return image;
    }();
    return picture;
}

const Image<float>& grey_picture() {
    static const Image<float> picture = [] {
        Image<float> image(kWidth_px, kHeight_px);
        for (std::size_t i = 0; i < image.pixels().size(); ++i) image.pixels()[i] = rgb_picture().pixels()[i].r;
        return image;
    }();
    return picture;
}

void count_pixels(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * std::int64_t{kWidth_px} * kHeight_px);
}

template <class Pixel>
void copy(benchmark::State& state, const Image<Pixel>& picture) {
    Image<Pixel> copied(kWidth_px, kHeight_px);
    for (auto _ : state) {
        std::memcpy(copied.pixels().data(), picture.pixels().data(), picture.pixels().size_bytes());
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

/// Times a dither on some threads; what one thread makes is the measure of what is right.
template <class Pixel, class Code>
void time_dither(benchmark::State& state, const Dither& dither, const Image<Pixel>& picture, const CodeScale& scale,
                 int threads, Image<Code> codes) {
    quantize_into(dither, picture.view(), scale, codes.view(), threads);
    if (codes != quantize(dither, picture.view(), scale, 1)) return state.SkipWithError("differs from one thread's");
    for (auto _ : state) {
        quantize_into(dither, picture.view(), scale, codes.view(), threads);
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

void rgb_to_8_bits(benchmark::State& state) {
    time_dither(state, alternative_of_range<Dither>(state), rgb_picture(), {}, 1,
                Image<CodeRGB>(kWidth_px, kHeight_px));
}

void grey_to_1_bit(benchmark::State& state) {
    time_dither(state, alternative_of_range<Dither>(state), grey_picture(), kOneBit, 1,
                Image<std::uint16_t>(kWidth_px, kHeight_px));
}

void floyd_steinberg(benchmark::State& state) {
    const FloydSteinberg dither{static_cast<int>(state.range(0))};
    state.SetLabel(to_text(dither));
    time_dither(state, dither, rgb_picture(), {}, static_cast<int>(state.range(1)),
                Image<CodeRGB>(kWidth_px, kHeight_px));
}

void floyd_steinberg_plainly(benchmark::State& state) {
    Image<CodeRGB> codes(kWidth_px, kHeight_px);
    const auto diffuse = [&] {
        diffuse_plainly(kFloydSteinbergKernel, RowOrder::raster, rgb_rows(rgb_picture().view()), {},
                        rgb_rows(codes.view()));
    };
    diffuse();
    if (codes != quantize(FloydSteinberg{}, rgb_picture().view(), {}, 1)) return state.SkipWithError("not the same");
    for (auto _ : state) {
        diffuse();
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

void every_dither(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgName("alternative")->DenseRange(0, static_cast<int>(std::variant_size_v<Dither>) - 1);
    benchmark->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(copy, rgb, rgb_picture())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(copy, grey, grey_picture())->Unit(benchmark::kMillisecond);
BENCHMARK(rgb_to_8_bits)->Apply(every_dither);
BENCHMARK(grey_to_1_bit)->Apply(every_dither);
BENCHMARK(floyd_steinberg_plainly)->Unit(benchmark::kMillisecond);
BENCHMARK(floyd_steinberg)
    ->ArgNames({"scan", "threads"})
    ->Args({kRasterScan, 1})
    ->Args({kRasterScan, 2})
    ->Args({kSerpentineScan, 1})
    ->Args({kHilbertScan, 1})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
