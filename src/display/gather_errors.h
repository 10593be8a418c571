#pragma once
// What a row gets of the errors of the rows above it, many pixels at a time: display/diffuse_rows.h.

#include <cstddef>
#include <span>

#include "display/code_units.h"
#include "display/diffusion_kernel.h"
#include "display/error_rows.h"

namespace emulsion {

/// Where a row's errors are read from: component 0 of the row, and components from a pixel to the next that was
/// rounded.
struct ErrorSource {
    const ErrorUnits *parts, *rests;
    std::ptrdiff_t step;
};

/// Compilers are to see every weight as a number, and so these are templates.
template <const DiffusionKernel& Kernel, int Dx, int Dy>
ErrorUnits share(ErrorUnits error) noexcept {
    constexpr int kWeight = Kernel.weight(Dx, Dy);
    if constexpr (kWeight == 0) return 0;
    return Kernel.share(error, kWeight);
}

/// What a pixel below gets of an error if all its neighbours are there.
template <const DiffusionKernel& Kernel>
ErrorUnits rest_below(ErrorUnits error) noexcept {
    constexpr int kOthers = Kernel.total() - Kernel.weight(0, 1);
    if constexpr (Kernel.rounding == ShareRounding::parts) {
        return Kernel.handed_on(error) - kOthers * Kernel.floor_quotient(error);
    } else {
        static_assert(Kernel.reach() == 1);
        return Kernel.handed_on(error) -
               (share<Kernel, 1, 0>(error) + share<Kernel, -1, 1>(error) + share<Kernel, 1, 1>(error));
    }
}

/// What component i gets from the pixel that it is Dx ahead and Dy below of.
template <const DiffusionKernel& Kernel, int Dx, int Dy>
ErrorUnits share_from(const ErrorSource& source, std::ptrdiff_t i) noexcept {
    constexpr int kWeight = Kernel.weight(Dx, Dy);
    if constexpr (kWeight == 0) {
        return 0;
    } else if constexpr (Kernel.rounding == ShareRounding::parts) {
        return Dx == 0 && Dy == 1 ? source.rests[i] : kWeight * source.parts[i - Dx * source.step];
    } else {
        const ErrorUnits error = source.parts[i - Dx * source.step];
        return Dx == 0 && Dy == 1 ? rest_below<Kernel>(error) : share<Kernel, Dx, Dy>(error);
    }
}

/// From all pixels of the row so far up. Inlined whatever compilers think: only then do they make vectors of the loop.
template <const DiffusionKernel& Kernel, int Dy>
[[gnu::always_inline]] inline ErrorUnits shares_from(const ErrorSource& source, std::ptrdiff_t i) noexcept {
    return share_from<Kernel, -2, Dy>(source, i) + share_from<Kernel, -1, Dy>(source, i) +
           share_from<Kernel, 0, Dy>(source, i) + share_from<Kernel, 1, Dy>(source, i) +
           share_from<Kernel, 2, Dy>(source, i);
}

/// Values of components from `begin` on, which `encoded` has, with the shares of the errors above them: one row up and,
/// for wide kernels, two.
template <const DiffusionKernel& Kernel>
void gather_errors(std::span<const float> encoded, const CodeUnits& units, const ErrorSource& one_up,
                   const ErrorSource& two_up, std::ptrdiff_t begin, std::span<ErrorUnits> values) noexcept {
    const float* in = encoded.data();
    ErrorUnits* out = values.data() + begin;
    const auto count = static_cast<std::ptrdiff_t>(encoded.size());
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        ErrorUnits value = units(in[i]) + shares_from<Kernel, 1>(one_up, begin + i);
        if constexpr (Kernel.reach() == 2) value += shares_from<Kernel, 2>(two_up, begin + i);
        out[i] = value;
    }
}

}  // namespace emulsion
