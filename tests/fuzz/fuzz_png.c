/* fuzz_png - a libFuzzer target: any bytes as a PNG picture, and as a deflate stream
 *
 * A picture is also read with the CRCs that its chunks should have, as few inputs have one.
 *
 * Promised, whatever the bytes are (png.h, inflate.h):
 *
 *   - a picture that was read has 1 to PICTURE_SIDE_MAX pixels on each side, and reading it
 *     again, over an older picture, gives the same pixels;
 *   - on failure the picture is zero or what it was, and the text is one line that begins
 *     with the file's name;
 *   - unpacking writes no more than its room, and into less room the same bytes;
 *   - what deflate packs, inflate unpacks.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "engine/planelet_crc32.h"
#include "host_tools/picture/deflate.h"
#include "host_tools/picture/inflate.h"
#include "host_tools/picture/png.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { ROOM = 70000 }; /* more than the longest distance back */

static void promise(int kept, const char *sentence) {
    if (!kept) {
        fprintf(stderr, "%s\n", sentence);
        abort();
    }
}

static int is_zero(const picture *p) {
    return p->rgb == NULL && p->width == 0 && p->height == 0;
}

static int same_picture(const picture *a, const picture *b) {
    return a->width == b->width && a->height == b->height &&
           memcmp(a->rgb, b->rgb, 3 * (size_t)a->width * a->height) == 0;
}

static void check_failure(const fail *f) {
    int controls = 0;
    for (const char *c = f->text; *c != '\0'; c++) {
        controls |= (unsigned char)*c < 0x20;
    }
    promise(strncmp(f->text, "fuzz.png: ", 10) == 0 && f->text[10] != '\0' && !controls,
            "a failure is no line about the file");
}

static void read_png(const uint8_t *data, size_t size) {
    picture first = {0}, second = {0}, old = {0};
    fail f = {""}, again = {""};
    const int made = picture_make(&second, 3, 2, &f) | picture_make(&old, 3, 2, &f);
    promise(made == 0, "memory for six pixels");
    memset(old.rgb, 7, 18);
    memset(second.rgb, 7, 18);
    const int status = png_read(&first, data, size, "fuzz.png", &f);
    promise(png_read(&second, data, size, "fuzz.png", &again) == status &&
                strcmp(f.text, again.text) == 0,
            "the second reading ends in another way");
    if (status == 0) {
        promise(first.width - 1 < PICTURE_SIDE_MAX && first.height - 1 < PICTURE_SIDE_MAX,
                "a size that no picture has");
        promise(same_picture(&first, &second), "the second reading gives other pixels");
        promise(f.text[0] == '\0', "a failure that is none");
    } else {
        promise(is_zero(&first), "a failure leaves a picture");
        promise(is_zero(&second) || same_picture(&second, &old), "a failure leaves half a picture");
        check_failure(&f);
    }
    picture_free(&first);
    picture_free(&second);
    picture_free(&old);
}

static uint32_t big32(const uint8_t *p) {
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

/* Gives every chunk that is all there the CRC of its kind and bytes. */
static void mend(uint8_t *data, size_t size) {
    size_t at = sizeof png_signature;
    while (at <= size && size - at >= 12 && big32(data + at) <= size - at - 12) {
        const size_t count = 4 + (size_t)big32(data + at);
        const uint32_t crc = plt_crc32(0, data + at + 4, count);
        for (int i = 0; i < 4; i++) {
            data[at + 4 + count + (size_t)i] = (uint8_t)(crc >> (24 - 8 * i));
        }
        at += 8 + count;
    }
}

static void unpack(const uint8_t *data, size_t size) {
    uint8_t *all = malloc(ROOM);
    const size_t count = inflate_bytes(data, size, all, ROOM), less = count / 2;
    uint8_t *half = malloc(less > 0 ? less : 1);
    promise(count <= ROOM, "more bytes than there is room");
    promise(inflate_bytes(data, size, half, less) == less && memcmp(half, all, less) == 0,
            "less room gives other bytes");
    free(all);
    free(half);
}

/* A zlib stream has two bytes in front of what deflate packed, and four behind. */
static void pack_and_unpack(const uint8_t *data, size_t size) {
    bits packed = {0};
    uint8_t *back = malloc(size > 0 ? size : 1);
    promise(deflate_zlib(&packed, data, size) == 0, "memory for a few bytes");
    promise(inflate_bytes(packed.bytes + 2, packed.size - 6, back, size) == size &&
                memcmp(back, data, size) == 0,
            "what was packed is not what is unpacked");
    bits_free(&packed);
    free(back);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    uint8_t *bytes = malloc(size > 0 ? size : 1); /* of just this size, for sanitizers */
    memcpy(bytes, data, size);
    read_png(bytes, size);
    unpack(bytes, size);
    pack_and_unpack(bytes, size);
    mend(bytes, size);
    read_png(bytes, size);
    free(bytes);
    return 0;
}
