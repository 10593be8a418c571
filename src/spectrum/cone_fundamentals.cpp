#include "spectrum/cone_fundamentals.h"

#include <cstddef>

#include "spectrum/data_table.h"
#include "spectrum/one_nm_table.h"

namespace emulsion {

const ConeFundamentals& stockman_sharpe_2deg() {
    static const ConeFundamentals fundamentals = [] {
        const DataTable& table = data_table("stockman_sharpe_2deg_lms_1nm");
        ConeFundamentals made{
            "Stockman & Sharpe 2000 2 degrees", static_cast<int>(table.column("wavelength").front()), {}};
        for (std::size_t i = 0; i < table.row_count(); ++i) {
            made.value.push_back({table.column("lbar")[i], table.column("mbar")[i], table.column("sbar")[i]});
        }
        return made;
    }();
    return fundamentals;
}

ConeSensitivities eval(const ConeFundamentals& fundamentals, double lambda_nm) noexcept {
    return value_at(fundamentals.first_nm, fundamentals.value, lambda_nm);
}

Matrix3 xyz_2015_from_stockman_sharpe() noexcept {
    return {{{{1.94735469, -1.41445123, 0.36476327}, {0.68990272, 0.34832189, 0.0}, {0.0, 0.0, 1.93485343}}}};
}

}  // namespace emulsion
