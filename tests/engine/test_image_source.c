/* test_image_source - sources that fail, delay, corrupt or end early
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "board/fake/fake.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

#define RAYS 500u

static packed image_of(uint32_t triangles, uint8_t build) {
    mesh m = {0};
    packed image;
    fail f = {""};
    const pack_options options = {
        .splits = PLT_SPLIT_SAH, .build = build, .leaf_triangles = 2, .treelet_nodes = 3};
    shape_soup(&m, triangles, 0.6f, 17);
    CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0, "%s", f.text);
    mesh_free(&m);
    return image;
}

static plt_options options_of(void) {
    const plt_options options = {.packet_side = 2, .count_touched = 1};
    return options;
}

/* An arena for the streamed image, full of a pattern. */
static void *arena_for(const packed *image, size_t *bytes) {
    const plt_options options = options_of();
    *bytes = plt_arena_need(&image->info, 0, &options);
    void *arena = aligned_alloc(PLT_ALIGN, *bytes);
    memset(arena, 0x5A, *bytes);
    return arena;
}

static fake_link link_to(const packed *image) {
    const fake_link link = {.image = image->bytes, .bytes = image->size};
    return link;
}

static int open_over(fake_link *link, void *arena, size_t bytes, plt_engine **e, plt_fault *fault) {
    const plt_source source = fake_source(link);
    const plt_options options = options_of();
    return plt_open(e, arena, bytes, &source, &options, fault);
}

static void no_bad_manners(const fake_link *link, const char *what, uint32_t call) {
    CHECK(link->broken == 0, "%s %u: %s", what, call, link->sentence);
    CHECK(fake_unfinished(link) == 0, "%s %u: %u transfers still pending", what, call,
          fake_unfinished(link));
}

/* The number of calls a successful opening makes; also checks the hits. */
static uint32_t works(const packed *image, int at_once) {
    plt_ray rays[RAYS];
    plt_hit streamed[RAYS], mapped[RAYS];
    mesh m = {0};
    random_state r = {4};
    plt_engine *e;
    plt_fault fault;
    size_t bytes;
    void *arena = arena_for(image, &bytes);
    fake_link link = link_to(image);
    link.at_once = at_once;
    CHECK(open_over(&link, arena, bytes, &e, &fault) == PLT_OK, "%s", fault.message);
    no_bad_manners(&link, "no failure", 0);
    CHECK(link.bytes_moved == image->size, "%llu bytes moved",
          (unsigned long long)link.bytes_moved);
    shape_cube(&m);
    rays_mixed(rays, RAYS, &m, &r);
    mesh_free(&m);
    if (e != NULL) {
        plt_trace(e, rays, streamed, RAYS, 0);
    }
    uint32_t met = 0;
    for (uint32_t i = 0; i < RAYS && e != NULL; i++) {
        met += streamed[i].triangle != PLT_MISS;
    }
    CHECK(met > RAYS / 8, "%u of %u rays hit", met, (unsigned)RAYS);
    const plt_source source = rig_source(image);
    const plt_options options = options_of();
    const size_t need = plt_arena_need(&image->info, 1, &options);
    void *other = aligned_alloc(PLT_ALIGN, need);
    CHECK(plt_open(&e, other, need, &source, &options, &fault) == PLT_OK, "%s", fault.message);
    if (e != NULL) {
        plt_trace(e, rays, mapped, RAYS, 0);
        CHECK(memcmp(mapped, streamed, sizeof mapped) == 0, "streamed and mapped hits differ");
    }
    free(other);
    free(arena);
    return link.starts + link.waits;
}

static void fails_at_every_call(const packed *image, enum fake_failure kind, uint32_t calls,
                                int at_once) {
    uint32_t failed = 0;
    for (uint32_t call = 1; call <= calls; call++) {
        plt_engine *e;
        plt_fault fault;
        size_t bytes;
        void *arena = arena_for(image, &bytes);
        fake_link link = link_to(image);
        link.failure = kind;
        link.at_call = call;
        link.at_once = at_once;
        const int status = open_over(&link, arena, bytes, &e, &fault);
        no_bad_manners(&link, "call", call);
        if (link.failed > 0) {
            CHECK(status == PLT_ERR_SOURCE && e == NULL, "kind %d, call %u: status %d", (int)kind,
                  call, status);
            CHECK(fault.message != NULL && fault.offset < image->size, "kind %d, call %u: fault",
                  (int)kind, call);
            failed++;
        } else {
            CHECK(status == PLT_OK, "kind %d, call %u: %s", (int)kind, call, fault.message);
        }
        free(arena);
    }
    CHECK(failed >= calls / 3, "kind %d: %u of %u calls failed", (int)kind, failed, calls);
}

/* The source reports no error: only the checksums can detect wrong bytes. */
static void lies_at_every_start(const packed *image, enum fake_failure kind, uint32_t calls) {
    uint32_t noticed = 0;
    for (uint32_t call = 1; call <= calls; call++) {
        plt_engine *e;
        plt_fault fault;
        size_t bytes;
        void *arena = arena_for(image, &bytes);
        fake_link link = link_to(image);
        link.failure = kind;
        link.at_call = call;
        const int status = open_over(&link, arena, bytes, &e, &fault);
        no_bad_manners(&link, "start", call);
        CHECK(call > link.starts ? status == PLT_OK : status == PLT_ERR_IMAGE,
              "kind %d, start %u of %u: status %d", (int)kind, call, link.starts, status);
        noticed += status == PLT_ERR_IMAGE;
        free(arena);
    }
    CHECK(noticed >= 2, "%u noticed", noticed);
}

static void shorter_source(const packed *image) {
    for (uint32_t size = 0; size < image->size; size += size < 300 ? 1 : 37) {
        plt_engine *e;
        plt_fault fault;
        size_t bytes;
        void *arena = arena_for(image, &bytes);
        fake_link link = link_to(image);
        link.bytes = size;
        const int status = open_over(&link, arena, bytes, &e, &fault);
        no_bad_manners(&link, "size", size);
        CHECK(status == PLT_ERR_IMAGE && e == NULL, "size %u: status %d", size, status);
        free(arena);
    }
}

static void transfers_stay_inside(const packed *image) {
    size_t bytes;
    void *arena = arena_for(image, &bytes);
    fake_link link = link_to(image);
    plt_engine *e;
    plt_fault fault;
    CHECK(open_over(&link, arena, bytes, &e, &fault) == PLT_OK, "%s", fault.message);
    const uint32_t per_section = PLT_TRANSFER_BYTES;
    const uint32_t due = (256 + per_section - 1) / per_section +
                         (image->info.node_bytes + per_section - 1) / per_section +
                         (image->info.triangle_bytes + per_section - 1) / per_section;
    CHECK(link.starts == due, "%u transfers, not %u", link.starts, due);
    free(arena);
}

static void arguments(const packed *image) {
    plt_engine *e;
    plt_fault fault;
    size_t bytes;
    unsigned char *arena = arena_for(image, &bytes);
    plt_options options = options_of();
    plt_source source = rig_source(image);
    const plt_source nowhere = {NULL, image->size, NULL, NULL, NULL};
    CHECK(plt_open(&e, arena, bytes, &nowhere, &options, &fault) == PLT_ERR_ARGUMENT && !e, "none");
    CHECK(plt_image_info(&nowhere, &(plt_info){0}, &fault) == PLT_ERR_ARGUMENT, "none");
    source.mapped = image->bytes + 8;
    CHECK(plt_open(&e, arena, bytes, &source, &options, &fault) == PLT_ERR_ARGUMENT && !e,
          "an image that is not aligned");
    source.mapped = image->bytes;
    CHECK(plt_open(&e, arena + 8, bytes - 8, &source, &options, &fault) == PLT_ERR_ARGUMENT && !e,
          "an arena that is not aligned");
    for (unsigned side = 0; side < 256; side++) {
        options.packet_side = (uint8_t)side;
        const int valid = (side == 0 || side == 2 || side == 4 || side == 8 || side == 16) &&
                          side <= PLT_PACKET_SIDE_MAX;
        CHECK((plt_arena_need(&image->info, 1, &options) != 0) == valid, "side %u", side);
        if (!valid) {
            CHECK(plt_open(&e, arena, bytes, &source, &options, &fault) == PLT_ERR_ARGUMENT && !e,
                  "side %u", side);
        }
    }
    options = options_of();
    options.order = 2;
    CHECK(plt_open(&e, arena, bytes, &source, &options, &fault) == PLT_ERR_ARGUMENT && !e, "order");
    free(arena);
}

/* Reported before the arena, which is too small for anything, is looked at. */
static void two_stages_of_blocks(void) {
    static _Alignas(PLT_ALIGN) unsigned char arena[PLT_ALIGN];
    const compact_options how = {.lattice_bits = 16, .leaf_triangles = 2};
    const plt_options options = {
        .packet_side = 2, .order = PLT_ORDER_TWO_STAGE, .count_touched = 1};
    packed image;
    mesh m = {0};
    lattice_loss loss;
    plt_engine *e;
    plt_fault fault;
    fail f = {""};
    shape_cube(&m);
    CHECK(pack_compact(&image, &m, &how, "test", &loss, &f) == 0, "%s", f.text);
    const plt_source source = rig_source(&image);
    CHECK(plt_open(&e, arena, 0, &source, &options, &fault) == PLT_ERR_ARGUMENT && !e, "%s",
          fault.message);
    CHECK(plt_arena_need(&image.info, 1, &options) == 0, "a need");
    pack_free(&image);
    mesh_free(&m);
}

int main(void) {
    packed image[2] = {image_of(rig_triangles(250, 2), PLT_BUILD_HOST),
                       image_of(rig_triangles(250, 2), PLT_BUILD_DEVICE)};
    uint32_t calls[2] = {0, 0};
    test("an image that is streamed gives the hits of one that is mapped");
    for (int i = 0; i < 2; i++) {
        works(&image[i], 1);
        calls[i] = works(&image[i], 0);
    }
    test("a source that fails at any call gives PLT_ERR_SOURCE and leaves no pending transfer");
    for (int i = 0; i < 2; i++) {
        for (int at_once = 0; at_once < 2; at_once++) {
            fails_at_every_call(&image[i], FAKE_FAILS_AT_CALL, calls[i] + 2, at_once);
            fails_at_every_call(&image[i], FAKE_FAILS_FROM_CALL, calls[i] + 2, at_once);
            fails_at_every_call(&image[i], FAKE_FAILS_AT_START, calls[i] + 2, at_once);
            fails_at_every_call(&image[i], FAKE_FAILS_AT_WAIT, calls[i] + 2, at_once);
        }
        fails_at_every_call(&image[i], FAKE_SHORT_AT_START, calls[i], 0);
    }
    test("wrong or missing bytes are detected");
    for (int i = 0; i < 2; i++) {
        lies_at_every_start(&image[i], FAKE_GARBLED_AT_START, calls[i]);
        lies_at_every_start(&image[i], FAKE_SILENT_AT_START, calls[i]);
    }
    test("a source shorter than its image is refused and not read beyond its end");
    shorter_source(&image[0]);
    shorter_source(&image[1]);
    test("an image is fetched once, in transfers of PLT_TRANSFER_BYTES");
    transfers_stay_inside(&image[0]);
    transfers_stay_inside(&image[1]);
    test("sources, arenas and options out of range are refused as arguments");
    arguments(&image[0]);
    two_stages_of_blocks();
    pack_free(&image[0]);
    pack_free(&image[1]);
    return test_done();
}
