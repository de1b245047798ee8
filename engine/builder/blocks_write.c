/* blocks_write - the block in hand to memory, bit for bit as SPEC.md has it
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/blocks_state.h"

#include <string.h>

static uint32_t count_edges(const plt_blocks_state *s) {
    uint32_t edges = 0;
    for (uint32_t i = 0; i < s->nodes; i++) {
        edges += (uint32_t)(s->node[i].kind[0] == PLT_SLOT_EDGE) +
                 (uint32_t)(s->node[i].kind[1] == PLT_SLOT_EDGE);
    }
    return edges;
}

static uint32_t links_offset(const plt_blocks_state *s) {
    return plt_block_parts_bytes(s->nodes, 0, s->job->bits);
}

void plt_blocks_link_offsets(const plt_blocks_state *s, uint32_t *offset) {
    uint32_t at = links_offset(s);
    for (uint32_t i = 0; i < s->nodes; i++) {
        for (uint32_t c = 0; c < 2; c++) {
            const uint32_t node = s->order_of[i];
            if (s->node[node].kind[c] == PLT_SLOT_EDGE) {
                offset[2 * node + c] = at;
                at += 4;
            }
        }
    }
}

static void write_bounds(const plt_blocks_state *s, unsigned char *at) {
    const uint32_t width = plt_block_bounds_width(s->job->bits);
    for (uint32_t a = 0; a < 3; a++) {
        plt_bits_put(at, a * width, width, s->at.bounds.lo[a]);
        plt_bits_put(at, (a + 3) * width, width, s->at.bounds.hi[a]);
    }
}

static void write_nodes(const plt_blocks_state *s, unsigned char *bytes) {
    const uint32_t k = s->job->leaf_triangles, mask_bytes = (2 * s->nodes + 7) / 8;
    unsigned char *mask_a = bytes + PLT_BLOCK_HEADER_BYTES + plt_block_bounds_bytes(s->job->bits);
    unsigned char *mask_b = mask_a + mask_bytes, *owners = mask_b + mask_bytes;
    unsigned char *planes = owners + (5 * s->nodes + 7) / 8;
    for (uint32_t i = 0; i < s->nodes; i++) {
        const plt_block_node *node = &s->node[s->order_of[i]];
        for (uint32_t c = 0; c < 2; c++) {
            const int leaf = node->kind[c] == PLT_SLOT_LEAF;
            const int b = leaf ? node->count[c] > k : node->kind[c] == PLT_SLOT_EDGE;
            plt_bits_put(mask_a, 2 * i + c, 1, !leaf);
            plt_bits_put(mask_b, 2 * i + c, 1, (uint32_t)b);
        }
        plt_bits_put(owners, 5 * i, 5, node->owners >> 1);
        memcpy(planes + 6 * i, node->plane, 6);
    }
    write_bounds(s, bytes + PLT_BLOCK_HEADER_BYTES);
}

/* Strings of the geometry part; returns the bits written. */
static uint32_t write_counts(const plt_blocks_state *s, unsigned char *bytes, uint32_t at) {
    const uint32_t k = s->job->leaf_triangles, strings = plt_geometry_count_strings(k);
    for (uint32_t u = 0; u < s->leaves; u++) {
        const uint32_t count = s->leaf_count[u], rest = count - 1 - (count > k ? k : 0);
        for (uint32_t i = 0; i < strings; i++) {
            plt_bits_put(bytes, at + i * s->leaves + u, 1, rest >> i);
        }
    }
    return at + strings * s->leaves;
}

static uint32_t write_strips(const plt_blocks_state *s, unsigned char *bytes, uint32_t at) {
    const uint32_t ref_bits = plt_geometry_ref_bits(s->vertices);
    for (uint32_t i = 0; i < s->triangles; i++) {
        plt_bits_put(bytes, at + i, 1, s->flags[i]);
        plt_bits_put(bytes, at + s->triangles + i, 1, s->flags[i] >> 1);
    }
    at += 2 * s->triangles;
    uint32_t ref = at + s->references, known = 0;
    for (uint32_t i = 0; i < s->references; i++) {
        if (s->reference[i] == known) {
            plt_bits_put(bytes, at + i, 1, 1);
            known++;
        } else {
            plt_bits_put(bytes, ref, ref_bits, s->reference[i]);
            ref += ref_bits;
        }
    }
    return ref;
}

static uint32_t write_vertices(const plt_blocks_state *s, unsigned char *bytes, uint32_t at) {
    const plt_lattice_box *f = &s->at.bounds;
    for (uint32_t v = 0; v < s->vertices; v++) {
        for (uint32_t a = 0; a < 3; a++) {
            const uint32_t q = (uint32_t)(s->vertex[v] >> 21 * (2 - a)) & 0x1FFFFFu;
            const uint32_t width = plt_bits_for(f->hi[a] - f->lo[a]);
            plt_bits_put(bytes, at, width, q - f->lo[a]);
            at += width;
        }
    }
    return at;
}

#if PLT_BLOCKS_LEVELS
/* Vertices by their numbers; where they are comes with every frame, the first one, too. Then, of
 * each triangle, which corner of its strip's is the mesh's first. */
static void write_names(const plt_blocks_state *s, unsigned char *bytes, uint32_t at) {
    plt_blocks_job *job = s->job;
    for (uint32_t v = 0; v < s->vertices; v++) {
        job->numbers[job->numbered + v] = plt_block_name_of(s->vertex[v]);
    }
    at += 3 * job->bits * s->vertices;
    for (uint32_t i = 0; i < s->triangles && job->has_turns; i++) {
        plt_bits_put(bytes, at + 2 * i, 2, (3u - s->rotation[i]) % 3u);
    }
}
#endif

static uint32_t geometry_bytes(const plt_blocks_state *s) {
    const uint32_t bytes = PLT_GEOMETRY_HEADER_BYTES + plt_blocks_geometry_bytes(s);
    return s->leaves == 0 ? 0 : plt_block_pad(bytes);
}

static void write_shapes(const plt_blocks_state *s, unsigned char *bytes, uint32_t at) {
    at = write_strips(s, bytes, at);
#if PLT_BLOCKS_LEVELS
    if (s->job->names != NULL) {
        write_names(s, bytes, at);
        return;
    }
#endif
    write_vertices(s, bytes, at);
}

static void write_geometry(const plt_blocks_state *s, unsigned char *bytes, uint32_t size) {
    uint32_t at = 8 * PLT_GEOMETRY_HEADER_BYTES;
    at = write_counts(s, bytes, at);
    if (!s->job->triangles.boxes) {
        write_shapes(s, bytes, at);
    }
    plt_put_u32(bytes, s->job->written | s->vertices << 27);
    const uint32_t word1 = s->vertices >> 5 | s->mesh << 6;
    plt_put_u32(bytes + 4, word1);
    const uint32_t check = plt_block_check(bytes, size, 6);
    plt_put_u32(bytes + 4, word1 | check << 16);
}

static void set_link(plt_blocks_state *s, uint32_t link) {
    if (s->at.link_at == PLT_LINK_NONE) {
        s->job->root = link;
    } else {
        plt_put_u32(s->job->memory + s->at.link_at, link);
    }
}

int plt_blocks_write(plt_blocks_state *s) {
    plt_blocks_job *job = s->job;
    const uint32_t geometry = geometry_bytes(s);
    const uint32_t node_part = plt_block_nodes_bytes(s->nodes, count_edges(s), job->bits);
    const uint32_t size = plt_block_pad(node_part + geometry);
    const size_t room =
        (size_t)(s->permutation - job->memory) + (size_t)s->at.first * s->index_bytes;
    const size_t need =
        (size_t)job->used + size + (size_t)(job->triangles.count - s->at.first) * s->index_bytes;
    job->peak = need > job->peak ? need : job->peak;
    if ((size_t)job->used + size > room) {
        return PLT_ERR_ARENA;
    }
    if (job->used + size > PLT_BLOCKS_BYTES_MAX) {
        return plt_blocks_limited(s, PLT_BLOCKS_LIMIT_BYTES);
    }
    unsigned char *bytes = job->memory + job->used;
    memset(bytes, 0, size);
    write_nodes(s, bytes);
    if (geometry > 0) {
        write_geometry(s, bytes + node_part, geometry);
    }
    plt_put_u32(bytes, (s->nodes - 1) | geometry / 8 << 6);
    set_link(s, plt_block_link(job->used, node_part));
    job->used += size;
    job->node_bytes += size - geometry;
    job->blocks++;
    job->nodes += s->nodes;
    job->leaves += s->leaves;
    job->written += s->triangles;
#if PLT_BLOCKS_LEVELS
    job->numbered += job->names != NULL ? s->vertices : 0;
#endif
    for (uint32_t i = 0; i < s->nodes; i++) { /* only of blocks that are kept */
        const uint32_t depth = s->at.depth + s->node[i].level + 1;
        job->depth = depth > job->depth ? depth : job->depth;
    }
    for (uint32_t u = 0; u < s->leaves; u++) {
        job->pairs += s->leaf_count[u] > job->leaf_triangles;
    }
    return PLT_OK;
}
