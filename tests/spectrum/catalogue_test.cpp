#include "spectrum/catalogue.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/name_key.h"
#include "core/units.h"
#include "spectrum/data_table.h"
#include "spectrum/embedded_tables.h"
#include "spectrum/named_spectra.h"
#include "spectrum/sellmeier.h"

namespace emulsion {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::ThrowsMessage;

double value(std::string_view name, double lambda_nm) { return eval(catalogue_spectrum(name), lambda_nm); }

TEST(Catalogue, HoldsEveryColumnOfEveryTable) {
    std::set<std::pair<std::string_view, std::string>> held;
    for (const NamedSpectrumInfo& entry : spectrum_catalogue()) held.insert({entry.table, entry.column});
    for (const EmbeddedTableFile& file : embedded_table_files()) {
        const DataTable& table = data_table(file.name);
        if (table.name == "rgb_colourspaces") continue;  // no spectra
        const bool is_glass = table.name == "glasses";
        for (const std::string& column : is_glass ? table.row_names : table.column_names) {
            if (column.starts_with("wavelength")) continue;
            // A and the D's of the narrow table give way to those of the wide one.
            const bool is_twice = table.name == "illuminants_5nm" &&
                                  held.contains({std::string_view("illuminants_a_d_300_830_5nm"), column});
            EXPECT_EQ(held.contains({file.name, column}), !is_twice) << table.name << ": " << column;
        }
    }
}

TEST(Catalogue, HasTheNumbersOfItsGroups) {
    std::map<std::string_view, int> count;
    for (const NamedSpectrumInfo& entry : spectrum_catalogue()) ++count[entry.group];
    EXPECT_EQ(count["illuminant"], 48);
    EXPECT_EQ(count["emission"], 1);
    EXPECT_EQ(count["reflectance"], 24 + 15 + 14 + 24 + 3);
    EXPECT_EQ(count["index of refraction"], 4 + 1 + 3 + 14);
    EXPECT_EQ(count["extinction coefficient"], 4 + 1 + 3);
    EXPECT_EQ(count["luminous efficiency"], 2);
    EXPECT_EQ(count["colour-matching function"], 4 * 3);
    EXPECT_EQ(count["component of daylight"], 3);
    EXPECT_EQ(count.size(), spectrum_groups().size());
}

TEST(Catalogue, NoNameMeansTwoSpectra) {
    std::map<std::string, std::string> owner;
    for (const NamedSpectrumInfo& entry : spectrum_catalogue()) {
        std::vector<std::string> names = entry.aliases;
        names.push_back(entry.name);
        for (const std::string& name : names) {
            const auto [place, is_new] = owner.emplace(name_key(name), entry.name);
            EXPECT_TRUE(is_new) << name << " is of " << entry.name << " and of " << place->second;
            EXPECT_EQ(find_in_catalogue(name), &entry) << name;
        }
    }
}

TEST(Catalogue, DescribesEachSpectrumAsItIs) {
    for (const NamedSpectrumInfo& entry : spectrum_catalogue()) {
        const PiecewiseLinearSpectrum spectrum = spectrum_of(entry);
        EXPECT_NO_THROW(validate(spectrum)) << entry.name;
        EXPECT_EQ(entry.first_nm, spectrum.lambda_nm.front()) << entry.name;
        EXPECT_EQ(entry.last_nm, spectrum.lambda_nm.back()) << entry.name;
        if (entry.step_nm > 0.0) {
            EXPECT_EQ(spectrum.lambda_nm.size(), std::round((entry.last_nm - entry.first_nm) / entry.step_nm) + 1.0);
        }
        EXPECT_THAT(spectrum_groups(), Contains(entry.group));
        EXPECT_THAT(entry.unit, testing::AnyOf("1", "relative power"));
        EXPECT_GE(entry.source.size(), 40u) << entry.name;
        if (entry.group == "reflectance") {
            for (const double reflectance : spectrum.value) {
                EXPECT_GE(reflectance, 0.0) << entry.name;
                // As published, one sample of the camera training set goes above 1 between 700 and 755 nm.
                EXPECT_LE(reflectance, entry.name == "ampas-patch125" ? 1.0891 : 1.0) << entry.name;
            }
        }
    }
    const NamedSpectrumInfo& red = *find_in_catalogue("colorchecker-red");
    EXPECT_THAT(red.source, AllOf(HasSubstr("reflectance"), HasSubstr("Ohta (1997)")));
    EXPECT_EQ(red.step_nm, 5.0);
    EXPECT_EQ(find_in_catalogue("metal-Ag-k")->step_nm, 0.0);
}

// One value a group, read off the tables.
TEST(Catalogue, FindsTheRightNumbers) {
    EXPECT_EQ(value("D65", 560.0), 100.0);
    EXPECT_EQ(value("D65", 300.0), 0.0341);
    EXPECT_EQ(value("fl3.10", 380.0), 0.25);
    EXPECT_EQ(value("led-rgb1", 380.0), 0.0);
    EXPECT_EQ(value("F11", 380.0), 0.91);
    EXPECT_EQ(value("ColorChecker dark skin", 380.0), 0.048);
    EXPECT_EQ(value("colorchecker-black", 780.0), 0.032);
    EXPECT_EQ(value("colorchecker-neutral_8_23_d", 380.0), 0.15);
    EXPECT_EQ(value("colorchecker-neutral-3.5", 780.0), 0.083);
    EXPECT_EQ(value("vs15", 830.0), 0.7439);
    EXPECT_EQ(value("TCS14", 360.0), 0.036);
    EXPECT_EQ(value("ampas-patch189", 780.0), 0.7247);
    EXPECT_EQ(value("cornell-red", 700.0), 0.642);
    EXPECT_EQ(value("cornell-light", 700.0), 18.4);
    EXPECT_EQ(value("metal-Ag-eta", 298.75705), 1.519);
    EXPECT_EQ(value("metal-CuZn-k", 890.0), 5.575);
    EXPECT_EQ(value("V", 555.0), 1.0);
    EXPECT_EQ(value("v'", 507.0), 1.0);
    EXPECT_EQ(value("cie_1964_10deg-ybar10", 550.0), 0.991761);
    EXPECT_EQ(value("stockman_sharpe_2deg-sbar", 390.0), 0.00954729);
    EXPECT_EQ(value("s2", 830.0), 6.5);
}

// The table of Johnson & Christy is in micrometres.
TEST(Catalogue, TakesMicrometresToNanometres) {
    const NamedSpectrumInfo& entry = *find_in_catalogue("johnson-christy-au-k");
    EXPECT_NEAR(entry.first_nm, 187.9, 1e-12);
    EXPECT_NEAR(entry.last_nm, 1937.0, 1e-12);
    const double at_550 = value("johnson-christy-Au-k", 550.0), palik = value("metal-Au-k", 550.0);
    EXPECT_NEAR(at_550 / palik, 1.0, 0.1) << "two measurements of gold";
}

TEST(Catalogue, GlassesAreTheirFormulaAtWholeNanometresAndNearItBetween) {
    for (const SellmeierGlass& glass : sellmeier_glasses()) {
        const std::string name = glass.name == "F5" ? "glass-schott-F5" : "glass-" + glass.name;
        EXPECT_EQ(value(name, 360.0), extrapolated_index(glass, 360.0)) << name;
        EXPECT_EQ(value(name, 830.0), extrapolated_index(glass, 830.0)) << name;
        for (const double lambda_nm : {360.5, 390.5, 587.5618, 829.5}) {
            EXPECT_NEAR(value(name, lambda_nm), extrapolated_index(glass, lambda_nm), 3e-6) << name;
        }
    }
    EXPECT_EQ(catalogue_spectrum("glass-f5"), catalogue_spectrum("glass-SF5"));
    EXPECT_NE(catalogue_spectrum("glass-schott-f5"), catalogue_spectrum("glass-SF5"));
}

TEST(Catalogue, MeansTheSameAsScenesDo) {
    for (const std::string& name : named_spectrum_names()) {
        if (name == "illum-acesD60") continue;  // worked out, not tabulated
        EXPECT_EQ(Spectrum(catalogue_spectrum(name)), named_spectrum(name).value()) << name;
    }
}

TEST(Catalogue, AnUnknownNameGivesTheNearestOnes) {
    EXPECT_EQ(find_in_catalogue("D66"), nullptr);
    EXPECT_THAT([] { (void)catalogue_spectrum("colorcheker-drak-skin"); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("spectrum \"colorcheker-drak-skin\""),
                                                           HasSubstr("catalogue: colorchecker-dark-skin, "))));
    EXPECT_THROW((void)catalogue_spectrum(""), std::invalid_argument);
    EXPECT_THROW((void)catalogue_spectrum(std::string(1 << 20, 'x')), std::invalid_argument) << "and soon";
}

}  // namespace
}  // namespace emulsion
