#pragma once
// How a film sums: exactly (the default), or in plain doubles, floats, or floats with Kahan's compensation. The last
// three depend on the order of samples and merges, and are there to be measured against the first.
//
// Each kind names the luminance up to which a sample of weight 1 is lost in it: kFaintLuminance_cdm2. It has two types
// of pixel. TilePixel, one thread's:
//     bool add(double x, double y, double z, double weight) noexcept
// adds weight * XYZ and the weight; if a number among them is not finite it does nothing and returns false.
//     std::uint64_t samples() const noexcept
// says how many were added.
// FilmPixel, the film's:
//     void add(const TilePixel&, std::uint32_t samples) noexcept;  void merge(const FilmPixel&) noexcept
//     WeightedSums sums() const noexcept;  std::uint32_t samples() const noexcept;  bool is_saturated() const noexcept

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "film/exact_film_pixel.h"
#include "film/exact_tile_pixel.h"
#include "film/weighted_sums.h"

namespace emulsion {

/// Pixels are the same bits for every order of samples and merges, every number of threads, every size of tiles and
/// every way of sharing samples out over runs.
struct ExactSums {
    static constexpr std::string_view kName = "exact";
    static constexpr std::string_view kHelp = "fixed-point sums that do not depend on any order";
    bool operator==(const ExactSums&) const = default;
    static constexpr float kFaintLuminance_cdm2 = static_cast<float>(0.5 * ExactSum::kResolution);
    using TilePixel = ExactTilePixel;
    using FilmPixel = ExactFilmPixel;
};

/// A sum in T that forgets what it rounds off.
template <class T>
struct PlainSum {
    T sum{};
    void add(T term) noexcept { sum += term; }
    void merge(const PlainSum& other) noexcept { add(other.sum); }
    [[nodiscard]] double value() const noexcept { return static_cast<double>(sum); }
};

/// A sum in T that carries what it rounded off into the next addition.
/// Source: Kahan, "Further Remarks on Reducing Truncation Errors", Communications of the ACM 8 (1965).
template <class T>
struct KahanSum {
    T sum{}, excess{};  ///< excess: by how much `sum` is too large
    void add(T term) noexcept {
        const T corrected = term - excess, next = sum + corrected;
        excess = (next - sum) - corrected;
        sum = next;
    }
    void merge(const KahanSum& other) noexcept {
        add(other.sum);
        add(-other.excess);
    }
    [[nodiscard]] double value() const noexcept { return static_cast<double>(sum) - static_cast<double>(excess); }
};

/// The sums of X, Y, Z and the weight.
template <class Sum>
struct FourSums {
    std::array<Sum, 4> of{};
    void merge(const FourSums& other) noexcept {
        for (std::size_t i = 0; i < 4; ++i) of[i].merge(other.of[i]);
    }
    [[nodiscard]] WeightedSums values() const noexcept {
        return {{of[0].value(), of[1].value(), of[2].value()}, of[3].value()};
    }
};

/// The pixel of a tile whose four sums are of type Sum over numbers of type T.
template <class T, class Sum>
class FloatingTilePixel {
  public:
    bool add(double x, double y, double z, double weight) noexcept {
        const double wx = weight * x, wy = weight * y, wz = weight * z;
        if (!std::isfinite((wx + wy) + (wz + weight))) return false;
        const std::array<double, 4> terms = {wx, wy, wz, weight};
        for (std::size_t i = 0; i < 4; ++i) sums_.of[i].add(static_cast<T>(terms[i]));
        ++samples_;
        return true;
    }
    [[nodiscard]] const FourSums<Sum>& four_sums() const noexcept { return sums_; }
    [[nodiscard]] WeightedSums sums() const noexcept { return sums_.values(); }
    [[nodiscard]] std::uint64_t samples() const noexcept { return samples_; }

  private:
    FourSums<Sum> sums_;
    std::uint64_t samples_ = 0;
};

/// The pixel of a film of such sums.
template <class T, class Sum>
class FloatingFilmPixel {
  public:
    void add(const FloatingTilePixel<T, Sum>& tile, std::uint32_t samples) noexcept {
        sums_.merge(tile.four_sums());
        samples_.add(samples);
    }
    void merge(const FloatingFilmPixel& other) noexcept {
        sums_.merge(other.sums_);
        samples_.add(other.samples());
    }
    [[nodiscard]] WeightedSums sums() const noexcept { return sums_.values(); }
    [[nodiscard]] std::uint32_t samples() const noexcept { return samples_.count(); }
    /// A sum has overflowed.
    [[nodiscard]] bool is_saturated() const noexcept {
        const WeightedSums all = sums();
        return samples_.is_saturated() || !std::isfinite(all.xyz.x) || !std::isfinite(all.xyz.y) ||
               !std::isfinite(all.xyz.z) || !std::isfinite(all.weight);
    }

  private:
    FourSums<Sum> sums_;
    SampleCount samples_;
};

template <class T, class Sum>
struct FloatingSums {
    bool operator==(const FloatingSums&) const = default;
    static constexpr float kFaintLuminance_cdm2 = 0.0f;
    using TilePixel = FloatingTilePixel<T, Sum>;
    using FilmPixel = FloatingFilmPixel<T, Sum>;
};

struct DoubleSums : FloatingSums<double, PlainSum<double>> {
    static constexpr std::string_view kName = "double";
    static constexpr std::string_view kHelp = "sums in double precision";
    bool operator==(const DoubleSums&) const = default;
};

/// Stops growing where a sample is less than half a unit in the last place of the sum: at 2^24 samples of one size.
struct FloatSums : FloatingSums<float, PlainSum<float>> {
    static constexpr std::string_view kName = "float";
    static constexpr std::string_view kHelp = "sums in single precision";
    bool operator==(const FloatSums&) const = default;
};

struct KahanFloatSums : FloatingSums<float, KahanSum<float>> {
    static constexpr std::string_view kName = "kahan-float";
    static constexpr std::string_view kHelp = "sums in single precision with Kahan's compensation";
    bool operator==(const KahanFloatSums&) const = default;
};

/// All kinds, to iterate; core/named_value.h lists them.
using FilmSums = std::variant<ExactSums, DoubleSums, FloatSums, KahanFloatSums>;

}  // namespace emulsion
