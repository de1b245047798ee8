/* image_mutations - a target of images (image_target.h) with deterministic mutations
 *
 * SPDX-License-Identifier: MIT */
#ifndef IMAGE_MUTATIONS_H
#define IMAGE_MUTATIONS_H

#include "host_tools/pack/pack.h"
#include "tests/fuzz/image_target.h"
#include "tests/hostile/mutations.h"
#include "tests/test.h"

/* Defined by the program: an image for each seed, and which of its bytes is damaged. */
static packed seed_image(uint32_t seed);
static uint32_t place(const unsigned char *image, uint32_t size, random_state *r);

/* The image of a seed, damaged in one to three places, and now and then cut. */
static inline void fuzz(uint32_t seed, uint32_t mutations) {
    random_state r = {seed};
    packed image = seed_image(seed);
    unsigned char *input = malloc(image.size + 1), *bytes = input + 1;
    for (uint32_t i = 0; i < mutations; i++) {
        memcpy(bytes, image.bytes, image.size);
        input[0] = (unsigned char)(random_bits(&r) | 16);
        for (uint32_t times = 1 + random_below(&r, 3); times > 0; times--) {
            mutate_at(bytes, image.size, place(bytes, image.size, &r), &r);
        }
        const size_t size = image.size + 1;
        const size_t cut = random_below(&r, 50) ? size : random_below(&r, (uint32_t)size);
        CHECK(LLVMFuzzerTestOneInput(input, cut) == 0, "seed %u, mutation %u", seed, i);
    }
    free(input);
    pack_free(&image);
}

#endif
