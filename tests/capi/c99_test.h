/* The C interface as a C renderer sees it: what the tests of it share, compiled as C99. */
#ifndef EMULSION_C99_TEST_H
#define EMULSION_C99_TEST_H

#include <emulsion.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

extern int failures;

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

#define CHECK_NULL(call, name) CHECK_REFUSED(call, EMULSION_INVALID_ARGUMENT, name " is NULL")

enum { WIDTH = 8, HEIGHT = 6, PIXELS = WIDTH * HEIGHT };

/* WIDTH x HEIGHT pixels, everything else by default; and a tile of all of them. */
emulsion_film* new_film(void);
emulsion_tile* new_tile(const emulsion_film* film);

void test_samples(void);
void test_dropped_samples(void);
void test_refused_batches(void);
void test_filters_crops_and_light(void);
void test_layers(void);
void test_splatted_layers(void);
void test_firefly_control(void);
void test_refused_layers(void);
void test_null(void);
void test_null_batches(void);
void test_null_layers(void);

#endif /* EMULSION_C99_TEST_H */
