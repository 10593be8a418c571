#include "spectrum/wavelength_importance.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"

namespace emulsion {
namespace {

double sum_of_nanometres(const WavelengthImportance& importance) {
    return std::accumulate(importance.per_nm.begin(), importance.per_nm.end(), 0.0);
}

double exact_sum(const Spectrum& spectrum) {
    const XYZd xyz = xyz_of_radiance(spectrum);
    return (xyz.x + xyz.y + xyz.z) / kLuminousEfficacy;
}

TEST(WavelengthImportance, AddsUpToXPlusYPlusZ) {
    const Spectrum fl11 = tabulated_spectrum("illuminants_5nm", "FL11");
    // Smooth ones, an edge and a narrow bump: sigmoid(1e7 (t - 0.4)), sigmoid(-1e9 (t - 0.4)^2).
    for (const Spectrum& spectrum :
         {fl11, Spectrum(ConstantSpectrum{2.0}), Spectrum(BlackbodySpectrum{2042.0}),
          Spectrum(SigmoidSpectrum{{-40.0, 30.0, -5.0}}), Spectrum(SigmoidSpectrum{{0.0, 1e7, -4e6}}),
          Spectrum(SigmoidSpectrum{{-1e9, 8e8, -1.6e8}})}) {
        const double exact = exact_sum(spectrum);
        EXPECT_NEAR(sum_of_nanometres(wavelength_importance(spectrum)), exact, 1e-9 * exact);
    }
}

// Of a straight line, the mean of its ends.
TEST(WavelengthImportance, OfANanometreIsItsIntegral) {
    const auto at = [](double lambda_nm) {
        const XYZd xyz = eval(cie_1931_2deg(), lambda_nm);
        return xyz.x + xyz.y + xyz.z;
    };
    const WavelengthImportance importance = wavelength_importance(ConstantSpectrum{1.0});
    EXPECT_NEAR(importance.per_nm[190], 0.5 * (at(550.0) + at(551.0)), 1e-14);
    EXPECT_NEAR(importance.per_nm[469], 0.5 * (at(829.0) + at(830.0)), 1e-14);
}

// A band of 0.02 nm, 1 high: between the knots of its own, no grid is needed to find it.
TEST(WavelengthImportance, FindsBandsNarrowerThanANanometre) {
    const Spectrum band = PiecewiseLinearSpectrum{{550.30, 550.31, 550.32}, {0.0, 1.0, 0.0}};
    const double exact = exact_sum(band);
    const WavelengthImportance importance = wavelength_importance(band);
    EXPECT_NEAR(importance.per_nm[190], exact, 1e-9 * exact);
    EXPECT_NEAR(sum_of_nanometres(importance), exact, 1e-9 * exact);
}

// Also on a continuum, under a reflector, and as narrow Gaussians: those belong to their nanometres.
TEST(WavelengthImportance, FindsGaussiansInTheirNanometre) {
    // The observer is a straight line there, so that a Gaussian counts with its mean.
    const XYZd xyz = eval(cie_1931_2deg(), 546.5);
    const double expected = 2.0 * (xyz.x + xyz.y + xyz.z);
    for (const double fwhm_nm : {1e-6, 1e-3, 0.1}) {
        const WavelengthImportance importance = wavelength_importance(LineSpectrum{{}, {{546.5, fwhm_nm, 2.0}}});
        EXPECT_TRUE(importance.lines.empty());
        EXPECT_NEAR(importance.per_nm[186], expected, 1e-9 * expected) << fwhm_nm;
        EXPECT_NEAR(sum_of_nanometres(importance), importance.per_nm[186], 1e-12);
    }
}

TEST(WavelengthImportance, LinesCountInTheSameMeasure) {
    const std::vector<Line> lines = {{360.0, 1.0}, {435.8, -3.0}, {700.0, 2.0}, {830.0, 1.0}};
    const WavelengthImportance importance = wavelength_importance(LineSpectrum{lines, {}});
    ASSERT_EQ(importance.lines.size(), 4u);
    EXPECT_EQ(sum_of_nanometres(importance), 0.0);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const XYZd xyz = eval(cie_1931_2deg(), lines[i].lambda_nm);
        EXPECT_EQ(importance.lines[i].lambda_nm, lines[i].lambda_nm);
        EXPECT_NEAR(importance.lines[i].importance, std::abs(lines[i].power) * (xyz.x + xyz.y + xyz.z), 1e-14);
    }
}

TEST(WavelengthImportance, LeavesOutLinesThatCantBeSeen) {
    const LineSpectrum mercury = {{{253.65, 100.0}, {546.07, 1.0}, {1013.98, 5.0}}, {}};
    const WavelengthImportance importance = wavelength_importance(mercury);
    ASSERT_EQ(importance.lines.size(), 1u);
    EXPECT_EQ(importance.lines[0].lambda_nm, 546.07);
}

TEST(WavelengthImportance, OfNegativeLightIsThatOfItsMagnitude) {
    EXPECT_EQ(wavelength_importance(ConstantSpectrum{-1.0}), wavelength_importance(ConstantSpectrum{1.0}));
}

TEST(LinePowers, HaveTheNumbersOfTheScene) {
    const Spectrum mercury = LineSpectrum{{{253.65, 9.0}, {435.83, 1.0}, {546.07, 2.0}}, {}};
    const Spectrum sodium = LineSpectrum{{{589.0, 4.0}, {546.07, 3.0}}, {}};
    const Spectrum lamp = BlackbodySpectrum{3000.0};
    const WavelengthImportance scene = wavelength_importance(sum_of(sum_of(mercury, lamp), sodium));
    EXPECT_EQ(line_powers(mercury, scene), (std::vector<double>{1.0, 2.0, 0.0}));
    EXPECT_EQ(line_powers(sodium, scene), (std::vector<double>{0.0, 3.0, 4.0}));
    EXPECT_EQ(line_powers(lamp, scene), (std::vector<double>{0.0, 0.0, 0.0}));
}

TEST(LinePowers, RefuseLinesThatWouldBeMissed) {
    const WavelengthImportance scene = wavelength_importance(LineSpectrum{{{435.83, 1.0}}, {}});
    try {
        (void)line_powers(LineSpectrum{{{589.0, 1.0}}, {}}, scene);
        FAIL() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(
            error.what(),
            "line of the light: lambda_nm is 589: expected one of the lines that the wavelengths are drawn from");
    }
}

TEST(WavelengthImportance, ValidateNamesWhatIsWrong) {
    const auto message_of = [](const WavelengthImportance& importance) {
        try {
            validate(importance);
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    WavelengthImportance importance;
    EXPECT_EQ(message_of(importance), "importance: the sum is 0: expected a finite number > 0");
    importance.lines = {{500.0, 1.0}};
    EXPECT_EQ(message_of(importance), "accepted");
    importance.lines = {{500.0, -1.0}};
    EXPECT_EQ(message_of(importance), "line 0: importance is -1: expected a finite number >= 0");
    importance.lines = {{253.65, 1.0}};
    EXPECT_EQ(message_of(importance), "line 0: lambda_nm is 253.65: expected a wavelength in [360, 830]");
    importance.lines.assign(kMaxWavelengthLines + 1, {500.0, 1.0});
    EXPECT_EQ(message_of(importance), "importance: the number of lines is 3627: expected at most 3626");
    importance.lines.clear();
    importance.per_nm[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(message_of(importance), "importance: per_nm[3] is nan: expected a finite number >= 0");
    importance.per_nm.fill(1e308);
    EXPECT_EQ(message_of(importance), "importance: the sum is inf: expected a finite number > 0");
}

}  // namespace
}  // namespace emulsion
