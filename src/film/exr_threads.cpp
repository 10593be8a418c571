#include "film/exr_threads.h"

#include <mutex>

#include <OpenEXR/ImfThreading.h>

#include "core/parallel.h"
#include "core/parameters.h"

namespace emulsion {

int use_exr_threads(int threads) {
    check_range(threads, {0.0, kInfinity}, "EXR file: threads");
    if (threads == 0) threads = hardware_threads();
    if (threads == 1) return 0;
    static std::mutex mutex;  // between the look at the pool and its change
    const std::lock_guard lock(mutex);
    if (Imf::globalThreadCount() < threads) Imf::setGlobalThreadCount(threads);
    return threads;
}

}  // namespace emulsion
