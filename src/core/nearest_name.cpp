#include "core/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace emulsion {

namespace {

constexpr std::size_t kLongestName = 64;  // no known name comes near this; keeps garbage cheap

char lower(char c) noexcept { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

}  // namespace

std::size_t name_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (const char letter : a) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t change = lower(letter) == lower(b[j]) ? 0 : 1;
            const std::size_t best = std::min({row[j] + 1, row[j + 1] + 1, diagonal + change});
            diagonal = row[j + 1];
            row[j + 1] = best;
        }
    }
    return 2 * row[b.size()] + (a == b ? 0 : 1);
}

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> known) {
    if (known.empty() || name.size() > kLongestName) return {};
    const auto nearest = std::min_element(known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
        return name_distance(name, a) < name_distance(name, b);
    });
    const bool unlike = name_distance(name, *nearest) / 2 >= std::max(name.size(), nearest->size());
    return unlike ? std::string_view{} : *nearest;
}

}  // namespace emulsion
