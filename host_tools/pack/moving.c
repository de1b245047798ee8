/* moving - see moving.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/moving.h"

#include <math.h>
#include <string.h>

#include "engine/image/items.h"
#include "engine/motion/block_refit.h"
#include "engine/scene/compact_tree.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/checks.h"

static uint32_t steps(const plt_lattice *l, int axis, float x) {
    return (uint32_t)floor(((double)x - (double)l->origin[axis]) / (double)l->step + 0.5);
}

int moving_snap(snapped *s, const mesh *m, const plt_lattice *lattice) {
    const plt_lattice_box empty = {{UINT32_MAX, UINT32_MAX, UINT32_MAX}, {0, 0, 0}};
    memset(s, 0, sizeof *s);
    s->lattice = *lattice;
    s->box = empty;
    s->width = plt_corner_width(lattice->bits);
    if (snapped_make_room(s, m->triangles, 3) != 0) {
        return -1;
    }
    for (size_t i = 0; i < m->triangles; i++) {
        lattice_position p[3];
        for (size_t k = 0; k < 9; k++) {
            const float x = m->vertex[3 * (size_t)m->triangle[3 * i + k / 3] + k % 3];
            p[k / 3].q[k % 3] = steps(lattice, (int)(k % 3), x);
        }
        s->rotation[i] = 0;
        snapped_add(s, p, 3, (uint32_t)i);
    }
    return 0;
}

int moving_begin(plt_blocks_job *job, const snapped *s, const mesh *m, const moving_vertices *v,
                 int has_ids) {
    const uint64_t bytes = ((uint64_t)s->count + 1) * 3 * sizeof(uint32_t);
    uint32_t *names = heap_get(bytes);
    job->names = names;
    job->numbers = heap_get(bytes);
    job->has_turns = (uint8_t)has_ids;
    if (names == NULL || job->numbers == NULL) {
        return -1;
    }
    for (size_t i = 0; i < 3 * (size_t)s->count; i++) {
        names[i] = v->number[m->triangle[3 * (size_t)s->source[i / 3] + i % 3]];
    }
    return 0;
}

void moving_end(plt_blocks_job *job, moving_vertices *v) {
    heap_drop((void *)(uintptr_t)job->names);
    v->of_blocks = job->numbers;
    v->count = job->numbered;
}

/* Of all parts of all blocks. */
static void put_checks(unsigned char *blocks, const plt_block_tree *tree) {
    plt_block b;
    for (uint32_t at = 0; at < tree->used; at += plt_block_bytes(&b)) {
        unsigned char *bytes = blocks + at;
        plt_block_open(&b, bytes, tree->lattice.bits);
        unsigned char *geometry = bytes + b.node_bytes;
        const uint32_t nodes = plt_block_check(bytes, b.node_bytes, 2) ^ tree->salt;
        plt_put_u32(bytes, (plt_get_u32(bytes) & 0xFFFFu) | nodes << 16);
        if (b.geometry_bytes > 0) {
            const uint32_t check = plt_block_check(geometry, b.geometry_bytes, 6) ^ tree->salt;
            plt_put_u32(geometry + 4, (plt_get_u32(geometry + 4) & 0xFFFFu) | check << 16);
        }
    }
}

void moving_set_box(plt_header *h, const plt_lattice_box *of) {
    plt_box box;
    plt_lattice_to_box(&h->lattice, of, &box);
    for (int a = 0; a < 3; a++) {
        h->info.lo[a] = box.lo[a];
        h->info.hi[a] = box.hi[a];
    }
    h->lattice_box = *of;
}

int moving_put(const plt_header *h, unsigned char *blocks, unsigned char *ids, uint32_t frame,
               const plt_frame_vertex *vertex, const unsigned char *numbers, plt_lattice_box *box) {
    plt_block_tree tree = {.bytes = blocks, .used = h->info.node_bytes + h->info.triangle_bytes};
    plt_block_refit refit;
    void *room = heap_get(plt_block_refit_bytes(h->info.treelets));
    if (room == NULL) {
        return -1;
    }
    plt_compact_describe(&tree, h);
    tree.salt = plt_header_has_stills(&h->info) ? plt_still_salt(frame) : 0;
    plt_block_refit_open(&refit, room, &tree);
    const plt_block_numbers n = {vertex, numbers, plt_index_bits(h->info.vertices)};
    plt_block_refit_all(&refit, &tree, blocks, ids, &n);
    heap_drop(room);
    if (ids != NULL && h->info.has_checks) {
        checks_put_ids(blocks, ids, h);
    }
    put_checks(blocks, &tree);
    *box = tree.box;
    return 0;
}
