#include "cli/measured_display.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/number_list.h"
#include "cli/option_checks.h"
#include "core/error.h"
#include "spectrum/table_transfer.h"

namespace emulsion::cli {

namespace {

constexpr const char *kPrimaries = "--primaries", *kWhite = "--white", *kTransferTable = "--transfer-table";

/// In the order of --primaries, and of --white behind it.
constexpr std::array kChromaticities = {&CustomDisplay::rx, &CustomDisplay::ry, &CustomDisplay::gx, &CustomDisplay::gy,
                                        &CustomDisplay::bx, &CustomDisplay::by, &CustomDisplay::wx, &CustomDisplay::wy};
constexpr std::size_t kWithoutWhite = 6;

/// The custom display that is measured further. The default is no one's choice, and gives way.
CustomDisplay custom_display(const Pipeline& pipeline, const CLI::Option& display, const char* flag) {
    if (const auto* custom = std::get_if<CustomDisplay>(&pipeline.display)) return *custom;
    if (display.count() == 0 && pipeline.display == Pipeline{}.display) return {};
    const auto name = std::visit([](const auto& chosen) { return chosen.kName; }, pipeline.display);
    throw CLI::ValidationError(flag, fmt::format("found the display {} as well, expected none, or custom", name));
}

/// Chromaticities from the member `first` on, of which there may be as many as one of `counts`.
void read_chromaticities(const std::string& text, std::size_t first, std::initializer_list<std::size_t> counts,
                         const char* flag, std::string_view expected, CustomDisplay& display) {
    const auto numbers = numbers_of<double>(text, ',');
    const auto in_range = [](double number) { return CustomDisplay::kChromaticity.contains(number); };
    const bool is_good = numbers && std::find(counts.begin(), counts.end(), numbers->size()) != counts.end() &&
                         std::all_of(numbers->begin(), numbers->end(), in_range);
    if (!is_good) throw CLI::ValidationError(flag, found_expected(text, expected));
    for (std::size_t i = 0; i < numbers->size(); ++i) display.*kChromaticities.at(first + i) = (*numbers)[i];
}

/// Of all flags together.
void check_display(const Pipeline& pipeline, const char* flag) {
    try {
        validate(pipeline.display);
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError(flag, error.what());
    }
}

}  // namespace

void add_primaries_options(CLI::App& command, const CLI::Option& display, Pipeline& pipeline) {
    const auto set_primaries = [&command, &display, &pipeline](const std::string& text) {
        CustomDisplay measured = custom_display(pipeline, display, kPrimaries);
        read_chromaticities(text, 0, {kWithoutWhite, kChromaticities.size()}, kPrimaries,
                            "rx,ry,gx,gy,bx,by or rx,ry,gx,gy,bx,by,wx,wy, each in [0, 1]", measured);
        pipeline.display = measured;
        if (command.count(kWhite) == 0) check_display(pipeline, kPrimaries);
    };
    const CLI::Option* primaries =
        command
            .add_option_function<std::string>(
                kPrimaries, set_primaries,
                "Primaries of the display as measured, CIE 1931, and maybe its white: the same as --display "
                "custom:rx=... with the peak, black and flare that this has beside it [default: as --display]")
            ->option_text("rx,ry,gx,gy,bx,by[,wx,wy]");
    const auto set_white = [&display, &pipeline, primaries](const std::string& text) {
        if (primaries->count() > 0 && split(primaries->results().front(), ',').size() == kChromaticities.size()) {
            throw CLI::ValidationError(kWhite, "found a white in --primaries as well, expected one of the two");
        }
        CustomDisplay measured = custom_display(pipeline, display, kWhite);
        read_chromaticities(text, kWithoutWhite, {2}, kWhite, "x,y, each in [0, 1]", measured);
        pipeline.display = measured;
        check_display(pipeline, kWhite);
    };
    command
        .add_option_function<std::string>(kWhite, set_white,
                                          "White of that display as measured [default: as --display]; the scene's is "
                                          "--scene-white")
        ->option_text("x,y");
}

void add_transfer_table_option(CLI::App& command, const CLI::Option& transfer, Pipeline& pipeline) {
    const auto read = [&transfer, &pipeline](const std::string& file) {
        if (transfer.count() > 0) {
            throw CLI::ValidationError(kTransferTable, "found --transfer as well, expected one of the two");
        }
        try {
            pipeline.transfer = read_table_transfer(file);
        } catch (const IoError& error) {
            throw CLI::ValidationError(kTransferTable, error.what());
        }
    };
    command
        .add_option_function<std::string>(
            kTransferTable, read,
            "Measured transfer function: a row for each of up to 1024 codes, and the luminance that it gave; the same "
            "as --transfer table:... [default: as --transfer]")
        ->option_text("FILE.csv");
}

}  // namespace emulsion::cli
