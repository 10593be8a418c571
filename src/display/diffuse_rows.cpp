#include "display/diffuse_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "display/code_units.h"
#include "display/error_rows.h"
#include "display/gather_errors.h"
#include "display/wavefront.h"

namespace emulsion {

namespace {

constexpr int kPadding_px = 2;  // beside a row of errors: the reach of the widest kernel
constexpr int kEdge_px = 4;     // that pixels within that reach of a border hand errors down to
constexpr int kLeastWidth_px = 2 * kEdge_px;

/// A picture that is being rounded.
template <const DiffusionKernel& Kernel, int Channels>
class RowDiffusion {
  public:
    RowDiffusion(RowOrder order, const CodeScale& scale, const CodeRows& codes, const Wavefront& wavefront)
        : order_(order),
          scale_(scale),
          units_(scale),
          codes_(codes),
          error_rows_(wavefront, Kernel.reach()),
          edges_(static_cast<std::size_t>(codes.height)),
          states_(edges_.size()) {
        for (std::size_t i = 0; i < error_rows_.count(); ++i) {
            errors_.push_back(RowErrors::make<Kernel>(codes.row(0).size() + 2 * kPadding));
        }
    }

    /// Rounds row y, which is above the last rows, on from where it was left to before column x1. Rows above are done
    /// as far as x1 + reach. `values` is room for a row.
    void round_to(int y, int x1, EncodedReader& read, std::span<ErrorUnits> values) {
        RowState& state = states_[static_cast<std::size_t>(y)];
        const int x0 = std::exchange(state.done, x1);
        Carry& carry = state.carry;
        constexpr int kReach = Kernel.reach();
        const int width = codes_.width, direction = row_direction(order_, y);
        gather_values(y, x0, x1, read, values);
        // In the order of the row: its first pixels, those that have all their neighbours, its last pixels
        const int begin = direction > 0 ? x0 : width - x1, end = direction > 0 ? x1 : width - x0;
        const int inner_begin = std::clamp(kReach, begin, end),
                  inner_end = std::clamp(width - kReach, inner_begin, end);
        for (int i = begin; i < inner_begin; ++i) round_at_border(y, i, carry, values);
        if (direction > 0) {
            round_inside<1>(y, inner_begin, inner_end, carry, values);
        } else {
            round_inside<-1>(y, inner_begin, inner_end, carry, values);
        }
        for (int i = inner_end; i < end; ++i) round_at_border(y, i, carry, values);
    }

    /// What has reached the last rows, `first_row` and below, of one channel.
    [[nodiscard]] IncomingErrors incoming(int first_row, int channel) {
        IncomingErrors all(codes_.width);
        const CodeUnits no_units(CodeScale{0, 1});
        const std::vector<float> black(codes_.row(0).size());
        std::vector<ErrorUnits> values(black.size());
        for (int y = first_row; y < std::min(first_row + Kernel.reach(), codes_.height); ++y) {
            gather_errors<Kernel>(black, no_units, source(y - 1, first_row), source(y - 2, first_row), 0, values);
            add_edges(y, 0, codes_.width, values);
            for (int x = 0; x < codes_.width; ++x) {
                all.row(y - first_row)[static_cast<std::size_t>(x)] = values[component(x, channel)];
            }
        }
        return all;
    }

  private:
    [[nodiscard]] static std::size_t component(int x, int channel) noexcept {
        return static_cast<std::size_t>(x) * Channels + static_cast<std::size_t>(channel);
    }

    static constexpr std::size_t kPadding = std::size_t{kPadding_px} * Channels;

    /// What a row hands on within itself: to the next pixel and to the one after it.
    struct Carry {
        std::array<ErrorUnits, Channels> next{}, after_next{};
    };
    struct RowState {
        int done = 0;  ///< columns
        Carry carry;
    };

    /// Errors handed down to the pixels near the left and right border of a row.
    using Edges = std::array<ErrorUnits, std::size_t{kLeastWidth_px} * Channels>;

    [[nodiscard]] RowErrors& errors(int y) noexcept { return errors_[error_rows_.place_of(y)]; }

    /// Nothing comes from outside of the picture, and nothing is kept of rows from `end` on.
    [[nodiscard]] ErrorSource source(int y, int end) noexcept {
        if (y < 0 || y >= end) return {nothing_.data() + kPadding, nothing_.data() + kPadding, Channels};
        const RowErrors& row = errors(y);
        const ErrorUnits* rests = row.rests.empty() ? nullptr : row.rests.data() + kPadding;
        return {row.parts.data() + kPadding, rests, std::ptrdiff_t{Channels} * row_direction(order_, y)};
    }

    /// A stretch after the other, each while its encoded values are in the cache.
    void gather_values(int y, int x0, int x1, EncodedReader& read, std::span<ErrorUnits> values) {
        for (int begin = x0; begin < x1; begin += kStretch_px) {
            const std::span<const float> encoded = read(y, begin, std::min(x1, begin + kStretch_px));
            gather_errors<Kernel>(encoded, units_, source(y - 1, y), source(y - 2, y), std::ptrdiff_t{begin} * Channels,
                                  values);
        }
        add_edges(y, x0, x1, values);
    }

    void add_edges(int y, int x0, int x1, std::span<ErrorUnits> values) noexcept {
        const Edges& edges = edges_[static_cast<std::size_t>(y)];
        const auto add = [&](int x, int place) {
            for (int c = 0; c < Channels; ++c) {
                values[component(x, c)] += edges[component(place, c)];
            }
        };
        const int right = codes_.width - kEdge_px;
        for (int x = x0; x < std::min(x1, kEdge_px); ++x) add(x, x);
        for (int x = std::max(x0, right); x < x1; ++x) add(x, x - right + kEdge_px);
    }

    /// The pixels [begin, end) in the order of the row, which have all neighbours.
    template <int Direction>
    void round_inside(int y, int begin, int end, Carry& carry, std::span<const ErrorUnits> values) noexcept {
        const int first = Direction > 0 ? begin : codes_.width - 1 - begin;
        const std::ptrdiff_t start = std::ptrdiff_t{first} * Channels;
        const ErrorUnits* value = values.data() + start;
        std::uint16_t* code = codes_.row(y).data() + start;
        RowErrors& row = errors(y);
        ErrorUnits* part = row.parts.data() + kPadding + start;
        ErrorUnits* rest = part;
        if constexpr (Kernel.rounding == ShareRounding::parts) rest = row.rests.data() + kPadding + start;
        Carry now = carry;
        for (int i = begin; i < end; ++i) {
            for (int c = 0; c < Channels; ++c) {
                const auto channel = static_cast<std::size_t>(c);
                ErrorUnits error = value[c] + now.next[channel];
                code[c] = take_code(error, units_, scale_);
                now.next[channel] = now.after_next[channel] + share<Kernel, 1, 0>(error);
                now.after_next[channel] = share<Kernel, 2, 0>(error);
                if constexpr (Kernel.rounding == ShareRounding::parts) {
                    part[c] = Kernel.floor_quotient(error);
                    rest[c] = rest_below<Kernel>(error);
                } else {
                    part[c] = error;
                }
            }
            constexpr std::ptrdiff_t kStep = std::ptrdiff_t{Direction} * Channels;
            value += kStep, code += kStep, part += kStep;
            if constexpr (Kernel.rounding == ShareRounding::parts) rest += kStep;
        }
        carry = now;
    }

    /// Pixel i in the order of the row, near a border.
    void round_at_border(int y, int i, Carry& carry, std::span<const ErrorUnits> values) noexcept {
        const int width = codes_.width, direction = row_direction(order_, y);
        const int x = direction > 0 ? i : width - 1 - i;
        const DiffusionNeighbours& neighbours = i < width / 2 ? near_begin_[static_cast<std::size_t>(i)]
                                                              : near_end_[static_cast<std::size_t>(width - 1 - i)];
        for (int c = 0; c < Channels; ++c) {
            const auto channel = static_cast<std::size_t>(c);
            ErrorUnits error = values[component(x, c)] + carry.next[channel];
            codes_.row(y)[component(x, c)] = take_code(error, units_, scale_);
            carry.next[channel] = std::exchange(carry.after_next[channel], 0);
            neighbours.hand_on(Kernel, error, [&](int dx, int dy, ErrorUnits share) {
                if (dy == 0) {
                    (dx == 1 ? carry.next : carry.after_next)[channel] += share;
                    return;
                }
                const int to = x + direction * dx, place = to < kEdge_px ? to : to - width + 2 * kEdge_px;
                const int row = y + dy;
                edges_[static_cast<std::size_t>(row)][component(place, c)] += share;
            });
        }
    }

    RowOrder order_;
    CodeScale scale_;
    CodeUnits units_;
    CodeRows codes_;
    ErrorRows error_rows_;
    std::vector<RowErrors> errors_;  // in the places of error_rows_
    std::vector<ErrorUnits> nothing_ = std::vector<ErrorUnits>(codes_.row(0).size() + 2 * kPadding);
    std::vector<Edges> edges_;  // of all rows
    std::vector<RowState> states_;
    /// Of the first two pixels in the order of the row, and of the last two from the end.
    std::array<DiffusionNeighbours, 2> near_begin_ = {DiffusionNeighbours(Kernel, 0, 2, 2),
                                                      DiffusionNeighbours(Kernel, 1, 2, 2)};
    std::array<DiffusionNeighbours, 2> near_end_ = {DiffusionNeighbours(Kernel, 2, 0, 2),
                                                    DiffusionNeighbours(Kernel, 2, 1, 2)};
};

template <const DiffusionKernel& Kernel, int Channels>
void diffuse_channels(RowOrder order, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
                      int threads) {
    const int last_rows = codes.height - Kernel.reach(), width = codes.width;
    if (last_rows <= 0 || last_rows > kMostErrorRows || width < kLeastWidth_px) {
        return diffuse_plainly(Kernel, order, EncodedPicture(source, 0, threads).rows(), scale, codes);
    }

    // Rows that have all rows below them. More threads than there are stretches of a row to follow each other at would
    // only wait.
    constexpr int kLeastStretch_px = 128;
    const int wanted = order == RowOrder::serpentine ? 1 : threads == 0 ? hardware_threads() : threads;
    const int workers = std::clamp(width / kLeastStretch_px, 1, wanted);
    Wavefront wavefront(width, last_rows, Kernel.reach(), workers);
    RowDiffusion<Kernel, Channels> diffusion(order, scale, codes, wavefront);
    parallel_for(0, workers, workers, [&](int) {
        EncodedReader read(source);
        std::vector<ErrorUnits> values(codes.row(0).size());
        while (const std::optional<WavefrontTile> tile = wavefront.take()) {
            for (int y = tile->y0; y < tile->y1; ++y) diffusion.round_to(y, wavefront.end_of(*tile, y), read, values);
            wavefront.done(*tile);
        }
    });

    const EncodedPicture last(source, last_rows, threads);
    for (int channel = 0; channel < Channels; ++channel) {
        IncomingErrors incoming = diffusion.incoming(last_rows, channel);
        diffuse_plainly(Kernel, order, last.rows(), scale, codes.from(last_rows), channel, last_rows, incoming);
    }
}

}  // namespace

template <const DiffusionKernel& Kernel>
void diffuse_rows(RowOrder order, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
                  int threads) {
    if (source.channels() == 1) return diffuse_channels<Kernel, 1>(order, source, scale, codes, threads);
    diffuse_channels<Kernel, 3>(order, source, scale, codes, threads);
}

template void diffuse_rows<kFloydSteinbergKernel>(RowOrder, const EncodedSource&, const CodeScale&, const CodeRows&,
                                                  int);
template void diffuse_rows<kJarvisKernel>(RowOrder, const EncodedSource&, const CodeScale&, const CodeRows&, int);
template void diffuse_rows<kStuckiKernel>(RowOrder, const EncodedSource&, const CodeScale&, const CodeRows&, int);
template void diffuse_rows<kSierraKernel>(RowOrder, const EncodedSource&, const CodeScale&, const CodeRows&, int);
template void diffuse_rows<kAtkinsonKernel>(RowOrder, const EncodedSource&, const CodeScale&, const CodeRows&, int);

}  // namespace emulsion
