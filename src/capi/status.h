#pragma once
// From exceptions to codes: no exception leaves the C interface.

#include <stdexcept>
#include <string>

#include "capi/emulsion.h"

namespace emulsion::capi {

/// The code of the exception that is being handled; keeps its message for emulsion_last_error().
emulsion_status report_current_exception() noexcept;

/// Runs the body of a function of the C interface.
template <class Body>
emulsion_status guarded(const Body& body) noexcept {
    try {
        body();
        return EMULSION_OK;
    } catch (...) {
        return report_current_exception();
    }
}

/// What the pointer points to. \throws std::invalid_argument naming the argument if it is NULL.
template <class T>
T& dereference(T* pointer, const char* name) {
    if (pointer == nullptr) throw std::invalid_argument(std::string(name) + " is NULL");
    return *pointer;
}

}  // namespace emulsion::capi
