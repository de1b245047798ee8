/* bits - a growing string of bits, least significant first
 *
 * The room doubles: appending costs amortised constant time.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/bits.h"

#include <stdlib.h>
#include <string.h>

static int make_room(bits *b, size_t more) {
    if (b->failed || more > SIZE_MAX / 4 - b->size) {
        b->failed = 1;
        return -1;
    }
    if (b->size + more <= b->room) {
        return 0;
    }
    const size_t room = 2 * (b->size + more) + 256;
    uint8_t *bytes = realloc(b->bytes, room);
    if (!bytes) {
        b->failed = 1;
        return -1;
    }
    b->bytes = bytes;
    b->room = room;
    return 0;
}

void bits_put(bits *b, uint32_t value, unsigned count) {
    b->hold |= (uint64_t)value << b->held; /* at most 7 + 32 bits */
    b->held += count;
    if (make_room(b, 8)) {
        b->hold = b->held = 0;
        return;
    }
    while (b->held >= 8) {
        b->bytes[b->size++] = (uint8_t)b->hold;
        b->hold >>= 8;
        b->held -= 8;
    }
}

void bits_align(bits *b) {
    bits_put(b, 0, (8 - b->held) & 7);
}

void bits_bytes(bits *b, const uint8_t *bytes, size_t count) {
    if (count == 0 || make_room(b, count)) {
        return;
    }
    memcpy(b->bytes + b->size, bytes, count);
    b->size += count;
}

void bits_big32(bits *b, uint32_t value) {
    const uint8_t four[4] = {(uint8_t)(value >> 24), (uint8_t)(value >> 16), (uint8_t)(value >> 8),
                             (uint8_t)value};
    bits_bytes(b, four, sizeof four);
}

void bits_free(bits *b) {
    free(b->bytes);
    memset(b, 0, sizeof *b);
}
