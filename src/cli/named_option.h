#pragma once
// Flags whose values are named values (core/named_value.h): NAME[:parameter=value,...].

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "core/named_value.h"

namespace emulsion::cli {

/// "WHAT, NAME[:parameter=value,...] [default: ...]; one of" and, below, the names with their parameters. What a
/// parameter means is said once: of those that an earlier choice has, too, only the default.
[[nodiscard]] std::string named_option_help(std::string_view what, std::string_view default_text,
                                            std::span<const NamedValueDescription> choices);

/// Reads such a value for a flag, and checks what parameters say together (a display's triangle), as far as its type
/// has a validate(). \throws CLI::ValidationError naming the flag.
template <NamedVariant Variant>
[[nodiscard]] Variant parse_named_option(const std::string& text, const std::string& flag, std::string_view kind) {
    try {
        auto value = parse_named<Variant>(text, kind);
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
        value = parse_named_option<Variant>(text, flag, kind);
    };
    return command
        .add_option_function<std::string>(flag, parse,
                                          named_option_help(what, to_text(value), describe_named<Variant>()))
        ->option_text("NAME");
}

/// The same where no value means another source's; `otherwise` names it.
template <NamedVariant Variant>
CLI::Option* add_named_option(CLI::App& command, const std::string& flag, std::string_view kind,
                              std::optional<Variant>& value, std::string_view what, std::string_view otherwise) {
    const auto parse = [&value, flag, kind = std::string(kind)](const std::string& text) {
        value = parse_named_option<Variant>(text, flag, kind);
    };
    return command
        .add_option_function<std::string>(flag, parse, named_option_help(what, otherwise, describe_named<Variant>()))
        ->option_text("NAME");
}

}  // namespace emulsion::cli
