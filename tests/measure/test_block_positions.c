/* test_block_positions [IMAGE...] - what room to move costs compact blocks, by how it is given
 *
 * Of sequences of compact blocks, all frames: bytes per triangle of positions as offsets in the
 * bounds of the frame alone; in as many bits as the widest bounds of the block take; in the box of
 * the block's vertices over all frames; and as they are, lattice coordinates. Then of numbers of
 * vertices instead, and of the vertices of a frame; and what a frame takes in the image. Without
 * an image it takes a small one and is one test more; the figures are for people.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/engine.h"
#include "host_tools/base/heap.h"
#include "tests/reference/sequence_rig.h"
#include "tests/test.h"

typedef struct widths {
    uint32_t widest[3];  /* of the block's bounds, in any frame */
    plt_lattice_box all; /* of its vertices in all frames */
    uint64_t alone;      /* bits of a vertex, all frames together */
    uint32_t vertices;
} widths;

typedef struct sums {
    double alone, widest, all, absolute; /* bits */

} sums;

static uint32_t bits_of(const plt_lattice_box *b, int axis) {
    return plt_bits_for(b->hi[axis] - b->lo[axis]);
}

static void add_vertices(widths *w, const plt_geometry *g) {
    for (uint32_t v = 0; v < g->vertices; v++) {
        uint32_t q[3];
        plt_leaf_vertex(g, v, q);
        for (int a = 0; a < 3; a++) {
            w->all.lo[a] = q[a] < w->all.lo[a] ? q[a] : w->all.lo[a];
            w->all.hi[a] = q[a] > w->all.hi[a] ? q[a] : w->all.hi[a];
        }
    }
}

static void add_block(widths *w, const plt_block_tree *t, const plt_block *b) {
    plt_lattice_box bounds, frame = {{0}, {0}};
    plt_geometry g;
    plt_block_bounds(b, t->lattice.bits, &bounds);
    for (int a = 0; a < 3; a++) {
        const uint32_t bits = bits_of(&bounds, a);
        w->widest[a] = bits > w->widest[a] ? bits : w->widest[a];
        w->alone += bits;
    }
    plt_block_tree_frame(t, &frame);
    plt_geometry_open(&g, b, &frame, t->leaf_triangles);
    w->vertices = g.vertices;
    add_vertices(w, &g);
}

/* One frame. */
static void add_frame(widths *of, const plt_block_tree *t) {
    plt_block b;
    for (uint32_t at = 0, i = 0; at < t->used; at += plt_block_bytes(&b), i++) {
        plt_block_open(&b, t->bytes + at, t->lattice.bits);
        if (b.leaves > 0) {
            add_block(&of[i], t, &b);
        }
    }
}

static sums sums_of(const widths *of, const plt_info *info) {
    sums s = {0};
    for (uint32_t i = 0; i < info->treelets; i++) {
        const widths *w = &of[i];
        for (int a = 0; a < 3 && w->vertices > 0; a++) {
            s.widest += (double)w->vertices * w->widest[a];
            s.all += (double)w->vertices * bits_of(&w->all, a);
        }
        s.alone += (double)w->vertices * (double)w->alone / info->frames;
        s.absolute += 3.0 * info->lattice_bits * w->vertices;
    }
    return s;
}

static void print(const sums *s, const plt_info *i, const char *name) {
    const double n = i->triangles, each = 1.0 / (8 * n);
    const double numbers = (double)i->block_vertices * plt_index_bits(i->vertices) / 8 / n;
    printf(
        "    %s: %u triangles, %u frames, %u bits, K = %u; bytes per triangle: nodes %.2f, "
        "geometry %.2f, of that positions %.2f; in the bounds of a frame alone %.2f, of the "
        "widest %.2f, in a box for all %.2f; numbers %.2f, vertices of a frame %.2f, as 16 bits "
        "%.2f; a frame in the image %.2f\n",
        name, i->triangles, i->frames, (unsigned)i->lattice_bits, i->leaf_triangles,
        i->node_bytes / n, i->triangle_bytes / n, s->absolute * each, s->alone * each,
        s->widest * each, s->all * each, numbers, 12.0 * i->vertices / n, 6.0 * i->vertices / n,
        (double)i->frame_bytes / i->frames / n);
}

static void measure(const packed *image, const char *name) {
    const plt_options o = {.packet_side = 2, .movable = 1};
    const plt_source source = rig_source(image);
    const size_t bytes = plt_arena_need(&image->info, 1, &o);
    void *arena = aligned_alloc(PLT_ALIGN, bytes > 0 ? bytes : PLT_ALIGN);
    plt_engine *e = NULL;
    plt_fault fault;
    CHECK(image->info.block_vertices > 0 &&
              plt_open(&e, arena, bytes, &source, &o, &fault) == PLT_OK,
          "%s: no compact blocks that move", name);
    if (e != NULL) {
        widths *of = calloc(image->info.treelets, sizeof *of);
        for (uint32_t i = 0; i < image->info.treelets; i++) {
            memset(of[i].all.lo, 0xFF, sizeof of[i].all.lo);
        }
        for (uint32_t k = 0; k < image->info.frames; k++) {
            CHECK(plt_sequence_show(e, k, &fault) == PLT_OK, "%s: %s", name, fault.message);
            add_frame(of, &e->scene.compact);
        }
        const sums s = sums_of(of, &image->info);
        CHECK(s.alone <= s.widest && s.widest <= s.absolute && s.all <= s.absolute, "%s", name);
        print(&s, &image->info, name);
        free(of);
    }
    free(arena);
}

static packed file_of(const char *path) {
    packed image = {.size = 0};
    FILE *f = fopen(path, "rb");
    fseek(f, 0, SEEK_END);
    image.size = (uint32_t)ftell(f);
    rewind(f);
    image.bytes = heap_get_aligned(image.size);
    CHECK(fread(image.bytes, 1, image.size, f) == image.size, "%s", path);
    fclose(f);
    const plt_source source = rig_source(&image);
    plt_fault fault;
    CHECK(plt_image_info(&source, &image.info, &fault) == PLT_OK, "%s: %s", path, fault.message);
    return image;
}

static packed small_image(void) {
    const sequence_config c = {.scene = rig_config_of(2, 1, PLT_BUILD_HOST, PLT_SPLIT_SAH),
                               .frames = 9,
                               .key_every = 4,
                               .lattice_bits = 16,
                               .is_mapped = 1,
                               .is_compact = 1};
    return sequence_rig_image(&c, rig_triangles(300, 2), 5);
}

int main(int argc, char **argv) {
    test("positions of compact blocks that move, in bytes");
    for (int i = 1; i < argc || i == 1; i++) {
        packed image = i < argc ? file_of(argv[i]) : small_image();
        measure(&image, i < argc ? argv[i] : "soup");
        pack_free(&image);
    }
    return test_done();
}
