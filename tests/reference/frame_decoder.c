/* frame_decoder - see frame_decoder.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/frame_decoder.h"

#include <stdlib.h>
#include <string.h>

static uint32_t word(const unsigned char *at) {
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static float number(const unsigned char *at) {
    const uint32_t bits = word(at);
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* `width` bits from bit `at`, the first the least. */
static uint64_t bits_of(const unsigned char *bytes, uint64_t at, uint32_t width) {
    uint64_t x = 0;
    for (uint32_t i = 0; i < width; i++, at++) {
        x |= (uint64_t)(bytes[at / 8] >> at % 8 & 1) << i;
    }
    return x;
}

/* CRC-32, bit by bit. */
static uint32_t sum(uint32_t crc, const unsigned char *bytes, size_t count) {
    crc = ~crc;
    for (size_t i = 0; i < 8 * count; i++) {
        const uint32_t bit = (crc ^ bytes[i / 8] >> i % 8) & 1;
        crc = crc >> 1 ^ (bit ? 0xEDB88320u : 0);
    }
    return ~crc;
}

static uint32_t bits_for(uint32_t most) {
    uint32_t n = 0;
    while (n < 32 && most >> n != 0) {
        n++;
    }
    return n;
}

static const unsigned char *find_section(frame_decoder *d, const unsigned char *image,
                                         uint32_t size, unsigned entry, uint32_t kind,
                                         uint64_t bytes, uint64_t summed) {
    const unsigned char *at = image + 104 + 16 * entry;
    const uint32_t offset = word(at + 4);
    const uint64_t padded = (bytes + 63) / 64 * 64;
    if (word(at) != kind || offset > size || padded > size - offset || word(at + 8) != padded) {
        d->sentence = "a section is not where it must be";
        return NULL;
    }
    if (sum(0, image + offset, (size_t)(summed > 0 ? summed : padded)) != word(at + 12)) {
        d->sentence = "a section's sum is wrong";
    }
    return image + offset;
}

frame_decoder frame_decoder_of(const unsigned char *image, uint32_t size) {
    frame_decoder d = {.triangles = word(image + 24),
                       .step = number(image + 180),
                       .bits = word(image + 184),
                       .vertices = word(image + 188),
                       .frames = word(image + 192),
                       .rate = word(image + 196),
                       .key_every = word(image + 200),
                       .frame_bytes = word(image + 204)};
    for (int a = 0; a < 3; a++) {
        d.origin[a] = number(image + 168 + 4 * a);
    }
    const uint64_t indices = 3 * (uint64_t)d.triangles * bits_for(d.vertices - 1);
    d.topology = find_section(&d, image, size, 2, 7, (indices + 7) / 8 + 8, 0);
    d.section =
        find_section(&d, image, size, 3, 8, (uint64_t)d.frame_bytes + 8, 4 * (d.frames + 1));
    return d;
}

uint32_t frame_vertex(const frame_decoder *d, uint32_t id, unsigned corner) {
    const uint32_t width = bits_for(d->vertices - 1);
    return (uint32_t)bits_of(d->topology, (3 * (uint64_t)id + corner) * width, width);
}

static uint32_t block_vertices(const frame_decoder *d, uint32_t block) {
    return d->vertices - 64 * block < 64 ? d->vertices - 64 * block : 64;
}

/* Adds a block's differences to `value`, three words per vertex; its bytes. 0: it is wrong. */
static uint32_t add_block(frame_decoder *d, const unsigned char *at, uint32_t frame, uint32_t block,
                          uint64_t *value) {
    const uint32_t w = d->bits > 0 ? d->bits : 32, count = block_vertices(d, block);
    unsigned char place[8] = {0};
    uint64_t width[3], least[3], bit = 32 + 18 + 3 * w, all = bit;
    for (uint32_t a = 0; a < 3; a++) {
        width[a] = bits_of(at, 32 + 6 * a, 6);
        least[a] = bits_of(at, 32 + 18 + w * a, w);
        all += count * width[a];
    }
    const uint32_t bytes = (uint32_t)((all + 31) / 32 * 4);
    for (int i = 0; i < 4; i++) {
        place[i] = (unsigned char)(frame >> 8 * i);
        place[4 + i] = (unsigned char)(block >> 8 * i);
    }
    if (sum(sum(0, place, 8), at + 4, bytes - 4) != word(at)) {
        d->sentence = "a block's check is wrong";
        return 0;
    }
    for (uint32_t a = 0; a < 3; a++) {
        for (uint32_t i = 0; i < count; i++, bit += width[a]) {
            uint64_t *v = &value[3 * (64 * (uint64_t)block + i) + a];
            *v = (*v + least[a] + bits_of(at, bit, (uint32_t)width[a])) % ((uint64_t)1 << w);
        }
    }
    return bytes;
}

/* Whole coordinates as floats: on the lattice, or in the order of floats, negative ones with all
 * bits but the sign inverted. */
static void to_floats(const frame_decoder *d, const uint64_t *value, float *position) {
    for (size_t i = 0; i < 3 * (size_t)d->vertices; i++) {
        if (d->bits > 0) {
            const float moved = d->step * (float)value[i];
            position[i] = d->origin[i % 3] + moved;
        } else {
            const uint32_t x = (uint32_t)value[i], bits = x >> 31 ? x ^ 0x7FFFFFFFu : x;
            memcpy(&position[i], &bits, sizeof bits);
        }
    }
}

uint32_t frame_decode(frame_decoder *d, uint32_t k, float *position) {
    const uint32_t key = k - k % d->key_every;
    uint64_t *value = calloc(3 * (size_t)d->vertices, sizeof *value);
    uint32_t read = 0;
    for (uint32_t frame = key; frame <= k && d->sentence == NULL; frame++) {
        uint32_t at = word(d->section + 4 * (size_t)frame);
        for (uint32_t block = 0; 64 * block < d->vertices && d->sentence == NULL; block++) {
            const uint32_t bytes = add_block(d, d->section + at, frame, block, value);
            at += bytes;
            read += bytes;
        }
        if (at != word(d->section + 4 * ((size_t)frame + 1))) {
            d->sentence = "a frame does not end where the next one begins";
        }
    }
    to_floats(d, value, position);
    free(value);
    return d->sentence == NULL ? read : 0;
}
