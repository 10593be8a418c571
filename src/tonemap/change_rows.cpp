#include "tonemap/change_rows.h"

namespace emulsion {

void OriginalRows::keep_border() {
    if (radius_ == 0) return;
    border_ = Image<float>(picture_->width(), 2 * radius_);
    const auto copy = [&](int from, int to) {
        const std::span<const float> row = picture_->row(mirrored(from, picture_->height()));
        std::copy(row.begin(), row.end(), border_.row(to).begin());
    };
    for (int i = 0; i < radius_; ++i) {
        copy(begin_ - radius_ + i, i);
        copy(end_ + i, radius_ + i);
    }
}

std::span<const float* const> OriginalRows::about(int y) {
    if (kept_.width() == 0) {
        kept_ = Image<float>(picture_->width(), radius_ + 1);
        rows_.resize(2 * static_cast<std::size_t>(radius_) + 1);
    }
    const std::span<const float> here = picture_->row(y);
    std::copy(here.begin(), here.end(), kept(y));
    int from = y - radius_;
    for (const float*& row : rows_) {
        if (from < begin_) {
            row = border_.row(from - begin_ + radius_).data();
        } else if (from <= y) {
            row = kept(from);
        } else if (from < end_) {
            row = picture_->row(from).data();
        } else {
            row = border_.row(radius_ + from - end_).data();
        }
        ++from;
    }
    return rows_;
}

}  // namespace emulsion
