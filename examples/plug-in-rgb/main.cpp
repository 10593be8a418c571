// An RGB renderer that hands its samples to Emulsion's film: a sphere under three coloured lamps, computed in linear
// Rec. 2020. Usage: plug_in_rgb [SAMPLES PER PIXEL]; writes plug-in-rgb.exr and plug-in-rgb.png.

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <thread>
#include <vector>

#include <emulsion/core/random.h>
#include <emulsion/develop/develop.h>
#include <emulsion/display/png_file.h>
#include <emulsion/film/exr_file.h>
#include <emulsion/film/film.h>
#include <emulsion/film/rgb_input.h>

using emulsion::RGB;

struct Lamp {
    double x, y, z;  // a unit vector towards it
    RGB radiance;    // 1 is 1 cd/m^2 of white
};
constexpr std::array kLamps = {Lamp{-0.8, -0.36, 0.48, {220, 40, 20}}, Lamp{0.6, -0.64, 0.48, {30, 200, 60}},
                               Lamp{0.28, 0.72, 0.635, {30, 60, 260}}};

// What the camera sees at a place of the picture, both in [-1, 1] from the centre.
RGB shade(double x, double y) {
    const double radius = std::hypot(x, y), size = 0.8;
    RGB sum{4, 4, 5};
    if (radius > size) return (radius < 0.83) ? RGB{60, 60, 60} : sum;
    const double nx = x / size, ny = y / size, nz = std::sqrt(std::max(0.0, 1.0 - nx * nx - ny * ny));
    for (const Lamp& lamp : kLamps) {
        const double cosine = std::max(0.0, nx * lamp.x + ny * lamp.y + nz * lamp.z);
        const double highlight = 8.0 * std::pow(std::max(0.0, 2.0 * cosine * nz - lamp.z), 60.0);
        sum = sum + static_cast<float>(0.6 * cosine + highlight) * lamp.radiance;
    }
    return sum;
}

int main(int argc, char** argv) {
    const int samples_per_pixel = argc > 1 ? std::max(1, std::atoi(argv[1])) : 64;
    emulsion::FilmOptions options;
    options.width_px = options.height_px = 320;
    options.filter = emulsion::GaussianFilter{};
    options.filter_use = emulsion::FilterUse::splatted;  // places are uniform; the film filters
    emulsion::Film film(options);
    const emulsion::RgbInput rgb_input(emulsion::rgb_space("Rec2020"), film.sensor().imaging_ratio());

    // A film that splats wants samples a little beyond its edges, too.
    const emulsion::PixelBounds places = film.sample_bounds();
    std::atomic<int> next_row = places.y0;
    std::vector<std::thread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::thread& thread : threads) {
        thread = std::thread([&] {
            for (int y = next_row++; y < places.y1; y = next_row++) {
                emulsion::FilmTile tile = film.make_tile({places.x0, y, places.x1, y + 1});
                emulsion::Pcg32 random(static_cast<std::uint64_t>(y - places.y0));
                for (int i = 0; i < places.width() * samples_per_pixel; ++i) {
                    const float x_px = static_cast<float>(places.x0 + i / samples_per_pixel) + random.next_float();
                    const float y_px = static_cast<float>(y) + random.next_float();
                    tile.add_at(x_px, y_px, rgb_input.to_xyz(shade(x_px / 160.0 - 1.0, y_px / 160.0 - 1.0)));
                }
                film.merge(tile);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();

    const emulsion::Image<emulsion::XYZ> picture = film.xyz_image();
    emulsion::write_exr("plug-in-rgb.exr", picture, {}, {.space = "Rec2020"});
    emulsion::write_png("plug-in-rgb.png", emulsion::develop(picture, emulsion::Pipeline{}, 0).image);
    std::cout << film.sample_count() << " samples, " << film.dropped().count() << " kept out\n";
}
