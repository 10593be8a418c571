#include "film/sensor_options.h"

#include <cmath>
#include <functional>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/film.h"
#include "sensor_fixture.h"

namespace emulsion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(SensorOptions, ImagingRatioIsTimeTimesIsoOver100) {
    EXPECT_EQ(imaging_ratio({}), 1.0);
    EXPECT_EQ(imaging_ratio({.exposure_time_s = 0.5, .iso = 800.0}), 4.0);
    EXPECT_EQ(white_luminance_cdm2({}), 1.0);
    EXPECT_EQ(white_luminance_cdm2({.exposure_time_s = 0.5, .iso = 800.0}), 0.25);
}

struct BadOptions {
    std::function<void(SensorOptions&)> spoil;
    std::string field, range;
};

TEST(SensorOptions, RefusesWhatIsOutOfRange) {
    const BadOptions all[] = {
        {[](auto& o) { o.exposure_time_s = 0.0; }, "exposure_time_s", "(0, inf)"},
        {[](auto& o) { o.exposure_time_s = -1.0; }, "exposure_time_s", "(0, inf)"},
        {[](auto& o) { o.exposure_time_s = std::nan(""); }, "exposure_time_s", "(0, inf)"},
        {[](auto& o) { o.iso = HUGE_VAL; }, "iso", "(0, inf)"},
        {[](auto& o) { o.iso = -100.0; }, "iso", "(0, inf)"},
        {[](auto& o) { o.iso = 1e33; }, "imaging ratio", "[1e-30, 1e+30]"},
        {[](auto& o) { o.exposure_time_s = 1e-31; }, "imaging ratio", "[1e-30, 1e+30]"},
        {[](auto& o) { o.observer = "cie_1932"; }, "observer", "cie_1931_2deg"},
        {[](auto& o) { o.white_balance = WhiteBalance{TemperatureWhite{999.0}}; }, "temperature_K", "[1000, 25000]"},
        {[](auto& o) { o.white_balance = WhiteBalance{TemperatureWhite{25001.0}}; }, "temperature_K", "[1000, 25000]"},
        {[](auto& o) {
             o.white_balance = WhiteBalance{Chromaticity{0.3, 0.0}};
         },
         "y of the white", "(0, inf)"},
        {[](auto& o) {
             o.white_balance = WhiteBalance{Chromaticity{std::nan(""), 0.3}};
         },
         "x of the white", "(-inf"},
        {[](auto& o) {
             o.white_balance = WhiteBalance{Chromaticity{0.1, 0.9}};
         },
         "white", "bradford"},
        {[](auto& o) { o.camera = CameraSensor{}; }, "camera", "360 to 830 nm"},
        {[](auto& o) {
             o.camera = CameraSensor{testing::humps_camera(), {BlackbodySpectrum{-1.0}}};
         },
         "temperature_K", "> 0"},
        {[](auto& o) {
             o.camera = CameraSensor{testing::humps_camera(), {.target_illuminant = DaylightSpectrum{5000.0}}};
             o.white_balance = WhiteBalance{};
         },
         "target_illuminant", "one of them"},
    };
    for (const BadOptions& bad : all) {
        SensorOptions options;
        bad.spoil(options);
        const auto names_it = ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(bad.field), HasSubstr(bad.range)));
        EXPECT_THAT([&] { validate(options); }, names_it);
        EXPECT_THAT([&] { Sensor{options}; }, names_it);
        EXPECT_THAT([&] { Film({4, 4, options}); }, names_it);
    }
}

TEST(SensorOptions, TakesEverySensorAndTheEndsOfItsRanges) {
    for (const auto& [name, options] : testing::every_sensor()) {
        EXPECT_NO_THROW(validate(options)) << name;
        EXPECT_EQ(options, SensorOptions(options));
    }
    EXPECT_NO_THROW(validate({.exposure_time_s = 1e-30}));
    EXPECT_NO_THROW(validate({.exposure_time_s = 1e30}));
    for (const double kelvin : {1000.0, 3999.9, 4000.0, 25000.0}) {
        EXPECT_NO_THROW(Sensor({.white_balance = WhiteBalance{TemperatureWhite{kelvin}}})) << kelvin;
    }
}

// The name of an observer in any spelling.
TEST(SensorOptions, ObserverByAnyOfItsNames) {
    EXPECT_EQ(Sensor({.observer = "1964"}).response(500.0), Sensor({.observer = "CIE 1964 10deg"}).response(500.0));
    EXPECT_NE(Sensor({.observer = "1964"}).response(500.0), Sensor().response(500.0));
}

}  // namespace
}  // namespace emulsion
