#include "cli/named_option.h"

#include <fmt/format.h>

namespace emulsion::cli {

std::string named_option_help(std::string_view what, std::string_view default_text,
                              std::span<const NamedValueDescription> choices) {
    std::string text = fmt::format("{}, NAME[:parameter=value,...] [default: {}]; one of", what, default_text);
    for (const NamedValueDescription& choice : choices) {
        text += fmt::format("\n  {}: {}", choice.name, choice.help);
        for (const ParameterDescription& parameter : choice.parameters) {
            text += fmt::format("\n    {}={}  {}{}{}, in {}", parameter.name, parameter.default_text, parameter.help,
                                parameter.unit.empty() ? "" : ", ", parameter.unit, parameter.range_text);
        }
    }
    return text;
}

}  // namespace emulsion::cli
