#pragma once
// The tests that run for every operator: their fixture, and what they share.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/color.h"
#include "core/image.h"
#include "test_pictures.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {

inline constexpr XYZ kWhite{0.95f, 1.0f, 1.09f};
inline constexpr XYZd kWhiteD{0.95, 1.0, 1.09};

/// Every operator with its defaults.
inline std::vector<ToneMapper> all_mappers() {
    std::vector<ToneMapper> mappers;
    for_each_alternative<ToneMapper>([&](const auto& mapper) { mappers.emplace_back(mapper); });
    return mappers;
}

inline bool is_local(const ToneMapper& mapper) { return is_local(own_adaptation(mapper)); }

/// Under one adaptation for the picture: the operator's own if that is so.
inline ToneMapping with_global_adaptation(const ToneMapper& mapper) {
    if (is_local(mapper)) return {mapper, LogAverageAdaptation{}};
    return {mapper};
}

/// A picture in which a pixel is about as bright as those around it, where these matter.
inline Image<XYZ> scene_for(const ToneMapper& mapper, int width, int height, unsigned seed) {
    return is_local(mapper) ? smooth_scene(width, height, seed) : random_scene(width, height, seed);
}

class EveryToneMapper : public testing::TestWithParam<ToneMapper> {
  protected:
    [[nodiscard]] static Image<XYZ> map(const Image<XYZ>& scene, int threads = 1) {
        return tone_map({GetParam()}, scene.view(), kWhite, threads).image;
    }
};

inline bool is_sound(const XYZ& p) noexcept {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && p.y >= 0.0f;
}

/// What a display makes of it.
inline float shown(const XYZ& pixel) noexcept { return std::min(pixel.y, 1.0f); }

inline void expect_sound(const Image<XYZ>& image) {
    EXPECT_TRUE(std::all_of(image.pixels().begin(), image.pixels().end(), is_sound));
}

/// |fast - exact| <= 2e-4 |exact| + 1e-37 in each component: the stated tolerance.
inline void expect_close(const XYZ& fast, const XYZd& exact, const std::string& where) {
    const auto close = [](float a, double b) { return std::abs(a - b) <= 2e-4 * std::abs(b) + 1e-37; };
    EXPECT_TRUE(close(fast.x, exact.x) && close(fast.y, exact.y) && close(fast.z, exact.z))
        << where << ": " << fast.x << " " << fast.y << " " << fast.z << ", exactly " << exact.x << " " << exact.y << " "
        << exact.z;
}

/// Under one adaptation; what local ones are within of their twins is in colour differences: tests/develop.
inline void expect_twin(const ToneMapper& mapper, const Image<XYZ>& scene) {
    const ToneMapping mapping = with_global_adaptation(mapper);
    const Image<XYZ> fast = tone_map(mapping, scene.view(), kWhite, 0).image;
    const Image<XYZd> exact = tone_map_reference(mapping, scene.view(), kWhiteD);
    expect_sound(fast);
    if (is_local(mapper)) expect_sound(tone_map({mapper}, scene.view(), kWhite, 0).image);
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) {
            expect_close(fast(x, y), exact(x, y),
                         to_text(mapper) + " at " + std::to_string(x) + ", " + std::to_string(y));
            if (testing::Test::HasFailure()) return;
        }
    }
}

/// Largest difference of what a display shows, and largest relative difference, between two maps.
inline std::pair<float, float> differences(const Image<XYZ>& a, const Image<XYZ>& b) {
    float of_shown = 0.0f, relative = 0.0f;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const XYZ before = a.pixels()[i], after = b.pixels()[i];
        of_shown = std::max(of_shown, std::abs(shown(after) - shown(before)));
        if (before.y != after.y) relative = std::max(relative, std::abs(after.y - before.y) / before.y);
    }
    return {of_shown, relative};
}

/// How far a bad pixel or an outlier moves any other pixel at most, as displayed: of the operator's own adaptation, in
/// pictures of a thousand pixels or more, away from the edges. reinhard-local looks closest: what noise there was at
/// the pixel shows in whether its neighbours' scales are taken.
inline float most_move(const ToneMapper& mapper) noexcept {
    return (std::holds_alternative<ReinhardLocal>(mapper) ? 3.0f : 2.0f) / 255.0f;
}

/// The operator's name, as names of tests have it.
inline std::string mapper_name(const testing::TestParamInfo<ToneMapper>& info) {
    std::string name = to_text(info.param);
    name.resize(std::min(name.size(), name.find(':')));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

}  // namespace emulsion
