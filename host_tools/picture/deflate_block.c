/* deflate_block - one deflate block: literals and matches in, the shortest coding out
 *
 * Source: P. Deutsch, RFC 1951 "DEFLATE Compressed Data Format", 1996,
 * sections 3.2.3 to 3.2.7.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/deflate_block.h"

#include <string.h>

#include "host_tools/picture/huffman.h"

#define MATCH 0x80000000u
#define END_OF_BLOCK 256
#define FIXED_LITERALS HUFFMAN_SYMBOLS /* two more than can occur, but they have codes */
#define STORED_MAX 65535u

typedef struct coding {
    uint8_t length[FIXED_LITERALS], distance_length[DEFLATE_DISTANCES];
    uint16_t code[FIXED_LITERALS], distance_code[DEFLATE_DISTANCES];
} coding;

/* How the code lengths themselves are sent. */
typedef struct header {
    uint16_t run[DEFLATE_LITERALS + DEFLATE_DISTANCES]; /* symbol | extra << 8 */
    unsigned runs, literals, distances, ordered;
    uint8_t length[HUFFMAN_LENGTH_CODES];
    uint16_t code[HUFFMAN_LENGTH_CODES];
    uint64_t cost; /* in bits */
} header;

/* Lengths and distances come in classes, 2^keep of them for every power of
 * two; the rest of the number follows as `extra` bits. */
static unsigned class_of(unsigned value, unsigned keep, unsigned *extra) {
    *extra = 0;
    while (value >> *extra >= 2u << keep) {
        ++*extra;
    }
    return (*extra << keep) + (value >> *extra);
}

static unsigned length_class(unsigned length_less_3, unsigned *extra) {
    if (length_less_3 == 255) { /* 258 has a class of its own */
        *extra = 0;
        return 28;
    }
    return class_of(length_less_3, 2, extra);
}

void deflate_block_clear(deflate_block *b) {
    b->tokens = 0;
    memset(b->literals, 0, sizeof b->literals);
    memset(b->distances, 0, sizeof b->distances);
    b->literals[END_OF_BLOCK] = 1;
}

void deflate_block_literal(deflate_block *b, uint8_t byte) {
    b->token[b->tokens++] = byte;
    b->literals[byte]++;
}

void deflate_block_match(deflate_block *b, unsigned length, unsigned distance) {
    unsigned extra;
    b->token[b->tokens++] = MATCH | (length - 3) << 16 | (distance - 1);
    b->literals[END_OF_BLOCK + 1 + length_class(length - 3, &extra)]++;
    b->distances[class_of(distance - 1, 1, &extra)]++;
}

static void fixed_coding(coding *c) {
    for (unsigned s = 0; s < FIXED_LITERALS; s++) {
        c->length[s] = s < 144 ? 8 : s < 256 ? 9 : s < 280 ? 7 : 8;
    }
    memset(c->distance_length, 5, sizeof c->distance_length);
    huffman_codes(c->length, FIXED_LITERALS, c->code);
    huffman_codes(c->distance_length, DEFLATE_DISTANCES, c->distance_code);
}

static void own_coding(const deflate_block *b, coding *c) {
    uint32_t distances[DEFLATE_DISTANCES];
    memcpy(distances, b->distances, sizeof distances);
    /* Two distance codes at least: old readers refuse an incomplete code. */
    distances[0] += distances[0] == 0;
    distances[1] += distances[1] == 0;
    huffman_lengths(b->literals, DEFLATE_LITERALS, HUFFMAN_LIMIT, c->length);
    huffman_lengths(distances, DEFLATE_DISTANCES, HUFFMAN_LIMIT, c->distance_length);
    huffman_codes(c->length, DEFLATE_LITERALS, c->code);
    huffman_codes(c->distance_length, DEFLATE_DISTANCES, c->distance_code);
}

/* Bits of all tokens and the end of block under `c`, without any header. */
static uint64_t body_cost(const deflate_block *b, const coding *c) {
    uint64_t cost = 0;
    for (unsigned s = 0; s < DEFLATE_LITERALS; s++) {
        const unsigned k = s > END_OF_BLOCK ? s - END_OF_BLOCK - 1 : 0;
        const unsigned extra = k < 8 || k == 28 ? 0 : k / 4 - 1;
        cost += (uint64_t)b->literals[s] * (c->length[s] + extra);
    }
    for (unsigned s = 0; s < DEFLATE_DISTANCES; s++) {
        const unsigned extra = s < 4 ? 0 : s / 2 - 1;
        cost += (uint64_t)b->distances[s] * (c->distance_length[s] + extra);
    }
    return cost;
}

static unsigned used_symbols(const uint8_t *length, unsigned symbols, unsigned least) {
    while (symbols > least && length[symbols - 1] == 0) {
        symbols--;
    }
    return symbols;
}

/* Splits lengths into runs: 16 repeats the last one 3 .. 6 times, 17 is
 * 3 .. 10 zeros, 18 is 11 .. 138 zeros. */
static void find_runs(header *h, const uint8_t *length, unsigned count) {
    for (unsigned at = 0; at < count;) {
        unsigned same = 1;
        while (at + same < count && length[at + same] == length[at]) {
            same++;
        }
        if (length[at] == 0 && same >= 3) {
            same = same > 138 ? 138 : same;
            h->run[h->runs++] =
                (uint16_t)(same < 11 ? 17 | (same - 3) << 8 : 18 | (same - 11) << 8);
        } else if (at > 0 && length[at] == length[at - 1] && same >= 3) {
            same = same > 6 ? 6 : same;
            h->run[h->runs++] = (uint16_t)(16 | (same - 3) << 8);
        } else {
            same = 1;
            h->run[h->runs++] = length[at];
        }
        at += same;
    }
}

static unsigned run_extra(unsigned symbol) {
    return symbol < 16 ? 0 : symbol == 16 ? 2 : symbol == 17 ? 3 : 7;
}

static void make_header(header *h, const coding *c) {
    uint8_t all[DEFLATE_LITERALS + DEFLATE_DISTANCES];
    uint32_t count[HUFFMAN_LENGTH_CODES] = {0};
    memset(h, 0, sizeof *h);
    h->literals = used_symbols(c->length, DEFLATE_LITERALS, END_OF_BLOCK + 1);
    h->distances = used_symbols(c->distance_length, DEFLATE_DISTANCES, 1);
    memcpy(all, c->length, h->literals);
    memcpy(all + h->literals, c->distance_length, h->distances);
    find_runs(h, all, h->literals + h->distances);
    for (unsigned i = 0; i < h->runs; i++) {
        count[h->run[i] & 255]++;
    }
    huffman_lengths(count, HUFFMAN_LENGTH_CODES, 7, h->length);
    huffman_codes(h->length, HUFFMAN_LENGTH_CODES, h->code);
    h->ordered = HUFFMAN_LENGTH_CODES;
    while (h->ordered > 4 && h->length[huffman_length_order[h->ordered - 1]] == 0) {
        h->ordered--;
    }
    h->cost = 14 + 3 * h->ordered;
    for (unsigned s = 0; s < HUFFMAN_LENGTH_CODES; s++) {
        h->cost += (uint64_t)count[s] * (h->length[s] + run_extra(s));
    }
}

static void write_header(const header *h, bits *out) {
    bits_put(out, h->literals - 257, 5);
    bits_put(out, h->distances - 1, 5);
    bits_put(out, h->ordered - 4, 4);
    for (unsigned i = 0; i < h->ordered; i++) {
        bits_put(out, h->length[huffman_length_order[i]], 3);
    }
    for (unsigned i = 0; i < h->runs; i++) {
        const unsigned symbol = h->run[i] & 255;
        bits_put(out, h->code[symbol], h->length[symbol]);
        bits_put(out, h->run[i] >> 8, run_extra(symbol));
    }
}

static void write_match(uint32_t token, const coding *c, bits *out) {
    const unsigned length = token >> 16 & 255, distance = token & 32767;
    unsigned extra;
    unsigned k = END_OF_BLOCK + 1 + length_class(length, &extra);
    bits_put(out, c->code[k], c->length[k]);
    bits_put(out, length & ((1u << extra) - 1), extra);
    k = class_of(distance, 1, &extra);
    bits_put(out, c->distance_code[k], c->distance_length[k]);
    bits_put(out, distance & ((1u << extra) - 1), extra);
}

static void write_body(const deflate_block *b, const coding *c, bits *out) {
    for (unsigned i = 0; i < b->tokens; i++) {
        const uint32_t token = b->token[i];
        if (token & MATCH) {
            write_match(token, c, out);
        } else {
            bits_put(out, c->code[token], c->length[token]);
        }
    }
    bits_put(out, c->code[END_OF_BLOCK], c->length[END_OF_BLOCK]);
}

static void write_stored(const uint8_t *raw, size_t size, int last, bits *out) {
    do {
        const unsigned part = size > STORED_MAX ? STORED_MAX : (unsigned)size;
        size -= part;
        bits_put(out, last && size == 0, 3);
        bits_align(out);
        bits_put(out, part | (uint32_t)(part ^ 65535u) << 16, 32);
        bits_bytes(out, raw, part);
        raw += part;
    } while (size);
}

void deflate_block_write(deflate_block *b, const uint8_t *raw, size_t size, int last, bits *out) {
    coding fixed, own;
    header h;
    fixed_coding(&fixed);
    own_coding(b, &own);
    make_header(&h, &own);
    const uint64_t fixed_cost = body_cost(b, &fixed), own_cost = h.cost + body_cost(b, &own);
    const uint64_t stored_cost = 8 * (uint64_t)size + 40 * (size / STORED_MAX + 1);
    if (stored_cost < fixed_cost && stored_cost < own_cost) {
        write_stored(raw, size, last, out);
    } else if (fixed_cost <= own_cost) {
        bits_put(out, (unsigned)last | 1 << 1, 3);
        write_body(b, &fixed, out);
    } else {
        bits_put(out, (unsigned)last | 2 << 1, 3);
        write_header(&h, out);
        write_body(b, &own, out);
    }
    deflate_block_clear(b);
}
