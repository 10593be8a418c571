#pragma once
// What a path carries: the values of N wavelengths, or red, green and blue. The integrator is written once, for any of
// them; kChannels values are a SampledSpectrum, whichever they are.

#include "core/color.h"
#include "spectrum/sampled_spectrum.h"
#include "spectrum/spectrum_table.h"

namespace emulsion {

/// Radiance in W m^-2 sr^-1 nm^-1 at N wavelengths of the path's own.
template <int N>
struct SpectralTransport {
    static constexpr int kChannels = N;
    using Wavelengths = SampledWavelengths<N>;
    using Index = SpectrumTableIndex<N>;  ///< of the wavelengths
};

/// Linear Rec.709 in cd/m^2: reflectances as they look under D65, lights as they look. Every product of a light and a
/// reflectance is one of colours, whatever their spectra: bench/pathtracer compares it with the others.
struct RgbTransport {
    static constexpr int kChannels = 3;
    struct Wavelengths {};
    struct Index {};
};

/// The channels of an index.
template <int N>
[[nodiscard]] constexpr int channels_of(const SpectrumTableIndex<N>&) noexcept {
    return N;
}
[[nodiscard]] constexpr int channels_of(const RgbTransport::Index&) noexcept { return RgbTransport::kChannels; }
template <class Index>
using ValuesAt = SampledSpectrum<channels_of(Index{})>;

/// A spectrum in the form of every transport.
class PreparedSpectrum {
  public:
    PreparedSpectrum(SpectrumTable table, const RGB& rgb) : table_(std::move(table)) {
        rgb_.value = {rgb.r, rgb.g, rgb.b};
    }

    template <int N>
    [[nodiscard]] SampledSpectrum<N> at(const SpectrumTableIndex<N>& index) const noexcept {
        return table_.at(index);
    }
    [[nodiscard]] const SampledSpectrum<3>& at(const RgbTransport::Index&) const noexcept { return rgb_; }

  private:
    SpectrumTable table_;
    SampledSpectrum<3> rgb_;
};

}  // namespace emulsion

/// Expands macro(Transport) for each.
#define EMULSION_FOR_EACH_TRANSPORT(macro)                                                                          \
    macro(SpectralTransport<1>) macro(SpectralTransport<2>) macro(SpectralTransport<4>) macro(SpectralTransport<8>) \
        macro(SpectralTransport<16>) macro(SpectralTransport<32>) macro(RgbTransport)
