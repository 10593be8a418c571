#include "analysis/model_choice.h"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace emulsion {
namespace {

using ::testing::HasSubstr;

TEST(ModelChoice, IsAModelOrTheWishForOne) {
    EXPECT_EQ(parse_model_choice("basis:4"), ModelChoice{TransportModel{BasisModel{4}}});
    EXPECT_EQ(parse_model_choice("auto"), ModelChoice{AutoModel{}});
    EXPECT_EQ(parse_model_choice("AUTO:0.5"), (ModelChoice{AutoModel{{0.5, 1.5}}}));
    EXPECT_EQ(parse_model_choice("auto:0.5,4"), (ModelChoice{AutoModel{{0.5, 4.0}}}));
}

TEST(ModelChoice, RefusesWhatIsNone) {
    const auto message = [](const char* text) -> std::string {
        try {
            static_cast<void>(parse_model_choice(text));
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "taken";
    };
    EXPECT_THAT(message("atuo"), HasSubstr("found \"atuo\", expected spectral:N[:STRATEGY], rgb[:SPACE], "
                                           "rgb-prefiltered, basis:K or auto[:MEAN[,P99]]"));
    EXPECT_THAT(message("auto:"), HasSubstr("mean"));
    EXPECT_THAT(message("auto:1,"), HasSubstr("p99"));
    EXPECT_THAT(message("auto:-1"), HasSubstr("mean = -1"));
    EXPECT_THAT(message("rgb:"), HasSubstr("expected rgb[:SPACE]"));
}

}  // namespace
}  // namespace emulsion
