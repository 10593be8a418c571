#include "display/floyd_steinberg.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace emulsion {

namespace {

constexpr int kFractionBits = 16;
constexpr std::int64_t kUnitsPerCode = std::int64_t{1} << kFractionBits;

/// A value or an error of one pixel in units of 2^-16 code. 64 bits: on a saturated last row errors add up.
using Units = BasicRGB<std::int64_t>;

/// A value in units above black, as the scale has them.
std::int64_t to_units(float encoded, const CodeScale& scale) noexcept {
    const auto units = static_cast<double>(scale.steps() * kUnitsPerCode);
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): not negative, and exact in double precision up to the cut
    return static_cast<std::int64_t>(static_cast<double>(unit_clamp(encoded)) * units + 0.5);
}

/// Rounds to the nearest code that there is, and leaves the error in `value`.
std::uint16_t take_code(std::int64_t& value, const CodeScale& scale) noexcept {
    const std::int64_t nearest = (value + kUnitsPerCode / 2) >> kFractionBits;
    const std::int64_t step = std::clamp<std::int64_t>(nearest, 0, scale.steps());
    value -= step * kUnitsPerCode;
    return static_cast<std::uint16_t>(scale.black + step);
}

/// Where a pixel's error goes.
struct Shares {
    Units right, below_left, below, below_right;
};

/// Inside the picture; what rounding leaves over goes below.
Shares inner_shares(const Units& error) noexcept {
    const auto sixteenths = [](std::int64_t weight, const Units& e) {
        return Units{(weight * e.r) >> 4, (weight * e.g) >> 4, (weight * e.b) >> 4};
    };
    Shares shares{sixteenths(7, error), sixteenths(3, error), {}, sixteenths(1, error)};
    shares.below = error + std::int64_t{-1} * (shares.right + shares.below_left + shares.below_right);
    return shares;
}

/// weight / total of an error, rounded toward 0.
Units fraction(const Units& error, std::int64_t weight, std::int64_t total) noexcept {
    return {weight * error.r / total, weight * error.g / total, weight * error.b / total};
}

/// In the first column of at least two, no last row: nothing is below left, the other weights are 7, 5, 1.
Shares first_column_shares(const Units& error) noexcept {
    Shares shares{fraction(error, 7, 13), {}, {}, fraction(error, 1, 13)};
    shares.below = error + std::int64_t{-1} * (shares.right + shares.below_right);
    return shares;
}

/// In the last column of at least two, no last row: only 3 below left and 5 below are left.
Shares last_column_shares(const Units& error) noexcept {
    const Units below_left = fraction(error, 3, 8);
    return {{}, below_left, error + std::int64_t{-1} * below_left, {}};
}

/// The value of a pixel with the errors that reached it.
Units value_of(const RGB& encoded, const CodeScale& scale, const Units& from_above, const Units& from_left) noexcept {
    const Units value{to_units(encoded.r, scale), to_units(encoded.g, scale), to_units(encoded.b, scale)};
    return value + from_above + from_left;
}

CodeRGB take_codes(Units& value, const CodeScale& scale) noexcept {
    return {take_code(value.r, scale), take_code(value.g, scale), take_code(value.b, scale)};
}

/// Rounds a row that has one below it. `errors` holds those from above, and is left with those for the row below: the
/// one for x - 1 is complete, and its place free, once pixel x is done.
void diffuse_row(std::span<const RGB> encoded, const CodeScale& scale, std::span<CodeRGB> codes,
                 std::span<Units> errors) noexcept {
    const std::size_t last = encoded.size() - 1;
    Units error = value_of(encoded[0], scale, errors[0], {});
    codes[0] = take_codes(error, scale);
    Shares shares = last == 0 ? Shares{{}, {}, error, {}} : first_column_shares(error);
    Units below_previous = shares.below, below_this = shares.below_right;

    for (std::size_t x = 1; x < last; ++x) {
        error = value_of(encoded[x], scale, errors[x], shares.right);
        codes[x] = take_codes(error, scale);
        shares = inner_shares(error);
        errors[x - 1] = below_previous + shares.below_left;
        below_previous = below_this + shares.below;
        below_this = shares.below_right;
    }

    if (last > 0) {
        error = value_of(encoded[last], scale, errors[last], shares.right);
        codes[last] = take_codes(error, scale);
        shares = last_column_shares(error);
        errors[last - 1] = below_previous + shares.below_left;
        below_previous = below_this + shares.below;
    }
    errors[last] = below_previous;
}

/// The last row hands everything to the right.
void diffuse_last_row(std::span<const RGB> encoded, const CodeScale& scale, std::span<CodeRGB> codes,
                      std::span<const Units> errors) noexcept {
    Units error;
    for (std::size_t x = 0; x < encoded.size(); ++x) {
        error = value_of(encoded[x], scale, errors[x], error);
        codes[x] = take_codes(error, scale);
    }
}

}  // namespace

void quantize(const FloydSteinberg& /*dither*/, ImageView<const RGB> encoded, const CodeScale& scale,
              ImageView<CodeRGB> codes, int /*threads*/) {
    std::vector<Units> errors(static_cast<std::size_t>(encoded.width()));
    const int last = encoded.height() - 1;
    for (int y = 0; y < last; ++y) diffuse_row(encoded.row(y), scale, codes.row(y), errors);
    diffuse_last_row(encoded.row(last), scale, codes.row(last), errors);
}

}  // namespace emulsion
