#pragma once

#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>

namespace emulsion::testing {

/// Whether a text is one JSON value (RFC 8259); strings and numbers are not looked at closely.
class JsonCheck {
  public:
    static bool is_json(std::string_view text) {
        JsonCheck check{text};
        return check.value() && check.blank() && check.rest_.empty();
    }

  private:
    explicit JsonCheck(std::string_view text) : rest_(text) {}
    bool blank() {
        while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_[0])) != 0) rest_.remove_prefix(1);
        return true;
    }
    bool take(char c) {
        blank();
        if (rest_.empty() || rest_[0] != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    bool string() {
        if (!take('"')) return false;
        for (; !rest_.empty(); rest_.remove_prefix(1)) {
            if (rest_[0] == '"') return take('"');
            if (rest_[0] == '\\') rest_.remove_prefix(1);
        }
        return false;
    }
    template <class Item>
    bool list(char open, char close, Item item) {
        if (!take(open)) return false;
        if (take(close)) return true;
        do {
            if (!item()) return false;
        } while (take(','));
        return take(close);
    }
    bool value() {
        blank();
        if (rest_.empty()) return false;
        if (rest_[0] == '"') return string();
        if (rest_[0] == '[') return list('[', ']', [this] { return value(); });
        if (rest_[0] == '{') return list('{', '}', [this] { return string() && take(':') && value(); });
        const std::size_t end = rest_.find_first_of(",]} \n");
        const std::string word(rest_.substr(0, end));
        rest_.remove_prefix(word.size());
        if (word == "null" || word == "true" || word == "false") return true;
        return !word.empty() && word.find_first_not_of("0123456789.e+-") == std::string::npos;
    }

    std::string_view rest_;
};

}  // namespace emulsion::testing
