#pragma once
// Parameters of plain value types: each type carries a constexpr table of them, which the command line, --help, the
// text forms, the tests and the benchmarks all read.
//
//     struct ReinhardGlobal {
//         static constexpr std::string_view kName = "reinhard-global";
//         static constexpr std::string_view kHelp = "one curve for the whole picture";
//         float key = 0.18f;
//         bool operator==(const ReinhardGlobal&) const = default;
//         static constexpr std::array kParameters = {Parameter<ReinhardGlobal>{
//             "key", &ReinhardGlobal::key, kPositiveFinite, "", "scaled luminance given to the log-average"}};
//     };
//
// The default is the member's own initialiser. A type without data members needs no table.

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace emulsion {

/// Whether the end of an interval belongs to it.
enum class RangeEnd { open, closed };

/// An interval of real numbers, infinities included where the end is closed. NaN lies in none.
struct ParameterRange {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    RangeEnd min_end = RangeEnd::closed;
    RangeEnd max_end = RangeEnd::closed;

    [[nodiscard]] constexpr bool contains(double value) const noexcept {
        const bool above = min_end == RangeEnd::closed ? value >= min : value > min;
        const bool below = max_end == RangeEnd::closed ? value <= max : value < max;
        return above && below;
    }
    bool operator==(const ParameterRange&) const = default;
};

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr ParameterRange kFinite = {-kInfinity, kInfinity, RangeEnd::open, RangeEnd::open};
inline constexpr ParameterRange kPositiveFinite = {0.0, kInfinity, RangeEnd::open, RangeEnd::open};
inline constexpr ParameterRange kPositive = {0.0, kInfinity, RangeEnd::open, RangeEnd::closed};  ///< or infinite

/// A value of a parameter that stands for a choice, and the word that it is written as.
struct ParameterWord {
    std::string_view word;  ///< lower case; a number where the choice is one of a few numbers
    int value;
};

/// For a parameter above 0.
inline constexpr std::array kAutomatic = {ParameterWord{"auto", 0}};

/// One parameter of the value type T.
template <class T>
struct Parameter {
    std::string_view name;  ///< as written in text forms: lower case, words joined by '-'
    std::variant<float T::*, double T::*, int T::*> member;  ///< where it is kept
    ParameterRange range;                                    ///< the numbers that it may be
    std::string_view unit;                                   ///< "cd/m^2", "px"; empty if it has none
    std::string_view help;                                   ///< one line, no full stop
    /// What it may be beside the numbers of the range: values outside of it that stand for choices, and are written as
    /// words only: kAutomatic.
    std::span<const ParameterWord> special = {};
    /// Where the values are a few choices, all of them; the range then is that of their values.
    std::span<const ParameterWord> words = {};
};

/// What --help says about a parameter.
struct ParameterDescription {
    std::string_view name;
    std::string default_text;  ///< as to_text() prints it
    std::string range_text;    ///< as range_text() prints it
    std::string_view unit;
    std::string_view help;
    bool operator==(const ParameterDescription&) const = default;
};

/// "(0, inf]", "[1, 16]": round brackets leave the end out, square ones take it in.
[[nodiscard]] std::string to_text(const ParameterRange& range);

/// The same where words stand beside the range: "auto, max or (0, 1]".
[[nodiscard]] std::string range_text(const ParameterRange& range, std::span<const ParameterWord> special);

/// The choices where a parameter has words: "{2, 4, 8}".
[[nodiscard]] std::string range_text(std::span<const ParameterWord> words);

/// The shortest text that parse_number reads back as the same value; "inf" and "-inf" for the infinities.
[[nodiscard]] std::string number_text(float value);
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string number_text(int value);

/// Reads the whole of `text` into `value`: decimal, with a point whatever the locale; "inf" for infinity in a float or
/// double. `what` names the parameter in messages: "tonemap reinhard-global: key". \throws std::invalid_argument if the
/// text is no number (for an int: no whole number), or too large or too small to be held. The words that might have
/// stood there are named before the number: "neither auto nor a number".
void parse_number(std::string_view text, std::string_view what, float& value,
                  std::span<const ParameterWord> special = {});
void parse_number(std::string_view text, std::string_view what, double& value,
                  std::span<const ParameterWord> special = {});
void parse_number(std::string_view text, std::string_view what, int& value,
                  std::span<const ParameterWord> special = {});

/// \throws std::invalid_argument naming `what`, the value and the range, unless the range contains the value. The words
/// that might have stood there are named before the range: "must be auto or in (0, 1]".
void check_range(float value, const ParameterRange& range, std::string_view what,
                 std::span<const ParameterWord> special = {});
void check_range(double value, const ParameterRange& range, std::string_view what,
                 std::span<const ParameterWord> special = {});
void check_range(int value, const ParameterRange& range, std::string_view what,
                 std::span<const ParameterWord> special = {});

/// The choice that `text` is the word of. \throws std::invalid_argument naming `what` and the words, if there is none.
[[nodiscard]] int parse_word(std::string_view text, std::string_view what, std::span<const ParameterWord> words);

/// \throws std::invalid_argument naming `what`, the value and the words, unless one of the words stands for the value.
void check_word(int value, std::span<const ParameterWord> words, std::string_view what);

}  // namespace emulsion
