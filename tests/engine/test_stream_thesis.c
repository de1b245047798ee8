/* test_stream_thesis - thesis nodes that stay in a source that is small, cut or hostile
 *
 * As test_stream.c of compact blocks: hits and frames are those of the same image, resident.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/base/rules.h"
#include "tests/hostile/images.h"
#include "tests/reference/rig.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/reference/stream_rig.h"

/* Without checks: as images were before there were any. */
static int is_unchecked;
/* Of the treelets of images that follow. */
static uint8_t its_fill, its_slots;

/* Resident scenes are refused where the two-stage order, which they could be traced in, would need
 * too large a stack; with treelets of one node it does not. */
static packed image_of(const mesh *m, uint32_t k, uint32_t n) {
    const pack_options o = {.splits = PLT_SPLIT_SAH,
                            .build = PLT_BUILD_HOST,
                            .leaf_triangles = k,
                            .treelet_nodes = rig_is_tiny() ? 1 : n,
                            .checks = !is_unchecked,
                            .fill = its_fill,
                            .slots = its_slots};
    packed image = {0};
    fail f = {""};
    CHECK(pack_mesh(&image, m, &o, "test", &f) == 0, "%s", f.text);
    return image;
}

static void fill_subject(subject *s, uint32_t triangles, uint32_t k, uint32_t n) {
    mesh m = {0};
    random_state r = {triangles + k};
    shape_soup(&m, rig_triangles(triangles, k), 0.1f, 3 + k);
    rays_mixed(s->rays, RAYS, &m, &r);
    s->image = image_of(&m, k, n);
    mesh_free(&m);
    set_due(s);
}

/* ---- the same from every store --------------------------------------------- */

static void same_statistics(const subject *s, const run *x, uint32_t store) {
    plt_stats q;
    plt_stats_get(x->engine, &q);
    CHECK(q.bytes_fetched + PLT_HEADER_BYTES == x->link.bytes_moved, "bytes are not those moved");
    CHECK(q.fetch_retries == 0 && q.bytes_touched_once <= q.bytes_fetched, "statistics");
    CHECK(q.bytes_touched_once > s->image.size / 4, "little was touched: the test is weak");
    if (store >= 2 * s->image.size) {
        CHECK(q.bytes_fetched == q.bytes_touched_once && q.store_evictions == 0, "fetched twice");
    } else if (s->image.size > 3 * (uint64_t)(store > 0 ? store : PLT_STORE_LEAST)) {
        CHECK(q.store_evictions > 100, "%u evictions", (unsigned)q.store_evictions);
    }
}

static void same(const subject *s, uint8_t side, uint32_t store) {
    run x = {0};
    uint8_t frame[3 * WIDTH * HEIGHT];
    plt_hit hits[RAYS];
    const uint32_t n = s->image.info.treelet_nodes;
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, side, store);
    const int status = open_run(&x, &s->image, &o);
    CHECK(status == PLT_OK, "%s", x.fault.message);
    CHECK(x.link.bytes_moved == PLT_HEADER_BYTES, "opening moves more than the header");
    for (int any = 0; any < 2 && status == PLT_OK; any++) {
        CHECK(plt_trace(x.engine, s->rays, hits, RAYS, any) == PLT_OK, "any %d", any);
        CHECK(memcmp(hits, s->due[any], sizeof hits) == 0, "N %u, side %u, any %d: hits", n, side,
              any);
    }
    CHECK(render(x.engine, frame) == PLT_OK, "the frame");
    CHECK(memcmp(frame, s->frame, sizeof frame) == 0, "N %u, side %u, store %u: frame", n, side,
          store);
    same_statistics(s, &x, store);
    close_run(&x);
}

static void all_stores(uint32_t triangles, uint32_t k, uint32_t n) {
    static subject s;
    fill_subject(&s, triangles, k, n);
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        same(&s, side, 0);
        same(&s, side, 40000);
        same(&s, side, 4u << 20);
    }
    pack_free(&s.image);
}

static void all_treelets(void) {
    for (its_fill = 0; its_fill < TREELET_FILLS; its_fill++) {
        for (its_slots = TREELET_SLOTS_THESIS; its_slots <= TREELET_SLOTS_NONE; its_slots++) {
            all_stores(3000, 2, 16);
            all_stores(3000, 1, 64);
        }
    }
    its_fill = its_slots = 0;
}

static void few_triangles(uint32_t few, uint32_t k) {
    static subject s;
    mesh m = {0};
    random_state r = {few};
    shape_soup(&m, few > 0 ? few : 1, 0.5f, 1 + few);
    rays_mixed(s.rays, RAYS, &m, &r);
    m.triangles = few;
    s.image = image_of(&m, k, 4);
    m.triangles = few > 0 ? few : 1;
    mesh_free(&m);
    set_due(&s);
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        run x = {0};
        plt_hit hits[RAYS];
        const plt_options o = options_of(PLT_RESIDENCY_STREAMED, side, 0);
        CHECK(open_run(&x, &s.image, &o) == PLT_OK, "%u: %s", few, x.fault.message);
        CHECK(trace_all(&x, &s, hits) == PLT_OK, "%u triangles", few);
        CHECK(memcmp(hits, s.due[0], sizeof hits) == 0, "%u triangles, side %u: hits", few, side);
        close_run(&x);
    }
    pack_free(&s.image);
}

/* Clusters at ever smaller distances: treelets as deep as they can be. */
static void deep_treelets(uint8_t side) {
    static subject s;
    mesh m = {0};
    fail f = {""};
    random_state r = {side};
    float at = 1.0f;
    for (uint32_t i = 0; i < 60; i++, at *= i % 3 == 0 ? 0.5f : 1.0f) {
        const float x = at * random_float(&r, 0.9f, 1.0f), y = at * random_float(&r, 0, 1);
        const float z = at * random_float(&r, 0, 1), e = at * 0.05f;
        mesh_add_vertex(&m, x, y, z, &f);
        mesh_add_vertex(&m, x + e, y, z, &f);
        mesh_add_vertex(&m, x, y + e, z + e, &f);
        CHECK(mesh_add_triangle(&m, 3 * i, 3 * i + 1, 3 * i + 2, &f) == 0, "%s", f.text);
    }
    rays_mixed(s.rays, RAYS, &m, &r);
    s.image = image_of(&m, 1, side == 2 ? 64 : 8);
    mesh_free(&m);
    set_due(&s);
    run x = {0};
    plt_hit hits[RAYS];
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, side, 0);
    CHECK(open_run(&x, &s.image, &o) == PLT_OK, "%s", x.fault.message);
    CHECK(trace_all(&x, &s, hits) == PLT_OK, "side %u", side);
    CHECK(memcmp(hits, s.due[0], sizeof hits) == 0, "side %u: hits", side);
    close_run(&x);
    pack_free(&s.image);
}

/* ---- images that lie --------------------------------------------------------- */

static unsigned char *node_at(packed *image, uint32_t slot) {
    return image->bytes + PLT_HEADER_BYTES + (size_t)slot * PLT_NODE_BYTES;
}

static void set_link(packed *image, uint32_t slot, int child, uint32_t link) {
    unsigned char *at = node_at(image, slot) + 24 + 4 * child;
    plt_put_u32(at, (link & ~PLT_LINK_OWNERS) | (plt_get_u32(at) & PLT_LINK_OWNERS));
}

/* A link that may be one, to any node or record. */
static uint32_t any_link(const plt_info *info, random_state *r) {
    const uint32_t kind = random_below(r, 4);
    uint32_t index =
        random_below(r, (kind & PLT_LINK_LEAF) != 0 ? info->triangles + 1 : info->node_slots + 1);
    if (kind == PLT_LINK_OUT && random_below(r, 2)) {
        index -= index % info->treelet_nodes;
    }
    return plt_link_make(index, kind);
}

static void forge(packed *image, random_state *r) {
    const plt_info *info = &image->info;
    unsigned char *section = image->bytes + PLT_HEADER_BYTES;
    const uint32_t bytes = image->size - PLT_HEADER_BYTES;
    for (uint32_t times = 1 + random_below(r, 3); times > 0; times--) {
        const uint32_t at = random_below(r, bytes);
        switch (random_below(r, 5)) {
        case 0:
            section[at] ^= (unsigned char)(1u << random_below(r, 8));
            break;
        case 1:
            section[at] = (unsigned char)random_bits(r);
            break;
        case 2: /* a word from elsewhere */
            memcpy(section + (at & ~3u), section + (random_below(r, bytes) & ~3u), 4);
            break;
        default:
            set_link(image, random_below(r, info->node_slots), (int)random_below(r, 2),
                     any_link(info, r));
        }
    }
}

/* What a packet may visit at most: treelets that fill their blocks once, and from each of their
 * edges a treelet that has none. */
static uint64_t nodes_most(const plt_info *info) {
    return (uint64_t)info->node_slots * (info->treelet_nodes + 2ull);
}

/* A forged image, streamed: PLT_OK or a refusal with its place, and hits within their ranges. */
static const char *try_forged(const packed *image, uint8_t side, int *status) {
    run x = {0};
    plt_ray rays[HOSTILE_RAYS];
    plt_hit hits[HOSTILE_RAYS];
    plt_stats q;
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, side, 0);
    const char *wrong = NULL;
    *status = open_run(&x, image, &o);
    if (*status == PLT_OK) {
        hostile_rays(rays, plt_engine_info(x.engine));
        *status = plt_trace(x.engine, rays, hits, HOSTILE_RAYS, 0);
        plt_stats_get(x.engine, &q);
        plt_fault_get(x.engine, &x.fault);
        for (uint32_t i = 0; i < HOSTILE_RAYS && *status == PLT_OK; i++) {
            if (hits[i].triangle != PLT_MISS && hits[i].triangle >= image->info.triangles) {
                wrong = "a hit is out of range";
            }
        }
        if (q.node_visits > visits_most(&q, nodes_most(&image->info))) {
            wrong = "treelets were visited again and again";
        }
        if (*status != PLT_OK &&
            (*status != PLT_ERR_IMAGE || x.fault.kind != 'I' || x.fault.offset >= image->size)) {
            wrong = "refused without its place";
        }
    }
    close_run(&x);
    return wrong;
}

static void forged_images(uint32_t seeds) {
    static const uint32_t n[] = {1, 2, 5, 16, 64};
    static subject s;
    uint32_t refused = 0, tried = 0;
    for (uint32_t scene = 0; scene < 5; scene++) {
        fill_subject(&s, 700, 1 + scene % 2, n[scene]);
        unsigned char *whole = room_get(s.image.size);
        memcpy(whole, s.image.bytes, s.image.size);
        for (uint32_t seed = 0; seed < seeds; seed++, tried++) {
            random_state r = {seed * 8 + scene};
            int status = PLT_OK;
            forge(&s.image, &r);
            if (seed % 8 != 0) {
                hostile_seal(s.image.bytes, s.image.size);
            }
            const char *wrong = try_forged(&s.image, seed % 2 ? 2 : PLT_PACKET_SIDE_MAX, &status);
            CHECK(wrong == NULL, "N %u, seed %u: %s", n[scene], seed, wrong);
            refused += status != PLT_OK;
            memcpy(s.image.bytes, whole, s.image.size);
        }
        free(whole);
        pack_free(&s.image);
    }
    CHECK(refused > tried / 8 && refused < tried * 9 / 10, "%u of %u refused", refused, tried);
}

/* Every node's links lead to the two behind it, as many ways as Fibonacci numbers to the last: it
 * would be a year until a packet were through. Planes are such that every ray goes everywhere. */
static void ways_without_number(uint32_t n, uint32_t apart) {
    static subject s;
    fill_subject(&s, 700, 1, n);
    const uint32_t slots = s.image.info.node_slots;
    n = s.image.info.treelet_nodes;
    for (uint32_t slot = 0; slot < slots; slot++) {
        for (uint32_t child = 0; child < 2; child++) {
            const uint32_t to = slot + 1 + apart * child;
            const uint32_t kind = slot / n == to / n ? 0 : PLT_LINK_OUT;
            unsigned char *node = node_at(&s.image, slot);
            memset(node, 0, 24);
            memcpy(node + 12 * child, s.image.bytes + 72 + 12 * child, 12); /* the scene's box */
            plt_put_u32(node + 24 + 4 * child, to < slots ? plt_link_make(to, kind) : 1);
        }
    }
    hostile_seal(s.image.bytes, s.image.size);
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        int status = PLT_OK;
        const char *wrong = try_forged(&s.image, side, &status);
        CHECK(wrong == NULL, "N %u: %s", n, wrong);
        CHECK(status == PLT_ERR_IMAGE, "N %u, %u apart: status %d", n, apart, status);
    }
    pack_free(&s.image);
}

/* Words of the root, which no treelet says, and of lists. */
static void refuses_word(const packed *image, uint32_t at, uint32_t word, uint8_t rule) {
    run x = {0};
    plt_ray rays[HOSTILE_RAYS];
    plt_hit hits[HOSTILE_RAYS];
    unsigned char *to = image->bytes + at;
    const uint32_t was = plt_get_u32(to);
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, 0);
    plt_put_u32(to, word);
    hostile_seal(image->bytes, image->size);
    int status = open_run(&x, image, &o);
    if (status == PLT_OK) {
        hostile_rays(rays, plt_engine_info(x.engine));
        status = plt_trace(x.engine, rays, hits, HOSTILE_RAYS, 0);
        plt_fault_get(x.engine, &x.fault);
    }
    CHECK(status == PLT_ERR_IMAGE && x.fault.rule == rule, "byte %u: status %d, rule %u, not %u",
          at, status, x.fault.rule, rule);
    close_run(&x);
    plt_put_u32(to, was);
}

static void one_word_wrong(void) {
    static subject s;
    fill_subject(&s, 300, 2, 16);
    const plt_info *i = &s.image.info;
    const uint32_t records = PLT_HEADER_BYTES + i->node_slots * PLT_NODE_BYTES;
    refuses_word(&s.image, 68, PLT_LINK_NONE, PLT_I4_LIST_ORDER);
    refuses_word(&s.image, 68, plt_link_make(1, PLT_LINK_LEAF), PLT_I4_LIST_ORDER);
    refuses_word(&s.image, 68, plt_link_make(1, 0), PLT_I1_LINKS);
    refuses_word(&s.image, PLT_HEADER_BYTES, 0x7FC00000u, PLT_I6_PLANES);
    refuses_word(&s.image, PLT_HEADER_BYTES + 24, plt_link_make(0, 0), PLT_I1_LINKS);
    refuses_word(&s.image, PLT_HEADER_BYTES + 24, plt_link_make(i->node_slots, PLT_LINK_OUT),
                 PLT_I1_LINKS);
    refuses_word(&s.image, PLT_HEADER_BYTES + 24, plt_link_make(i->triangles, PLT_LINK_LEAF),
                 PLT_I3_LIST_ENDS);
    refuses_word(&s.image, PLT_HEADER_BYTES + 28, plt_link_make(1, 0), PLT_I1_LINKS);
    refuses_word(&s.image, 52, 1, PLT_I8_COUNTS); /* K */
    for (uint32_t r = 0; r < i->triangles; r++) {
        plt_put_u32(s.image.bytes + records + 40 * r + 8, 0x7FC00000u);
    }
    refuses_word(&s.image, records, 0x7FC00000u, PLT_I5_CORNERS);
    pack_free(&s.image);
}

/* The last list of all has no end. */
static void list_without_end(void) {
    static subject s;
    fill_subject(&s, 300, 2, 16);
    const plt_info *i = &s.image.info;
    unsigned char *records = s.image.bytes + PLT_HEADER_BYTES + i->node_slots * PLT_NODE_BYTES;
    for (uint32_t r = 0; r < i->triangles; r++) {
        unsigned char *word = records + 40 * r + 36;
        plt_put_u32(word, plt_get_u32(word) & ~PLT_RECORD_LAST);
    }
    refuses_word(&s.image, 52, 2, PLT_I8_COUNTS);
    refuses_word(&s.image, 52, i->triangles + 1, PLT_I3_LIST_ENDS);
    pack_free(&s.image);
}

/* ---- a source that changes --------------------------------------------------- */

/* Every part comes from one of several versions. */
static void changes(const subject *s, uint8_t side, uint32_t seed, uint32_t *ended) {
    changing c = {.random = {seed}};
    for (unsigned i = 0; i < VERSIONS; i++) {
        packed copy = s->image;
        copy.bytes = c.version[i] = room_get(s->image.size);
        memcpy(copy.bytes, s->image.bytes, s->image.size);
        for (unsigned times = 0; i > 0 && times < 3; times++) {
            forge(&copy, &c.random);
        }
        hostile_seal(copy.bytes, copy.size);
    }
    trace_changing(&c, s, side, ended);
}

static void changing_sources(uint32_t seeds) {
    static subject s;
    uint32_t ended = 0;
    for (uint32_t n = 2; n <= 32; n *= 4) {
        fill_subject(&s, 2500, 2, n);
        for (uint32_t seed = 0; seed < seeds; seed++) {
            for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
                changes(&s, side, seed, &ended);
            }
        }
        pack_free(&s.image);
    }
    /* In transfers of 64 bytes nodes and their checks are seldom of one version. */
    CHECK(ended > 0 || rig_is_tiny(), "no packet came through");
}

/* ---- what the header claims ---------------------------------------------------- */

static void claim(subject *s, uint32_t depth, uint32_t claimed, uint8_t side) {
    run x = {0};
    plt_hit hits[RAYS];
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, side, 0);
    plt_put_u32(s->image.bytes + 64, claimed);
    hostile_seal(s->image.bytes, s->image.size);
    s->image.info.depth_stack_entries = claimed;
    CHECK(open_run(&x, &s->image, &o) == PLT_OK, "%s", x.fault.message);
    const int status = trace_all(&x, s, hits);
    plt_fault_get(x.engine, &x.fault);
    CHECK(status == PLT_OK ? memcmp(hits, s->due[0], sizeof hits) == 0
                           : status == PLT_ERR_IMAGE && x.fault.rule == PLT_I8_COUNTS,
          "claim %u of %u: status %d", claimed, depth, status);
    CHECK(claimed < depth || status == PLT_OK, "the depth itself is refused");
    /* The stack has room for more than a scene of this depth; as if it had less. */
    x.engine->scene.info.depth_stack_entries = claimed - PLT_STACK_SLACK;
    const int less = trace_all(&x, s, hits);
    plt_fault_get(x.engine, &x.fault);
    CHECK(less == PLT_OK ? memcmp(hits, s->due[0], sizeof hits) == 0
                         : less == PLT_ERR_IMAGE && x.fault.rule == PLT_I8_COUNTS,
          "room for %u of %u: status %d", claimed, depth, less);
    /* Packets that wait at edges are on no stack. */
    CHECK(claimed > 1 || batch > 0 || less == PLT_ERR_IMAGE, "one entry is enough for %u", depth);
    close_run(&x);
}

static void claims_of_depth(void) {
    static subject s;
    fill_subject(&s, 3000, 1, 16);
    const uint32_t depth = plt_get_u32(s.image.bytes + 64);
    for (uint32_t claimed = 1; claimed <= depth; claimed++) {
        for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
            claim(&s, depth, claimed, side);
        }
    }
    pack_free(&s.image);
}

static void refuses_config(rig_config config, const char *word) {
    mesh m = {0};
    rig r;
    config.run.residency = PLT_RESIDENCY_STREAMED;
    shape_soup(&m, 50, 0.5f, 3);
    CHECK(rig_open(&r, &m, &config) == PLT_ERR_ARGUMENT && strstr(r.fault.message, word), "%s: %s",
          rig_name(&config), r.fault.message);
    rig_close(&r);
    mesh_free(&m);
}

static void refusals(void) {
    refuses_config(rig_config_of(2, 257, PLT_BUILD_HOST, PLT_SPLIT_SAH), "256 nodes");
    refuses_config(rig_config_of(2, 16, PLT_BUILD_DEVICE, PLT_SPLIT_SAH), "only finished trees");
    rig_config two_stage = rig_config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    two_stage.run.order = PLT_ORDER_TWO_STAGE;
    refuses_config(two_stage, "depth first");
}

/* ---- all ----------------------------------------------------------------------- */

static void sources_that_fail(int soaks) {
    static subject s;
    const uint32_t step = soaks ? 17 : batch > 0 ? 211 : 101;
    int cuts = 0;
    fill_subject(&s, 2501, 2, 16); /* the last page is not full */
    test("a transfer that fails or is short once is got over");
    every_call_fails_once(&s, FAKE_FAILS_AT_START, step);
    every_call_fails_once(&s, FAKE_SHORT_AT_START, step);
    every_call_fails_once(&s, FAKE_SILENT_AT_START, step);
    test("a wrong bit of any transfer is noticed; what is wrong whenever it comes is told");
    every_transfer_is_garbled(&s, 2, 2 * step);
    test("of a source that fails for good the place is told, and all goes on when it is mended");
    for (uint32_t call = 1; call < 200; call += call < 40 ? 1 : 7) {
        cuts += is_cut_and_mended(&s, call);
    }
    CHECK(cuts > 40, "%d cuts", cuts);
    pack_free(&s.image);
    if (batch == 0) { /* whatever asks for a part, it is checked by the same code */
        test("... be it the first transfer, the last or any between");
        fill_subject(&s, 401, 2, 16);
        every_transfer_is_garbled(&s, 2, 1);
        pack_free(&s.image);
    }
}

/* All that depends on the schedule. */
static void schedule(const char *sentence, int soaks) {
    test(sentence);
    for (uint32_t n = 1; n <= PLT_STREAMED_TREELET_MOST; n *= 2) {
        all_stores(n == 16 || n == 64 ? 9000 : 4000, 1 + n % 3, n);
    }
    all_stores(6000, 4, 37);
    all_stores(3000, 40, 16); /* lists of more than a page */
    test("scenes of few triangles");
    for (uint32_t few = 0; few < 12; few++) {
        few_triangles(few, 1 + few % 3);
    }
    test("packets come back to treelets that are as deep as they can be");
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        deep_treelets(side);
    }
    sources_that_fail(soaks);
    test("images that lie are refused when it shows, or are traced without harm");
    forged_images(soaks ? 50000 : 500);
    test("a source that returns other bytes each time does no harm");
    changing_sources(soaks ? 200 : 4);
    test("a tree that is deeper than its header claims does not overflow the stack");
    claims_of_depth();
}

/* All of it with parts that are on their way while rays are traced. */
static void prefetched(const char *sentence, int soaks) {
    static subject s;
    const enum fake_failure kinds[] = {FAKE_FAILS_AT_START, FAKE_FAILS_AT_WAIT,
                                       parts_ahead == 1 ? FAKE_SHORT_AT_START
                                                        : FAKE_GARBLED_AT_START};
    test(sentence);
    for (uint32_t n = 1; n <= PLT_STREAMED_TREELET_MOST; n *= 4) {
        all_stores(n == 16 ? 9000 : 3000, 1 + n % 3, n);
    }
    all_stores(3000, 40, 16); /* lists of more than a page */
    for (uint32_t few = 0; few < 12; few++) {
        few_triangles(few, 1 + few % 3);
    }
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        deep_treelets(side);
    }
    fill_subject(&s, 2500, 2, 16);
    for (unsigned i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        every_call_fails_once(&s, kinds[i], soaks ? 1 : 101);
    }
    for (uint32_t call = 1; call < 200; call += call < 20 ? 1 : 17) {
        is_cut_and_mended(&s, call);
    }
    for (uint32_t call = 2; call < 200; call += call < 20 ? 1 : 17) {
        is_garbled_and_mended(&s, call);
    }
    pack_free(&s.image);
    forged_images(soaks ? 20000 : 100);
    changing_sources(soaks ? 100 : 2);
    claims_of_depth();
}

/* As it was before there were checks. */
static void unchecked(const char *sentence) {
    test(sentence);
    for (uint32_t n = 4; n <= 64; n *= 4) {
        all_stores(4000, 2, n);
    }
    for (uint32_t few = 0; few < 12; few++) {
        few_triangles(few, 1 + few % 3);
    }
    forged_images(200);
    changing_sources(2);
}

static void ahead_of_rays(void) {
    static subject s;
    for (uint32_t n = 4; n <= 64; n *= 4) {
        fill_subject(&s, 9000, 2, n);
        every_distance(&s, 30); /* leaves of a soup lie in each other: many are not met */
        pack_free(&s.image);
    }
}

int main(void) {
    const char *soak = getenv("PLANELET_SOAK");
    const int soaks = soak != NULL && soak[0] == '1';
    every_schedule(schedule,
                   "hits and frames are those of the resident scene, whatever treelets and store",
                   soaks);
    test("treelets of all fills and slots that pack forms");
    all_treelets();
    is_unchecked = 1;
    unchecked("the same of images whose parts have no checks");
    is_unchecked = 0;
    test("parts that come ahead of the rays: most are wanted");
    ahead_of_rays();
    parts_ahead = 1;
    every_schedule(prefetched, "... one at a time, failures and lies are got over", soaks);
    parts_ahead = PLT_PREFETCH_MOST;
    every_schedule(prefetched, "... as many as may be", soaks);
    parts_ahead = 0;
    test("links that would lead to a treelet in countless ways are refused");
    ways_without_number(1, 1);
    ways_without_number(1, 0);
    ways_without_number(2, 1);
    ways_without_number(16, 0);
    ways_without_number(16, 16);
    test("one wrong word is refused by its rule");
    one_word_wrong();
    list_without_end();
    test("what cannot be streamed is refused");
    refusals();
    return test_done();
}
