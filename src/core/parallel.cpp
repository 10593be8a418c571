#include "core/parallel.h"

#include <stdexcept>
#include <string>

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
    oneapi::tbb::task_arena arena(threads == 0 ? oneapi::tbb::task_arena::automatic : threads);
    arena.execute([&] { oneapi::tbb::parallel_for(begin, end, body, oneapi::tbb::simple_partitioner{}); });
}

int hardware_threads() noexcept { return oneapi::tbb::info::default_concurrency(); }

}  // namespace emulsion
