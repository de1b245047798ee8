/* png_read - a PNG picture of 8 bits per channel, not interlaced
 *
 * Grey, colour and palette, with or without alpha, which is laid on black.
 * A chunk whose checksum is wrong is refused; that of the samples themselves,
 * Adler's, is not read. The file is untrusted; every length is checked before it
 * is used. What is behind IEND is not read.
 *
 * Source: W3C, "Portable Network Graphics (PNG) Specification (Third
 * Edition)", 2025.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "engine/planelet_crc32.h"
#include "host_tools/picture/inflate.h"
#include "host_tools/picture/png.h"

enum { PALETTE = 3 };          /* a colour type */
enum { DEFLATE_RATIO = 1032 }; /* at most: 258 bytes from two codes of one bit each */

typedef struct png {
    const char *name; /* for errors */
    const uint8_t *file;
    size_t bytes;
    uint32_t width, height;
    unsigned channels, colour; /* samples per pixel; PNG's colour type */
    uint8_t palette[3 * 256];
    uint8_t *packed; /* all IDAT chunks together */
    size_t packed_bytes;
    uint8_t *rows; /* of each row a filter byte and the samples */
} png;

static uint32_t u32(const uint8_t *p) {
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

/* The filter byte and the samples. read_head keeps all rows together below 2^32, so that their
 * number fits in a size_t of 32 bits. */
static size_t row_bytes(const png *p) {
    return 1 + (size_t)p->width * p->channels;
}

static int read_head(png *p, const uint8_t *data, uint32_t bytes, fail *f) {
    static const unsigned channels[] = {1, 0, 3, 1, 2, 0, 4};
    if (bytes != 13 || data[8] != 8 || data[9] > 6 || channels[data[9]] == 0 || data[12] != 0) {
        return fail_set(f, p->name, "only PNG of 8 bits, not interlaced, is read; convert it");
    }
    p->width = u32(data);
    p->height = u32(data + 4);
    p->colour = data[9];
    p->channels = channels[data[9]];
    if (p->width - 1 >= PICTURE_SIDE_MAX || p->height - 1 >= PICTURE_SIDE_MAX ||
        row_bytes(p) > UINT32_MAX / p->height) {
        return fail_set(f, p->name, "%u x %u pixels are too many; make it smaller", p->width,
                        p->height);
    }
    return 0;
}

static int read_chunk(png *p, const uint8_t *kind, uint32_t bytes, fail *f) {
    const uint8_t *data = kind + 4;
    if (memcmp(kind, "IHDR", 4) == 0) {
        return read_head(p, data, bytes, f);
    }
    if (memcmp(kind, "PLTE", 4) == 0) {
        memcpy(p->palette, data, bytes < sizeof p->palette ? bytes : sizeof p->palette);
    } else if (memcmp(kind, "IDAT", 4) == 0) {
        memcpy(p->packed + p->packed_bytes, data, bytes);
        p->packed_bytes += bytes;
    }
    return 0;
}

/* A kind is four letters (section 5.3); of others there is no name to say. */
static int fail_chunk(const png *p, size_t at, fail *f) {
    char kind[5] = {0};
    for (size_t i = 0; i < 4; i++) {
        const uint8_t letter = p->file[at + 4 + i];
        const int is_one = (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z');
        kind[i] = is_one ? (char)letter : '?';
    }
    return fail_set(f, p->name, "its chunk %s at byte %zu is damaged (CRC); write it again", kind,
                    at);
}

static int read_chunks(png *p, fail *f) {
    size_t at = PNG_SIGNATURE_BYTES;
    int is_end = 0;
    while (!is_end && p->bytes - at >= 12) {
        const uint32_t bytes = u32(p->file + at);
        const uint8_t *kind = p->file + at + 4;
        if (bytes > p->bytes - at - 12) {
            break;
        }
        if (plt_crc32(0, kind, (size_t)bytes + 4) != u32(kind + 4 + bytes)) {
            return fail_chunk(p, at, f);
        }
        if (read_chunk(p, kind, bytes, f) != 0) {
            return -1;
        }
        is_end = memcmp(kind, "IEND", 4) == 0;
        at += 12 + (size_t)bytes;
    }
    if (p->width == 0 || p->packed_bytes < 6) {
        return fail_set(f, p->name, "holds no picture; write it again");
    }
    return 0;
}

/* Section 9: each sample from its left, upper and upper left neighbours. */
static int unfilter(png *p) {
    const size_t row = (size_t)p->width * p->channels;
    for (uint32_t y = 0; y < p->height; y++) {
        uint8_t *at = p->rows + y * (row + 1) + 1;
        const uint8_t *up = y > 0 ? at - row - 1 : NULL;
        for (size_t i = 0; i < row; i++) {
            const unsigned left = i >= p->channels ? at[i - p->channels] : 0;
            const unsigned above = up ? up[i] : 0;
            const unsigned corner = up && i >= p->channels ? up[i - p->channels] : 0;
            const unsigned guesses[PNG_FILTERS] = {0, left, above, (left + above) / 2,
                                                   png_paeth((int)left, (int)above, (int)corner)};
            if (at[-1] >= PNG_FILTERS) {
                return -1;
            }
            at[i] = (uint8_t)(at[i] + guesses[at[-1]]);
        }
    }
    return 0;
}

static void to_rgb(const png *p, const uint8_t *sample, uint8_t *rgb) {
    const unsigned alpha = p->colour == 4 ? sample[1] : p->colour == 6 ? sample[3] : 255;
    for (unsigned c = 0; c < 3; c++) {
        unsigned v = sample[p->channels >= 3 ? c : 0];
        if (p->colour == PALETTE) {
            v = p->palette[3 * sample[0] + c];
        }
        rgb[c] = (uint8_t)((v * alpha + 127) / 255);
    }
}

static int fail_damaged(const png *p, fail *f) {
    return fail_set(f, p->name, "is damaged or ends too early; write it again");
}

static int decode(png *p, picture *to, fail *f) {
    const size_t row = row_bytes(p), all = row * p->height;
    if (all / DEFLATE_RATIO > p->packed_bytes) { /* memory grows with the file alone */
        return fail_damaged(p, f);
    }
    p->rows = malloc(all);
    if (p->rows == NULL) {
        return fail_set(f, p->name, "too large for memory; make it smaller");
    }
    /* Two bytes of zlib's head stand before the packed data. */
    if (inflate_bytes(p->packed + 2, p->packed_bytes - 2, p->rows, all) != all ||
        unfilter(p) != 0) {
        return fail_damaged(p, f);
    }
    if (picture_resize(to, p->width, p->height, f) != 0) {
        return -1;
    }
    for (uint32_t y = 0; y < p->height; y++) {
        for (uint32_t x = 0; x < p->width; x++) {
            to_rgb(p, p->rows + y * row + 1 + (size_t)x * p->channels,
                   to->rgb + 3 * ((size_t)y * p->width + x));
        }
    }
    return 0;
}

int png_read(picture *to, const uint8_t *file, size_t bytes, const char *name, fail *f) {
    png p = {.name = name, .file = file, .bytes = bytes};
    if (bytes < 33 || memcmp(file, png_signature, sizeof png_signature) != 0) {
        return fail_set(f, name, "is no PNG picture; convert it to one");
    }
    p.packed = malloc(bytes);
    const int status = p.packed == NULL ? fail_set(f, name, "too large for memory; make it smaller")
                       : read_chunks(&p, f) != 0 ? -1
                                                 : decode(&p, to, f);
    free(p.rows);
    free(p.packed);
    return status;
}
