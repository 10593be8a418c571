// A renderer that hands its samples to Emulsion's film: soap bubbles on a checkered floor, four wavelengths a path.
// Usage: plug_in [SAMPLES PER PIXEL]; writes plug-in.exr and plug-in.png.

#include <algorithm>
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
#include <emulsion/film/filter_sampler.h>
#include <emulsion/spectrum/wavelength_sampling.h>

using Wavelengths = emulsion::SampledWavelengths<4>;
using Spectrum = emulsion::SampledSpectrum<4>;
using Vec = emulsion::XYZd;  // three doubles
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec unit(Vec a) { return (1.0 / std::sqrt(dot(a, a))) * a; }

enum class Material { matte, mirror, bubble };
struct Sphere {
    Vec centre;
    double radius, peak_nm;  // peak of its reflectance
    Material material;
};
const std::vector<Sphere> kSpheres = {
    {{0, -1000, 0}, 1000, 0, Material::matte},    {{-2.1, 0.8, 0.3}, 0.8, 640, Material::matte},
    {{2.3, 0.7, 0.2}, 0.7, 455, Material::matte}, {{0.9, 0.5, -1.7}, 0.5, 620, Material::mirror},
    {{0.1, 1.5, 0.6}, 1.4, 0, Material::bubble},  {{-1.0, 0.6, -1.5}, 0.55, 0, Material::bubble},
    {{1.9, 2.2, 0.9}, 0.5, 0, Material::bubble},  {{-1.9, 2.5, 1.2}, 0.45, 0, Material::bubble}};

double reflectance(const Sphere& sphere, Vec point, double lambda_nm) {
    if (&sphere == &kSpheres[0]) return std::sin(3.1416 * point.x) * std::sin(3.1416 * point.z) > 0.0 ? 0.75 : 0.3;
    const double offset = (lambda_nm - sphere.peak_nm) / (sphere.material == Material::mirror ? 150.0 : 45.0);
    return 0.08 + 0.8 * std::exp(-offset * offset);
}

// Two reflections, from the front and the back of a film of water that is thicker further down, interfere.
double bubble_reflectance(double cosine, double height, double lambda_nm) {
    const double thickness_nm = 400.0 - 150.0 * height, n = 1.33;
    const double cos_inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (n * n));
    const double r = (cosine - n * cos_inside) / (cosine + n * cos_inside);
    const double s = std::sin(6.2831853 * n * thickness_nm * cos_inside / lambda_nm);
    return std::min(1.0, 4.0 * r * r * s * s);
}

// Radiance in W m^-2 sr^-1 nm^-1: a blue sky that pales towards the horizon, and a large, warm sun.
double sky(Vec direction, double lambda_nm) {
    const double bluish = 560.0 / lambda_nm, up = std::max(direction.y, 0.0);
    const double sun = dot(direction, unit({-0.5, 0.7, -0.6})) > 0.95 ? 1.2 * lambda_nm / 560.0 : 0.0;
    return 0.03 * std::pow(bluish, 4.0) * (0.4 + up) + 0.04 * bluish * std::pow(1.0 - up, 8.0) + sun;
}

Vec random_on_sphere(emulsion::Pcg32& random) {
    const double z = 1.0 - 2.0 * random.next_float(), r = std::sqrt(1.0 - z * z), phi = 6.2831853 * random.next_float();
    return {r * std::cos(phi), r * std::sin(phi), z};
}

Spectrum trace(Vec origin, Vec direction, const Wavelengths& wavelengths, emulsion::Pcg32& random) {
    Spectrum path(1.0f);
    const auto multiply = [&](auto&& factor) {
        for (int i = 0; i < 4; ++i) path[i] *= static_cast<float>(factor(wavelengths.lambda_nm[i]));
        return path;
    };
    for (int bounce = 0; bounce < 12; ++bounce) {
        const Sphere* hit = nullptr;
        double nearest = 1e9;
        for (const Sphere& sphere : kSpheres) {
            const Vec to = origin - sphere.centre;
            const double b = dot(to, direction), root = std::sqrt(b * b - dot(to, to) + sphere.radius * sphere.radius);
            for (const double t : {-b - root, -b + root}) {  // NaN where the ray misses
                if (t > 1e-4 && t < nearest) nearest = t, hit = &sphere;
            }
        }
        if (hit == nullptr) return multiply([&](double lambda_nm) { return sky(direction, lambda_nm); });
        origin = origin + nearest * direction;
        const Vec normal = (1.0 / hit->radius) * (origin - hit->centre);
        const double cosine = dot(normal, direction);
        const Vec mirrored = direction - 2.0 * cosine * normal;
        if (hit->material != Material::bubble) {
            multiply([&](double lambda_nm) { return reflectance(*hit, origin, lambda_nm); });
            direction = hit->material == Material::mirror ? mirrored : unit(normal + random_on_sphere(random));
            continue;
        }
        const bool reflects = random.next_float() < 0.3f;
        multiply([&](double lambda_nm) {
            const double reflected = bubble_reflectance(std::abs(cosine), normal.y, lambda_nm);
            return reflects ? reflected / 0.3 : (1.0 - reflected) / 0.7;
        });
        if (reflects) direction = mirrored;
    }
    return Spectrum(0.0f);
}

void render_tile(emulsion::FilmTile& tile, const emulsion::FilmOptions& options, int samples_per_pixel) {
    const emulsion::PixelBounds& bounds = tile.bounds();
    const emulsion::FilterSampler filter(options.filter);
    const emulsion::VisibleWavelengthPdf visible;
    emulsion::Pcg32 random(static_cast<std::uint64_t>(bounds.y0));
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

int main(int argc, char** argv) {
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
}
