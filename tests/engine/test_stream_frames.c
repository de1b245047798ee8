/* test_stream_frames - frames of streamed compact blocks by beams, as machines without lanes have
 * them
 *
 * As test_stream, whose sources fail in every way: frames are those of the same image, resident and
 * by groups of rays.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/base/rules.h"
#include "engine/memory/prefetch.h"
#include "tests/reference/room.h"
#include "tests/reference/stream_compact.h"

enum { FRAME_BYTES = 3 * WIDTH * HEIGHT };

/* ---- the same from every store --------------------------------------------- */

/* A frame, and how many bytes came for it. */
static uint64_t same(const subject *s, uint8_t side, uint32_t store) {
    run x = {0};
    uint8_t frame[FRAME_BYTES];
    plt_stats q;
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, side, store);
    CHECK(open_run(&x, &s->image, &o) == PLT_OK, "%s", x.fault.message);
    for (int again = 0; again < 2; again++) {
        CHECK(render(x.engine, frame) == PLT_OK, "side %u, store %u", side, store);
        CHECK(memcmp(frame, s->frame, sizeof frame) == 0, "side %u, store %u: frame", side, store);
    }
    plt_stats_get(x.engine, &q);
    CHECK(q.bytes_fetched + PLT_HEADER_BYTES == x.link.bytes_moved, "bytes are not those moved");
    CHECK(q.fetch_retries == 0 && fake_unfinished(&x.link) == 0, "statistics");
    CHECK(q.rays == 2 * WIDTH * HEIGHT, "%u rays", (unsigned)q.rays);
    if (store >= 2 * s->image.size) {
        CHECK(q.bytes_fetched == q.bytes_touched_once && q.store_evictions == 0, "fetched twice");
    }
    close_run(&x);
    return q.bytes_fetched;
}

static void all_stores(uint32_t triangles, uint32_t k, uint8_t bits, int ids) {
    static subject s;
    fill_subject(&s, triangles, k, bits, ids);
    for (uint8_t side = PLT_BEAM_BLOCKS_LEAST; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        for (unsigned i = 0; i < 3; i++) {
            static const uint32_t store[3] = {0, 40000, 4u << 20};
            const uint64_t bytes = same(&s, side, store[i]);
            by_beams = 0;
            const uint64_t groups = same(&s, side, store[i]);
            by_beams = 1;
            CHECK(bytes < groups + groups / (parts_ahead > 0 ? 2 : 4),
                  "side %u: %u bytes, %u by groups of rays", side, (unsigned)bytes,
                  (unsigned)groups);
        }
    }
    pack_free(&s.image);
}

/* Beams and rays in turn over one engine, which share its stack and its packet. */
static void in_turn(void) {
    static subject s;
    run x = {0};
    uint8_t frame[FRAME_BYTES];
    plt_hit hits[RAYS];
    const plt_options o = options_of(PLT_RESIDENCY_STREAMED, PLT_BEAM_BLOCKS_LEAST, 0);
    fill_subject(&s, 3000, 2, 14, 1);
    CHECK(open_run(&x, &s.image, &o) == PLT_OK, "%s", x.fault.message);
    for (int i = 0; i < 6; i++) {
        by_beams = i % 2;
        CHECK(render(x.engine, frame) == PLT_OK && memcmp(frame, s.frame, sizeof frame) == 0,
              "frame %d", i);
        CHECK(trace_all(&x, &s, hits) == PLT_OK && memcmp(hits, s.due[0], sizeof hits) == 0,
              "hits %d", i);
    }
    by_beams = 1;
    close_run(&x);
    pack_free(&s.image);
}

static void few_triangles(void) {
    for (uint32_t few = 1; few < 4; few++) {
        static subject s;
        fill_subject(&s, few, 2, 14, 1);
        same(&s, PLT_BEAM_BLOCKS_LEAST, 0);
        pack_free(&s.image);
    }
}

/* ---- images that lie --------------------------------------------------------- */

static void forged_images(uint32_t seeds) {
    static subject s;
    uint32_t refused = 0;
    fill_subject(&s, 700, 2, 14, 1);
    const uint32_t blocks = s.image.info.node_bytes + s.image.info.triangle_bytes;
    unsigned char *whole = room_get(s.image.size);
    memcpy(whole, s.image.bytes, s.image.size);
    for (uint32_t seed = 0; seed < seeds; seed++) {
        random_state r = {seed};
        run x = {0};
        uint8_t frame[FRAME_BYTES];
        const plt_options o = options_of(PLT_RESIDENCY_STREAMED, PLT_BEAM_BLOCKS_LEAST, 0);
        forge(&s.image, blocks, &r);
        compact_seal(s.image.bytes, s.image.size, seed % 8 != 0);
        CHECK(open_run(&x, &s.image, &o) == PLT_OK, "%s", x.fault.message);
        const int status = render(x.engine, frame);
        plt_fault_get(x.engine, &x.fault);
        CHECK(status == PLT_OK ||
                  (status == PLT_ERR_IMAGE && x.fault.kind == 'I' && x.fault.offset < s.image.size),
              "seed %u: status %d", seed, status);
        refused += status == PLT_ERR_IMAGE;
        close_run(&x);
        memcpy(s.image.bytes, whole, s.image.size);
    }
    CHECK(refused > seeds / 8 && refused < seeds * 9 / 10, "%u of %u refused", refused, seeds);
    free(whole);
    pack_free(&s.image);
}

/* Blocks as deep as they can be, and as the header claims and the stack has room for. */
static void deep_blocks(uint8_t side) {
    static subject s;
    s.image = deep_image(side, s.rays);
    if (s.image.size > 0) {
        set_due(&s);
        same(&s, side, 0);
        pack_free(&s.image);
    }
}

static void claims_of_depth(void) {
    static subject s;
    fill_subject(&s, 3000, 1, 14, 1);
    const uint32_t depth = plt_get_u32(s.image.bytes + 64);
    for (uint32_t claim = 1; claim <= depth; claim++) {
        run x = {0};
        int is_same = 0;
        const plt_options o = options_of(PLT_RESIDENCY_STREAMED, PLT_PACKET_SIDE_MAX, 0);
        plt_put_u32(s.image.bytes + 64, claim);
        compact_seal(s.image.bytes, s.image.size, 0);
        s.image.info.depth_stack_entries = claim;
        CHECK(open_run(&x, &s.image, &o) == PLT_OK, "%s", x.fault.message);
        for (int less = 0; less < 2; less++) { /* then as if the stack had no room to spare */
            const int status = trace_or_render(&x, &s, &is_same);
            plt_fault_get(x.engine, &x.fault);
            CHECK(status == PLT_OK ? is_same
                                   : status == PLT_ERR_IMAGE && x.fault.rule == PLT_I18_COUNTS,
                  "claim %u of %u, less %d: status %d", claim, depth, less, status);
            CHECK(less ? claim > 1 || status != PLT_OK : claim < depth || status == PLT_OK,
                  "claim %u of %u, less %d: status %d", claim, depth, less, status);
            x.engine->scene.info.depth_stack_entries = claim - PLT_STACK_SLACK;
        }
        close_run(&x);
    }
    pack_free(&s.image);
}

static void changing_sources(uint32_t seeds) {
    static subject s;
    uint32_t ended = 0;
    fill_subject(&s, 2500, 2, 14, 1);
    for (uint32_t seed = 0; seed < seeds; seed++) {
        changing c = {.random = {seed}};
        forge_versions(&c, &s);
        trace_changing(&c, &s, PLT_BEAM_BLOCKS_LEAST, &ended);
    }
    pack_free(&s.image);
}

/* ---- all of it --------------------------------------------------------------- */

static void failures(void) {
    static subject s;
    static const enum fake_failure kinds[] = {FAKE_FAILS_AT_START, FAKE_FAILS_AT_WAIT,
                                              FAKE_SHORT_AT_START, FAKE_SILENT_AT_START};
    int cuts = 0;
    fill_subject(&s, 2500, 2, 14, 1);
    for (unsigned i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        every_call_fails_once(&s, kinds[i], 31);
    }
    for (uint32_t call = 1; call < 200; call += call < 40 ? 1 : 7) {
        cuts += is_cut_and_mended(&s, call);
    }
    CHECK(cuts > 40, "%d cuts", cuts);
    pack_free(&s.image);
    fill_subject(&s, 2500, 2, 14, 0); /* primitive ids have no check: SPEC.md, 5.5 */
    every_call_fails_once(&s, FAKE_GARBLED_AT_START, 31);
    pack_free(&s.image);
}

static void all(const char *when, uint8_t ahead, int is_soak) {
    char sentence[160];
    parts_ahead = ahead;
    snprintf(sentence, sizeof sentence,
             "%s: frames are those of the resident scene, whatever the "
             "store, and take few more bytes than by groups of rays",
             when);
    test(sentence);
    all_stores(12000, 1, 14, 1);
    all_stores(12000, 2, 18, 0);
    all_stores(9000, 4, 21, 1);
    few_triangles();
    in_turn();
    test("a transfer that fails, is short or wrong is got over, or told, and all goes on after it");
    failures();
    test("images that lie are refused when it shows, or rendered without harm");
    forged_images(is_soak ? 30000 : 300);
    test("a source that returns other bytes each time does no harm");
    changing_sources(is_soak ? 100 : 5);
    test("blocks that are deep, and deeper than the header claims, do not overflow the stack");
    for (uint8_t side = PLT_BEAM_BLOCKS_LEAST; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        deep_blocks(side);
    }
    claims_of_depth();
}

int main(void) {
    const char *soak = getenv("PLANELET_SOAK");
    const int is_soak = soak != NULL && soak[0] == '1';
    if (PLT_PACKET_SIDE_MAX < PLT_BEAM_BLOCKS_LEAST) {
        test("packets of this build are too small for beams over blocks: frames go by groups");
        CHECK(PLT_PACKET_SIDE_MAX == 2, "%d", PLT_PACKET_SIDE_MAX);
        return test_done();
    }
    by_beams = 1;
    all("one part at a time", 0, is_soak);
    all("one part ahead", 1, is_soak);
    all("as many ahead as may be", PLT_PREFETCH_MOST, is_soak);
    return test_done();
}
