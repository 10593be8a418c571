#include "spectrum/luminous_efficiency.h"

#include "spectrum/data_table.h"

namespace emulsion {

const PiecewiseLinearSpectrum& photopic_efficiency() {
    static const PiecewiseLinearSpectrum efficiency = tabulated_spectrum("cie_1924_photopic_1nm", "V");
    return efficiency;
}

const PiecewiseLinearSpectrum& scotopic_efficiency() {
    static const PiecewiseLinearSpectrum efficiency = tabulated_spectrum("cie_1951_scotopic_1nm", "V_prime");
    return efficiency;
}

}  // namespace emulsion
