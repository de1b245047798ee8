/* attacks - damage for every kind of image: flips, lengths, extreme header words
 *
 * The including program defines how an image is opened (open_once), and gets counts of opened
 * and refused images.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOSTILE_ATTACKS_H
#define HOSTILE_ATTACKS_H

#include <stdlib.h>
#include <string.h>

#include "host_tools/pack/pack.h"
#include "tests/hostile/images.h"
#include "tests/test.h"

static uint32_t opened, refused;

/* Defined by the program: opens once, with the damage at byte `at`. */
static hostile_result open_once(const unsigned char *bytes, uint32_t size, uint8_t streamed,
                                uint32_t at);

/* From both sources. Returns the last result. */
static inline hostile_result meet(const unsigned char *bytes, uint32_t size, const char *what,
                                  uint32_t at) {
    hostile_result r = {0, {0, 0, 0, 0, NULL}, NULL};
    for (uint8_t streamed = 0; streamed < 2; streamed++) {
        r = open_once(bytes, size, streamed, at);
        CHECK(r.sentence == NULL, "%s at %u, %s: %s", what, at, streamed ? "streamed" : "mapped",
              r.sentence);
        opened += r.status == PLT_OK;
        refused += r.status != PLT_OK;
    }
    return r;
}

static inline void must_refuse(const unsigned char *bytes, uint32_t size, const char *what,
                               uint32_t at) {
    const hostile_result r = meet(bytes, size, what, at);
    CHECK(r.status == PLT_ERR_IMAGE && r.fault.kind == 'R', "%s at %u: status %d", what, at,
          r.status);
}

/* ---- accidents: every one is detected --- */

static inline void flips(const packed *image) {
    static const unsigned char pattern[4] = {0x01, 0x80, 0xFF, 0x24};
    for (uint32_t at = 0; at < image->size; at++) {
        for (int p = 0; p < 4; p++) {
            image->bytes[at] ^= pattern[p];
            must_refuse(image->bytes, image->size, "a flip", at);
            image->bytes[at] ^= pattern[p];
        }
    }
}

static inline void lengths(const packed *image) {
    unsigned char *longer = calloc(image->size + 200, 1);
    memcpy(longer, image->bytes, image->size);
    for (uint32_t size = 0; size < image->size + 200; size++) {
        if (size != image->size) {
            must_refuse(longer, size, "a size", size);
        }
    }
    free(longer);
}

/* ---- forgeries: checksums are right --- */

/* Includes offsets, which sections and blocks round to 32 or 64 bytes. */
static inline void header_words(const packed *image) {
    static const uint32_t extreme[] = {0,          1,          2,          3,          5,
                                       0x40,       0x100,      0x7FFFFFFF, 0x80000000, 0xFFFFFFFF,
                                       0x07FFFFFF, 0x08000000, 0x7FC00000, 0x7F800000, 0xFF800000};
    for (uint32_t at = 0; at < 256; at += 4) {
        const uint32_t was = plt_get_u32(image->bytes + at);
        for (unsigned i = 0; i < 20; i++) {
            const uint32_t now =
                i < 15 ? extreme[i] : was + (i == 15) - (i == 16) + (i == 17) * 32 + (i == 18) * 64;
            plt_put_u32(image->bytes + at, i == 19 ? ~was : now);
            hostile_seal_header(image->bytes, image->size);
            meet(image->bytes, image->size, "a header word", at);
        }
        plt_put_u32(image->bytes + at, was);
    }
    hostile_seal_header(image->bytes, image->size);
}

#endif
