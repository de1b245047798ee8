/* deflate - lossless compression as PNG wants it
 *
 * Lazy matching over hash chains: a match is held back one byte to see
 * whether a longer one starts there. A search ends after CHAIN_MAX steps
 * or at the longest possible match: time is linear.
 *
 * Invariant: head and prev hold position + 1 of earlier positions only,
 * 0 for none; prev is a ring of the last WINDOW positions.
 *
 * Sources: P. Deutsch, J.-L. Gailly, RFC 1950 "ZLIB", 1996; P. Deutsch, RFC
 * 1951 "DEFLATE", 1996, section 4 (lazy matching).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/deflate.h"

#include <stdlib.h>

#include "host_tools/picture/deflate_block.h"

#define WINDOW 32768u /* RFC 1951, 2: how far back a match may lie */
#define HASH_BITS 15
#define SHORTEST 3u
#define LONGEST 258u
#define FAR 4096u /* three bytes from further back cost more than literals */
#define CHAIN_MAX 256

typedef struct matcher {
    uint32_t head[1u << HASH_BITS], prev[WINDOW];
    const uint8_t *data;
    size_t size;
    deflate_block tokens;
} matcher;

typedef struct match {
    unsigned length, distance; /* length 0: none */
} match;

static unsigned hash3(const uint8_t *p) {
    const uint32_t three = p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16;
    return three * 2654435761u >> (32 - HASH_BITS);
}

static void insert(matcher *m, size_t at) {
    if (m->size - at >= SHORTEST) {
        const unsigned h = hash3(m->data + at);
        m->prev[at % WINDOW] = m->head[h];
        m->head[h] = (uint32_t)at + 1;
    }
}

static unsigned common(const uint8_t *a, const uint8_t *b, unsigned most) {
    unsigned n = 0;
    while (n < most && a[n] == b[n]) {
        n++;
    }
    return n;
}

/* The longest earlier match for `at` that is longer than `floor`. */
static match find(const matcher *m, size_t at, unsigned floor) {
    match best = {0, 0};
    if (m->size - at < SHORTEST) {
        return best;
    }
    const uint8_t *here = m->data + at;
    const unsigned most = m->size - at < LONGEST ? (unsigned)(m->size - at) : LONGEST;
    unsigned least = floor < SHORTEST - 1 ? SHORTEST - 1 : floor;
    uint32_t next = m->head[hash3(here)];
    for (unsigned steps = 0; next && steps < CHAIN_MAX && least < most; steps++) {
        const size_t from = next - 1, distance = at - from;
        if (distance > WINDOW) {
            break;
        }
        if (m->data[from + least] == here[least]) {
            const unsigned length = common(m->data + from, here, most);
            if (length > least && (length > SHORTEST || distance <= FAR)) {
                best = (match){length, (unsigned)distance};
                least = length;
            }
        }
        next = m->prev[from % WINDOW]; /* not yet overwritten: from > at - 1 - WINDOW */
    }
    return best;
}

/* One token at `at`; returns the number of bytes it stands for. `held` is
 * the match at `at` on entry and the one at the end of the token on return. */
static unsigned emit(matcher *m, size_t at, match *held) {
    const match now = *held;
    insert(m, at);
    *held = (match){0, 0};
    if (now.length < LONGEST && at + 1 < m->size) {
        *held = find(m, at + 1, now.length);
    }
    if (now.length == 0 || held->length > now.length) {
        deflate_block_literal(&m->tokens, m->data[at]);
        return 1;
    }
    for (unsigned i = 1; i < now.length; i++) {
        insert(m, at + i);
    }
    deflate_block_match(&m->tokens, now.length, now.distance);
    const size_t end = at + now.length;
    *held = end < m->size ? find(m, end, 0) : (match){0, 0};
    return now.length;
}

static void pack(matcher *m, bits *out) {
    match held = {0, 0};
    size_t at = 0, begin = 0;
    deflate_block_clear(&m->tokens);
    while (at < m->size) {
        at += emit(m, at, &held);
        if (m->tokens.tokens == DEFLATE_TOKENS && at < m->size) {
            deflate_block_write(&m->tokens, m->data + begin, at - begin, 0, out);
            begin = at;
        }
    }
    deflate_block_write(&m->tokens, m->data + begin, m->size - begin, 1, out);
}

static uint32_t adler32(const uint8_t *data, size_t size) {
    uint32_t a = 1, b = 0;
    while (size) {
        /* 5552: the most bytes for which b stays below 2^32. */
        const size_t part = size > 5552 ? 5552 : size;
        for (size_t i = 0; i < part; i++) {
            a += data[i];
            b += a;
        }
        a %= 65521;
        b %= 65521;
        data += part;
        size -= part;
    }
    return b << 16 | a;
}

int deflate_zlib(bits *out, const uint8_t *data, size_t size) {
    matcher *m = calloc(1, sizeof *m);
    if (!m) {
        return -1;
    }
    m->data = data;
    m->size = size;
    bits_put(out, 0x9C78, 16); /* 32 KB window, check bits */
    pack(m, out);
    bits_align(out);
    bits_big32(out, adler32(data, size));
    free(m);
    return out->failed ? -1 : 0;
}
