#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "pathtracer/render.h"

namespace emulsion::cli {

enum class ProgressStyle { none, bar, lines };

/// A bar if standard error is a terminal, else lines.
[[nodiscard]] ProgressStyle progress_style_for_stderr();

/// "[####....]  37%  6.2 of 16.8 Msamples  1.41 Msamples/s  0:07 left", shorter than `columns`, so that a terminal of
/// that width can show it again in the same place: the bar takes what room there is. With 0 columns there is no bar,
/// and no end to the line.
[[nodiscard]] std::string progress_text(std::int64_t done, std::int64_t total, double elapsed_s, int columns);

/// Shows on standard error how far a render has come: a bar that moves, or a line every few seconds. Of the samples in
/// all, those that the render finds to be needless are taken off. Ends when destroyed.
class ProgressDisplay {
  public:
    ProgressDisplay(ProgressStyle style, const RenderProgress& progress, std::int64_t total_samples);
    ~ProgressDisplay();
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  private:
    void run(ProgressStyle style, const RenderProgress& progress, std::int64_t total_samples);

    std::mutex mutex_;
    std::condition_variable wake_;
    bool ended_ = false;
    std::thread thread_;
};

}  // namespace emulsion::cli
