#include "display/encoded_source.h"

#include <cstddef>
#include <utility>

namespace emulsion {

EncodedSource::EncodedSource(const EncodedRows& rows) : rows_(rows) {}

EncodedSource::EncodedSource(int width, int height, MakeEncoded make)
    : rows_{nullptr, width, height, 3}, make_(std::move(make)) {}

std::span<const float> EncodedReader::operator()(int y, int x0, int x1) {
    const std::size_t count = static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(source_->channels());
    if (!source_->make_) {
        return source_->rows_.row(y).subspan(
            static_cast<std::size_t>(x0) * static_cast<std::size_t>(source_->channels()), count);
    }
    room_.resize(std::max(room_.size(), static_cast<std::size_t>(x1 - x0)));
    source_->make_(y, x0, std::span(room_).first(static_cast<std::size_t>(x1 - x0)));
    return {&room_.data()->r, count};
}

EncodedPicture::EncodedPicture(const EncodedSource& source, int first_row, int threads) {
    const int height = source.height() - first_row;
    if (!source.make_) {
        rows_ = source.rows_.from(first_row);
        return;
    }
    made_ = Image<RGB>(source.width(), height, UnsetPixels{});
    parallel_for_rows(source.width(), height, threads, [&](int y) { source.make_(first_row + y, 0, made_.row(y)); });
    rows_ = rgb_rows(std::as_const(made_).view());
}

}  // namespace emulsion
