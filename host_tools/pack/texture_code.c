/* texture_code - see texture_code.h
 *
 * A block begins with the ends of its colours along their main direction. Then, in turns, each
 * texel takes the nearest of the four colours, and the ends become those of least squares for that;
 * at last each of their components is tried one step up and down while that helps.
 *
 * Source of least squares: S. Brown, "DXT compression techniques", 2006.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/texture_code.h"

#include <math.h>
#include <string.h>

#include "engine/texture/texel.h"

enum { TEXELS = 16, FITS = 4, TRIES = 8 };

uint32_t texture_rgb565(const uint8_t rgb[3]) {
    const uint32_t r = (rgb[0] * 31u + 127) / 255, g = (rgb[1] * 63u + 127) / 255,
                   b = (rgb[2] * 31u + 127) / 255;
    return r << 11 | g << 5 | b;
}

static uint32_t squared(const uint8_t a[3], const uint8_t b[3]) {
    uint32_t sum = 0;
    for (int c = 0; c < 3; c++) {
        const int d = a[c] - b[c];
        sum += (uint32_t)(d * d);
    }
    return sum;
}

static void put_ends(unsigned char *block, const uint32_t end[2]) {
    for (int e = 0; e < 2; e++) {
        block[2 * e] = (unsigned char)(end[e] & 255u);
        block[2 * e + 1] = (unsigned char)(end[e] >> 8);
    }
}

/* Sets the texels' numbers; returns how far off they are. */
static uint32_t assign(const uint8_t texel[TEXELS][3], unsigned char *block) {
    uint8_t colour[4][3];
    uint32_t error = 0;
    for (uint32_t k = 0; k < 4; k++) {
        plt_block_colour(block, k, colour[k]);
    }
    memset(block + 4, 0, 4);
    for (unsigned i = 0; i < TEXELS; i++) {
        unsigned best = 0;
        for (unsigned k = 1; k < 4; k++) {
            best = squared(texel[i], colour[k]) < squared(texel[i], colour[best]) ? k : best;
        }
        block[4 + i / 4] |= (unsigned char)(best << 2 * (i % 4));
        error += squared(texel[i], colour[best]);
    }
    return error;
}

uint32_t texture_block_error(const uint8_t texel[TEXELS][3],
                             const unsigned char block[PLT_BLOCK_BYTES]) {
    uint32_t error = 0;
    for (unsigned i = 0; i < TEXELS; i++) {
        uint8_t colour[3];
        plt_block_colour(block, block[4 + i / 4] >> 2 * (i % 4) & 3u, colour);
        error += squared(texel[i], colour);
    }
    return error;
}

/* Keeps the better of two blocks. */
static int better(const uint8_t texel[TEXELS][3], const uint32_t end[2], unsigned char *block,
                  uint32_t *error) {
    unsigned char other[PLT_BLOCK_BYTES];
    put_ends(other, end);
    const uint32_t off = assign(texel, other);
    if (off >= *error) {
        return 0;
    }
    memcpy(block, other, sizeof other);
    *error = off;
    return 1;
}

static uint32_t code_of(const double at[3]) {
    uint8_t rgb[3];
    for (int c = 0; c < 3; c++) {
        rgb[c] = (uint8_t)(at[c] > 0.0 ? (at[c] < 255.0 ? at[c] + 0.5 : 255.0) : 0.0);
    }
    return texture_rgb565(rgb);
}

/* The direction in which colours differ most: the covariance's, by powers. */
static void main_direction(const uint8_t texel[TEXELS][3], const double mean[3], double to[3]) {
    double matrix[3][3] = {{0}};
    for (int i = 0; i < TEXELS; i++) {
        for (int a = 0; a < 9; a++) {
            matrix[a / 3][a % 3] +=
                (texel[i][a / 3] - mean[a / 3]) * (texel[i][a % 3] - mean[a % 3]);
        }
    }
    for (int c = 0; c < 3; c++) {
        to[c] = matrix[c][c] + 1e-3; /* not at right angles to it, but by chance */
    }
    for (int turn = 0; turn < TRIES; turn++) {
        double next[3], most = 0.0;
        for (int a = 0; a < 3; a++) {
            next[a] = matrix[a][0] * to[0] + matrix[a][1] * to[1] + matrix[a][2] * to[2];
            most = fabs(next[a]) > most ? fabs(next[a]) : most;
        }
        for (int a = 0; a < 3 && most > 0.0; a++) {
            to[a] = next[a] / most;
        }
    }
}

static void first_ends(const uint8_t texel[TEXELS][3], uint32_t end[2]) {
    double mean[3] = {0, 0, 0}, along[3], least = 0.0, most = 0.0, at[2][3];
    for (int i = 0; i < 3 * TEXELS; i++) {
        mean[i % 3] += texel[i / 3][i % 3] / (double)TEXELS;
    }
    main_direction(texel, mean, along);
    const double length = along[0] * along[0] + along[1] * along[1] + along[2] * along[2];
    for (int i = 0; i < TEXELS && length > 0.0; i++) {
        double t = 0.0;
        for (int c = 0; c < 3; c++) {
            t += (texel[i][c] - mean[c]) * along[c] / length;
        }
        least = t < least ? t : least;
        most = t > most ? t : most;
    }
    for (int c = 0; c < 3; c++) {
        at[0][c] = mean[c] + least * along[c];
        at[1][c] = mean[c] + most * along[c];
    }
    end[0] = code_of(at[0]);
    end[1] = code_of(at[1]);
}

/* The ends that suit the numbers best; 0: they are all of one colour. */
static int fit_ends(const uint8_t texel[TEXELS][3], const unsigned char *block, uint32_t end[2]) {
    static const double share[4] = {1.0, 0.0, 2.0 / 3.0, 1.0 / 3.0}; /* of the first end */
    double aa = 0, ab = 0, bb = 0, sum[2][3] = {{0}}, at[2][3];
    for (unsigned i = 0; i < TEXELS; i++) {
        const double a = share[block[4 + i / 4] >> 2 * (i % 4) & 3], b = 1.0 - a;
        aa += a * a;
        ab += a * b;
        bb += b * b;
        for (int c = 0; c < 3; c++) {
            sum[0][c] += a * texel[i][c];
            sum[1][c] += b * texel[i][c];
        }
    }
    const double under = aa * bb - ab * ab;
    if (under < 1e-6) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        at[0][c] = (sum[0][c] * bb - sum[1][c] * ab) / under;
        at[1][c] = (sum[1][c] * aa - sum[0][c] * ab) / under;
    }
    end[0] = code_of(at[0]);
    end[1] = code_of(at[1]);
    return 1;
}

/* One component of one end, a step up or down; 0: it has none. */
static int step(uint32_t end[2], unsigned which) {
    static const unsigned shift[3] = {0, 5, 11}, most[3] = {31, 63, 31};
    const unsigned e = which / 6, c = which / 2 % 3;
    const unsigned value = end[e] >> shift[c] & most[c];
    const int up = which % 2 == 0;
    if (value == (up ? most[c] : 0)) {
        return 0;
    }
    end[e] = up ? end[e] + (1u << shift[c]) : end[e] - (1u << shift[c]);
    return 1;
}

static int improve(const uint8_t texel[TEXELS][3], unsigned char *block, uint32_t *error) {
    int any = 0;
    for (unsigned which = 0; which < 12; which++) {
        uint32_t end[2] = {plt_texel_u16(block), plt_texel_u16(block + 2)};
        any |= step(end, which) && better(texel, end, block, error);
    }
    return any;
}

void texture_block(const uint8_t texel[TEXELS][3], unsigned char block[PLT_BLOCK_BYTES]) {
    uint32_t end[2], error = UINT32_MAX;
    first_ends(texel, end);
    better(texel, end, block, &error);
    for (int i = 0; i < FITS && fit_ends(texel, block, end); i++) {
        if (!better(texel, end, block, &error)) {
            break;
        }
    }
    for (int i = 0; i < TRIES && error > 0 && improve(texel, block, &error); i++) {
    }
}
