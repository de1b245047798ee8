/* jpeg_decode - baseline JPEG read the plain way, in double precision
 *
 * Knows no more than T.81 says of a file: tables come from the file, codes are found bit by bit,
 * the transform is the sum of A.3.3. Anything odd is an error with a sentence.
 *
 * SPDX-License-Identifier: MIT */
#ifndef JPEG_DECODE_H
#define JPEG_DECODE_H
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct jpeg_decoded {
    unsigned width, height;
    unsigned across, down; /* luminance samples per chrominance sample */
    double *plane[3];      /* Y, Cb, Cr of whole units, side by side; free them */
    unsigned stride[3];
    const char *trouble; /* NULL: there is none */
} jpeg_decoded;

typedef struct jpeg_reader {
    const uint8_t *at, *end;
    unsigned bit; /* of *at, 0 the highest */
    const char *trouble;
    double steps[4][64];
    uint8_t lengths[2][2][16]; /* AC, table */
    uint8_t values[2][2][256];
    jpeg_decoded *to;
} jpeg_reader;

static inline unsigned jpeg_bit(jpeg_reader *r) {
    if (r->at >= r->end) {
        r->trouble = "the scan ends early";
        return 0;
    }
    const unsigned bit = r->at[0] >> (7 - r->bit) & 1;
    if (++r->bit == 8) {
        r->bit = 0;
        if (*r->at++ == 0xFF) {
            if (r->at >= r->end || *r->at++ != 0) {
                r->trouble = "a marker within the scan";
            }
        }
    }
    return bit;
}

static inline int jpeg_value(jpeg_reader *r, unsigned bits) {
    int value = 0;
    for (unsigned i = 0; i < bits; i++) {
        value = value * 2 + (int)jpeg_bit(r);
    }
    return bits > 0 && value < 1 << (bits - 1) ? value - (1 << bits) + 1 : value;
}

static inline unsigned jpeg_symbol(jpeg_reader *r, unsigned ac, unsigned table) {
    unsigned code = 0, first = 0, index = 0;
    for (unsigned length = 0; length < 16; length++) {
        const unsigned count = r->lengths[ac][table][length];
        code = code * 2 + jpeg_bit(r);
        if (code - first < count) {
            return r->values[ac][table][index + code - first];
        }
        index += count;
        first = (first + count) * 2;
    }
    r->trouble = "a code that is in no table";
    return 0;
}

static inline unsigned jpeg_place(unsigned k) { /* of the k-th coefficient, along diagonals */
    unsigned row = 0, column = 0;
    for (; k > 0; k--) {
        const int up = (row + column) % 2 == 0;
        if (up && column == 7) {
            row++;
        } else if (!up && row == 7) {
            column++;
        } else if (up) {
            column++;
            row -= row > 0;
        } else {
            row++;
            column -= column > 0;
        }
    }
    return 8 * row + column;
}

static inline void jpeg_inverse(const double in[64], double *out, unsigned stride) {
    static double cosine[8][8];
    for (int x = 0; x < 8 && cosine[0][0] == 0; x++) {
        for (int u = 7; u >= 0; u--) {
            cosine[7 - x][u] = (u ? 1 : sqrt(0.5)) / 2 * cos((2 * (7 - x) + 1) * u * acos(-1) / 16);
        }
    }
    double half[64];
    for (int v = 0; v < 8; v++) {
        for (int x = 0; x < 8; x++) {
            half[8 * v + x] = 0;
            for (int u = 0; u < 8; u++) {
                half[8 * v + x] += in[8 * v + u] * cosine[x][u];
            }
        }
    }
    for (unsigned y = 0; y < 8; y++) {
        for (unsigned x = 0; x < 8; x++) {
            double sum = 128;
            for (unsigned v = 0; v < 8; v++) {
                sum += half[8 * v + x] * cosine[y][v];
            }
            out[y * stride + x] = sum < 0 ? 0 : sum > 255 ? 255 : sum;
        }
    }
}

static inline void jpeg_block_in(jpeg_reader *r, unsigned component, unsigned x, unsigned y,
                                 int *dc) {
    const unsigned table = component > 0;
    double in[64] = {0};
    *dc += jpeg_value(r, jpeg_symbol(r, 0, table));
    in[0] = *dc * r->steps[table][0];
    for (unsigned k = 1; k < 64 && r->trouble == NULL; k++) {
        const unsigned symbol = jpeg_symbol(r, 1, table);
        if (symbol == 0) {
            break;
        }
        k += symbol >> 4;
        const int value = jpeg_value(r, symbol & 15);
        if (k > 63) {
            r->trouble = "a run beyond the block";
            return;
        }
        in[jpeg_place(k)] = value * r->steps[table][k];
    }
    jpeg_inverse(in, r->to->plane[component] + (size_t)y * r->to->stride[component] + x,
                 r->to->stride[component]);
}

static inline void jpeg_scan(jpeg_reader *r) {
    jpeg_decoded *d = r->to;
    const unsigned units_x = (d->width + 8 * d->across - 1) / (8 * d->across);
    const unsigned units_y = (d->height + 8 * d->down - 1) / (8 * d->down);
    int dc[3] = {0};
    for (unsigned c = 0; c < 3; c++) {
        d->stride[c] = units_x * 8 * (c ? 1 : d->across);
        d->plane[c] =
            calloc((size_t)d->stride[c] * units_y * 8 * (c ? 1 : d->down), sizeof(double));
    }
    for (unsigned u = 0; u < units_x * units_y && r->trouble == NULL; u++) {
        const unsigned x = u % units_x * 8, y = u / units_x * 8;
        for (unsigned b = 0; b < d->across * d->down; b++) {
            jpeg_block_in(r, 0, x * d->across + b % d->across * 8, y * d->down + b / d->across * 8,
                          &dc[0]);
        }
        jpeg_block_in(r, 1, x, y, &dc[1]);
        jpeg_block_in(r, 2, x, y, &dc[2]);
    }
    for (; r->bit != 0 && r->trouble == NULL;) {
        if (!jpeg_bit(r)) {
            r->trouble = "padding that is not ones";
        }
    }
    if (r->trouble == NULL && (r->end - r->at != 2 || r->at[0] != 0xFF || r->at[1] != 0xD9)) {
        r->trouble = "no end behind the scan";
    }
}

static inline void jpeg_segment(jpeg_reader *r, unsigned marker, const uint8_t *s, unsigned bytes) {
    jpeg_decoded *d = r->to;
    if (marker == 0xC0) {
        if (bytes != 15 || s[0] != 8 || s[5] != 3 || s[10] != 0x11 || s[13] != 0x11) {
            r->trouble = "an odd frame";
            return;
        }
        d->height = s[1] * 256u + s[2];
        d->width = s[3] * 256u + s[4];
        d->across = s[7] >> 4;
        d->down = s[7] & 15;
    } else if (marker == 0xDB) {
        for (unsigned i = 0; i + 65 <= bytes; i += 65) {
            for (unsigned k = 0; k < 64; k++) {
                r->steps[s[i] & 3][k] = s[i + 1 + k];
            }
        }
    } else if (marker == 0xC4) {
        for (unsigned i = 0; i + 17 <= bytes;) {
            const unsigned ac = s[i] >> 4 & 1, table = s[i] & 1;
            unsigned count = 0;
            for (unsigned k = 0; k < 16; k++) {
                count += r->lengths[ac][table][k] = s[i + 1 + k];
            }
            memcpy(r->values[ac][table], s + i + 17, count);
            i += 17 + count;
        }
    } else if (marker != 0xE0) {
        r->trouble = "an unknown marker";
    }
}

static inline jpeg_decoded jpeg_decode(const uint8_t *file, size_t bytes) {
    jpeg_decoded d = {0};
    jpeg_reader r = {.at = file, .end = file + bytes, .to = &d};
    if (bytes < 4 || file[0] != 0xFF || file[1] != 0xD8) {
        d.trouble = "no start";
        return d;
    }
    for (r.at += 2; r.trouble == NULL;) {
        if (r.end - r.at < 4 || r.at[0] != 0xFF) {
            r.trouble = "no marker where one is due";
            break;
        }
        const unsigned marker = r.at[1], size = r.at[2] * 256u + r.at[3];
        const uint8_t *segment = r.at + 4;
        r.at += 2 + size;
        if (marker == 0xDA) {
            jpeg_scan(&r);
            break;
        }
        jpeg_segment(&r, marker, segment, size - 2);
    }
    d.trouble = r.trouble;
    return d;
}

static inline void jpeg_decoded_free(jpeg_decoded *d) {
    for (unsigned c = 0; c < 3; c++) {
        free(d->plane[c]);
    }
}

/* Y, Cb and Cr of a pixel, chroma as it is for all of its sample. */
static inline double jpeg_component(const jpeg_decoded *d, unsigned c, unsigned x, unsigned y) {
    return c == 0 ? d->plane[0][(size_t)y * d->stride[0] + x]
                  : d->plane[c][(size_t)(y / d->down) * d->stride[c] + x / d->across];
}

#endif
