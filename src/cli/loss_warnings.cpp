#include "cli/loss_warnings.h"

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "cli/messages.h"

namespace emulsion::cli {

namespace {

std::string kinds_text(const DroppedSamples& dropped) {
    return fmt::format("{} NaN, {} infinite, {} of negative luminance", dropped.count(DroppedKind::nan),
                       dropped.count(DroppedKind::infinite), dropped.count(DroppedKind::negative_luminance));
}

}  // namespace

void warn_of_losses(const Film& film) {
    const DroppedSamples dropped = film.dropped();
    const std::uint64_t kept = film.sample_count();
    if (dropped.count() > 0) {
        for (const DroppedSample& sample : dropped.first()) print_warning(to_string(sample));
        if (kept == 0) {
            throw std::runtime_error(
                fmt::format("all {} samples were bad: {}; nothing was written", dropped.count(), kinds_text(dropped)));
        }
        print_warning(fmt::format("{} of {} samples were bad and kept out: {}", dropped.count(), dropped.count() + kept,
                                  kinds_text(dropped)));
    }
    if (const auto count = film.pixels_without_value(); count > 0) {
        print_warning(
            fmt::format("{} of {} pixels have no value and are 0: no good samples, or filter weights that cancel; more "
                        "samples help",
                        count, static_cast<std::int64_t>(film.bounds().width()) * film.bounds().height()));
    }
    if (const auto count = film.saturated_pixels(); count > 0) {
        print_warning(fmt::format("{} pixels have left the range of the film's sums", count));
    }
}

std::vector<std::string> exr_losses(const ExrWriteResult& written, PixelType pixel_type) {
    std::vector<std::string> losses;
    if (written.clamped_count > 0) {
        const bool is_half = pixel_type == PixelType::half;
        losses.push_back(fmt::format(
            "{} channel values are too large for {}-bit floats and were stored as {}, the "
            "largest, with their sign",
            written.clamped_count, is_half ? 16 : 32, is_half ? 65504.0f : std::numeric_limits<float>::max()));
    }
    if (written.non_finite_count > 0) {
        losses.push_back(
            fmt::format("{} channel values are NaN or infinite and were stored as such", written.non_finite_count));
    }
    return losses;
}

}  // namespace emulsion::cli
