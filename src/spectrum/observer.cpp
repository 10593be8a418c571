#include "spectrum/observer.h"

#include <array>
#include <cstddef>

#include "core/name_key.h"
#include "core/named_value.h"
#include "spectrum/data_table.h"
#include "spectrum/one_nm_table.h"

namespace emulsion {

namespace {

/// What an observer is known by.
struct ObserverName {
    std::string_view name;
    std::array<std::string_view, 4> alias_keys;
    const Observer& (*get)();
};

constexpr std::array<ObserverName, 3> kObservers = {{
    {"cie_1931_2deg", {"1931", "1931-2deg", "cie-1931", "cie-1931-2-degrees"}, cie_1931_2deg},
    {"cie_1964_10deg", {"1964", "1964-10deg", "cie-1964", "cie-1964-10-degrees"}, cie_1964_10deg},
    {"cie_2015_2deg", {"2015", "2015-2deg", "cie-2015", "cie-2015-2-degrees"}, cie_2015_2deg},
}};

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

const Observer& cie_1964_10deg() {
    static const Observer observer =
        tabulated_observer("CIE 1964 10 degrees", data_table("cie_1964_10deg_xyz_1nm"), "xbar10", "ybar10", "zbar10");
    return observer;
}

const Observer& cie_2015_2deg() {
    static const Observer observer =
        tabulated_observer("CIE 2015 2 degrees", data_table("cie_2015_2deg_xyz_1nm"), "xbar", "ybar", "zbar");
    return observer;
}

const Observer& observer(std::string_view name) {
    const std::string key = name_key(name);
    for (const ObserverName& known : kObservers) {
        if (name_key(known.name) == key) return known.get();
        for (const std::string_view alias_key : known.alias_keys) {
            if (alias_key == key) return known.get();
        }
    }
    throw_unknown_name("observer", name, observer_names());
}

std::vector<std::string_view> observer_names() {
    std::vector<std::string_view> names;
    names.reserve(kObservers.size());
    for (const ObserverName& known : kObservers) names.push_back(known.name);
    return names;
}

XYZd eval(const Observer& observer, double lambda_nm) noexcept {
    return value_at(observer.first_nm, observer.value, lambda_nm);
}

}  // namespace emulsion
