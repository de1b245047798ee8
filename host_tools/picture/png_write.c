/* png_write - one 8-bit RGB picture as a PNG file
 *
 * Each row gets the filter whose result has the smallest sum of absolute
 * differences, a good guess at what deflate compresses best.
 *
 * Source: W3C "Portable Network Graphics (PNG) Specification", second
 * edition, 2003, sections 5 (chunks), 9 (filters) and 12.8 (their choice).
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "engine/planelet_crc32.h"
#include "host_tools/picture/deflate.h"
#include "host_tools/picture/formats.h"
#include "host_tools/picture/png.h"

#define PIXEL 3u
#define IDAT_MAX ((size_t)1 << 30)

static void put_big(uint8_t *to, uint32_t value) {
    for (unsigned i = 0; i < 4; i++) {
        to[i] = (uint8_t)(value >> (24 - 8 * i));
    }
}

static void chunk(bits *file, const char *name, const uint8_t *data, size_t size) {
    const uint8_t *letters = (const uint8_t *)name;
    bits_big32(file, (uint32_t)size);
    bits_bytes(file, letters, 4);
    bits_bytes(file, data, size);
    bits_big32(file, plt_crc32(plt_crc32(0, letters, 4), data, size));
}

/* out[f] = the row under filter f. `above` is a row of zeros for the first. */
static void filter_row(const uint8_t *row, const uint8_t *above, size_t bytes, uint8_t *out) {
    uint8_t *none = out, *sub = none + bytes, *up = sub + bytes;
    uint8_t *average = up + bytes, *predictor = average + bytes;
    for (size_t i = 0; i < bytes; i++) {
        const uint8_t left = i < PIXEL ? 0 : row[i - PIXEL];
        const uint8_t corner = i < PIXEL ? 0 : above[i - PIXEL];
        none[i] = row[i];
        sub[i] = (uint8_t)(row[i] - left);
        up[i] = (uint8_t)(row[i] - above[i]);
        average[i] = (uint8_t)(row[i] - (left + above[i]) / 2);
        predictor[i] = (uint8_t)(row[i] - png_paeth(left, above[i], corner));
    }
}

static uint64_t roughness(const uint8_t *row, size_t bytes) {
    uint64_t sum = 0;
    for (size_t i = 0; i < bytes; i++) {
        sum += row[i] < 128 ? row[i] : 256u - row[i];
    }
    return sum;
}

static uint8_t smoothest(const uint8_t *rows, size_t bytes) {
    uint8_t best = 0;
    uint64_t least = roughness(rows, bytes);
    for (uint8_t k = 1; k < PNG_FILTERS; k++) {
        const uint64_t sum = roughness(rows + k * bytes, bytes);
        if (sum < least) {
            least = sum;
            best = k;
        }
    }
    return best;
}

/* `scratch` holds six rows. */
static void filter_picture(const picture *p, uint8_t *filtered, uint8_t *scratch) {
    const size_t bytes = PIXEL * (size_t)p->width;
    const uint8_t *above = scratch + PNG_FILTERS * bytes;
    memset(scratch + PNG_FILTERS * bytes, 0, bytes);
    for (unsigned y = 0; y < p->height; y++) {
        const uint8_t *row = p->rgb + y * bytes;
        filter_row(row, above, bytes, scratch);
        const uint8_t k = smoothest(scratch, bytes);
        *filtered++ = k;
        memcpy(filtered, scratch + k * bytes, bytes);
        filtered += bytes;
        above = row;
    }
}

static int out_of_memory(const picture *p, fail *f) {
    return fail_set(f, NULL,
                    "PNG of %u x %u pixels: out of memory; "
                    "write .ppm, which needs none, or a smaller picture",
                    p->width, p->height);
}

static int compress(const picture *p, bits *packed, fail *f) {
    const size_t bytes = PIXEL * (size_t)p->width, size = (bytes + 1) * p->height;
    uint8_t *filtered = malloc(size), *scratch = malloc((PNG_FILTERS + 1) * bytes);
    int wrong = !filtered || !scratch;
    if (!wrong) {
        filter_picture(p, filtered, scratch);
        wrong = deflate_zlib(packed, filtered, size);
    }
    free(filtered);
    free(scratch);
    return wrong ? out_of_memory(p, f) : 0;
}

static void put_chunks(bits *file, const picture *p, const bits *packed) {
    uint8_t header[13] = {0};
    put_big(header, p->width);
    put_big(header + 4, p->height);
    header[8] = 8; /* bits per channel */
    header[9] = 2; /* RGB */
    bits_bytes(file, png_signature, sizeof png_signature);
    chunk(file, "IHDR", header, sizeof header);
    for (size_t at = 0; at < packed->size; at += IDAT_MAX) {
        const size_t rest = packed->size - at;
        chunk(file, "IDAT", packed->bytes + at, rest < IDAT_MAX ? rest : IDAT_MAX);
    }
    chunk(file, "IEND", NULL, 0);
}

int png_pack(bits *file, const picture *p, fail *f) {
    bits packed = {0};
    int result = compress(p, &packed, f);
    if (result == 0) {
        put_chunks(file, p, &packed);
        result = file->failed ? out_of_memory(p, f) : 0;
    }
    bits_free(&packed);
    return result;
}

int png_frame(output *o, const picture *p, fail *f) {
    bits file = {0};
    int result = png_pack(&file, p, f);
    if (result == 0) {
        result = output_write(o, file.bytes, file.size, f);
    }
    bits_free(&file);
    return result;
}
