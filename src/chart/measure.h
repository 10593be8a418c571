#pragma once
// Times as ratios to a baseline that is measured in turn with them. Processor time of the calling thread: what else the
// machine does changes that least, and so what is measured must run on this thread alone.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "chart/chart.h"
#include "chart/charts.h"

namespace emulsion {

using Work = std::function<void()>;

/// Keeps the compiler from leaving out what makes `value`.
template <class T>
inline void keep(const T& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

struct TimingOptions {
    int rounds = 9;         ///< >= 1; in each, every work is timed, and the baseline before it
    double least_s = 5e-3;  ///< of one timing: a work is repeated until it takes as long, found once beforehand
};

struct RelativeTime {
    Spread ratio;          ///< over the rounds: time over the baseline's in the same round
    double seconds = 0.0;  ///< of one call, the median
};

/// One for each work, in their order.
[[nodiscard]] std::vector<RelativeTime> times_relative_to(const Work& baseline, std::span<const Work> works,
                                                          const TimingOptions& options);

/// What a chart's effort asks for.
[[nodiscard]] TimingOptions timing_options(const ChartOptions& options);

/// How a time is told among a point's details: as a time, seconds times `factor`, or as a rate, `factor` over seconds.
struct TimeDetail {
    enum class Kind { time, rate };
    std::string name;  ///< "ns", "Mpix/s"
    double factor = 1.0;
    Kind kind = Kind::time;
};

/// Gives each point of a panel its time, in their order, and marks the front.
/// \throws std::invalid_argument unless there are as many.
void set_times(ChartPanel& panel, std::span<const RelativeTime> times, const TimeDetail& detail);

/// Processor time that one call takes in this thread.
[[nodiscard]] double thread_seconds(const Work& work);
/// By the clock on the wall.
[[nodiscard]] double wall_seconds(const Work& work);

}  // namespace emulsion
