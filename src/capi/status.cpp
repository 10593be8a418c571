#include "capi/status.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>

#include "core/error.h"

namespace emulsion::capi {

namespace {

// Of a fixed size, so that running out of memory can be told, too. The interface asks for one a thread.
thread_local std::array<char, 2048> last_error{};  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

emulsion_status report(emulsion_status status, std::string_view message) noexcept {
    const std::size_t length = std::min(message.size(), last_error.size() - 1);
    std::memcpy(last_error.data(), message.data(), length);
    last_error[length] = '\0';
    return status;
}

}  // namespace

emulsion_status report_current_exception() noexcept {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return report(EMULSION_OUT_OF_MEMORY, "out of memory");
    } catch (const std::length_error&) {  // of a vector that could never be allocated
        return report(EMULSION_OUT_OF_MEMORY, "out of memory");
    } catch (const std::logic_error& error) {  // std::invalid_argument, and calls that come too early
        return report(EMULSION_INVALID_ARGUMENT, error.what());
    } catch (const IoError& error) {
        return report(EMULSION_IO_ERROR, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return report(EMULSION_IO_ERROR, error.what());
    } catch (const std::exception& error) {
        return report(EMULSION_INTERNAL_ERROR, error.what());
    } catch (...) {
        return report(EMULSION_INTERNAL_ERROR, "an exception of an unknown type");
    }
}

}  // namespace emulsion::capi

const char* emulsion_last_error() { return emulsion::capi::last_error.data(); }

const char* emulsion_version() { return EMULSION_VERSION; }
