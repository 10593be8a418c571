#include "pathtracer/spectrum_nodes.h"

#include "core/units.h"
#include "spectrum/spectrum_table.h"

namespace emulsion {

std::vector<double> node_integrals(const Spectrum& spectrum) {
    const SpectrumTable table(spectrum);
    constexpr std::size_t kCells = kMaxWavelength_nm - kMinWavelength_nm;
    std::vector<double> nodes(kCells + 1, 0.0);
    for (std::size_t cell = 0; cell < kCells; ++cell) {
        SpectrumTableIndex<2> ends;
        ends.cell.fill(static_cast<int>(cell));
        ends.fraction = {0.0f, 1.0f};
        const SampledSpectrum<2> value = table.at(ends);
        const auto start = static_cast<double>(value[0]), end = static_cast<double>(value[1]);
        nodes[cell] += (2.0 * start + end) / 6.0;
        nodes[cell + 1] += (start + 2.0 * end) / 6.0;
    }
    return nodes;
}

}  // namespace emulsion
