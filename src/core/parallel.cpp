#include "core/parallel.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#endif

namespace emulsion {

namespace {

#ifdef __SANITIZE_THREAD__

/// The loop on plain threads. TBB is not built with the thread sanitizer, which would take every body for unordered
/// with what comes before and after the loop.
void run_loop(std::int64_t begin, std::int64_t end, int threads, const std::function<void(int)>& body) {
    std::atomic<std::int64_t> next{begin};
    std::exception_ptr first_exception;
    std::mutex mutex;
    const auto work = [&] {
        for (std::int64_t i = next++; i < end; i = next++) {
            try {
                body(static_cast<int>(i));
            } catch (...) {
                const std::scoped_lock lock(mutex);
                if (!first_exception) first_exception = std::current_exception();
                next = end;
            }
        }
    };
    {
        std::vector<std::jthread> workers;
        for (int i = 1; i < threads; ++i) workers.emplace_back(work);
        work();
    }
    if (first_exception) std::rethrow_exception(first_exception);
}

#else

void run_loop(std::int64_t begin, std::int64_t end, int threads, const std::function<void(int)>& body) {
    const auto loop = [&] {
        oneapi::tbb::parallel_for(
            begin, end, [&](std::int64_t i) { body(static_cast<int>(i)); }, oneapi::tbb::simple_partitioner{});
    };
    // In the arena that threads are waiting in already, if it has as many.
    if (threads == oneapi::tbb::this_task_arena::max_concurrency()) return loop();
    oneapi::tbb::task_arena(threads).execute(loop);
}

#endif

}  // namespace

void parallel_for(int begin, int end, int threads, const std::function<void(int)>& body) {
    if (threads < 0) throw std::invalid_argument("threads " + std::to_string(threads) + ": must be at least 0");
    if (threads == 1) {
        for (int i = begin; i < end; ++i) body(i);
        return;
    }
    // TBB would print a warning if it were asked for more threads than it can give.
    using Control = oneapi::tbb::global_control;
    const std::size_t available = Control::active_value(Control::max_allowed_parallelism);
    const bool all = threads == 0 || static_cast<std::size_t>(threads) > available;
    // 64-bit indices, because end - begin need not fit into an int.
    run_loop(begin, end, all ? static_cast<int>(available) : threads, body);
}

int hardware_threads() noexcept { return oneapi::tbb::info::default_concurrency(); }

}  // namespace emulsion
