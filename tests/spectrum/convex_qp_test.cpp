#include "spectrum/convex_qp.h"

#include <cmath>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

// Nearest point to c of the simplex x >= 0, sum x = total.
QuadraticProgram projection(const std::vector<double>& c, double total) {
    QuadraticProgram program;
    program.hessian.assign(c.size(), std::vector<double>(c.size()));
    for (std::size_t i = 0; i < c.size(); ++i) {
        program.hessian[i][i] = 1.0;
        program.gradient.push_back(-c[i]);
        program.inequalities.push_back({{{i, 1.0}}, 0.0});
    }
    program.equalities.emplace_back(c.size(), 1.0);
    program.equality_values.push_back(total);
    return program;
}

TEST(ConvexQp, ProjectsOntoTheSimplex) {
    // By hand: max(0, c_i - t) with t = 0.15 for the sum 1.
    const auto x = minimise(projection({1.0, 0.3, -1.0}, 1.0), {0.3, 0.3, 0.3});
    ASSERT_TRUE(x.has_value());
    EXPECT_NEAR((*x)[0], 0.85, 1e-10);
    EXPECT_NEAR((*x)[1], 0.15, 1e-10);
    EXPECT_NEAR((*x)[2], 0.0, 1e-10);
    EXPECT_NEAR((*x)[0] + (*x)[1] + (*x)[2], 1.0, 1e-12);
}

TEST(ConvexQp, NeedsNoEqualities) {
    // The nearest x in [0, 1] to 2 and to 0.25.
    QuadraticProgram program;
    program.hessian = {{1.0, 0.0}, {0.0, 1.0}};
    program.gradient = {-2.0, -0.25};
    for (const std::size_t i : {0U, 1U}) {
        program.inequalities.push_back({{{i, 1.0}}, 0.0});
        program.inequalities.push_back({{{i, -1.0}}, -1.0});
    }
    const auto x = minimise(program, {0.5, 0.5});
    ASSERT_TRUE(x.has_value());
    EXPECT_NEAR((*x)[0], 1.0, 1e-10);
    EXPECT_NEAR((*x)[1], 0.25, 1e-10);
}

TEST(ConvexQp, SmoothestCurveThroughTwoPointsIsStraight) {
    // Least squared steps from 0 to 1 over eleven points, a hessian without an inverse: a straight line.
    constexpr std::size_t kPoints = 11;
    QuadraticProgram program;
    program.hessian.assign(kPoints, std::vector<double>(kPoints));
    program.gradient.assign(kPoints, 0.0);
    for (std::size_t i = 0; i + 1 < kPoints; ++i) {
        program.hessian[i][i] += 1.0;
        program.hessian[i + 1][i + 1] += 1.0;
        program.hessian[i][i + 1] = program.hessian[i + 1][i] = -1.0;
    }
    for (std::size_t i = 0; i < kPoints; ++i) program.inequalities.push_back({{{i, 1.0}}, -1.0});
    program.equalities.assign(2, std::vector<double>(kPoints));
    program.equalities[0].front() = program.equalities[1].back() = 1.0;
    program.equality_values = {0.0, 1.0};
    const auto x = minimise(program, std::vector<double>(kPoints, 0.5));
    ASSERT_TRUE(x.has_value());
    for (std::size_t i = 0; i < kPoints; ++i) EXPECT_NEAR((*x)[i], 0.1 * static_cast<double>(i), 1e-10) << i;
}

TEST(ConvexQp, IsUnsetWhereNothingIsFeasible) {
    EXPECT_FALSE(minimise(projection({1.0, 0.3, -1.0}, -0.01), {0.3, 0.3, 0.3}).has_value());
}

}  // namespace
}  // namespace emulsion
