#include "spectrum/named_spectra.h"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/chromaticity.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"

namespace emulsion {
namespace {

using testing::Contains;

double value(std::string_view name, double lambda_nm) { return eval(named_spectrum(name).value(), lambda_nm); }

TEST(NamedSpectra, IlluminantsComeFromTheTables) {
    EXPECT_EQ(named_spectrum("stdillum-D65"), Spectrum(tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65")));
    EXPECT_EQ(named_spectrum("stdillum-F11"), Spectrum(tabulated_spectrum("illuminants_5nm", "FL11")));
    EXPECT_EQ(named_spectrum("stdillum-FL11"), named_spectrum("stdillum-F11"));
    EXPECT_EQ(value("stdillum-A", 810.0) > 200.0, true) << "the table that goes beyond 780 nm";
    EXPECT_EQ(value("stdillum-HP1", 380.0), 1.9);
}

TEST(NamedSpectra, MetalsComeFromTheTables) {
    EXPECT_NEAR(value("metal-Ag-eta", 298.75705), 1.519, 1e-12);
    EXPECT_NEAR(value("metal-Cu-k", 885.601257), 5.717, 1e-12);
    EXPECT_EQ(value("metal-CuZn-eta", 550.0), 0.527);
    EXPECT_EQ(value("metal-CuZn-k", 550.0), 2.765);
}

TEST(NamedSpectra, GlassesOfPbrtAreThoseOfItsTables) {
    EXPECT_EQ(named_spectrum("glass-BK7"), named_spectrum("glass-N_BK7"));
    EXPECT_EQ(named_spectrum("glass-F5"), named_spectrum("glass-SF5"));
    EXPECT_EQ(named_spectrum("glass-F10"), named_spectrum("glass-SF10"));
    EXPECT_EQ(named_spectrum("glass-F11"), named_spectrum("glass-SF11"));
    EXPECT_NEAR(value("glass-LASF9", 589.3), 1.85004, 3e-5);
}

TEST(NamedSpectra, TheWhiteOfAcesIsDaylightOf6000K) {
    // Three of the numbers that AMPAS publishes, to the rounding of the components' weights.
    EXPECT_NEAR(value("illum-acesD60", 360.0), 38.3813, 5e-4);
    EXPECT_NEAR(value("illum-acesD60", 365.0), 40.6445, 5e-4);
    EXPECT_NEAR(value("illum-acesD60", 370.0), 42.9077, 5e-4);
    const Chromaticity white = chromaticity_of(xyz_of_radiance(*named_spectrum("illum-acesD60")));
    EXPECT_NEAR(white.x, 0.32168, 2e-4);
    EXPECT_NEAR(white.y, 0.33767, 2e-4);
    EXPECT_TRUE(is_known_to_pbrt("illum-acesD60"));
}

TEST(NamedSpectra, EveryListedNameIsAValidSpectrum) {
    const std::vector<std::string> names = named_spectrum_names();
    EXPECT_GE(names.size(), 80u);
    for (const std::string& name : names) {
        ASSERT_TRUE(named_spectrum(name).has_value()) << name;
        EXPECT_NO_THROW(validate(*named_spectrum(name))) << name;
        EXPECT_GT(value(name, 550.0), 0.0) << name;
    }
    EXPECT_THAT(names, Contains("metal-Au-k"));
    EXPECT_THAT(names, Contains("illum-acesD60"));
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
}

TEST(NamedSpectra, UnknownNamesAreUnset) {
    for (const char* name : {"", "stdillum-", "stdillum-d65", "D65", "glass_BK7", "colorchecker-red",
                             "johnson-christy-Ag-k", "metal-Au", "metal-Au-n", "glass-", "stdillum-wavelength"}) {
        EXPECT_FALSE(named_spectrum(name).has_value()) << name;
        EXPECT_FALSE(is_known_to_pbrt(name)) << name;
    }
}

TEST(NamedSpectra, KnowsWhichNamesPbrtHas) {
    for (const char* name : {"stdillum-A", "stdillum-D50", "stdillum-F12", "metal-CuZn-eta", "glass-F11"}) {
        EXPECT_TRUE(is_known_to_pbrt(name)) << name;
        EXPECT_TRUE(named_spectrum(name).has_value()) << name;
    }
    for (const char* name : {"metal-MgO-eta", "metal-TiO2-k", "canon_eos_5d_mkiv_r", "nikon_d850_g", "sony_ilce_9_b",
                             "hasselblad_l1d_20c_r"}) {
        EXPECT_TRUE(is_known_to_pbrt(name)) << name;
        EXPECT_FALSE(named_spectrum(name).has_value()) << name;
    }
    for (const char* name :
         {"stdillum-F13", "metal-Fe-eta", "glass-SF11", "nikon_d850", "nikon_d850_x", "metal-MgO-n"}) {
        EXPECT_FALSE(is_known_to_pbrt(name)) << name;
    }
}

}  // namespace
}  // namespace emulsion
