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

void warn_of_losses(const FilmContents<ExactSums>& contents) {
    const DroppedSamples& dropped = contents.counts.dropped;
    const std::uint64_t kept = contents.counts.samples;
    if (dropped.count() > 0) {
        for (const DroppedSample& sample : dropped.first()) print_warning(to_string(sample));
        if (kept == 0) {
            throw std::runtime_error(
                fmt::format("all {} samples were bad: {}; nothing was written", dropped.count(), kinds_text(dropped)));
        }
        print_warning(fmt::format("{} of {} samples were bad and kept out: {}", dropped.count(), dropped.count() + kept,
                                  kinds_text(dropped)));
    }
    if (const std::uint64_t count = contents.counts.faint; count > 0) {
        print_warning(fmt::format(
            "{} of {} samples are too faint for the film's sums, at most {:.2g} cd/m^2 times the imaging ratio", count,
            kept + contents.counts.light_splats, 0.5 * ExactSum::kResolution));
    }
    if (const auto count = pixels_without_value(contents); count > 0) {
        print_warning(
            fmt::format("{} of {} pixels have no value and are 0: no good samples, or too little weight of the filter "
                        "(less than 1/64 a "
                        "sample in the mean); more samples help",
                        count, contents.pixels.size()));
    }
    if (const auto count = saturated_pixels(contents); count > 0) {
        print_warning(fmt::format("{} pixels have left the range of the film's sums", count));
    }
}

void warn_of_losses(const Film& film) {
    film.with_contents([](const FilmContents<ExactSums>& contents) { warn_of_losses(contents); });
}

std::vector<std::string> exr_losses(const ExrWriteResult& written, PixelType pixel_type) {
    const bool is_half = pixel_type == PixelType::half;
    const int bits = is_half ? 16 : 32;
    const float largest = is_half ? 65504.0f : std::numeric_limits<float>::max();
    std::vector<std::string> losses;
    const auto note = [&](std::int64_t count, const std::string& what) {
        if (count > 0) losses.push_back(fmt::format("{} channel values are {}", count, what));
    };
    note(written.too_high_count,
         fmt::format("too large for {}-bit floats and were stored as {}, the largest", bits, largest));
    note(written.too_low_count,
         fmt::format("negative and too large for {}-bit floats and were stored as {}, the lowest", bits, -largest));
    note(written.vanished_positive_count, fmt::format("too small for {}-bit floats and were stored as 0", bits));
    note(written.vanished_negative_count,
         fmt::format("negative and too small for {}-bit floats and were stored as 0", bits));
    note(written.non_finite_count, "NaN or infinite and were stored as such");
    return losses;
}

}  // namespace emulsion::cli
