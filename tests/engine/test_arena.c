/* test_arena - the arena's size, guards, failures, and images that are never written
 *
 * Arenas lie between pages that may not be touched; an image that is mapped
 * lies on pages that may not be written.
 *
 * SPDX-License-Identifier: MIT */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "engine/base/arena.h"
#include "tests/hostile/images.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { ZONE = 64, PATTERN = 0xC3 };

/* `bytes` that end just before a page that cannot be touched. */
typedef struct walled {
    unsigned char *base, *at;
    size_t mapped_bytes, page;
} walled;

static walled wall(size_t bytes) {
    walled w = {.page = (size_t)sysconf(_SC_PAGESIZE)};
    const size_t inside = (bytes + ZONE + w.page - 1) / w.page * w.page;
    w.mapped_bytes = inside + 2 * w.page;
    w.base = mmap(NULL, w.mapped_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    w.at = w.base + w.page + inside - bytes;
    memset(w.base, PATTERN, w.mapped_bytes);
    mprotect(w.base, w.page, PROT_NONE);
    mprotect(w.base + w.page + inside, w.page, PROT_NONE);
    return w;
}

static int zone_is_whole(const walled *w) {
    for (const unsigned char *p = w->base + w->page; p < w->at; p++) {
        if (*p != PATTERN) {
            return 0;
        }
    }
    return 1;
}

static void unwall(const walled *w) {
    munmap(w->base, w->mapped_bytes);
}

typedef struct opened {
    int status;
    plt_fault fault;
    size_t used, peak;
} opened;

/* Opens in an arena of `bytes` and traces if that works. (If `bytes` is no multiple of
 * PLT_ALIGN, the guard page is at the next multiple.) */
static opened open_in(const packed *image, size_t bytes, int streamed, const plt_options *options) {
    opened o;
    hostile_stream stream = {image->bytes, image->size, 0};
    plt_source source = rig_source(image);
    if (streamed) {
        const plt_source s = {NULL, image->size, &stream, hostile_start, hostile_wait};
        source = s;
    }
    plt_engine *e = NULL;
    const walled w = wall((bytes + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN);
    o.status = plt_open(&e, w.at, bytes, &source, options, &o.fault);
    o.used = o.peak = 0;
    if (o.status == PLT_OK) {
        const char *sentence = hostile_trace(e);
        CHECK(sentence == NULL, "%s", sentence);
        o.used = plt_arena_used(e);
        o.peak = plt_arena_peak(e);
    }
    CHECK((e != NULL) == (o.status == PLT_OK), "status %d", o.status);
    CHECK(zone_is_whole(&w), "bytes before the arena were written");
    CHECK(!stream.beyond, "the source was read beyond its end");
    unwall(&w);
    return o;
}

static packed image_of(uint32_t triangles, uint8_t build, uint32_t k, uint32_t n) {
    mesh m = {0};
    packed image;
    fail f = {""};
    const pack_options options = {PLT_SPLIT_SAH, build, k, n, NULL, 0, NULL, 0, 0};
    shape_soup(&m, triangles, 0.5f, triangles);
    CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0, "%s", f.text);
    mesh_free(&m);
    return image;
}

/* Every size: from exactly the need on it is enough; below, the fault reports the need. */
static void host_sizes(const packed *image, int streamed, const plt_options *options) {
    const size_t need = plt_arena_need(&image->info, !streamed, options);
    for (size_t bytes = 0; bytes < need + 100; bytes += bytes + 200 < need ? 97 : 1) {
        const opened o = open_in(image, bytes, streamed, options);
        if (bytes < need) {
            CHECK(o.status == PLT_ERR_ARENA && o.fault.need_bytes == need,
                  "%zu bytes of %zu: status %d, need %zu", bytes, need, o.status,
                  o.fault.need_bytes);
        } else {
            CHECK(o.status == PLT_OK, "%zu bytes of %zu: %s", bytes, need, o.fault.message);
            CHECK(o.peak == need && o.used <= o.peak, "used %zu, peak %zu, need %zu", o.used,
                  o.peak, need);
        }
    }
}

/* A device may need less: the need is for the worst tree. */
static void device_sizes(const packed *image, int streamed, const plt_options *options) {
    const size_t need = plt_arena_need(&image->info, !streamed, options);
    size_t least = 0;
    for (size_t bytes = 0; bytes < need + 400; bytes += 48) {
        const opened o = open_in(image, bytes, streamed, options);
        if (bytes >= need || o.status == PLT_OK) {
            CHECK(o.status == PLT_OK, "%zu bytes of %zu: %s", bytes, need, o.fault.message);
            CHECK(o.peak <= bytes, "peak %zu of %zu", o.peak, bytes);
            least = least == 0 ? bytes : least;
        } else {
            CHECK(o.status == PLT_ERR_ARENA && o.fault.need_bytes == need,
                  "%zu bytes of %zu: status %d", bytes, need, o.status);
        }
    }
    const opened exact = open_in(image, need, streamed, options);
    CHECK(exact.status == PLT_OK && least < need + 48, "need %zu, least %zu", need, least);
}

static void sizes(void (*of)(const packed *, int, const plt_options *), uint8_t build) {
    /* The stacks of the last scene are larger than the scratch of opening. */
    static const uint32_t triangles[5] = {0, 1, 3, 60, 500}, nodes[5] = {1, 1, 1, 3, 64};
    const int count = build == PLT_BUILD_HOST && !rig_is_tiny() ? 5 : 4;
    for (int i = 0; i < count; i++) {
        packed image = image_of(triangles[i], build, 1, nodes[i]);
        for (uint8_t order = 0; order < 2; order++) {
            const plt_options small = {.packet_side = 2, .order = order, .count_touched = 1};
            const plt_options large = {
                .packet_side = PLT_PACKET_SIDE_MAX, .order = order, .count_touched = 1};
            of(&image, 0, &small);
            of(&image, 1, &large);
        }
        pack_free(&image);
    }
}

/* The image lies on pages that cannot be written. */
static void read_only(uint8_t build) {
    packed image = image_of(rig_triangles(200, 2), build, 2, 3);
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    const size_t bytes = (image.size + page - 1) / page * page;
    unsigned char *pages =
        mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    memcpy(pages, image.bytes, image.size);
    mprotect(pages, bytes, PROT_READ);
    packed locked = image;
    locked.bytes = pages;
    for (uint8_t order = 0; order < 2; order++) {
        const plt_options options = {.packet_side = 2, .order = order, .count_touched = 1};
        const opened o = open_in(&locked, plt_arena_need(&image.info, 1, &options), 0, &options);
        CHECK(o.status == PLT_OK, "build %u: %s", build, o.fault.message);
    }
    CHECK(memcmp(pages, image.bytes, image.size) == 0, "the image has changed");
    munmap(pages, bytes);
    pack_free(&image);
}

/* Many engines of one image: none affects the others. */
static void side_by_side(void) {
    enum { ENGINES = 4, RAYS = 256 };
    packed image = image_of(60, PLT_BUILD_HOST, 1, 2);
    const plt_source source = rig_source(&image);
    const plt_options options = {.packet_side = 2, .count_touched = 1};
    const size_t need = plt_arena_need(&image.info, 1, &options);
    unsigned char *arena = aligned_alloc(PLT_ALIGN, ENGINES * need), *before = malloc(need);
    plt_engine *e[ENGINES];
    plt_fault fault;
    plt_ray rays[RAYS];
    plt_hit hits[ENGINES][RAYS];
    mesh m = {0};
    random_state r = {1};
    shape_cube(&m);
    rays_mixed(rays, RAYS, &m, &r);
    for (int i = 0; i < ENGINES; i++) {
        CHECK(plt_open(&e[i], arena + i * need, need, &source, &options, &fault) == PLT_OK, "%s",
              fault.message);
    }
    memcpy(before, arena + need, need);
    plt_trace(e[0], rays, hits[0], RAYS, 0);
    plt_trace(e[2], rays, hits[2], RAYS, 0);
    CHECK(memcmp(before, arena + need, need) == 0, "an engine wrote into another's arena");
    plt_trace(e[1], rays, hits[1], RAYS, 0);
    uint32_t met = 0;
    for (int i = 0; i < RAYS; i++) {
        met += hits[0][i].triangle != PLT_MISS;
    }
    CHECK(met > RAYS / 8, "%u of %d rays hit", met, (int)RAYS);
    CHECK(memcmp(hits[0], hits[1], sizeof hits[0]) == 0 &&
              memcmp(hits[0], hits[2], sizeof hits[0]) == 0,
          "hits differ");
    free(arena);
    free(before);
    pack_free(&image);
    mesh_free(&m);
}

static void cuts(void) {
    _Alignas(16) unsigned char memory[256];
    plt_arena a = {memory, sizeof memory, 0, 0};
    CHECK(plt_arena_cut(&a, 1) == memory && a.used == 16, "one byte");
    CHECK(plt_arena_cut(&a, 16) == memory + 16 && a.used == 32, "sixteen");
    CHECK(plt_arena_cut(&a, 0) == memory + 32 && a.used == 32, "none");
    CHECK(plt_arena_cut(&a, 225) == NULL && a.used == 32 && a.peak == 32, "too many");
    CHECK(plt_arena_cut(&a, SIZE_MAX) == NULL && a.used == 32, "the largest possible count");
    CHECK(plt_arena_cut(&a, SIZE_MAX - 15) == NULL && a.used == 32, "all but fifteen");
    CHECK(plt_arena_cut(&a, 224) == memory + 32 && a.used == 256, "the rest");
    plt_arena_release(&a, 16);
    CHECK(a.used == 16 && a.peak == 256, "given back");
    CHECK(plt_arena_cut(&a, 3) == memory + 16, "cut again");
    CHECK(plt_arena_cut_bytes(SIZE_MAX - 3) == SIZE_MAX, "saturates");
}

/* Needs larger than any arena: they grow with the triangles and never wrap. */
static void largest_needs(void) {
    const plt_options options = {.packet_side = 2, .count_touched = 1};
    for (uint8_t format = 0; format < 2; format++) {
        size_t before = 0;
        for (uint32_t triangles = 1; triangles < 1u << 27; triangles = 2 * triangles + 1) {
            const plt_info info = {.triangles = triangles,
                                   .treelet_nodes = 64,
                                   .leaf_triangles = 1,
                                   .triangle_bytes = format == 0 ? 31 * triangles : 0,
                                   .build = PLT_BUILD_DEVICE,
                                   .nodes_format = format,
                                   .geometry_format = format,
                                   .lattice_bits = format == 0 ? 0 : 21};
            const size_t need = plt_arena_need(&info, 1, &options);
            CHECK(need > before || need == SIZE_MAX, "%u triangles: %zu bytes after %zu", triangles,
                  need, before);
            before = need;
        }
    }
}

int main(void) {
    test("cuts are aligned, a cut that does not fit changes nothing");
    cuts();
    test("exactly the need is enough; a byte less fails and reports the need");
    sizes(host_sizes, PLT_BUILD_HOST);
    sizes(host_sizes, PLT_BUILD_NONE);
    test("for a build on the device the need is enough; less is built or refused");
    sizes(device_sizes, PLT_BUILD_DEVICE);
    test("more triangles never need less, up to 2^27 - 1 of them");
    largest_needs();
    test("an image that is mapped is never written");
    for (uint8_t build = 0; build < 3; build++) {
        read_only(build);
    }
    test("engines side by side do not affect each other");
    side_by_side();
    return test_done();
}
