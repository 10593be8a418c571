#include "display/floyd_steinberg.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "display/code_units.h"

namespace emulsion {

namespace {

/// A value or an error of one component. 64 bits: on a saturated last row errors add up.
using Units = std::int64_t;

/// One channel of a row.
template <class T>
struct Channel {
    std::span<T> row;
    std::size_t channel, channels;
    [[nodiscard]] std::size_t size() const noexcept { return row.size() / channels; }
    [[nodiscard]] T& operator[](std::size_t x) const noexcept { return row[x * channels + channel]; }
};
using Encoded = Channel<const float>;
using Codes = Channel<std::uint16_t>;

/// Rounds to the nearest code that there is, and leaves the error in `value`.
std::uint16_t take_code(Units& value, const CodeScale& scale) noexcept {
    const CodeUnits units(scale);
    const Units nearest = (value + units.per_code() / 2) >> units.fraction_bits();
    const Units step = std::clamp<Units>(nearest, 0, scale.steps());
    value -= step * units.per_code();
    return static_cast<std::uint16_t>(scale.black + step);
}

/// Where a pixel's error goes.
struct Shares {
    Units right, below_left, below, below_right;
};

/// Inside the picture; what rounding leaves over goes below.
Shares inner_shares(Units error) noexcept {
    Shares shares{(7 * error) >> 4, (3 * error) >> 4, {}, error >> 4};
    shares.below = error - (shares.right + shares.below_left + shares.below_right);
    return shares;
}

/// In the first column of at least two, no last row: nothing is below left, the other weights are 7, 5, 1.
Shares first_column_shares(Units error) noexcept {
    Shares shares{7 * error / 13, {}, {}, error / 13};
    shares.below = error - (shares.right + shares.below_right);
    return shares;
}

/// In the last column of at least two, no last row: only 3 below left and 5 below are left.
Shares last_column_shares(Units error) noexcept {
    const Units below_left = 3 * error / 8;
    return {{}, below_left, error - below_left, {}};
}

/// Rounds a row that has one below it. `errors` holds those from above, and is left with those for the row below: the
/// one for x - 1 is complete, and its place free, once pixel x is done.
void diffuse_row(const Encoded& encoded, const CodeScale& scale, const Codes& codes, std::span<Units> errors) noexcept {
    const std::size_t last = encoded.size() - 1;
    Units error = CodeUnits(scale)(encoded[0]) + errors[0];
    codes[0] = take_code(error, scale);
    Shares shares = last == 0 ? Shares{{}, {}, error, {}} : first_column_shares(error);
    Units below_previous = shares.below, below_this = shares.below_right;

    for (std::size_t x = 1; x < last; ++x) {
        error = CodeUnits(scale)(encoded[x]) + errors[x] + shares.right;
        codes[x] = take_code(error, scale);
        shares = inner_shares(error);
        errors[x - 1] = below_previous + shares.below_left;
        below_previous = below_this + shares.below;
        below_this = shares.below_right;
    }

    if (last > 0) {
        error = CodeUnits(scale)(encoded[last]) + errors[last] + shares.right;
        codes[last] = take_code(error, scale);
        shares = last_column_shares(error);
        errors[last - 1] = below_previous + shares.below_left;
        below_previous = below_this + shares.below;
    }
    errors[last] = below_previous;
}

/// The last row hands everything to the right.
void diffuse_last_row(const Encoded& encoded, const CodeScale& scale, const Codes& codes,
                      std::span<const Units> errors) noexcept {
    Units error = 0;
    for (std::size_t x = 0; x < encoded.size(); ++x) {
        error = CodeUnits(scale)(encoded[x]) + errors[x] + error;
        codes[x] = take_code(error, scale);
    }
}

}  // namespace

void quantize(const FloydSteinberg& /*dither*/, const EncodedRows& encoded, const CodeScale& scale,
              const CodeRows& codes, int /*threads*/) {
    const auto channels = static_cast<std::size_t>(encoded.channels);
    const int last = encoded.height - 1;
    for (std::size_t c = 0; c < channels; ++c) {
        std::vector<Units> errors(static_cast<std::size_t>(encoded.width));
        for (int y = 0; y < last; ++y) {
            diffuse_row({encoded.row(y), c, channels}, scale, {codes.row(y), c, channels}, errors);
        }
        diffuse_last_row({encoded.row(last), c, channels}, scale, {codes.row(last), c, channels}, errors);
    }
}

}  // namespace emulsion
