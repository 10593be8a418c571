#include "core/parallel.h"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

namespace emulsion {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::ThrowsMessage;

class ParallelForThreads : public testing::TestWithParam<int> {};

TEST_P(ParallelForThreads, CallsTheBodyOnceForEveryIndex) {
    constexpr int kBegin = -17, kEnd = 10000;
    std::vector<std::atomic<int>> calls(kEnd - kBegin);
    parallel_for(kBegin, kEnd, GetParam(), [&](int i) { ++calls.at(static_cast<std::size_t>(i - kBegin)); });
    std::vector<int> counts(calls.begin(), calls.end());
    EXPECT_THAT(counts, Each(1));
}

TEST_P(ParallelForThreads, DoesNothingForAnEmptyOrReversedRange) {
    int calls = 0;
    parallel_for(5, 5, GetParam(), [&](int) { ++calls; });
    parallel_for(5, -5, GetParam(), [&](int) { ++calls; });
    parallel_for(std::numeric_limits<int>::max(), std::numeric_limits<int>::min(), GetParam(), [&](int) { ++calls; });
    EXPECT_EQ(calls, 0);
}

TEST_P(ParallelForThreads, CountsToTheEndsOfTheIntegers) {
    constexpr int kHighest = std::numeric_limits<int>::max(), kLowest = std::numeric_limits<int>::min();
    std::atomic<int> calls{0};
    parallel_for(kHighest - 3, kHighest, GetParam(), [&](int) { ++calls; });
    parallel_for(kLowest, kLowest + 3, GetParam(), [&](int) { ++calls; });
    EXPECT_EQ(calls, 6);
}

TEST_P(ParallelForThreads, RethrowsAndRunsNothingAfterwards) {
    std::atomic<int> running{0}, calls{0};
    const auto body = [&](int i) {
        ++running;
        ++calls;
        if (i == 500) {
            --running;
            throw std::runtime_error("body 500");
        }
        std::this_thread::yield();
        --running;
    };
    EXPECT_THAT([&] { parallel_for(0, 1000000, GetParam(), body); }, ThrowsMessage<std::runtime_error>("body 500"));
    EXPECT_EQ(running, 0);
    const int calls_at_return = calls;
    EXPECT_LT(calls_at_return, 1000000) << "the exception should have stopped the loop";
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(calls, calls_at_return) << "a body ran after parallel_for had returned";
}

TEST_P(ParallelForThreads, RunsAgainAfterAnException) {
    EXPECT_THROW(parallel_for(0, 100, GetParam(), [](int) { throw std::runtime_error("each"); }), std::runtime_error);
    std::atomic<int> calls{0};
    parallel_for(0, 100, GetParam(), [&](int) { ++calls; });
    EXPECT_EQ(calls, 100);
}

TEST_P(ParallelForThreads, MayBeNested) {
    std::atomic<int> calls{0};
    parallel_for(0, 20, GetParam(), [&](int) { parallel_for(0, 20, GetParam(), [&](int) { ++calls; }); });
    EXPECT_EQ(calls, 400);
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelForThreads, testing::Values(0, 1, 2, 8, std::numeric_limits<int>::max()));

TEST(ParallelFor, OneThreadIsTheCallingThreadInOrder) {
    std::vector<int> order;
    bool elsewhere = false;
    const std::thread::id caller = std::this_thread::get_id();
    parallel_for(3, 8, 1, [&](int i) {
        order.push_back(i);
        elsewhere |= std::this_thread::get_id() != caller;
    });
    EXPECT_THAT(order, testing::ElementsAre(3, 4, 5, 6, 7));
    EXPECT_FALSE(elsewhere);
}

TEST(ParallelFor, RefusesNegativeThreads) {
    EXPECT_THAT([] { parallel_for(0, 1, -1, [](int) {}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("threads -1")));
}

TEST(ParallelFor, UsesAsManyThreadsAsItIsAllowed) {
    const oneapi::tbb::global_control allow_two(oneapi::tbb::global_control::max_allowed_parallelism, 2);
    // Two bodies that wait for each other: they can only both end if they run at once.
    std::atomic<int> arrived{0};
    std::atomic<bool> met{true};
    parallel_for(0, 2, 2, [&](int) {
        ++arrived;
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (arrived < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
        if (arrived < 2) met = false;
    });
    EXPECT_TRUE(met);
}

TEST(HardwareThreads, IsAtLeastOne) { EXPECT_GE(hardware_threads(), 1); }

}  // namespace
}  // namespace emulsion
