/* test_pages - normals, colours and texture coordinates page by page, of scenes that are resident
 * and that are streamed
 *
 * Frames, which have textures, are compared with those of the same scene with tables. Every
 * transfer fails once, and every page is damaged once.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>

#include "engine/surface/surface_pages.h"
#include "engine/texture/directory.h"
#include "host_tools/pack/material_section.h"
#include "host_tools/pack/surface_pages.h"
#include "host_tools/pack/texture_section.h"
#include "tests/hostile/mutations.h"
#include "tests/hostile/surface.h"
#include "tests/reference/frames.h"
#include "tests/reference/lit_rig.h"
#include "tests/reference/surface_rig.h"

enum { RESIDENT = 0, SHIFT = 6, KINDS = 2, MUTATIONS = 300, WIDTH = 45, HEIGHT = 35 };

/* A source that fails at one transfer. */
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
    return hostile_wait(&f->stream, tags);
}

/* A tiny build refuses such trees of thesis nodes. */
static unsigned first_kind(void) {
    return rig_is_tiny() ? 1 : 0;
}

/* ---- images ------------------------------------------------------------------------------ */

static void make_mesh(lit_scene *s, mesh_corners *c) {
    lit_scene_make(s);
    shape_icosphere(&s->m, rig_is_tiny() ? 0 : 4);
    lit_scene_is(s, LIT_PAINT);
    CHECK(mesh_smooth(&s->m, 40, c) == 0, "no memory");
    surface_rig_colour(&s->m, c, 4);
    surface_rig_unwrap(&s->m, c, 3.0f);
}

/* Two pictures for all materials. */
static void add_textures(packed *image) {
    static const texture_paint paint[LIT_MATERIALS] = {{1, 0, {1, 1}, {0, 0}},
                                                       {2, 0, {1, 1}, {0, 0}},
                                                       {2, 1, {0.5f, 1}, {0, 0.25f}},
                                                       {1, 0, {2, 3}, {0, 0}},
                                                       {0, 0, {1, 1}, {0, 0}}};
    picture p[2];
    texture_stats stats;
    fail f = {""};
    for (unsigned i = 0; i < 2; i++) {
        CHECK(picture_make(&p[i], 40, 24 + 9 * i, &f) == 0, "%s", f.text);
        for (unsigned k = 0; k < 3 * 40 * (24 + 9 * i); k++) {
            p[i].rgb[k] = (uint8_t)(k * (7 + i) % 211 + 40);
        }
    }
    const texture_set set = {p, 2, paint, LIT_MATERIALS, PLT_TEXTURE_RGB565};
    CHECK(texture_section_add(image, &set, "test", &stats, &f) == 0, "%s", f.text);
    picture_free(&p[0]);
    picture_free(&p[1]);
}

/* u and v are. */
enum { EXCHANGED = 8 };

/* Bits of surface_pages.h. What is left out is still owned by `c`. */
static mesh_corners some_of(const mesh_corners *c, unsigned what) {
    mesh_corners some = *c;
    some.normal = what & PLT_PAGES_NORMALS ? c->normal : NULL;
    some.colour = what & PLT_PAGES_COLOURS ? c->colour : NULL;
    some.texcoord[0] = what & PLT_PAGES_TEXCOORDS ? c->texcoord[what & EXCHANGED ? 1 : 0] : NULL;
    some.texcoord[1] = c->texcoord[what & EXCHANGED ? 0 : 1];
    return some;
}

/* Thesis nodes, or compact blocks of a lattice. */
static void pack_tree(packed *image, const lit_scene *s, unsigned kind) {
    fail f = {""};
    if (kind == 0) {
        const rig_config config = rig_config_of(4, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
        CHECK(pack_mesh(image, &s->m, &config.pack, "test", &f) == 0, "%s", f.text);
        return;
    }
    const compact_options options = {
        .lattice_bits = 14, .numbers = 1, .leaf_triangles = 4, .meshes = 1, .checks = 1};
    lattice_loss loss;
    CHECK(pack_compact(image, &s->m, &options, "test", &loss, &f) == 0, "%s", f.text);
}

/* What corners have in pages of 2^shift triangles (0: there are none), and in tables. */
static packed image_with(unsigned kind, uint32_t shift, unsigned paged, unsigned in_tables) {
    lit_scene s;
    mesh_corners c = {0}, of_pages, of_tables;
    surface_stats stats;
    material_stats more;
    fail f = {""};
    packed image = {.size = 0};
    make_mesh(&s, &c);
    pack_tree(&image, &s, kind);
    of_pages = some_of(&c, paged);
    of_tables = some_of(&c, in_tables);
    CHECK(shift == 0 || surface_pages_add(&image, &of_pages, shift, "test", &stats, &f) == 0, "%s",
          f.text);
    CHECK(in_tables == 0 || surface_add(&image, &of_tables, "test", &stats, &f) == 0, "%s", f.text);
    CHECK(material_section_add(&image, &s.materials, NULL, "test", &more, &f) == 0, "%s", f.text);
    add_textures(&image);
    corners_free(&c);
    lit_scene_free(&s);
    return image;
}

/* shift 0: tables. */
static packed image_of(unsigned kind, uint32_t shift) {
    return image_with(kind, shift, PLT_PAGES_ALL, shift > 0 ? 0 : PLT_PAGES_ALL);
}

/* ---- frames ------------------------------------------------------------------------------ */

static plt_frame frame_by(uint8_t shader) {
    const plt_frame frame = {.camera = {.eye = {1, 4, 9}, .up = {0, 1, 0}, .tan_half_fov = 0.6f},
                             .width = WIDTH,
                             .height = HEIGHT,
                             .shader = shader};
    return frame;
}

typedef struct opened {
    plt_engine *engine;
    void *arena;
    plt_fault fault;
    int status;
} opened;

static opened open_by(const packed *image, const plt_source *source, const plt_options *options) {
    opened o = {.engine = NULL};
    const size_t need = plt_arena_need(&image->info, source->mapped != NULL, options);
    o.arena = aligned_alloc(PLT_ALIGN, (need + PLT_ALIGN) / PLT_ALIGN * PLT_ALIGN);
    o.status = plt_open(&o.engine, o.arena, need, source, options, &o.fault);
    return o;
}

static int begin(const opened *o, const plt_frame *frame) {
    const plt_lighting l = lit_lights(3);
    int status = frame->shader == PLT_SHADE_WHITTED ? plt_lighting_set(o->engine, &l) : PLT_OK;
    return status == PLT_OK ? plt_render_begin(o->engine, frame) : status;
}

static int render(const opened *o, const plt_frame *frame) {
    int status = begin(o, frame);
    while (status >= PLT_OK) {
        status = plt_render_step(o->engine, 100);
        if (status == PLT_OK) {
            break;
        }
    }
    return status;
}

static uint64_t hash_of(const opened *o, uint8_t shader) {
    const plt_frame frame = frame_by(shader);
    CHECK(begin(o, &frame) == PLT_OK, "a frame is refused");
    return frame_hash(o->engine, &frame, 1000);
}

static plt_options options_of(uint8_t residency, uint8_t side, uint32_t store) {
    const plt_options o = {.packet_side = side,
                           .residency = residency,
                           .store_bytes = store,
                           .surface = 1,
                           .whitted = 4,
                           .textures = PLT_TEXTURES_BILINEAR,
                           .count_touched = 1};
    return o;
}

static const uint8_t shaders[2] = {PLT_SHADE_SMOOTH, PLT_SHADE_WHITTED};

static void check_statistics(const opened *o, uint32_t store, int fetched) {
    plt_stats q;
    plt_stats_get(o->engine, &q);
    CHECK(q.bytes_touched_once <= q.bytes_fetched && q.fetch_retries == 0, "statistics");
    CHECK(!fetched || store < 1u << 20 || q.bytes_fetched == q.bytes_touched_once,
          "%" PRIu64 " bytes, %" PRIu64 " of them once", q.bytes_fetched, q.bytes_touched_once);
}

/* Both shaders, by that image and those options; due: their hashes. */
static void compare(const packed *image, const plt_options *options, int fetched,
                    const uint64_t due[2]) {
    hostile_stream stream = {image->bytes, image->size, 0};
    const plt_source mapped = rig_source(image),
                     through = {NULL, image->size, &stream, hostile_start, hostile_wait};
    const opened o = open_by(image, fetched ? &through : &mapped, options);
    CHECK(o.status == PLT_OK, "%s", o.fault.message);
    for (int i = 0; i < 2 && o.status == PLT_OK; i++) {
        const uint64_t hash = hash_of(&o, shaders[i]);
        CHECK(hash == due[i], "shader %u, side %u, residency %u, store %u, fetched %d: %016" PRIx64,
              shaders[i], options->packet_side, options->residency, options->store_bytes, fetched,
              hash);
    }
    if (o.status == PLT_OK && options->residency == PLT_RESIDENCY_STREAMED) {
        check_statistics(&o, options->store_bytes, 1);
    }
    CHECK(!stream.beyond, "read beyond");
    free(o.arena);
}

static void hashes(const packed *image, uint64_t due[2]) {
    const plt_options options = options_of(RESIDENT, 2, 0);
    const plt_source source = rig_source(image);
    const opened o = open_by(image, &source, &options);
    CHECK(o.status == PLT_OK, "%s", o.fault.message);
    for (int i = 0; i < 2 && o.status == PLT_OK; i++) {
        due[i] = hash_of(&o, shaders[i]);
    }
    free(o.arena);
}

static void same_frames(void) {
    static const uint32_t shifts[3] = {SHIFT, 9, SURFACE_PAGES_USUAL};
    for (unsigned kind = first_kind(); kind < KINDS; kind++) {
        uint64_t due[2] = {0, 0};
        packed tables = image_of(kind, 0);
        hashes(&tables, due);
        for (unsigned i = 0; i < 3; i++) {
            packed image = image_of(kind, shifts[i]);
            for (unsigned way = 0; way < 2 * 4; way++) {
                const uint32_t stores[4] = {0, PLT_STORE_LEAST, 60000, 4u << 20};
                for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
                    const plt_options o = options_of(
                        way / 2 > 0 ? PLT_RESIDENCY_STREAMED : RESIDENT, side, stores[way / 2]);
                    compare(&image, &o, (int)(way % 2), due);
                }
            }
            pack_free(&image);
        }
        pack_free(&tables);
    }
}

/* Read whole, those of the table; streamed, those of pages, or none. */
static void either_way(void) {
    static const struct {
        unsigned paged, in_tables;
        int streams; /* coordinates */
    } images[] = {{PLT_PAGES_ALL, PLT_PAGES_TEXCOORDS | EXCHANGED, 1},
                  {PLT_PAGES_NORMALS | PLT_PAGES_COLOURS, PLT_PAGES_TEXCOORDS | EXCHANGED, 0},
                  {PLT_PAGES_ALL, PLT_PAGES_ALL | EXCHANGED, 1}};
    for (unsigned kind = first_kind(); kind < KINDS; kind++) {
        uint64_t due[2] = {0, 0}, whole[2] = {0, 0}, bare[2] = {0, 0};
        packed exchanged = image_with(kind, 0, 0, PLT_PAGES_ALL | EXCHANGED);
        packed tables = image_of(kind, 0);
        packed plain = image_with(kind, 0, 0, PLT_PAGES_NORMALS | PLT_PAGES_COLOURS);
        hashes(&tables, due);
        hashes(&plain, bare);
        hashes(&exchanged, whole);
        CHECK(due[0] != bare[0] && due[1] != bare[1], "textures are not seen");
        CHECK(due[0] != whole[0] && due[1] != whole[1], "u is v");
        for (unsigned i = 0; i < sizeof images / sizeof images[0]; i++) {
            packed image = image_with(kind, SHIFT, images[i].paged, images[i].in_tables);
            for (unsigned way = 0; way < 4; way++) {
                const plt_options o = options_of((uint8_t)(way / 2), 2, 0);
                compare(&image, &o, (int)(way % 2),
                        way < 2             ? whole
                        : images[i].streams ? due
                                            : bare);
            }
            pack_free(&image);
        }
        pack_free(&tables);
        pack_free(&plain);
        pack_free(&exchanged);
    }
}

/* Coordinates alone, of packets and beams. */
static void alone(void) {
    uint64_t due[2] = {0, 0};
    const unsigned kind = first_kind();
    packed tables = image_with(kind, 0, 0, PLT_PAGES_TEXCOORDS);
    packed image = image_with(kind, SHIFT, PLT_PAGES_TEXCOORDS, 0);
    hashes(&tables, due);
    for (unsigned way = 0; way < 4; way++) {
        const plt_options o = options_of((uint8_t)(way / 2), PLT_PACKET_SIDE_MAX, 0);
        compare(&image, &o, (int)(way % 2), due);
    }
    pack_free(&tables);
    pack_free(&image);
}

/* Hits of a resident scene, found by their number. */
static void same_points(void) {
    for (unsigned kind = first_kind(); kind < KINDS; kind++) {
        packed image[2] = {image_of(kind, 0), image_of(kind, SHIFT)};
        const plt_options options = options_of(RESIDENT, 2, 0);
        const plt_source source[2] = {rig_source(&image[0]), rig_source(&image[1])};
        const opened o[2] = {open_by(&image[0], &source[0], &options),
                             open_by(&image[1], &source[1], &options)};
        CHECK(o[0].status == PLT_OK && o[1].status == PLT_OK, "%s", o[1].fault.message);
        for (uint32_t i = 0; i < image[0].info.triangles; i++) {
            plt_surface_point p[2];
            const plt_hit hit = {1.0f, 0.2f, 0.3f, i};
            memset(p, 0, sizeof p);
            CHECK(plt_surface_at(o[0].engine, &hit, &p[0]) == PLT_OK &&
                      plt_surface_at(o[1].engine, &hit, &p[1]) == PLT_OK,
                  "triangle %u", i);
            CHECK(memcmp(&p[0], &p[1], sizeof p[0]) == 0, "triangle %u differs", i);
        }
        for (int i = 0; i < 2; i++) {
            free(o[i].arena);
            pack_free(&image[i]);
        }
    }
}

/* The section of pages of an image, and where its pages begin. */
typedef struct pages_at {
    uint32_t at, bytes, chunks, first, end;
} pages_at;

static pages_at find_pages(const unsigned char *bytes) {
    const unsigned char *entry = bytes + hostile_further_at(bytes) + 16;
    while (plt_get_u32(entry) != PLT_SECTION_PAGES) {
        entry += 16;
    }
    pages_at p = {.at = plt_get_u32(entry + 4), .bytes = plt_get_u32(entry + 8)};
    p.chunks = p.at + PLT_PAGES_HEAD + 4 * plt_get_u32(bytes + p.at + 8);
    p.first = p.at + plt_get_u32(bytes + p.chunks + 4);
    p.end = p.at + p.bytes;
    return p;
}

/* A bit of every third page. */
static void flip_pages(unsigned char *bytes) {
    const pages_at p = find_pages(bytes);
    for (uint32_t i = 0; i < PLT_PAGES_IN_CHUNK; i += 3) {
        const uint32_t at = plt_get_u32(bytes + p.chunks + 4 + 4 * i);
        if (plt_get_u32(bytes + p.chunks + 8 + 4 * i) > at) {
            bytes[p.at + at + 8] ^= 1;
        }
    }
}

/* Samples of frames that are streamed; `wrong`: pages are damaged at first, which ends the frame
 * while it is shaded, or mixed. */
static void mixed(const packed *image, const plt_frame *frame, int wrong, uint64_t due) {
    unsigned char *bytes = hostile_copy(image->bytes, image->size);
    hostile_stream stream = {bytes, image->size, 0};
    const plt_source source = {NULL, image->size, &stream, hostile_start, hostile_wait};
    const plt_options options = options_of(PLT_RESIDENCY_STREAMED, 4, PLT_STORE_LEAST);
    const opened o = open_by(image, &source, &options);
    CHECK(o.status == PLT_OK, "%s", o.fault.message);
    if (wrong) {
        flip_pages(bytes);
        const int status = render(&o, frame);
        CHECK(status == PLT_ERR_IMAGE, "samples %u: %d", frame->samples, status);
        flip_pages(bytes);
    }
    CHECK(begin(&o, frame) == PLT_OK, "a frame is refused");
    CHECK(frame_hash(o.engine, frame, 1000) == due, "shader %u, samples %u, wrong %d",
          frame->shader, frame->samples, wrong);
    free(o.arena);
    free(bytes);
}

static void samples(void) {
    static const uint8_t all[3] = {PLT_SAMPLES_FOUR, PLT_SAMPLES_SIXTEEN, PLT_SAMPLES_ADAPTIVE};
    for (unsigned kind = 0; kind < KINDS && PLT_PACKET_SIDE_MAX >= 4; kind++) {
        packed image = image_of(kind, SHIFT);
        const plt_options options = options_of(RESIDENT, 4, 0);
        const plt_source source = rig_source(&image);
        const opened o = open_by(&image, &source, &options);
        CHECK(o.status == PLT_OK, "%s", o.fault.message);
        for (int i = 0; i < 6; i++) {
            plt_frame frame = frame_by(shaders[i % 2]);
            frame.samples = all[i / 2];
            CHECK(begin(&o, &frame) == PLT_OK, "a frame is refused");
            const uint64_t due = frame_hash(o.engine, &frame, 1000);
            mixed(&image, &frame, 0, due);
            mixed(&image, &frame, 1, due);
        }
        free(o.arena);
        pack_free(&image);
    }
}

/* Whole frames by beams keep numbers where those of lights keep triangles. */
static void after_beams(void) {
    lit_scene s;
    mesh_corners c = {0};
    surface_stats stats;
    fail f = {""};
    packed image = {.size = 0};
    const uint8_t side = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8;
    memset(&s, 0, sizeof s);
    shape_icosphere(&s.m, rig_is_tiny() ? 0 : 1);
    CHECK(mesh_smooth(&s.m, 40, &c) == 0, "no memory");
    surface_rig_colour(&s.m, &c, 4);
    pack_tree(&image, &s, 1);
    CHECK(surface_pages_add(&image, &c, SHIFT, "test", &stats, &f) == 0, "%s", f.text);
    hostile_stream stream = {image.bytes, image.size, 0};
    const plt_source source = {NULL, image.size, &stream, hostile_start, hostile_wait};
    const plt_options options = options_of(PLT_RESIDENCY_STREAMED, side, 0);
    const opened o = open_by(&image, &source, &options);
    CHECK(o.status == PLT_OK, "%s", o.fault.message);
    plt_frame lit = frame_by(PLT_SHADE_WHITTED), plain = frame_by(PLT_SHADE_EYELIGHT);
    lit.camera.tan_half_fov = plain.camera.tan_half_fov = 0.3f;
    CHECK(begin(&o, &lit) == PLT_OK, "a frame is refused");
    const uint64_t due = frame_hash(o.engine, &lit, 1000);
    for (int i = 0; i < 16; i++) {
        plain.camera.eye[0] = (float)(i - 8);
        CHECK(render(&o, &plain) == PLT_OK && begin(&o, &lit) == PLT_OK, "a frame is refused");
        CHECK(frame_hash(o.engine, &lit, 1000) == due, "frame %d is another", i);
    }
    free(o.arena);
    corners_free(&c);
    mesh_free(&s.m);
    pack_free(&image);
}

/* ---- what fails -------------------------------------------------------------------------- */

static void failures(void) {
    const plt_options options = options_of(PLT_RESIDENCY_STREAMED, 2, PLT_STORE_LEAST);
    for (unsigned kind = first_kind(); kind < KINDS; kind++) {
        packed image = image_of(kind, SHIFT);
        failing f = {.stream = {image.bytes, image.size, 0}};
        const plt_source source = {NULL, image.size, &f, start_failing, wait_failing};
        opened o = open_by(&image, &source, &options);
        CHECK(o.status == PLT_OK, "%s", o.fault.message);
        const plt_frame frame = frame_by(PLT_SHADE_SMOOTH);
        CHECK(render(&o, &frame) == PLT_OK, "it is not rendered");
        const uint32_t calls = f.calls;
        free(o.arena);
        for (uint32_t at = 1; at <= calls; at += 1 + calls / 150) {
            f.calls = 0;
            f.fails_at = at;
            o = open_by(&image, &source, &options);
            const int status = o.status == PLT_OK ? render(&o, &frame) : PLT_OK;
            CHECK(o.status == PLT_OK || o.status == PLT_ERR_SOURCE, "%d", o.status);
            CHECK(status == PLT_OK, "call %u of %u: %d, though it is asked again", at, calls,
                  status);
            free(o.arena);
        }
        CHECK(!f.stream.beyond, "read beyond");
        pack_free(&image);
    }
}

/* Renders an image that is wrong, streamed: 1 if it is refused with that place and rule 31. */
static int is_refused(const unsigned char *bytes, const packed *image, uint32_t place) {
    const plt_options options = options_of(PLT_RESIDENCY_STREAMED, 2, PLT_STORE_LEAST);
    hostile_stream stream = {bytes, image->size, 0};
    const plt_source source = {NULL, image->size, &stream, hostile_start, hostile_wait};
    const plt_frame frame = frame_by(PLT_SHADE_SMOOTH);
    opened o = open_by(image, &source, &options);
    CHECK(o.status == PLT_OK, "%s", o.fault.message);
    const int status = render(&o, &frame);
    plt_fault_get(o.engine, &o.fault);
    if (status != PLT_OK) {
        CHECK(status == PLT_ERR_IMAGE && o.fault.kind == 'I' && o.fault.rule == 31 &&
                  o.fault.offset == place,
              "status %d, rule %u at %u, not at %u", status, o.fault.rule, o.fault.offset, place);
        const plt_frame plain = frame_by(PLT_SHADE_EYELIGHT);
        CHECK(render(&o, &plain) == PLT_OK, "without pages it is not rendered any more");
    }
    free(o.arena);
    return status != PLT_OK;
}

static void damage(void) {
    for (unsigned kind = first_kind(); kind < KINDS; kind++) {
        packed image = image_of(kind, SHIFT);
        const pages_at p = find_pages(image.bytes);
        unsigned char *bytes = hostile_copy(image.bytes, image.size);
        unsigned refused = 0, pages = 0;
        random_state r = {kind + 3};
        for (uint32_t chunk = p.chunks; chunk < p.first; chunk += PLT_PAGES_CHUNK) {
            for (uint32_t i = 0; i < PLT_PAGES_IN_CHUNK; i++) {
                const uint32_t at = p.at + plt_get_u32(bytes + chunk + 4 + 4 * i);
                const uint32_t end = p.at + plt_get_u32(bytes + chunk + 8 + 4 * i);
                if (end > at) {
                    unsigned char *wrong = bytes + at + random_below(&r, end - at);
                    *wrong ^= (unsigned char)(1u << random_below(&r, 8));
                    refused += (unsigned)is_refused(bytes, &image, at);
                    memcpy(bytes + at, image.bytes + at, end - at);
                    pages++;
                }
            }
            bytes[chunk + random_below(&r, PLT_PAGES_CHUNK)] ^= 4;
            refused += (unsigned)is_refused(bytes, &image, chunk);
            memcpy(bytes + chunk, image.bytes + chunk, PLT_PAGES_CHUNK);
        }
        CHECK(pages == (image.info.triangles + 63) / 64, "%u pages", pages);
        CHECK(refused > pages / 6, "%u of %u pages refused", refused, pages);
        CHECK(!is_refused(bytes, &image, 0), "the test left damage");
        free(bytes);
        pack_free(&image);
    }
}

/* Pages in the places of others as long as they, though both are whole. */
static void exchanged(void) {
    packed image = image_of(first_kind(), SHIFT);
    const pages_at p = find_pages(image.bytes);
    unsigned char *bytes = hostile_copy(image.bytes, image.size);
    const unsigned char *offset = image.bytes + p.chunks + 4;
    unsigned refused = 0, pairs = 0;
    for (uint32_t i = 0; i < PLT_PAGES_IN_CHUNK; i++) {
        const uint32_t at = p.at + plt_get_u32(offset + 4 * i);
        const uint32_t count = p.at + plt_get_u32(offset + 4 * i + 4) - at;
        for (uint32_t k = 0; k < PLT_PAGES_IN_CHUNK && count > 0; k++) {
            const uint32_t other = p.at + plt_get_u32(offset + 4 * k);
            if (k != i && p.at + plt_get_u32(offset + 4 * k + 4) - other == count) {
                memcpy(bytes + at, image.bytes + other, count);
                refused += (unsigned)is_refused(bytes, &image, at);
                memcpy(bytes + at, image.bytes + at, count);
                pairs++;
                break;
            }
        }
    }
    CHECK(rig_is_tiny() || (pairs > 4 && refused > pairs / 12), "%u of %u", refused, pairs);
    free(bytes);
    pack_free(&image);
}

/* ---- refusals ---------------------------------------------------------------------------- */

static plt_fault refusal(const packed *image, const unsigned char *bytes, uint8_t residency) {
    const plt_options options = options_of(residency, 2, 0);
    hostile_stream stream = {bytes, image->size, 0};
    const plt_source source = {NULL, image->size, &stream, hostile_start, hostile_wait};
    opened o = open_by(image, &source, &options);
    CHECK(o.status == PLT_ERR_IMAGE, "%d: %s", o.status, o.fault.message);
    free(o.arena);
    return o.fault;
}

/* A place of what pages begin with, and the word there. */
typedef struct wrong_word {
    uint32_t at, is;
} wrong_word;

static void refuse_heads(packed *image, const wrong_word *wrong, unsigned count) {
    const pages_at p = find_pages(image->bytes);
    for (unsigned i = 0; i < count; i++) {
        for (uint8_t residency = 0; residency < 2; residency++) {
            unsigned char *bytes = hostile_copy(image->bytes, image->size);
            unsigned char *head = bytes + p.at;
            plt_put_u32(head + wrong[i].at, wrong[i].is);
            if (wrong[i].at != 12 && wrong[i].at != 64) {
                plt_put_u32(head + 12, plt_pages_head_check(head, p.chunks - p.at));
            }
            hostile_seal_surface(bytes, image->size);
            const plt_fault f = refusal(image, bytes, residency);
            CHECK(f.kind == 'R' && f.rule == 21 && f.offset == p.at, "%u: rule %u at %u", i, f.rule,
                  f.offset);
            free(bytes);
        }
    }
    pack_free(image);
}

static void heads(void) {
    static const wrong_word all[] = {{0, 0}, {0, 3},   {0, 4},  {0, 8},  {0, 15}, {4, 5}, {4, 13},
                                     {8, 0}, {8, 256}, {12, 7}, {40, 1}, {60, 1}, {64, 9}};
    static const wrong_word steps[] = {{16, 1},          {16, 17},         {20, 1},
                                       {20, 17},         {24, 0x7FC00000}, {28, 0xC9800001},
                                       {32, 0xBF800000}, {36, 0x49800000}};
    static const wrong_word without[] = {{0, 7}, {16, 1}, {24, 1}, {36, 1}, {60, 1}};
    packed image = image_of(1, SHIFT);
    refuse_heads(&image, all, sizeof all / sizeof all[0]);
    image = image_of(1, SHIFT);
    refuse_heads(&image, steps, sizeof steps / sizeof steps[0]);
    image = image_with(1, SHIFT, PLT_PAGES_NORMALS | PLT_PAGES_COLOURS, 0);
    refuse_heads(&image, without, sizeof without / sizeof without[0]);
}

/* Read whole: the CRC, and whoever made that right, too. */
static void resident_damage(void) {
    packed image = image_of(first_kind(), SHIFT);
    const pages_at p = find_pages(image.bytes);
    const uint32_t places[3] = {p.chunks, p.first, p.at + p.bytes - 1};
    for (unsigned i = 0; i < 3; i++) {
        unsigned char *bytes = hostile_copy(image.bytes, image.size);
        bytes[places[i]] ^= 1;
        plt_fault f = refusal(&image, bytes, RESIDENT);
        CHECK(f.kind == 'R' && f.rule == 13 && f.offset == p.at, "rule %u", f.rule);
        hostile_seal_surface(bytes, image.size);
        f = refusal(&image, bytes, RESIDENT);
        CHECK(f.kind == 'I' && f.rule == 31, "rule %u", f.rule);
        CHECK(i == 2 || f.offset == places[i], "at %u", f.offset);
        free(bytes);
    }
    pack_free(&image);
}

static void refused_options(void) {
    packed pages = image_of(first_kind(), SHIFT), tables = image_of(first_kind(), 0);
    plt_options batch = options_of(PLT_RESIDENCY_STREAMED, 2, 0), grid = batch, plain = batch;
    batch.whitted = grid.whitted = 0;
    batch.schedule = PLT_SCHEDULE_BATCH;
    grid.residency = RESIDENT;
    grid.structure = PLT_STRUCTURE_GRID;
    CHECK(plt_arena_need(&pages.info, 0, &batch) == 0, "many packets at a time");
    CHECK(plt_arena_need(&pages.info, 0, &grid) == 0, "grids over pages");
    CHECK(plt_arena_need(&tables.info, 0, &plain) == 0, "tables are not streamed");
    CHECK(rig_is_tiny() || plt_arena_need(&tables.info, 0, &grid) > 0, "grids over tables");
    const plt_source source[2] = {rig_source(&pages), rig_source(&tables)};
    const plt_options *const asked[3] = {&batch, &grid, &plain};
    for (int i = 0; i < 3; i++) {
        static unsigned char arena[4096] __attribute__((aligned(PLT_ALIGN)));
        plt_engine *e;
        plt_fault fault;
        CHECK(plt_open(&e, arena, sizeof arena, &source[i == 2], asked[i], &fault) ==
                  PLT_ERR_ARGUMENT,
              "%d: %s", i, fault.message);
    }
    pack_free(&pages);
    pack_free(&tables);
}

/* Where coordinates are in a table, or nowhere, textures take no room and are not read. */
static void room_of_textures(void) {
    packed image[2] = {image_of(first_kind(), SHIFT),
                       image_with(first_kind(), 0, 0, PLT_PAGES_TEXCOORDS)};
    for (int i = 0; i < 2; i++) {
        plt_options options = options_of(PLT_RESIDENCY_STREAMED, 2, 0);
        options.whitted = 0;
        options.textures = 0;
        const size_t without = plt_arena_need(&image[i].info, 0, &options);
        options.textures = PLT_TEXTURES_BILINEAR;
        const size_t with = plt_arena_need(&image[i].info, 0, &options);
        CHECK(without > 0 && (i == 0 ? with > without + 64 * PLT_TEXTURE_LEAST : with == without),
              "%zu bytes, without textures %zu", with, without);
        pack_free(&image[i]);
    }
}

/* Whatever is there: refused with a place, or rendered. */
static void mutations(void) {
    const plt_frame frame = frame_by(PLT_SHADE_SMOOTH);
    unsigned rendered = 0, refused = 0;
    for (unsigned kind = first_kind(); kind < KINDS; kind++) {
        packed image = image_of(kind, SHIFT);
        const pages_at p = find_pages(image.bytes);
        random_state r = {kind + 11};
        for (unsigned i = 0; i < MUTATIONS; i++) {
            unsigned char *bytes = hostile_copy(image.bytes, image.size);
            const uint32_t span = i % 3 == 0 ? p.first - p.at : p.bytes;
            mutate_at(bytes, image.size, p.at + random_below(&r, span), &r);
            unsigned char *head = bytes + p.at;
            if (i % 5 == 0) {
                hostile_seal_paged(bytes, image.size);
            }
            plt_put_u32(head + 12, plt_pages_head_check(head, p.chunks - p.at));
            for (uint32_t c = 0; c < (p.first - p.chunks) / PLT_PAGES_CHUNK; c++) {
                unsigned char *chunk = bytes + p.chunks + c * PLT_PAGES_CHUNK;
                plt_put_u32(chunk, plt_pages_check(c, chunk + 4, PLT_PAGES_CHUNK - 4));
            }
            hostile_seal_surface(bytes, image.size);
            const plt_options options = options_of((uint8_t)(i % 2), 2, 0);
            hostile_stream stream = {bytes, image.size, 0};
            const plt_source source = {NULL, image.size, &stream, hostile_start, hostile_wait};
            opened o = open_by(&image, &source, &options);
            const int status = o.status == PLT_OK ? render(&o, &frame) : o.status;
            if (o.status == PLT_OK && status != PLT_OK) {
                plt_fault_get(o.engine, &o.fault);
            }
            rendered += status == PLT_OK;
            refused += status == PLT_ERR_IMAGE && o.fault.rule > 0 && o.fault.offset < image.size;
            CHECK(!stream.beyond, "read beyond");
            free(o.arena);
            free(bytes);
        }
        pack_free(&image);
    }
    CHECK(rendered + refused == (KINDS - first_kind()) * MUTATIONS && refused > MUTATIONS / 3,
          "%u rendered, %u refused", rendered, refused);
}

int main(void) {
    test("frames by pages are those by tables: resident, copied, and streamed by any store");
    same_frames();
    test("... by lights, whatever beams have shown before");
    after_beams();
    if (!rig_is_tiny()) { /* which has packets of a pixel's rays */
        test("... with several samples, also behind a frame that a damaged page has ended");
        samples();
    }
    test("texture coordinates may be in pages, in a table, or in both, and be alone");
    either_way();
    alone();
    test("points of hits are those by tables");
    same_points();
    test("a transfer that fails once is asked for again, that of a page, too");
    failures();
    test("a page or chunk that is damaged is refused with its place, and only pages are");
    damage();
    test("... and one that is in the place of another");
    exchanged();
    test("what a section of pages begins with is checked: R21");
    heads();
    test("... and all of it, if it is read whole: R13, I31");
    resident_damage();
    test("tables are not streamed, pages not of grids, and not of many packets at a time");
    refused_options();
    test("textures take no room where scenes are streamed and their coordinates are not");
    room_of_textures();
    test("whatever pages hold, they are refused with a place, or frames are rendered");
    mutations();
    return test_done();
}
