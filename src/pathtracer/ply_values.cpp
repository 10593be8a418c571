#include "pathtracer/ply_values.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"
#include "pathtracer/scene_source.h"

namespace emulsion {

namespace {

static_assert(std::endian::native == std::endian::little || std::endian::native == std::endian::big);

template <class T>
double value_of(std::string_view bytes, PlyFormat format) noexcept {
    char ordered[sizeof(T)];
    std::memcpy(ordered, bytes.data(), sizeof(T));
    const bool is_native = (format == PlyFormat::little_endian) == (std::endian::native == std::endian::little);
    if (!is_native) std::reverse(ordered, ordered + sizeof(T));
    T value;
    std::memcpy(&value, ordered, sizeof(T));
    return static_cast<double>(value);
}

/// Bytes that one of the element takes at least: in text a digit and what parts it from the next.
std::uint64_t least_bytes(const PlyElement& element, PlyFormat format) noexcept {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
        bytes += format == PlyFormat::ascii ? 2 : size_of(property.count_type.value_or(property.type));
    }
    return bytes;
}

constexpr std::string_view kSpace = " \t\r\n\v\f";

}  // namespace

double PlyValues::next(PlyType type) {
    if (format_ == PlyFormat::ascii) return next_of_text();
    const std::string_view bytes = take(size_of(type));
    switch (type) {
        case PlyType::int8:
            return value_of<std::int8_t>(bytes, format_);
        case PlyType::uint8:
            return value_of<std::uint8_t>(bytes, format_);
        case PlyType::int16:
            return value_of<std::int16_t>(bytes, format_);
        case PlyType::uint16:
            return value_of<std::uint16_t>(bytes, format_);
        case PlyType::int32:
            return value_of<std::int32_t>(bytes, format_);
        case PlyType::uint32:
            return value_of<std::uint32_t>(bytes, format_);
        case PlyType::float32:
            return value_of<float>(bytes, format_);
        default:
            return value_of<double>(bytes, format_);
    }
}

double PlyValues::next_of_text() {
    offset_ = std::min(bytes_.find_first_not_of(kSpace, offset_), bytes_.size());
    last_ = offset_;
    if (offset_ == bytes_.size()) fail("the end of the file", "another number");
    const std::string_view word = bytes_.substr(offset_, bytes_.find_first_of(kSpace, offset_) - offset_);
    offset_ += word.size();
    const char* const begin = word.data() + (word.front() == '+' ? 1 : 0);
    double value = 0.0;
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    if (end != word.data() + word.size() || error == std::errc::invalid_argument) fail(quote(word), "a number");
    // Of one that no double holds, it is not told whether it is too large or too small: the latter does no harm.
    if (error == std::errc::result_out_of_range) {
        return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos
                   ? 0.0
                   : std::numeric_limits<double>::infinity();
    }
    return value;
}

std::string_view PlyValues::take(std::size_t count) {
    last_ = offset_;
    if (room() < count) fail(fmt::format("the end of the file after {} bytes", room()), fmt::format("{} more", count));
    offset_ += count;
    return bytes_.substr(last_, count);
}

std::uint64_t PlyValues::next_count(PlyType type) {
    const double count = next(type);
    if (!(count >= 0.0 && count <= 4294967295.0 && count == std::trunc(count))) {
        fail(fmt::format("a list of {} values", count), "a whole number from 0 to 4294967295");
    }
    return static_cast<std::uint64_t>(count);
}

void PlyValues::skip(PlyType type, std::uint64_t values) {
    if (format_ != PlyFormat::ascii) {
        static_cast<void>(take(static_cast<std::size_t>(values * size_of(type))));
        return;
    }
    for (std::uint64_t i = 0; i < values; ++i) static_cast<void>(next_of_text());
}

void PlyValues::skip(const PlyProperty& property) {
    skip(property.type, property.count_type ? next_count(*property.count_type) : 1);
}

void PlyValues::skip(const PlyElement& element) {
    if (element.properties.empty()) return;  // any number of them takes no room
    check_room_for(element);
    for (std::uint64_t i = 0; i < element.count; ++i) {
        for (const PlyProperty& property : element.properties) skip(property);
    }
}

void PlyValues::check_room_for(const PlyElement& element) const {
    // The last number of a text needs nothing behind it.
    const std::uint64_t least = std::max<std::uint64_t>(1, least_bytes(element, format_));
    const std::uint64_t room_for = (room() + (format_ == PlyFormat::ascii ? 1 : 0)) / least;
    if (element.count <= room_for) return;
    throw IoError(path_, fmt::format("found {} bytes of {} announced \"{}\" elements, expected at least {} bytes each",
                                     room(), element.count, element.name, least));
}

void PlyValues::fail(const std::string& found, const std::string& expected) const {
    if (format_ != PlyFormat::ascii) {
        throw IoError(path_, fmt::format("byte {}: found {}, expected {}", last_, found, expected));
    }
    const auto lines = std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(last_), '\n');
    throw IoError(path_, fmt::format("line {}: found {}, expected {}", lines + 1, found, expected));
}

}  // namespace emulsion
