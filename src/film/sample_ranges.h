#pragma once
// Which samples of every pixel a film has, by their indices. Renders share samples out by index: a run that goes on, a
// shard on another machine and a single long run take the same ones, and films of different ranges add up.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace emulsion {

/// Sample indices [begin, end).
struct SampleRange {
    std::uint64_t begin = 0, end = 0;
    [[nodiscard]] std::uint64_t size() const noexcept { return end - begin; }
    bool operator==(const SampleRange&) const = default;
};

/// Ranges that are sorted, not empty, and neither overlap nor touch.
class SampleRanges {
  public:
    SampleRanges() = default;

    /// \throws std::invalid_argument if the range is empty or turned round, or overlaps one that is there; naming both.
    void add(SampleRange range);
    /// \throws std::invalid_argument likewise, before anything is added.
    void add(const SampleRanges& others);

    [[nodiscard]] std::span<const SampleRange> ranges() const noexcept { return ranges_; }
    [[nodiscard]] bool empty() const noexcept { return ranges_.empty(); }
    /// Samples in all.
    [[nodiscard]] std::uint64_t count() const noexcept;
    /// What of [begin, end) is not there, in order.
    [[nodiscard]] std::vector<SampleRange> missing(SampleRange range) const;
    bool operator==(const SampleRanges&) const = default;

  private:
    std::vector<SampleRange> ranges_;
};

/// "0-16,32-48", of ranges [0, 16) and [32, 48); empty text for none.
[[nodiscard]] std::string to_text(const SampleRanges& ranges);
/// \throws std::invalid_argument if it is no such text.
[[nodiscard]] SampleRanges parse_sample_ranges(std::string_view text);

}  // namespace emulsion
