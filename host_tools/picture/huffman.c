/* huffman - prefix codes of bounded length for deflate
 *
 * The result depends on the counts alone: equal counts are ordered by
 * symbol, and two C libraries' sorts give the same file.
 *
 * Sources: J. van Leeuwen, "On the construction of Huffman trees", ICALP
 * 1976 (two queues); P. Deutsch, RFC 1951, 1996, section 3.2.2 (canonical
 * codes).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/huffman.h"

#include <stdlib.h>
#include <string.h>

const uint8_t huffman_length_order[HUFFMAN_LENGTH_CODES] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                            11, 4,  12, 3, 13, 2, 14, 1, 15};

typedef struct leaf {
    uint32_t count;
    uint32_t symbol;
} leaf;

static int rarer(const void *left, const void *right) {
    const leaf *a = left, *b = right;
    if (a->count != b->count) {
        return a->count < b->count ? -1 : 1;
    }
    return a->symbol < b->symbol ? -1 : 1;
}

static unsigned sorted_leaves(const uint32_t *count, unsigned symbols, leaf *leaves) {
    unsigned used = 0;
    for (unsigned s = 0; s < symbols; s++) {
        if (count[s]) {
            leaves[used++] = (leaf){count[s], s};
        }
    }
    qsort(leaves, used, sizeof *leaves, rarer);
    return used;
}

/* at_depth[d] = number of leaves at depth d. Merged nodes come out in
 * rising weight, so the two smallest are always at one of two fronts. */
static void tree_depths(const leaf *leaves, unsigned used, unsigned *at_depth) {
    uint64_t weight[2 * HUFFMAN_SYMBOLS];
    unsigned parent[2 * HUFFMAN_SYMBOLS], depth[2 * HUFFMAN_SYMBOLS];
    for (unsigned i = 0; i < used; i++) {
        weight[i] = leaves[i].count;
    }
    unsigned front_leaf = 0, front_merged = used;
    const unsigned nodes = 2 * used - 1;
    for (unsigned made = used; made < nodes; made++) {
        weight[made] = 0;
        for (unsigned child = 0; child < 2; child++) {
            const int leaf_next = front_leaf < used && (front_merged == made ||
                                                        weight[front_leaf] <= weight[front_merged]);
            const unsigned node = leaf_next ? front_leaf++ : front_merged++;
            weight[made] += weight[node];
            parent[node] = made;
        }
    }
    depth[nodes - 1] = 0;
    for (unsigned i = nodes - 1; i-- > 0;) {
        depth[i] = depth[parent[i]] + 1;
        at_depth[depth[i]] += i < used;
    }
}

/* Lifts leaves deeper than `limit` to it, then pays for them, in units of
 * 2^-limit of the code space, by splitting the deepest leaves above it. */
static void limit_depths(unsigned *at_depth, unsigned limit) {
    uint32_t spent = 0;
    for (unsigned d = HUFFMAN_SYMBOLS - 1; d > limit; d--) {
        at_depth[limit] += at_depth[d];
        at_depth[d] = 0;
    }
    for (unsigned d = 1; d <= limit; d++) {
        spent += at_depth[d] << (limit - d);
    }
    for (; spent > 1u << limit; spent--) {
        unsigned d = limit - 1;
        while (!at_depth[d]) {
            d--;
        }
        at_depth[limit]--;
        at_depth[d]--;
        at_depth[d + 1] += 2;
    }
}

void huffman_lengths(const uint32_t *count, unsigned symbols, unsigned limit, uint8_t *length) {
    leaf leaves[HUFFMAN_SYMBOLS];
    unsigned at_depth[HUFFMAN_SYMBOLS] = {0};
    memset(length, 0, symbols);
    unsigned rest = sorted_leaves(count, symbols, leaves);
    if (rest < 2) {
        if (rest) {
            length[leaves[0].symbol] = 1;
        }
        return;
    }
    tree_depths(leaves, rest, at_depth);
    limit_depths(at_depth, limit);
    for (unsigned d = 1; d <= limit; d++) {
        for (unsigned i = 0; i < at_depth[d]; i++) {
            length[leaves[--rest].symbol] = (uint8_t)d;
        }
    }
}

void huffman_codes(const uint8_t *length, unsigned symbols, uint16_t *code) {
    unsigned next = 0;
    for (unsigned bits = 1; bits <= HUFFMAN_LIMIT; bits++, next <<= 1) {
        for (unsigned s = 0; s < symbols; s++) {
            if (length[s] != bits) {
                continue;
            }
            unsigned reversed = 0;
            for (unsigned b = 0; b < bits; b++) {
                reversed |= (next >> b & 1) << (bits - 1 - b);
            }
            code[s] = (uint16_t)reversed;
            next++;
        }
    }
}
