#pragma once
// The responses of a sensor in single precision, made to be looked up at every sample: straight lines over every whole
// nanometre of [kMinWavelength_nm, kMaxWavelength_nm), and 0 outside.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/units.h"
#include "film/vectors.h"

namespace emulsion {

/// Wavelengths in nm, densities in 1/nm and radiances of one path. Where a path has fewer, the other places are idle:
/// they have no radiance.
struct FourWavelengths {
    Float4 lambda_nm = {kMinWavelength_nm, kMinWavelength_nm, kMinWavelength_nm, kMinWavelength_nm};
    Float4 pdf = {1.0f, 1.0f, 1.0f, 1.0f};
    Float4 radiance{};

    /// Reads `count` <= 4 of each.
    [[nodiscard]] static FourWavelengths load(const float* lambda_nm, const float* pdf, const float* radiance,
                                              std::size_t count) noexcept {
        FourWavelengths four;
        std::memcpy(&four.lambda_nm, lambda_nm, count * sizeof(float));
        std::memcpy(&four.pdf, pdf, count * sizeof(float));
        std::memcpy(&four.radiance, radiance, count * sizeof(float));
        return four;
    }
};

class ResponseTable {
  public:
    static constexpr std::size_t kCells = kMaxWavelength_nm - kMinWavelength_nm;

    /// The responses at both ends of the nanometre that starts at kMinWavelength_nm + cell. Neighbours need not agree:
    /// there may be a jump between them.
    void set(std::size_t cell, const std::array<double, 4>& start, const std::array<double, 4>& end) noexcept {
        for (std::size_t i = 0; i < 4; ++i) {
            lines_[cell].start[i] = static_cast<float>(start[i] / 4.0);
            lines_[cell].slope[i] = static_cast<float>((end[i] - start[i]) / 4.0);
        }
    }

    /// scale / 4 * sum of radiance / pdf * response, of those whose pdf is not 0. Not finite if any wavelength is not.
    [[nodiscard]] Float4 sum(const FourWavelengths& four, float scale) const noexcept {
        // Lines are by truncated wavelength. Taken without a sign, everything below the first is far above the last.
        constexpr std::uint32_t kFirst = kMinWavelength_nm, kNone = kCells;
        const Int4 whole_nm = __builtin_convertvector(four.lambda_nm, Int4);
        const Uint4 cell = smaller(std::bit_cast<Uint4>(whole_nm) - kFirst, Uint4{kNone, kNone, kNone, kNone});
        const auto offset = scalars(cell * static_cast<std::uint32_t>(sizeof(Line)));

        const Float4 fraction = four.lambda_nm - __builtin_convertvector(whole_nm, Float4);
        const Float4 all = four.radiance / four.pdf * scale;
        const auto scaled = std::bit_cast<Float4>(std::bit_cast<Int4>(all) & (four.pdf != Float4{}));

        const auto term = [&]<int I>() {
            const Line& line = *reinterpret_cast<const Line*>(reinterpret_cast<const char*>(lines_.data()) + offset[I]);
            return broadcast<I>(scaled) * (line.start + broadcast<I>(fraction) * line.slope);
        };
        return (term.template operator()<0>() + term.template operator()<1>()) +
               (term.template operator()<2>() + term.template operator()<3>());
    }

  private:
    struct Line {
        Float4 start{}, slope{};
    };
    // A quarter of the responses, as most paths have four wavelengths; and one line of zeros.
    std::array<Line, kCells + 1> lines_;
};

}  // namespace emulsion
