#include "film/sample_batch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace emulsion {

namespace {

void require_length(const char* array, std::size_t length, std::size_t expected) {
    if (length == expected) return;
    throw std::invalid_argument(std::string("sample batch: ") + array + " has " + std::to_string(length) +
                                " numbers, expected " + std::to_string(expected));
}

/// All in one step, without a branch by pixel, so that the compiler takes several at a time.
bool all_inside(const BatchPixels& pixels, const PixelBounds& bounds) noexcept {
    // Of bounds without pixels there is no last one: what is below would wrap, and let everything in.
    if (bounds.width() < 1 || bounds.height() < 1) return pixels.x_px.empty();
    const auto x0 = static_cast<std::uint32_t>(bounds.x0), y0 = static_cast<std::uint32_t>(bounds.y0);
    const auto last_x = static_cast<std::uint32_t>(bounds.width() - 1);
    const auto last_y = static_cast<std::uint32_t>(bounds.height() - 1);
    std::uint32_t beyond_x = 0, beyond_y = 0;  // the greatest offsets; those of pixels before the bounds wrap
    for (const std::int32_t x : pixels.x_px) beyond_x = std::max(beyond_x, static_cast<std::uint32_t>(x) - x0);
    for (const std::int32_t y : pixels.y_px) beyond_y = std::max(beyond_y, static_cast<std::uint32_t>(y) - y0);
    return beyond_x <= last_x && beyond_y <= last_y;
}

}  // namespace

void validate(const BatchPixels& pixels, const PixelBounds& bounds) {
    const std::size_t count = pixels.x_px.size();
    require_length("y_px", pixels.y_px.size(), count);
    if (!pixels.weight.empty()) require_length("weight", pixels.weight.size(), count);
    if (all_inside(pixels, bounds)) return;
    std::size_t i = 0;
    while (bounds.contains(pixels.x_px[i], pixels.y_px[i])) ++i;
    throw std::invalid_argument(
        "sample batch: sample " + std::to_string(i) + " is at pixel (" + std::to_string(pixels.x_px[i]) + ", " +
        std::to_string(pixels.y_px[i]) + "), expected one inside [" + std::to_string(bounds.x0) + ", " +
        std::to_string(bounds.x1) + ") x [" + std::to_string(bounds.y0) + ", " + std::to_string(bounds.y1) + ")");
}

void validate(const BatchPlaces& places, const std::optional<PixelBounds>& bounds) {
    require_length("y_px", places.y_px.size(), places.x_px.size());
    for (std::size_t i = 0; i < places.x_px.size(); ++i) {
        const auto x = static_cast<double>(places.x_px[i]), y = static_cast<double>(places.y_px[i]);
        const bool is_good = bounds ? x >= bounds->x0 && x <= bounds->x1 && y >= bounds->y0 && y <= bounds->y1
                                    : std::isfinite(x) && std::isfinite(y);
        if (is_good) continue;
        throw std::invalid_argument("sample batch: sample " + std::to_string(i) + " is at (" + std::to_string(x) +
                                    ", " + std::to_string(y) + "), expected a place inside " +
                                    (bounds ? to_string(*bounds) : "the plane"));
    }
}

void validate(const BatchRadiance& radiance, std::size_t samples) {
    const std::size_t wavelengths = radiance.wavelengths;
    if (wavelengths < 1 || wavelengths > kMostBatchWavelengths) {
        throw std::invalid_argument("sample batch: wavelengths is " + std::to_string(wavelengths) +
                                    ", expected a number in [1, " + std::to_string(kMostBatchWavelengths) + "]");
    }
    require_length("lambda_nm", radiance.lambda_nm.size(), samples * wavelengths);
    require_length("radiance", radiance.radiance.size(), samples * wavelengths);
    require_length("pdf_per_nm", radiance.pdf_per_nm.size(), samples * wavelengths);
}

}  // namespace emulsion
