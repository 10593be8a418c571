#include "cli/checkpoints.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <string>
#include <utility>

#include "cli/messages.h"

namespace emulsion::cli {

Checkpoints::Checkpoints(std::optional<double> interval_s, std::function<void()> write) : write_(std::move(write)) {
    if (interval_s) thread_ = std::thread([this, seconds = *interval_s] { run(seconds); });
}

Checkpoints::~Checkpoints() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Checkpoints::run(double interval_s) {
    // A century is for ever, and what the clock can still add to now.
    constexpr double kLongest_s = 100.0 * 365.0 * 86400.0;
    const std::chrono::duration<double> interval(std::min(interval_s, kLongest_s));
    while (true) {
        {
            std::unique_lock lock(mutex_);
            if (wake_.wait_for(lock, interval, [this] { return ended_; })) return;
        }
        try {
            write_();
        } catch (const std::exception& error) {
            print_warning(std::string("no checkpoint this time: ") + error.what());
        }
    }
}

}  // namespace emulsion::cli
