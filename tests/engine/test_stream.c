/* test_stream - scenes whose blocks stay in a source that is small, slow, wrong or hostile
 *
 * Hits and frames are compared with those of the same image, resident. Every transfer fails once,
 * in every way that fake.h knows, and for good; every byte of blocks may be wrong.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/base/rules.h"
#include "tests/reference/room.h"
#include "tests/reference/stream_compact.h"

/* ---- the same from every store --------------------------------------------- */

static void same(const subject *s, uint8_t side, uint32_t store) {
    run x = {0};
    uint8_t frame[3 * WIDTH * HEIGHT];
    plt_hit hits[RAYS];
    plt_stats q;
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, side, store);
    const int status = open_run(&x, &s->image, &o);
    CHECK(status == PLT_OK, "%s", x.fault.message);
    CHECK(x.link.bytes_moved == PLT_HEADER_BYTES, "opening moves more than the header");
    for (int any = 0; any < 2 && status == PLT_OK; any++) {
        CHECK(plt_trace(x.engine, s->rays, hits, RAYS, any) == PLT_OK, "any %d", any);
        CHECK(memcmp(hits, s->due[any], sizeof hits) == 0, "side %u, any %d: hits", side, any);
    }
    CHECK(render(x.engine, frame) == PLT_OK, "the frame");
    CHECK(memcmp(frame, s->frame, sizeof frame) == 0, "side %u, store %u: frame", side, store);
    plt_stats_get(x.engine, &q);
    CHECK(q.bytes_fetched + PLT_HEADER_BYTES == x.link.bytes_moved, "bytes are not those moved");
    CHECK(q.fetch_retries == 0 && q.bytes_touched_once <= q.bytes_fetched, "statistics");
    CHECK(q.bytes_validated >= (parts_ahead > 0 ? q.bytes_touched_once / 2 : q.bytes_fetched),
          "bytes that came were not validated");
    CHECK(fake_unfinished(&x.link) == 0, "something is on its way still");
    const uint64_t tree = s->image.info.node_bytes + s->image.info.triangle_bytes;
    CHECK(q.bytes_touched_once > tree / 4, "little was touched: the test is weak");
    if (store >= 2 * s->image.size) {
        CHECK(q.bytes_fetched == q.bytes_touched_once && q.store_evictions == 0, "fetched twice");
    } else if (tree > 3 * (uint64_t)(store > 0 ? store : PLT_STORE_LEAST)) {
        CHECK(q.store_evictions > 100, "%u evictions", (unsigned)q.store_evictions);
    }
    close_run(&x);
}

static void all_stores(uint32_t triangles, uint32_t k, uint8_t bits, int ids) {
    static subject s;
    fill_subject(&s, triangles, k, bits, ids);
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        same(&s, side, 0);
        same(&s, side, 40000);
        same(&s, side, 4u << 20);
    }
    pack_free(&s.image);
}

/* Without sizes the store takes what the arena has, beside packets of a size that leaves it half.
 */
static void takes_the_rest(void) {
    static subject s;
    fill_subject(&s, 3000, 2, 14, 1);
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, 0, 0);
    for (size_t more = 0; more < 400000; more += 50000) {
        const size_t bytes = plt_arena_need(&s.image.info, 0, &o) + more;
        run x = {.link = {.image = s.image.bytes, .bytes = s.image.size}};
        x.arena = aligned_alloc(PLT_ALIGN, (bytes + 15) & ~(size_t)15);
        const plt_source source = fake_source(&x.link);
        const int status = plt_open(&x.engine, x.arena, bytes, &source, &o, &x.fault);
        CHECK(status == PLT_OK, "%zu bytes: %s", bytes, x.fault.message);
        CHECK(status != PLT_OK || plt_arena_used(x.engine) + 2 * PLT_ALIGN > bytes,
              "%zu of %zu used", plt_arena_used(x.engine), bytes);
        free(x.arena);
    }
    pack_free(&s.image);
}

/* ---- images that lie --------------------------------------------------------- */

/* A forged image, streamed: PLT_OK or a refusal with its place, and hits within their ranges. */
static const char *try_forged(const packed *image, uint32_t *refused) {
    run x = {0};
    plt_ray rays[HOSTILE_RAYS];
    plt_hit hits[HOSTILE_RAYS];
    plt_stats q;
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, 0);
    const char *wrong = NULL;
    if (open_run(&x, image, &o) == PLT_OK) {
        hostile_rays(rays, plt_engine_info(x.engine));
        const int status = plt_trace(x.engine, rays, hits, HOSTILE_RAYS, 0);
        plt_stats_get(x.engine, &q);
        plt_fault_get(x.engine, &x.fault);
        *refused += status == PLT_ERR_IMAGE;
        for (uint32_t i = 0; i < HOSTILE_RAYS && status == PLT_OK; i++) {
            if (hits[i].triangle != PLT_MISS && hits[i].triangle >= compact_ids_end(&image->info)) {
                wrong = "a hit is out of range";
            }
        }
        /* However many nodes the header claims, a block has 64, and at least 40 bytes. */
        if (q.node_visits > visits_most(&q, 64ull * image->size / 40)) {
            wrong = "a node was visited twice";
        }
        if (status != PLT_OK &&
            (status != PLT_ERR_IMAGE || x.fault.kind != 'I' || x.fault.offset >= image->size)) {
            wrong = "refused without its place";
        }
    } else {
        ++*refused;
    }
    close_run(&x);
    return wrong;
}

static void forged_images(uint32_t seeds) {
    static subject s;
    uint32_t refused = 0, tried = 0;
    for (uint32_t scene = 0; scene < 4; scene++) {
        fill_subject(&s, 700, scene % 2 ? 2 : 1, scene < 2 ? 14 : 18, (int)(scene + 3) % 4 % 3);
        const uint32_t blocks = s.image.info.node_bytes + s.image.info.triangle_bytes;
        unsigned char *whole = room_get(s.image.size);
        memcpy(whole, s.image.bytes, s.image.size);
        for (uint32_t seed = 0; seed < seeds; seed++, tried++) {
            random_state r = {seed * 4 + scene};
            forge(&s.image, blocks, &r);
            compact_seal(s.image.bytes, s.image.size, seed % 8 != 0);
            const char *wrong = try_forged(&s.image, &refused);
            CHECK(wrong == NULL, "scene %u, seed %u: %s", scene, seed, wrong);
            memcpy(s.image.bytes, whole, s.image.size);
        }
        free(whole);
        pack_free(&s.image);
    }
    CHECK(refused > tried / 8 && refused < tried * 9 / 10, "%u of %u refused", refused, tried);
}

/* A link to the last block that says that it is longer than the image: it is refused before
 * anything is asked for. close_run counts reads beyond the end. */
static void link_beyond_the_end(void) {
    static subject s;
    fill_subject(&s, 700, 2, 14, 0);
    unsigned char *section = s.image.bytes + PLT_HEADER_BYTES;
    const uint32_t used = s.image.info.node_bytes + s.image.info.triangle_bytes;
    plt_block b;
    plt_block_open(&b, section, 14);
    CHECK(b.edges > 0, "the root has no edges");
    for (uint32_t edge = 0; edge < b.edges; edge++) {
        unsigned char *link = (unsigned char *)(uintptr_t)b.links + 4 * edge;
        const uint32_t was = plt_get_u32(link);
        plt_put_u32(link, plt_block_link((used - 8) & ~7u, 1020));
        compact_seal(s.image.bytes, s.image.size, 1);
        run x = {0};
        plt_hit hits[RAYS];
        const plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, 0);
        CHECK(open_run(&x, &s.image, &o) == PLT_OK, "%s", x.fault.message);
        const int status = trace_all(&x, &s, hits);
        plt_fault_get(x.engine, &x.fault);
        /* I10: a sibling met before has lost the room of its subtree. */
        CHECK(status == PLT_ERR_IMAGE &&
                  (x.fault.rule == PLT_I17_LINKS || x.fault.rule == PLT_I10_SIZES),
              "edge %u: status %d, rule %u", edge, status, x.fault.rule);
        close_run(&x);
        plt_put_u32(link, was);
    }
    pack_free(&s.image);
}

/* Packets come back to blocks again and again. */
static void deep_blocks(uint8_t side) {
    static plt_ray rays[RAYS];
    static plt_hit due[RAYS], hits[RAYS];
    packed image = deep_image(side, rays);
    for (unsigned residency = 0; image.size > 0 && residency < 2; residency++) {
        run x = {0};
        const plt_options o = options_of((uint8_t)residency, side, 0);
        CHECK(open_run(&x, &image, &o) == PLT_OK, "%s", x.fault.message);
        const int status = plt_trace(x.engine, rays, residency ? hits : due, RAYS, 0);
        plt_fault_get(x.engine, &x.fault);
        CHECK(status == PLT_OK, "side %u: status %d: %s", side, status, x.fault.message);
        CHECK(!residency || memcmp(hits, due, sizeof hits) == 0, "side %u: hits", side);
        close_run(&x);
    }
    pack_free(&image);
}

/* ---- a source that changes --------------------------------------------------- */

/* Every part comes from one of several versions. */
static void changes(const subject *s, uint8_t side, uint32_t seed, uint32_t *ended) {
    changing c = {.random = {seed}};
    forge_versions(&c, s);
    trace_changing(&c, s, side, ended);
}

static void changing_sources(uint32_t seeds) {
    static subject s;
    uint32_t ended = 0;
    fill_subject(&s, 2500, 2, 14, 1);
    for (uint32_t seed = 0; seed < seeds; seed++) {
        for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
            changes(&s, side, seed, &ended);
        }
    }
    pack_free(&s.image);
}

/* A header that claims a shallower tree, and so a smaller stack, than its blocks are. */
static void claims_of_depth(void) {
    static subject s;
    fill_subject(&s, 3000, 1, 14, 1);
    const uint32_t depth = plt_get_u32(s.image.bytes + 64);
    for (uint32_t claim = 1; claim <= depth; claim++) {
        for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
            run x = {0};
            plt_hit hits[RAYS];
            const plt_options o = options_of(PLT_RESIDENCY_STREAMED, side, 0);
            plt_put_u32(s.image.bytes + 64, claim);
            compact_seal(s.image.bytes, s.image.size, 0);
            s.image.info.depth_stack_entries = claim;
            CHECK(open_run(&x, &s.image, &o) == PLT_OK, "%s", x.fault.message);
            const int status = trace_all(&x, &s, hits);
            plt_fault_get(x.engine, &x.fault);
            CHECK(status == PLT_OK ? memcmp(hits, s.due[0], sizeof hits) == 0
                                   : status == PLT_ERR_IMAGE && x.fault.rule == PLT_I18_COUNTS,
                  "claim %u of %u: status %d", claim, depth, status);
            CHECK(claim < depth || status == PLT_OK, "the depth itself is refused");
            /* The stack has room for more than a scene of this depth; as if it had less. */
            x.engine->scene.info.depth_stack_entries = claim - PLT_STACK_SLACK;
            const int less = trace_all(&x, &s, hits);
            plt_fault_get(x.engine, &x.fault);
            CHECK(less == PLT_OK ? memcmp(hits, s.due[0], sizeof hits) == 0
                                 : less == PLT_ERR_IMAGE && x.fault.rule == PLT_I18_COUNTS,
                  "room for %u of %u: status %d", claim, depth, less);
            /* Packets that wait at edges are on no stack. */
            CHECK(claim > 1 || batch > 0 || less == PLT_ERR_IMAGE, "one entry is enough for %u",
                  depth);
            close_run(&x);
        }
    }
    pack_free(&s.image);
}

static void refuses_config(const compact_config *config) {
    mesh m = {0};
    rig r;
    compact_config c = *config;
    c.run.residency = PLT_RESIDENCY_STREAMED;
    shape_soup(&m, 50, 0.5f, 3);
    CHECK(compact_open(&r, &m, &c) == PLT_ERR_ARGUMENT && strstr(r.fault.message, "lattice"),
          "%s: %s", compact_name(&c), r.fault.message);
    rig_close(&r);
    mesh_free(&m);
}

static void refusals(void) {
    static subject s;
    fill_subject(&s, 300, 2, 14, 1);
    plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, PLT_STORE_LEAST - 16);
    CHECK(plt_arena_need(&s.image.info, 0, &o) == 0, "a store below the least");
    o.store_bytes = 0;
    o.residency = 2;
    CHECK(plt_arena_need(&s.image.info, 0, &o) == 0, "an unknown residency");
    o.residency = PLT_RESIDENCY_STREAMED;
    CHECK(plt_arena_need(&s.image.info, 0, &o) > 0, "a streamed scene");
    o.schedule = PLT_SCHEDULE_WORKER + 1;
    CHECK(plt_arena_need(&s.image.info, 0, &o) == 0, "an unknown schedule");
    o.schedule = PLT_SCHEDULE_BATCH;
    o.batch = PLT_BATCH_MOST + 1;
    CHECK(plt_arena_need(&s.image.info, 0, &o) == 0, "a batch above the most");
    o.batch = PLT_BATCH_MOST;
    CHECK(plt_arena_need(&s.image.info, 0, &o) > 0, "the largest batch");
    o.residency = PLT_RESIDENCY_WHOLE;
    CHECK(plt_arena_need(&s.image.info, 0, &o) == 0, "batches of a resident scene");
    o.residency = PLT_RESIDENCY_STREAMED;
    o.schedule = PLT_SCHEDULE_WORKER;
    CHECK(plt_arena_need(&s.image.info, 0, &o) == 0, "a worker with packets of its own");
    o.schedule = PLT_SCHEDULE_BRANCH;
    CHECK(plt_arena_need(&s.image.info, 0, &o) == 0, "a batch that nobody asked for");
    o.batch = 0;
    CHECK(plt_can_stream(&s.image.info), "compact blocks can be streamed");
    compact_config floats = compact_config_of(2, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    floats.pack.floats = 1;
    refuses_config(&floats);
    const compact_config device = compact_config_of(2, 14, PLT_BUILD_DEVICE, PLT_SPLIT_SAH);
    refuses_config(&device);
    pack_free(&s.image);
}

/* How far ahead may be. */
static void ahead_of_rays(void) {
    static subject s;
    fill_subject(&s, 9000, 2, 14, 1);
    every_distance(&s, 12);
    plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, 0);
    o.prefetch = PLT_PREFETCH_MOST + 1;
    CHECK(plt_arena_need(&s.image.info, 0, &o) == 0, "more parts ahead than there are tags");
    pack_free(&s.image);
}

/* ---- counts that are wrong once ---------------------------------------------- */

/* A source that garbles what it brings for the first time. */
typedef struct garbling {
    plt_source source; /* of the link */
    fake_link *link;
    const unsigned char *right;
    unsigned char *wrong; /* for the first time; from then on it is what is right, byte for byte */
} garbling;

static int garble_start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    garbling *g = context;
    g->link->image = g->wrong;
    const int status = g->source.start(g->source.context, tag, offset, to, count);
    memcpy(g->wrong + offset, g->right + offset, count);
    return status;
}

static int garble_wait(void *context, uint32_t tags) {
    const garbling *g = context;
    return g->source.wait(g->source.context, tags);
}

/* Counts of every geometry part come wrong, once: ids that were asked for by them are not taken for
 * those that belong to the part, which lie elsewhere. */
static void counts_wrong_once(int ids) {
    static subject s;
    run x = {.link = {.at_once = 1}};
    plt_hit hits[RAYS];
    plt_stats q;
    fill_subject(&s, 6000, 2, 14, ids);
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, 40000);
    garbling g = {.link = &x.link, .right = s.image.bytes, .wrong = room_get(s.image.size)};
    memcpy(g.wrong, s.image.bytes, s.image.size);
    garble_counts(&s, g.wrong);
    CHECK(open_run(&x, &s.image, &o) == PLT_OK, "%s", x.fault.message);
    g.source = x.engine->source;
    x.engine->source.context = &g;
    x.engine->source.start = garble_start;
    x.engine->source.wait = garble_wait;
    CHECK(trace_all(&x, &s, hits) == PLT_OK, "ids %d", ids);
    CHECK(memcmp(hits, s.due[0], sizeof hits) == 0, "ids %d: hits", ids);
    plt_stats_get(x.engine, &q);
    CHECK(q.fetch_retries > (rig_is_tiny() ? 0 : 5), "%u retries", (unsigned)q.fetch_retries);
    close_run(&x);
    free(g.wrong);
    pack_free(&s.image);
}

/* All of it with parts that are on their way while rays are traced. */
static void prefetched(const char *sentence, int soak) {
    static subject s;
    static const enum fake_failure kinds[] = {FAKE_FAILS_AT_START, FAKE_FAILS_AT_WAIT,
                                              FAKE_SHORT_AT_START, FAKE_SILENT_AT_START,
                                              FAKE_GARBLED_AT_START};
    const uint32_t step = soak ? 1 : batch > 0 ? 101 : 67;
    test(sentence);
    all_stores(6000, 2, 14, 1);
    fill_subject(&s, 2500, 2, 14, 1);
    for (unsigned i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        every_call_fails_once(&s, kinds[i], step);
    }
    for (uint32_t call = 1; call < 200; call += call < 20 ? 1 : 17) {
        is_cut_and_mended(&s, call);
    }
    for (uint32_t call = 2; call < 200; call += call < 20 ? 1 : 17) {
        is_garbled_and_mended(&s, call);
    }
    pack_free(&s.image);
    for (int ids = NO_IDS; ids <= IDS_UNCHECKED; ids++) {
        counts_wrong_once(ids);
    }
    forged_images(soak ? 30000 : 100);
    changing_sources(soak ? 100 : 3);
    claims_of_depth();
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        deep_blocks(side);
    }
}

/* Of batches: fewer bytes than packets one by one, and never a block twice in one batch. */
static void batches_save(void) {
    enum { SIDE = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8 };
    static subject s;
    uint64_t bytes[3], once = 0;
    const uint16_t packets[3] = {0, 4, RAYS / SIDE / SIDE};
    fill_subject(&s, 12000, 2, 14, 1);
    for (unsigned i = 0; i < 3; i++) {
        run x = {0};
        plt_hit hits[RAYS];
        plt_stats q;
        batch = packets[i];
        const plt_options o = options_of(PLT_RESIDENCY_STREAMED, SIDE, 0);
        CHECK(open_run(&x, &s.image, &o) == PLT_OK, "%s", x.fault.message);
        CHECK(trace_all(&x, &s, hits) == PLT_OK, "%u packets", packets[i]);
        plt_stats_get(x.engine, &q);
        bytes[i] = q.bytes_fetched;
        once = i == 0 ? q.bytes_touched_once : once;
        if (packets[i] * SIDE * SIDE >= RAYS) {
            CHECK(bytes[i] < q.bytes_touched_once * 21 / 20, "%u bytes of %u, all at once",
                  (unsigned)bytes[i], (unsigned)q.bytes_touched_once);
        }
        close_run(&x);
    }
    /* Scenes of tiny limits fit the least store: there is nothing to save. */
    CHECK(bytes[0] == once || (bytes[1] < bytes[0] / 2 && bytes[2] < bytes[1] / 2),
          "%u, %u and %u bytes", (unsigned)bytes[0], (unsigned)bytes[1], (unsigned)bytes[2]);
    batch = 0;
    pack_free(&s.image);
}

/* All that depends on the schedule. */
static void schedule(const char *sentence, int is_soak) {
    static subject s;
    const uint32_t step = batch > 0 ? 101 : 17;
    int cuts = 0;
    test(sentence);
    all_stores(12000, 1, 14, 1);
    all_stores(12000, 2, 18, 0);
    all_stores(9000, 4, 21, 1);
    all_stores(6000, 2, 14, IDS_UNCHECKED);
    test("scenes of no, one and two triangles");
    for (uint32_t few = 0; few < 3; few++) {
        mesh m = {0};
        run x = {0};
        plt_hit hit;
        const plt_ray ray = {{0, 0, 9}, 0, {0, 0, -1}, RAYS_FAR};
        compact_config c = compact_config_of(2, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
        shape_soup(&m, few, 0.5f, 1);
        packed image = compact_packed(&m, &c);
        const plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, 0);
        CHECK(open_run(&x, &image, &o) == PLT_OK, "%u: %s", few, x.fault.message);
        CHECK(plt_trace(x.engine, &ray, &hit, 1, 0) == PLT_OK, "%u triangles", few);
        close_run(&x);
        pack_free(&image);
    }
    test("a store of no stated size takes the room that the arena has");
    takes_the_rest();
    fill_subject(&s, 2500, 2, 14, 1);
    test("a transfer that fails, is short or wrong once is got over");
    every_call_fails_once(&s, FAKE_FAILS_AT_START, step);
    every_call_fails_once(&s, FAKE_SHORT_AT_START, step);
    every_call_fails_once(&s, FAKE_SILENT_AT_START, step);
    test("of a source that fails for good the place is told, and all goes on when it is mended");
    for (uint32_t call = 1; call < 200; call += call < 40 ? 1 : batch > 0 ? 40 : 7) {
        cuts += is_cut_and_mended(&s, call);
    }
    CHECK(cuts > (batch > 0 ? 30 : 40), "%d cuts", cuts);
    test("a wrong bit of any transfer is noticed; what is wrong whenever it comes is told");
    every_transfer_is_garbled(&s, 2, step);
    pack_free(&s.image);
    if (batch == 0) { /* whatever asks for a part, it is checked by the same code */
        test("... be it the first, the last or any between");
        for (int ids = NO_IDS; ids <= IDS; ids++) {
            fill_subject(&s, 1200, 2, 14, ids);
            every_transfer_is_garbled(&s, ids == IDS ? 2 : 1, 1);
            pack_free(&s.image);
        }
    }
    test("images that lie are refused when it shows, or are traced without harm");
    forged_images(is_soak ? 100000 : batch > 0 ? 300 : 700);
    test("a link that says more than the image has is refused before it is followed");
    link_beyond_the_end();
    test("packets come back to blocks that are as deep as they can be");
    for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        deep_blocks(side);
    }
    test("a source that returns other bytes each time does no harm");
    changing_sources(is_soak ? 300 : 8);
    test("a tree that is deeper than its header claims does not overflow the stack");
    claims_of_depth();
}

int main(void) {
    const char *soak = getenv("PLANELET_SOAK");
    const int is_soak = soak != NULL && soak[0] == '1';
    every_schedule(schedule, "hits and frames are those of the resident scene, whatever the store",
                   is_soak);
    test("packets that meet fetch less than packets one by one");
    batches_save();
    test("parts that come ahead of the rays: most are wanted");
    ahead_of_rays();
    parts_ahead = 1;
    every_schedule(prefetched, "... one at a time, failures and lies are got over", is_soak);
    parts_ahead = PLT_PREFETCH_MOST;
    every_schedule(prefetched, "... as many as may be", is_soak);
    parts_ahead = 0;
    test("what cannot be streamed is refused");
    refusals();
    return test_done();
}
