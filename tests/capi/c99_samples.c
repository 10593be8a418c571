/* Batches of samples of every kind, good and bad. */
#include "c99_test.h"

void test_samples(void) {
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

void test_dropped_samples(void) {
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
void test_refused_batches(void) {
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
