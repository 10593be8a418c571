#include "tonemap/tone_mapper.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/row_blocks.h"
#include "tonemap/scale_pixels.h"
#include "tonemap/single_precision.h"

namespace emulsion {

namespace {

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

void check(const ToneMapping& mapping, ImageView<const XYZ> scene) {
    validate(mapping);
    if (scene.width() >= 1 && scene.height() >= 1) return;
    throw std::invalid_argument("scene size " + size_text(scene.width(), scene.height()) + ": both must be at least 1");
}

void check_other(ImageView<const XYZ> other, ImageView<const XYZ> scene) {
    if (other.width() == scene.width() && other.height() == scene.height()) return;
    throw std::invalid_argument("other size " + size_text(other.width(), other.height()) + ": must be " +
                                size_text(scene.width(), scene.height()) + ", as the scene's");
}

Adaptation chosen_adaptation(const ToneMapping& mapping) {
    return mapping.adaptation ? *mapping.adaptation : own_adaptation(mapping.mapper);
}

/// Of a picture without positive pixels.
constexpr auto kBlack = [](double) { return 0.0; };

XYZd widened(const XYZ& xyz) noexcept { return {xyz.x, xyz.y, xyz.z}; }

Image<XYZd> black_reference(ImageView<const XYZ> scene, const XYZd& display_white) {
    Image<XYZd> display(scene.width(), scene.height());
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) display(x, y) = scaled_pixel(scene(x, y), display_white, kBlack);
    }
    return display;
}

/// \param least_cdm2 that a pixel's own adaptation may be
Image<XYZd> mapped_reference(const ToneReproduction& reproduction, const BasicAdaptationLuminance<double>& adaptation,
                             ImageView<const XYZ> scene, double least_cdm2, const XYZd& display_white) {
    Image<XYZd> display(scene.width(), scene.height());
    const bool is_local = adaptation.local.width() > 0;
    const double uniform = adaptation.uniform_cdm2;
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) {
            const double here = is_local ? std::max(adaptation.local(x, y) * uniform, least_cdm2) : uniform;
            const auto scale = [&](double luminance_cdm2) { return reproduction.scale(luminance_cdm2, here); };
            display(x, y) = scaled_pixel(scene(x, y), display_white, scale);
        }
    }
    return display;
}

}  // namespace

OperatorTraits traits_of(const ToneMapper& mapper) noexcept {
    return visit_noexcept([](const auto& chosen) { return chosen.kTraits; }, mapper);
}

Adaptation own_adaptation(const ToneMapper& mapper) {
    return std::visit([](const auto& chosen) -> Adaptation { return own_adaptation(chosen); }, mapper);
}

ToneReproduction prepare(const ToneMapper& mapper, const SceneLuminance& luminance, double adaptation_cdm2) {
    return std::visit([&](const auto& chosen) { return prepare(chosen, luminance, adaptation_cdm2); }, mapper);
}

void validate(const ToneMapping& mapping) {
    validate_named(mapping.mapper, "tonemap");
    if (mapping.adaptation) validate_named(*mapping.adaptation, "adaptation");
}

PreparedToneMapping::PreparedToneMapping(const ToneMapping& mapping, ImageView<const XYZ> scene,
                                         const XYZ& display_white, int threads)
    : scene_(scene) {
    check(mapping, scene);
    const SceneLuminance luminance(scene, threads);
    statistics_ = luminance.statistics();
    if (statistics_.counts.positive == 0) {
        map_to_black(display_white);
        return;
    }
    AdaptationLuminance adaptation = adapt(chosen_adaptation(mapping), scene, luminance, threads);
    const ToneReproduction reproduction = prepare(mapping.mapper, luminance, adaptation.uniform_cdm2);
    map_ = reproduce(reproduction, statistics_, std::move(adaptation), display_white, threads);
}

PreparedToneMapping PreparedToneMapping::as_other(const ToneMapping& mapping, ImageView<const XYZ> scene,
                                                  ImageView<const XYZ> other, const XYZ& display_white, int threads) {
    check(mapping, scene);
    check_other(other, scene);
    const SceneLuminance other_luminance(other, threads);
    if (other_luminance.statistics().counts.positive == 0) return {mapping, scene, display_white, threads};

    PreparedToneMapping prepared(scene);
    const SceneLuminance luminance(scene, threads);
    prepared.statistics_ = luminance.statistics();
    if (prepared.statistics_.counts.positive == 0) {
        prepared.map_to_black(display_white);
        return prepared;
    }
    const Adaptation adaptation = chosen_adaptation(mapping);
    AdaptationLuminance adapted = adapt(adaptation, other, other_luminance, threads);
    const ToneReproduction reproduction = prepare(mapping.mapper, other_luminance, adapted.uniform_cdm2);
    if (is_local(adaptation)) adapted = adapt(adaptation, scene, luminance, threads);
    prepared.map_ = reproduce(reproduction, prepared.statistics_, std::move(adapted), display_white, threads);
    return prepared;
}

PreparedToneMapping PreparedToneMapping::reference(const ToneMapping& mapping, ImageView<const XYZ> scene,
                                                   const XYZ& display_white) {
    PreparedToneMapping prepared(scene);
    prepared.hold(tone_map_reference(mapping, scene, widened(display_white)));
    return prepared;
}

PreparedToneMapping PreparedToneMapping::reference_as_other(const ToneMapping& mapping, ImageView<const XYZ> scene,
                                                            ImageView<const XYZ> other, const XYZ& display_white) {
    PreparedToneMapping prepared(scene);
    prepared.hold(tone_map_reference_as_other(mapping, scene, other, widened(display_white)));
    return prepared;
}

void PreparedToneMapping::hold(const Image<XYZd>& display) {
    statistics_ = luminance_statistics_reference(scene_);
    const auto held = std::make_shared<const Image<XYZ>>(in_single_precision(display));
    map_ = [held](int y, int x0, std::span<const XYZ> /*scene*/, std::span<XYZ> pixels) {
        std::ranges::copy(held->row(y).subspan(static_cast<std::size_t>(x0), pixels.size()), pixels.begin());
    };
}

void PreparedToneMapping::map_to_black(const XYZ& display_white) {
    map_ = [display_white](int, int, auto in, auto out) {
        const auto scale = [](auto pixels, auto scaled, LeftPixels& left) {
            scale_row(0.0f, pixels, scaled, RowPixels::any, left);
        };
        scale_pixels(in, out, display_white, scale, [](std::size_t) { return kBlack; });
    };
}

LuminanceStatistics tone_map_into(const ToneMapping& mapping, ImageView<const XYZ> scene, ImageView<XYZ> display,
                                  const XYZ& display_white, int threads) {
    if (display.width() != scene.width() || display.height() != scene.height()) {
        throw std::invalid_argument("display size " + size_text(display.width(), display.height()) + ": must be " +
                                    size_text(scene.width(), scene.height()) + ", as the scene's");
    }
    const PreparedToneMapping map(mapping, scene, display_white, threads);
    parallel_for_rows(scene.width(), scene.height(), threads, [&](int y) { map(y, 0, display.row(y)); });
    return map.statistics();
}

ToneMapResult tone_map(const ToneMapping& mapping, ImageView<const XYZ> scene, const XYZ& display_white, int threads) {
    check(mapping, scene);
    ToneMapResult result{Image<XYZ>(scene.width(), scene.height(), UnsetPixels{}), {}};
    result.statistics = tone_map_into(mapping, scene, result.image.view(), display_white, threads);
    return result;
}

std::vector<CurvePoint> tone_curve(const ToneMapping& mapping, ImageView<const XYZ> scene, int threads) {
    check(mapping, scene);
    const SceneLuminance luminance(scene, threads);
    if (luminance.statistics().counts.positive == 0) return {};
    const Adaptation adaptation = chosen_adaptation(mapping);
    const bool local = is_local(adaptation);
    const double picture_cdm2 =
        local ? luminance.log_average_cdm2() : adapt(adaptation, scene, luminance, threads).uniform_cdm2;
    const ToneReproduction reproduction = prepare(mapping.mapper, luminance, picture_cdm2);

    const double least = luminance.statistics().min_positive_cdm2,
                 octaves = std::log2(luminance.statistics().max_cdm2 / least);
    const int steps = static_cast<int>(std::ceil(16.0 * octaves));
    std::vector<CurvePoint> curve;
    for (int i = 0; i <= steps; ++i) {
        const double cdm2 = steps == 0 ? least : least * std::exp2(octaves * i / steps);
        curve.push_back({cdm2, cdm2 * reproduction.scale(cdm2, local ? cdm2 : picture_cdm2)});
    }
    return curve;
}

Image<XYZd> tone_map_reference(const ToneMapping& mapping, ImageView<const XYZ> scene, const XYZd& display_white) {
    check(mapping, scene);
    const SceneLuminance luminance(scene, luminance_statistics_reference(scene), 1);
    if (luminance.statistics().counts.positive == 0) return black_reference(scene, display_white);
    const auto adaptation = adapt_reference(chosen_adaptation(mapping), scene, luminance);
    const ToneReproduction reproduction = prepare(mapping.mapper, luminance, adaptation.uniform_cdm2);
    return mapped_reference(reproduction, adaptation, scene, luminance.statistics().min_positive_cdm2, display_white);
}

Image<XYZd> tone_map_reference_as_other(const ToneMapping& mapping, ImageView<const XYZ> scene,
                                        ImageView<const XYZ> other, const XYZd& display_white) {
    check(mapping, scene);
    check_other(other, scene);
    const SceneLuminance other_luminance(other, luminance_statistics_reference(other), 1);
    if (other_luminance.statistics().counts.positive == 0) return tone_map_reference(mapping, scene, display_white);
    const SceneLuminance luminance(scene, luminance_statistics_reference(scene), 1);
    if (luminance.statistics().counts.positive == 0) return black_reference(scene, display_white);
    const Adaptation chosen = chosen_adaptation(mapping);
    auto adaptation = adapt_reference(chosen, other, other_luminance);
    const ToneReproduction reproduction = prepare(mapping.mapper, other_luminance, adaptation.uniform_cdm2);
    if (is_local(chosen)) adaptation = adapt_reference(chosen, scene, luminance);
    return mapped_reference(reproduction, adaptation, scene, luminance.statistics().min_positive_cdm2, display_white);
}

}  // namespace emulsion
