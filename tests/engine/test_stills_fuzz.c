/* test_stills_fuzz - stills that nobody made, with checks that are right: frames that show, and
 * rays
 *
 * Blocks of any frame, and what the header says of them. PLANELET_SOAK=1 runs a hundred times as
 * many.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/tree/compact/block_tree.h"
#include "tests/hostile/mutations.h"
#include "tests/hostile/sequences.h"
#include "tests/reference/room.h"
#include "tests/reference/sequence_rig.h"
#include "tests/test.h"

enum { SEEDS = 6, MUTATIONS = 600, AT_NODE_BYTES = 220, AT_TRIANGLE_BYTES = 224 };

static packed make_image(uint32_t seed) {
    static const uint32_t bits[3] = {12, 16, 21};
    const sequence_config c = {.scene = rig_config_of(1u << seed % 3, 1, PLT_BUILD_HOST, 0),
                               .frames = 2 + seed % 3,
                               .key_every = 1,
                               .lattice_bits = bits[seed % 3],
                               .is_mapped = 1,
                               .is_compact = 1,
                               .is_stills = 1,
                               .without_ids = seed % 4 == 3};
    return sequence_rig_image(&c, rig_triangles(20 + 60 * seed, c.scene.pack.leaf_triangles), seed);
}

/* ---- sealing ---------------------------------------------------------------------- */

static void add_salt(unsigned char *part, uint32_t check_at, uint32_t salt) {
    part[check_at] ^= (unsigned char)salt;
    part[check_at + 1] ^= (unsigned char)(salt >> 8);
}

static void seal_frame(unsigned char *blocks, uint32_t used, uint32_t bits, uint32_t frame,
                       const hostile_ids *ids) {
    const uint32_t salt = plt_still_salt(frame);
    for (uint32_t at = 0, block = 1; block > 0 && at < used; at += block) {
        plt_block b;
        block = hostile_seal_block(blocks + at, used - at, bits, ids);
        if (block > 0) {
            plt_block_open(&b, blocks + at, bits);
            add_salt(blocks + at, 2, salt);
            if (b.geometry_bytes > 0) {
                add_salt(blocks + at + b.node_bytes, 6, salt);
            }
        }
    }
}

static void seal(unsigned char *bytes, uint32_t size) {
    const hostile_section stills = hostile_section_at(bytes, size, 0, 9);
    const uint64_t used =
        (uint64_t)plt_get_u32(bytes + AT_NODE_BYTES) + plt_get_u32(bytes + AT_TRIANGLE_BYTES);
    const hostile_ids ids = hostile_ids_of(bytes, size);
    for (uint32_t k = 0; stills.bytes != NULL && (k + 1) * used + 8 <= stills.count && k < 8; k++) {
        seal_frame(stills.bytes + k * used, (uint32_t)used, plt_get_u32(bytes + 184), k, &ids);
    }
    hostile_seal_header(bytes, size);
}

/* ---- trying ----------------------------------------------------------------------- */

static unsigned long shown, refused, traced;

/* Each frame shows, or is refused by a rule; then the last one that has shown goes on. */
static const char *show(plt_engine *e) {
    const uint32_t frames = plt_engine_info(e)->frames;
    for (uint32_t i = 0; i < frames && i < HOSTILE_FRAMES_MOST; i++) {
        plt_fault fault;
        const int status = plt_sequence_show(e, i * 7 % frames, &fault);
        shown += status == PLT_OK;
        refused += status != PLT_OK;
        if (status != PLT_OK && !(status == PLT_ERR_IMAGE && fault.kind == 'I' &&
                                  fault.offset < plt_engine_info(e)->image_bytes)) {
            return "a frame is refused without a rule";
        }
        const char *sentence = hostile_trace_streamed(e);
        if (sentence != NULL) {
            return sentence;
        }
        traced++;
    }
    return NULL;
}

/* Half of the damage is to the first bytes of blocks, where their sizes are. */
static void damage(unsigned char *bytes, uint32_t size, random_state *r) {
    const uint32_t way = random_below(r, 8);
    const uint32_t at = way == 0   ? 168 + random_below(r, 60)
                        : way == 1 ? 72 + random_below(r, 24)
                        : way < 5  ? 256 + random_below(r, size - 256 < 64 ? size - 256 : 64)
                                   : 256 + random_below(r, size - 256);
    mutate_at(bytes, size, at, r);
}

static void try_images(unsigned times) {
    random_state r = {11};
    for (uint32_t seed = 0; seed < SEEDS; seed++) {
        packed image = make_image(seed);
        unsigned char *bytes = room_get(image.size);
        for (unsigned i = 0; i < times; i++) {
            const hostile_config config = {
                .streamed = i % 2, .packet_side = 2, .residency = PLT_RESIDENCY_STREAMED};
            memcpy(bytes, image.bytes, image.size);
            for (uint32_t n = i == 0 ? 0 : 1 + random_below(&r, 3); n > 0; n--) {
                damage(bytes, image.size, &r);
            }
            seal(bytes, image.size);
            CHECK(i > 0 || memcmp(bytes, image.bytes, image.size) == 0, "seed %u is sealed", seed);
            const hostile_result a =
                hostile_try_with(bytes, image.size, config, HOSTILE_RECORDS, show);
            CHECK(a.sentence == NULL, "seed %u, mutation %u: %s", seed, i, a.sentence);
        }
        free(bytes);
        pack_free(&image);
    }
}

int main(void) {
    test("stills that are damaged and sealed again: frames show or are refused, and rays, too");
    try_images(mutations_of(MUTATIONS));
    CHECK(shown > 2000 && refused > 200 && traced > 1000, "%lu shown, %lu refused, %lu traced",
          shown, refused, traced);
    return test_done();
}
