/* test_further_sections - images with all further sections at once, of sources that fail, and
 * forged
 *
 * Surfaces and lights are both asked for, in an arena of exactly its need: sanitizers see accesses
 * beyond it.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/image/further.h"
#include "host_tools/pack/further_add.h"
#include "host_tools/pack/material_section.h"
#include "tests/hostile/mutations.h"
#include "tests/hostile/surface.h"
#include "tests/reference/instances_rig.h"
#include "tests/reference/lit_rig.h"
#include "tests/reference/sequence_rig.h"
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

/* ---- one section --------------------------------------------------------------------------- */

static void loads(void) {
    test("a section is loaded from where it is mapped, or through a source that may fail");
    enum { AT = 128, BYTES = 192 };
    static unsigned char image[AT + BYTES] __attribute__((aligned(PLT_ALIGN)));
    unsigned char room[BYTES + 1];
    const unsigned char *bytes;
    plt_fault fault = {.message = ""};
    for (unsigned i = 0; i < sizeof image; i++) {
        image[i] = (unsigned char)(7 * i);
    }
    plt_section s = {PLT_SECTION_NORMALS, AT, BYTES, plt_crc32(0, image + AT, BYTES)};
    failing f = {.stream = {image, sizeof image, 0}};
    const plt_source mapped = {.mapped = image, .bytes = sizeof image},
                     fetched = {NULL, sizeof image, &f, start_failing, wait_failing};
    CHECK(plt_further_load(&mapped, &s, NULL, &bytes, &fault) == PLT_OK && bytes == image + AT,
          "%s", fault.message);
    room[BYTES] = 99;
    CHECK(plt_further_load(&fetched, &s, room, &bytes, &fault) == PLT_OK && bytes == room &&
              memcmp(room, image + AT, BYTES) == 0 && room[BYTES] == 99,
          "%s", fault.message);
    const uint32_t calls = f.calls;
    CHECK(calls >= 2, "%u calls", calls);
    for (f.fails_at = 1; f.fails_at <= calls; f.fails_at++) {
        f.calls = 0;
        CHECK(plt_further_load(&fetched, &s, room, &bytes, &fault) == PLT_ERR_SOURCE, "call %u",
              f.fails_at);
    }
    s.crc ^= 1;
    f.fails_at = 0;
    for (int i = 0; i < 2; i++) {
        CHECK(plt_further_load(i ? &mapped : &fetched, &s, room, &bytes, &fault) == PLT_ERR_IMAGE &&
                  fault.kind == 'R' && fault.rule == 13 && fault.offset == AT,
              "%s", fault.message);
    }
}

/* The image with such a section of 64 bytes: is it refused where that has its entry? */
static void check_kind(packed image, uint32_t kind, int is_allowed) {
    static const unsigned char section[64] = {0};
    plt_fault fault = {.message = ""};
    plt_info info;
    fail f = {""};
    const int status = further_add(&image, kind, section, sizeof section, "test", &f);
    const plt_source source = {.mapped = image.bytes, .bytes = image.size};
    CHECK((status == 0) == is_allowed, "kind %u: %s", kind, f.text);
    const int read = plt_image_info(&source, &info, &fault);
    CHECK(is_allowed ? read == PLT_OK
                     : read == PLT_ERR_IMAGE && fault.kind == 'R' && fault.rule == 17 &&
                           fault.offset == hostile_further_at(image.bytes) + 16,
          "kind %u: rule %u at %u", kind, fault.rule, fault.offset);
    pack_free(&image);
}

static void forbidden(void) {
    static const uint32_t kinds[] = {PLT_SECTION_NORMALS, PLT_SECTION_COLOURS,
                                     PLT_SECTION_MATERIALS, PLT_SECTION_PAGES};
    test("images with frames have no normals and colours, and those with instances nothing at all");
    for (unsigned i = 0; i < 4; i++) {
        const rig_config scene = rig_config_of(2, 8, PLT_BUILD_HOST, PLT_SPLIT_SAH);
        const sequence_config moving = {.scene = scene, .frames = 2, .key_every = 1};
        const instances_config placed = {.scene = scene, .instances = 2, .apart = 3, .seed = 5};
        check_kind(sequence_rig_image(&moving, 20, 3), kinds[i], kinds[i] == PLT_SECTION_MATERIALS);
        check_kind(instances_rig_image(&placed), kinds[i], 0);
        lit_scene s;
        packed still = {.size = 0};
        lit_scene_make(&s);
        const rig_config none = rig_config_of(2, 8, PLT_BUILD_NONE, PLT_SPLIT_SAH);
        fail f = {""};
        CHECK(pack_mesh(&still, &s.m, &none.pack, "test", &f) == 0, "%s", f.text);
        check_kind(still, kinds[i], 1);
        lit_scene_free(&s);
    }
}

int main(void) {
    loads();
    forbidden();
    failures();
    mutations();
    return test_done();
}
