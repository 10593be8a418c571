#pragma once

#include <array>
#include <atomic>
#include <csignal>

namespace emulsion::cli {

/// While it lives, Ctrl-C and a request to terminate set a flag instead of ending the process. A second one ends it.
/// A signal that the process was started to ignore stays ignored, as in a shell script's background jobs. Afterwards
/// all is as it was before.
class StopSignals {
  public:
    /// One at a time. The flag must outlive this.
    explicit StopSignals(std::atomic<bool>& stop);
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

  private:
    static constexpr std::array kSignals = {SIGINT, SIGTERM};
    std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace emulsion::cli
