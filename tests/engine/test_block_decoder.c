/* test_block_decoder - a second decoder, from SPEC.md alone, reads what was packed
 *
 * What the decoder reads is compared with the meshes, and with what the engine's own functions
 * read.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/pack/pack.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/block_decoder.h"
#include "tests/reference/block_engine_scan.h"
#include "tests/reference/block_expect.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* Lattice geometry with primitive ids, without, and float records. */
enum variant { PRIMITIVE_IDS, IMAGE_INDICES, FLOATS, VARIANTS };

/* One mesh, packed as one variant, and what the decoder read from it. */
typedef struct subject {
    const mesh *m;
    packed image;
    decoded_image decoded;
    enum variant variant;
    int is_packed;
    char name[80];
} subject;

typedef struct subjects {
    subject *list;
    size_t count;
} subjects;

static const uint32_t all_bits[] = {12, 14, 16, 17, 21};
static const uint32_t all_k[] = {1, 2, 4};
enum { BITS = 5, KS = 3 };

static void pack_subject(subject *s, const mesh *m, uint32_t bits, uint32_t k,
                         enum variant variant) {
    compact_options options = {0};
    options.lattice_bits = (uint8_t)bits;
    options.leaf_triangles = k;
    options.numbers = variant == PRIMITIVE_IDS;
    options.floats = variant == FLOATS;
    lattice_loss loss;
    fail f = {""};
    static const char *const word[VARIANTS] = {"primitive ids", "image indices", "floats"};
    s->m = m;
    s->variant = variant;
    snprintf(s->name, sizeof s->name, "%u bits, K %u, %s", bits, k, word[variant]);
    s->is_packed = pack_compact(&s->image, m, &options, "mesh", &loss, &f) == 0;
    CHECK(s->is_packed, "%s: %s", s->name, f.text);
}

static subjects pack_all(const mesh *m) {
    subjects all = {calloc((size_t)BITS * KS * VARIANTS, sizeof(subject)), 0};
    for (size_t b = 0; b < BITS && all.list != NULL; b++) {
        for (size_t k = 0; k < KS; k++) {
            for (int variant = 0; variant < VARIANTS; variant++) {
                pack_subject(&all.list[all.count], m, all_bits[b], all_k[k], (enum variant)variant);
                all.count += (size_t)all.list[all.count].is_packed;
            }
        }
    }
    return all;
}

static void free_subject(subject *s) {
    block_decode_free(&s->decoded);
    pack_free(&s->image);
}

static void decode_subject(subject *s) {
    const int status = block_decode(&s->decoded, s->image.bytes, s->image.size);
    CHECK(status == 0, "%s: %s", s->name, s->decoded.wrong);
}

static int32_t count_flags(const unsigned char *flag, size_t count) {
    int32_t ones = 0;
    for (size_t i = 0; i < count; i++) {
        ones += flag[i] != 0;
    }
    return ones;
}

/* Each record is a triangle of the mesh bit for bit, and each one is there. */
static void check_records(const subject *s) {
    const decoded_image *d = &s->decoded;
    unsigned char *seen = calloc(s->m->triangles + 1, 1);
    for (uint32_t t = 0; t < d->triangles && seen != NULL; t++) {
        const decoded_triangle *triangle = &d->triangle[t];
        if (triangle->primitive_id >= s->m->triangles) {
            CHECK(0, "%s: record %u: primitive id %u", s->name, t, triangle->primitive_id);
            continue;
        }
        CHECK(!seen[triangle->primitive_id], "%s: primitive id %u twice", s->name,
              triangle->primitive_id);
        seen[triangle->primitive_id] = 1;
        for (unsigned c = 0; c < 3; c++) {
            const float *vertex = shape_corner(s->m, triangle->primitive_id, c);
            const float *point = triangle->point[(triangle->rotation + c) % 3];
            CHECK(memcmp(vertex, point, 3 * sizeof *point) == 0, "%s: record %u", s->name, t);
        }
    }
    const int32_t found = seen == NULL ? -1 : count_flags(seen, s->m->triangles);
    CHECK(found == (int32_t)s->m->triangles, "%s: %d triangles", s->name, (int)found);
    free(seen);
}

/* What the decoder read, in the form of what is expected: by primitive id, or ordered by
 * corners. */
static expected_triangle *found_triangles(const subject *s) {
    const decoded_image *d = &s->decoded;
    expected_triangle *found = calloc((size_t)d->triangles + 1, sizeof *found);
    for (uint32_t t = 0; t < d->triangles && found != NULL; t++) {
        memcpy(found[t].corner, d->triangle[t].corner, sizeof found[t].corner);
        found[t].primitive_id = d->triangle[t].primitive_id;
        found[t].rotation = d->triangle[t].rotation;
        CHECK(s->variant == PRIMITIVE_IDS || (found[t].primitive_id == t && found[t].rotation == 0),
              "%s", s->name);
    }
    return found;
}

static int compare_ids(const void *first, const void *second) {
    const expected_triangle *s = first, *t = second;
    return s->primitive_id < t->primitive_id ? -1 : s->primitive_id > t->primitive_id;
}

static void check_lattice(const subject *s) {
    const decoded_image *d = &s->decoded;
    uint32_t count = 0;
    expected_triangle *expected = expect_triangles(s->m, &d->header, &count);
    expected_triangle *found = found_triangles(s);
    CHECK(count == d->triangles, "%s: %u, not %u", s->name, d->triangles, count);
    CHECK(d->header.source_triangles == s->m->triangles, "%s: source triangles", s->name);
    if (s->variant == PRIMITIVE_IDS) {
        qsort(found, d->triangles, sizeof *found, compare_ids);
    } else {
        expect_sort(found, d->triangles);
        expect_sort(expected, count);
    }
    for (uint32_t t = 0; t < count && t < d->triangles; t++) {
        const int same = memcmp(found[t].corner, expected[t].corner, sizeof found[t].corner) == 0;
        const int same_id = found[t].primitive_id == expected[t].primitive_id &&
                            found[t].rotation == expected[t].rotation;
        CHECK(same, "%s: triangle %u of %u", s->name, t, expected[t].primitive_id);
        CHECK(s->variant == IMAGE_INDICES || same_id, "%s: %u rotation %u, not %u rotation %u",
              s->name, found[t].primitive_id, found[t].rotation, expected[t].primitive_id,
              expected[t].rotation);
    }
    free(expected);
    free(found);
}

static void check_triangles(const subject *s) {
    s->variant == FLOATS ? check_records(s) : check_lattice(s);
}

/* The tightest lattice box around the floats; with lattice geometry it has exactly the corners'
 * coordinates. */
static int is_exact(const decoded_header *h, const decoded_box *bounds, const decoded_box *exact) {
    for (int a = 0; a < 3; a++) {
        const float up = block_decode_float(h, a, bounds->lo[a] + 1);
        const float down = block_decode_float(h, a, bounds->hi[a] - 1);
        const int numbers = h->geometry_format == 0 ||
                            (bounds->lo[a] == exact->lo[a] && bounds->hi[a] == exact->hi[a]);
        if (!numbers || bounds->float_lo[a] > exact->float_lo[a] || exact->float_lo[a] >= up ||
            bounds->float_hi[a] < exact->float_hi[a] || exact->float_hi[a] <= down) {
            return 0;
        }
    }
    return 1;
}

/* With float records the exact box has no lattice coordinates: uses the outer box's. */
static int holds(const subject *s, const decoded_box *outer, decoded_box exact) {
    if (s->variant == FLOATS) {
        memcpy(exact.lo, outer->lo, sizeof exact.lo);
        memcpy(exact.hi, outer->hi, sizeof exact.hi);
    }
    return expect_holds(outer, &exact);
}

static void check_boxes(const subject *s) {
    const decoded_image *d = &s->decoded;
    expected_boxes exact = expect_boxes(d);
    for (uint32_t b = 0; b < d->blocks; b++) {
        const decoded_block *block = &d->block[b];
        CHECK(is_exact(&d->header, &block->bounds, &exact.node[block->first_node]),
              "%s: block %u: bounds", s->name, block->address);
    }
    for (uint32_t i = 0; i < d->nodes; i++) {
        const decoded_node *node = &d->node[i];
        CHECK(holds(s, &node->box, exact.node[i]), "%s: node %u", s->name, i);
        for (int c = 0; c < 2; c++) {
            const decoded_child *child = &node->child[c];
            const decoded_box *below = &exact.leaf[child->kind >= DECODED_LEAF ? child->which : 0];
            if (child->kind == DECODED_INNER) {
                below = &exact.node[child->which];
            } else if (child->kind == DECODED_EDGE) {
                below = &exact.node[d->block[child->which].first_node];
            }
            CHECK(holds(s, &child->box, *below), "%s: child %d of %u", s->name, c, i);
            CHECK(expect_holds(&node->box, &child->box), "%s: child %d of %u", s->name, c, i);
        }
    }
    for (int a = 0; a < 3 && d->blocks > 0; a++) {
        CHECK(d->block[0].bounds.lo[a] == (int32_t)d->header.lattice_lo[a] &&
                  d->block[0].bounds.hi[a] == (int32_t)d->header.lattice_hi[a],
              "%s: the first bounds are not the scene's box", s->name);
    }
    expect_boxes_free(&exact);
}

/* ---- the engine's own decoding --------------------------------------------- */

static int same_boxes(const decoded_box *box, const plt_lattice_box *lattice) {
    return memcmp(box->lo, lattice->lo, sizeof box->lo) == 0 &&
           memcmp(box->hi, lattice->hi, sizeof box->hi) == 0;
}

static void check_engine_child(const subject *s, uint32_t slot, const engine_child *theirs) {
    const decoded_image *d = &s->decoded;
    const decoded_node *node = &d->node[slot / 2];
    const decoded_child *ours = &node->child[slot % 2];
    const decoded_block *block = &d->block[node->block];
    CHECK(same_boxes(&ours->box, &theirs->box), "%s: slot %u: box", s->name, slot);
    CHECK(memcmp(ours->box.float_lo, theirs->floats.lo, sizeof ours->box.float_lo) == 0 &&
              memcmp(ours->box.float_hi, theirs->floats.hi, sizeof ours->box.float_hi) == 0,
          "%s: slot %u: floats", s->name, slot);
    if (ours->kind == DECODED_INNER) {
        CHECK(theirs->kind == PLT_SLOT_INNER, "%s: slot %u", s->name, slot);
        CHECK(ours->which == block->first_node + 1 + theirs->rank, "%s: slot %u", s->name, slot);
    } else if (ours->kind == DECODED_EDGE) {
        const decoded_block *below = &d->block[ours->which];
        CHECK(theirs->kind == PLT_SLOT_EDGE, "%s: slot %u", s->name, slot);
        CHECK(below->address == plt_block_address(theirs->link), "%s: slot %u", s->name, slot);
        CHECK(below->nodes_bytes == plt_block_node_bytes(theirs->link), "%s: %u", s->name, slot);
    } else {
        const decoded_leaf *leaf = &d->leaf[ours->which];
        CHECK(theirs->kind == PLT_SLOT_LEAF, "%s: slot %u", s->name, slot);
        CHECK(ours->which == block->first_leaf + theirs->rank, "%s: slot %u", s->name, slot);
        CHECK(leaf->first == theirs->first, "%s: slot %u: first", s->name, slot);
        CHECK(leaf->triangles == theirs->count, "%s: slot %u: count", s->name, slot);
    }
}

static void check_engine_block(const subject *s, uint32_t b, const engine_block *theirs) {
    const decoded_block *ours = &s->decoded.block[b];
    CHECK(ours->address == theirs->address, "%s: block %u: address", s->name, b);
    CHECK(ours->nodes_bytes == theirs->node_bytes, "%s: block %u: nodes part", s->name, b);
    CHECK(ours->geometry_bytes == theirs->geometry_bytes, "%s: block %u: geometry", s->name, b);
    CHECK(ours->nodes == theirs->nodes && ours->edges == theirs->edges, "%s: %u", s->name, b);
    CHECK(ours->leaves == theirs->leaves, "%s: block %u: leaves", s->name, b);
    CHECK(same_boxes(&ours->bounds, &theirs->bounds), "%s: block %u: bounds", s->name, b);
    CHECK(ours->triangles == theirs->triangles, "%s: block %u: triangles", s->name, b);
    CHECK(ours->leaves == 0 || ours->first_triangle == theirs->first_triangle, "%s: %u", s->name,
          b);
    CHECK(s->variant == FLOATS || ours->vertices == theirs->vertices, "%s: %u", s->name, b);
    CHECK(ours->mesh == theirs->mesh, "%s: block %u: mesh", s->name, b);
}

static void check_engine(const subject *s) {
    const decoded_image *d = &s->decoded;
    engine_scan scan;
    engine_scan_make(&scan, s->image.bytes, &d->header);
    CHECK(scan.blocks == d->blocks && scan.children == 2 * d->nodes, "%s: nodes", s->name);
    CHECK(scan.triangles == d->triangles, "%s: %u triangles", s->name, scan.triangles);
    for (uint32_t b = 0; b < d->blocks && b < scan.blocks; b++) {
        check_engine_block(s, b, &scan.block[b]);
    }
    for (uint32_t slot = 0; slot < 2 * d->nodes && slot < scan.children; slot++) {
        check_engine_child(s, slot, &scan.child[slot]);
    }
    for (uint32_t t = 0; t < d->triangles && t < scan.triangles; t++) {
        const decoded_triangle *ours = &d->triangle[t];
        const engine_triangle *theirs = &scan.triangle[t];
        CHECK(memcmp(ours->corner, theirs->corner, sizeof ours->corner) == 0 &&
                  memcmp(ours->point, theirs->point, sizeof ours->point) == 0,
              "%s: triangle %u: corners", s->name, t);
        CHECK(ours->primitive_id == theirs->primitive_id && ours->rotation == theirs->rotation,
              "%s: triangle %u: primitive id", s->name, t);
    }
    engine_scan_free(&scan);
}

static void check_subjects(const char *scene, const char *property, const subjects *all,
                           void (*check)(const subject *s)) {
    char sentence[200];
    snprintf(sentence, sizeof sentence, "%s: %s", scene, property);
    test(sentence);
    size_t checked = 0;
    for (size_t i = 0; i < all->count; i++) {
        if (all->list[i].decoded.wrong[0] == '\0') {
            check(&all->list[i]);
            checked++;
        }
    }
    CHECK(checked == (size_t)BITS * KS * VARIANTS, "only %zu images were looked at", checked);
}

static void check_scene(const char *scene, const mesh *m) {
    char sentence[200];
    snprintf(sentence, sizeof sentence, "%s: every image decodes, its counts as the header says",
             scene);
    test(sentence);
    subjects all = pack_all(m);
    for (size_t i = 0; i < all.count; i++) {
        decode_subject(&all.list[i]);
    }
    check_subjects(scene, "each triangle is there once, snapped, with its winding and primitive id",
                   &all, check_triangles);
    check_subjects(scene, "bounds are exact, every box contains what is below it", &all,
                   check_boxes);
    check_subjects(scene, "the engine reads the same, bit for bit", &all, check_engine);
    for (size_t i = 0; i < all.count; i++) {
        free_subject(&all.list[i]);
    }
    free(all.list);
}

static void check_scenes(void) {
    static const char *const name[] = {"knot", "terrain", "marbles", "ground"};
    for (int scene = 0; scene < 4; scene++) {
        if (scene == 2 && rig_is_tiny()) {
            continue; /* the marbles' tree is deeper than tiny limits allow */
        }
        mesh m = {0};
        fail f = {""};
        const uint32_t triangles = rig_triangles(2000, 2);
        int status = 0;
        switch (scene) {
        case 0:
            status = scene_knot(&m, triangles < 24 ? 24 : triangles, &f);
            break;
        case 1:
            status = scene_terrain(&m, triangles, &f);
            break;
        case 2:
            status = scene_marbles(&m, SCENE_MARBLES_MOST, 0, &f);
            break;
        default:
            status = scene_ground(&m, &f);
        }
        test("a scene can be made");
        CHECK(status == 0, "%s: %s", name[scene], f.text);
        check_scene(name[scene], &m);
        mesh_free(&m);
    }
}

/* ---- odd and small meshes ------------------------------------------------ */

static void check_one_size(size_t triangles, uint32_t k, enum variant variant) {
    mesh m = {0};
    subject s = {0};
    shape_soup(&m, (uint32_t)triangles, 0.5f, 7);
    pack_subject(&s, &m, 16, k, variant);
    if (s.is_packed) {
        decode_subject(&s);
        const decoded_image *d = &s.decoded;
        const uint32_t wanted = triangles == 1 ? 2 : (uint32_t)triangles;
        CHECK(d->triangles == wanted, "%s: %u of %u", s.name, d->triangles, wanted);
        CHECK(d->header.source_triangles == triangles, "%s: source triangles", s.name);
        CHECK(triangles > 0 || d->blocks == 0, "%s: blocks", s.name);
        CHECK(triangles == 0 || triangles > 2 * k || (d->nodes == 1 && d->leaves == 2),
              "%s, %u triangles: %u nodes", s.name, wanted, d->nodes);
        if (triangles > 1) {
            check_triangles(&s);
        }
        check_boxes(&s);
        free_subject(&s);
    }
    mesh_free(&m);
}

static void check_sizes(void) {
    test("up to 2K triangles are one node of two leaves, one triangle is there twice");
    for (size_t triangles = 0; triangles <= 10; triangles++) {
        for (size_t k = 0; k < KS; k++) {
            for (int variant = 0; variant < VARIANTS; variant++) {
                check_one_size(triangles, all_k[k], (enum variant)variant);
            }
        }
    }
}

static void check_shapes(void) {
    mesh flat = {0}, soup = {0}, twins = {0};
    shape_degenerate(&flat);
    check_scene("degenerate", &flat);
    shape_soup(&soup, rig_triangles(1500, 2), 0.01f, 3);
    check_scene("soup", &soup);
    shape_coincident(&twins, 9);
    check_scene("coincident", &twins);
    mesh_free(&flat);
    mesh_free(&soup);
    mesh_free(&twins);
}

static void check_mesh_numbers(void) {
    test("a block that names a mesh holds triangles of that mesh alone");
    mesh m = {0};
    shape_icosphere(&m, 2);
    shape_transform(&m, 1.0f, 4.0f, 0.0f, 0.0f);
    const size_t first = m.triangles;
    shape_sheet(&m, 12, 1);
    const size_t mesh_end[] = {first, m.triangles};
    const compact_options options = {
        .lattice_bits = 16, .numbers = 1, .leaf_triangles = 2, .mesh_end = mesh_end, .meshes = 2};
    lattice_loss loss;
    fail f = {""};
    subject s = {0};
    s.is_packed = pack_compact(&s.image, &m, &options, "two", &loss, &f) == 0;
    CHECK(s.is_packed, "%s", f.text);
    if (s.is_packed) {
        decode_subject(&s);
        uint32_t named = 0;
        for (uint32_t b = 0; b < s.decoded.blocks; b++) {
            const decoded_block *block = &s.decoded.block[b];
            named += block->mesh != 0;
            CHECK(block->mesh <= 2, "block %u: mesh %u", block->address, block->mesh);
            for (uint32_t t = 0; t < block->triangles && block->mesh != 0; t++) {
                const uint32_t number = s.decoded.triangle[block->first_triangle + t].primitive_id;
                CHECK((number >= first) == (block->mesh == 2), "block %u", block->address);
            }
        }
        CHECK(named > 0, "no block names a mesh");
        free_subject(&s);
    }
    mesh_free(&m);
}

int main(void) {
    check_sizes();
    check_mesh_numbers();
    check_scenes();
    check_shapes();
    return test_done();
}
