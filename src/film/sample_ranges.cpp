#include "film/sample_ranges.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace emulsion {

namespace {

std::string to_text(const SampleRange& range) { return std::to_string(range.begin) + "-" + std::to_string(range.end); }

void require_samples(const SampleRange& range) {
    if (range.begin < range.end) return;
    throw std::invalid_argument("sample ranges: begin is " + std::to_string(range.begin) + " and end is " +
                                std::to_string(range.end) + ", expected begin < end");
}

void require_apart(const SampleRange& range, std::span<const SampleRange> others) {
    for (const SampleRange& other : others) {
        if (range.end <= other.begin || other.end <= range.begin) continue;
        throw std::invalid_argument("sample ranges: " + to_text(range) + " overlaps " + to_text(other) +
                                    ", expected samples that are not there yet");
    }
}

[[noreturn]] void refuse(std::string_view text) {
    throw std::invalid_argument("sample ranges: found \"" + std::string(text) +
                                "\", expected ranges such as 0-16,32-48");
}

/// Takes the whole number that the rest of the text begins with away from it.
std::uint64_t take_number(std::string_view& rest, std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc{}) refuse(text);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return number;
}

/// Whether the text begins with the character, which is then taken away from it.
bool take(std::string_view& rest, char expected) {
    if (rest.empty() || rest.front() != expected) return false;
    rest.remove_prefix(1);
    return true;
}

}  // namespace

void SampleRanges::add(SampleRange range) {
    require_samples(range);
    require_apart(range, ranges_);
    auto next = std::find_if(ranges_.begin(), ranges_.end(), [&](const auto& r) { return r.begin >= range.end; });
    const bool touches_next = next != ranges_.end() && next->begin == range.end;
    const bool touches_previous = next != ranges_.begin() && (next - 1)->end == range.begin;
    if (touches_previous && touches_next) {
        (next - 1)->end = next->end;
        ranges_.erase(next);
    } else if (touches_previous) {
        (next - 1)->end = range.end;
    } else if (touches_next) {
        next->begin = range.begin;
    } else {
        ranges_.insert(next, range);
    }
}

void SampleRanges::add(const SampleRanges& others) {
    SampleRanges both = *this;
    for (const SampleRange& range : others.ranges_) both.add(range);
    *this = std::move(both);
}

std::uint64_t SampleRanges::count() const noexcept {
    std::uint64_t samples = 0;
    for (const SampleRange& range : ranges_) samples += range.size();
    return samples;
}

std::vector<SampleRange> SampleRanges::missing(SampleRange range) const {
    std::vector<SampleRange> gaps;
    std::uint64_t at = range.begin;
    for (const SampleRange& there : ranges_) {
        if (there.end <= at) continue;
        if (there.begin >= range.end) break;
        if (there.begin > at) gaps.push_back({at, there.begin});
        at = there.end;
    }
    if (at < range.end) gaps.push_back({at, range.end});
    return gaps;
}

std::string to_text(const SampleRanges& ranges) {
    std::string text;
    for (const SampleRange& range : ranges.ranges()) text += (text.empty() ? "" : ",") + to_text(range);
    return text;
}

SampleRanges parse_sample_ranges(std::string_view text) {
    SampleRanges ranges;
    if (text.empty()) return ranges;
    std::string_view rest = text;
    do {
        SampleRange range;
        range.begin = take_number(rest, text);
        if (!take(rest, '-')) refuse(text);
        range.end = take_number(rest, text);
        ranges.add(range);
    } while (take(rest, ','));
    if (!rest.empty()) refuse(text);
    return ranges;
}

}  // namespace emulsion
