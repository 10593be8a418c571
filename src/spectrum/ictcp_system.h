#pragma once
// ICtCp (spectrum/ictcp.h) as a colour system: ICtCp is of absolute XYZ, colour systems of relative one, so that the
// luminance of the white has to be said.

#include <array>
#include <string_view>

#include "core/color.h"
#include "core/parameters.h"
#include "spectrum/color_values.h"
#include "spectrum/ictcp.h"

namespace emulsion {

struct IctcpSystem {
    static constexpr std::string_view kName = "ictcp";
    static constexpr std::string_view kHelp = "ICtCp of BT.2100 with PQ, of XYZ for D65";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"I", 0.0, 0.5807, "", "intensity"},
                                               ColorComponent{"Ct", -0.2813, 0.2775, "", "yellow to blue"},
                                               ColorComponent{"Cp", -0.1614, 0.2788, "", "green to red"}};
    double white_cdm2 = kIctcpReferenceWhite_cdm2;  ///< luminance of Y = 1; in (0, 10000]
    bool operator==(const IctcpSystem&) const = default;

    static constexpr std::array kParameters = {Parameter<IctcpSystem>{
        "white", &IctcpSystem::white_cdm2, {0.0, 10000.0, RangeEnd::open}, "cd/m^2", "luminance of the white"}};
};
[[nodiscard]] inline ColorValues from_xyz(const IctcpSystem& system, const XYZd& xyz,
                                          const ColorContext& /*context*/) noexcept {
    const ICtCp ictcp = ictcp_from_xyz(system.white_cdm2 * xyz);
    return {{ictcp.i, ictcp.ct, ictcp.cp}};
}
[[nodiscard]] inline XYZd to_xyz(const IctcpSystem& system, const ColorValues& color,
                                 const ColorContext& /*context*/) noexcept {
    return (1.0 / system.white_cdm2) * xyz_from_ictcp({color.value[0], color.value[1], color.value[2]});
}

}  // namespace emulsion
