/* Filters that splat, crop windows, light tracers. */
#include "c99_test.h"

void test_filters_crops_and_light(void) {
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
