#pragma once
// Structs of options that grow at their end: a program hands over as many bytes as its header knew of, in `size`.

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace emulsion::capi {

/// \throws std::invalid_argument unless a struct of that size can be one of ours, or of an older version.
template <class Options>
void require_size(std::size_t size, const char* name) {
    if (size >= sizeof(std::size_t) && size <= sizeof(Options)) return;
    throw std::invalid_argument(std::string(name) + ": size is " + std::to_string(size) + ", expected at most " +
                                std::to_string(sizeof(Options)) + ", as the _init function sets it");
}

/// The first `size` bytes of the defaults go to the caller.
template <class Options>
void initialise(Options& to, std::size_t size, Options defaults, const char* name) {
    static_assert(std::is_trivially_copyable_v<Options>);
    require_size<Options>(size, name);
    defaults.size = size;
    std::memcpy(&to, &defaults, size);
}

/// The caller's options; what its version does not have is as in the defaults.
template <class Options>
Options complete(const Options& from, Options defaults, const char* name) {
    require_size<Options>(from.size, name);
    std::memcpy(&defaults, &from, from.size);
    return defaults;
}

}  // namespace emulsion::capi
