#include "display/display_encoder.h"

#include <variant>

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
    return TransferEncoder(transfer);
}

}  // namespace

RGBd encode_signal(const Display& display, const TransferFunction& transfer, const RGBd& signal) {
    const DisplayLight light = light_of(display);
    RGBd linear = signal;
    if (has_system_gamma(display, transfer)) {
        linear = hlg_scene_light(hlg_system_gamma(light.peak_cdm2), display_gamut(display).luminance, signal);
    }
    if (std::holds_alternative<PqTransfer>(transfer)) {
        linear = {pq_linear(light, signal.r), pq_linear(light, signal.g), pq_linear(light, signal.b)};
    }
    return {encode(transfer, linear.r), encode(transfer, linear.g), encode(transfer, linear.b)};
}

DisplayEncoder::DisplayEncoder(const Display& display, const TransferFunction& transfer)
    : scene_light_(scene_light_of(display, transfer)), encoder_(encoder_of(display, transfer)) {
    validate(display);
}

void DisplayEncoder::operator()(std::span<RGB> signal) const noexcept {
    if (scene_light_) (*scene_light_)(signal);
    encoder_(signal);
}

}  // namespace emulsion
