#include "cli/progress_display.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/messages.h"

namespace emulsion::cli {

namespace {

constexpr int kMostBarWidth = 30, kLeastBarWidth = 5;
constexpr std::chrono::milliseconds kBarInterval{100}, kLineInterval{5000};

std::string minutes_text(double seconds) {
    const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
    if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

/// The width of the terminal on standard error; 80 if it does not say.
int terminal_columns() {
    winsize size{};
    if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

}  // namespace

ProgressStyle progress_style_for_stderr() {
    return ::isatty(STDERR_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::lines;
}

std::string progress_text(std::int64_t done, std::int64_t total, double elapsed_s, int columns) {
    const double share = total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 1.0;
    const double rate = elapsed_s > 0.0 ? static_cast<double>(done) / elapsed_s : 0.0;
    std::string text = fmt::format("{:3.0f}%  {:.1f} of {:.1f} Msamples  {:.2f} Msamples/s", std::floor(100.0 * share),
                                   static_cast<double>(done) * 1e-6, static_cast<double>(total) * 1e-6, rate * 1e-6);
    if (rate > 0.0 && done < total) text += "  " + minutes_text(static_cast<double>(total - done) / rate) + " left";
    if (columns == 0) return text;

    // The last column stays free: some terminals go on to the next line as soon as it is written.
    const int room = columns - 1 - static_cast<int>(text.size()) - 3;
    const int width = std::min(room, kMostBarWidth);
    if (width < kLeastBarWidth) return text.substr(0, static_cast<std::size_t>(std::max(columns - 1, 0)));
    const int filled = static_cast<int>(share * width);
    return "[" + std::string(static_cast<std::size_t>(filled), '#') +
           std::string(static_cast<std::size_t>(width - filled), '.') + "] " + text;
}

ProgressDisplay::ProgressDisplay(ProgressStyle style, const RenderProgress& progress, std::int64_t total_samples) {
    if (style == ProgressStyle::none) return;
    thread_ = std::thread([this, style, &progress, total_samples] { run(style, progress, total_samples); });
}

ProgressDisplay::~ProgressDisplay() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void ProgressDisplay::run(ProgressStyle style, const RenderProgress& progress, std::int64_t total_samples) {
    const auto start = std::chrono::steady_clock::now();
    const auto interval = style == ProgressStyle::bar ? kBarInterval : kLineInterval;
    std::unique_lock lock(mutex_);
    bool ended = false;
    while (!ended) {
        ended = wake_.wait_for(lock, interval, [this] { return ended_; });
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        const std::int64_t done = progress.samples_done.load(), total = total_samples - progress.samples_saved.load();
        if (style == ProgressStyle::bar) {
            // "\033[K" clears what a longer line before has left.
            print_progress(fmt::format("\r{}\033[K{}", progress_text(done, total, elapsed.count(), terminal_columns()),
                                       ended ? "\n" : ""));
        } else {
            print_progress(progress_text(done, total, elapsed.count(), 0) + "\n");
        }
    }
}

}  // namespace emulsion::cli
