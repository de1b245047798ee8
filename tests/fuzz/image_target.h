/* image_target - what the libFuzzer targets of images have in common
 *
 * The first byte of an input says how the image behind it is opened; bit 4 asks for its checks to
 * be made right, or hardly a mutation would pass them. What is promised is in tests/hostile.
 *
 * SPDX-License-Identifier: MIT */
#ifndef IMAGE_TARGET_H
#define IMAGE_TARGET_H

#include <stdio.h>

#include "tests/hostile/images.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static unsigned long images_opened;

/* Defined by the target: makes the checks of an image right, and tries it. */
static void seal_image(unsigned char *bytes, uint32_t size);
static hostile_result try_image(const unsigned char *bytes, uint32_t size, uint8_t first);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < 1 || size > 1u << 20) {
        return 0;
    }
    const uint32_t count = (uint32_t)size - 1;
    unsigned char *bytes = malloc(count > 0 ? count : 1);
    memcpy(bytes, data + 1, count);
    if (data[0] & 16) {
        seal_image(bytes, count);
    }
    const hostile_result r = try_image(bytes, count, data[0]);
    free(bytes);
    images_opened += r.status == PLT_OK;
    if (r.sentence != NULL) {
        fprintf(stderr, "%s\n", r.sentence);
        abort();
    }
    return 0;
}

#endif
