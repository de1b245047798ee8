/* test_compact_hits - compact blocks hit what thesis nodes hit, bit for bit
 *
 * Thesis nodes get the mesh with every vertex moved to its lattice point. The scenes contain
 * whatever could make a difference: long and flat triangles, shared edges, ties, triangles
 * without area on the lattice.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "engine/trace/blocks_resident.h"
#include "engine/trace/format_compact.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/block_slots.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/random.h"
#include "tests/reference/rays.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

#if defined(__SANITIZE_ADDRESS__)
enum { RAYS = 64 };
#else
enum { RAYS = 200 };
#endif
enum { SCENES = 9, COMBINATIONS = SCENES * 3 * 5 }; /* of a scene, K and bits */
enum {
    SIDES =
        1 + (PLT_PACKET_SIDE_MAX >= 4) + (PLT_PACKET_SIDE_MAX >= 8) + (PLT_PACKET_SIDE_MAX >= 16)
};
/* What one pass over all combinations compares: nearest and any hit per packet size. */
static const uint64_t HITS = (uint64_t)COMBINATIONS * SIDES * 2 * 4 * RAYS;

typedef struct subject {
    const char *name;
    mesh m;
} subject;

static uint64_t compared, met;

static subject make(int number, uint32_t k) {
    static const char *const name[SCENES] = {"soup",        "small soup", "sheet",
                                             "coincident",  "degenerate", "knot",
                                             "far terrain", "icosphere",  "needles"};
    subject s = {name[number], {0}};
    fail f = {""};
    switch (number) {
    case 0:
        shape_soup(&s.m, compact_triangles(300, k), 0.7f, 1);
        break;
    case 1:
        shape_soup(&s.m, compact_triangles(900, k), 0.02f, 2);
        break;
    case 2:
        shape_sheet(&s.m, rig_is_tiny() ? 7 : 15, (int)k % 3);
        break;
    case 3:
        shape_coincident(&s.m, compact_triangles(40, k) - 2);
        break;
    case 4:
        shape_degenerate(&s.m);
        break;
    case 5:
        scene_knot(&s.m, compact_triangles(900, k), &f);
        break;
    case 6:
        scene_terrain(&s.m, compact_triangles(900, k), &f);
        shape_transform(&s.m, 37.0f, 30.0f, -77.0f, 21.0f);
        break;
    case 7:
        shape_icosphere(&s.m, rig_is_tiny() ? 1 : 2);
        shape_transform(&s.m, 1e-6f, 1e-6f, 0.0f, 1e-7f);
        break;
    default:
        shape_needles(&s.m, 13);
    }
    return s;
}

/* Rays of all kinds at the snapped mesh; `rays` has room for 4 * RAYS. */
static void set_rays(plt_ray *rays, const mesh *m, uint64_t seed) {
    random_state r = {seed};
    rays_mixed(rays, RAYS, m, &r);
    rays_edges(rays + RAYS, RAYS, m, &r);
    rays_camera(rays + 2 * RAYS, RAYS, m, &r);
    rays_axis(rays + 3 * RAYS, RAYS, m, &r);
}

/* ---- the reference: thesis nodes, or no tree where the limits allow none ------ */

static void trace_thesis(const mesh *m, const plt_ray *rays, plt_hit *hits, int any) {
    rig thesis;
    rig_config config = rig_config_of(2, 8, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    int status = rig_open(&thesis, m, &config);
    if (status == PLT_ERR_LIMIT && rig_is_tiny()) {
        rig_close(&thesis);
        config.pack.build = PLT_BUILD_NONE;
        status = rig_open(&thesis, m, &config);
    }
    CHECK(status == PLT_OK, "thesis nodes: %s", thesis.fault.message);
    memset(hits, 0x55, 4 * RAYS * sizeof *hits);
    if (status == PLT_OK) {
        plt_trace(thesis.engine, rays, hits, 4 * RAYS, any);
    }
    rig_close(&thesis);
}

static void compare(const char *name, const compact_config *config, const plt_hit *a,
                    const plt_hit *b) {
    for (uint32_t i = 0; i < 4 * RAYS; i++) {
        compared++;
        met += a[i].triangle != PLT_MISS;
        CHECK(memcmp(&a[i], &b[i], sizeof a[i]) == 0,
              "%s, %s, ray %u: triangle %u t %a u %a v %a, not triangle %u t %a u %a v %a", name,
              compact_name(config), i, b[i].triangle, (double)b[i].t, (double)b[i].u,
              (double)b[i].v, a[i].triangle, (double)a[i].t, (double)a[i].u, (double)a[i].v);
    }
}

/* All packet sizes, nearest and any hit. */
static void trace_compact(const subject *s, compact_config config, const plt_ray *rays,
                          const plt_hit *nearest, const plt_hit *any) {
    static plt_hit hits[4 * RAYS];
    rig compact;
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        config.run.packet_side = side;
        const int status = compact_open(&compact, &s->m, &config);
        CHECK(status == PLT_OK, "%s, %s: %s", s->name, compact_name(&config),
              compact.fault.message);
        if (status == PLT_OK) {
            plt_trace(compact.engine, rays, hits, 4 * RAYS, 0);
            compare(s->name, &config, nearest, hits);
            plt_trace(compact.engine, rays, hits, 4 * RAYS, 1);
            compare(s->name, &config, any, hits);
        }
        rig_close(&compact);
    }
}

/* ---- properties ------------------------------------------------------------------ */

typedef struct expected {
    plt_ray rays[4 * RAYS];
    plt_hit nearest[4 * RAYS], any[4 * RAYS];
} expected;

static void expect(expected *e, const mesh *m, uint64_t seed) {
    set_rays(e->rays, m, seed);
    trace_thesis(m, e->rays, e->nearest, 0);
    trace_thesis(m, e->rays, e->any, 1);
}

static void with_primitive_ids(int number, uint32_t k, uint8_t bits, uint8_t splits) {
    static expected e;
    subject s = make(number, k);
    mesh moved = compact_mesh(&s.m, bits);
    expect(&e, &moved, 7u * (uint64_t)number + k);
    trace_compact(&s, compact_config_of(k, bits, PLT_BUILD_HOST, splits), e.rays, e.nearest, e.any);
    mesh_free(&moved);
    mesh_free(&s.m);
}

/* Float records: the mesh as it is, with its own primitive ids and box. */
static void with_floats(int number, uint32_t k, uint8_t bits, uint8_t splits) {
    static expected e;
    subject s = make(number, k);
    compact_config config = compact_config_of(k, bits, PLT_BUILD_HOST, splits);
    config.pack.floats = 1;
    expect(&e, &s.m, 3u * (uint64_t)number + k);
    trace_compact(&s, config, e.rays, e.nearest, e.any);
    mesh_free(&s.m);
}

/* Host and device alike name triangles by their image index. */
static void by_image_index(int number, uint32_t k, uint8_t bits, uint8_t splits) {
    static expected e;
    subject s = make(number, k);
    compact_config config = compact_config_of(k, bits, PLT_BUILD_HOST, splits);
    rig numbered;
    if (compact_open(&numbered, &s.m, &config) == PLT_OK && numbered.image.info.triangles > 0) {
        mesh moved = compact_mesh(&s.m, bits);
        mesh ordered = compact_mesh_in_order(&numbered.image, &moved);
        expect(&e, &ordered, 5u * (uint64_t)number + k);
        config.pack.numbers = 0;
        trace_compact(&s, config, e.rays, e.nearest, e.any);
        config.pack.build = PLT_BUILD_DEVICE;
        trace_compact(&s, config, e.rays, e.nearest, e.any);
        mesh_free(&moved);
        mesh_free(&ordered);
    }
    CHECK(numbered.engine != NULL, "%s, %s: %s", s.name, compact_name(&config),
          numbered.fault.message);
    rig_close(&numbered);
    mesh_free(&s.m);
}

static uint32_t same; /* pairs of device and host that were compared */

/* Blocks, root and counts of device and host. */
static void same_blocks(int number, uint32_t k, uint8_t bits, uint8_t splits) {
    subject s = make(number, k);
    compact_config host_config = compact_config_of(k, bits, PLT_BUILD_HOST, splits);
    host_config.pack.checks = 0; /* of what is streamed, behind geometry: a device has none */
    const compact_config device_config = compact_config_of(k, bits, PLT_BUILD_DEVICE, splits);
    rig host, device;
    const int a = compact_open(&host, &s.m, &host_config);
    const int b = compact_open(&device, &s.m, &device_config);
    CHECK(a == PLT_OK && b == PLT_OK, "%s: host %d, device %d", s.name, a, b);
    if (a == PLT_OK && b == PLT_OK) {
        const plt_block_tree *h = compact_tree(&host), *d = compact_tree(&device);
        const plt_info *hi = plt_engine_info(host.engine), *di = plt_engine_info(device.engine);
        CHECK(h->used == d->used && h->root == d->root, "%s: %u and %u bytes", s.name, h->used,
              d->used);
        CHECK(h->used == d->used && memcmp(h->bytes, d->bytes, h->used) == 0,
              "%s, %s: blocks differ", s.name, compact_name(&host_config));
        CHECK(hi->nodes == di->nodes && hi->treelets == di->treelets &&
                  hi->leaf_lists == di->leaf_lists &&
                  hi->intermediate_lists == di->intermediate_lists &&
                  hi->node_bytes == di->node_bytes && hi->triangle_bytes == di->triangle_bytes &&
                  hi->depth_stack_entries == di->depth_stack_entries,
              "%s, %s: counts differ", s.name, compact_name(&host_config));
        same++;
    }
    rig_close(&host);
    rig_close(&device);
    mesh_free(&s.m);
}

static void everything(void (*one)(int, uint32_t, uint8_t, uint8_t)) {
    static const uint8_t bits[5] = {12, 14, 16, 17, 21};
    for (int scene = 0; scene < SCENES; scene++) {
        for (uint32_t k = 1; k <= 4; k *= 2) {
            for (int i = 0; i < 5; i++) {
                one(scene, k, bits[i], (uint8_t)((scene + i) & 1));
            }
        }
    }
}

/* Many equal triangles: the lowest primitive id is hit, wherever it lies. */
static void ties(void) {
    enum { COPIES = 37 };
    mesh m = {0};
    const plt_ray ray = {{0, -0.5f, -3}, 0, {0, 0.1f, 1}, 100};
    shape_coincident(&m, COPIES);
    for (uint32_t k = 1; k <= 4; k *= 2) {
        for (uint8_t floats = 0; floats < 2; floats++) {
            compact_config config = compact_config_of(k, 14, PLT_BUILD_HOST, floats);
            plt_hit hit = {0, 0, 0, PLT_MISS};
            rig r;
            config.pack.floats = floats;
            CHECK(compact_open(&r, &m, &config) == PLT_OK, "%s", r.fault.message);
            if (r.engine != NULL) {
                plt_trace(r.engine, &ray, &hit, 1, 0);
            }
            CHECK(hit.triangle == 0, "%s: %u", compact_name(&config), hit.triangle);
            rig_close(&r);
        }
    }
    mesh_free(&m);
}

/* ---- the traversal's arithmetic ---------------------------------------------------- */

static void every_step(void) {
    uint32_t wrong = 0, first = 0;
    for (uint32_t extent = 0; extent < 1u << PLT_LATTICE_BITS_MOST; extent += 4) {
        float e[4], step[4];
        for (uint32_t lane = 0; lane < 4; lane++) {
            e[lane] = (float)(extent + lane);
        }
        f4_store(step, plane_step(f4_load(e)));
        for (uint32_t lane = 0; lane < 4; lane++) {
            const uint32_t due = extent + lane <= 255 ? 1 : (extent + lane + 254) / 255;
            first = wrong == 0 ? extent + lane : first;
            wrong += step[lane] != (float)due;
        }
    }
    CHECK(wrong == 0, "%u wrong, the first of extent %u", wrong, first);
}

/* One node with any bytes: the traversal's boxes are those of plt_block_apply. */
static void any_planes(void) {
    random_state r = {9};
    for (int round = 0; round < 20000; round++) {
        unsigned char bytes[32] = {0};
        plt_block b = {.owners = bytes, .planes = bytes + 1};
        plt_lattice_box box, child[2];
        format_place at;
        memset(&at, 0, sizeof at); /* node 0 */
        float lo[2][4], hi[2][4];
        f4 los[2], his[2];
        for (int i = 0; i < 7; i++) {
            bytes[i] = (unsigned char)random_bits(&r);
        }
        for (int a = 0; a < 3; a++) {
            const uint32_t most = (1u << (1 + random_below(&r, PLT_LATTICE_BITS_MOST))) - 1;
            box.lo[a] = random_below(&r, most + 1);
            box.hi[a] = box.lo[a] + random_below(&r, most + 1 - box.lo[a]);
            at.lo[a] = (float)box.lo[a];
            at.hi[a] = (float)box.hi[a];
        }
        plt_block_apply(&box, b.planes, (uint32_t)(bytes[0] & 31u) << 1 | 1u, child);
        decode_boxes(&b, 0, &at, los, his);
        for (int c = 0; c < 2; c++) {
            f4_store(lo[c], los[c]);
            f4_store(hi[c], his[c]);
            for (int a = 0; a < 3; a++) {
                CHECK(lo[c][a] == (float)(int32_t)child[c].lo[a] &&
                          hi[c][a] == (float)(int32_t)child[c].hi[a],
                      "round %d, child %d, axis %d: %g .. %g", round, c, a, (double)lo[c][a],
                      (double)hi[c][a]);
            }
        }
    }
}

int main(void) {
    test("the traversal's step of a plane is the format's for every possible extent");
    every_step();
    test("the traversal decodes the boxes of any node as the format defines them");
    any_planes();
    test("with primitive ids, hits are those of thesis nodes over the same positions, bit for bit");
    everything(with_primitive_ids);
    CHECK(compared == HITS, "only %llu hits", (unsigned long long)compared);
    test("with float geometry, hits are those of thesis nodes over the same mesh, bit for bit");
    everything(with_floats);
    CHECK(compared == 2 * HITS, "only %llu hits", (unsigned long long)(compared - HITS));
    test("without primitive ids, and built on the device, a hit reports the image index");
    everything(by_image_index);
    CHECK(compared == 4 * HITS, "only %llu hits", (unsigned long long)(compared - 2 * HITS));
    test("a device's blocks are byte for byte the host's");
    everything(same_blocks);
    CHECK(same == COMBINATIONS, "only %u were compared", same);
    test("of coincident triangles the lowest primitive id is hit");
    ties();
    CHECK(met > compared / 10, "hardly any hit");
    printf("    %llu hits compared, %llu of them of triangles\n", (unsigned long long)compared,
           (unsigned long long)met);
    return test_done();
}
