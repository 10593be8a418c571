#include "display/diffuse_hilbert.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/image.h"
#include "display/code_units.h"
#include "display/diffuse_plainly.h"
#include "display/hilbert_curve.h"

namespace emulsion {

namespace {

/// A neighbour `ahead` on the way of the curve and `aside` to the right of it.
struct Neighbour {
    int ahead, aside, weight;
};

/// Those of a kernel with its lower part on both sides.
std::vector<Neighbour> on_both_sides(const DiffusionKernel& kernel) {
    std::vector<Neighbour> all;
    for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
            const int weight = kernel.weight(dx, dy < 0 ? -dy : dy);
            if (weight != 0) all.push_back({dx, dy, weight});
        }
    }
    return all;
}

/// Where the error of a pixel goes.
class Recipients {
  public:
    explicit Recipients(const DiffusionKernel& kernel) : neighbours_(on_both_sides(kernel)) {}

    /// Those neighbours of `from` that are in the picture and not yet rounded, with the curve going on to `next`.
    void find(PixelPlace from, PixelPlace next, const Image<std::uint8_t>& rounded) noexcept {
        const bool sideways = next.x != from.x;  // a step to a corner counts as one to the side
        const int dx = sideways ? next.x - from.x : 0, dy = sideways ? 0 : next.y - from.y;
        next_ = index(next, rounded.width());
        count_ = 0, total_ = 0;
        for (const Neighbour& n : neighbours_) {
            const PixelPlace to = {from.x + n.ahead * dx - n.aside * dy, from.y + n.ahead * dy + n.aside * dx};
            if (to.x < 0 || to.x >= rounded.width() || to.y < 0 || to.y >= rounded.height()) continue;
            if (rounded(to.x, to.y) != 0) continue;
            found_[count_++] = {index(to, rounded.width()), n.weight};
            total_ += n.weight;
        }
    }

    /// Calls give(pixel, share) for each; the next pixel on the curve gets what the others leave.
    template <class Give>
    void hand_on(std::int64_t handed, const Give& give) const noexcept {
        std::int64_t rest = handed;
        for (std::size_t i = 0; i < count_; ++i) {
            const std::int64_t share = handed * found_[i].weight / total_;
            give(found_[i].pixel, share);
            rest -= share;
        }
        give(next_, rest);
    }

  private:
    struct Found {
        std::size_t pixel;
        int weight;
    };
    [[nodiscard]] static std::size_t index(PixelPlace at, int width) noexcept {
        return static_cast<std::size_t>(at.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(at.x);
    }

    std::vector<Neighbour> neighbours_;
    std::array<Found, 24> found_{};
    std::size_t count_ = 0, next_ = 0;
    int total_ = 0;
};

}  // namespace

void diffuse_hilbert(const DiffusionKernel& kernel, const EncodedRows& encoded, const CodeScale& scale,
                     const CodeRows& codes) {
    const CodeUnits units(scale);
    const auto channels = static_cast<std::size_t>(encoded.channels);
    const std::vector<PixelPlace> curve = hilbert_curve(encoded.width, encoded.height);
    std::vector<std::int64_t> incoming(curve.size() * channels);
    Image<std::uint8_t> rounded(encoded.width, encoded.height);
    Recipients recipients(kernel);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const auto [x, y] = curve[i];
        const bool is_last = i + 1 == curve.size();
        rounded(x, y) = 1;
        if (!is_last) recipients.find(curve[i], curve[i + 1], rounded);
        for (std::size_t c = 0; c < channels; ++c) {
            const std::size_t component = static_cast<std::size_t>(x) * channels + c;
            std::int64_t error = units(encoded.row(y)[component]) +
                                 incoming[static_cast<std::size_t>(y) * encoded.row(y).size() + component];
            codes.row(y)[component] = take_code(error, units, scale);
            if (is_last) continue;
            recipients.hand_on(kernel.handed_on(error),
                               [&](std::size_t pixel, std::int64_t share) { incoming[pixel * channels + c] += share; });
        }
    }
}

}  // namespace emulsion
