#pragma once
// Parallel loops over oneTBB.

#include <functional>

namespace emulsion {

/// Calls body(i) once for every i in [begin, end), on up to `threads` threads (0: one per hardware thread), in no
/// particular order; with one thread, in order on the calling thread. An exception thrown by a body is rethrown here,
/// once no body runs any more; indices that had not been begun are then left out. Nothing happens if end <= begin.
/// There are never more threads than TBB allows: those of the hardware, unless a tbb::global_control says otherwise.
/// \throws std::invalid_argument if threads < 0.
void parallel_for(int begin, int end, int threads, const std::function<void(int)>& body);

/// The number of threads that `threads` = 0 stands for.
[[nodiscard]] int hardware_threads() noexcept;

}  // namespace emulsion
