#include "film/sample_ranges.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace emulsion {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

SampleRanges ranges_of(const std::vector<SampleRange>& all) {
    SampleRanges ranges;
    for (const SampleRange& range : all) ranges.add(range);
    return ranges;
}

TEST(SampleRanges, AreSortedAndJoinWhereTheyTouch) {
    SampleRanges ranges = ranges_of({{32, 48}, {0, 16}});
    EXPECT_THAT(ranges.ranges(), ElementsAre(SampleRange{0, 16}, SampleRange{32, 48}));
    EXPECT_EQ(ranges.count(), 32u);
    ranges.add(SampleRange{16, 20});
    EXPECT_THAT(ranges.ranges(), ElementsAre(SampleRange{0, 20}, SampleRange{32, 48}));
    ranges.add(SampleRange{31, 32});
    EXPECT_THAT(ranges.ranges(), ElementsAre(SampleRange{0, 20}, SampleRange{31, 48}));
    ranges.add(SampleRange{20, 31});
    EXPECT_THAT(ranges.ranges(), ElementsAre(SampleRange{0, 48}));
    EXPECT_TRUE(SampleRanges{}.empty());
    EXPECT_FALSE(ranges.empty());
}

TEST(SampleRanges, AreTheSameInEveryOrder) {
    std::vector<SampleRange> parts;
    for (std::uint64_t i = 0; i < 20; ++i) parts.push_back({i * i, (i + 1) * (i + 1) - i % 3});
    const SampleRanges expected = ranges_of(parts);
    EXPECT_EQ(expected.ranges().size(), 13u) << "a third of them touch the next";
    std::mt19937 shuffler(1);
    for (int i = 0; i < 200; ++i) {
        std::shuffle(parts.begin(), parts.end(), shuffler);
        ASSERT_EQ(ranges_of(parts), expected);
    }
}

TEST(SampleRanges, OverlapsAndEmptyOnesAreRefused) {
    SampleRanges ranges = ranges_of({{10, 20}, {30, 40}});
    const SampleRanges before = ranges;
    for (const SampleRange& range : {SampleRange{0, 11}, {19, 25}, {12, 13}, {10, 20}, {5, 50}}) {
        EXPECT_THAT([&] { ranges.add(range); }, ThrowsMessage<std::invalid_argument>(
                                                    AllOf(HasSubstr("10-20"), HasSubstr(to_text(ranges_of({range}))))));
    }
    for (const SampleRange& range : {SampleRange{5, 5}, {9, 2}}) {
        EXPECT_THROW(ranges.add(range), std::invalid_argument);
    }
    EXPECT_THROW(ranges.add(ranges_of({{0, 3}, {50, 60}, {39, 45}})), std::invalid_argument);
    EXPECT_EQ(ranges, before) << "nothing was added";
    ranges.add(ranges_of({{20, 30}, {50, 60}}));
    EXPECT_EQ(to_text(ranges), "10-40,50-60");
}

TEST(SampleRanges, TellWhatIsMissing) {
    const SampleRanges ranges = ranges_of({{10, 20}, {30, 40}});
    EXPECT_THAT(ranges.missing({0, 50}), ElementsAre(SampleRange{0, 10}, SampleRange{20, 30}, SampleRange{40, 50}));
    EXPECT_THAT(ranges.missing({12, 35}), ElementsAre(SampleRange{20, 30}));
    EXPECT_THAT(ranges.missing({15, 25}), ElementsAre(SampleRange{20, 25}));
    EXPECT_THAT(ranges.missing({10, 20}), IsEmpty());
    EXPECT_THAT(ranges.missing({20, 20}), IsEmpty());
    EXPECT_THAT(SampleRanges{}.missing({3, 4}), ElementsAre(SampleRange{3, 4}));
}

TEST(SampleRanges, TextComesBack) {
    constexpr std::uint64_t kLast = ~std::uint64_t{0};
    for (const SampleRanges& ranges :
         {SampleRanges{}, ranges_of({{0, 1}}), ranges_of({{0, 16}, {32, 48}, {50, kLast}})}) {
        EXPECT_EQ(parse_sample_ranges(to_text(ranges)), ranges);
    }
    EXPECT_EQ(to_text(ranges_of({{0, 16}, {32, 48}})), "0-16,32-48");
    for (const char* text : {"0", "0-", "-3", "0-16,", ",0-16", "0-16;", "0-16 ", " 0-16", "16-0", "3-3", "0-16,8-20",
                             "+0-16", "0--16", "a-b", "0-18446744073709551616", "0-1x"}) {
        EXPECT_THROW(static_cast<void>(parse_sample_ranges(text)), std::invalid_argument) << text;
    }
}

}  // namespace
}  // namespace emulsion
