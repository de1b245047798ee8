/* inflate - see inflate.h
 *
 * Codes are read bit by bit. Canonical codes of one length are consecutive, so
 * a code minus the first code of its length is the index of its symbol among
 * those of that length. At most 15 steps per symbol: slow beside tables, and
 * fast enough for a picture.
 *
 * Source: P. Deutsch, RFC 1951, 1996. SPDX-License-Identifier: MIT */
#include "host_tools/picture/inflate.h"

#include <string.h>

#include "host_tools/picture/huffman.h"

enum { LITERALS = HUFFMAN_SYMBOLS, DISTANCES = 32, END = 256 };

typedef struct unpacking {
    const uint8_t *at, *end;
    uint8_t *to;
    size_t used, room;
    uint32_t held; /* bits that were read, lowest first */
    unsigned count;
    int wrong;
} unpacking;

typedef struct codes {
    uint16_t count[HUFFMAN_LIMIT + 1]; /* codes of each length */
    uint16_t symbol[LITERALS];         /* by length, then by value */
} codes;

static unsigned read_bits(unpacking *s, unsigned count) {
    while (s->count < count) {
        if (s->at == s->end) {
            s->wrong = 1;
            return 0;
        }
        s->held |= (uint32_t)*s->at++ << s->count;
        s->count += 8;
    }
    const unsigned value = s->held & ((1u << count) - 1);
    s->held >>= count;
    s->count -= count;
    return value;
}

static void make_codes(codes *c, const uint8_t *length, unsigned symbols) {
    uint16_t at[HUFFMAN_LIMIT + 1] = {0};
    memset(c, 0, sizeof *c);
    for (unsigned i = 0; i < symbols; i++) {
        c->count[length[i]]++;
    }
    c->count[0] = 0;
    for (unsigned l = 1; l < HUFFMAN_LIMIT; l++) {
        at[l + 1] = (uint16_t)(at[l] + c->count[l]);
    }
    for (unsigned i = 0; i < symbols; i++) {
        if (length[i] > 0) {
            c->symbol[at[length[i]]++] = (uint16_t)i;
        }
    }
}

static unsigned read_symbol(unpacking *s, const codes *c) {
    unsigned code = 0, first = 0, index = 0;
    for (unsigned l = 1; l <= HUFFMAN_LIMIT && !s->wrong; l++) {
        code = code << 1 | read_bits(s, 1);
        if (code - first < c->count[l]) {
            return c->symbol[index + code - first];
        }
        index += c->count[l];
        first = (first + c->count[l]) << 1;
    }
    s->wrong = 1;
    return END;
}

static void put_byte(unpacking *s, uint8_t byte) {
    if (s->used == s->room) {
        s->wrong = 1;
        return;
    }
    s->to[s->used++] = byte;
}

/* Section 3.2.5: lengths from 3 on, distances from 1 on, in groups that grow. */
static unsigned read_length(unpacking *s, unsigned symbol) {
    const unsigned n = symbol - 257;
    if (n < 8 || n == 28) {
        return n == 28 ? 258 : n + 3;
    }
    const unsigned extra = n / 4 - 1;
    return ((4 + n % 4) << extra) + 3 + read_bits(s, extra);
}

static unsigned read_distance(unpacking *s, const codes *distances) {
    const unsigned n = read_symbol(s, distances);
    if (n < 4) {
        return n + 1;
    }
    const unsigned extra = n / 2 - 1;
    return n > 29 ? 0 : ((2 + n % 2) << extra) + 1 + read_bits(s, extra);
}

static void copy_back(unpacking *s, unsigned symbol, const codes *distances) {
    const unsigned length = symbol > 285 ? 0 : read_length(s, symbol);
    const unsigned back = read_distance(s, distances);
    if (length == 0 || back == 0 || back > s->used) {
        s->wrong = 1;
    }
    for (unsigned i = 0; i < length && !s->wrong; i++) {
        put_byte(s, s->to[s->used - back]);
    }
}

static void read_coded(unpacking *s, const codes *literals, const codes *distances) {
    while (!s->wrong) {
        const unsigned symbol = read_symbol(s, literals);
        if (symbol == END) {
            return;
        }
        if (symbol < END) {
            put_byte(s, (uint8_t)symbol);
        } else {
            copy_back(s, symbol, distances);
        }
    }
}

static void read_stored(unpacking *s) {
    s->held = s->count = 0;
    const unsigned bytes = read_bits(s, 16);
    if (read_bits(s, 16) != (bytes ^ 0xFFFF)) {
        s->wrong = 1;
    }
    for (unsigned i = 0; i < bytes && !s->wrong; i++) {
        const uint8_t byte = (uint8_t)read_bits(s, 8);
        if (!s->wrong) {
            put_byte(s, byte);
        }
    }
}

static void read_fixed(unpacking *s) {
    uint8_t length[LITERALS];
    codes literals, distances;
    for (unsigned i = 0; i < LITERALS; i++) {
        length[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    }
    make_codes(&literals, length, LITERALS);
    memset(length, 5, DISTANCES);
    make_codes(&distances, length, DISTANCES);
    read_coded(s, &literals, &distances);
}

/* Section 3.2.7: code lengths, packed by a code of their own. */
static void read_lengths(unpacking *s, const codes *c, uint8_t *length, unsigned count) {
    for (unsigned i = 0; i < count && !s->wrong;) {
        const unsigned symbol = read_symbol(s, c);
        unsigned times = 1;
        uint8_t value = (uint8_t)symbol;
        if (symbol >= 16) {
            value = symbol == 16 && i > 0 ? length[i - 1] : 0;
            times = symbol == 16   ? 3 + read_bits(s, 2)
                    : symbol == 17 ? 3 + read_bits(s, 3)
                                   : 11 + read_bits(s, 7);
        }
        for (; times > 0 && i < count; times--) {
            length[i++] = value;
        }
    }
}

static void read_dynamic(unpacking *s) {
    uint8_t length[LITERALS + DISTANCES] = {0}, small[HUFFMAN_LENGTH_CODES] = {0};
    codes literals, distances, lengths;
    const unsigned many = read_bits(s, 5) + 257, few = read_bits(s, 5) + 1;
    const unsigned smalls = read_bits(s, 4) + 4;
    for (unsigned i = 0; i < smalls; i++) {
        small[huffman_length_order[i]] = (uint8_t)read_bits(s, 3);
    }
    make_codes(&lengths, small, sizeof small);
    read_lengths(s, &lengths, length, many + few);
    make_codes(&literals, length, many);
    make_codes(&distances, length + many, few);
    read_coded(s, &literals, &distances);
}

size_t inflate_bytes(const uint8_t *from, size_t bytes, uint8_t *to, size_t room) {
    unpacking s = {.at = from, .end = from + bytes, .to = to, .room = room};
    for (int last = 0; !last && !s.wrong;) {
        last = (int)read_bits(&s, 1);
        const unsigned kind = read_bits(&s, 2);
        if (kind == 0) {
            read_stored(&s);
        } else if (kind == 1) {
            read_fixed(&s);
        } else if (kind == 2) {
            read_dynamic(&s);
        } else {
            s.wrong = 1;
        }
    }
    return s.used;
}
