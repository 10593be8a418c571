#pragma once
// Flags whose values are named values (core/named_value.h): NAME[:parameter=value,...].

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "core/named_value.h"
#include "develop/pipeline.h"

namespace emulsion::cli {

/// "WHAT, NAME[:parameter=value,...] [default: ...]; one of" and, below, the names with their parameters. What a
/// parameter means is said once: of those that an earlier choice has, too, only the default.
[[nodiscard]] std::string named_option_help(std::string_view what, std::string_view default_text,
                                            std::span<const NamedValueDescription> choices);

/// What parse() reads for a flag; checks what parameters say together (a display's triangle), as far as its type has a
/// validate(). \throws CLI::ValidationError naming the flag, for what that or parse() refuses.
template <class Parse>
[[nodiscard]] auto parse_named_option(const std::string& flag, const Parse& parse) {
    try {
        auto value = parse();
        if constexpr (requires { validate(value); }) validate(value);
        return value;
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError(flag, error.what());
    }
}

/// Adds a flag ("--tonemap") that sets `value`, whose present value is the default; what is no such value is bad usage.
/// `kind` is the role in messages: "tonemap". `value` must outlive the parsing.
template <NamedVariant Variant>
CLI::Option* add_named_option(CLI::App& command, const std::string& flag, std::string_view kind, Variant& value,
                              std::string_view what) {
    const auto parse = [&value, flag, kind = std::string(kind)](const std::string& text) {
        value = parse_named_option(flag, [&] { return parse_named<Variant>(text, kind); });
    };
    return command
        .add_option_function<std::string>(flag, parse,
                                          named_option_help(what, to_text(value), describe_named<Variant>()))
        ->option_text("NAME");
}

/// The same where no value, "own", means another's; `whose` says whose: "the operator's".
template <NamedVariant Variant>
CLI::Option* add_named_option(CLI::App& command, const std::string& flag, std::string_view kind,
                              std::optional<Variant>& value, std::string_view what, std::string_view whose) {
    const auto parse = [&value, flag, kind = std::string(kind)](const std::string& text) {
        value = parse_named_option(flag, [&] { return parse_named_or<Variant>(kOwnStage, text, kind); });
    };
    return command
        .add_option_function<std::string>(
            flag, parse,
            named_option_help(what, std::string(kOwnStage) + ", " + std::string(whose), describe_named<Variant>()))
        ->option_text("NAME");
}

}  // namespace emulsion::cli
