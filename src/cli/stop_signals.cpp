#include "cli/stop_signals.h"

#include <csignal>

namespace emulsion::cli {

namespace {

// A signal handler has no other way to its data.
std::atomic<std::atomic<bool>*> stop_flag{nullptr};
static_assert(std::atomic<bool>::is_always_lock_free && decltype(stop_flag)::is_always_lock_free);

extern "C" void set_stop_flag(int) {
    if (std::atomic<bool>* flag = stop_flag.load()) flag->store(true);
}

constexpr int kSignals[] = {SIGINT, SIGTERM};

}  // namespace

StopSignals::StopSignals(std::atomic<bool>& stop) {
    stop_flag = &stop;
    struct sigaction action {};
    action.sa_handler = set_stop_flag;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    for (const int signal : kSignals) ::sigaction(signal, &action, nullptr);
}

StopSignals::~StopSignals() {
    for (const int signal : kSignals) std::signal(signal, SIG_DFL);
    stop_flag = nullptr;
}

}  // namespace emulsion::cli
