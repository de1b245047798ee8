/* test_further_sections - images with all further sections at once, of sources that fail, and
 * forged
 *
 * Surfaces and lights are both asked for, in an arena of exactly its need: sanitizers see accesses
 * beyond it.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/material_section.h"
#include "tests/hostile/mutations.h"
#include "tests/hostile/surface.h"
#include "tests/reference/lit_rig.h"
#include "tests/reference/surface_rig.h"

enum { MUTATIONS = 1200, FLOATS = 1, KINDS = 4 };

/* A source that fails at one transfer, or when one is waited for. */
typedef struct failing {
    hostile_stream stream;
    uint32_t calls, fails_at; /* fails_at 0: never */
} failing;

static int start_failing(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    failing *f = context;
    return ++f->calls == f->fails_at ? -1 : hostile_start(&f->stream, tag, offset, to, count);
}

static int wait_failing(void *context, uint32_t tags) {
    failing *f = context;
    return ++f->calls == f->fails_at ? -1 : hostile_wait(&f->stream, tags);
}

/* Trees of three kinds, and one that the engine builds in steps, which has no normals. */
static packed image_of(unsigned kind) {
    lit_scene s;
    mesh_corners c = {0};
    material_stats stats;
    fail f = {""};
    packed image = {.size = 0};
    lit_scene_make(&s);
    CHECK(mesh_smooth(&s.m, 40, &c) == 0, "no memory");
    surface_rig_colour(&s.m, &c, 2);
    if (kind == 3) {
        const compact_options options = {
            .build = PLT_BUILD_DEVICE, .lattice_bits = 14, .numbers = 1, .leaf_triangles = 2};
        lattice_loss loss;
        CHECK(pack_compact(&image, &s.m, &options, "test", &loss, &f) == 0, "%s", f.text);
    } else if (kind == 2) {
        image = surface_rig_compact(&s.m, &c, !FLOATS);
    } else {
        const rig_config config =
            rig_config_of(2, 8, kind == 0 ? PLT_BUILD_NONE : PLT_BUILD_HOST, PLT_SPLIT_SAH);
        image = surface_rig_image(&s.m, &c, &config.pack);
    }
    CHECK(material_section_add(&image, &s.materials, NULL, "test", &stats, &f) == 0, "%s", f.text);
    corners_free(&c);
    lit_scene_free(&s);
    return image;
}

static int render(plt_engine *e) {
    const plt_lighting l = lit_lights(3);
    const plt_frame frame = {.camera = {.eye = {1, 4, 9}, .up = {0, 1, 0}, .tan_half_fov = 0.6f},
                             .width = 11,
                             .height = 7,
                             .shader = PLT_SHADE_WHITTED};
    int status = plt_lighting_set(e, &l);
    status = status == PLT_OK ? plt_render_begin(e, &frame) : status;
    if (status != PLT_OK) {
        return status;
    }
    do {
        status = plt_render_step(e, 100);
    } while (status > PLT_OK);
    return status;
}

static int try_source(const plt_source *source, uint8_t surface, plt_fault *fault) {
    const plt_options options = {.packet_side = 2, .surface = surface, .whitted = 4};
    plt_info info;
    plt_engine *e = NULL;
    int status = plt_image_info(source, &info, fault);
    if (status != PLT_OK) {
        return status;
    }
    const size_t need = plt_arena_need(&info, source->mapped != NULL, &options);
    if (need > 64u << 20) {
        return PLT_ERR_ARENA;
    }
    void *arena = aligned_alloc(PLT_ALIGN, need > 0 ? need : PLT_ALIGN);
    status = plt_open(&e, arena, need, source, &options, fault);
    if (status == PLT_OK) {
        status = render(e);
    }
    free(arena);
    return status;
}

static void failures(void) {
    test("a source that fails at any transfer makes opening fail, whichever section is copied");
    for (unsigned kind = 0; kind < KINDS; kind++) {
        packed image = image_of(kind);
        failing f = {.stream = {image.bytes, image.size, 0}};
        const plt_source source = {NULL, image.size, &f, start_failing, wait_failing};
        plt_fault fault = {.message = ""};
        const int status = try_source(&source, kind < 3, &fault);
        const uint32_t calls = f.calls;
        CHECK(status == PLT_OK || (rig_is_tiny() && status == PLT_ERR_LIMIT), "%u: %d %s", kind,
              status, fault.message);
        for (uint32_t at = 1; at <= calls && status == PLT_OK; at += 1 + calls / 300) {
            f.calls = 0;
            f.fails_at = at;
            CHECK(try_source(&source, kind < 3, &fault) == PLT_ERR_SOURCE, "%u: call %u of %u",
                  kind, at, calls);
        }
        CHECK(!f.stream.beyond, "read beyond");
        pack_free(&image);
    }
}

/* The number of sections, their table, or what is in them. */
static uint32_t place(uint32_t further_at, uint32_t size, random_state *r) {
    switch (random_below(r, 6)) {
    case 0:
        return HOSTILE_AT_FURTHER;
    case 1:
        return random_below(r, HOSTILE_HEADER);
    case 2:
    case 3:
        return further_at + random_below(r, 64);
    default:
        return further_at + random_below(r, size - further_at);
    }
}

static unsigned mutate(const packed *image, uint8_t surface, uint32_t seed) {
    random_state r = {seed};
    const uint32_t further_at = hostile_further_at(image->bytes);
    unsigned opened = 0;
    for (int i = 0; i < MUTATIONS; i++) {
        plt_fault fault = {.message = NULL};
        unsigned char *bytes = hostile_copy(image->bytes, image->size);
        failing f = {.stream = {bytes, image->size, 0}};
        const plt_source mapped = {.mapped = bytes, .bytes = image->size},
                         fetched = {NULL, image->size, &f, start_failing, wait_failing};
        for (uint32_t times = 1 + random_below(&r, 3); times > 0; times--) {
            mutate_at(bytes, image->size, place(further_at, image->size, &r), &r);
        }
        hostile_seal_surface(bytes, image->size);
        const int status = try_source(i % 2 ? &mapped : &fetched, surface, &fault);
        CHECK(status == PLT_OK || fault.message != NULL || status == PLT_ERR_ARENA, "%d", status);
        CHECK(!f.stream.beyond, "read beyond");
        opened += status == PLT_OK;
        free(bytes);
    }
    return opened;
}

static void mutations(void) {
    test("whatever further sections hold, an image is refused with a reason, or rendered");
    for (unsigned kind = 0; kind < KINDS; kind++) {
        packed image = image_of(kind);
        const unsigned opened = mutate(&image, kind < 3, 1 + kind);
        CHECK((opened > MUTATIONS / 50 || rig_is_tiny()) && opened < MUTATIONS, "%u: %u", kind,
              opened);
        pack_free(&image);
    }
}

int main(void) {
    failures();
    mutations();
    return test_done();
}
