/* The C interface as a C renderer sees it: compiled as C99, without anything of C++, in the build and, against the
 * installed package, by pkg-config. Takes the name of an EXR to write. */
#include <emulsion.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition)                                                                                           \
    do {                                                                                                           \
        if (!(condition)) {                                                                                        \
            fprintf(stderr, "line %d: not so: %s; last error: %s\n", __LINE__, #condition, emulsion_last_error()); \
            ++failures;                                                                                            \
        }                                                                                                          \
    } while (0)

/* The call must be refused with that status and a message that has that text in it. */
#define CHECK_REFUSED(call, expected, text)                   \
    do {                                                      \
        CHECK((call) == (expected));                          \
        CHECK(strstr(emulsion_last_error(), (text)) != NULL); \
    } while (0)

enum { WIDTH = 8, HEIGHT = 6, PIXELS = WIDTH * HEIGHT };

static emulsion_film* new_film(void) {
    emulsion_film_options options;
    emulsion_film* film = NULL;
    CHECK(emulsion_film_options_init(&options, sizeof options) == EMULSION_OK);
    CHECK(options.size == sizeof options && options.width_px == 1280 && options.iso == 100.0);
    options.width_px = WIDTH;
    options.height_px = HEIGHT;
    CHECK(emulsion_film_create(&options, &film) == EMULSION_OK);
    return film;
}

static emulsion_tile* new_tile(const emulsion_film* film) {
    emulsion_rect all;
    emulsion_tile* tile = NULL;
    CHECK(emulsion_film_bounds(film, &all) == EMULSION_OK);
    CHECK(all.x0 == 0 && all.y0 == 0 && all.x1 == WIDTH && all.y1 == HEIGHT);
    CHECK(emulsion_tile_create(film, all, &tile) == EMULSION_OK);
    CHECK(emulsion_tile_bounds(tile, &all) == EMULSION_OK && all.x1 == WIDTH && all.y1 == HEIGHT);
    return tile;
}

static void test_samples(void) {
    emulsion_film* film = new_film();
    emulsion_tile* tile = new_tile(film);
    const int32_t x[] = {1, 1, 2}, y[] = {3, 3, 5};
    const float xyz[] = {1, 2, 3, 5, 6, 7, 4, 4, 4}, rgb[] = {1, 1, 1};
    const float weight[] = {3, 1, 0.5f};
    /* Equal energy at 555 nm, where the eye sees 683 lm/W, from 0.01 W m^-2 sr^-1 nm^-1 over 100 nm: about 683 cd/m^2
     */
    const float lambda_nm[] = {555}, radiance[] = {0.01f}, pdf_per_nm[] = {0.01f};
    float pixels[3 * PIXELS];
    uint64_t count = 0;

    CHECK(emulsion_tile_add_xyz(tile, 3, x, y, weight, xyz) == EMULSION_OK);
    CHECK(emulsion_tile_add_rgb(tile, 1, &x[2], &y[0], NULL, "srgb", rgb) == EMULSION_OK);
    CHECK(emulsion_tile_add_spectral(tile, 1, &y[2], &y[2], NULL, 1, lambda_nm, radiance, pdf_per_nm) == EMULSION_OK);
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_sample_count(film, &count) == EMULSION_OK && count == 5);
    CHECK(emulsion_film_pixels_without_value(film, &count) == EMULSION_OK && count == PIXELS - 4);
    CHECK(emulsion_film_saturated_pixels(film, &count) == EMULSION_OK && count == 0);

    CHECK(emulsion_film_read_xyz(film, pixels, 3 * PIXELS) == EMULSION_OK);
    CHECK(pixels[3 * (3 * WIDTH + 1)] == 2.0f && pixels[3 * (3 * WIDTH + 1) + 1] == 3.0f);
    CHECK(pixels[3 * (5 * WIDTH + 2) + 2] == 4.0f);
    CHECK(fabs(pixels[3 * (5 * WIDTH + 5) + 1] - 683.0) < 1.0);
    CHECK(emulsion_film_read_rgb(film, "sRGB", pixels, 3 * PIXELS) == EMULSION_OK);
    CHECK(fabs(pixels[3 * (3 * WIDTH + 2)] - 1.0) < 1e-6 && fabs(pixels[3 * (3 * WIDTH + 2) + 2] - 1.0) < 1e-6);

    /* A tile that was cleared adds nothing. */
    CHECK(emulsion_tile_clear(tile) == EMULSION_OK);
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_sample_count(film, &count) == EMULSION_OK && count == 5);
    CHECK(emulsion_tile_destroy(tile) == EMULSION_OK);
    CHECK(emulsion_film_destroy(film) == EMULSION_OK);
}

static void test_dropped_samples(void) {
    emulsion_film* film = new_film();
    emulsion_tile* tile = new_tile(film);
    const int32_t at[] = {0, 1, 2, 3};
    const float xyz[] = {NAN, 1, 1, 1, INFINITY, 1, 1, -1, 1, 1, 1, 1};
    const float lambda_nm[] = {NAN}, one[] = {1}, faint[] = {0, 1e-20f, 0, 0, 0, 0};
    uint64_t count = 9;
    CHECK(emulsion_tile_add_xyz(tile, 4, at, at, NULL, xyz) == EMULSION_OK);
    CHECK(emulsion_tile_add_spectral(tile, 1, at, at, NULL, 1, lambda_nm, one, one) == EMULSION_OK);
    CHECK(emulsion_film_dropped_count(film, EMULSION_DROPPED_NAN, &count) == EMULSION_OK && count == 0);
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_dropped_count(film, EMULSION_DROPPED_NAN, &count) == EMULSION_OK && count == 2);
    CHECK(emulsion_film_dropped_count(film, EMULSION_DROPPED_INFINITE, &count) == EMULSION_OK && count == 1);
    CHECK(emulsion_film_dropped_count(film, EMULSION_DROPPED_NEGATIVE_LUMINANCE, &count) == EMULSION_OK && count == 1);
    CHECK_REFUSED(emulsion_film_dropped_count(film, 3, &count), EMULSION_INVALID_ARGUMENT, "kind is 3");
    CHECK_REFUSED(emulsion_film_dropped_count(film, -1, &count), EMULSION_INVALID_ARGUMENT, "kind is -1");
    CHECK(emulsion_film_sample_count(film, &count) == EMULSION_OK && count == 1);
    CHECK(emulsion_film_faint_count(film, &count) == EMULSION_OK && count == 0);
    CHECK(emulsion_tile_add_xyz(tile, 2, at, at, NULL, faint) == EMULSION_OK);
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_faint_count(film, &count) == EMULSION_OK && count == 1);
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}

/* Whatever is wrong with a batch, nothing of it is added. */
static void test_refused_batches(void) {
    emulsion_film* film = new_film();
    emulsion_tile* tile = new_tile(film);
    const int32_t x[] = {0, 1, WIDTH, -1}, y[] = {0, 0, 0, 0}, far[] = {0, 1, 2147483647, -2147483647 - 1};
    const float xyz[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, lambda_nm[] = {500, 600, 500, 600};
    uint64_t count = 9;
    CHECK_REFUSED(emulsion_tile_add_xyz(tile, 4, x, y, NULL, xyz), EMULSION_INVALID_ARGUMENT,
                  "sample 2 is at pixel (8, 0)");
    CHECK_REFUSED(emulsion_tile_add_xyz(tile, 4, y, far, NULL, xyz), EMULSION_INVALID_ARGUMENT, "sample 2 is at");
    CHECK_REFUSED(emulsion_tile_add_rgb(tile, 1, &x[3], y, NULL, "sRGB", xyz), EMULSION_INVALID_ARGUMENT,
                  "sample 0 is at pixel (-1, 0)");
    CHECK_REFUSED(emulsion_tile_add_rgb(tile, 1, x, y, NULL, "no such space", xyz), EMULSION_INVALID_ARGUMENT,
                  "no such space");
    CHECK_REFUSED(emulsion_tile_add_spectral(tile, 1, x, y, NULL, 0, lambda_nm, xyz, xyz), EMULSION_INVALID_ARGUMENT,
                  "wavelengths is 0");
    CHECK_REFUSED(emulsion_tile_add_spectral(tile, 1, x, y, NULL, EMULSION_MAX_WAVELENGTHS + 1, lambda_nm, xyz, xyz),
                  EMULSION_INVALID_ARGUMENT, "wavelengths is 257");
    CHECK_REFUSED(emulsion_tile_add_spectral(tile, (size_t)-1, x, y, NULL, 4, lambda_nm, xyz, xyz),
                  EMULSION_INVALID_ARGUMENT, "more than memory can hold");
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_sample_count(film, &count) == EMULSION_OK && count == 0);

    /* An empty batch is none. */
    CHECK(emulsion_tile_add_xyz(tile, 0, NULL, NULL, NULL, NULL) == EMULSION_OK);
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}

static void test_options(void) {
    emulsion_film_options options;
    emulsion_exr_options exr;
    emulsion_film* film = NULL;
    const struct {
        size_t size;
        int32_t width_px, height_px;
    } old = {sizeof old, 3, 2}; /* as if from the time before there were other fields */
    emulsion_rect bounds;

    CHECK_REFUSED(emulsion_film_options_init(&options, sizeof options + 1), EMULSION_INVALID_ARGUMENT, "size is");
    CHECK_REFUSED(emulsion_exr_options_init(&exr, 0), EMULSION_INVALID_ARGUMENT, "size is 0");
    CHECK(emulsion_film_options_init(&options, sizeof options) == EMULSION_OK);
    options.width_px = 0;
    CHECK_REFUSED(emulsion_film_create(&options, &film), EMULSION_INVALID_ARGUMENT, "width_px is 0");
    options.width_px = 1;
    options.observer = "Polyphemus";
    CHECK_REFUSED(emulsion_film_create(&options, &film), EMULSION_INVALID_ARGUMENT, "Polyphemus");
    options.observer = NULL;
    CHECK_REFUSED(emulsion_film_create(&options, &film), EMULSION_INVALID_ARGUMENT, "observer is NULL");
    options.size = 0;
    CHECK_REFUSED(emulsion_film_create(&options, &film), EMULSION_INVALID_ARGUMENT, "size is 0");
    CHECK(film == NULL);

    CHECK(emulsion_film_create((const emulsion_film_options*)&old, &film) == EMULSION_OK);
    CHECK(emulsion_film_bounds(film, &bounds) == EMULSION_OK && bounds.x1 == 3 && bounds.y1 == 2);
    emulsion_film_destroy(film);
}

static void test_null(void) {
    emulsion_film* film = new_film();
    emulsion_tile* tile = new_tile(film);
    emulsion_film* no_film = NULL;
    emulsion_tile* no_tile = NULL;
    const emulsion_rect one = {0, 0, 1, 1}, outside = {0, 0, WIDTH + 1, 1};
    const int32_t zero[] = {0};
    const float numbers[] = {500, 500, 500};
    float pixels[3 * PIXELS];
    uint64_t count = 0;
    emulsion_rect bounds;

#define CHECK_NULL(call, name) CHECK_REFUSED(call, EMULSION_INVALID_ARGUMENT, name " is NULL")
    CHECK_NULL(emulsion_film_options_init(NULL, 8), "options");
    CHECK_NULL(emulsion_exr_options_init(NULL, 8), "options");
    CHECK_NULL(emulsion_film_create(NULL, &no_film), "options");
    CHECK_NULL(emulsion_film_create(NULL, NULL), "film");
    CHECK_NULL(emulsion_film_bounds(NULL, &bounds), "film");
    CHECK_NULL(emulsion_film_bounds(film, NULL), "bounds");
    CHECK_NULL(emulsion_film_merge_tile(NULL, tile), "film");
    CHECK_NULL(emulsion_film_merge_tile(film, NULL), "tile");
    CHECK_NULL(emulsion_tile_create(NULL, one, &no_tile), "film");
    CHECK_NULL(emulsion_tile_create(film, one, NULL), "tile");
    CHECK_REFUSED(emulsion_tile_create(film, outside, &no_tile), EMULSION_INVALID_ARGUMENT, "bounds are");
    CHECK(no_tile == NULL && no_film == NULL);
    CHECK_NULL(emulsion_tile_clear(NULL), "tile");
    CHECK_NULL(emulsion_tile_bounds(NULL, &bounds), "tile");
    CHECK_NULL(emulsion_tile_bounds(tile, NULL), "bounds");
    CHECK_NULL(emulsion_tile_add_spectral(NULL, 1, zero, zero, NULL, 1, numbers, numbers, numbers), "tile");
    CHECK_NULL(emulsion_tile_add_spectral(tile, 1, NULL, zero, NULL, 1, numbers, numbers, numbers), "x_px");
    CHECK_NULL(emulsion_tile_add_spectral(tile, 1, zero, NULL, NULL, 1, numbers, numbers, numbers), "y_px");
    CHECK_NULL(emulsion_tile_add_spectral(tile, 1, zero, zero, NULL, 1, NULL, numbers, numbers), "lambda_nm");
    CHECK_NULL(emulsion_tile_add_spectral(tile, 1, zero, zero, NULL, 1, numbers, NULL, numbers), "radiance");
    CHECK_NULL(emulsion_tile_add_spectral(tile, 1, zero, zero, NULL, 1, numbers, numbers, NULL), "pdf_per_nm");
    CHECK_NULL(emulsion_tile_add_xyz(NULL, 1, zero, zero, NULL, numbers), "tile");
    CHECK_NULL(emulsion_tile_add_xyz(tile, 1, zero, zero, NULL, NULL), "xyz");
    CHECK_NULL(emulsion_tile_add_rgb(NULL, 1, zero, zero, NULL, "sRGB", numbers), "tile");
    CHECK_NULL(emulsion_tile_add_rgb(tile, 1, zero, zero, NULL, NULL, numbers), "space");
    CHECK_NULL(emulsion_tile_add_rgb(tile, 1, zero, zero, NULL, "sRGB", NULL), "rgb");
    CHECK_NULL(emulsion_film_sample_count(NULL, &count), "film");
    CHECK_NULL(emulsion_film_sample_count(film, NULL), "count");
    CHECK_NULL(emulsion_film_dropped_count(NULL, 0, &count), "film");
    CHECK_NULL(emulsion_film_dropped_count(film, 0, NULL), "count");
    CHECK_NULL(emulsion_film_faint_count(NULL, &count), "film");
    CHECK_NULL(emulsion_film_faint_count(film, NULL), "count");
    CHECK_NULL(emulsion_film_pixels_without_value(NULL, &count), "film");
    CHECK_NULL(emulsion_film_pixels_without_value(film, NULL), "count");
    CHECK_NULL(emulsion_film_saturated_pixels(NULL, &count), "film");
    CHECK_NULL(emulsion_film_saturated_pixels(film, NULL), "count");
    CHECK_NULL(emulsion_film_read_xyz(NULL, pixels, 3 * PIXELS), "film");
    CHECK_NULL(emulsion_film_read_xyz(film, NULL, 3 * PIXELS), "xyz");
    CHECK_REFUSED(emulsion_film_read_xyz(film, pixels, PIXELS), EMULSION_INVALID_ARGUMENT, "expected 144");
    CHECK_NULL(emulsion_film_read_rgb(NULL, "sRGB", pixels, 3 * PIXELS), "film");
    CHECK_NULL(emulsion_film_read_rgb(film, NULL, pixels, 3 * PIXELS), "space");
    CHECK_NULL(emulsion_film_read_rgb(film, "sRGB", NULL, 3 * PIXELS), "rgb");
    CHECK_NULL(emulsion_film_write_exr(NULL, "no.exr", NULL, NULL), "film");
    CHECK_NULL(emulsion_film_write_exr(film, NULL, NULL, NULL), "path");
    CHECK(emulsion_tile_destroy(NULL) == EMULSION_OK);
    CHECK(emulsion_film_destroy(NULL) == EMULSION_OK);
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}

static void test_exr(const char* path) {
    emulsion_film* film = new_film();
    emulsion_tile* tile = new_tile(film);
    emulsion_exr_options options;
    const int32_t at[] = {2};
    const float xyz[] = {1e6f, 1e6f, 1e6f};
    uint64_t lost = 9;

    CHECK(emulsion_tile_add_xyz(tile, 1, at, at, NULL, xyz) == EMULSION_OK);
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_write_exr(film, path, NULL, &lost) == EMULSION_OK && lost == 0);

    CHECK(emulsion_exr_options_init(&options, sizeof options) == EMULSION_OK);
    options.space = "Rec. 709";
    CHECK_REFUSED(emulsion_film_write_exr(film, path, &options, NULL), EMULSION_INVALID_ARGUMENT, "Rec. 709");
    options.space = "Rec709";
    options.compression = "gzip";
    CHECK_REFUSED(emulsion_film_write_exr(film, path, &options, NULL), EMULSION_INVALID_ARGUMENT, "gzip");
    options.compression = "none";
    options.pixel_type = 7;
    CHECK_REFUSED(emulsion_film_write_exr(film, path, &options, NULL), EMULSION_INVALID_ARGUMENT, "pixel_type is 7");
    options.pixel_type = EMULSION_HALF;
    options.renderer_version = "c99_test 1";
    CHECK(emulsion_film_write_exr(film, path, &options, &lost) == EMULSION_OK && lost == 3);
    CHECK_REFUSED(emulsion_film_write_exr(film, "/no such folder/picture.exr", NULL, NULL), EMULSION_IO_ERROR,
                  "/no such folder/picture.exr");
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}

static void test_filters_crops_and_light(void) {
    emulsion_film_options options;
    emulsion_film *film = NULL, *other = NULL;
    emulsion_tile *tile = NULL, *sampled_tile = NULL;
    emulsion_rect places, bounds;
    const emulsion_rect crop = {2, 1, 6, 5};
    const float x_px[] = {3.5f, 4.25f}, y_px[] = {2.5f, 3.75f}, far[] = {3.5f, 100.0f}, bad[] = {3.5f, NAN};
    const float xyz[] = {2, 2, 2, 2, 2, 2}, lambda_nm[] = {555, 555}, radiance[] = {0.01f, 0.01f},
                pdf[] = {0.01f, 0.01f};
    const int32_t pixel[] = {3};
    float pixels[3 * 16];
    uint64_t count = 0;

    emulsion_film_options_init(&options, sizeof options);
    options.width_px = WIDTH;
    options.height_px = HEIGHT;
    options.crop = crop;
    options.filter = "gaussian:x-radius=2,y-radius=2";
    options.filter_use = 7;
    CHECK_REFUSED(emulsion_film_create(&options, &film), EMULSION_INVALID_ARGUMENT, "filter_use is 7");
    options.filter_use = EMULSION_SPLATTED;
    options.light_splats = -1;
    CHECK_REFUSED(emulsion_film_create(&options, &film), EMULSION_INVALID_ARGUMENT, "light_splats is -1");
    options.light_splats = 1;
    options.filter = "sponge";
    CHECK_REFUSED(emulsion_film_create(&options, &film), EMULSION_INVALID_ARGUMENT, "sponge");
    options.filter = NULL;
    CHECK_REFUSED(emulsion_film_create(&options, &film), EMULSION_INVALID_ARGUMENT, "filter is NULL");
    options.filter = "gaussian:x-radius=2,y-radius=2";
    options.crop.x1 = WIDTH + 1;
    CHECK_REFUSED(emulsion_film_create(&options, &film), EMULSION_INVALID_ARGUMENT, "crop is");
    options.crop.x1 = 6;
    CHECK(emulsion_film_create(&options, &film) == EMULSION_OK);
    CHECK(emulsion_film_create(&options, &other) == EMULSION_OK);

    CHECK(emulsion_film_bounds(film, &bounds) == EMULSION_OK && bounds.x0 == 2 && bounds.y1 == 5);
    CHECK(emulsion_film_sample_bounds(film, &places) == EMULSION_OK && places.x0 < 2 && places.y1 > 5);
    CHECK(emulsion_tile_create(film, places, &tile) == EMULSION_OK);
    CHECK(emulsion_tile_bounds(tile, &bounds) == EMULSION_OK && bounds.x0 == 2 && bounds.y1 == 5);

    /* Camera samples with places: the same value everywhere is that value. */
    CHECK(emulsion_tile_add_at_xyz(tile, 2, x_px, y_px, xyz) == EMULSION_OK);
    CHECK_REFUSED(emulsion_tile_add_at_xyz(tile, 2, far, y_px, xyz), EMULSION_INVALID_ARGUMENT, "sample 1 is at (100");
    CHECK_REFUSED(emulsion_tile_add_at_xyz(tile, 2, bad, y_px, xyz), EMULSION_INVALID_ARGUMENT, "sample 1 is at (nan");
    CHECK_REFUSED(emulsion_tile_add_xyz(tile, 1, pixel, pixel, NULL, xyz), EMULSION_INVALID_ARGUMENT, "splatted");
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_read_xyz(film, pixels, 3 * 16) == EMULSION_OK);
    CHECK(fabs(pixels[3 * (1 * 4 + 1)] - 2.0) < 1e-6 && fabs(pixels[3 * (2 * 4 + 2) + 1] - 2.0) < 1e-6);
    CHECK(emulsion_tile_add_at_spectral(tile, 2, x_px, y_px, 1, lambda_nm, radiance, pdf) == EMULSION_OK);
    CHECK(emulsion_tile_add_at_rgb(tile, 2, x_px, y_px, "sRGB", xyz) == EMULSION_OK);

    /* Light: nothing can be shown before the number of paths is known. */
    CHECK(emulsion_tile_clear(tile) == EMULSION_OK);
    CHECK(emulsion_tile_splat_xyz(tile, 2, far, y_px, xyz) == EMULSION_OK); /* the second one misses */
    CHECK(emulsion_tile_splat_spectral(tile, 2, x_px, y_px, 1, lambda_nm, radiance, pdf) == EMULSION_OK);
    CHECK_REFUSED(emulsion_tile_splat_xyz(tile, 2, bad, y_px, xyz), EMULSION_INVALID_ARGUMENT, "sample 1 is at (nan");
    CHECK(emulsion_film_merge_tile(other, tile) == EMULSION_OK);
    CHECK_REFUSED(emulsion_film_read_xyz(other, pixels, 3 * 16), EMULSION_INVALID_ARGUMENT, "light paths");
    CHECK(emulsion_film_add_light_paths(other, 4) == EMULSION_OK);
    CHECK(emulsion_film_read_xyz(other, pixels, 3 * 16) == EMULSION_OK && pixels[3 * (1 * 4 + 1) + 1] > 0.0f);

    /* Films: of the same options, and not the same one. */
    CHECK(emulsion_film_merge_film(film, other) == EMULSION_OK);
    CHECK(emulsion_film_sample_count(film, &count) == EMULSION_OK && count == 2);
    CHECK_REFUSED(emulsion_film_merge_film(film, film), EMULSION_INVALID_ARGUMENT, "itself");
    CHECK_REFUSED(emulsion_film_merge_film(film, NULL), EMULSION_INVALID_ARGUMENT, "other is NULL");
    CHECK_REFUSED(emulsion_film_merge_film(NULL, film), EMULSION_INVALID_ARGUMENT, "film is NULL");
    CHECK_REFUSED(emulsion_film_add_light_paths(NULL, 1), EMULSION_INVALID_ARGUMENT, "film is NULL");
    CHECK_REFUSED(emulsion_film_sample_bounds(NULL, &places), EMULSION_INVALID_ARGUMENT, "film is NULL");
    CHECK_REFUSED(emulsion_film_sample_bounds(film, NULL), EMULSION_INVALID_ARGUMENT, "bounds is NULL");
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(other);

    /* A film that splats nothing takes none of these. */
    other = new_film();
    CHECK_REFUSED(emulsion_film_merge_film(film, other), EMULSION_INVALID_ARGUMENT, "other options");
    sampled_tile = new_tile(other);
    CHECK_REFUSED(emulsion_tile_add_at_xyz(sampled_tile, 1, x_px, y_px, xyz), EMULSION_INVALID_ARGUMENT, "filter_use");
    CHECK_REFUSED(emulsion_tile_splat_xyz(sampled_tile, 1, x_px, y_px, xyz), EMULSION_INVALID_ARGUMENT, "light_splats");
    CHECK_REFUSED(emulsion_tile_splat_xyz(NULL, 1, x_px, y_px, xyz), EMULSION_INVALID_ARGUMENT, "tile is NULL");
    CHECK_REFUSED(emulsion_tile_add_at_xyz(NULL, 1, x_px, y_px, xyz), EMULSION_INVALID_ARGUMENT, "tile is NULL");
    emulsion_tile_destroy(sampled_tile);
    emulsion_film_destroy(other);
    emulsion_film_destroy(film);
}

/* What README.md shows. */
static void test_readme(const char* path) {
    enum { count = 2 };
    const int32_t x_px[count] = {0, 639}, y_px[count] = {0, 15};
    float lambda_nm[4 * count], radiance[4 * count], pdf_per_nm[4 * count];
    int i;
    for (i = 0; i < 4 * count; ++i) {
        lambda_nm[i] = 400.0f + 40.0f * (float)i;
        radiance[i] = 1.0f;
        pdf_per_nm[i] = 1.0f / 470.0f;
    }
    CHECK(remove(path) == 0);
    emulsion_film_options options;
    emulsion_film* film = NULL;
    emulsion_tile* tile = NULL;
    emulsion_film_options_init(&options, sizeof options);
    options.width_px = 640;
    options.height_px = 480;
    if (emulsion_film_create(&options, &film) != EMULSION_OK) puts(emulsion_last_error());
    emulsion_tile_create(film, (emulsion_rect){0, 0, 640, 16}, &tile);
    emulsion_tile_add_spectral(tile, count, x_px, y_px, NULL, 4, lambda_nm, radiance, pdf_per_nm);
    emulsion_film_merge_tile(film, tile);
    emulsion_tile_destroy(tile);
    emulsion_film_write_exr(film, path, NULL, NULL);
    emulsion_film_destroy(film);
    CHECK(remove(path) == 0);
}

int main(int argc, char** argv) {
    if (argc != 2) {
        fprintf(stderr, "expected the name of an EXR to write\n");
        return 2;
    }
    CHECK(strcmp(emulsion_last_error(), "") == 0);
    CHECK(strchr(emulsion_version(), '.') != NULL);
    test_samples();
    test_dropped_samples();
    test_refused_batches();
    test_options();
    test_filters_crops_and_light();
    test_null();
    test_exr(argv[1]);
    test_readme(argv[1]);
    return failures == 0 ? 0 : 1;
}
