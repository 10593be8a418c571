/* NULL where something is needed. */
#include "c99_test.h"

void test_null(void) {
    emulsion_film* film = new_film();
    emulsion_tile* tile = new_tile(film);
    emulsion_film* no_film = NULL;
    emulsion_tile* no_tile = NULL;
    const emulsion_rect one = {0, 0, 1, 1}, outside = {0, 0, WIDTH + 1, 1};
    float pixels[3 * PIXELS];
    uint64_t count = 0;
    emulsion_rect bounds;

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

void test_null_batches(void) {
    emulsion_film* film = new_film();
    emulsion_tile* tile = new_tile(film);
    const int32_t zero[] = {0};
    const float numbers[] = {500, 500, 500};
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
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}

void test_null_layers(void) {
    emulsion_film* film = new_film();
    emulsion_tile* tile = new_tile(film);
    const int32_t zero[] = {0};
    const float place[] = {0.5f};
    float numbers[PIXELS] = {0.5f};
    uint32_t counts[PIXELS];
    uint64_t count = 0;
    CHECK_NULL(emulsion_tile_set_sample_index(NULL, 0), "tile");
    CHECK_NULL(emulsion_tile_add_aux(NULL, 1, zero, zero, NULL, "depth", numbers), "tile");
    CHECK_NULL(emulsion_tile_add_aux(tile, 1, NULL, zero, NULL, "depth", numbers), "x_px");
    CHECK_NULL(emulsion_tile_add_aux(tile, 1, zero, NULL, NULL, "depth", numbers), "y_px");
    CHECK_NULL(emulsion_tile_add_aux(tile, 1, zero, zero, NULL, NULL, numbers), "layer");
    CHECK_NULL(emulsion_tile_add_aux_at(NULL, 1, place, place, "depth", numbers), "tile");
    CHECK_NULL(emulsion_film_dropped_aux_count(NULL, &count), "film");
    CHECK_NULL(emulsion_film_dropped_aux_count(film, NULL), "count");
    CHECK_NULL(emulsion_film_clamped_count(NULL, &count), "film");
    CHECK_NULL(emulsion_film_clamped_count(film, NULL), "count");
    CHECK_NULL(emulsion_film_read_sample_counts(NULL, counts, PIXELS), "film");
    CHECK_NULL(emulsion_film_read_sample_counts(film, NULL, PIXELS), "counts");
    CHECK_NULL(emulsion_film_read_variance(NULL, numbers, PIXELS), "film");
    CHECK_NULL(emulsion_film_read_standard_error(NULL, numbers, PIXELS), "film");
    CHECK_NULL(emulsion_film_read_spectrum(NULL, numbers, PIXELS), "film");
    CHECK_NULL(emulsion_film_read_aux(NULL, "depth", numbers, PIXELS), "film");
    CHECK_NULL(emulsion_film_read_aux(film, NULL, numbers, PIXELS), "layer");
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}
