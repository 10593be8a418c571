#pragma once
// Values as JSON has them (RFC 8259).

#include <string>
#include <string_view>

namespace emulsion::cli {

/// In double quotes, with what has to be escaped. Bytes that are no UTF-8, as names of files may hold, become U+FFFD.
[[nodiscard]] std::string json_text(std::string_view words);

/// With 17 digits, which every double survives; "null" unless it is finite, as JSON has no others.
[[nodiscard]] std::string json_number(double value);

}  // namespace emulsion::cli
