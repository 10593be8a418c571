// The C interface: a film's picture.

#include <array>
#include <cstddef>
#include <span>

#include "capi/emulsion.h"
#include "capi/handles.h"
#include "capi/pixel_numbers.h"
#include "capi/status.h"
#include "core/color.h"
#include "core/image.h"
#include "core/matrix3.h"
#include "film/film.h"
#include "spectrum/rgb_space.h"

namespace {

using emulsion::Image;
using emulsion::XYZ;
using emulsion::capi::dereference;
using emulsion::capi::guarded;
using emulsion::capi::pixel_numbers;

}  // namespace

emulsion_status emulsion_film_read_xyz(const emulsion_film* film, float* xyz, size_t length) {
    return guarded([&] {
        const emulsion::Film& from = dereference(film, "film").film;
        const std::span<float> to = pixel_numbers(xyz, length, from, 3, "xyz");
        const Image<XYZ> image = from.xyz_image();
        std::size_t i = 0;
        for (const XYZ& pixel : image.pixels()) {
            for (const float channel : {pixel.x, pixel.y, pixel.z}) to[i++] = channel;
        }
    });
}

emulsion_status emulsion_film_read_rgb(const emulsion_film* film, const char* space, float* rgb, size_t length) {
    return guarded([&] {
        const emulsion::Film& from = dereference(film, "film").film;
        const std::span<float> to = pixel_numbers(rgb, length, from, 3, "rgb");
        const emulsion::Matrix3 matrix = rgb_from_xyz(emulsion::rgb_space(&dereference(space, "space")));
        const Image<XYZ> image = from.xyz_image();
        std::size_t i = 0;
        for (const XYZ& pixel : image.pixels()) {
            const std::array<double, 3> xyz = {static_cast<double>(pixel.x), static_cast<double>(pixel.y),
                                               static_cast<double>(pixel.z)};
            for (const double channel : matrix* xyz) to[i++] = static_cast<float>(channel);
        }
    });
}
