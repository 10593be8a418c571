#include "pathtracer/transport_model.h"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/rgb_space.h"

namespace emulsion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(TransportModel, TextsReadBackAsTheSameModel) {
    for (const TransportModel& model :
         {TransportModel{}, TransportModel{SpectralModel{8, HeroIlluminant{0.25f}}},
          TransportModel{SpectralModel{1, IndependentUniform{}}}, TransportModel{RgbModel{}},
          TransportModel{RgbModel{"Rec2020"}}, TransportModel{RgbModel{"sharp"}}, TransportModel{PrefilteredRgbModel{}},
          TransportModel{BasisModel{}}, TransportModel{BasisModel{8}}}) {
        EXPECT_EQ(parse_transport_model(to_text(model)), model) << to_text(model);
    }
}

TEST(TransportModel, WhatIsLeftOutHasItsDefault) {
    EXPECT_EQ(to_text(parse_transport_model("spectral")), "spectral:4");
    EXPECT_EQ(to_text(parse_transport_model("spectral:2")), "spectral:2");
    EXPECT_EQ(to_text(parse_transport_model("spectral:2:hero-visible")), "spectral:2");
    EXPECT_EQ(to_text(parse_transport_model("spectral:2:hero-uniform")), "spectral:2:hero-uniform");
    EXPECT_EQ(to_text(parse_transport_model("rgb")), "rgb:sRGB");
    EXPECT_EQ(to_text(parse_transport_model("rgb:ACEScg")), "rgb:ACEScg_AP1");
    EXPECT_EQ(to_text(parse_transport_model("rgb:SHARP")), "rgb:sharp");
    EXPECT_EQ(to_text(parse_transport_model("basis")), "basis:6");
}

TEST(TransportModel, NamesAreComparedAsElsewhere) {
    EXPECT_EQ(to_text(parse_transport_model("RGB")), "rgb:sRGB");
    EXPECT_EQ(to_text(parse_transport_model("rgb:Rec.709")), "rgb:Rec709");
    EXPECT_EQ(to_text(parse_transport_model("rgb:rec.2020")), "rgb:Rec2020");
    EXPECT_EQ(to_text(parse_transport_model("RGB_Prefiltered")), "rgb-prefiltered");
    EXPECT_EQ(to_text(parse_transport_model("Basis:4")), "basis:4");
    EXPECT_EQ(to_text(parse_transport_model("Spectral:2:Hero_Uniform")), "spectral:2:hero-uniform");
}

TEST(TransportModel, RefusesWhatIsNone) {
    const auto message = [](const char* text) -> std::string {
        try {
            static_cast<void>(parse_transport_model(text));
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "taken";
    };
    EXPECT_THAT(message("rbg"), HasSubstr("found \"rbg\", expected spectral:N[:STRATEGY], rgb[:SPACE]"));
    EXPECT_THAT(message(""), HasSubstr("found \"\""));
    EXPECT_THAT(message("spectral:3"), HasSubstr("wavelengths 3: must be one of 1, 2, 4, 8, 16, 32"));
    EXPECT_THAT(message("spectral:four"), HasSubstr("four"));
    EXPECT_THAT(message("spectral:4:hero"), HasSubstr("hero-visible"));
    EXPECT_THAT(message("spectral:4:hero-lines:uniform-share=2"), HasSubstr("uniform-share"));
    EXPECT_THAT(message("rgb:Rec1886"), AllOf(HasSubstr("Rec2020"), HasSubstr("or sharp")));
    EXPECT_THAT(message("rgb:"), HasSubstr("found \"rgb:\", expected rgb[:SPACE]"));
    EXPECT_THAT(message("basis:"), HasSubstr("found \"basis:\", expected basis:K"));
    for (const std::string text : {"spectral:", "spectral:4:", "spectral::hero-visible"}) {
        EXPECT_THAT(message(text.c_str()), HasSubstr("found \"" + text + "\", expected spectral:N[:STRATEGY]"));
    }
    EXPECT_THAT(message("rgb-prefiltered:"), HasSubstr("alone"));
    EXPECT_THAT(message("rgb-prefiltered:sRGB"), HasSubstr("expected \"rgb-prefiltered\" alone"));
    EXPECT_THAT(message("basis:2"), HasSubstr("functions 2: must be in [3, 8]"));
    EXPECT_THAT(message("basis:9"), HasSubstr("functions 9: must be in [3, 8]"));
}

TEST(TransportModel, EveryFormIsDescribed) {
    const auto descriptions = describe_transport_models();
    EXPECT_EQ(descriptions.size(), std::variant_size_v<TransportModel>);
    for (const auto& [form, help] : descriptions) {
        const std::string name = form.substr(0, form.find_first_of("[:"));
        EXPECT_NO_THROW(static_cast<void>(parse_transport_model(name))) << name;
        EXPECT_FALSE(help.empty());
    }
}

TEST(ChannelSpace, IsThatOfTheRgbSpace) {
    EXPECT_EQ(channel_space_from_xyz("Rec2020"), rgb_from_xyz(rgb_space("Rec2020")));
    // White, of equal energy, is about (1, 1, 1) in sharp channels: their rows add up to 1.
    for (const auto& row : channel_space_from_xyz("sharp").m) EXPECT_NEAR(row[0] + row[1] + row[2], 1.0, 1e-3);
}

}  // namespace
}  // namespace emulsion
