#include "compare/pixel_choice.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include <fmt/core.h>

#include "compare/finite_pixel.h"
#include "core/name_key.h"
#include "core/row_blocks.h"
#include "film/exr_channels.h"
#include "film/exr_layers.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/viewing_conditions.h"
#include "tonemap/luminance_statistics.h"

namespace emulsion {

namespace {

ExrOptions with_type(ExrOptions options, PixelType type) {
    options.pixel_type = type;
    return options;
}

XYZd widened(const XYZ& xyz) noexcept { return {xyz.x, xyz.y, xyz.z}; }

/// What a file holds of a pixel, both ways. Colours are relative to the file's unit: their scale is that of the white.
class StoredBothWays {
  public:
    StoredBothWays(const ExrOptions& options, const ViewingConditions& viewing)
        : float_encoder_(with_type(options, PixelType::float32)),
          half_encoder_(with_type(options, PixelType::half)),
          decoder_(space_as_stored(options.space), 1.0),
          viewing_(viewing) {}

    /// CIEDE2000 of the two; NaN for a pixel that is not finite. Adds to `lost` what half can't hold.
    [[nodiscard]] double difference_of(const XYZ& pixel, ExrWriteResult& lost) const {
        ExrWriteResult ignored;
        const ChannelValues of_float = float_encoder_.encode(pixel, ignored),
                            of_half = half_encoder_.encode(pixel, lost);
        const XYZ a = decoder_.decode(of_float), b = decoder_.decode(of_half);
        if (!is_finite(a) || !is_finite(b)) return std::numeric_limits<double>::quiet_NaN();
        if (a == b) return 0.0;
        return difference(Ciede2000Difference{}, lab_as_viewed(widened(a), viewing_),
                          lab_as_viewed(widened(b), viewing_));
    }

  private:
    ChannelEncoder float_encoder_, half_encoder_;
    ChannelDecoder decoder_;
    ViewingConditions viewing_;
};

ViewingConditions viewing_of(const Image<XYZ>& picture, const Observer& observer, int threads) {
    const double log_average = luminance_statistics(picture.view(), threads).log_average_cdm2;
    return {default_white(observer), log_average > 0.0 ? white_luminance_of_log_average(log_average) : 1.0};
}

/// Of a row: how many pixels, and the first.
struct RowLoss {
    std::int64_t overflowing = 0, vanishing = 0;
    int first_overflowing_x = -1, first_vanishing_x = -1;
};

RowLoss compare_row(const StoredBothWays& stored, std::span<const XYZ> pixels, std::span<double> differences) {
    RowLoss row;
    const auto note = [](std::size_t x, std::int64_t& count, int& first) {
        if (count++ == 0) first = static_cast<int>(x);
    };
    for (std::size_t x = 0; x < pixels.size(); ++x) {
        ExrWriteResult lost;
        differences[x] = stored.difference_of(pixels[x], lost);
        if (lost.too_high_count + lost.too_low_count > 0) note(x, row.overflowing, row.first_overflowing_x);
        if (lost.vanished_positive_count + lost.vanished_negative_count > 0) {
            note(x, row.vanishing, row.first_vanishing_x);
        }
    }
    return row;
}

void compare_colors(const FilmPicture& picture, const ExrOptions& options, const Observer& observer, HalfLoss& loss) {
    const StoredBothWays stored(options, viewing_of(picture.xyz, observer, options.threads));
    const int width = picture.xyz.width(), height = picture.xyz.height();
    Image<double> differences(width, height, UnsetPixels{});
    std::vector<RowLoss> rows(static_cast<std::size_t>(height));
    parallel_for_rows(width, height, options.threads, [&](int y) {
        rows[static_cast<std::size_t>(y)] = compare_row(stored, picture.xyz.row(y), differences.row(y));
    });
    const auto in_frame = [&](int x, int y) {
        return std::pair(picture.data_window.x0 + x, picture.data_window.y0 + y);
    };
    for (int y = 0; y < height; ++y) {
        const RowLoss& row = rows[static_cast<std::size_t>(y)];
        loss.overflowing += row.overflowing;
        loss.vanishing += row.vanishing;
        if (row.overflowing > 0 && !loss.first_overflowing_px) {
            loss.first_overflowing_px = in_frame(row.first_overflowing_x, y);
        }
        if (row.vanishing > 0 && !loss.first_vanishing_px) {
            loss.first_vanishing_px = in_frame(row.first_vanishing_x, y);
        }
    }
    loss.ciede2000 = difference_statistics(std::as_const(differences).view());
}

/// Whether half would spoil the numbers of a channel that is no colour.
bool is_damaged(const Image<float>& values) {
    const ChannelRounder half(PixelType::half);
    ExrWriteResult lost;
    double squared = 0.0, squared_error = 0.0;
    for (const float given : values.pixels()) {
        if (!std::isfinite(given)) continue;
        const double value = given, error = half.round(value, lost) - value;
        squared += value * value;
        squared_error += error * error;
    }
    constexpr double kMost = 0x1p-11;
    return lost.too_high_count + lost.too_low_count > 0 || squared_error > kMost * kMost * squared;
}

/// Looks at all channels beside the colours that would be half.
void compare_layers(const FilmPicture& picture, HalfLoss& loss) {
    constexpr int kColours = 3;
    std::size_t halves = kColours, always_wide = picture.counts.size();
    const auto look_at = [&](const std::string& name, const Image<float>& values) {
        ++halves;
        if (loss.damaged_channel.empty() && is_damaged(values)) loss.damaged_channel = name;
    };
    for (const FloatChannel& channel : picture.floats) {
        if (is_always_float(channel.name)) {
            ++always_wide;
        } else {
            look_at(channel.name, channel.values);
        }
    }
    for (const SpectralChannel& channel : picture.spectral) {
        look_at(spectral_channel_name(channel.centre_nm), channel.values);
    }
    loss.float_bytes =
        static_cast<double>(4 * (halves + always_wide)) / static_cast<double>(2 * halves + 4 * always_wide);
}

std::string pixels_text(std::int64_t count, const std::optional<std::pair<int, int>>& first) {
    const auto [x, y] = first.value_or(std::pair{0, 0});
    return count == 1 ? fmt::format("1 pixel, ({}, {})", x, y)
                      : fmt::format("{} pixels, first at ({}, {})", count, x, y);
}

/// Why not; empty: half will do.
std::string why_float(const HalfLoss& loss, const ErrorBudget& budget) {
    if (loss.overflowing > 0) {
        return "half would overflow in " + pixels_text(loss.overflowing, loss.first_overflowing_px);
    }
    if (loss.vanishing > 0) {
        return "half would make values 0 in " + pixels_text(loss.vanishing, loss.first_vanishing_px);
    }
    if (!is_within(loss.ciede2000.mean, loss.ciede2000.p99, budget)) {
        return fmt::format("half has dE00 {:.2g} mean, {:.2g} p99; asked for {:g} and {:g}", loss.ciede2000.mean,
                           loss.ciede2000.p99, budget.mean, budget.p99);
    }
    if (!loss.damaged_channel.empty()) return "half would damage the channel " + loss.damaged_channel;
    return {};
}

}  // namespace

PixelChoice parse_pixel_choice(std::string_view text) {
    const std::string name = name_key(text);
    if (name == "half") return PixelType::half;
    if (name == "float") return PixelType::float32;
    if (const auto budget = parse_auto(text, "pixels")) return AutoPixels{*budget};
    throw std::invalid_argument(fmt::format("found \"{}\", expected half, float or auto[:MEAN[,P99]]", text));
}

HalfLoss half_loss(const FilmPicture& picture, const ExrOptions& options, const Observer& observer) {
    validate(view_of(picture));
    validate(options);
    HalfLoss loss;
    compare_colors(picture, options, observer, loss);
    compare_layers(picture, loss);
    return loss;
}

PixelDecision decide_pixels(const HalfLoss& loss, const ErrorBudget& budget) {
    validate(budget);
    const std::string reason = why_float(loss, budget);
    if (!reason.empty()) return {PixelType::float32, "float: " + reason};
    return {PixelType::half,
            fmt::format("half: dE00 {:.2g} mean, {:.2g} p99, within {:g} and {:g}; float would take {:.3g}x the bytes, "
                        "before compression",
                        loss.ciede2000.mean, loss.ciede2000.p99, budget.mean, budget.p99, loss.float_bytes)};
}

}  // namespace emulsion
