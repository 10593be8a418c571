#include "chart/measure.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <stdexcept>

namespace emulsion {

namespace {

double thread_clock_s() {
    ::timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A work and how often it is called for one timing.
class TimedWork {
  public:
    TimedWork(const Work& work, double least_s) : work_(&work) {
        work();  // fills caches and tables
        for (double s = seconds(); s * calls_ < least_s && calls_ < kMostCalls; s = seconds()) {
            const double wanted = s > 0.0 ? 1.2 * least_s / s : 8.0 * calls_;
            calls_ = static_cast<int>(std::min({wanted + 1.0, 16.0 * calls_, double{kMostCalls}}));
        }
    }

    /// Of one call.
    [[nodiscard]] double seconds() const {
        const double start_s = thread_clock_s();
        for (int i = 0; i < calls_; ++i) (*work_)();
        return (thread_clock_s() - start_s) / calls_;
    }

  private:
    static constexpr int kMostCalls = 1 << 24;
    const Work* work_;
    int calls_ = 1;
};

}  // namespace

std::vector<RelativeTime> times_relative_to(const Work& baseline, std::span<const Work> works,
                                            const TimingOptions& options) {
    const TimedWork timed_baseline(baseline, options.least_s);
    std::vector<TimedWork> timed;
    for (const Work& work : works) timed.emplace_back(work, options.least_s);
    std::vector<std::vector<double>> seconds(works.size()), ratios(works.size());
    for (int round = 0; round < options.rounds; ++round) {
        for (std::size_t i = 0; i < works.size(); ++i) {
            // Beside each, so that a change in the machine's speed meets both.
            const double baseline_s = timed_baseline.seconds();
            seconds[i].push_back(timed[i].seconds());
            ratios[i].push_back(seconds[i].back() / baseline_s);
        }
    }
    std::vector<RelativeTime> times;
    for (std::size_t i = 0; i < works.size(); ++i) {
        times.push_back({spread_of(ratios[i]), spread_of(seconds[i]).median});
    }
    return times;
}

TimingOptions timing_options(const ChartOptions& options) {
    if (options.effort == ChartEffort::quick) return {.rounds = 3, .least_s = 2e-4};
    return {.rounds = 9, .least_s = 5e-3};
}

void set_times(ChartPanel& panel, std::span<const RelativeTime> times, const TimeDetail& detail) {
    if (panel.points.size() != times.size()) throw std::invalid_argument("chart: expected as many times as points");
    for (std::size_t i = 0; i < times.size(); ++i) {
        ChartPoint& point = panel.points[i];
        point.x = times[i].ratio;
        const double number =
            detail.kind == TimeDetail::Kind::time ? times[i].seconds * detail.factor : detail.factor / times[i].seconds;
        point.details.emplace_back(detail.name, number);
    }
    mark_front(panel);
}

double thread_seconds(const Work& work) {
    const double start_s = thread_clock_s();
    work();
    return thread_clock_s() - start_s;
}

double wall_seconds(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace emulsion
