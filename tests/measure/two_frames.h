/* two_frames - an image with a sequence: a mesh, and the mesh half as large again
 *
 * SPDX-License-Identifier: MIT */
#ifndef MEASURE_TWO_FRAMES_H
#define MEASURE_TWO_FRAMES_H

#include <stdlib.h>

#include "host_tools/pack/lattice.h"
#include "host_tools/pack/sequence.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

static inline int pack_first(packed *image, const mesh *m, uint32_t k, sequence *s, int is_compact,
                             fail *f) {
    rig_config c = rig_config_of(k, rig_is_tiny() ? 1 : 64, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    const compact_options blocks = {.build = PLT_BUILD_HOST,
                                    .lattice_bits = 16,
                                    .numbers = 1,
                                    .leaf_triangles = k,
                                    .moving = &s->moving};
    lattice_loss loss;
    c.pack.checks = 0; /* what moves is not streamed */
    return is_compact ? pack_compact(image, m, &blocks, "test", &loss, f)
                      : pack_mesh(image, m, &c.pack, "test", f);
}

/* `bits`: of the lattice; 0: floats, of thesis nodes alone. */
static inline void pack_frames(packed *image, const mesh *m, uint32_t k, uint32_t bits,
                               int is_compact) {
    sequence_options o = {2, 25, 2, {{0}, 0, 0}, 0};
    mesh frame = *m;
    sequence s;
    fail f = {""};
    lattice_ground ground = {plt_box_empty(), LATTICE_NO_GRAIN};
    shape_box(m, ground.box.lo, ground.box.hi);
    for (int a = 0; a < 3; a++) {
        ground.box.lo[a] *= ground.box.lo[a] < 0 ? 1.5f : 1.0f;
        ground.box.hi[a] *= ground.box.hi[a] > 0 ? 1.5f : 1.0f;
    }
    const lattice_wish wish = {.bits = bits, .power = 1};
    CHECK(bits == 0 || lattice_over(&o.lattice, &ground, &wish, "test", &f) == 0, "%s", f.text);
    mesh first = *m;
    first.vertex = malloc(3 * m->vertices * sizeof(float));
    frame.vertex = malloc(3 * m->vertices * sizeof(float));
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        first.vertex[i] = m->vertex[i];
        frame.vertex[i] = 1.5f * m->vertex[i];
    }
    if (bits > 0) {
        sequence_snap(&first, &o.lattice);
    }
    CHECK(sequence_begin(&s, &first, &o, "test", &f) == 0 &&
              pack_first(image, &first, k, &s, is_compact, &f) == 0 &&
              sequence_add(&s, &first, "test", &f) == 0,
          "%s", f.text);
    CHECK(sequence_add(&s, &frame, "test", &f) == 0 &&
              sequence_finish(&s, image, &first, "test", &f) == 0,
          "%s", f.text);
    free(first.vertex);
    free(frame.vertex);
    sequence_free(&s);
}

#endif
