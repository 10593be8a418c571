#pragma once
// Tiles of a picture: paths are started, traced in batches, and added to the film. A part of render(), for one kind of
// transport at a time.

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "film/film.h"
#include "film/filter_sampler.h"
#include "pathtracer/aux_layers.h"
#include "pathtracer/camera.h"
#include "pathtracer/path_integrator.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/sample_sequence.h"
#include "pathtracer/transport_model.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion {

/// Paths traced together: enough to fill Embree's packets down to the last bounces, few enough to stay in cache.
inline constexpr std::size_t kBatchSize = 256;

inline WavelengthSampler sampler_of(const PreparedScene& scene, const TransportModel& model) {
    const auto* spectral = std::get_if<SpectralModel>(&model);
    const bool known = spectral != nullptr && !std::holds_alternative<HeroVisible>(spectral->strategy);
    return known ? scene.wavelengths() : WavelengthSampler{};
}

/// From a path's channels to what the film takes.
inline std::array<XYZ, kMostFixedChannels> channel_matrix(const FixedChannels& channels, double imaging_ratio) {
    std::array<XYZ, kMostFixedChannels> matrix{};
    for (std::size_t k = 0; k < channels.size(); ++k) {
        const auto& [x, y, z] = channels[k].xyz;
        matrix[k] = {static_cast<float>(x * imaging_ratio), static_cast<float>(y * imaging_ratio),
                     static_cast<float>(z * imaging_ratio)};
    }
    return matrix;
}

/// Where the random numbers of a picture come from.
struct RandomNumbers {
    Sampler sampler;
    std::uint64_t seed = 0;
};

/// Renders tiles with one kind of transport.
template <class Transport>
class TileRenderer {
  public:
    TileRenderer(const PreparedScene& scene, const TransportModel& model, const RandomNumbers& random, const Film& film)
        : scene_(scene),
          random_(random),
          film_(film),
          is_splatted_(film.options().filter_use == FilterUse::splatted),
          filter_(film.options().filter),
          camera_(scene.scene().camera, film.options().width_px, film.options().height_px),
          aux_(scene.scene(), film.options().aux),
          wavelengths_(sampler_of(scene, model)) {
        if constexpr (!Transport::kSpectral) {
            xyz_from_channels_ = channel_matrix(*scene.channels(), film.sensor().imaging_ratio());
        }
    }

    /// These samples of every pixel within the bounds, some of which may lie outside the frame.
    [[nodiscard]] FilmTile render_tile(PixelBounds bounds, SampleRange samples) const {
        FilmTile tile = film_.make_tile(bounds);
        PathIntegrator<Transport> integrator(scene_, scene_.scene().integrator.max_depth);
        std::vector<Start> starts;
        std::vector<Path<Transport>> paths;
        std::vector<FirstHit> first_hits(aux_.empty() ? 0 : kBatchSize);
        starts.reserve(kBatchSize);
        paths.reserve(kBatchSize);
        const auto finish_batch = [&] {
            const std::span<FirstHit> hits(first_hits.data(), aux_.empty() ? 0 : paths.size());
            integrator.trace(paths, hits);
            for (std::size_t i = 0; i < paths.size(); ++i) {
                add(tile, starts[i], paths[i]);
                if (!hits.empty()) [[unlikely]]
                    add_aux(tile, starts[i], hits[i]);
            }
            starts.clear();
            paths.clear();
        };
        const auto begin = static_cast<int>(samples.begin), end = static_cast<int>(samples.end);
        for (int y = bounds.y0; y < bounds.y1; ++y) {
            for (int x = bounds.x0; x < bounds.x1; ++x) {
                for (int i = begin; i < end; ++i) {
                    starts.push_back(start_path(x, y, i, paths.emplace_back()));
                    if (paths.size() == kBatchSize) finish_batch();
                }
            }
        }
        finish_batch();
        return tile;
    }

  private:
    struct Start {
        int x, y, sample_index;
        float x_px, y_px, weight;
    };

    Start start_path(int x, int y, int sample_index, Path<Transport>& path) const noexcept {
        path.samples = SampleSequence(random_.sampler, random_.seed, x, y, sample_index);
        const SampleJitter& jitter = scene_.scene().jitter;
        if constexpr (Transport::kSpectral) {
            const auto next_u = [&] {
                const float u = path.samples.next_1d();
                return jitter.wavelength ? u : 0.5f;
            };
            path.wavelengths = sample_wavelengths<Transport::kChannels>(wavelengths_, next_u);
            path.index = typename Transport::Index(path.wavelengths.lambda_nm);
        }
        const auto [u, v] = jittered(path.samples.next_2d());
        Start start{x, y, sample_index, static_cast<float>(x) + u, static_cast<float>(y) + v, 1.0f};
        if (!is_splatted_ && jitter.pixel) {
            const FilterSample place = filter_.sample(u, v);
            start.x_px = static_cast<float>(x) + 0.5f + place.x_offset_px;
            start.y_px = static_cast<float>(y) + 0.5f + place.y_offset_px;
            start.weight = place.weight;
        }
        path.ray = camera_.has_lens() ? camera_.ray(start.x_px, start.y_px, jittered(path.samples.next_2d()))
                                      : camera_.ray(start.x_px, start.y_px);
        return start;
    }

    [[nodiscard]] std::array<float, 2> jittered(const std::array<float, 2>& uv) const noexcept {
        return scene_.scene().jitter.pixel ? uv : std::array{0.5f, 0.5f};
    }

    void add(FilmTile& tile, const Start& start, const Path<Transport>& path) const noexcept {
        tile.set_sample_index(static_cast<std::uint64_t>(start.sample_index));
        if constexpr (Transport::kSpectral) {
            if (is_splatted_) [[unlikely]]
                return add_at(tile, start.x_px, start.y_px, path);
            tile.add(start.x, start.y, path.wavelengths, path.radiance, start.weight);
        } else {
            XYZ xyz{};
            for (int k = 0; k < Transport::kChannels; ++k) {
                xyz = xyz + path.radiance[k] * xyz_from_channels_[static_cast<std::size_t>(k)];
            }
            if (is_splatted_) return tile.add_at(start.x_px, start.y_px, xyz);
            tile.add(start.x, start.y, xyz, start.weight);
        }
    }
    void add_aux(FilmTile& tile, const Start& start, const FirstHit& hit) const noexcept {
        if (is_splatted_) return aux_.add_at(tile, start.x_px, start.y_px, hit);
        aux_.add(tile, start.x, start.y, start.weight, hit);
    }

    const PreparedScene& scene_;
    RandomNumbers random_;
    const Film& film_;
    bool is_splatted_;
    FilterSampler filter_;
    CameraRays camera_;
    AuxLayers aux_;
    WavelengthSampler wavelengths_;                            // of spectral models
    std::array<XYZ, kMostFixedChannels> xyz_from_channels_{};  // of the others
};

}  // namespace emulsion
