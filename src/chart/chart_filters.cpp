// Reconstruction filters, splatted and by importance sampling: time of a sample, against what becomes of a zone plate
// and of a slanted edge, whose right answers are known.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "chart/charts.h"
#include "chart/measure.h"
#include "core/named_value.h"
#include "core/random.h"
#include "film/film.h"
#include "film/filter_sampler.h"

namespace emulsion {

namespace {

// --- What is sampled. Places in pixels from the upper left corner.

/// Rings about the corner whose frequency grows evenly: half a cycle a pixel, the most that pixels can hold, at the
/// middle of the side. (1 + cos(k r^2)) / 2 has k r / pi cycles a pixel.
struct ZonePlate {
    double side_px;
    [[nodiscard]] double frequency(double x, double y) const { return 0.5 * std::hypot(x, y) / (0.5 * side_px); }
    [[nodiscard]] double operator()(double x, double y) const {
        const double k = std::numbers::pi * 0.5 / (0.5 * side_px);
        return 0.5 + 0.5 * std::cos(k * (x * x + y * y));
    }
};

/// 1 on one side of a line through a point, at an angle that meets pixels in every way.
struct SlantedEdge {
    static constexpr double kSlope = 0.21;  // of the edge against the vertical
    double side_px;
    [[nodiscard]] double distance(double x, double y) const { return x - 0.5 * side_px + kSlope * (y - 0.5 * side_px); }
    [[nodiscard]] double operator()(double x, double y) const { return distance(x, y) < 0.0 ? 0.0 : 1.0; }
};

// --- How it is sampled

/// Strata of a pixel with a point each.
template <class Signal>
Image<XYZ> filtered(const Signal& signal, const Filter& filter, FilterUse use, int side, int strata) {
    Film film({.width_px = side, .height_px = side, .filter = filter, .filter_use = use});
    const PixelBounds places = film.sample_bounds();
    FilmTile tile = film.make_tile(places);
    const FilterSampler sampler(filter);
    Pcg32 random(7);
    for (int y = places.y0; y < places.y1; ++y) {
        for (int x = places.x0; x < places.x1; ++x) {
            for (int i = 0; i < strata * strata; ++i) {
                const auto number = [&](int stratum) {
                    return (static_cast<float>(stratum) + random.next_float()) / static_cast<float>(strata) * 0.999999f;
                };
                const float u = number(i % strata), v = number(i / strata);
                const auto value = [&](float x_px, float y_px) {
                    const auto s = static_cast<float>(signal(static_cast<double>(x_px), static_cast<double>(y_px)));
                    return XYZ{s, s, s};
                };
                if (use == FilterUse::splatted) {
                    const float x_px = static_cast<float>(x) + u, y_px = static_cast<float>(y) + v;
                    tile.add_at(x_px, y_px, value(x_px, y_px));
                } else {
                    const FilterSample sample = sampler.sample(u, v);
                    tile.add(x, y,
                             value(static_cast<float>(x) + 0.5f + sample.x_offset_px,
                                   static_cast<float>(y) + 0.5f + sample.y_offset_px),
                             sample.weight);
                }
            }
        }
    }
    film.merge(tile);
    return film.xyz_image();
}

// --- What it should become

/// Without the frequencies that pixels can't hold the rings beyond are their mean; what is left of them there is
/// aliasing. What is lost of the rings within is blur. Both RMS.
struct ZonePlateError {
    double aliasing = 0.0, blur = 0.0;
};

ZonePlateError zone_plate_error(const Image<XYZ>& picture, const ZonePlate& plate) {
    double beyond = 0.0, within = 0.0, count_beyond = 0.0, count_within = 0.0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const auto got = static_cast<double>(picture(x, y).y);
            if (plate.frequency(x + 0.5, y + 0.5) > 0.5) {
                beyond += (got - 0.5) * (got - 0.5);
                ++count_beyond;
            } else {
                const double error = got - plate(x + 0.5, y + 0.5);
                within += error * error;
                ++count_within;
            }
        }
    }
    return {std::sqrt(beyond / count_beyond), std::sqrt(within / count_within)};
}

/// The filter's exact answer to the edge, by the distance from the pixel's centre: the part of its integral that lies
/// on the bright side. Integrals in double precision, by the middles of 2000 intervals along each axis.
class ExactEdge {
  public:
    explicit ExactEdge(const Filter& filter) : reach_(radius_px(filter, FilterAxis::x)) {
        const double y_reach = radius_px(filter, FilterAxis::y);
        // Along x: the integral from the left up to each point
        cumulative_.assign(kSteps + 1, 0.0);
        for (std::size_t i = 0; i < kSteps; ++i) {
            cumulative_[i + 1] = cumulative_[i] + eval(filter, FilterAxis::x, middle(i, reach_));
        }
        for (std::size_t i = 0; i < kSteps; ++i) {
            offset_.push_back(middle(i, y_reach));
            weight_.push_back(eval(filter, FilterAxis::y, offset_.back()));
            weights_ += weight_.back();
        }
    }

    /// Offsets (dx, dy) from the centre are bright where distance + dx + slope dy >= 0.
    [[nodiscard]] double operator()(double distance) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < kSteps; ++i) {
            const double from = -(distance + SlantedEdge::kSlope * offset_[i]);
            const double place = std::clamp((from + reach_) / (2.0 * reach_), 0.0, 1.0) * kSteps;
            const std::size_t below = std::min(static_cast<std::size_t>(place), kSteps - 1);
            const double up_to =
                std::lerp(cumulative_[below], cumulative_[below + 1], place - static_cast<double>(below));
            sum += weight_[i] * (1.0 - up_to / cumulative_.back());
        }
        return sum / weights_;
    }

  private:
    static constexpr std::size_t kSteps = 2000;
    static double middle(std::size_t i, double reach) {
        return reach * (2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(kSteps) - 1.0);
    }

    double reach_, weights_ = 0.0;
    std::vector<double> cumulative_, offset_, weight_;
};

/// RMS over the pixels that the edge concerns.
double edge_error(const Image<XYZ>& picture, const SlantedEdge& edge, const Filter& filter) {
    const ExactEdge exact(filter);
    const double reach = radius_px(filter, FilterAxis::x) + SlantedEdge::kSlope * radius_px(filter, FilterAxis::y);
    double sum = 0.0, count = 0.0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const double distance = edge.distance(x + 0.5, y + 0.5);
            if (std::abs(distance) > reach) continue;
            const double error = static_cast<double>(picture(x, y).y) - exact(distance);
            sum += error * error;
            ++count;
        }
    }
    return std::sqrt(sum / count);
}

// --- What it costs

constexpr int kTile_px = 16;
constexpr std::size_t kSamplesOfWork = std::size_t{kTile_px} * kTile_px * 4;

Work timed_samples(const Filter& filter, FilterUse use) {
    std::vector<float> numbers;
    Pcg32 random(3);
    for (std::size_t i = 0; i < 2 * kSamplesOfWork; ++i) numbers.push_back(random.next_float());
    // Of a film with a border as wide as any filter, so that all samples reach as many pixels.
    auto film = std::make_shared<Film>(
        FilmOptions{.width_px = kTile_px + 16, .height_px = kTile_px + 16, .filter = filter, .filter_use = use});
    auto tile = std::make_shared<FilmTile>(film->make_tile(film->bounds()));
    return [film, tile, numbers, use, sampler = FilterSampler(filter)] {
        tile->clear();
        for (std::size_t i = 0; i < kSamplesOfWork; ++i) {
            const auto pixel = static_cast<int>(i / 4);
            const int x = 8 + pixel % kTile_px, y = 8 + pixel / kTile_px;
            const float u = numbers[2 * i], v = numbers[2 * i + 1];
            if (use == FilterUse::splatted) {
                tile->add_at(static_cast<float>(x) + u, static_cast<float>(y) + v, XYZ{u, v, 1.0f});
            } else {
                const FilterSample sample = sampler.sample(u, v);
                tile->add(x, y, XYZ{u + sample.x_offset_px, v + sample.y_offset_px, 1.0f}, sample.weight);
            }
        }
        keep(*tile);
    };
}

}  // namespace

Chart measure_filters_chart(const ChartOptions& options) {
    const bool quick = options.effort == ChartEffort::quick;
    const int side = quick ? 48 : 128, strata = quick ? 8 : 16;
    Chart chart{
        .name = "filters",
        .title = "Reconstruction filters: aliasing, blur and noise",
        .note = fmt::format("{0}x{0} pixels, stratified samples: {1} a pixel of the zone plate, 16 of the edge. "
                            "Aliasing: RMS of rings beyond half a cycle a pixel, which should be a flat 1/2. "
                            "Blur: RMS of rings below that, from the rings. Edge: RMS of pixels at the edge, "
                            "from the filter's own integral: noise.",
                            side, strata * strata)};
    const ChartAxis time = {.label = "time of a sample / of box, importance-sampled"};
    chart.panels = {{.title = "Zone plate: aliasing", .x = time, .y = {.label = "RMS error"}},
                    {.title = "Zone plate: blur", .x = time, .y = {.label = "RMS error"}},
                    {.title = "Slanted edge: noise", .x = time, .y = {.label = "RMS error"}}};
    const ZonePlate plate{static_cast<double>(side)};
    const SlantedEdge edge{static_cast<double>(side)};
    std::vector<Work> works;
    for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
        for_each_alternative<Filter>([&]<class Kind>(const Kind& kind) {
            const Filter filter = kind;
            const ZonePlateError zone = zone_plate_error(filtered(plate, filter, use, side, strata), plate);
            const double at_edge = edge_error(filtered(edge, filter, use, side, 4), edge, filter);
            const std::array errors = {zone.aliasing, zone.blur, at_edge};
            for (std::size_t i = 0; i < chart.panels.size(); ++i) {
                chart.panels[i].points.push_back(
                    {.series = use == FilterUse::splatted ? "splatted" : "importance-sampled",
                     .label = std::string(Kind::kName),
                     .y = exactly(errors[i])});
            }
            works.push_back(timed_samples(filter, use));
        });
    }
    const std::vector<RelativeTime> times =
        times_relative_to(timed_samples(BoxFilter{}, FilterUse::importance_sampled), works, timing_options(options));
    for (ChartPanel& panel : chart.panels) {
        set_times(panel, times, {.name = "ns", .factor = 1e9 / static_cast<double>(kSamplesOfWork)});
    }
    return chart;
}

}  // namespace emulsion
