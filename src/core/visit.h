#pragma once
// std::visit for functions that don't throw.

#include <cstddef>
#include <utility>
#include <variant>

namespace emulsion {

/// visitor(the variant's value), for visitors that don't throw and variants that hold a value. std::visit itself throws
/// for a variant without one. Variants of plain values never lose theirs; those of vectors do if an assignment runs out
/// of memory: ask valueless_by_exception() first.
template <std::size_t I = 0, class Visitor, class... Ts>
constexpr decltype(auto) visit_noexcept(Visitor&& visitor, const std::variant<Ts...>& variant) noexcept {
    const auto* alternative = std::get_if<I>(&variant);
    if constexpr (I + 1 < sizeof...(Ts)) {
        if (alternative == nullptr) return visit_noexcept<I + 1>(std::forward<Visitor>(visitor), variant);
    }
    return std::forward<Visitor>(visitor)(*alternative);
}

}  // namespace emulsion
