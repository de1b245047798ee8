/* test_stream - scenes whose blocks stay in a source that is small, slow, wrong or hostile
 *
 * Hits and frames are compared with those of the same image, resident. Every transfer fails once,
 * in every way that fake.h knows, and for good; every byte of blocks may be wrong.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "board/fake/fake.h"
#include "engine/base/rules.h"
#include "engine/engine.h"
#include "tests/reference/compact_hostile.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/rays.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { RAYS = 1024, WIDTH = 40, HEIGHT = 28, GUARD = 64 };

typedef struct run {
    unsigned char *arena;
    size_t bytes;
    plt_engine *engine;
    plt_fault fault;
    fake_link link;
} run;

typedef struct subject {
    packed image;
    plt_ray rays[RAYS];
    plt_hit due[2][RAYS]; /* nearest, any */
    uint8_t frame[3 * WIDTH * HEIGHT];
} subject;

static plt_options options_of(uint8_t residency, uint8_t packet_side, uint32_t store_bytes) {
    const plt_options o = {.packet_side = packet_side,
                           .count_touched = 1,
                           .residency = residency,
                           .store_bytes = store_bytes};
    return o;
}

static int open_run(run *x, const packed *image, const plt_options *o) {
    x->bytes = plt_arena_need(&image->info, 0, o);
    x->arena = aligned_alloc(PLT_ALIGN, x->bytes + GUARD);
    memset(x->arena, 0x5A, x->bytes + GUARD);
    x->link.image = image->bytes;
    x->link.bytes = image->size;
    x->link.arena = x->arena;
    x->link.arena_bytes = x->bytes;
    const plt_source source = fake_source(&x->link);
    return plt_open(&x->engine, x->arena, x->bytes, &source, o, &x->fault);
}

static void close_run(run *x) {
    CHECK(x->link.broken == 0, "%s", x->link.sentence);
    CHECK(fake_unfinished(&x->link) == 0, "transfers are pending");
    for (unsigned i = 0; i < GUARD; i++) {
        CHECK(x->arena[x->bytes + i] == 0x5A, "written behind the arena");
    }
    free(x->arena);
}

static int render(plt_engine *e, uint8_t frame[3 * WIDTH * HEIGHT]) {
    const plt_info *info = plt_engine_info(e);
    plt_frame f = {.width = WIDTH, .height = HEIGHT, .camera = {{0}, {0}, {0, 1, 0}, 0.6f}};
    for (int a = 0; a < 3; a++) {
        f.camera.look[a] = 0.5f * (info->lo[a] + info->hi[a]);
        f.camera.eye[a] = f.camera.look[a] + (a == 2 ? 1.8f : 0.4f) * (info->hi[2] - info->lo[2]);
    }
    int status = plt_render_begin(e, &f);
    while (status >= PLT_OK && (status = plt_render_step(e, 50)) > PLT_OK) {
        plt_tile tile;
        plt_render_tile(e, &tile);
        for (unsigned y = 0; status == PLT_TILE && y < tile.height; y++) {
            memcpy(frame + 3 * ((tile.y + y) * WIDTH + tile.x), tile.rgb + 3 * y * tile.width,
                   3u * tile.width);
        }
    }
    return status;
}

static void fill_subject(subject *s, uint32_t triangles, uint32_t k, uint8_t bits, int ids) {
    mesh m = {0};
    random_state r = {triangles + k};
    shape_soup(&m, compact_triangles(triangles, k), 0.1f, 3 + k);
    rays_mixed(s->rays, RAYS, &m, &r);
    compact_config c = compact_config_of(k, bits, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    c.pack.numbers = (uint8_t)ids;
    s->image = compact_packed(&m, &c);
    run x = {0};
    const plt_options o = options_of(PLT_RESIDENCY_WHOLE, 2, 0);
    CHECK(open_run(&x, &s->image, &o) == PLT_OK, "%s", x.fault.message);
    plt_trace(x.engine, s->rays, s->due[0], RAYS, 0);
    plt_trace(x.engine, s->rays, s->due[1], RAYS, 1);
    CHECK(render(x.engine, s->frame) == PLT_OK, "the frame");
    close_run(&x);
}

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
    const uint64_t tree = s->image.info.node_bytes + s->image.info.triangle_bytes;
    CHECK(q.bytes_touched_once > tree / 4, "little was touched: the test is weak");
    if (store >= 2 * s->image.size) {
        CHECK(q.bytes_fetched == q.bytes_touched_once && q.store_evictions == 0, "fetched twice");
    } else if (tree > 2 * store) {
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

/* ---- sources that fail ------------------------------------------------------ */

static int trace_all(run *x, const subject *s, plt_hit hits[RAYS]) {
    return plt_trace(x->engine, s->rays, hits, RAYS, 0);
}

/* One failure is got over: the same hits, one retry. */
static uint32_t fails_once(const subject *s, enum fake_failure kind, uint32_t call) {
    run x = {.link = {.failure = kind, .at_call = call, .at_once = call % 2}};
    plt_hit hits[RAYS];
    plt_stats q;
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, 0);
    const int status = open_run(&x, &s->image, &o);
    if (status != PLT_OK) { /* of the header: nothing is tried again */
        free(x.arena);
        return 1;
    }
    CHECK(trace_all(&x, s, hits) == PLT_OK, "kind %d, call %u", (int)kind, call);
    CHECK(memcmp(hits, s->due[0], sizeof hits) == 0, "kind %d, call %u: hits", (int)kind, call);
    plt_stats_get(x.engine, &q);
    const uint32_t retries = (uint32_t)q.fetch_retries, starts = x.link.starts;
    close_run(&x);
    return call > starts ? 0 : retries;
}

static void every_call_fails_once(const subject *s, enum fake_failure kind, uint32_t step) {
    uint32_t call = 1, failed = 0;
    for (; call < 100000; call += call < 40 ? 1 : step) {
        const uint32_t retries = fails_once(s, kind, call);
        if (retries == 0) {
            break;
        }
        CHECK(retries == 1, "kind %d, call %u: %u retries", (int)kind, call, retries);
        failed++;
    }
    CHECK(failed > 40, "kind %d: %u failures", (int)kind, failed);
}

/* A link that is cut: the status says so, the fault where; and when it is mended all goes on. */
static void is_cut_and_mended(const subject *s, uint32_t call) {
    run x = {.link = {.failure = FAKE_FAILS_FROM_CALL, .at_call = call}};
    plt_hit hits[RAYS];
    uint8_t frame[3 * WIDTH * HEIGHT];
    plt_fault fault;
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, 0);
    if (open_run(&x, &s->image, &o) == PLT_OK) {
        memset(hits, 0x77, sizeof hits);
        const int status = call % 2 ? trace_all(&x, s, hits) : render(x.engine, frame);
        plt_fault_get(x.engine, &fault);
        CHECK(status == PLT_ERR_SOURCE, "call %u: status %d", call, status);
        CHECK(fault.offset >= PLT_HEADER_BYTES && fault.offset < s->image.size &&
                  strstr(fault.message, "source") != NULL,
              "call %u: byte %u, %s", call, (unsigned)fault.offset, fault.message);
        int ended = 0;
        for (uint32_t i = 0; i < RAYS && call % 2; i++) {
            ended |= hits[i].triangle == 0x77777777u;
            CHECK(ended || memcmp(&hits[i], &s->due[0][i], sizeof hits[i]) == 0,
                  "call %u: hit %u before the failure is wrong", call, i);
        }
        x.link.failure = FAKE_WORKS;
        CHECK(trace_all(&x, s, hits) == PLT_OK && memcmp(hits, s->due[0], sizeof hits) == 0,
              "call %u: hits after it was mended", call);
        CHECK(render(x.engine, frame) == PLT_OK && memcmp(frame, s->frame, sizeof frame) == 0,
              "call %u: the frame after it was mended", call);
        close_run(&x);
        return;
    }
    free(x.arena);
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

static void forge(packed *image, uint32_t blocks, random_state *r) {
    unsigned char *section = image->bytes + PLT_HEADER_BYTES;
    for (uint32_t times = 1 + random_below(r, 3); times > 0; times--) {
        const uint32_t at = random_below(r, blocks);
        switch (random_below(r, 4)) {
        case 0:
            section[at] ^= (unsigned char)(1u << random_below(r, 8));
            break;
        case 1:
            section[at] = (unsigned char)random_bits(r);
            break;
        case 2: /* a word that may be a link, from elsewhere */
            memcpy(section + (at & ~3u), section + (random_below(r, blocks) & ~3u), 4);
            break;
        default:
            section[at] = random_below(r, 2) ? 0 : 0xFF;
        }
    }
}

static void forged_images(uint32_t seeds) {
    static subject s;
    uint32_t refused = 0, tried = 0;
    for (uint32_t scene = 0; scene < 4; scene++) {
        fill_subject(&s, 700, scene % 2 ? 2 : 1, scene < 2 ? 14 : 18, scene != 1);
        const uint32_t blocks = s.image.info.node_bytes + s.image.info.triangle_bytes;
        unsigned char *whole = malloc(s.image.size);
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
            CHECK(claim > 1 || status == PLT_ERR_IMAGE, "a claim of one level is believed");
            CHECK(claim < depth || status == PLT_OK, "the depth itself is refused");
            close_run(&x);
        }
    }
    pack_free(&s.image);
}

static void refusals(void) {
    static subject s;
    mesh m = {0};
    rig r;
    rig_config config = rig_config_of(2, 3, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    fill_subject(&s, 300, 2, 14, 1);
    plt_options o = options_of(PLT_RESIDENCY_STREAMED, 2, PLT_STORE_LEAST - 16);
    CHECK(plt_arena_need(&s.image.info, 0, &o) == 0, "a store below the least");
    o.store_bytes = 0;
    o.residency = 2;
    CHECK(plt_arena_need(&s.image.info, 0, &o) == 0, "an unknown residency");
    shape_soup(&m, 50, 0.5f, 3);
    config.run.residency = PLT_RESIDENCY_STREAMED;
    CHECK(plt_can_stream(&s.image.info), "compact blocks can be streamed");
    CHECK(rig_open(&r, &m, &config) == PLT_ERR_ARGUMENT && strstr(r.fault.message, "compact"),
          "thesis nodes: %s", r.fault.message);
    rig_close(&r);
    mesh_free(&m);
    pack_free(&s.image);
}

int main(void) {
    const char *soak = getenv("PLANELET_SOAK");
    static subject s;
    test("hits and frames are those of the resident scene, whatever the store");
    all_stores(12000, 1, 14, 1);
    all_stores(12000, 2, 18, 0);
    all_stores(9000, 4, 21, 1);
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
    every_call_fails_once(&s, FAKE_FAILS_AT_START, 17);
    every_call_fails_once(&s, FAKE_SHORT_AT_START, 17);
    every_call_fails_once(&s, FAKE_SILENT_AT_START, 17);
    test("of a source that fails for good the place is told, and all goes on when it is mended");
    for (uint32_t call = 1; call < 200; call += call < 40 ? 1 : 7) {
        is_cut_and_mended(&s, call);
    }
    pack_free(&s.image);
    test("a wrong bit of nodes or geometry is noticed, and they are fetched again");
    fill_subject(&s, 2500, 2, 14, 0); /* primitive ids have no check: SPEC.md, 5.5 */
    every_call_fails_once(&s, FAKE_GARBLED_AT_START, 17);
    pack_free(&s.image);
    test("images that lie are refused when it shows, or are traced without harm");
    forged_images(soak != NULL && soak[0] == '1' ? 100000 : 700);
    test("a tree that is deeper than its header claims does not overflow the stack");
    claims_of_depth();
    test("what cannot be streamed is refused");
    refusals();
    return test_done();
}
