/* blocks_geometry - the leaves of a block: order, strips, local vertices
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/blocks_state.h"

#include <string.h>

#define NONE 0xFFFFu

/* Nodes breadth first: the root, then in order of parent and child. */
static void order_nodes(plt_blocks_state *s) {
    uint32_t count = 1;
    s->order_of[0] = 0;
    for (uint32_t i = 0; i < count; i++) {
        const plt_block_node *node = &s->node[s->order_of[i]];
        for (int c = 0; c < 2; c++) {
            if (node->kind[c] == PLT_SLOT_INNER) {
                s->order_of[count++] = node->node[c];
            }
        }
    }
}

/* The block's index of a vertex; NONE when there is no room. A new vertex gets the next
 * one. */
static uint32_t vertex_index(plt_blocks_state *s, const uint32_t position[3]) {
    const uint64_t key = plt_lattice_key(position);
    uint32_t at = (uint32_t)((key * 0x9E3779B97F4A7C15u) >> 54) % PLT_BLOCK_HASH;
    while (s->hash[at] != NONE && s->vertex[s->hash[at]] != key) {
        at = (at + 1) % PLT_BLOCK_HASH;
    }
    if (s->hash[at] == NONE) {
        if (s->vertices == PLT_BLOCK_VERTICES_MOST) {
            return NONE;
        }
        s->vertex[s->vertices] = key;
        s->hash[at] = (uint16_t)s->vertices++;
    }
    return s->hash[at];
}

static int add_reference(plt_blocks_state *s, const uint32_t position[3]) {
    const uint32_t index = vertex_index(s, position);
    s->reference[s->references++] = (uint16_t)index;
    return index != NONE;
}

/* A triangle joins the block, next in image order. */
static void add_triangle(plt_blocks_state *s, uint32_t triangle) {
    const uint32_t mesh = s->job->mesh == NULL ? 0 : s->job->mesh[triangle] + 1u;
    s->mesh = s->triangles == 0 || s->mesh == mesh ? mesh : 0;
    if (s->order != NULL) {
        s->order[s->job->written + s->triangles] = triangle;
    }
    s->triangles++;
}

/* Float records are put into image order by the owner of plt_blocks_record_order. */
static void add_records(plt_blocks_state *s, uint32_t first, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        add_triangle(s, plt_permuted(s, first + i));
    }
    s->leaf_count[s->leaves++] = (uint8_t)count;
}

/* By what vertices are told apart: where they are, or whose they are. */
static void corners_of(const plt_blocks_state *s, uint32_t triangle, uint32_t corner[3][3]) {
    plt_lattice_corners(&s->job->triangles, triangle, corner);
#if PLT_BLOCKS_LEVELS
    for (uint32_t k = 0; k < 3 && s->job->names != NULL; k++) {
        plt_block_name_put(corner[k], s->job->names[3 * (size_t)triangle + k]);
    }
#endif
}

static int add_leaf(plt_blocks_state *s, uint32_t first, uint32_t count) {
    if (s->job->triangles.boxes) {
        add_records(s, first, count);
        return 1;
    }
    uint32_t corner[PLT_LEAF_TRIANGLES_MOST][3][3], index[PLT_LEAF_TRIANGLES_MOST];
    plt_strip_step step[PLT_LEAF_TRIANGLES_MOST];
    for (uint32_t i = 0; i < count; i++) {
        index[i] = plt_permuted(s, first + i);
        corners_of(s, index[i], corner[i]);
    }
    plt_strips_find((const uint32_t(*)[3][3])corner, count, step);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t(*c)[3] = (const uint32_t(*)[3])corner[step[i].triangle];
        for (uint32_t k = step[i].start ? 0 : 2; k < 3; k++) {
            if (!add_reference(s, c[(step[i].rotation + k) % 3])) {
                return 0;
            }
        }
        s->flags[s->triangles] = (uint8_t)(step[i].start | step[i].swap << 1);
#if PLT_BLOCKS_LEVELS
        s->rotation[s->triangles] = step[i].rotation;
#endif
        add_triangle(s, index[step[i].triangle]);
    }
    s->leaf_count[s->leaves] = (uint8_t)count;
    s->leaves++;
    return 1;
}

/* Strips, references and positions. */
static uint32_t geometry_bits(const plt_blocks_state *s) {
    uint32_t vertex_bits = 0;
    for (int a = 0; a < 3; a++) {
        vertex_bits += plt_blocks_axis_bits(s, a);
    }
    const uint32_t ref_bits = plt_geometry_ref_bits(s->vertices);
    return 2 * s->triangles + s->references + (s->references - s->vertices) * ref_bits +
           s->vertices * vertex_bits;
}

uint32_t plt_blocks_geometry_bytes(const plt_blocks_state *s) {
    uint32_t bits = plt_geometry_count_strings(s->job->leaf_triangles) * s->leaves;
    bits += s->job->triangles.boxes ? 0 : geometry_bits(s);
#if PLT_BLOCKS_LEVELS
    bits += 8 * s->job->geometry_tail + 2 * s->job->has_turns * s->triangles;
#endif
    return (bits + 7) / 8;
}

int plt_blocks_collect_geometry(plt_blocks_state *s) {
    order_nodes(s);
    s->leaves = s->triangles = s->references = s->vertices = 0;
    memset(s->hash, 0xFF, sizeof s->hash);
    for (uint32_t i = 0; i < s->nodes; i++) {
        const plt_block_node *node = &s->node[s->order_of[i]];
        for (int c = 0; c < 2; c++) {
            if (node->kind[c] == PLT_SLOT_LEAF && !add_leaf(s, node->first[c], node->count[c])) {
                return 0;
            }
        }
    }
    return PLT_GEOMETRY_HEADER_BYTES + plt_blocks_geometry_bytes(s) <= PLT_BLOCK_GEOMETRY_MOST;
}
