// How time, memory and error grow with pixels, samples, triangles and threads: measured exponents.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include "chart/charts.h"
#include "chart/measure.h"
#include "core/parallel.h"
#include "film/film.h"
#include "pathtracer/landscape_scene.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/render.h"

namespace emulsion {

namespace {

constexpr std::int64_t kTriangles = 2000;
constexpr int kSide_px = 96;

/// Of this process, after what was freed has been given back.
double resident_bytes() {
    ::malloc_trim(0);
    std::ifstream file("/proc/self/statm");
    double all = 0.0, resident = 0.0;
    file >> all >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// Processor time of all threads.
double process_seconds() {
    ::timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Image<XYZ> render_picture(const PreparedScene& scene, int samples, std::uint64_t seed, int threads) {
    Film film(film_options(scene.scene()));
    RenderProgress progress;
    render(scene, {.samples_per_pixel = samples, .seed = seed, .model = {}, .threads = threads}, film, progress);
    return film.xyz_image();
}

/// Adds y over that of the first, at the numbers `x`; and the exponent to the panel's title.
void add_series(ChartPanel& panel, const std::string& series, const std::vector<double>& x,
                const std::vector<Spread>& y) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double first = y[0].median;
        panel.points.push_back({.series = series,
                                .label = "",
                                .x = exactly(x[i]),
                                .y = {y[i].median / first, y[i].p25 / first, y[i].p75 / first}});
    }
    panel.title +=
        fmt::format("{} {} {:+.2f}", panel.title.ends_with(":") ? "" : ",", series, fitted_exponent(panel, series));
}

/// Times relative to that of the first work.
std::vector<Spread> relative_times(const std::vector<Work>& works, const ChartOptions& options) {
    std::vector<Spread> ratios;
    const int rounds = options.effort == ChartEffort::quick ? 3 : 9;
    for (const RelativeTime& time : times_relative_to(works[0], works, {.rounds = rounds, .least_s = 0.0})) {
        ratios.push_back(time.ratio);
    }
    return ratios;
}

ChartPanel by_pixels(const ChartOptions& options) {
    std::vector<int> sides = {128, 256, 512, 1024};
    if (options.effort == ChartEffort::quick) sides = {128, 256, 512};
    std::vector<double> pixels, film_pixels;
    std::vector<Spread> bytes;
    std::vector<Work> works;
    for (const int side : sides) {
        auto scene = std::make_shared<PreparedScene>(landscape_scene(kTriangles, side), options.threads);
        pixels.push_back(static_cast<double>(side) * side);
        works.emplace_back([scene] { keep(render_picture(*scene, 1, 1, 1)); });
        const double before = resident_bytes();
        const Film film(film_options(landscape_scene(1, 4 * side)));
        keep(film);
        bytes.push_back(exactly(resident_bytes() - before));
        film_pixels.push_back(16.0 * side * side);
    }
    ChartPanel panel{
        .title = "Pixels:", .x = {.label = "pixels"}, .y = {.label = "of the first"}, .lines = SeriesLines::joined};
    add_series(panel, "time", pixels, relative_times(works, options));
    add_series(panel, "memory", film_pixels, bytes);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        panel.points[sides.size() + i].details = {{"bytes of a film", bytes[i].median}};
    }
    return panel;
}

ChartPanel by_samples(const PreparedScene& scene, const ChartOptions& options) {
    std::vector<int> counts = {4, 8, 16, 32, 64, 128};
    if (options.effort == ChartEffort::quick) counts = {4, 16, 64};
    std::vector<Work> works;
    works.reserve(counts.size());
    for (const int count : counts) works.emplace_back([&scene, count] { keep(render_picture(scene, count, 1, 1)); });
    ChartPanel panel{.title = "Samples:",
                     .x = {.label = "samples a pixel"},
                     .y = {.label = "of the first"},
                     .lines = SeriesLines::joined};
    add_series(panel, "time", {counts.begin(), counts.end()}, relative_times(works, options));
    return panel;
}

/// Root of the mean squared error of Y.
double rms_error(const Image<XYZ>& picture, const Image<XYZ>& reference) {
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
        const double error = static_cast<double>(picture.pixels()[i].y) - static_cast<double>(reference.pixels()[i].y);
        sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(picture.pixels().size()));
}

ChartPanel error_by_samples(const PreparedScene& scene, const ChartOptions& options) {
    const bool quick = options.effort == ChartEffort::quick;
    const Image<XYZ> reference = render_picture(scene, quick ? 1024 : 8192, 999, options.threads);
    std::vector<double> counts;
    std::vector<Spread> errors;
    for (int count = 1; count <= (quick ? 16 : 128); count *= quick ? 4 : 2) {
        std::vector<double> of_seeds;
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            of_seeds.push_back(rms_error(render_picture(scene, count, seed, options.threads), reference));
        }
        counts.push_back(count);
        errors.push_back(spread_of(of_seeds));
    }
    ChartPanel panel{.title = "Error by samples:",
                     .x = {.label = "samples a pixel"},
                     .y = {.label = "of the first"},
                     .lines = SeriesLines::joined};
    add_series(panel, "error", counts, errors);
    return panel;
}

ChartPanel by_triangles(const ChartOptions& options) {
    std::vector<std::int64_t> counts = {30'000, 100'000, 300'000, 1'000'000, 3'000'000};
    if (options.effort == ChartEffort::quick) counts = {30'000, 100'000, 300'000};
    // Memory first, and all scenes are kept: allocators of their own would give freed memory to the next one.
    std::vector<double> triangles;
    std::vector<Spread> bytes, build_s;
    std::vector<Work> works;
    for (const std::int64_t count : counts) {
        const double before = resident_bytes();
        auto scene = std::make_shared<PreparedScene>(landscape_scene(count, kSide_px), options.threads);
        bytes.push_back(exactly(resident_bytes() - before));
        triangles.push_back(static_cast<double>(count));
        works.emplace_back([scene] { keep(render_picture(*scene, 1, 1, 1)); });
    }
    for (const std::int64_t count : counts) {
        std::vector<double> seconds;
        for (int round = 0; round < 3; ++round) {
            Scene scene = landscape_scene(count, kSide_px);
            seconds.push_back(wall_seconds([&] { keep(PreparedScene(std::move(scene), options.threads)); }));
        }
        build_s.push_back(spread_of(seconds));
    }
    ChartPanel panel{.title = "Triangles:",
                     .x = {.label = "triangles"},
                     .y = {.label = "of the first"},
                     .lines = SeriesLines::joined};
    add_series(panel, "tracing", triangles, relative_times(works, options));
    add_series(panel, "building", triangles, build_s);
    add_series(panel, "memory", triangles, bytes);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        panel.points[2 * counts.size() + i].details = {{"bytes", bytes[i].median}};
    }
    return panel;
}

/// By the clock on the wall, which other programs on the machine change; and the processor time of all threads
/// together, which says what working together costs, whatever else there is.
ChartPanel by_threads(const ChartOptions& options) {
    const PreparedScene scene(landscape_scene(kTriangles, 2 * kSide_px), 0);
    std::vector<double> counts;
    for (int threads = 1; threads <= std::max(hardware_threads(), 2); threads *= 2) counts.push_back(threads);
    std::vector<std::vector<double>> wall(counts.size()), processor(counts.size());
    for (int round = 0; round < (options.effort == ChartEffort::quick ? 3 : 15); ++round) {
        double wall_of_one_s = 0.0, processor_of_one_s = 0.0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const double start_s = process_seconds();
            const double wall_s = wall_seconds([&] { keep(render_picture(scene, 8, 1, static_cast<int>(counts[i]))); });
            const double processor_s = process_seconds() - start_s;
            if (i == 0) {
                wall_of_one_s = wall_s;
                processor_of_one_s = processor_s;
            }
            wall[i].push_back(wall_s / wall_of_one_s);
            processor[i].push_back(processor_s / processor_of_one_s);
        }
    }
    const auto spreads = [](const std::vector<std::vector<double>>& times) {
        std::vector<Spread> all;
        all.reserve(times.size());
        for (const std::vector<double>& of_count : times) all.push_back(spread_of(of_count));
        return all;
    };
    ChartPanel panel{
        .title = "Threads:", .x = {.label = "threads"}, .y = {.label = "of the first"}, .lines = SeriesLines::joined};
    add_series(panel, "time", counts, spreads(wall));
    add_series(panel, "processor", counts, spreads(processor));
    return panel;
}

}  // namespace

Chart measure_scaling_chart(const ChartOptions& options) {
    Chart chart{.name = "scaling",
                .title = "What grows with what: exponents by least squares",
                .note = fmt::format(
                    "Grey hills of {} triangles, {}x{} pixels and 1 sample each unless they are counted. Everything is "
                    "relative to the first point of its line. Processor time of one thread, but by the clock for "
                    "building and for threads; memory is what the process holds more: a film, a prepared scene. Error: "
                    "RMS of Y against many "
                    "samples; independent samples have -1/2.",
                    kTriangles, kSide_px, kSide_px)};
    const PreparedScene scene(landscape_scene(kTriangles, kSide_px), options.threads);
    chart.panels = {by_pixels(options), by_samples(scene, options)};
    chart.panels.push_back(error_by_samples(scene, options));
    chart.panels.push_back(by_triangles(options));
    chart.panels.push_back(by_threads(options));
    return chart;
}

}  // namespace emulsion
