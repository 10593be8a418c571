// `emulsion color list`: every name that the color commands know.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/color_tasks.h"
#include "cli/difference_method.h"
#include "cli/messages.h"
#include "cli/option_checks.h"
#include "core/name_key.h"
#include "core/named_value.h"
#include "spectrum/catalogue.h"
#include "spectrum/chromatic_adaptation.h"
#include "spectrum/color_system.h"
#include "spectrum/data_table.h"
#include "spectrum/observer.h"
#include "spectrum/transfer_function.h"

namespace emulsion::cli {

namespace {

void print_named(const std::vector<NamedValueDescription>& all) {
    for (const NamedValueDescription& value : all) {
        print_output(fmt::format("  {:<24}{}\n", value.name, value.help));
        for (const ParameterDescription& parameter : value.parameters) {
            print_output(fmt::format("    {}={}  {}{}{}, in {}\n", parameter.name, parameter.default_text,
                                     parameter.help, parameter.unit.empty() ? "" : ", ", parameter.unit,
                                     parameter.range_text));
        }
    }
}

void print_systems() {
    for_each_alternative<ColorSystem>([](const auto& system) {
        std::vector<std::string_view> names;
        for (const ColorComponent& component : components_of(system)) names.push_back(component.name);
        print_output(
            fmt::format("  {:<24}{:<16}{}\n", system.kName, fmt::format("{}", fmt::join(names, " ")), system.kHelp));
    });
}

void print_rgb_spaces() {
    for (const std::string& name : data_table("rgb_colourspaces").row_names) {
        const RgbSpace& s = rgb_space(name);
        print_output(fmt::format("  {:<24}red {} {}, green {} {}, blue {} {}, white {} {}\n", name, s.red.x, s.red.y,
                                 s.green.x, s.green.y, s.blue.x, s.blue.y, s.white.x, s.white.y));
    }
}

void print_spectra(std::string_view group) {
    for (const NamedSpectrumInfo& entry : spectrum_catalogue()) {
        if (entry.group != group) continue;
        std::string names = entry.name;
        for (const std::string& alias : entry.aliases) names += ", " + alias;
        print_output(fmt::format("  {:<40}{:g}-{:g} nm{}\n", names, entry.first_nm, entry.last_nm,
                                 entry.step_nm > 0.0 ? fmt::format(", step {:g} nm", entry.step_nm) : ""));
    }
}

void print_observers() {
    for (const std::string_view name : observer_names()) {
        const Observer& o = observer(name);
        print_output(fmt::format("  {:<24}{}-{} nm\n", name, o.first_nm, o.last_nm()));
    }
}

/// A part of the list: what is asked for, and what heads it.
struct Section {
    std::string_view name, title;
    void (*print)();
};

template <NamedVariant Variant>
void print_variant() {
    print_named(describe_named<Variant>());
}

const std::vector<Section>& sections() {
    static const std::vector<Section> all = {
        {"spaces", "Colour systems, for SPACE", print_systems},
        {"rgb-spaces", "RGB spaces, for --rgb-space, and for SPACE: linear RGB", print_rgb_spaces},
        {"transfers", "Transfer functions, for --transfer", print_variant<TransferFunction>},
        {"adaptations", "Chromatic adaptations, for --adapt, and for --method of adapt",
         print_variant<ChromaticAdaptation>},
        {"differences", "Colour differences, for --method of difference", print_variant<DifferenceMethod>},
        {"observers", "Standard observers, for --observer", print_observers},
    };
    return all;
}

/// "illuminant" is asked for as "illuminants", "index of refraction" as "index-of-refraction".
std::string section_name(std::string_view group) {
    std::string name(group);
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

std::vector<std::string> section_names() {
    std::vector<std::string> names;
    for (const Section& section : sections()) names.emplace_back(section.name);
    for (const std::string_view group : spectrum_groups()) names.push_back(section_name(group));
    return names;
}

std::string parse_section(const std::string& text) {
    const std::vector<std::string> names = section_names();
    for (const std::string& name : names) {
        if (name_key(name) == name_key(text)) return name;
    }
    throw CLI::ValidationError("SECTION", found_expected(text, fmt::format("one of {}", fmt::join(names, ", "))));
}

void print_list(const std::string& asked) {
    std::string separator;
    const auto head = [&](std::string_view name, std::string_view title) {
        if (!asked.empty() && asked != name) return false;
        print_output(fmt::format("{}{} [{}]\n", separator, title, name));
        separator = "\n";
        return true;
    };
    for (const Section& section : sections()) {
        if (head(section.name, section.title)) section.print();
    }
    for (const std::string_view group : spectrum_groups()) {
        if (head(section_name(group), fmt::format("Spectra: {}", group))) print_spectra(group);
    }
}

}  // namespace

ColorTask add_color_list(CLI::App& color) {
    CLI::App& command = *color.add_subcommand("list", "Every name that these commands know");
    const auto section = std::make_shared<std::string>();
    command
        .add_option_function<std::string>(
            "SECTION", [section](const std::string& text) { *section = parse_section(text); },
            fmt::format("Only this part, one of {} [default: all]", fmt::join(section_names(), ", ")))
        ->option_text(" ");
    return {&command, [section] { print_list(*section); }};
}

}  // namespace emulsion::cli
