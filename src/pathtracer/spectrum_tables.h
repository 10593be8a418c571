#pragma once
// The spectra of a scene as the renderer keeps them, by index: as tables for paths of wavelengths, and as channels for
// paths of channels.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "pathtracer/fixed_channels.h"
#include "pathtracer/scene_light.h"
#include "pathtracer/transport.h"

namespace emulsion {

/// A spectrum in the form of every transport. The channels are 0 until SpectrumTables::prepare().
class PreparedSpectrum {
  public:
    explicit PreparedSpectrum(SpectrumTable table) : table_(std::move(table)) {}

    template <int N>
    [[nodiscard]] SampledSpectrum<N> at(const SpectrumTableIndex<N>& index) const noexcept {
        return table_.at(index);
    }
    template <int K>
    [[nodiscard]] SampledSpectrum<K> at(const FixedIndex<K>& /*index*/) const noexcept {
        static_assert(K <= kMostFixedChannels);
        SampledSpectrum<K> values;
        for (std::size_t k = 0; k < K; ++k) values.value[k] = channels_[k];
        return values;
    }

    void set_channels(const ChannelValues& channels) noexcept {
        for (std::size_t k = 0; k < channels.size(); ++k) channels_[k] = static_cast<float>(channels[k]);
    }

  private:
    SpectrumTable table_;
    alignas(16) std::array<float, kMostFixedChannels> channels_{};
};

class SpectrumTables {
  public:
    /// What a spectrum is of.
    enum class Role {
        light,
        reflectance,
        index,  ///< of refraction, of glass and the like, or what follows from it
        metal   ///< index of refraction of a conductor; its absorption is the next spectrum, of the same role
    };

    /// \throws std::invalid_argument as SpectrumTable does.
    std::uint32_t add_light(const ScaledSpectrum& light);
    [[nodiscard]] std::uint32_t add_reflectance(const Spectrum& spectrum);
    [[nodiscard]] std::uint32_t add_index(const Spectrum& spectrum);
    /// Returns the index of eta; that of k is one more.
    [[nodiscard]] std::uint32_t add_metal(const Spectrum& eta, const Spectrum& k);

    /// Works out the channels of all spectra that were added. Reflectances are kept in [-1, 1], so that bounces
    /// converge: a saturated colour may have a negative channel. A metal gets the reflectance of its spectrum at normal
    /// incidence. An index is the same for all channels, the mean by ybar: they share one direction, and nothing
    /// disperses.
    /// \throws std::invalid_argument as SpectrumTable does.
    void prepare(const FixedChannels& channels);

    [[nodiscard]] const PreparedSpectrum& operator[](std::uint32_t i) const noexcept { return spectra_[i]; }

    /// What was added, in that order.
    struct Source {
        Role role = Role::light;
        ScaledSpectrum spectrum;
    };
    [[nodiscard]] std::span<const Source> sources() const noexcept { return sources_; }

  private:
    std::uint32_t add(Role role, const ScaledSpectrum& spectrum);

    std::vector<PreparedSpectrum> spectra_;
    std::vector<Source> sources_;
};

/// Of a conductor in air, at each whole nanometre of the visible.
[[nodiscard]] Spectrum normal_reflectance(const Spectrum& eta, const Spectrum& k);

}  // namespace emulsion
