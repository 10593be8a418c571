#pragma once
// A list of facts in two forms: aligned lines for people, one JSON object for machines.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace emulsion::cli {

class InfoReport {
  public:
    /// A line for people. Without a label it goes on with the one before; without text it is left out.
    void line(std::string_view label, std::string_view text);

    /// A member of the JSON object, whose value is JSON already.
    void member(std::string_view key, std::string json);
    void member_text(std::string_view key, std::string_view text);

    /// The lines, their texts below one another.
    [[nodiscard]] std::string text() const;
    /// An object, a member a line.
    [[nodiscard]] std::string json() const;

  private:
    std::vector<std::pair<std::string, std::string>> lines_, members_;
};

/// "[a, b]", of values that are JSON already.
[[nodiscard]] std::string json_list(const std::vector<std::string>& values);
/// {"key": value, ...}, likewise.
[[nodiscard]] std::string json_object(const std::vector<std::pair<std::string_view, std::string>>& members);

}  // namespace emulsion::cli
