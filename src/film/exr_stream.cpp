#include "film/exr_stream.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "core/error.h"

namespace emulsion {

namespace {
constexpr std::size_t kBufferBytes = std::size_t{1} << 18u;
constexpr std::size_t kWorthNoCopy = std::size_t{1} << 15u;
}  // namespace

CheckedOStream::CheckedOStream(const std::filesystem::path& file, std::filesystem::path named)
    : Imf::OStream(named.c_str()), named_(std::move(named)), descriptor_(::open(file.c_str(), O_WRONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) fail(errno);
    buffer_.reserve(kBufferBytes);
}

CheckedOStream::~CheckedOStream() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void CheckedOStream::write(const char* bytes, int count) {
    const auto size = static_cast<std::size_t>(count);
    if (size >= kWorthNoCopy || buffer_.size() + size > kBufferBytes) flush();
    if (size >= kWorthNoCopy) {
        write_all(bytes, size);
    } else {
        buffer_.insert(buffer_.end(), bytes, bytes + size);
    }
    position_ += size;
}

void CheckedOStream::seekp(std::uint64_t position) {
    flush();
    if (::lseek(descriptor_, static_cast<::off_t>(position), SEEK_SET) < 0) fail(errno);
    position_ = position;
}

void CheckedOStream::finish() {
    flush();
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
}

void CheckedOStream::fail(int error) {
    if (error_ == 0) error_ = error;
    throw IoError(named_, "cannot write: " + errno_text(error_));
}

void CheckedOStream::flush() {
    write_all(buffer_.data(), buffer_.size());
    buffer_.clear();
}

void CheckedOStream::write_all(const char* bytes, std::size_t count) {
    if (error_ != 0) fail(error_);
    while (count > 0) {
        const ::ssize_t written = ::write(descriptor_, bytes, count);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail(written < 0 ? errno : ENOSPC);
        bytes += written;
        count -= static_cast<std::size_t>(written);
    }
}

}  // namespace emulsion
