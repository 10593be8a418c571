#include "cli/named_option.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace emulsion::cli {

namespace {

/// But for the default.
bool means_the_same(const ParameterDescription& a, const ParameterDescription& b) {
    return a.name == b.name && a.help == b.help && a.unit == b.unit && a.range_text == b.range_text;
}

/// "key=0.18  scaled luminance given to the log-average, in (0, inf)", a line for each parameter, and one for those
/// that are among `told`; adds the others to them.
std::string parameter_lines(const NamedValueDescription& choice, std::vector<ParameterDescription>& told) {
    std::string lines, again;
    for (const ParameterDescription& parameter : choice.parameters) {
        const auto same = [&](const ParameterDescription& earlier) { return means_the_same(earlier, parameter); };
        if (std::any_of(told.begin(), told.end(), same)) {
            again += fmt::format("{}{}={}", again.empty() ? "" : ", ", parameter.name, parameter.default_text);
            continue;
        }
        lines += fmt::format("\n    {}={}  {}{}{}, in {}", parameter.name, parameter.default_text, parameter.help,
                             parameter.unit.empty() ? "" : ", ", parameter.unit, parameter.range_text);
        told.push_back(parameter);
    }
    return again.empty() ? lines : lines + fmt::format("\n    {}  as above", again);
}

}  // namespace

std::string named_option_help(std::string_view what, std::string_view default_text,
                              std::span<const NamedValueDescription> choices) {
    std::string text = fmt::format("{}, NAME[:parameter=value,...] [default: {}]; one of", what, default_text);
    std::vector<ParameterDescription> told;
    for (const NamedValueDescription& choice : choices) {
        text += fmt::format("\n  {}: {}", choice.name, choice.help) + parameter_lines(choice, told);
    }
    return text;
}

}  // namespace emulsion::cli
