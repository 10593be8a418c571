#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace emulsion::cli {

/// Calls write() every so many seconds, counted from the end of the call before, on a thread of its own, until
/// destroyed; a call that runs then is waited for. One that throws is warned of, and the next one tries again: what
/// there is to write grows, and the last file that was written is still good.
class Checkpoints {
  public:
    /// No interval: no calls.
    Checkpoints(std::optional<double> interval_s, std::function<void()> write);
    ~Checkpoints();
    Checkpoints(const Checkpoints&) = delete;
    Checkpoints& operator=(const Checkpoints&) = delete;

  private:
    void run(double interval_s);

    std::function<void()> write_;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool ended_ = false;
    std::thread thread_;
};

}  // namespace emulsion::cli
