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

namespace emulsion {

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
    oneapi::tbb::task_arena arena(all ? static_cast<int>(available) : threads);
    // 64-bit indices, because end - begin need not fit into an int.
    arena.execute([&] {
        oneapi::tbb::parallel_for(
            std::int64_t{begin}, std::int64_t{end}, [&](std::int64_t i) { body(static_cast<int>(i)); },
            oneapi::tbb::simple_partitioner{});
    });
}

int hardware_threads() noexcept { return oneapi::tbb::info::default_concurrency(); }

}  // namespace emulsion
