/* Variances, spectra, auxiliary layers, firefly control. */
#include "c99_test.h"

/* Two pixels, and everything but light splats and firefly control. */
static emulsion_film_options all_layers(void) {
    emulsion_film_options options;
    CHECK(emulsion_film_options_init(&options, sizeof options) == EMULSION_OK);
    CHECK(options.variance == EMULSION_VARIANCE_NONE && options.spectrum_count == 0);
    CHECK(options.spectrum_min_nm == 380.0 && options.spectrum_max_nm == 780.0);
    CHECK(strcmp(options.aux, "none") == 0 && strcmp(options.firefly_control, "none") == 0);
    options.width_px = 2;
    options.height_px = 1;
    options.variance = EMULSION_VARIANCE_XYZ;
    options.spectrum_count = 2;
    options.spectrum_min_nm = 400;
    options.spectrum_max_nm = 600;
    options.aux = "depth,motion:x+y";
    return options;
}

static void new_pair(const emulsion_film_options* options, emulsion_film** film, emulsion_tile** tile) {
    emulsion_rect places;
    *film = NULL;
    *tile = NULL;
    CHECK(emulsion_film_create(options, film) == EMULSION_OK);
    CHECK(emulsion_film_bounds(*film, &places) == EMULSION_OK);
    CHECK(emulsion_tile_create(*film, places, tile) == EMULSION_OK);
}

void test_layers(void) {
    emulsion_film_options options = all_layers();
    emulsion_film* film;
    emulsion_tile* tile;
    const int32_t x[] = {1, 1}, y[] = {0, 0};
    const float xyz[] = {1, 2, 3, 3, 6, 9}, depth[] = {5, 9}, weight[] = {1, 3}, motion[] = {-1, 1, -3, 1};
    const float bad[] = {NAN, 4}, lambda_nm[] = {450}, radiance[] = {0.25f}, pdf_per_nm[] = {0.005f};
    float numbers[6];
    uint32_t counts[2];
    uint64_t count = 0;
    new_pair(&options, &film, &tile);

    /* Of 1 and 3 the mean is 2 and the variance 2; that of the mean is half of it. */
    CHECK(emulsion_tile_add_xyz(tile, 2, x, y, NULL, xyz) == EMULSION_OK);
    CHECK(emulsion_tile_add_aux(tile, 2, x, y, weight, "depth", depth) == EMULSION_OK);
    CHECK(emulsion_tile_add_aux(tile, 2, x, y, NULL, "motion", motion) == EMULSION_OK);
    CHECK(emulsion_tile_add_aux(tile, 2, y, y, NULL, "depth", bad) == EMULSION_OK);
    CHECK(emulsion_tile_add_spectral(tile, 1, y, y, NULL, 1, lambda_nm, radiance, pdf_per_nm) == EMULSION_OK);
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_read_variance(film, numbers, 6) == EMULSION_OK);
    CHECK(numbers[0] == 0 && numbers[3] == 2 && numbers[4] == 8 && numbers[5] == 18);
    CHECK(emulsion_film_read_standard_error(film, numbers, 6) == EMULSION_OK);
    CHECK(numbers[2] == 0 && numbers[3] == 1 && numbers[4] == 2 && numbers[5] == 3);
    CHECK(emulsion_film_read_sample_counts(film, counts, 2) == EMULSION_OK && counts[0] == 1 && counts[1] == 2);
    CHECK(emulsion_film_read_aux(film, "depth", numbers, 2) == EMULSION_OK && numbers[0] == 4 && numbers[1] == 8);
    CHECK(emulsion_film_read_aux(film, "motion", numbers, 4) == EMULSION_OK);
    CHECK(numbers[0] == 0 && numbers[2] == -2 && numbers[3] == 1);
    CHECK(emulsion_film_dropped_aux_count(film, &count) == EMULSION_OK && count == 1);
    CHECK(emulsion_film_read_spectrum(film, numbers, 4) == EMULSION_OK);
    CHECK(numbers[0] == 0.25f && numbers[1] == 0 && numbers[2] == 0 && numbers[3] == 0);
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);

    options.variance = EMULSION_VARIANCE_LUMINANCE;
    new_pair(&options, &film, &tile);
    CHECK(emulsion_tile_add_xyz(tile, 2, x, y, NULL, xyz) == EMULSION_OK);
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_read_variance(film, numbers, 2) == EMULSION_OK && numbers[0] == 0 && numbers[1] == 8);
    CHECK(emulsion_film_read_standard_error(film, numbers, 2) == EMULSION_OK && numbers[1] == 2);
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}

void test_splatted_layers(void) {
    emulsion_film_options options = all_layers();
    emulsion_film* film;
    emulsion_tile* tile;
    const float x_px[] = {0.5f}, y_px[] = {0.5f}, xyz[] = {1, 1, 1}, depth[] = {7}, far[] = {9};
    const float lambda_nm[] = {550}, radiance[] = {0.5f}, pdf_per_nm[] = {0.01f};
    const int32_t zero[] = {0};
    float numbers[6] = {9, 9, 9, 9};
    options.filter_use = EMULSION_SPLATTED;
    options.light_splats = 1;
    new_pair(&options, &film, &tile);
    CHECK(emulsion_tile_add_at_xyz(tile, 1, x_px, y_px, xyz) == EMULSION_OK);
    CHECK(emulsion_tile_add_aux_at(tile, 1, x_px, y_px, "depth", depth) == EMULSION_OK);
    CHECK_REFUSED(emulsion_tile_add_aux_at(tile, 1, far, y_px, "depth", depth), EMULSION_INVALID_ARGUMENT,
                  "sample 0 is at (9");
    CHECK_REFUSED(emulsion_tile_add_aux_at(tile, 1, x_px, y_px, "death", depth), EMULSION_INVALID_ARGUMENT, "death");
    CHECK_REFUSED(emulsion_tile_add_aux(tile, 1, zero, zero, NULL, "depth", depth), EMULSION_INVALID_ARGUMENT,
                  "filter_use is splatted");
    CHECK_NULL(emulsion_tile_add_aux_at(tile, 1, NULL, y_px, "depth", depth), "x_px");
    CHECK_NULL(emulsion_tile_add_aux_at(tile, 1, x_px, NULL, "depth", depth), "y_px");
    CHECK_NULL(emulsion_tile_add_aux_at(tile, 1, x_px, y_px, NULL, depth), "layer");
    CHECK_NULL(emulsion_tile_add_aux_at(tile, 1, x_px, y_px, "depth", NULL), "values");
    CHECK(emulsion_tile_add_aux_at(tile, 0, NULL, NULL, "depth", NULL) == EMULSION_OK);
    CHECK(emulsion_tile_splat_spectral(tile, 1, x_px, y_px, 1, lambda_nm, radiance, pdf_per_nm) == EMULSION_OK);
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_read_aux(film, "depth", numbers, 2) == EMULSION_OK && numbers[0] == 7 && numbers[1] == 0);

    /* Light: nothing can be shown before the number of paths is known; 4 of them, of which one came, over 100 nm. */
    numbers[0] = 9;
    CHECK_REFUSED(emulsion_film_read_spectrum(film, numbers, 4), EMULSION_INVALID_ARGUMENT, "light paths");
    CHECK(numbers[0] == 9);
    CHECK(emulsion_film_add_light_paths(film, 4) == EMULSION_OK);
    CHECK(emulsion_film_read_spectrum(film, numbers, 4) == EMULSION_OK);
    CHECK(numbers[0] == 0 && fabs(numbers[1] - 0.125) < 1e-7 && numbers[3] == 0);
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}

void test_firefly_control(void) {
    emulsion_film_options options;
    emulsion_film* film;
    emulsion_tile* tile;
    const int32_t zero[] = {0};
    const float dim[] = {1, 2, 1}, bright[] = {100, 200, 100};
    float numbers[3];
    uint64_t count = 9, index;
    emulsion_film_options_init(&options, sizeof options);
    options.width_px = options.height_px = 1;

    options.firefly_control = "clamp:luminance=20";
    new_pair(&options, &film, &tile);
    CHECK(emulsion_tile_add_xyz(tile, 1, zero, zero, NULL, bright) == EMULSION_OK);
    CHECK(emulsion_tile_add_xyz(tile, 1, zero, zero, NULL, dim) == EMULSION_OK);
    CHECK(emulsion_film_clamped_count(film, &count) == EMULSION_OK && count == 0);
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_clamped_count(film, &count) == EMULSION_OK && count == 1);
    CHECK(emulsion_film_read_xyz(film, numbers, 3) == EMULSION_OK && fabs(numbers[1] - 11.0) < 1e-5);
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);

    options.firefly_control = "median-of-means:groups=3";
    new_pair(&options, &film, &tile);
    for (index = 0; index < 3; ++index) {
        CHECK(emulsion_tile_set_sample_index(tile, index) == EMULSION_OK);
        CHECK(emulsion_tile_add_xyz(tile, 1, zero, zero, NULL, index == 1 ? bright : dim) == EMULSION_OK);
    }
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_read_xyz(film, numbers, 3) == EMULSION_OK && numbers[0] == 1 && numbers[1] == 2);
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}

static void check_options_refused(void) {
    emulsion_film_options options = all_layers();
    emulsion_film* film = NULL;
#define CHECK_OPTION(field, bad, good, text)                                                     \
    do {                                                                                         \
        options.field = bad;                                                                     \
        CHECK_REFUSED(emulsion_film_create(&options, &film), EMULSION_INVALID_ARGUMENT, (text)); \
        options.field = good;                                                                    \
    } while (0)
    CHECK_OPTION(variance, 3, EMULSION_VARIANCE_XYZ, "variance is 3");
    CHECK_OPTION(variance, -1, EMULSION_VARIANCE_XYZ, "variance is -1");
    CHECK_OPTION(spectrum_count, -1, 2, "spectrum.count = -1");
    CHECK_OPTION(spectrum_count, 1025, 2, "spectrum.count = 1025");
    CHECK_OPTION(spectrum_min_nm, 600, 400, "spectrum.min_nm = 600");
    CHECK_OPTION(spectrum_max_nm, NAN, 600, "spectrum.max_nm");
    CHECK_OPTION(aux, NULL, "depth", "aux is NULL");
    CHECK_OPTION(aux, "roughness", "depth", "found \"roughness\"");
    CHECK_OPTION(aux, "depth,depth", "depth", "twice");
    CHECK_OPTION(aux, "variance:Y", "depth", "variance");
    CHECK_OPTION(firefly_control, NULL, "none", "firefly_control is NULL");
    CHECK_OPTION(firefly_control, "swatter", "none", "swatter");
    CHECK_OPTION(firefly_control, "clamp:luminance=0", "none", "luminance");
    CHECK_OPTION(firefly_control, "median-of-means:groups=2", "none", "groups");
    CHECK(film == NULL);

    /* A program of the time before there were layers, whatever lies behind its options. */
    options.size = offsetof(emulsion_film_options, variance);
    options.variance = 77;
    options.aux = options.firefly_control = NULL;
    CHECK(emulsion_film_create(&options, &film) == EMULSION_OK);
    emulsion_film_destroy(film);
}

void test_refused_layers(void) {
    emulsion_film_options options = all_layers();
    emulsion_film *film, *plain = new_film();
    emulsion_tile *tile, *plain_tile = new_tile(plain);
    const int32_t x[] = {0, 2}, y[] = {0, 0};
    const float depth[] = {1, 2}, place[] = {0.5f, 0.5f};
    float numbers[3 * PIXELS];
    uint32_t counts[PIXELS];
    check_options_refused();
    new_pair(&options, &film, &tile);

    /* Whatever is wrong with a batch, nothing of it is added. */
    CHECK_REFUSED(emulsion_tile_add_aux(tile, 2, x, y, NULL, "depth", depth), EMULSION_INVALID_ARGUMENT,
                  "sample 1 is at pixel (2, 0)");
    CHECK_REFUSED(emulsion_tile_add_aux(tile, 1, x, y, NULL, "Depth", depth), EMULSION_INVALID_ARGUMENT,
                  "expected depth or motion");
    CHECK_NULL(emulsion_tile_add_aux(tile, 1, x, y, NULL, "depth", NULL), "values");
    CHECK_REFUSED(emulsion_tile_add_aux(tile, (size_t)-1, x, y, NULL, "depth", depth), EMULSION_INVALID_ARGUMENT,
                  "more than memory can hold");
    CHECK_REFUSED(emulsion_tile_add_aux_at(tile, 1, place, place, "depth", depth), EMULSION_INVALID_ARGUMENT,
                  "filter_use is importance_sampled");
    CHECK(emulsion_tile_add_aux(tile, 0, NULL, NULL, NULL, "depth", NULL) == EMULSION_OK);
    CHECK(emulsion_film_merge_tile(film, tile) == EMULSION_OK);
    CHECK(emulsion_film_read_aux(film, "depth", numbers, 2) == EMULSION_OK && numbers[0] == 0 && numbers[1] == 0);

    CHECK_REFUSED(emulsion_film_read_variance(film, numbers, 2), EMULSION_INVALID_ARGUMENT, "expected 6");
    CHECK_NULL(emulsion_film_read_variance(film, NULL, 6), "variance");
    CHECK_REFUSED(emulsion_film_read_standard_error(film, numbers, 7), EMULSION_INVALID_ARGUMENT, "expected 6");
    CHECK_NULL(emulsion_film_read_standard_error(film, NULL, 6), "standard_error");
    CHECK_REFUSED(emulsion_film_read_spectrum(film, numbers, 2), EMULSION_INVALID_ARGUMENT, "expected 4");
    CHECK_NULL(emulsion_film_read_spectrum(film, NULL, 4), "radiance");
    CHECK_REFUSED(emulsion_film_read_aux(film, "motion", numbers, 2), EMULSION_INVALID_ARGUMENT, "expected 4");
    CHECK_REFUSED(emulsion_film_read_aux(film, "albedo", numbers, 6), EMULSION_INVALID_ARGUMENT, "albedo");
    CHECK_NULL(emulsion_film_read_aux(film, "depth", NULL, 2), "values");
    CHECK_REFUSED(emulsion_film_read_sample_counts(film, counts, 1), EMULSION_INVALID_ARGUMENT, "expected 2");

    /* A film that was not asked for them has none, but for its counts. */
    CHECK_REFUSED(emulsion_tile_add_aux(plain_tile, 1, x, y, NULL, "depth", depth), EMULSION_INVALID_ARGUMENT,
                  "there are none");
    CHECK_REFUSED(emulsion_film_read_aux(plain, "depth", numbers, PIXELS), EMULSION_INVALID_ARGUMENT, "there are none");
    CHECK_REFUSED(emulsion_film_read_variance(plain, numbers, PIXELS), EMULSION_INVALID_ARGUMENT, "without variance");
    CHECK_REFUSED(emulsion_film_read_standard_error(plain, numbers, PIXELS), EMULSION_INVALID_ARGUMENT,
                  "without variance");
    CHECK_REFUSED(emulsion_film_read_spectrum(plain, numbers, PIXELS), EMULSION_INVALID_ARGUMENT, "without a spectrum");
    CHECK(emulsion_film_read_sample_counts(plain, counts, PIXELS) == EMULSION_OK && counts[PIXELS - 1] == 0);
    emulsion_tile_destroy(plain_tile);
    emulsion_film_destroy(plain);
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}
