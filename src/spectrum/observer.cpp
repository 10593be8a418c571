#include "spectrum/observer.h"

#include <algorithm>
#include <cstddef>

#include "spectrum/data_table.h"

namespace emulsion {

namespace {

Observer tabulated_observer(std::string name, const DataTable& table, std::string_view x, std::string_view y,
                            std::string_view z) {
    Observer observer{std::move(name), static_cast<int>(table.column("wavelength").front()), {}};
    observer.value.resize(table.row_count());
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        observer.value[i] = {table.column(x)[i], table.column(y)[i], table.column(z)[i]};
    }
    return observer;
}

}  // namespace

const Observer& cie_1931_2deg() {
    static const Observer observer =
        tabulated_observer("CIE 1931 2 degrees", data_table("cie_1931_2deg_xyz_1nm"), "xbar", "ybar", "zbar");
    return observer;
}

XYZd eval(const Observer& observer, double lambda_nm) noexcept {
    const double above = lambda_nm - observer.first_nm;
    const double last = static_cast<double>(observer.value.size()) - 1.0;
    if (!(above >= 0.0 && above <= last)) return {};
    const auto i = std::min(static_cast<std::size_t>(above), observer.value.size() - 2);
    const double t = above - static_cast<double>(i);
    return (1.0 - t) * observer.value[i] + t * observer.value[i + 1];
}

}  // namespace emulsion
