#include "spectrum/ictcp.h"

#include <array>

#include "core/matrix3.h"
#include "spectrum/pq.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

namespace {

constexpr Matrix3 kLmsFromRgbBy4096 = {
    {{{{1688.0, 2146.0, 262.0}}, {{683.0, 2951.0, 462.0}}, {{99.0, 309.0, 3688.0}}}}};
constexpr Matrix3 kIctcpFromLmsBy4096 = {
    {{{{2048.0, 2048.0, 0.0}}, {{6610.0, -13613.0, 7003.0}}, {{17933.0, -17390.0, -543.0}}}}};

Matrix3 divided(Matrix3 matrix, double divisor) noexcept {
    for (auto& row : matrix.m) {
        for (double& element : row) element /= divisor;
    }
    return matrix;
}

struct IctcpMatrices {
    Matrix3 lms_from_xyz, xyz_from_lms;      ///< LMS over 10000 cd/m^2, XYZ in cd/m^2
    Matrix3 ictcp_from_lms, lms_from_ictcp;  ///< of encoded LMS
};

const IctcpMatrices& matrices() {
    static const IctcpMatrices all = [] {
        const Matrix3 lms_from_xyz =
            divided(kLmsFromRgbBy4096, 4096.0 * PqTransfer::kPeak_cdm2) * rgb_from_xyz(rgb_space("Rec2020"));
        const Matrix3 ictcp_from_lms = divided(kIctcpFromLmsBy4096, 4096.0);
        return IctcpMatrices{lms_from_xyz, inverse(lms_from_xyz), ictcp_from_lms, inverse(ictcp_from_lms)};
    }();
    return all;
}

}  // namespace

ICtCp ictcp_from_xyz(const XYZd& xyz_cdm2) {
    auto lms = matrices().lms_from_xyz * std::array<double, 3>{xyz_cdm2.x, xyz_cdm2.y, xyz_cdm2.z};
    for (double& response : lms) response = encode(PqTransfer{}, response);
    const auto ictcp = matrices().ictcp_from_lms * lms;
    return {ictcp[0], ictcp[1], ictcp[2]};
}

XYZd xyz_from_ictcp(const ICtCp& ictcp) {
    auto lms = matrices().lms_from_ictcp * std::array<double, 3>{ictcp.i, ictcp.ct, ictcp.cp};
    for (double& response : lms) response = decode(PqTransfer{}, response);
    const auto xyz = matrices().xyz_from_lms * lms;
    return {xyz[0], xyz[1], xyz[2]};
}

}  // namespace emulsion
