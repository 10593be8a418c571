#pragma once
// What a camera was measured to respond: red, green and blue against the wavelength.
//
// Responses are to power (radiance in W m^-2 sr^-1 nm^-1, not photons), on a scale that is the same for no two tables
// and of no consequence: the fit to XYZ (film/camera_fit.h) undoes it, for each channel by itself. Measured noise may
// be negative.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/color.h"
#include "spectrum/observer.h"

namespace emulsion {

/// Curves of straight lines between the rows of a table, and 0 outside.
struct CameraResponse {
    std::string name;               ///< in messages: a model, or the file that it was read from
    std::vector<double> lambda_nm;  ///< strictly increasing, finite, > 0
    std::vector<RGBd> value;        ///< as many, finite
    bool operator==(const CameraResponse&) const = default;
};

/// \throws std::invalid_argument naming the camera, field, value and range; also unless the table has two whole
/// nanometres of [kMinWavelength_nm, kMaxWavelength_nm], and each channel responds to some wavelength there.
void validate(const CameraResponse& response);

/// The curves in place of the colour-matching functions: at the whole nanometres of the table that are in
/// [kMinWavelength_nm, kMaxWavelength_nm], straight lines between, so that a kink elsewhere is cut off.
/// \throws std::invalid_argument as validate() does.
[[nodiscard]] Observer at_whole_nm(const CameraResponse& response);

/// Reads comma-separated text: lines that are empty or start with '#' are left out; then a line of the names
/// wavelength (in nm), r, g, b, in any order and case; then a row of four numbers a line. Blanks around a cell and line
/// ends of other systems do no harm.
/// \throws std::invalid_argument naming `name`, the line (from 1), the value and what was expected.
[[nodiscard]] CameraResponse parse_camera_response(std::string_view name, std::string_view csv);

/// The same of a file, whose path is the name.
/// \throws IoError naming the file, the line, the value and what was expected.
[[nodiscard]] CameraResponse read_camera_response(const std::filesystem::path& path);

}  // namespace emulsion
