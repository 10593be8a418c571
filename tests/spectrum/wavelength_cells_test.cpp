#include "spectrum/wavelength_cells.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "spectrum/data_table.h"
#include "wavelength_lights.h"

namespace emulsion {
namespace {

struct Case {
    const char* name;
    WavelengthImportance importance;
    float uniform_share;
};

WavelengthImportance one_nanometre(std::size_t nm) {
    WavelengthImportance importance;
    importance.per_nm[nm] = 1.0;
    return importance;
}

WavelengthImportance only_lines(std::size_t count) {
    WavelengthImportance importance;
    for (std::size_t i = 0; i < count; ++i) {
        importance.lines.push_back({360.0 + 470.0 * static_cast<double>(i) / static_cast<double>(count - 1), 1.0});
    }
    return importance;
}

// Lines at both ends, two at one wavelength, one without power, not in order.
WavelengthImportance odd_lines() {
    WavelengthImportance importance = importance_of(lit_by("D65"));
    importance.lines = {{830.0, 20.0}, {500.0, 30.0}, {360.0, 5.0}, {500.0, 10.0}, {499.5, 0.0}};
    return importance;
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const float share : {1.0f / 64.0f, kDefaultUniformShare, 1.0f}) {
        all.push_back({"FL11", importance_of(lit_by("FL11")), share});
        all.push_back({"lines", importance_of(lit_by_lines()), share});
        all.push_back({"odd lines", odd_lines(), share});
        all.push_back({"first nanometre", one_nanometre(0), share});
        all.push_back({"last nanometre", one_nanometre(469), share});
        // 470 + 42 cells: the even share is a power of two.
        all.push_back({"42 lines", only_lines(42), share});
        all.push_back({"most lines", only_lines(kMaxWavelengthLines), share});
    }
    return all;
}

double total_of(const WavelengthCells& cells) {
    double total = 0.0;
    for (std::size_t nm = 0; nm < kWavelengthCells; ++nm) total += cells.pdf(360.5 + static_cast<double>(nm));
    for (std::size_t line = 0; line < cells.line_count(); ++line) total += cells.mass(line);
    return total;
}

TEST(WavelengthCells, DensityAndMassesAddUpToOne) {
    for (const Case& c : cases()) {
        EXPECT_NEAR(total_of(WavelengthCells(c.importance, c.uniform_share)), 1.0, 1e-12) << c.name;
    }
}

TEST(WavelengthCells, SharesFollowTheFormula) {
    constexpr double kRounding = 4096 * 0x1p-53;  // of a sum of 4096 numbers of at most 1
    for (const Case& c : cases()) {
        const WavelengthCells cells(c.importance, c.uniform_share);
        const auto share = static_cast<double>(c.uniform_share);
        double sum = std::accumulate(c.importance.per_nm.begin(), c.importance.per_nm.end(), 0.0);
        for (const LineImportance& line : c.importance.lines) sum += line.importance;
        const double even = share / static_cast<double>(kWavelengthCells + c.importance.lines.size());
        for (std::size_t nm = 0; nm < kWavelengthCells; ++nm) {
            const double expected = (1.0 - share) * c.importance.per_nm[nm] / sum + even;
            ASSERT_NEAR(cells.pdf(360.5 + static_cast<double>(nm)), expected, kRounding) << c.name << ' ' << nm;
        }
        for (std::size_t i = 0; i < cells.line_count(); ++i) {
            const double expected = (1.0 - share) * c.importance.lines[i].importance / sum + even;
            ASSERT_NEAR(cells.mass(i), expected, kRounding) << c.name << ' ' << i;
        }
    }
}

void expect_twins_agree(const WavelengthCells& cells, double u, const char* name) {
    const WavelengthCells::Sample fast = cells.sample(u);
    const WavelengthCells::ExactSample exact = cells.exact(u);
    ASSERT_EQ(fast.line, exact.line) << name << ' ' << u;
    ASSERT_NEAR(static_cast<double>(fast.lambda_nm), exact.lambda_nm, 1e-4) << name << ' ' << u;
    ASSERT_NEAR(static_cast<double>(fast.pdf), exact.pdf, 1e-6 * exact.pdf) << name << ' ' << u;
}

// At u = 0, u -> 1, at random, and around each end of a cell: the ends by adding up what precedes them, which is right
// to a few units in the last place, and some of those to both sides.
TEST(WavelengthCells, FastSampleFollowsItsTwin) {
    constexpr double kBelowOne = 1.0 - 0x1p-53;
    for (const Case& c : cases()) {
        const WavelengthCells cells(c.importance, c.uniform_share);
        Pcg32 random(7);
        for (const double u : {0.0, 0x1p-53, kBelowOne}) expect_twins_agree(cells, u, c.name);
        for (int i = 0; i < 2000; ++i) expect_twins_agree(cells, static_cast<double>(random.next_float()), c.name);
        double end = 0.0;
        while (end < 1.0 - 1e-9) {
            end += cells.exact(end + 1e-12).pdf;
            for (int ulps = -8; ulps <= 8; ++ulps) {
                expect_twins_agree(cells, std::clamp(end + ulps * 0x1p-53, 0.0, kBelowOne), c.name);
            }
        }
    }
}

// The specification itself: u is the probability of all that comes before. A line is level.
TEST(WavelengthCells, ExactSampleInvertsTheDistribution) {
    const WavelengthImportance importance = odd_lines();
    const WavelengthCells cells(importance, kDefaultUniformShare);
    // In the order of wavelength: lines follow their nanometre, the last one all.
    double below = 0.0;
    const auto expect_line = [&](std::int32_t line) {
        const double mass = cells.mass(static_cast<std::size_t>(line));
        for (const double t : {0.01, 0.5, 0.99}) {
            const WavelengthCells::ExactSample sample = cells.exact(below + t * mass);
            EXPECT_EQ(sample.line, line);
            EXPECT_EQ(sample.lambda_nm, importance.lines[static_cast<std::size_t>(line)].lambda_nm);
            EXPECT_NEAR(sample.pdf, mass, 1e-14);
        }
        below += mass;
    };
    for (int nm = 360; nm < 830; ++nm) {
        const double density = cells.pdf(nm + 0.5);
        for (const double t : {0.01, 0.5, 0.99}) {
            const WavelengthCells::ExactSample sample = cells.exact(below + t * density);
            EXPECT_EQ(sample.line, kNoLine);
            EXPECT_NEAR(sample.lambda_nm, nm + t, 1e-8);
            EXPECT_NEAR(sample.pdf, density, 1e-14);
        }
        below += density;
        if (nm == 360) expect_line(2);
        if (nm == 499) expect_line(4);
        if (nm == 500) expect_line(1);
        if (nm == 500) expect_line(3);
    }
    expect_line(0);
    EXPECT_NEAR(below, 1.0, 1e-12);
}

TEST(WavelengthCells, RefusesSharesOutOfRange) {
    for (const float share : {0.0f, 0.015f, 1.01f, std::numeric_limits<float>::quiet_NaN()}) {
        EXPECT_THROW(WavelengthCells(one_nanometre(5), share), std::invalid_argument) << share;
    }
    EXPECT_THROW(WavelengthCells(WavelengthImportance{}, 1.0f), std::invalid_argument) << "nothing to be seen";
}

}  // namespace
}  // namespace emulsion
