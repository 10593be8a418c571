#pragma once
// What a path carries: the values of N wavelengths that it drew, or K channels that are the same for all paths. The
// integrator is written once, for either; kChannels values are a SampledSpectrum, whichever they are.

#include "spectrum/sampled_spectrum.h"
#include "spectrum/spectrum_table.h"

namespace emulsion {

/// Radiance in W m^-2 sr^-1 nm^-1 at N wavelengths of the path's own.
template <int N>
struct SpectralTransport {
    static constexpr int kChannels = N;
    static constexpr bool kSpectral = true;
    static constexpr bool kMarksDispersion = false;
    using Wavelengths = SampledWavelengths<N>;
    using Index = SpectrumTableIndex<N>;  ///< of the wavelengths
};

/// Which numbers of a spectrum a path of K channels asks for: all of them.
template <int K>
struct FixedIndex {};

/// The K channels of fixed_channels.h. Every product of a light and a reflectance is one of channels, whatever their
/// spectra.
template <int K>
struct FixedTransport {
    static constexpr int kChannels = K;
    static constexpr bool kSpectral = false;
    static constexpr bool kMarksDispersion = false;
    struct Wavelengths {};
    using Index = FixedIndex<K>;
};

/// Many channels at once, for pilots that compare models path by path: of all of them every path is the same. Its last
/// channel loses what dispersing materials scatter.
struct PilotTransport {
    static constexpr int kChannels = 64;
    static constexpr bool kSpectral = false;
    static constexpr bool kMarksDispersion = true;
    struct Wavelengths {};
    using Index = FixedIndex<kChannels>;
};

/// The channels of an index.
template <int N>
[[nodiscard]] constexpr int channels_of(const SpectrumTableIndex<N>&) noexcept {
    return N;
}
template <int K>
[[nodiscard]] constexpr int channels_of(const FixedIndex<K>&) noexcept {
    return K;
}
template <class Index>
using ValuesAt = SampledSpectrum<channels_of(Index{})>;

}  // namespace emulsion

/// Expands macro(Transport) for each. Channels of a number in between are rendered as the next of these, the rest 0.
#define EMULSION_FOR_EACH_TRANSPORT(macro)                                                                          \
    macro(SpectralTransport<1>) macro(SpectralTransport<2>) macro(SpectralTransport<4>) macro(SpectralTransport<8>) \
        macro(SpectralTransport<16>) macro(SpectralTransport<32>) macro(FixedTransport<3>) macro(FixedTransport<4>) \
            macro(FixedTransport<8>) macro(PilotTransport)
