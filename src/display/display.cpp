#include "display/display.h"

#include "core/named_value.h"

namespace emulsion {

namespace {

template <class Preset>
RgbSpace space_of(const PresetDisplay<Preset>& display) {
    return rgb_space(display.kSpace);
}

RgbSpace space_of(const CustomDisplay& display) { return rgb_space(display); }

template <class T>
TransferFunction transfer_of(const T& display) noexcept {
    return display.kTransfer;
}

TransferFunction transfer_of(const Rec2020Display& display) noexcept {
    return Bt1886Transfer{display.black_cdm2, display.peak_cdm2};
}

}  // namespace

void validate(const Display& display) {
    validate_named(display, "display");
    if (const auto* custom = std::get_if<CustomDisplay>(&display)) {
        check_triangle(*custom);
        check_white(*custom);
    }
}

RgbSpace rgb_space(const Display& display) {
    return std::visit([](const auto& chosen) { return space_of(chosen); }, display);
}

TransferFunction own_transfer(const Display& display) noexcept {
    return visit_noexcept([](const auto& chosen) { return transfer_of(chosen); }, display);
}

DisplayLight light_of(const Display& display) noexcept {
    return visit_noexcept(
        [](const auto& chosen) {
            return DisplayLight{chosen.peak_cdm2, chosen.black_cdm2, chosen.flare_cdm2};
        },
        display);
}

XYZd white_xyz(const Display& display) { return xyz_of(rgb_space(display).white); }

}  // namespace emulsion
