#include "spectrum/sellmeier.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <fmt/core.h>

#include "core/name_key.h"
#include "core/named_value.h"
#include "spectrum/data_table.h"

namespace emulsion {

const std::vector<SellmeierGlass>& sellmeier_glasses() {
    static const std::vector<SellmeierGlass> glasses = [] {
        const DataTable& table = data_table("glasses");
        std::vector<SellmeierGlass> made;
        for (std::size_t i = 0; i < table.row_count(); ++i) {
            const auto cell = [&](std::string_view column) { return table.column(column)[i]; };
            made.push_back({table.row_names[i],
                            {cell("B1"), cell("B2"), cell("B3")},
                            {cell("C1"), cell("C2"), cell("C3")},
                            cell("lambda_min_nm"),
                            cell("lambda_max_nm"),
                            cell("nd"),
                            cell("Vd")});
        }
        return made;
    }();
    return glasses;
}

const SellmeierGlass& sellmeier_glass(std::string_view name) {
    const std::string key = name_key(name);
    std::vector<std::string_view> known;
    for (const SellmeierGlass& glass : sellmeier_glasses()) {
        if (name_key(glass.name) == key) return glass;
        known.emplace_back(glass.name);
    }
    throw_unknown_name("glass", name, std::move(known));
}

double index_of_refraction(const SellmeierGlass& glass, double lambda_nm) {
    if (!(lambda_nm >= glass.lambda_min_nm && lambda_nm <= glass.lambda_max_nm)) {
        throw std::invalid_argument(fmt::format("lambda_nm = {}: the formula of the glass {} holds from {} to {} nm",
                                                lambda_nm, glass.name, glass.lambda_min_nm, glass.lambda_max_nm));
    }
    return extrapolated_index(glass, lambda_nm);
}

double extrapolated_index(const SellmeierGlass& glass, double lambda_nm) noexcept {
    const double squared_um2 = 1e-6 * lambda_nm * lambda_nm;
    double n_squared = 1.0;
    for (std::size_t j = 0; j < 3; ++j) n_squared += glass.b[j] * squared_um2 / (squared_um2 - glass.c_um2[j]);
    return std::sqrt(n_squared);
}

}  // namespace emulsion
