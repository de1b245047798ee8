/* jpeg - see jpeg.h
 *
 * A unit (MCU) of 8x8, 16x8 or 16x16 pixels is read, transformed and written, then the next. Chroma
 * samples are the mean of their pixels'; beyond the right and lower border the last pixel repeats.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/jpeg.h"

#include "host_tools/picture/jpeg_block.h"
#include "host_tools/picture/jpeg_codes.h"

enum { COMPONENTS = 3, UNIT_MOST = 16 };

typedef struct encoder {
    const picture *of;
    jpeg_file file;
    uint8_t steps[2][JPEG_BLOCK]; /* luminance, chrominance */
    jpeg_book book[2];
    int dc[COMPONENTS];
    unsigned across, down; /* blocks of luminance in a unit: 1 or 2 */
} encoder;

size_t jpeg_most(unsigned width, unsigned height) {
    const size_t across = (width + UNIT_MOST - 1) / UNIT_MOST * UNIT_MOST;
    const size_t down = (height + UNIT_MOST - 1) / UNIT_MOST * UNIT_MOST;
    /* A coefficient's code and bits are 26 at most, and each byte may be stuffed. */
    return 1024 + across * down * COMPONENTS * 26 / 8 * 2;
}

/* ---- what stands before the pixels (T.81, Annex B) ------------------------------------- */

static void put_marker(jpeg_file *f, unsigned code) {
    jpeg_byte(f, 0xFF);
    jpeg_byte(f, code);
}

static void put_u16(jpeg_file *f, unsigned value) {
    jpeg_byte(f, value >> 8);
    jpeg_byte(f, value & 0xFF);
}

/* SOI and JFIF's APP0: version 1.02, pixels are square, no thumbnail. */
static void put_start(jpeg_file *f) {
    static const uint8_t app0[] = {'J', 'F', 'I', 'F', 0, 1, 2, 0, 0, 1, 0, 1, 0, 0};
    put_marker(f, 0xD8);
    put_marker(f, 0xE0);
    put_u16(f, 2 + sizeof app0);
    for (unsigned i = 0; i < sizeof app0; i++) {
        jpeg_byte(f, app0[i]);
    }
}

static void put_quantisation(encoder *e) {
    put_marker(&e->file, 0xDB);
    put_u16(&e->file, 2 + 2 * (1 + JPEG_BLOCK));
    for (unsigned t = 0; t < 2; t++) {
        jpeg_byte(&e->file, t);
        for (unsigned i = 0; i < JPEG_BLOCK; i++) {
            jpeg_byte(&e->file, e->steps[t][jpeg_zigzag[i]]);
        }
    }
}

static void put_frame(encoder *e) {
    jpeg_file *f = &e->file;
    put_marker(f, 0xC0);
    put_u16(f, 8 + 3 * COMPONENTS);
    jpeg_byte(f, 8);
    put_u16(f, e->of->height);
    put_u16(f, e->of->width);
    jpeg_byte(f, COMPONENTS);
    for (unsigned c = 0; c < COMPONENTS; c++) {
        jpeg_byte(f, c + 1);
        jpeg_byte(f, c == 0 ? e->across << 4 | e->down : 0x11);
        jpeg_byte(f, c > 0);
    }
}

static void put_codes(jpeg_file *f) {
    put_marker(f, 0xC4);
    put_u16(f, 2 + 2 * (1 + 16 + 12) + 2 * (1 + 16 + 162));
    jpeg_code_tables(f, 0);
    jpeg_code_tables(f, 1);
}

static void put_scan(jpeg_file *f) {
    put_marker(f, 0xDA);
    put_u16(f, 6 + 2 * COMPONENTS);
    jpeg_byte(f, COMPONENTS);
    for (unsigned c = 0; c < COMPONENTS; c++) {
        jpeg_byte(f, c + 1);
        jpeg_byte(f, c == 0 ? 0x00 : 0x11);
    }
    jpeg_byte(f, 0);
    jpeg_byte(f, JPEG_BLOCK - 1);
    jpeg_byte(f, 0);
}

/* ---- pixels ---------------------------------------------------------------------------- */

/* Red, green and blue to Y - 128, Cb - 128, Cr - 128, times 2^16 (T.871, 7). */
static const int32_t colour_weights[COMPONENTS][3] = {
    {19595, 38470, 7471}, {-11059, -21709, 32768}, {32768, -27439, -5329}};

/* The component's sample of `across` x `down` pixels from x, y on: their mean. */
static int16_t sample_at(const picture *p, unsigned component, unsigned x, unsigned y,
                         unsigned across, unsigned down) {
    const int32_t *weights = colour_weights[component];
    const unsigned shift = 15 + across + down - 1; /* both are 1 or 2, so these are their logs */
    int32_t sum = 0;
    for (unsigned j = y; j < y + down; j++) {
        const unsigned row = j < p->height ? j : p->height - 1;
        for (unsigned i = x; i < x + across; i++) {
            const unsigned column = i < p->width ? i : p->width - 1;
            const uint8_t *rgb = p->rgb + 3 * ((size_t)row * p->width + column);
            sum += weights[0] * rgb[0] + weights[1] * rgb[1] + weights[2] * rgb[2];
        }
    }
    sum = (sum + (1 << (shift - 1))) >> shift;
    sum = component == 0 ? sum - 128 : sum;
    return (int16_t)(sum > 127 ? 127 : sum);
}

/* A block of the component whose first pixel is x, y. */
static void put_block(encoder *e, unsigned component, unsigned x, unsigned y) {
    const int chrominance = component > 0;
    const unsigned across = chrominance ? e->across : 1, down = chrominance ? e->down : 1;
    int16_t block[JPEG_BLOCK];
    for (unsigned i = 0; i < JPEG_BLOCK; i++) {
        block[i] = sample_at(e->of, component, x + i % JPEG_SIDE * across, y + i / JPEG_SIDE * down,
                             across, down);
    }
    jpeg_transform(block, e->steps[chrominance]);
    jpeg_code_block(&e->file, block, &e->book[chrominance], &e->dc[component]);
}

static void put_unit(encoder *e, unsigned x, unsigned y) {
    for (unsigned j = 0; j < e->down; j++) {
        for (unsigned i = 0; i < e->across; i++) {
            put_block(e, 0, x + i * JPEG_SIDE, y + j * JPEG_SIDE);
        }
    }
    put_block(e, 1, x, y);
    put_block(e, 2, x, y);
}

/* ---- files ----------------------------------------------------------------------------- */

size_t jpeg_write(const picture *p, jpeg_sampling sampling, unsigned quality, uint8_t *file,
                  size_t room) {
    encoder e = {.of = p,
                 .file = {.bytes = file, .room = room},
                 .across = sampling == JPEG_444 ? 1 : 2,
                 .down = sampling == JPEG_420 ? 2 : 1};
    for (int chrominance = 0; chrominance < 2; chrominance++) {
        jpeg_steps(quality, chrominance, e.steps[chrominance]);
        jpeg_book_set(&e.book[chrominance], chrominance);
    }
    put_start(&e.file);
    put_quantisation(&e);
    put_frame(&e);
    put_codes(&e.file);
    put_scan(&e.file);
    for (unsigned y = 0; y < p->height; y += JPEG_SIDE * e.down) {
        for (unsigned x = 0; x < p->width; x += JPEG_SIDE * e.across) {
            put_unit(&e, x, y);
        }
    }
    jpeg_pad(&e.file);
    put_marker(&e.file, 0xD9);
    return e.file.size;
}

size_t jpeg_fit(const picture *p, jpeg_sampling sampling, unsigned least, unsigned most,
                unsigned *quality, uint8_t *file, size_t room) {
    *quality = least;
    size_t size = jpeg_write(p, sampling, most, file, room);
    if (size <= room) {
        *quality = most;
        return size;
    }
    while (least + 1 < most) { /* `most` does not fit */
        const unsigned middle = (least + most) / 2;
        if (jpeg_write(p, sampling, middle, file, room) <= room) {
            least = *quality = middle;
        } else {
            most = middle;
        }
    }
    return jpeg_write(p, sampling, *quality, file, room);
}
