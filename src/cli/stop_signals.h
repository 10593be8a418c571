#pragma once

#include <atomic>

namespace emulsion::cli {

/// While it lives, Ctrl-C and a request to terminate set a flag instead of ending the process. A second one ends it.
class StopSignals {
  public:
    /// One at a time. The flag must outlive this.
    explicit StopSignals(std::atomic<bool>& stop);
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;
};

}  // namespace emulsion::cli
