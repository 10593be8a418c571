#include "display/display_encoder.h"

#include <algorithm>
#include <variant>

#include "core/named_value.h"
#include "display/display_gamut.h"

namespace emulsion {

namespace {

bool has_system_gamma(const Display& display, const TransferFunction& transfer) noexcept {
    return std::holds_alternative<HlgDisplay>(display) && std::holds_alternative<HlgTransfer>(transfer);
}

std::optional<HlgSceneLight> scene_light_of(const Display& display, const TransferFunction& transfer) {
    if (!has_system_gamma(display, transfer)) return {};
    return HlgSceneLight(hlg_system_gamma(light_of(display).peak_cdm2), display_gamut(display).luminance);
}

TransferEncoder encoder_of(const Display& display, const TransferFunction& transfer) {
    if (std::holds_alternative<PqTransfer>(transfer)) return TransferEncoder(PqTransfer{}, light_of(display));
    if (const auto* bt1886 = std::get_if<Bt1886Transfer>(&transfer)) {
        validate_named(transfer, "transfer");
        return TransferEncoder(*bt1886, light_of(display));
    }
    return TransferEncoder(transfer);
}

}  // namespace

RGBd encode_signal(const Display& display, const TransferFunction& transfer, const RGBd& signal) {
    const DisplayLight light = light_of(display);
    const auto of_each = [](const RGBd& rgb, const auto& f) { return RGBd{f(rgb.r), f(rgb.g), f(rgb.b)}; };
    const auto share = [&](double s) noexcept { return shown_share(light, s); };
    const auto code = [&](double x) noexcept { return encode(transfer, x); };
    if (std::holds_alternative<PqTransfer>(transfer)) {
        return of_each(signal, [&](double s) noexcept { return code(pq_linear(light, s)); });
    }
    if (std::holds_alternative<Bt1886Transfer>(transfer)) {
        return of_each(signal, [&](double s) noexcept { return std::max(code(share(s)), 0.0); });
    }
    if (!has_system_gamma(display, transfer)) return of_each(signal, code);
    const double gamma = hlg_system_gamma(light.peak_cdm2), lift = hlg_black_lift(gamma, share(0.0));
    const RGBd scene = hlg_scene_light(gamma, display_gamut(display).luminance, of_each(signal, share));
    return of_each(scene, [&](double x) noexcept { return std::max((code(x) - lift) / (1.0 - lift), 0.0); });
}

DisplayEncoder::DisplayEncoder(const Display& display, const TransferFunction& transfer)
    : scene_light_(scene_light_of(display, transfer)), encoder_(encoder_of(display, transfer)) {
    validate(display);
    if (!scene_light_) return;
    const DisplayLight light = light_of(display);
    const double black = shown_share(light, 0.0);
    black_ = static_cast<float>(black);
    lift_ = static_cast<float>(hlg_black_lift(hlg_system_gamma(light.peak_cdm2), black));
}

std::int64_t DisplayEncoder::operator()(std::span<RGB> signal) const noexcept {
    std::int64_t uncoded = 0;
    if (black_ > 0.0f) {
        const auto share = [&](float s) noexcept { return black_ * (1.0f - s) + s; };
        for (RGB& rgb : signal) rgb = {share(rgb.r), share(rgb.g), share(rgb.b)};
    }
    if (scene_light_) uncoded = (*scene_light_)(signal);
    encoder_(signal);
    if (lift_ > 0.0f) {
        const auto code = [&](float lifted) noexcept { return std::max((lifted - lift_) / (1.0f - lift_), 0.0f); };
        for (RGB& rgb : signal) rgb = {code(rgb.r), code(rgb.g), code(rgb.b)};
    }
    return uncoded;
}

}  // namespace emulsion
