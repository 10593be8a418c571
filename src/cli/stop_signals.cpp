#include "cli/stop_signals.h"

#include <cstddef>

namespace emulsion::cli {

namespace {

// A signal handler has no other way to its data.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<std::atomic<bool>*> stop_flag{nullptr};
static_assert(std::atomic<bool>::is_always_lock_free && decltype(stop_flag)::is_always_lock_free);

extern "C" void set_stop_flag(int) {
    if (std::atomic<bool>* flag = stop_flag.load()) flag->store(true);
}

}  // namespace

StopSignals::StopSignals(std::atomic<bool>& stop) {
    stop_flag = &stop;
    struct sigaction action {};
    action.sa_handler = set_stop_flag;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        ::sigaction(kSignals[i], nullptr, &before_[i]);
        const bool ignored = (before_[i].sa_flags & SA_SIGINFO) == 0 && before_[i].sa_handler == SIG_IGN;
        if (!ignored) ::sigaction(kSignals[i], &action, nullptr);
    }
}

StopSignals::~StopSignals() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before_[i], nullptr);
    stop_flag = nullptr;
}

}  // namespace emulsion::cli
