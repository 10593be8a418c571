// A whole renderer of its own that hands its samples to Emulsion's film: soap bubbles and spheres on a checkered floor,
// path traced at four wavelengths a path. Usage: plug_in [SAMPLES PER PIXEL]; writes plug-in.exr and plug-in.png.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <thread>
#include <vector>

#include <emulsion/core/random.h>
#include <emulsion/develop/develop.h>
#include <emulsion/display/png_file.h>
#include <emulsion/film/exr_file.h>
#include <emulsion/film/film.h>
#include <emulsion/film/filter_sampler.h>
#include <emulsion/spectrum/wavelength_sampling.h>

using Random = emulsion::Pcg32;
using Wavelengths = emulsion::SampledWavelengths<4>;
using Spectrum = emulsion::SampledSpectrum<4>;

struct Vec {
    double x, y, z;
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec unit(Vec a) { return (1.0 / std::sqrt(dot(a, a))) * a; }

enum class Material { matte, mirror, bubble };
struct Sphere {
    Vec centre;
    double radius;
    Material material;
    double peak_nm;  // of the reflectance
};
const std::vector<Sphere> kSpheres = {
    {{0, -1000, 0}, 1000, Material::matte, 0},    {{-2.1, 0.8, 0.3}, 0.8, Material::matte, 640},
    {{2.3, 0.7, 0.2}, 0.7, Material::matte, 455}, {{0.9, 0.5, -1.7}, 0.5, Material::mirror, 600},
    {{0.1, 1.5, 0.6}, 1.4, Material::bubble, 0},  {{-1.0, 0.6, -1.5}, 0.55, Material::bubble, 0},
    {{1.9, 2.2, 0.9}, 0.5, Material::bubble, 0},  {{-1.9, 2.5, 1.2}, 0.45, Material::bubble, 0}};

double reflectance(const Sphere& sphere, Vec point, double lambda_nm) {
    if (&sphere == &kSpheres[0]) {
        return (static_cast<int>(std::floor(point.x) + std::floor(point.z)) & 1) != 0 ? 0.75 : 0.3;
    }
    const double offset = (lambda_nm - sphere.peak_nm) / (sphere.material == Material::mirror ? 110.0 : 45.0);
    return sphere.material == Material::mirror && lambda_nm > sphere.peak_nm ? 0.95
                                                                             : 0.08 + 0.8 * std::exp(-offset * offset);
}

// Two reflections, from the front and the back of a film of water that is thicker further down, interfere.
double bubble_reflectance(double cos_angle, double height, double lambda_nm) {
    const double thickness_nm = 250.0 + 300.0 * (1.0 - height), n = 1.33;
    const double cos_inside = std::sqrt(1.0 - (1.0 - cos_angle * cos_angle) / (n * n));
    const double r = (cos_angle - n * cos_inside) / (cos_angle + n * cos_inside);
    const double s = std::sin(2.0 * 3.14159265 * n * thickness_nm * cos_inside / lambda_nm);
    return std::min(1.0, 4.0 * r * r * s * s);
}

// Radiance in W m^-2 sr^-1 nm^-1: a blue sky that pales towards the horizon, and a large, warm sun.
double sky(Vec direction, double lambda_nm) {
    const double blue = std::pow(500.0 / lambda_nm, 4.0), up = std::max(direction.y, 0.0);
    const double sun = dot(direction, unit({-0.5, 0.7, -0.6})) > 0.97 ? 1.5 * lambda_nm / 560.0 : 0.0;
    return 0.04 * (blue * up + 0.7 * (1.0 - up)) + sun;
}

Vec random_on_sphere(Random& random) {
    const double z = 1.0 - 2.0 * random.next_float(), phi = 2.0 * 3.14159265 * random.next_float();
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

Spectrum trace(Vec origin, Vec direction, const Wavelengths& wavelengths, Random& random) {
    Spectrum throughput(1.0f);
    const auto multiply = [&](auto&& factor) {
        for (int i = 0; i < 4; ++i) throughput[i] *= static_cast<float>(factor(wavelengths.lambda_nm[i]));
    };
    for (int bounce = 0; bounce < 12; ++bounce) {
        const Sphere* hit = nullptr;
        double nearest = 1e9;
        for (const Sphere& sphere : kSpheres) {
            const Vec to_origin = origin + -1.0 * sphere.centre;
            const double b = dot(to_origin, direction), c = dot(to_origin, to_origin) - sphere.radius * sphere.radius;
            if (b * b < c) continue;
            for (const double t : {-b - std::sqrt(b * b - c), -b + std::sqrt(b * b - c)}) {
                if (t > 1e-4 && t < nearest) nearest = t, hit = &sphere;
            }
        }
        if (hit == nullptr) {
            multiply([&](double lambda_nm) { return sky(direction, lambda_nm); });
            return throughput;
        }
        origin = origin + nearest * direction;
        const Vec normal = (1.0 / hit->radius) * (origin + -1.0 * hit->centre);
        const double cosine = dot(normal, direction);
        const Vec mirrored = direction + -2.0 * cosine * normal;
        if (hit->material == Material::bubble) {
            const auto reflected = [&](double lambda_nm) {
                return bubble_reflectance(std::abs(cosine), 0.5 + 0.5 * normal.y, lambda_nm);
            };
            const double p = 0.3;  // of following the reflection
            const bool reflects = random.next_float() < p;
            multiply([&](double nm) { return reflects ? reflected(nm) / p : (1.0 - reflected(nm)) / (1.0 - p); });
            if (reflects) direction = mirrored;
        } else {
            multiply([&](double lambda_nm) { return reflectance(*hit, origin, lambda_nm); });
            direction = hit->material == Material::mirror ? mirrored : unit(normal + random_on_sphere(random));
        }
    }
    return Spectrum(0.0f);
}

void render_tile(emulsion::FilmTile& tile, const emulsion::FilmOptions& options, int samples_per_pixel) {
    const emulsion::PixelBounds& bounds = tile.bounds();
    const emulsion::FilterSampler filter(options.filter);
    const emulsion::VisibleWavelengthPdf visible;
    Random random(static_cast<std::uint64_t>(bounds.y0));
    for (int y = bounds.y0; y < bounds.y1; ++y) {
        for (int x = bounds.x0; x < bounds.x1; ++x) {
            for (int s = 0; s < samples_per_pixel; ++s) {
                const emulsion::FilterSample place = filter.sample(random.next_float(), random.next_float());
                const Wavelengths wavelengths = emulsion::hero_wavelengths<4>(visible, random.next_float());
                const double right = (x + 0.5 + place.x_offset_px - 0.5 * options.width_px) / options.height_px;
                const double down = (y + 0.5 + place.y_offset_px - 0.5 * options.height_px) / options.height_px;
                const Spectrum radiance = trace({0, 1.6, -7}, unit({right, -0.05 - down, 1.2}), wavelengths, random);
                tile.add(x, y, wavelengths, radiance, place.weight);
            }
        }
    }
}

int main(int argc, char** argv) try {
    const int samples_per_pixel = argc > 1 ? std::max(1, std::atoi(argv[1])) : 256;
    emulsion::FilmOptions options;
    options.width_px = 640;
    options.height_px = 400;
    options.filter = emulsion::MitchellFilter{};
    emulsion::Film film(options);

    // Each thread fills tiles of its own, eight rows each, and merges them. The picture is the same for any number.
    std::atomic<int> next_row = 0;
    std::vector<std::thread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::thread& thread : threads) {
        thread = std::thread([&] {
            for (int row = next_row.fetch_add(8); row < options.height_px; row = next_row.fetch_add(8)) {
                emulsion::FilmTile tile = film.make_tile({0, row, options.width_px, row + 8});
                render_tile(tile, options, samples_per_pixel);
                film.merge(tile);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();

    const emulsion::Image<emulsion::XYZ> picture = film.xyz_image();  // Y in cd/m^2
    emulsion::write_exr("plug-in.exr", picture, {});
    emulsion::write_png("plug-in.png", emulsion::develop(picture, emulsion::Pipeline{}, 0).image);
    std::cout << film.sample_count() << " samples, " << film.dropped().count() << " kept out\n";
} catch (const std::exception& error) {
    std::cerr << "plug_in: " << error.what() << '\n';
    return 1;
}
