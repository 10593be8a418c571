#pragma once
// The renderer's form of a spectrum: one straight line per nanometre, single precision. Exact for piecewise linear
// spectra with knots at whole nanometres, jumps included (at the jump itself, the value on its long-wave side); the
// double-precision twin is eval(Spectrum, lambda_nm).
//
// A nanometre in which the spectrum is no straight line has the one nearest to it in the mean square: it has the
// spectrum's integral and first moment, and so its integral against any straight line, such as the observer's between
// whole nanometres. If that line leaves the range of the spectrum's values there (reflectances must stay in [0, 1],
// lights positive), it is pulled towards a constant as far as needed; the luminance is kept all the same, the other two
// of XYZ nearly. So however narrow a line of a light is, and wherever it lies, it is as bright as it should be. A line
// without width is treated alike: it is spread over the nanometre that it lies in (at a whole nanometre, the one
// above), and added.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/units.h"
#include "spectrum/sampled_spectrum.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// Where N wavelengths lie in the tables; worked out once per path and used for every spectrum that it meets.
template <int N>
struct SpectrumTableIndex {
    std::array<int, N> cell{};        ///< whole nanometres above kMinWavelength_nm
    std::array<float, N> fraction{};  ///< in [0, 1], nm above the start of the cell

    SpectrumTableIndex() = default;
    explicit SpectrumTableIndex(const std::array<float, N>& lambda_nm) noexcept {
        constexpr int kLastCell = kMaxWavelength_nm - kMinWavelength_nm - 1;
        for (std::size_t i = 0; i < N; ++i) {
            const float above = lambda_nm[i] - static_cast<float>(kMinWavelength_nm);
            cell[i] = std::clamp(static_cast<int>(above), 0, kLastCell);
            fraction[i] = above - static_cast<float>(cell[i]);
        }
    }
};

class SpectrumTable {
  public:
    /// Of spectrum * scale.
    /// \throws std::invalid_argument as validate(Spectrum) does, and for values beyond the range of a float.
    explicit SpectrumTable(const Spectrum& spectrum, double scale = 1.0);

    template <int N>
    [[nodiscard]] SampledSpectrum<N> at(const SpectrumTableIndex<N>& index) const noexcept {
        SampledSpectrum<N> values;
        for (std::size_t i = 0; i < N; ++i) {
            const CellValue& line = lines_[static_cast<std::size_t>(index.cell[i])];
            values.value[i] = line.start + index.fraction[i] * line.slope;
        }
        return values;
    }

  private:
    struct CellValue {
        float start, slope;  // value at the cell's start; rise over the cell
    };
    std::vector<CellValue> lines_;
};

}  // namespace emulsion
