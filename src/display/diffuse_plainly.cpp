#include "display/diffuse_plainly.h"

#include <algorithm>

namespace emulsion {

namespace {

/// One channel of a row.
template <class T>
struct Channel {
    std::span<T> row;
    int channel, channels;
    [[nodiscard]] T& operator[](int x) const noexcept {
        return row[static_cast<std::size_t>(x) * static_cast<std::size_t>(channels) +
                   static_cast<std::size_t>(channel)];
    }
};

/// Of every pixel of a row with `below` rows below it.
std::array<DiffusionNeighbours, 9> neighbours_by_place(const DiffusionKernel& kernel, int below) noexcept {
    return {DiffusionNeighbours(kernel, 0, 0, below), DiffusionNeighbours(kernel, 0, 1, below),
            DiffusionNeighbours(kernel, 0, 2, below), DiffusionNeighbours(kernel, 1, 0, below),
            DiffusionNeighbours(kernel, 1, 1, below), DiffusionNeighbours(kernel, 1, 2, below),
            DiffusionNeighbours(kernel, 2, 0, below), DiffusionNeighbours(kernel, 2, 1, below),
            DiffusionNeighbours(kernel, 2, 2, below)};
}

}  // namespace

void diffuse_plainly(const DiffusionKernel& kernel, RowOrder order, const EncodedRows& encoded, const CodeScale& scale,
                     const CodeRows& codes, int channel, int first_row, IncomingErrors& incoming) {
    const CodeUnits units(scale);
    const int width = encoded.width;
    for (int y = 0; y < encoded.height; ++y) {
        const auto neighbours = neighbours_by_place(kernel, std::min(2, encoded.height - 1 - y));
        const Channel<const float> in{encoded.row(y), channel, encoded.channels};
        const Channel<std::uint16_t> out{codes.row(y), channel, encoded.channels};
        const int direction = row_direction(order, first_row + y);
        for (int i = 0; i < width; ++i) {
            const int x = direction > 0 ? i : width - 1 - i;
            std::int64_t error = units(in[x]) + incoming.row(y)[static_cast<std::size_t>(x)];
            out[x] = take_code(error, units, scale);
            const int place = 3 * std::min(2, i) + std::min(2, width - 1 - i);
            neighbours[static_cast<std::size_t>(place)].hand_on(kernel, error, [&](int dx, int dy, std::int64_t share) {
                const int to = x + direction * dx;
                incoming.row(y + dy)[static_cast<std::size_t>(to)] += share;
            });
        }
        std::ranges::fill(incoming.row(y), 0);
    }
}

void diffuse_plainly(const DiffusionKernel& kernel, RowOrder order, const EncodedRows& encoded, const CodeScale& scale,
                     const CodeRows& codes) {
    for (int channel = 0; channel < encoded.channels; ++channel) {
        IncomingErrors incoming(encoded.width);
        diffuse_plainly(kernel, order, encoded, scale, codes, channel, 0, incoming);
    }
}

}  // namespace emulsion
