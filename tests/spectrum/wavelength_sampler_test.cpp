#include "spectrum/wavelength_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "support/chi_square.h"
#include "wavelength_lights.h"

namespace emulsion {
namespace {

// Every strategy with its defaults.
template <class Strategy>
class WavelengthStrategies : public ::testing::Test {
  protected:
    static WavelengthSampler sampler_for(const LitReflector& lit) { return prepare(Strategy{}, importance_of(lit)); }
    static constexpr bool sees_lines() { return std::is_same_v<Strategy, HeroLines>; }
};
template <class Variant>
struct AsTypes;
template <class... Ts>
struct AsTypes<std::variant<Ts...>> {
    using Types = ::testing::Types<Ts...>;
};
TYPED_TEST_SUITE(WavelengthStrategies, AsTypes<WavelengthStrategy>::Types);

// One sample of N wavelengths estimates XYZ without bias. Each |mean - exact| is within 4.75 standard errors, plus the
// 1e-6 that single precision may cost: 6 strategies x 6 counts x up to 4 lights x 3 components are at most 378
// comparisons of 2e-6 each, so that a right program fails by chance in less than one seed of a thousand.
TYPED_TEST(WavelengthStrategies, EstimateXyzWithoutBias) {
    constexpr double kStandardErrors = 4.75;
    constexpr int kEstimates = 4000;
    std::vector<LitReflector> all = {lit_by("D65", green_reflectance()), lit_by("FL11")};
    if (this->sees_lines()) {
        all.push_back(lit_by_lines());
        all.push_back(lit_by_lines(green_reflectance()));
    }
    for (const LitReflector& lit : all) {
        const WavelengthSampler sampler = this->sampler_for(lit);
        const XYZd xyz = exact_xyz(lit);
        const std::array<double, 3> exact = {xyz.x, xyz.y, xyz.z};
        for_each_wavelength_count([&]<int N>() {
            Pcg32 random(N, 11);
            Moments moments;
            for (int i = 0; i < kEstimates; ++i) {
                moments.add(estimated_xyz(lit, sample_wavelengths<N>(sampler, [&] { return random.next_float(); })));
            }
            for (std::size_t c = 0; c < 3; ++c) {
                const double tolerance = kStandardErrors * moments.deviation(c) / std::sqrt(kEstimates);
                EXPECT_NEAR(moments.mean(c), exact[c], tolerance + 1e-6 * exact[c]) << lit.name << ' ' << N << ' ' << c;
            }
        });
    }
}

// Light that the density was not made for: nothing of it is missed either.
TYPED_TEST(WavelengthStrategies, AreUnbiasedForLightThatTheyWereNotMadeFor) {
    constexpr double kStandardErrors = 4.2;  // 18 comparisons of 2.7e-5 each: 1 seed in 2000
    constexpr int kEstimates = 20000;
    const WavelengthSampler sampler = this->sampler_for(lit_by("HP1"));
    const LitReflector lit = lit_by("FL11");
    const XYZd xyz = exact_xyz(lit);
    const std::array<double, 3> exact = {xyz.x, xyz.y, xyz.z};
    Pcg32 random(1, 12);
    Moments moments;
    for (int i = 0; i < kEstimates; ++i) {
        moments.add(estimated_xyz(lit, sample_wavelengths<4>(sampler, [&] { return random.next_float(); })));
    }
    for (std::size_t c = 0; c < 3; ++c) {
        const double tolerance = kStandardErrors * moments.deviation(c) / std::sqrt(kEstimates);
        EXPECT_NEAR(moments.mean(c), exact[c], tolerance) << c;
    }
}

TYPED_TEST(WavelengthStrategies, DensityAndMassesAddUpToOne) {
    const LitReflector lit = lit_by_lines();
    const WavelengthSampler sampler = this->sampler_for(lit);
    double total = 0.0;
    for (std::size_t i = 0; i < lit.lines.size(); ++i) total += line_mass(sampler, i);
    EXPECT_EQ(total > 0.0, this->sees_lines());
    // Simpson's rule by nanometre, from inside; 1e-9 for the ends that this leaves out.
    for (double a = 360.0 + 1e-12; a < 830.0; a += 1.0) {
        const double b = a + 1.0 - 2e-12;
        total +=
            (wavelength_pdf(sampler, a) + 4.0 * wavelength_pdf(sampler, 0.5 * (a + b)) + wavelength_pdf(sampler, b)) /
            6.0;
    }
    EXPECT_NEAR(total, 1.0, 1e-9);
}

// Probability of [from_nm, from_nm + width_nm], whole nanometres.
double probability_of(const WavelengthSampler& sampler, double from_nm, int width_nm) {
    double sum = 0.0;
    for (int i = 0; i < width_nm; ++i) {
        const double a = from_nm + i + 1e-12, b = from_nm + i + 1.0 - 1e-12;
        sum += (wavelength_pdf(sampler, a) + 4.0 * wavelength_pdf(sampler, 0.5 * (a + b)) + wavelength_pdf(sampler, b));
    }
    return sum / 6.0;
}

// One of four wavelengths, picked at random, has the density that it says: chi^2 over bins of 10 nm and the lines. Six
// strategies: together they raise a false alarm in one seed of 5000.
TYPED_TEST(WavelengthStrategies, SamplesFollowTheDensity) {
    constexpr int kSamples = 20000, kBinWidth_nm = 10;
    constexpr std::size_t kBins = kWavelengthCells / kBinWidth_nm;
    const LitReflector lit = lit_by_lines();
    const WavelengthSampler sampler = this->sampler_for(lit);
    std::vector<double> observed(kBins + lit.lines.size());
    Pcg32 random(5, 13);
    for (int sample = 0; sample < kSamples; ++sample) {
        const auto wavelengths = sample_wavelengths<4>(sampler, [&] { return random.next_float(); });
        const std::size_t i = random.next() % 4;
        const double above = static_cast<double>(wavelengths.lambda_nm[i]) - kMinWavelength_nm;
        auto bin = std::min(static_cast<std::size_t>(above / kBinWidth_nm), kBins - 1);
        if (wavelengths.line[i] != kNoLine) bin = kBins + static_cast<std::size_t>(wavelengths.line[i]);
        observed[bin] += 1.0;
    }
    std::vector<double> expected;
    for (std::size_t bin = 0; bin < observed.size(); ++bin) {
        const double from_nm = kMinWavelength_nm + static_cast<double>(bin) * kBinWidth_nm;
        const double probability =
            bin < kBins ? probability_of(sampler, from_nm, kBinWidth_nm) : line_mass(sampler, bin - kBins);
        expected.push_back(kSamples * probability);
    }
    EXPECT_GT(testing::chi_square_test(observed, expected).p_value, testing::sidak_level(2e-4, 6));
}

// The same numbers give the same wavelengths: lambda within 1e-4 nm, density within 1e-6, at u = 0 and u -> 1 too.
TYPED_TEST(WavelengthStrategies, FastPathFollowsItsTwin) {
    const WavelengthSampler sampler = this->sampler_for(lit_by_lines());
    for_each_wavelength_count([&]<int N>() {
        Pcg32 random(N, 14);
        for (int i = 0; i < 2000; ++i) {
            const std::uint64_t seed = random.next();
            const float fixed = i == 0 ? 0.0f : 1.0f - 0x1p-24f;
            const auto source = [&](Pcg32& generator) { return i < 2 ? fixed : generator.next_float(); };
            Pcg32 fast_numbers(seed), exact_numbers(seed);
            const auto fast = sample_wavelengths<N>(sampler, [&] { return source(fast_numbers); });
            const auto exact = sample_wavelengths_reference<N>(sampler, [&] { return source(exact_numbers); });
            for (std::size_t k = 0; k < N; ++k) {
                ASSERT_EQ(fast.line[k], exact[k].line);
                ASSERT_NEAR(static_cast<double>(fast.lambda_nm[k]), exact[k].lambda_nm, 1e-4);
                ASSERT_NEAR(static_cast<double>(fast.pdf[k]), exact[k].pdf, 1e-6 * exact[k].pdf);
                ASSERT_GE(fast.lambda_nm[k], static_cast<float>(kMinWavelength_nm));
                ASSERT_LE(fast.lambda_nm[k], static_cast<float>(kMaxWavelength_nm));
            }
            EXPECT_EQ(fast_numbers.next(), exact_numbers.next()) << "the twins take as many numbers";
        }
    });
}

TYPED_TEST(WavelengthStrategies, CanBePrintedAndParsed) {
    const WavelengthStrategy strategy = TypeParam{};
    EXPECT_EQ(parse_named<WavelengthStrategy>(to_text(strategy), "wavelengths"), strategy);
}

TEST(WavelengthStrategy, DefaultIsTheRenderers) {
    EXPECT_TRUE(std::holds_alternative<HeroVisible>(WavelengthStrategy{}));
    const WavelengthSampler sampler = prepare(WavelengthStrategy{}, {});
    const auto general = sample_wavelengths<4>(sampler, [] { return 0.3f; });
    const SampledWavelengths<4> own = hero_wavelengths<4>(VisibleWavelengthPdf{}, 0.3f);
    EXPECT_EQ(general.lambda_nm, own.lambda_nm);
    EXPECT_EQ(general.pdf, own.pdf);
}

TEST(WavelengthStrategy, RefusesBadParametersAndLightWithoutPower) {
    const WavelengthImportance light = importance_of(lit_by("D65"));
    EXPECT_THROW((void)prepare(HeroLines{0.001f}, light), std::invalid_argument);
    EXPECT_THROW((void)prepare(HeroIlluminant{1.5f}, light), std::invalid_argument);
    EXPECT_THROW((void)prepare(HeroIlluminant{}, {}), std::invalid_argument);
    EXPECT_THROW((void)parse_named<WavelengthStrategy>("hero-lines:uniform-share=2", "wavelengths"),
                 std::invalid_argument);
}

// By rotation a line of mass m is among N wavelengths floor(m N) to ceil(m N) times, whatever u.
TEST(HeroLines, SpreadsEachLineEvenly) {
    const LitReflector lit = lit_by_lines();
    const LineWavelengthPdf distribution(importance_of(lit));
    for_each_wavelength_count([&]<int N>() {
        for (int k = 0; k < 500; ++k) {
            const auto wavelengths = hero_wavelengths<N>(distribution, static_cast<float>(k) / 500.0f);
            for (std::size_t line = 0; line < lit.lines.size(); ++line) {
                const auto drawn = static_cast<double>(
                    std::count(wavelengths.line.begin(), wavelengths.line.end(), static_cast<std::int32_t>(line)));
                const double mean = distribution.mass(line) * N;
                ASSERT_GE(drawn, std::floor(mean)) << N << ' ' << line;
                ASSERT_LE(drawn, std::ceil(mean)) << N << ' ' << line;
            }
        }
    });
}

// Scenes whose lights have no lines lose nothing by asking for them.
TEST(HeroLines, WithoutLinesIsHeroIlluminant) {
    const WavelengthImportance light = importance_of(lit_by("FL11"));
    const LineWavelengthPdf lines(light);
    const TabulatedWavelengthPdf plain(light);
    for (const float u : {0.0f, 0.123f, 0.5f, 0.999f}) {
        const auto a = hero_wavelengths<8>(lines, u);
        const auto b = hero_wavelengths<8>(plain, u);
        EXPECT_EQ(a.lambda_nm, b.lambda_nm);
        EXPECT_EQ(a.pdf, b.pdf);
        for (const std::int32_t line : a.line) EXPECT_EQ(line, kNoLine);
    }
}

// The relative RMS error of white Y of one sample of four rotated wavelengths, over all u: one period of the rotation,
// at `count` places.
template <class WavelengthsAt>
double rms_error_of_y(const LitReflector& lit, WavelengthsAt&& wavelengths_at_u, int count = 20000) {
    Moments moments;
    for (int i = 0; i < count; ++i) {
        const float u = static_cast<float>((i + 0.5) / (4.0 * count));
        SampledLineWavelengths<4> wavelengths;
        static_cast<SampledWavelengths<4>&>(wavelengths) = wavelengths_at_u(u);
        wavelengths.line.fill(kNoLine);
        moments.add(estimated_xyz(lit, wavelengths));
    }
    return moments.deviation(1) / moments.mean(1);
}

// What is known of FL11: near 1.1. Where the uniform density ends decides: it is 1.197 over the range of the observer,
// which is ours, and 1.044 over the range of the table, 380-780 nm. Both from a program of their own, in double
// precision, by the midpoint rule over u.
TEST(HeroUniform, FourWavelengthsOnFl11AreAsBadAsIsKnown) {
    const LitReflector fl11 = lit_by("FL11");
    const UniformWavelengthPdf uniform;
    EXPECT_NEAR(rms_error_of_y(fl11, [&](float u) { return hero_wavelengths<4>(uniform, u); }), 1.1968, 5e-4);
    const auto narrower = [](float u) {
        SampledWavelengths<4> wavelengths;
        for (std::size_t i = 0; i < 4; ++i) {
            wavelengths.lambda_nm[i] = 380.0f + 400.0f * (u + 0.25f * static_cast<float>(i));
            wavelengths.pdf[i] = 1.0f / 400.0f;
        }
        return wavelengths;
    };
    EXPECT_NEAR(rms_error_of_y(fl11, narrower), 1.0435, 5e-4);
}

// By random numbers rather than over all u: within 5% of the exact 1.197, the standard error being 1.2%.
TEST(HeroUniform, RandomEstimatesOnFl11HaveThatError) {
    const LitReflector fl11 = lit_by("FL11");
    const WavelengthSampler sampler = prepare(HeroUniform{}, {});
    Pcg32 random(2, 15);
    Moments moments;
    for (int i = 0; i < 20000; ++i) {
        moments.add(estimated_xyz(fl11, sample_wavelengths<4>(sampler, [&] { return random.next_float(); })));
    }
    EXPECT_NEAR(moments.deviation(1) / exact_xyz(fl11).y, 1.197, 0.05 * 1.197);
}

TEST(HeroIlluminant, FourWavelengthsOnFl11AreBelow15Percent) {
    const LitReflector fl11 = lit_by("FL11");
    const TabulatedWavelengthPdf distribution(importance_of(fl11));
    const double error = rms_error_of_y(fl11, [&](float u) { return hero_wavelengths<4>(distribution, u); });
    EXPECT_LT(error, 0.15);
    // From the same other program.
    EXPECT_NEAR(error, 0.1142, 5e-4);
}

// Lines are no harder than smooth light: the error is of the size that it has without lines.
TEST(HeroLines, FourWavelengthsOnLinesAreBelow20Percent) {
    const LitReflector lit = lit_by_lines();
    const LineWavelengthPdf distribution(importance_of(lit));
    Moments moments;
    for (int i = 0; i < 20000; ++i) {
        moments.add(estimated_xyz(lit, hero_wavelengths<4>(distribution, static_cast<float>((i + 0.5) / 80000.0))));
    }
    EXPECT_LT(moments.deviation(1) / moments.mean(1), 0.2);
}

}  // namespace
}  // namespace emulsion
