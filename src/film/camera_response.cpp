#include "film/camera_response.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "core/error.h"
#include "core/name_key.h"
#include "core/parameters.h"
#include "core/text_file.h"
#include "core/units.h"

namespace emulsion {

namespace {

constexpr std::array<std::string_view, 4> kColumns = {"wavelength", "r", "g", "b"};
constexpr std::array<double RGBd::*, 3> kChannels = {&RGBd::r, &RGBd::g, &RGBd::b};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r";
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// The text before the first separator, which is taken off.
std::string_view take(std::string_view& text, char separator) {
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return part;
}

/// Where each of kColumns stands in a row.
using Places = std::array<std::size_t, kColumns.size()>;

/// Reads line by line; what it throws says where.
class CameraCsv {
  public:
    explicit CameraCsv(std::string_view text) : text_(text) {
        constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
        if (text_.substr(0, kByteOrderMark.size()) == kByteOrderMark) text_.remove_prefix(kByteOrderMark.size());
    }

    CameraResponse read() {
        CameraResponse response;
        if (!next()) fail("the text ends here, expected the names wavelength,r,g,b");
        const Places places = read_names();
        while (next()) append_row(places, response);
        if (response.lambda_nm.size() < 2) fail("the text ends here, expected at least two rows");
        return response;
    }

  private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw std::invalid_argument("line " + std::to_string(std::max<std::size_t>(number_, 1)) + ": " + problem);
    }

    /// Goes to the next line that says something; false at the end of the text.
    bool next() {
        while (!text_.empty()) {
            line_ = trimmed(take(text_, '\n'));
            ++number_;
            if (!line_.empty() && line_.front() != '#') return true;
        }
        return false;
    }

    [[nodiscard]] std::array<std::string_view, kColumns.size()> cells() const {
        const auto count = static_cast<std::size_t>(std::count(line_.begin(), line_.end(), ',')) + 1;
        if (count != kColumns.size()) {
            fail("\"" + std::string(line_) + "\" has " + std::to_string(count) +
                 " cells, expected four, with commas between");
        }
        std::array<std::string_view, kColumns.size()> found;
        std::string_view rest = line_;
        for (std::string_view& cell : found) cell = trimmed(take(rest, ','));
        return found;
    }

    [[nodiscard]] Places read_names() const {
        const auto names = cells();
        Places places{};
        for (std::size_t i = 0; i < kColumns.size(); ++i) {
            const auto* const found = std::find_if(
                names.begin(), names.end(), [&](std::string_view name) { return name_key(name) == kColumns[i]; });
            if (found == names.end()) {
                fail("\"" + std::string(line_) + "\" has no column \"" + std::string(kColumns[i]) +
                     "\", expected the names wavelength,r,g,b");
            }
            places[i] = static_cast<std::size_t>(found - names.begin());
        }
        return places;
    }

    void append_row(const Places& places, CameraResponse& response) const {
        const auto texts = cells();
        std::array<double, kColumns.size()> row{};
        for (std::size_t i = 0; i < kColumns.size(); ++i) row[i] = number(kColumns[i], texts[places[i]]);
        const double previous = response.lambda_nm.empty() ? 0.0 : response.lambda_nm.back();
        if (!(row[0] > previous)) {
            fail("wavelength is " + std::string(texts[places[0]]) + ", expected more than " + number_text(previous));
        }
        response.lambda_nm.push_back(row[0]);
        response.value.push_back({row[1], row[2], row[3]});
    }

    [[nodiscard]] double number(std::string_view column, std::string_view cell) const {
        double value = 0.0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) {
            fail(std::string(column) + " is \"" + std::string(cell) + "\", expected a finite number");
        }
        return value;
    }

    std::string_view text_, line_;
    std::size_t number_ = 0;
};

/// What is wrong with the curves is said of "it"; the caller knows its name.
void check_curves(const CameraResponse& response) {
    if (response.lambda_nm.size() != response.value.size()) {
        throw std::invalid_argument(std::to_string(response.lambda_nm.size()) + " wavelengths and " +
                                    std::to_string(response.value.size()) + " values, expected as many");
    }
    double previous = 0.0;
    for (std::size_t i = 0; i < response.lambda_nm.size(); ++i) {
        const std::string row = "[" + std::to_string(i) + "]";
        check_range(response.lambda_nm[i], {previous, kInfinity, RangeEnd::open, RangeEnd::open}, "lambda_nm" + row);
        previous = response.lambda_nm[i];
        for (const auto channel : kChannels) check_range(response.value[i].*channel, kFinite, "value" + row);
    }
}

std::string in_range_text() {
    return "the visible range, " + std::to_string(kMinWavelength_nm) + " to " + std::to_string(kMaxWavelength_nm) +
           " nm";
}

Observer resampled(const CameraResponse& response) {
    check_curves(response);
    const auto& lambda_nm = response.lambda_nm;
    const double from_nm = lambda_nm.empty() ? 0.0 : lambda_nm.front(),
                 to_nm = lambda_nm.empty() ? 0.0 : lambda_nm.back();
    const double first = std::max<double>(kMinWavelength_nm, std::ceil(from_nm));
    const double last = std::min<double>(kMaxWavelength_nm, std::floor(to_nm));
    if (first >= last) {
        throw std::invalid_argument("wavelengths from " + number_text(from_nm) + " to " + number_text(to_nm) +
                                    ", expected at least two nm of " + in_range_text());
    }

    Observer curves{response.name, static_cast<int>(first), {}};
    std::size_t right = 1;
    for (int nm = curves.first_nm; nm <= static_cast<int>(last); ++nm) {
        const double at_nm = nm;
        while (lambda_nm[right] < at_nm) ++right;
        const double width_nm = lambda_nm[right] - lambda_nm[right - 1];
        const double fraction = (at_nm - lambda_nm[right - 1]) / width_nm;
        const RGBd a = response.value[right - 1], b = response.value[right];
        const RGBd value = (1.0 - fraction) * a + fraction * b;
        curves.value.push_back({value.r, value.g, value.b});
    }

    constexpr std::array<double XYZd::*, 3> kFunctions = {&XYZd::x, &XYZd::y, &XYZd::z};
    for (std::size_t i = 0; i < kFunctions.size(); ++i) {
        const auto is_zero = [&](const XYZd& value) { return value.*kFunctions[i] == 0.0; };
        if (std::all_of(curves.value.begin(), curves.value.end(), is_zero)) {
            throw std::invalid_argument(std::string(kColumns[i + 1]) + " is 0 over " + in_range_text() +
                                        ", expected a response");
        }
    }
    return curves;
}

}  // namespace

void validate(const CameraResponse& response) { static_cast<void>(at_whole_nm(response)); }

Observer at_whole_nm(const CameraResponse& response) {
    try {
        return resampled(response);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("camera " + response.name + ": " + error.what());
    }
}

CameraResponse parse_camera_response(std::string_view name, std::string_view csv) {
    try {
        CameraResponse response = CameraCsv(csv).read();
        response.name = name;
        static_cast<void>(resampled(response));
        return response;
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("camera " + std::string(name) + ": " + error.what());
    }
}

CameraResponse read_camera_response(const std::filesystem::path& path) {
    const std::string text = read_text_file(path);
    try {
        CameraResponse response = CameraCsv(text).read();
        response.name = path.string();
        static_cast<void>(resampled(response));
        return response;
    } catch (const std::invalid_argument& error) {
        throw IoError(path, error.what());
    }
}

}  // namespace emulsion
