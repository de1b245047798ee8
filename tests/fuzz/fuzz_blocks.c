/* fuzz_blocks - a libFuzzer target: any bytes as a compact block
 *
 *   clang -g -O1 -fsanitize=fuzzer,address,undefined -I. \
 *       tests/fuzz/fuzz_blocks.c $(find engine -name "*.c") -lm
 *
 * Without libFuzzer, -DFUZZ_BLOCKS_MAIN gives a program that mutates blocks of its
 * own for as many seconds as its argument says (5):
 *
 *   cc -g -O1 -fsanitize=address,undefined -DFUZZ_BLOCKS_MAIN -I. \
 *       tests/fuzz/fuzz_blocks.c $(find engine -name "*.c") -lm -o fuzz_blocks
 *
 * Byte 0 chooses K (bits 0, 1), 14 or 21 bits (2), float records (3), and whether
 * the checks are made right (4), or hardly a mutation would pass them. The block
 * follows, with 8 bytes behind it and no more, so that sanitizers see over-reads.
 *
 * The oracle is SPEC.md, 5.2: a block that is valid (I10 to I16) can be decoded
 * without leaving it, has leaves of at most 2 K, coordinates below 2^22, and, as the
 * only block of an image, can be traced.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "engine/image/header.h"
#include "engine/tree/compact/validate_block.h"
#include "engine/tree/record.h"
#include "tests/reference/block_slots.h"
#include "tests/reference/compact_hostile.h"
#include "tests/reference/leaf_corners.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static unsigned long blocks_valid, blocks_traced;

static void promise(int kept, const char *sentence) {
    if (!kept) {
        fprintf(stderr, "%s\n", sentence);
        abort();
    }
}

/* Returns the depth of the block's tree. */
static uint32_t decode_boxes(const plt_block *b, const plt_lattice_box *bounds) {
    plt_lattice_box box[PLT_BLOCK_NODES_MOST], child[2];
    uint32_t depth[PLT_BLOCK_NODES_MOST] = {1}, deepest = 1;
    box[0] = *bounds;
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        block_children(b, slot / 2, &box[slot / 2], child);
        const uint32_t rank = plt_block_rank(b, plt_block_kind(b, slot), slot);
        if (plt_block_kind(b, slot) == PLT_SLOT_INNER) {
            promise(rank + 1 > slot / 2 && rank + 1 < b->nodes, "a child is not behind its node");
            box[rank + 1] = child[slot & 1];
            depth[rank + 1] = depth[slot / 2] + 1;
            deepest = depth[rank + 1] > deepest ? depth[rank + 1] : deepest;
        } else if (plt_block_kind(b, slot) == PLT_SLOT_EDGE) {
            promise(rank < b->edges && b->links + 4 * rank + 4 <= b->geometry, "no such edge");
        }
    }
    return deepest;
}

static void decode_leaves(const plt_block *b, const plt_block_tree *tree, const plt_geometry *g) {
    uint32_t corner[PLT_LEAF_TRIANGLES_MOST][3][3], sum = 0;
    for (uint32_t slot = 0; slot < 2 * b->nodes; slot++) {
        if (plt_block_kind(b, slot) != PLT_SLOT_LEAF) {
            continue;
        }
        const uint32_t leaf = plt_block_rank(b, PLT_SLOT_LEAF, slot);
        const int pair = (int)(b->pair[slot >> 5] >> (slot & 31) & 1u);
        uint32_t count;
        const uint32_t first = plt_leaf_find(g, leaf, block_pairs(b, slot), pair, &count);
        promise(first == sum && count >= 1 && count <= 2 * tree->leaf_triangles, "a leaf's size");
        sum += count;
        if (tree->leaf_kind == PLT_LEAF_STRIPS) {
            leaf_corners(g, first, count, corner);
            for (uint32_t i = 0; i < 9 * count; i++) {
                promise(corner[i / 9][i / 3 % 3][i % 3] < 1u << 22, "a coordinate is too large");
            }
        }
    }
    promise(sum == g->triangles, "leaves do not make up the block");
}

static plt_header header_of(const plt_block *b, const plt_block_tree *tree, uint32_t triangles,
                            uint32_t depth) {
    const uint32_t size = plt_block_bytes(b);
    plt_header h = {.info = {.triangles = triangles,
                             .nodes = b->nodes,
                             .node_slots = b->nodes,
                             .leaf_lists = b->leaves - b->pairs,
                             .intermediate_lists = b->pairs,
                             .treelets = 1,
                             .treelet_nodes = PLT_BLOCK_NODES_MOST,
                             .leaf_triangles = tree->leaf_triangles,
                             .depth_stack_entries = depth,
                             .node_bytes = size - b->geometry_bytes,
                             .triangle_bytes = b->geometry_bytes,
                             .source_triangles = triangles,
                             .nodes_format = PLT_NODES_COMPACT,
                             .geometry_format = tree->leaf_kind == PLT_LEAF_RECORDS
                                                    ? PLT_GEOMETRY_FLOAT
                                                    : PLT_GEOMETRY_LATTICE,
                             .lattice_bits = (uint8_t)tree->lattice.bits},
                    .root = plt_block_link(0, b->node_bytes),
                    .lattice = tree->lattice,
                    .lattice_box = tree->box};
    for (int a = 0; a < 3; a++) {
        h.info.lo[a] = plt_lattice_float(&tree->lattice, a, tree->box.lo[a]);
        h.info.hi[a] = plt_lattice_float(&tree->lattice, a, tree->box.hi[a]);
    }
    return h;
}

/* An image of this one block and nothing else. */
static void trace_alone(const plt_block *b, const plt_block_tree *tree, uint32_t triangles,
                        uint32_t depth) {
    plt_header h = header_of(b, tree, triangles, depth);
    unsigned char header[PLT_HEADER_BYTES];
    plt_header_write(header, &h);
    unsigned char *image = calloc(h.info.image_bytes, 1);
    memcpy(image, header, sizeof header);
    memcpy(image + PLT_HEADER_BYTES, b->bytes, b->node_bytes + b->geometry_bytes);
    for (uint32_t i = 0; i < triangles && tree->leaf_kind == PLT_LEAF_RECORDS; i++) {
        unsigned char *record = image + h.section[1].offset + PLT_RECORD_BYTES * i;
        for (uint32_t c = 0; c < 3; c++) {
            plt_put_floats(record + 12 * c, c == i % 3 ? h.info.hi : h.info.lo, 3);
        }
        plt_put_u32(record + 36, i);
    }
    compact_seal(image, h.info.image_bytes, 0);
    const hostile_result r = compact_try(image, h.info.image_bytes, depth & 1, 2);
    free(image);
    promise(r.sentence == NULL, r.sentence);
    promise(r.status == PLT_OK || r.status == PLT_ERR_LIMIT, "a valid block does not open");
    blocks_traced += r.status == PLT_OK;
}

static plt_block_tree tree_of(uint8_t choice) {
    const uint32_t bits = choice & 4 ? 21 : 14;
    const uint32_t most = (1u << bits) - 1;
    const plt_block_tree tree = {.leaf_triangles = (choice & 3) == 3 ? 2 : 1u << (choice & 3),
                                 .lattice = {{-1.0f, 0.0f, 2.0f}, 1.0f / 2097152.0f, bits},
                                 .leaf_kind = choice & 8 ? PLT_LEAF_RECORDS : PLT_LEAF_STRIPS,
                                 .box = {{0, 0, 0}, {most, most, most}}};
    return tree;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < 1 || size > 1u << 14) {
        return 0;
    }
    const uint32_t limit = (uint32_t)size - 1;
    const plt_block_tree tree = tree_of(data[0]);
    unsigned char *bytes = calloc(limit + COMPACT_BEHIND, 1);
    memcpy(bytes, data + 1, limit);
    if (data[0] & 16) {
        hostile_seal_block(bytes, limit, tree.lattice.bits, NULL);
    }
    if (plt_block_validate(bytes, limit, &tree) == 0) {
        plt_block b;
        plt_lattice_box bounds;
        plt_geometry g = {.triangles = 0};
        plt_block_open(&b, bytes, tree.lattice.bits);
        plt_block_bounds(&b, tree.lattice.bits, &bounds);
        const uint32_t depth = decode_boxes(&b, &bounds);
        if (b.leaves > 0) {
            tree.leaf_kind == PLT_LEAF_RECORDS
                ? plt_geometry_open_counts(&g, &b, tree.leaf_triangles)
                : plt_geometry_open(&g, &b, &bounds, tree.leaf_triangles);
            decode_leaves(&b, &tree, &g);
        }
        blocks_valid++;
        if (b.edges == 0 && g.first_triangle == 0) {
            trace_alone(&b, &tree, g.triangles, depth);
        }
    }
    free(bytes);
    return 0;
}

#if defined(FUZZ_BLOCKS_MAIN)
#include <time.h>

#include "engine/builder/blocks.h"
#include "tests/reference/random.h"
#include "tests/reference/room.h"

/* The first block of a scene of `count` random triangles; returns its bytes. */
static uint32_t block_of(random_state *r, uint8_t choice, unsigned char to[1 << 14]) {
    const plt_block_tree tree = tree_of(choice);
    uint32_t corners[9 * 64];
    const uint32_t count = 1 + random_below(r, 64);
    static unsigned char memory[1 << 16];
    plt_blocks_job job = {.triangles = {(const unsigned char *)corners, count, 4, 0},
                          .bits = tree.lattice.bits,
                          .leaf_triangles = tree.leaf_triangles,
                          .memory = memory,
                          .bytes = sizeof memory,
                          .scratch = room_get(plt_blocks_scratch_bytes(count))};
    for (uint32_t i = 0; i < 9 * count; i++) {
        corners[i] = random_below(r, 1u << (1 + random_below(r, tree.lattice.bits)));
    }
    job.triangles.width = 4;
    int status = plt_blocks_begin(&job);
    for (status = PLT_MORE; status == PLT_MORE;) {
        status = plt_blocks_step(&job);
    }
    free(job.scratch);
    const uint32_t bytes = job.used < (1 << 14) - 1 ? job.used : (1 << 14) - 1;
    memcpy(to, memory, bytes);
    return bytes;
}

int main(int count, char **argument) {
    static unsigned char input[1 << 14], block[1 << 14];
    random_state r = {1};
    unsigned long runs = 0;
    const time_t end = time(NULL) + (count > 1 ? atoi(argument[1]) : 5);
    while (time(NULL) < end) {
        input[0] = (unsigned char)((random_bits(&r) & 7) | 16);
        const uint32_t bytes = block_of(&r, input[0], block);
        for (int i = 0; i < 200; i++, runs++) {
            memcpy(input + 1, block, bytes);
            for (uint32_t times = random_below(&r, 4); times > 0; times--) {
                input[1 + random_below(&r, bytes)] ^= (unsigned char)(1u << random_below(&r, 8));
            }
            LLVMFuzzerTestOneInput(input,
                                   1 + (random_below(&r, 20) ? bytes : random_below(&r, bytes)));
        }
    }
    printf("%lu runs, %lu valid blocks, %lu traced\n", runs, blocks_valid, blocks_traced);
    return 0;
}
#endif
