#pragma once
// OpenEXR's threads. Its pool is one for the whole process, and work that is handed to it waits for whatever else is
// there. This is the one place of the library that changes it.

namespace emulsion {

/// Sees to it that OpenEXR's pool has threads enough for `threads` (0: one per processor) to work at once; never makes
/// it smaller, as another file, or the program that uses this library, may count on it. Thread-safe.
/// \returns the numThreads for OpenEXR's files: 0 for one thread, the caller's, unless the pool has threads already.
/// \throws std::invalid_argument if threads < 0.
int use_exr_threads(int threads);

}  // namespace emulsion
