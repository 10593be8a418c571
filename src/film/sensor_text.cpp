#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

#include "core/content_hash.h"
#include "core/name_key.h"
#include "core/named_value.h"
#include "core/parameters.h"
#include "film/sensor_options.h"

namespace emulsion {

namespace {

/// Feeds a hash with numbers, each as the text that reads back as it, and with the structure around them.
class Fingerprint {
  public:
    void add(double number) { hash_.add(number_text(number) + " "); }
    void add(std::span<const double> numbers) {
        add(static_cast<double>(numbers.size()));
        for (const double number : numbers) add(number);
    }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void add(Enum choice) { add(static_cast<double>(choice)); }
    void add(const RGBd& color) {
        for (const double component : {color.r, color.g, color.b}) add(component);
    }

    void add(const ConstantSpectrum& s) { add(s.value); }
    void add(const PiecewiseLinearSpectrum& s) {
        add(s.lambda_nm);
        add(s.value);
        add(s.extrapolation);
    }
    void add(const BlackbodySpectrum& s) {
        add(s.temperature_K);
        add(s.unit);
    }
    void add(const SigmoidSpectrum& s) { add(s.c); }
    void add(const RgbIlluminantSpectrum& s) {
        add(s.sigmoid);
        add(s.illuminant);
        add(s.scale);
    }
    void add(const DenseSpectrum& s) {
        add(s.first_nm);
        add(s.step_nm);
        add(s.value);
        add(s.extrapolation);
    }
    void add(const DaylightSpectrum& s) {
        add(s.temperature_K);
        add(s.weights);
    }
    void add(const LineSpectrum& s) {
        for (const Line& line : s.line) {
            add(line.lambda_nm);
            add(line.power);
        }
        hash_.add("gaussian ");
        for (const GaussianLine& line : s.gaussian) {
            add(line.mean_nm);
            add(line.fwhm_nm);
            add(line.power);
        }
    }
    void add(const ProductSpectrum& s) {
        for (const Spectrum& factor : s.factor) add(factor);
        add(s.scale);
    }
    void add(const SumSpectrum& s) {
        for (const Spectrum& term : s.term) add(term);
        add(s.weight);
    }
    void add(const Spectrum& spectrum) {
        hash_.add("(");
        add(static_cast<double>(spectrum.index()));
        std::visit([this](const auto& s) { add(s); }, static_cast<const SpectrumVariant&>(spectrum));
        hash_.add(")");
    }
    void add(const CameraSensor& camera) {
        add(camera.response.lambda_nm);
        for (const RGBd& value : camera.response.value) add(value);
        add(camera.training.illuminant);
        if (camera.training.target_illuminant) add(*camera.training.target_illuminant);
    }

    [[nodiscard]] std::string hex() const { return hash_.hex(); }

  private:
    ContentHash hash_;
};

std::string camera_text(const CameraSensor& camera) {
    Fingerprint fingerprint;
    fingerprint.add(camera);
    const std::string& name = camera.response.name;
    return fingerprint.hex() + ":" + name.substr(name.find_last_of('/') + 1);
}

std::string balance_text(const WhiteBalance& balance) {
    std::string white;
    if (const auto* light = std::get_if<TemperatureWhite>(&balance.white)) {
        white = number_text(light->temperature_K) + "K";
    } else {
        const auto& point = std::get<Chromaticity>(balance.white);
        white = number_text(point.x) + "," + number_text(point.y);
    }
    return white + ":" + to_text(balance.method);
}

}  // namespace

std::string to_text(const SensorOptions& options) {
    return "exposure-time=" + number_text(options.exposure_time_s) + " iso=" + number_text(options.iso) +
           " observer=" + name_key(options.observer) +
           " white-balance=" + (options.white_balance ? balance_text(*options.white_balance) : "none") +
           " camera=" + (options.camera ? camera_text(*options.camera) : "none");
}

std::string_view without_camera_name(std::string_view sensor_text) noexcept {
    constexpr std::string_view kCamera = " camera=";
    const std::size_t camera = sensor_text.find(kCamera);
    if (camera == std::string_view::npos) return sensor_text;
    return sensor_text.substr(0, sensor_text.find(':', camera + kCamera.size()));
}

}  // namespace emulsion
