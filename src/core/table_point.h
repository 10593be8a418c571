#pragma once
// Named values that are tables: instead of parameters they have points, and "table:0=0,0.5=0.2,1=1" for a text form.

#include <concepts>
#include <string_view>
#include <vector>

namespace emulsion {

struct TablePoint {
    double x = 0.0, y = 0.0;
    bool operator==(const TablePoint&) const = default;
};

/// A type with the member `points`, and with check_points(), which throws std::invalid_argument for points that are no
/// such table; its second parameter names the value in the message.
template <class T>
concept NamedTable = requires(T value, std::string_view what) {
    { (value.points) } -> std::same_as<std::vector<TablePoint>&>;
    check_points(value, what);
};

}  // namespace emulsion
