/* test_compact_record_cache - blocks built directly from a source that is not mapped
 *
 * The same blocks as from a mapped image, with a record cache of a few KB instead of all
 * corners. A source that fails at any transfer ends the build with its error; one that returns
 * other bytes when it is read again harms only the picture.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "engine/engine.h"
#include "engine/image/header.h"
#include "engine/image/record_cache.h"
#include "engine/planelet_crc32.h"
#include "host_tools/scenes/scenes.h"
#include "tests/hostile/images.h"
#include "tests/reference/compact_hostile.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/random.h"
#include "tests/reference/room.h"
#include "tests/test.h"

enum { GUARD = 64, PATTERN = 0xA5 };

/* An image behind a source that counts reads, fails or returns false bytes. */
typedef struct line {
    const unsigned char *bytes;
    uint32_t size, reads;
    uint32_t fail_at; /* this read fails; 0: none */
    uint32_t lie_at;  /* from this read on coordinates are changed; 0: none */
    random_state random;
    int beyond;
} line;

static int line_start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    line *l = context;
    (void)tag;
    l->beyond |= offset > l->size || count > l->size - offset;
    if (l->beyond || ++l->reads == l->fail_at) {
        return -1;
    }
    memcpy(to, l->bytes + offset, count);
    if (l->lie_at > 0 && l->reads >= l->lie_at) {
        for (uint32_t i = 0; i < 1 + count / 16; i++) {
            ((unsigned char *)to)[random_below(&l->random, count)] ^=
                (unsigned char)random_bits(&l->random);
        }
    }
    return 0;
}

static int line_wait(void *context, uint32_t tags) {
    (void)context, (void)tags;
    return 0;
}

typedef struct built {
    int status;
    plt_fault fault;
    unsigned char *arena;
    plt_engine *engine;
    size_t peak;
} built;

static built build(const packed *image, line *l, const plt_options *options) {
    const plt_source source = {NULL, image->size, l, line_start, line_wait};
    const size_t need = plt_arena_need(&image->info, 0, options);
    built b = {.arena = room_get(need + GUARD)};
    memset(b.arena + need, PATTERN, GUARD);
    b.status = plt_open(&b.engine, b.arena, need, &source, options, &b.fault);
    CHECK((b.engine != NULL) == (b.status == PLT_OK), "status %d", b.status);
    CHECK(!l->beyond, "read beyond the image");
    for (size_t i = 0; i < GUARD; i++) {
        CHECK(b.arena[need + i] == PATTERN, "byte %zu after the arena was written", i);
    }
    b.peak = b.engine != NULL ? plt_arena_peak(b.engine) : 0;
    return b;
}

static line line_of(const packed *image) {
    const line l = {image->bytes, image->size, 0, 0, 0, {1}, 0};
    return l;
}

static packed image_of(uint32_t triangles, const compact_config *config) {
    mesh m = {0};
    fail f = {""};
    CHECK(scene_knot(&m, triangles, &f) == 0, "%s", f.text);
    return compact_packed(&m, config);
}

/* Stack needs that the header of an image without a tree claims count for nothing: mapped
 * or not, the scene has those of the tree that was built. */
static void claimed_stacks(void) {
    enum { LOCAL_STACK_AT = 56 };
    const compact_config config = compact_config_of(2, 14, PLT_BUILD_DEVICE, PLT_SPLIT_SAH);
    packed image = image_of(compact_triangles(200, 2), &config);
    image.bytes[LOCAL_STACK_AT] = 3;
    hostile_seal_header(image.bytes, image.size);
    for (int mapped = 0; mapped < 2; mapped++) {
        line l = line_of(&image);
        const plt_source source = {mapped ? image.bytes : NULL, image.size, &l, line_start,
                                   line_wait};
        const size_t need = plt_arena_need(&image.info, mapped, &config.run);
        void *arena = room_get(need);
        plt_engine *e = NULL;
        plt_fault fault;
        CHECK(plt_open(&e, arena, need, &source, &config.run, &fault) == PLT_OK, "mapped %d: %s",
              mapped, fault.message);
        CHECK(e == NULL || plt_engine_info(e)->local_stack_entries == 0, "mapped %d: claimed",
              mapped);
        free(arena);
    }
    pack_free(&image);
}

static void same_blocks(uint32_t k, uint8_t bits, uint8_t splits) {
    const compact_config config = compact_config_of(k, bits, PLT_BUILD_DEVICE, splits);
    packed image = image_of(compact_triangles(6000, k), &config);
    const plt_source mapped = {image.bytes, image.size, NULL, NULL, NULL};
    const size_t need = plt_arena_need(&image.info, 1, &config.run);
    void *arena = room_get(need);
    plt_engine *e = NULL;
    plt_fault fault;
    CHECK(plt_open(&e, arena, need, &mapped, &config.run, &fault) == PLT_OK, "%s", fault.message);
    line l = line_of(&image);
    built b = build(&image, &l, &config.run);
    CHECK(b.status == PLT_OK, "%s", b.fault.message);
    if (e != NULL && b.engine != NULL) {
        const plt_block_tree *x = &e->scene.compact, *y = &b.engine->scene.compact;
        const size_t cache = plt_record_cache_bytes(plt_corners_bytes(bits)) + PLT_ALIGN;
        CHECK(x->used == y->used && memcmp(x->bytes, y->bytes, x->used) == 0, "blocks differ");
        CHECK(b.peak <= plt_arena_peak(e) + cache, "peak %zu, mapped %zu", b.peak,
              plt_arena_peak(e));
        printf("    %u triangles, K %u, %u bits: %zu bytes at most, %zu mapped; %u reads\n",
               image.info.triangles, k, bits, b.peak, plt_arena_peak(e), l.reads);
    }
    free(arena);
    free(b.arena);
    pack_free(&image);
}

/* Moves all corners up by one coordinate per axis, so that zeros lie outside the lattice's box. */
static void raise_corners(packed *image) {
    plt_header h;
    plt_fault fault;
    CHECK(plt_header_read(&h, image->bytes, image->size, &fault) == PLT_OK, "%s", fault.message);
    h.info.lattice_bits = (uint8_t)++h.lattice.bits; /* room for one more at the top */
    for (int a = 0; a < 3; a++) {
        h.info.lo[a] = plt_lattice_float(&h.lattice, a, ++h.lattice_box.lo[a]);
        h.info.hi[a] = plt_lattice_float(&h.lattice, a, ++h.lattice_box.hi[a]);
    }
    unsigned char *corners = image->bytes + h.section[0].offset;
    for (uint32_t i = 0; i < 9 * h.info.triangles; i++) {
        const uint32_t q = (uint32_t)(corners[2 * i] | corners[2 * i + 1] << 8) + 1;
        corners[2 * i] = (unsigned char)q;
        corners[2 * i + 1] = (unsigned char)(q >> 8);
    }
    h.section[0].crc = plt_crc32(0, corners, h.section[0].bytes);
    plt_header_write(image->bytes, &h);
    image->info = h.info;
    CHECK(h.lattice_box.lo[0] > 0, "zeros lie inside the lattice's box");
}

static void failures(int raised) {
    const compact_config config = compact_config_of(2, 14, PLT_BUILD_DEVICE, PLT_SPLIT_SAH);
    packed image = image_of(compact_triangles(400, 2), &config);
    if (raised) {
        raise_corners(&image);
    }
    line whole = line_of(&image);
    built b = build(&image, &whole, &config.run);
    CHECK(b.status == PLT_OK, "%s", b.fault.message);
    free(b.arena);
    for (uint32_t at = 1; at <= whole.reads; at++) {
        line l = line_of(&image);
        l.fail_at = at;
        b = build(&image, &l, &config.run);
        CHECK(b.status == PLT_ERR_SOURCE, "read %u of %u: status %d", at, whole.reads, b.status);
        CHECK(l.reads == at, "read %u of %u: it was read %u times", at, whole.reads, l.reads);
        free(b.arena);
    }
    pack_free(&image);
}

/* Reads of the header and of the first pass over the corners return true bytes. */
static void false_bytes(uint32_t k, uint8_t splits) {
    const compact_config config = compact_config_of(k, 14, PLT_BUILD_DEVICE, splits);
    packed image = image_of(compact_triangles(400, k), &config);
    uint32_t opened = 0, refused = 0;
    line whole = line_of(&image);
    built b = build(&image, &whole, &config.run);
    free(b.arena);
    for (uint32_t i = 0; i < 300; i++) {
        line l = line_of(&image);
        l.lie_at = 3 + random_below(&l.random, whole.reads);
        l.random.at = i;
        l.lie_at = 3 + random_below(&l.random, whole.reads);
        b = build(&image, &l, &config.run);
        if (b.status == PLT_OK) {
            const char *sentence = compact_trace_any(b.engine);
            CHECK(sentence == NULL, "%s", sentence);
            opened++;
        } else {
            CHECK(b.status == PLT_ERR_SOURCE || b.status == PLT_ERR_IMAGE ||
                      b.status == PLT_ERR_LIMIT || b.status == PLT_ERR_ARENA,
                  "status %d: %s", b.status, b.fault.message);
            refused++;
        }
        free(b.arena);
    }
    CHECK(refused > 0, "no false bytes were detected");
    printf("    K %u: of 300 false sources %u were refused, %u traced\n", k, refused, opened);
    pack_free(&image);
}

/* A step after one that failed fails again, whatever the arena now contains: this arena has no
 * byte to spare, and the check reuses the scratch. */
static void after_failure(void) {
    const compact_config config = compact_config_of(2, 14, PLT_BUILD_DEVICE, PLT_SPLIT_SAH);
    packed image = image_of(compact_triangles(400, 2), &config);
    line whole = line_of(&image);
    built b = build(&image, &whole, &config.run);
    const size_t bytes = b.peak;
    unsigned failed = 0;
    free(b.arena);
    for (uint32_t at = 3; at <= whole.reads; at++) {
        line l = line_of(&image);
        const plt_source source = {NULL, image.size, &l, line_start, line_wait};
        void *arena = room_get(bytes);
        plt_engine *e = NULL;
        plt_fault fault;
        *(at % 2 ? &l.lie_at : &l.fail_at) = at;
        int status = plt_open_begin(&e, arena, bytes, &source, &config.run, &fault);
        while (status == PLT_MORE) {
            status = plt_open_step(e, 1, &fault);
        }
        failed += status < 0;
        for (int i = 0; i < 3 && e != NULL && status < 0; i++) {
            CHECK(plt_open_step(e, 1, &fault) == status && fault.message[0] != 0,
                  "read %u: status %d, then a different one", at, status);
        }
        free(arena);
    }
    CHECK(failed > whole.reads / 2, "%u of %u failed", failed, whole.reads);
    pack_free(&image);
}

int main(void) {
    test(
        "through a record cache the blocks are those of a mapped image; it is the only extra "
        "memory");
    for (uint32_t k = 1; k <= 4; k *= 2) {
        same_blocks(k, 14, PLT_SPLIT_SAH);
        same_blocks(k, 21, PLT_SPLIT_SAH);
        same_blocks(k, 14, PLT_SPLIT_MEDIAN);
    }
    test("a source that fails at any read ends the build with its error, and is not read again");
    failures(0);
    failures(1);
    after_failure();
    test("a source that returns other bytes when read again gives an error or a valid tree");
    false_bytes(2, PLT_SPLIT_SAH);
    false_bytes(4, PLT_SPLIT_SAH);
    false_bytes(2, PLT_SPLIT_MEDIAN);
    test("stack needs that an image without a tree claims count for nothing");
    claimed_stacks();
    return test_done();
}
