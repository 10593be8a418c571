// docs/colour-systems.md lists what users may name. Its tables are compared with what the variants and tables hold; if
// a test fails, it prints the rows that belong there.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "core/text_file.h"
#include "spectrum/color_system.h"
#include "spectrum/data_table.h"
#include "spectrum/transfer_function.h"

namespace emulsion {
namespace {

/// The rows of the table below this heading, without its head.
std::vector<std::string> rows_below(std::string_view heading) {
    const std::string text = read_text_file(EMULSION_SOURCE_DIR "/docs/colour-systems.md");
    std::vector<std::string> rows;
    bool inside = false;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        if (line.starts_with("## ")) inside = line.substr(3) == heading;
        if (inside && line.starts_with("| ")) rows.push_back(line);
        begin = end + 1;
    }
    if (!rows.empty()) rows.erase(rows.begin());
    return rows;
}

std::string described(const ColorComponent& component) {
    return fmt::format("`{}` {}, {} to {}{}{}", component.name, component.meaning, component.min, component.max,
                       component.unit.empty() ? "" : " ", component.unit);
}

void expect_rows(std::string_view heading, const std::vector<std::string>& expected) {
    std::string all;
    for (const std::string& row : expected) all += row + '\n';
    EXPECT_EQ(rows_below(heading), expected) << "## " << heading << '\n' << all;
}

TEST(ColorSystemDocs, ListEverySystemAndItsComponents) {
    std::vector<std::string> rows;
    for_each_alternative<ColorSystem>([&](const auto& system) {
        std::string components;
        for (const ColorComponent& component : components_of(system)) {
            components += (components.empty() ? "" : "; ") + described(component);
        }
        rows.push_back(
            fmt::format("| `{}` | {} | {} | {} |", to_text(system), system.kHelp, components, system.kDomain));
    });
    expect_rows("Colour systems", rows);
}

TEST(ColorSystemDocs, ListEveryTransferFunction) {
    std::vector<std::string> rows;
    for_each_alternative<TransferFunction>(
        [&](const auto& transfer) { rows.push_back(fmt::format("| `{}` | {} |", to_text(transfer), transfer.kHelp)); });
    expect_rows("Transfer functions", rows);
}

TEST(ColorSystemDocs, ListEveryRgbSpace) {
    std::vector<std::string> rows;
    for (const std::string& name : data_table("rgb_colourspaces").row_names) {
        const auto [label, red, green, blue, white] = rgb_space(name);
        rows.push_back(fmt::format("| `{}` | {}, {} | {}, {} | {}, {} | {}, {} |", label, red.x, red.y, green.x,
                                   green.y, blue.x, blue.y, white.x, white.y));
    }
    expect_rows("RGB spaces", rows);
}

}  // namespace
}  // namespace emulsion
