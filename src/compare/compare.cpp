#include "compare/compare.h"

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include "compare/encoded_error.h"
#include "compare/finite_pixel.h"
#include "core/row_blocks.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/itp_difference.h"
#include "spectrum/observer.h"
#include "tonemap/luminance_statistics.h"

namespace emulsion {

namespace {

/// White and its luminance, into the comparison.
void choose_viewing(const ComparedPicture& a, const ComparedPicture& b, const CompareOptions& options,
                    Comparison& comparison) {
    const Observer& seen_by = observer(a.observer);
    if (seen_by.name != observer(b.observer).name) {
        throw std::invalid_argument("A has X, Y and Z of the observer " + seen_by.name + ", B those of " +
                                    observer(b.observer).name + ": expected the same");
    }
    ViewingConditions& viewing = comparison.viewing;
    viewing.white = options.white ? xyz_of(*options.white) : default_white(seen_by);
    const auto log_average = [&](const ComparedPicture& picture) {
        return luminance_statistics(picture.xyz.view(), options.threads).log_average_cdm2;
    };
    if (options.white_luminance_cdm2) {
        viewing.white_luminance_cdm2 = *options.white_luminance_cdm2;
    } else if (const double of_a = log_average(a); of_a > 0.0) {
        viewing.white_luminance_cdm2 = white_luminance_of_log_average(of_a);
        comparison.white_source = WhiteLuminanceSource::log_average_of_a;
    } else if (const double of_b = log_average(b); of_b > 0.0) {
        viewing.white_luminance_cdm2 = white_luminance_of_log_average(of_b);
        comparison.white_source = WhiteLuminanceSource::log_average_of_b;
    } else {
        comparison.white_source = WhiteLuminanceSource::none;
    }
    validate(viewing);
}

void count(const XYZ& pixel, double white_cdm2, PixelRuleCounts& counts) noexcept {
    if (!is_finite(pixel)) {
        ++counts.not_finite;
        return;
    }
    if (pixel.x < 0.0f || pixel.y < 0.0f || pixel.z < 0.0f) ++counts.negative;
    if (double{pixel.y} > white_cdm2) ++counts.above_white;
}

void add(const PixelRuleCounts& more, PixelRuleCounts& counts) noexcept {
    counts.not_finite += more.not_finite;
    counts.negative += more.negative;
    counts.above_white += more.above_white;
}

XYZd widened(const XYZ& xyz) noexcept { return {xyz.x, xyz.y, xyz.z}; }

struct RowCounts {
    PixelRuleCounts a, b;
    std::int64_t left_out = 0;
    int first_left_out_x = -1;
};

/// Colour differences of a row, NaN for pixels that are left out.
RowCounts compare_row(std::span<const XYZ> a, std::span<const XYZ> b, const ViewingConditions& viewing,
                      std::span<double> ciede2000, std::span<double> itp) {
    RowCounts counts;
    for (std::size_t x = 0; x < a.size(); ++x) {
        count(a[x], viewing.white_luminance_cdm2, counts.a);
        count(b[x], viewing.white_luminance_cdm2, counts.b);
        if (!is_finite(a[x]) || !is_finite(b[x])) {
            ciede2000[x] = itp[x] = std::numeric_limits<double>::quiet_NaN();
            if (counts.left_out == 0) counts.first_left_out_x = static_cast<int>(x);
            ++counts.left_out;
        } else if (a[x] == b[x]) {
            ciede2000[x] = itp[x] = 0.0;
        } else {
            const XYZd first = widened(a[x]), second = widened(b[x]);
            ciede2000[x] =
                difference(Ciede2000Difference{}, lab_as_viewed(first, viewing), lab_as_viewed(second, viewing));
            itp[x] = difference(ItpDifference{}, ictcp_as_viewed(first, viewing), ictcp_as_viewed(second, viewing));
        }
    }
    return counts;
}

void in_frame(const PixelBounds& window, DifferenceStatistics& statistics) noexcept {
    statistics.max_x += window.x0;
    statistics.max_y += window.y0;
}

/// Of pictures of one window.
void compare_colors(const ComparedPicture& a, const ComparedPicture& b, int threads, Comparison& comparison) {
    const int width = a.xyz.width(), height = a.xyz.height();
    Image<double> itp(width, height, UnsetPixels{});
    comparison.ciede2000_pixels = Image<double>(width, height, UnsetPixels{});
    std::vector<RowCounts> rows(static_cast<std::size_t>(height));
    parallel_for_rows(width, height, threads, [&](int y) {
        rows[static_cast<std::size_t>(y)] =
            compare_row(a.xyz.row(y), b.xyz.row(y), comparison.viewing, comparison.ciede2000_pixels.row(y), itp.row(y));
    });
    for (int y = 0; y < height; ++y) {
        const RowCounts& row = rows[static_cast<std::size_t>(y)];
        add(row.a, comparison.a);
        add(row.b, comparison.b);
        comparison.left_out += row.left_out;
        if (row.left_out > 0 && !comparison.first_left_out_px) {
            comparison.first_left_out_px = {comparison.window.x0 + row.first_left_out_x, comparison.window.y0 + y};
        }
    }
    comparison.ciede2000 = difference_statistics(std::as_const(comparison.ciede2000_pixels).view());
    comparison.itp = difference_statistics(std::as_const(itp).view());
    if (comparison.ciede2000.pixels == 0) throw std::invalid_argument("no pixel is finite in both pictures");
    in_frame(comparison.window, comparison.ciede2000);
    in_frame(comparison.window, comparison.itp);
}

/// Of pictures of one window.
Comparison compare_whole(const ComparedPicture& a, const ComparedPicture& b, const CompareOptions& options) {
    Comparison comparison;
    comparison.window = a.window;
    choose_viewing(a, b, options, comparison);
    compare_colors(a, b, options.threads, comparison);
    comparison.squared = squared_difference(a, b, comparison.viewing, options.threads);
    comparison.psnr_db = encoded_psnr_db(a.xyz, b.xyz, options.pipeline, options.threads);
    return comparison;
}

}  // namespace

Comparison compare(const ComparedPicture& a, const ComparedPicture& b, const CompareOptions& options) {
    const PixelBounds window = common_window(a, b);
    if (a.window == window && b.window == window) return compare_whole(a, b, options);
    return compare_whole(cropped(a, window), cropped(b, window), options);
}

}  // namespace emulsion
