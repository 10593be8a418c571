#include "display/label.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

constexpr CodeRGB kInk{255, 255, 255};

/// The label as rows of '#' and '.', drawn at (x, y).
std::string drawn(std::string_view text, int width, int height, int x = 0, int y = 0, int scale = 1) {
    Image<CodeRGB> image(width, height);
    draw_label(image.view(), x, y, text, kInk, scale);
    std::string rows;
    for (int v = 0; v < height; ++v) {
        for (const CodeRGB& pixel : image.row(v)) rows += pixel == kInk ? '#' : '.';
        rows += '\n';
    }
    return rows;
}

TEST(Label, DrawsLettersSideBySide) {
    EXPECT_EQ(drawn("l-", 11, kLabelHeight_px),
              ".##........\n"
              "..#........\n"
              "..#........\n"
              "..#....###.\n"
              "..#........\n"
              "..#........\n"
              ".###.......\n"
              "...........\n"
              "...........\n");
}

TEST(Label, LettersThatItDoesNotKnowAreBoxes) {
    EXPECT_EQ(drawn("@", 5, kLabelHeight_px), drawn("A", 5, kLabelHeight_px));
    EXPECT_NE(drawn("@", 5, kLabelHeight_px), drawn(" ", 5, kLabelHeight_px));
}

TEST(Label, ScalesByWholePixels) {
    const std::string twice = drawn("i", 10, 2 * kLabelHeight_px, 0, 0, 2);
    EXPECT_EQ(
        std::count(twice.begin(), twice.end(), '#'), 4 * [] {
            const std::string once = drawn("i", 5, kLabelHeight_px);
            return std::count(once.begin(), once.end(), '#');
        }());
}

TEST(Label, LeavesOutWhatIsOutside) {
    const std::string nothing = drawn("", 8, 8);
    EXPECT_EQ(drawn("abc", 8, 8, 8, 0), nothing);
    EXPECT_EQ(drawn("abc", 8, 8, -100, -3, 2), nothing);
    EXPECT_NE(drawn("abc", 8, 8, -3, -2), nothing);
}

}  // namespace
}  // namespace emulsion
