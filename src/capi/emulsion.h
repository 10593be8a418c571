/* Emulsion's film for renderers in C, or in any language that can call C.
 *
 *     emulsion_film_options options;
 *     emulsion_film_options_init(&options, sizeof options);
 *     options.width_px = 640;  options.height_px = 480;
 *     emulsion_film* film = NULL;
 *     if (emulsion_film_create(&options, &film) != EMULSION_OK) puts(emulsion_last_error());
 *     each thread:  emulsion_tile_create, then for each batch of samples emulsion_tile_add_spectral, then
 *                   emulsion_film_merge_tile, emulsion_tile_destroy
 *     emulsion_film_write_exr(film, "picture.exr", NULL, NULL);
 *     emulsion_film_destroy(film);
 *
 * Units: wavelengths in nm, densities in 1/nm, radiance in W m^-2 sr^-1 nm^-1. The film holds CIE XYZ with Y in cd/m^2
 * times the imaging ratio exposure_time_s * iso / 100, which is 1 by default: "the film's units" below. Pixels are
 * counted from 0 at the top left; pictures are rows from the top, without padding.
 *
 * Threads: a tile belongs to one thread at a time, and nothing of it is locked. Everything about films may be called
 * from any thread at any time, but for their destruction. The picture is the same, bit for bit, for every order of
 * samples and merges, every number of threads and every size of tiles.
 *
 * Errors: every function returns a status, and on failure has changed nothing that it was given; a batch is added whole
 * or not at all. NULL where something is needed is EMULSION_INVALID_ARGUMENT. Samples that are NaN, infinite or of
 * negative luminance are no errors: they are kept out of the film and counted. */
#ifndef EMULSION_H
#define EMULSION_H

/* NOLINTBEGIN(modernize-*,readability-identifier-naming): this is C */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Errors ---- */

typedef enum emulsion_status {
    EMULSION_OK = 0,
    EMULSION_INVALID_ARGUMENT = 1, /* a value out of its range, NULL, an unknown name, a call too early */
    EMULSION_IO_ERROR = 2,         /* a file that can't be written */
    EMULSION_OUT_OF_MEMORY = 3,
    EMULSION_INTERNAL_ERROR = 4
} emulsion_status;

/* What the last call of this thread that failed has to say, in one line of at most 2047 bytes; "" before the first.
 * Valid until the thread's next failure. */
const char* emulsion_last_error(void);

/* "0.2.0" */
const char* emulsion_version(void);

/* ---- Films ---- */

typedef struct emulsion_film emulsion_film;
typedef struct emulsion_tile emulsion_tile;

/* Whole pixels, [x0, x1) x [y0, y1). */
typedef struct emulsion_rect {
    int32_t x0, y0, x1, y1;
} emulsion_rect;

/* How the filter is applied to camera samples. The expected picture is the same. */
typedef enum emulsion_filter_use {
    EMULSION_IMPORTANCE_SAMPLED = 0, /* places are drawn by the filter, and a sample belongs to one pixel: _add_ */
    EMULSION_SPLATTED = 1            /* places are uniform, and a sample goes into all pixels in reach: _add_at_ */
} emulsion_filter_use;

/* What a film gathers for variances and standard errors. */
typedef enum emulsion_variance {
    EMULSION_VARIANCE_NONE = 0,
    EMULSION_VARIANCE_LUMINANCE = 1, /* of Y */
    EMULSION_VARIANCE_XYZ = 2        /* of X, Y and Z, each by itself */
} emulsion_variance;

/* New fields come at the end. Let emulsion_film_options_init set all of them before you set yours. Strings are only
 * read by emulsion_film_create. What is optional costs nothing where it is left out, and is in the EXR where it is not.
 */
typedef struct emulsion_film_options {
    size_t size;                 /* of this struct, as the caller was compiled */
    int32_t width_px;            /* in [1, 65536]; 1280 */
    int32_t height_px;           /* in [1, 65536]; 720 */
    double exposure_time_s;      /* > 0; 1 */
    double iso;                  /* > 0; 100 */
    const char* observer;        /* whose XYZ the film holds; "cie_1931_2deg" */
    emulsion_rect crop;          /* the pixels that there are, in the full frame's coordinates; all 0: the full frame */
    const char* filter;          /* "box", or any other with its parameters: "gaussian:x-radius=2,y-radius=2" */
    int32_t filter_use;          /* an emulsion_filter_use; EMULSION_IMPORTANCE_SAMPLED */
    int32_t light_splats;        /* 1: takes what light tracers send, beside camera samples; 0 */
    int32_t variance;            /* an emulsion_variance; EMULSION_VARIANCE_NONE */
    int32_t spectrum_count;      /* buckets of wavelengths, of equal width; in [1, 1024], or 0: no spectrum; 0 */
    double spectrum_min_nm;      /* in [100, spectrum_max_nm); 380 */
    double spectrum_max_nm;      /* at most 1000; 780 */
    const char* aux;             /* auxiliary layers, each with its components; albedo, normal and depth know theirs:
                                    "albedo,normal,depth,roughness:value,motion:x+y"; "none" */
    const char* firefly_control; /* "clamp:luminance=1000", in cd/m^2 before the imaging ratio: samples are scaled down
                                    to it; or "median-of-means:groups=5", which needs emulsion_tile_set_sample_index.
                                    Biased, as the EXR's header tells; "none" */
} emulsion_film_options;

/* The defaults. size: sizeof(emulsion_film_options). */
emulsion_status emulsion_film_options_init(emulsion_film_options* options, size_t size);

emulsion_status emulsion_film_create(const emulsion_film_options* options, emulsion_film** film);
/* NULL is no error. Tiles of the film may outlive it. */
emulsion_status emulsion_film_destroy(emulsion_film* film);

/* The pixels of the film: the crop window, if there is one. */
emulsion_status emulsion_film_bounds(const emulsion_film* film, emulsion_rect* bounds);
/* The pixels to send samples to: those of the film, and a border more if it splats. */
emulsion_status emulsion_film_sample_bounds(const emulsion_film* film, emulsion_rect* bounds);

/* Adds a tile's sums to the film; the tile is left as it is, and merged twice it counts twice. */
emulsion_status emulsion_film_merge_tile(emulsion_film* film, const emulsion_tile* tile);
/* Adds what another film of the same options has gathered. */
emulsion_status emulsion_film_merge_film(emulsion_film* film, const emulsion_film* other);
/* The number of paths that a light tracer has traced, those that sent nothing among them; adds up. */
emulsion_status emulsion_film_add_light_paths(emulsion_film* film, uint64_t paths);

/* ---- Tiles: rectangles of the film that one thread fills ---- */

/* An empty tile for samples within `places`, inside emulsion_film_sample_bounds. Tiles may overlap, and any number may
 * exist. */
emulsion_status emulsion_tile_create(const emulsion_film* film, emulsion_rect places, emulsion_tile** tile);
/* NULL is no error. */
emulsion_status emulsion_tile_destroy(emulsion_tile* tile);
/* Back to no samples. */
emulsion_status emulsion_tile_clear(emulsion_tile* tile);
/* The pixels that the tile holds. */
emulsion_status emulsion_tile_bounds(const emulsion_tile* tile, emulsion_rect* bounds);

/* The number, in its pixel, of the samples that come next, from 0 on: the groups of median-of-means take turns by it. A
 * batch is then to have one sample of each pixel. For other films it is not needed. 0 in a new or a cleared tile. */
emulsion_status emulsion_tile_set_sample_index(emulsion_tile* tile, uint64_t index);

/* Batches of camera samples: `count` of them, the i-th at the pixel x_px[i], y_px[i], which must be one of the tile's,
 * with weight[i]. For films whose filter_use is EMULSION_IMPORTANCE_SAMPLED. Weights are signed, and of mean 1: those
 * of filter importance sampling, or NULL for 1 each. */

enum { EMULSION_MAX_WAVELENGTHS = 256 };

/* Radiance at `wavelengths` wavelengths a sample, 1 to EMULSION_MAX_WAVELENGTHS; quickest for 1, 2, 4, 8, 16 and 32.
 * lambda_nm, radiance and pdf_per_nm have count * wavelengths numbers, those of one sample side by side. Wavelengths
 * outside [360, 830] carry nothing; pdf_per_nm is the density with which each was drawn, 0 for one that the path has
 * given up. */
emulsion_status emulsion_tile_add_spectral(emulsion_tile* tile, size_t count, const int32_t* x_px, const int32_t* y_px,
                                           const float* weight, size_t wavelengths, const float* lambda_nm,
                                           const float* radiance, const float* pdf_per_nm);

/* xyz: count * 3 numbers, in the film's units. */
emulsion_status emulsion_tile_add_xyz(emulsion_tile* tile, size_t count, const int32_t* x_px, const int32_t* y_px,
                                      const float* weight, const float* xyz);

/* rgb: count * 3 numbers, linear RGB of the space of that name ("sRGB", "Rec2020", "Display_P3", "ACEScg_AP1", ...),
 * where (1, 1, 1) is the space's white at a luminance of 1 cd/m^2; the film's imaging ratio is applied. */
emulsion_status emulsion_tile_add_rgb(emulsion_tile* tile, size_t count, const int32_t* x_px, const int32_t* y_px,
                                      const float* weight, const char* space, const float* rgb);

/* The same for films whose filter_use is EMULSION_SPLATTED: places are in pixels, pixel (x, y) covering [x, x + 1) x
 * [y, y + 1), inside the places of the tile, and uniform. */
emulsion_status emulsion_tile_add_at_spectral(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                              size_t wavelengths, const float* lambda_nm, const float* radiance,
                                              const float* pdf_per_nm);
emulsion_status emulsion_tile_add_at_xyz(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                         const float* xyz);
emulsion_status emulsion_tile_add_at_rgb(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                         const char* space, const float* rgb);

/* What camera samples see of an auxiliary layer, by its name; beside the samples themselves, at their pixels and with
 * their weights, or at their places. values: as many numbers to a sample as the layer has components, those of one
 * sample side by side. Leave samples out that see nothing. Values that are not finite are kept out, and counted. */
emulsion_status emulsion_tile_add_aux(emulsion_tile* tile, size_t count, const int32_t* x_px, const int32_t* y_px,
                                      const float* weight, const char* layer, const float* values);
emulsion_status emulsion_tile_add_aux_at(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                         const char* layer, const float* values);

/* What paths of a light tracer send to places of the film, for films with light_splats. The mean, over paths, of the
 * sum of the values that arrive in a region is the integral of the picture over it, in pixels: values are radiance, or
 * XYZ, times an area in pixels. Places outside the tile are ignored, as most paths miss the film. Tell the film the
 * number of paths: emulsion_film_add_light_paths. */
emulsion_status emulsion_tile_splat_spectral(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                             size_t wavelengths, const float* lambda_nm, const float* radiance,
                                             const float* pdf_per_nm);
emulsion_status emulsion_tile_splat_xyz(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                        const float* xyz);

/* ---- What the film holds, of the tiles merged so far ---- */

/* Samples in all pixels, without the dropped ones. */
emulsion_status emulsion_film_sample_count(const emulsion_film* film, uint64_t* count);

/* Why a sample was kept out. */
typedef enum emulsion_dropped_kind {
    EMULSION_DROPPED_NAN = 0,               /* a NaN among its values or its weight */
    EMULSION_DROPPED_INFINITE = 1,          /* else an infinity */
    EMULSION_DROPPED_NEGATIVE_LUMINANCE = 2 /* else a luminance below 0, before the weight */
} emulsion_dropped_kind;
/* kind: an emulsion_dropped_kind. */
emulsion_status emulsion_film_dropped_count(const emulsion_film* film, int32_t kind, uint64_t* count);

/* Samples of auxiliary layers that were kept out, for a value or a weight that is not finite. */
emulsion_status emulsion_film_dropped_aux_count(const emulsion_film* film, uint64_t* count);
/* Samples that firefly control has scaled down. */
emulsion_status emulsion_film_clamped_count(const emulsion_film* film, uint64_t* count);
/* Samples whose luminance is above 0 and at most half of the resolution of the film's sums, 2.8e-14 in the film's
 * units: they were added, as what they round to. */
emulsion_status emulsion_film_faint_count(const emulsion_film* film, uint64_t* count);

/* Pixels that have no samples, or whose weights cancel: their value is 0. */
emulsion_status emulsion_film_pixels_without_value(const emulsion_film* film, uint64_t* count);
/* Pixels that have left the range of the film's sums: their value is wrong. */
emulsion_status emulsion_film_saturated_pixels(const emulsion_film* film, uint64_t* count);

/* All pixels as X, Y, Z in the film's units. A film with light splats must know its light paths. length: of xyz in
 * floats, 3 * width * height of the film's bounds. */
emulsion_status emulsion_film_read_xyz(const emulsion_film* film, float* xyz, size_t length);
/* All pixels as linear RGB of the space of that name: (1, 1, 1) is its white with Y = 1 in the film's units. */
emulsion_status emulsion_film_read_rgb(const emulsion_film* film, const char* space, float* rgb, size_t length);

/* The layers, for films whose options ask for them. length: of the array, in numbers; so many for each pixel of the
 * film's bounds, those of one pixel side by side. */

/* Samples that reach the pixel, without the dropped ones: 1 number; of every film. */
emulsion_status emulsion_film_read_sample_counts(const emulsion_film* film, uint32_t* counts, size_t length);

/* Of samples under the filter, squares of the film's units: 1 number of EMULSION_VARIANCE_LUMINANCE, Y, or 3 of
 * EMULSION_VARIANCE_XYZ. 0 for pixels of fewer than two samples. */
emulsion_status emulsion_film_read_variance(const emulsion_film* film, float* variance, size_t length);
/* Of the pixel, in the film's units; as many. For samples that are independent: stratified ones do better. Films
 * whose filter has negative lobes take 24 bytes a pixel more for it, or 48 of EMULSION_VARIANCE_XYZ. */
emulsion_status emulsion_film_read_standard_error(const emulsion_film* film, float* standard_error, size_t length);

/* Mean radiance in each bucket, W m^-2 sr^-1 nm^-1, without the imaging ratio; spectrum_count numbers, from
 * spectrum_min_nm on. 0 where no sample has reached a bucket. A film with light splats must know its light paths. */
emulsion_status emulsion_film_read_spectrum(const emulsion_film* film, float* radiance, size_t length);

/* The auxiliary layer of that name, as the weighted mean of the samples that see something of it; as many numbers as it
 * has components. 0 where fewer than one sample in 64 does. */
emulsion_status emulsion_film_read_aux(const emulsion_film* film, const char* layer, float* values, size_t length);

/* ---- Files ---- */

typedef enum emulsion_pixel_type { EMULSION_FLOAT = 0, EMULSION_HALF = 1 } emulsion_pixel_type;

/* New fields come at the end. Let emulsion_exr_options_init set all of them before you set yours. */
typedef struct emulsion_exr_options {
    size_t size;                  /* of this struct, as the caller was compiled */
    const char* space;            /* "xyz", or the name of a linear RGB space; "xyz" */
    int32_t pixel_type;           /* an emulsion_pixel_type; EMULSION_FLOAT */
    const char* compression;      /* "none", "zip", "piz", "dwaa:level=45", ...; "zip" */
    const char* renderer_version; /* your renderer's name and version, for the header; NULL for none */
} emulsion_exr_options;

/* The defaults. size: sizeof(emulsion_exr_options). */
emulsion_status emulsion_exr_options_init(emulsion_exr_options* options, size_t size);

/* Writes a scene-referred EXR; its header's whiteLuminance is what 1 in the film's units stands for, in cd/m^2. Layers
 * that the film has are channels beside the picture: samples, variance.Y, standard-error.Y, albedo.R, S0.550,938nm, ...
 * The file appears whole or not at all. options: NULL for the defaults. lost_values: NULL, or where to put the number
 * of channel values that the file could not hold as they were: halves beyond 65504 are stored as that, those near 0 as
 * 0. */
emulsion_status emulsion_film_write_exr(const emulsion_film* film, const char* path,
                                        const emulsion_exr_options* options, uint64_t* lost_values);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-*,readability-identifier-naming) */

#endif /* EMULSION_H */
