#pragma once
// Wavelengths at which spectra are evaluated many at a time.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace emulsion {

/// The wavelengths base_nm + offset_nm[i], in two parts: next to 500 nm a double has steps of 6e-14 nm, too coarse for
/// a Gaussian of 1e-6 nm. Spectra with narrow features subtract their own wavelengths from base_nm first, which is
/// exact nearby.
struct OffsetWavelengths {
    double base_nm = 0.0;
    std::span<const double> offset_nm;

    [[nodiscard]] std::size_t size() const noexcept { return offset_nm.size(); }
    [[nodiscard]] double operator[](std::size_t i) const noexcept { return base_nm + offset_nm[i]; }
};

/// Which side a limit is taken from: shorter or longer wavelengths.
enum class Side { below, above };

/// How many wavelengths spectra with parts work on at once, so that they need no memory but the stack's.
inline constexpr std::size_t kWavelengthBlock = 32;
using WavelengthBlock = std::array<double, kWavelengthBlock>;

/// Calls visitor(wavelengths, values, scratch) for consecutive blocks of wavelengths and values, with scratch room for
/// as many values more.
template <class Visitor>
void for_each_block(const OffsetWavelengths& at, std::span<double> values, const Visitor& visitor) noexcept {
    if (at.size() == 1) {
        double scratch = 0.0;
        visitor(at, values, std::span(&scratch, 1));
        return;
    }
    WavelengthBlock scratch{};
    for (std::size_t first = 0; first < at.size(); first += kWavelengthBlock) {
        const std::size_t count = std::min(kWavelengthBlock, at.size() - first);
        visitor(OffsetWavelengths{at.base_nm, at.offset_nm.subspan(first, count)}, values.subspan(first, count),
                std::span(scratch).first(count));
    }
}

}  // namespace emulsion
