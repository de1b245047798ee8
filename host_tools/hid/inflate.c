/* inflate - see inflate.h
 *
 * Codes are read bit by bit with counts of codes a length: canonical codes of
 * a length are consecutive, so a code minus the first of its length is the
 * place of its symbol. At most 15 steps a symbol: slow beside tables, and
 * fast enough for a picture.
 *
 * Source: P. Deutsch, RFC 1951, 1996. SPDX-License-Identifier: MIT */
#include "host_tools/hid/inflate.h"

#include <string.h>

enum { LENGTH_MAX = 15, LITERALS = 288, DISTANCES = 32, END = 256 };

typedef struct stream {
    const uint8_t *at, *end;
    uint8_t *to;
    size_t used, room;
    uint32_t held; /* bits that were read, lowest first */
    unsigned count;
    int wrong;
} stream;

typedef struct codes {
    uint16_t count[LENGTH_MAX + 1]; /* codes of each length */
    uint16_t symbol[LITERALS];      /* by length, then by value */
} codes;

static unsigned take_bits(stream *s, unsigned count) {
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
    uint16_t at[LENGTH_MAX + 1] = {0};
    memset(c, 0, sizeof *c);
    for (unsigned i = 0; i < symbols; i++) {
        c->count[length[i]]++;
    }
    c->count[0] = 0;
    for (unsigned l = 1; l < LENGTH_MAX; l++) {
        at[l + 1] = (uint16_t)(at[l] + c->count[l]);
    }
    for (unsigned i = 0; i < symbols; i++) {
        if (length[i] > 0) {
            c->symbol[at[length[i]]++] = (uint16_t)i;
        }
    }
}

static unsigned take_symbol(stream *s, const codes *c) {
    unsigned code = 0, first = 0, place = 0;
    for (unsigned l = 1; l <= LENGTH_MAX && !s->wrong; l++) {
        code = code << 1 | take_bits(s, 1);
        if (code - first < c->count[l]) {
            return c->symbol[place + code - first];
        }
        place += c->count[l];
        first = (first + c->count[l]) << 1;
    }
    s->wrong = 1;
    return END;
}

static void put_byte(stream *s, uint8_t byte) {
    if (s->used == s->room) {
        s->wrong = 1;
        return;
    }
    s->to[s->used++] = byte;
}

/* Section 3.2.5: lengths from 3 on, distances from 1 on, in groups that grow. */
static unsigned take_length(stream *s, unsigned symbol) {
    const unsigned n = symbol - 257;
    if (n < 8 || n == 28) {
        return n == 28 ? 258 : n + 3;
    }
    const unsigned extra = n / 4 - 1;
    return ((4 + n % 4) << extra) + 3 + take_bits(s, extra);
}

static unsigned take_distance(stream *s, const codes *distances) {
    const unsigned n = take_symbol(s, distances);
    if (n < 4) {
        return n + 1;
    }
    const unsigned extra = n / 2 - 1;
    return n > 29 ? 0 : ((2 + n % 2) << extra) + 1 + take_bits(s, extra);
}

static void copy_back(stream *s, unsigned symbol, const codes *distances) {
    const unsigned length = symbol > 285 ? 0 : take_length(s, symbol);
    const unsigned back = take_distance(s, distances);
    if (length == 0 || back == 0 || back > s->used) {
        s->wrong = 1;
    }
    for (unsigned i = 0; i < length && !s->wrong; i++) {
        put_byte(s, s->to[s->used - back]);
    }
}

static void take_coded(stream *s, const codes *literals, const codes *distances) {
    while (!s->wrong) {
        const unsigned symbol = take_symbol(s, literals);
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

static void take_stored(stream *s) {
    s->held = s->count = 0;
    const unsigned bytes = take_bits(s, 16);
    if (take_bits(s, 16) != (bytes ^ 0xFFFF)) {
        s->wrong = 1;
    }
    for (unsigned i = 0; i < bytes && !s->wrong; i++) {
        put_byte(s, (uint8_t)take_bits(s, 8));
    }
}

static void take_fixed(stream *s) {
    uint8_t length[LITERALS];
    codes literals, distances;
    for (unsigned i = 0; i < LITERALS; i++) {
        length[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    }
    make_codes(&literals, length, LITERALS);
    memset(length, 5, DISTANCES);
    make_codes(&distances, length, DISTANCES);
    take_coded(s, &literals, &distances);
}

/* Section 3.2.7: code lengths, packed by a code of their own. */
static void take_lengths(stream *s, const codes *c, uint8_t *length, unsigned count) {
    for (unsigned i = 0; i < count && !s->wrong;) {
        const unsigned symbol = take_symbol(s, c);
        unsigned times = 1;
        uint8_t value = (uint8_t)symbol;
        if (symbol >= 16) {
            value = symbol == 16 && i > 0 ? length[i - 1] : 0;
            times = symbol == 16   ? 3 + take_bits(s, 2)
                    : symbol == 17 ? 3 + take_bits(s, 3)
                                   : 11 + take_bits(s, 7);
        }
        for (; times > 0 && i < count; times--) {
            length[i++] = value;
        }
    }
}

static void take_dynamic(stream *s) {
    static const uint8_t order[] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                    11, 4,  12, 3, 13, 2, 14, 1, 15};
    uint8_t length[LITERALS + DISTANCES] = {0}, small[19] = {0};
    codes literals, distances, lengths;
    const unsigned many = take_bits(s, 5) + 257, few = take_bits(s, 5) + 1;
    const unsigned smalls = take_bits(s, 4) + 4;
    for (unsigned i = 0; i < smalls; i++) {
        small[order[i]] = (uint8_t)take_bits(s, 3);
    }
    make_codes(&lengths, small, sizeof small);
    take_lengths(s, &lengths, length, many + few);
    make_codes(&literals, length, many);
    make_codes(&distances, length + many, few);
    take_coded(s, &literals, &distances);
}

size_t inflate_bytes(const uint8_t *from, size_t bytes, uint8_t *to, size_t room) {
    stream s = {.at = from, .end = from + bytes, .to = to, .room = room};
    for (int last = 0; !last && !s.wrong;) {
        last = (int)take_bits(&s, 1);
        const unsigned kind = take_bits(&s, 2);
        if (kind == 0) {
            take_stored(&s);
        } else if (kind == 1) {
            take_fixed(&s);
        } else if (kind == 2) {
            take_dynamic(&s);
        } else {
            s.wrong = 1;
        }
    }
    return s.used;
}
