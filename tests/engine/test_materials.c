/* test_materials - what triangles are made of: the section of an image, and forged ones
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "engine/base/rules.h"
#include "engine/whitted/materials.h"
#include "host_tools/pack/further_add.h"
#include "host_tools/pack/material_section.h"
#include "tests/hostile/materials.h"
#include "tests/hostile/surface.h"
#include "tests/reference/lit_rig.h"
#include "tests/reference/random.h"
#include "tests/test.h"

enum { MUTATIONS = 3000 };

static packed image_of(const lit_scene *s) {
    packed image = {.bytes = NULL};
    CHECK(lit_pack(&image, s, LIT_LIST) == 0, "packed");
    return image;
}

static plt_materials read(const packed *image) {
    const plt_section at = hostile_materials_at(image->bytes, image->size);
    plt_materials m = {.table = NULL};
    plt_fault fault = {.message = ""};
    CHECK(at.bytes > 0 &&
              plt_materials_read(&m, image->bytes + at.offset, at.bytes,
                                 image->info.source_triangles, at.offset, &fault) == PLT_OK,
          "%s", fault.message);
    return m;
}

/* As many materials as that, in runs of so many triangles. */
static void set_runs(lit_scene *s, unsigned materials, unsigned run) {
    char name[32];
    while (s->materials.count < materials) {
        snprintf(name, sizeof name, "n%zu", s->materials.count);
        materials_find(&s->materials, name, strlen(name));
    }
    for (size_t i = 0; i < s->m.triangles; i++) {
        s->materials.of[i] = (uint16_t)(i / run % materials);
    }
}

static void finds(void) {
    static const struct {
        unsigned materials, run, bits;
    } kinds[] = {{1, 1, 0}, {2, 1, 1}, {3, 1, 2}, {5, 1, 4}, {17, 1, 8}, {5, 40, 0}, {256, 1, 8}};
    test("every triangle has the material it was packed with, in runs and by indices of any width");
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
        lit_scene s;
        lit_scene_make(&s);
        if (s.m.triangles > 300) {
            set_runs(&s, kinds[k].materials, kinds[k].run);
            packed image = image_of(&s);
            const plt_materials m = read(&image);
            CHECK(m.bits == kinds[k].bits && m.count == kinds[k].materials, "%zu: %u bits", k,
                  m.bits);
            for (uint32_t i = 0; i < s.m.triangles; i++) {
                plt_material got;
                plt_materials_get(&m, plt_materials_find(&m, i), &got);
                CHECK(memcmp(&got, &s.materials.material[s.materials.of[i]].values, sizeof got) ==
                          0,
                      "%zu: %u", k, i);
            }
            CHECK(plt_materials_find(&m, 0xFFFFFFFEu) < m.count, "one that is not there");
            CHECK(image.info.material_bytes == plt_materials_bytes(&m), "bytes");
            pack_free(&image);
        } else {
            CHECK(rig_is_tiny(), "a small scene");
        }
        lit_scene_free(&s);
    }
}

static void too_many(void) {
    lit_scene s;
    packed image = {.bytes = NULL};
    const pack_options options = {.build = PLT_BUILD_NONE, .leaf_triangles = 1, .treelet_nodes = 1};
    material_stats stats;
    fail f = {""};
    test("257 materials are refused, and the image stays as it was");
    lit_scene_make(&s);
    if (s.m.triangles < 300) {
        CHECK(rig_is_tiny(), "a small scene");
    } else {
        set_runs(&s, 257, 1);
        CHECK(pack_mesh(&image, &s.m, &options, "test", &f) == 0, "packed");
        const uint32_t size = image.size;
        CHECK(material_section_add(&image, &s.materials, NULL, "test", &stats, &f) != 0, "257");
        CHECK(image.size == size && image.info.material_bytes == 0, "as it was");
        CHECK(strstr(f.text, "256") != NULL, "%s", f.text);
        pack_free(&image);
    }
    lit_scene_free(&s);
}

static void without(void) {
    lit_scene s;
    packed with, image = {.bytes = NULL};
    const pack_options options = {
        .build = PLT_BUILD_NONE, .leaf_triangles = 2, .treelet_nodes = 8, .checks = 1};
    fail f = {""};
    plt_fault fault = {.message = ""};
    test("all but the header of an image is the same with materials and without");
    lit_scene_make(&s);
    with = image_of(&s);
    CHECK(pack_mesh(&image, &s.m, &options, "test", &f) == 0, "packed");
    CHECK(memcmp(with.bytes + PLT_HEADER_BYTES, image.bytes + PLT_HEADER_BYTES,
                 image.size - PLT_HEADER_BYTES) == 0,
          "the same");
    CHECK(hostile_try_materials(image.bytes, image.size, &fault) == PLT_OK, "%s", fault.message);
    pack_free(&image);
    pack_free(&with);
    lit_scene_free(&s);
}

/* ---- forged ---------------------------------------------------------------------------- */

static void forge(const packed *image, uint32_t at, uint32_t value, const char *what) {
    const plt_section s = hostile_materials_at(image->bytes, image->size);
    plt_fault fault = {.message = ""};
    const uint32_t was = plt_get_u32(image->bytes + s.offset + at);
    plt_put_u32(image->bytes + s.offset + at, value);
    hostile_seal_materials(image->bytes, image->size);
    const int status = hostile_try_materials(image->bytes, image->size, &fault);
    CHECK(status == PLT_ERR_IMAGE && fault.kind == 'R' && fault.rule == PLT_R19_MATERIALS,
          "%s %x at %u: %d, %c%u %s", what, value, at, status, fault.kind, fault.rule,
          fault.message);
    plt_put_u32(image->bytes + s.offset + at, was);
    hostile_seal_materials(image->bytes, image->size);
}

static void forged(void) {
    static const float most[15] = {1,       1,       1,       1,       1, 1, 0x1p20f, 0x1p20f,
                                   0x1p20f, 0x1p20f, 0x1p20f, 0x1p20f, 4, 1, 1};
    lit_scene s;
    lit_scene_make(&s);
    packed image = image_of(&s);
    const plt_materials m = read(&image);
    test("a count, a bit or a reserved byte that is wrong is refused (R19)");
    for (uint32_t at = 0; at < PLT_MATERIALS_HEAD; at += 4) {
        forge(&image, at, at == 4 ? 3 : 0xFFFFFFFFu, "head");
        forge(&image, at, at == 0 || at == 8 || at == 12 ? 0 : 1u << 24, "head");
    }
    forge(&image, 0, m.count + 1, "count");
    forge(&image, 12, m.triangles - 1, "triangles");
    test("a number of a material that is out of range, or none, is refused");
    for (uint32_t i = 0; i < m.count; i++) {
        const uint32_t at = PLT_MATERIALS_HEAD + i * PLT_MATERIAL_BYTES;
        for (uint32_t k = 0; k < 15; k++) {
            const float wrong[4] = {NAN, nextafterf(most[k], 1e30f), -1e-30f, INFINITY};
            for (int w = 0; w < 4; w++) {
                forge(&image, at + 4 * k, plt_bits_of(wrong[w]), "number");
            }
        }
        forge(&image, at + 60, 0, "exponent");
        forge(&image, at + 60, PLT_EXPONENT_MOST + 1, "exponent");
    }
    test(
        "runs that do not rise, or do not begin with 0, are refused, and materials beyond the "
        "last");
    const uint32_t at = PLT_MATERIALS_HEAD + m.count * PLT_MATERIAL_BYTES;
    CHECK(m.bits == 0 && m.runs > 2, "there are runs");
    forge(&image, at, 1, "first run");
    forge(&image, at + 4, 0, "second run");
    forge(&image, at + 8, plt_get_u32(m.index + 4), "third run");
    forge(&image, at + 4 * (m.runs - 1), m.triangles, "last run");
    forge(&image, at + 4 * m.runs, m.count, "material");
    test("what fills the section up is 0, or it is refused");
    const uint32_t bytes = hostile_materials_at(image.bytes, image.size).bytes;
    CHECK(at + 5 * m.runs + 4 <= bytes, "there is no padding");
    forge(&image, bytes - 4, 1, "padding");
    forge(&image, bytes - 4, 1u << 31, "padding");
    forge(&image, at + 5 * m.runs, 1, "padding");
    test("a section that is damaged is refused by its checksum (R13)");
    plt_fault fault = {.message = ""};
    image.bytes[hostile_materials_at(image.bytes, image.size).offset + 70] ^= 1;
    CHECK(hostile_try_materials(image.bytes, image.size, &fault) == PLT_ERR_IMAGE &&
              fault.rule == PLT_R13_SECTION_CRC,
          "%s", fault.message);
    pack_free(&image);
    lit_scene_free(&s);
}

static void packed_indices(void) {
    lit_scene s;
    lit_scene_make(&s);
    set_runs(&s, 3, 1);
    packed image = image_of(&s);
    const plt_materials m = read(&image);
    test("an index of a triangle beyond the last material is refused");
    if (m.bits > 0) {
        const uint32_t at = PLT_MATERIALS_HEAD + m.count * PLT_MATERIAL_BYTES;
        forge(&image, at, plt_get_u32(m.index) | 0x3, "first index");
        forge(&image, at, plt_get_u32(m.index) | 0xC0000000u, "16th index");
    } else {
        CHECK(rig_is_tiny(), "a small scene");
    }
    pack_free(&image);
    lit_scene_free(&s);
}

static void mutated(void) {
    lit_scene s;
    random_state r = {3};
    unsigned opened = 0;
    test("whatever an image with materials is made of, it is refused or rendered");
    lit_scene_make(&s);
    packed image = image_of(&s);
    const plt_section at = hostile_materials_at(image.bytes, image.size);
    for (int i = 0; i < MUTATIONS; i++) {
        plt_fault fault = {.message = NULL};
        unsigned char *copy = aligned_alloc(PLT_ALIGN, (image.size + 63) / 64 * 64);
        memcpy(copy, image.bytes, image.size);
        for (uint32_t k = 1 + random_below(&r, 3); k > 0; k--) {
            const uint32_t from = i % 4 == 0 ? 0 : at.offset - 64;
            copy[from + random_below(&r, image.size - from)] ^=
                (unsigned char)(1u << random_below(&r, 8));
        }
        if (i % 8 != 0) {
            hostile_seal_materials(copy, image.size);
        }
        const int status = hostile_try_materials(copy, image.size, &fault);
        CHECK(status == PLT_OK || fault.message != NULL, "%d", status);
        opened += status == PLT_OK;
        free(copy);
    }
    CHECK(opened > MUTATIONS / 100, "%u were opened", opened);
    pack_free(&image);
    lit_scene_free(&s);
}

/* ---- a source that changes ------------------------------------------------------------- */

/* Delivers `image`, which is exchanged for another while the engine builds. */
static int start_some(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    const packed *image = *(const packed **)context;
    (void)tag;
    memcpy(to, image->bytes + offset, count);
    return 0;
}

static int wait_none(void *context, uint32_t tags) {
    (void)context;
    (void)tags;
    return 0;
}

/* Compact blocks that are built by the engine, of so many materials, with as many bytes of normals,
 * which nobody asks for, before them. */
static packed image_to_build(lit_scene *s, unsigned materials, uint32_t normals) {
    const compact_options options = {
        .build = PLT_BUILD_DEVICE, .lattice_bits = 14, .numbers = 1, .leaf_triangles = 2};
    packed image = {.bytes = NULL};
    lattice_loss loss;
    material_stats stats;
    fail f = {""};
    unsigned char *zeros = calloc(normals + 1, 1);
    set_runs(s, materials, 1);
    CHECK(pack_compact(&image, &s->m, &options, "test", &loss, &f) == 0, "%s", f.text);
    CHECK(normals == 0 || further_add(&image, PLT_SECTION_NORMALS, zeros, normals, "test", &f) == 0,
          "%s", f.text);
    CHECK(material_section_add(&image, &s->materials, NULL, "test", &stats, &f) == 0, "%s", f.text);
    free(zeros);
    return image;
}

/* The status of opening `first`, which is `second` once the building has begun, in an arena of its
 * need alone. */
static int open_changing(const packed *first, const packed *second, plt_fault *fault) {
    const plt_options options = {.packet_side = 2, .whitted = 4};
    const packed *now = first;
    const plt_source source = {
        .bytes = second->size, .context = &now, .start = start_some, .wait = wait_none};
    const size_t need = plt_arena_need(&first->info, 0, &options);
    plt_engine *engine;
    void *arena = aligned_alloc(PLT_ALIGN, need);
    int status = plt_open_begin(&engine, arena, need, &source, &options, fault);
    now = second;
    while (status == PLT_MORE) {
        status = plt_open_step(engine, 100, fault);
    }
    free(arena);
    return status;
}

static void changes(void) {
    lit_scene s;
    plt_fault fault = {.message = ""};
    lit_scene_make(&s);
    packed many = image_to_build(&s, 200, 64), few = image_to_build(&s, 5, 64);
    const uint32_t more = many.info.material_bytes - few.info.material_bytes;
    pack_free(&few);
    few = image_to_build(&s, 5, 64 + more);
    test("materials that grow while a tree is built are refused, not written behind their room");
    CHECK(few.size == many.size && (more > 0 || rig_is_tiny()), "%u bytes more", more);
    const int same = open_changing(&few, &few, &fault);
    CHECK(same == PLT_OK || (rig_is_tiny() && same == PLT_ERR_LIMIT), "%d: %s", same,
          fault.message);
    const int status = open_changing(&few, &many, &fault);
    CHECK(status == PLT_ERR_SOURCE || (rig_is_tiny() && status <= PLT_OK), "%d: %s", status,
          fault.message);
    pack_free(&few);
    pack_free(&many);
    lit_scene_free(&s);
}

/* The header alone says that no section of its table is beyond the image. */
static void ends_before(void) {
    lit_scene s;
    plt_header h;
    plt_fault fault = {.message = ""};
    lit_scene_make(&s);
    packed image = image_of(&s);
    const uint32_t table = hostile_further_at(image.bytes);
    test("a header whose image ends before the table of further sections is refused (R17)");
    for (uint32_t less = 0; less < 2; less++) {
        const uint32_t size = table - 64 * less;
        plt_put_u32(image.bytes + PLT_AT_IMAGE_BYTES, size);
        plt_header_seal(image.bytes);
        const int status = plt_header_read(&h, image.bytes, size, &fault);
        CHECK(less == 0 ? status == PLT_OK
                        : status == PLT_ERR_IMAGE && fault.rule == PLT_R17_FURTHER &&
                              fault.offset == PLT_AT_IMAGE_BYTES,
              "%u: %d, %c%u", less, status, fault.kind, fault.rule);
    }
    pack_free(&image);
    lit_scene_free(&s);
}

int main(void) {
    finds();
    too_many();
    without();
    forged();
    packed_indices();
    mutated();
    changes();
    ends_before();
    return test_done();
}
