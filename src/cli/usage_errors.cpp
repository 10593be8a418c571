#include "cli/usage_errors.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/nearest_name.h"

namespace emulsion::cli {

namespace {

/// The innermost command that the command line names.
const CLI::App& chosen_command(const CLI::App& program) {
    const CLI::App* command = &program;
    while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
    return *command;
}

/// "emulsion color list"
std::string full_name(const CLI::App& command) {
    const CLI::App* parent = command.get_parent();
    return parent == nullptr ? command.get_name() : full_name(*parent) + " " + command.get_name();
}

/// "render, develop or merge"; empty if it has none.
std::string subcommand_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::App* each : command.get_subcommands({})) names.push_back(each->get_name());
    if (names.empty()) return {};
    const std::string last = names.back();
    names.pop_back();
    return fmt::format("{}{}{}", fmt::join(names, ", "), names.empty() ? "" : " or ", last);
}

/// What an option takes: its word for the value, "FILE", or "one".
std::string value_text(const CLI::Option& option) {
    const std::string& text = option.get_option_text();
    const bool has_word = text.find_first_not_of(" .") != std::string::npos;
    return has_word ? text : "one";
}

std::string missing_text(const CLI::App& command, const std::vector<std::string>& unread,
                         const std::string& otherwise) {
    if (const std::string names = subcommand_names(command); !names.empty()) {
        const bool is_word = !unread.empty() && !unread.front().starts_with('-');
        const std::string found = is_word ? "the subcommand \"" + unread.front() + "\"" : "no subcommand";
        return fmt::format("found {}, expected {}", found, names);
    }
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_required() || option->count() > 0) continue;
        return fmt::format("{}: found none, expected {}", option->get_name(), value_text(*option));
    }
    return otherwise;
}

std::string unknown_text(const CLI::App& command, const std::vector<std::string>& unread,
                         const std::string& otherwise) {
    if (unread.empty()) return otherwise;
    const std::string& found = unread.front();
    if (!found.starts_with('-')) {
        return fmt::format("found \"{}\", expected no further argument of {}", found, full_name(command));
    }
    std::vector<std::string_view> names;
    std::vector<std::string> owners;
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_positional()) owners.push_back(option->get_name());
    }
    names.assign(owners.begin(), owners.end());
    const std::string_view nearest = nearest_name(found.substr(0, found.find('=')), names);
    return fmt::format("found \"{}\", expected an option of {}{}{}", found, full_name(command),
                       nearest.empty() ? "" : "; nearest: ", nearest);
}

/// Of values too many or too few; the message starts with the option's name.
std::string mismatch_text(const CLI::App& command, const std::string& message) {
    // "half was given a disallowed flag override" of --half=x, without its dashes.
    const std::string word = message.substr(0, message.find_first_of(": "));
    const std::vector<const CLI::Option*> options = command.get_options();
    const auto is_named = [&](const CLI::Option* each) { return each->check_name(word) || each->check_lname(word); };
    const auto found = std::find_if(options.begin(), options.end(), is_named);
    if (found == options.end()) return message;
    const CLI::Option& option = **found;
    const std::string name = option.get_name();
    if (option.get_expected_max() == 0) return fmt::format("{}: found a value, expected none", name);
    if (option.count() > 1) return fmt::format("{}: found {} values, expected one", name, option.count());
    return fmt::format("{}: found no value, expected {}", name, value_text(option));
}

}  // namespace

std::string usage_error_text(const CLI::App& program, const CLI::ParseError& error) {
    const CLI::App& command = chosen_command(program);
    const std::vector<std::string> unread = program.remaining(true);
    const std::string message = error.what();
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return missing_text(command, unread, message);
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return unknown_text(command, unread, message);
    const bool is_mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr;
    return is_mismatch ? mismatch_text(command, message) : message;
}

}  // namespace emulsion::cli
