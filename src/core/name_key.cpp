#include "core/name_key.h"

#include <algorithm>

namespace emulsion {

std::string name_key(std::string_view name) {
    std::string key(name);
    std::transform(key.begin(), key.end(), key.begin(), [](char c) {
        if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
        return c == '_' || c == '.' || c == ' ' ? '-' : c;
    });
    return key;
}

}  // namespace emulsion
