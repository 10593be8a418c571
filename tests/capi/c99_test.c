/* The C interface as a C renderer sees it: compiled as C99, without anything of C++, in the build and, against the
 * installed package, by pkg-config. Takes the name of an EXR to write. */
#include "c99_test.h"

int failures = 0;

emulsion_film* new_film(void) {
    emulsion_film_options options;
    emulsion_film* film = NULL;
    CHECK(emulsion_film_options_init(&options, sizeof options) == EMULSION_OK);
    CHECK(options.size == sizeof options && options.width_px == 1280 && options.iso == 100.0);
    options.width_px = WIDTH;
    options.height_px = HEIGHT;
    CHECK(emulsion_film_create(&options, &film) == EMULSION_OK);
    return film;
}

emulsion_tile* new_tile(const emulsion_film* film) {
    emulsion_rect all;
    emulsion_tile* tile = NULL;
    CHECK(emulsion_film_bounds(film, &all) == EMULSION_OK);
    CHECK(all.x0 == 0 && all.y0 == 0 && all.x1 == WIDTH && all.y1 == HEIGHT);
    CHECK(emulsion_tile_create(film, all, &tile) == EMULSION_OK);
    CHECK(emulsion_tile_bounds(tile, &all) == EMULSION_OK && all.x1 == WIDTH && all.y1 == HEIGHT);
    return tile;
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
    test_layers();
    test_splatted_layers();
    test_firefly_control();
    test_refused_layers();
    test_null();
    test_null_batches();
    test_null_layers();
    test_exr(argv[1]);
    test_readme(argv[1]);
    return failures == 0 ? 0 : 1;
}
