/* test_layout - the parts of an arena add up to its need, and to what opening cuts
 *
 * Every image of a list with every combination of source and options that is valid, and
 * those that are not. The rule that adds parts up is written here once more, from
 * planelet.h.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "engine/engine.h"
#include "engine/layout.h"
#include "tests/hostile/images.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* ---- images ------------------------------------------------------------------------- */

enum { SIZES = 4, KINDS = 7, IMAGES = SIZES * KINDS, RAYS = 128 };

typedef struct subject {
    packed image;
    char name[80];
} subject;

static subject subjects[IMAGES];

static packed thesis_image(mesh *m, uint8_t build) {
    packed image = {.size = 0};
    fail f = {""};
    const pack_options options = {PLT_SPLIT_SAH, build, 2, 3, NULL, 0, NULL, 0, 0};
    if (pack_mesh(&image, m, &options, "test", &f) != 0) {
        image.bytes = NULL;
    }
    mesh_free(m);
    return image;
}

/* Kinds 0 .. 2: thesis nodes, built by host, device, nobody; 3 .. 6: compact blocks. */
static packed image_of(int kind, uint32_t triangles) {
    static const uint8_t build[KINDS] = {PLT_BUILD_HOST,  PLT_BUILD_DEVICE, PLT_BUILD_NONE,
                                         PLT_BUILD_HOST,  PLT_BUILD_HOST,   PLT_BUILD_HOST,
                                         PLT_BUILD_DEVICE};
    mesh m = {0};
    shape_soup(&m, triangles, 0.5f, triangles);
    if (kind < 3) {
        return thesis_image(&m, build[kind]);
    }
    compact_config config =
        compact_config_of(kind == 4 ? 4 : 2, kind == 4 ? 21 : 14, build[kind], PLT_SPLIT_SAH);
    config.pack.numbers = kind != 4;
    config.pack.floats = kind == 5;
    return compact_packed(&m, &config);
}

static void make_subjects(void) {
    static const char *const name[KINDS] = {"thesis",        "thesis, device", "list",
                                            "strips",        "no numbers",     "float records",
                                            "strips, device"};
    static const uint32_t triangles[SIZES] = {0, 1, 9, 110};
    for (int i = 0; i < IMAGES; i++) {
        subject *s = &subjects[i];
        s->image = image_of(i % KINDS, triangles[i / KINDS]);
        snprintf(s->name, sizeof s->name, "%s of %u triangles", name[i % KINDS],
                 triangles[i / KINDS]);
        CHECK(s->image.bytes != NULL, "%s is not packed", s->name);
        if (s->image.bytes == NULL) {
            exit(test_done());
        }
    }
}

/* ---- combinations --------------------------------------------------------------------- */

typedef struct combination {
    const subject *s;
    const plt_info *info;
    plt_options options;
    int mapped, valid, builds;
} combination;

static const char *name_of(const combination *c) {
    static char name[160];
    snprintf(name, sizeof name, "%s, mapped %d, side %u, order %u, touched %u", c->s->name,
             c->mapped, c->options.packet_side, c->options.order, c->options.count_touched);
    return name;
}

/* Calls `look` with every one; returns how many there are. */
static uint32_t each(void (*look)(const combination *c)) {
    uint32_t count = 0;
    for (unsigned i = 0; i < IMAGES * 2 * 4 * 2 * 2; i++) {
        const subject *s = &subjects[i / 32];
        const plt_options options = {.packet_side = (uint8_t)(2u << i % 4),
                                     .order = (uint8_t)(i / 4 % 2),
                                     .count_touched = (uint8_t)(i / 8 % 2)};
        const int valid = options.packet_side <= PLT_PACKET_SIDE_MAX &&
                          (options.order == PLT_ORDER_DEPTH_FIRST ||
                           s->image.info.nodes_format == PLT_NODES_THESIS);
        const combination c = {s,       &s->image.info,
                               options, (int)(i / 16 % 2),
                               valid,   s->image.info.build == PLT_BUILD_DEVICE};
        look(&c);
        count++;
    }
    return count;
}

/* Sums of the parts of each lifetime, and the bytes of one part. */
typedef struct sums {
    uint64_t of[PLT_LIFETIMES], touched;
    unsigned parts;
} sums;

static uint64_t most(uint64_t a, uint64_t b) {
    return a > b ? a : b;
}

static sums add_up(const combination *c) {
    sums s = {{0}, 0, 0};
    plt_arena_part part = {NULL, 0, 0};
    while (plt_arena_part_get(c->info, c->mapped, &c->options, s.parts, &part) == PLT_OK) {
        CHECK(part.lifetime < PLT_LIFETIMES && part.name != NULL && part.name[0] != '\0',
              "%s: part %u", name_of(c), s.parts);
        CHECK(part.bytes % PLT_ALIGN == 0, "%s: part %u is not aligned", name_of(c), s.parts);
        s.of[part.lifetime] += part.bytes;
        s.touched += s.parts == PLT_PART_TOUCHED ? part.bytes : 0;
        s.parts++;
    }
    return s;
}

/* planelet.h: what stays, and the greatest of the other three. */
static uint64_t need_of(const sums *s) {
    return s->of[PLT_LIFETIME_STAYS] +
           most(s->of[PLT_LIFETIME_VALIDATES],
                most(s->of[PLT_LIFETIME_BUILDS], s->of[PLT_LIFETIME_RUNS]));
}

static uint32_t valid_ones, invalid_ones, greatest[PLT_LIFETIMES];

static void adds_up(const combination *c) {
    const size_t need = plt_arena_need(c->info, c->mapped, &c->options);
    const sums s = add_up(c);
    if (!c->valid) {
        CHECK(need == 0 && s.parts == 0, "%s: need %zu, %u parts", name_of(c), need, s.parts);
        invalid_ones++;
        return;
    }
    CHECK(need == need_of(&s), "%s: need %zu, not %llu", name_of(c), need,
          (unsigned long long)need_of(&s));
    CHECK(s.parts == PLT_PARTS_COUNT, "%s: %u parts", name_of(c), s.parts);
    CHECK((s.of[PLT_LIFETIME_BUILDS] > 0) == c->builds, "%s: a builder", name_of(c));
    /* Blocks that are built of mapped corners are right by construction. */
    const int trusted = c->builds && c->mapped && c->info->nodes_format == PLT_NODES_COMPACT;
    CHECK((s.of[PLT_LIFETIME_VALIDATES] == 0) == trusted, "%s: validation", name_of(c));
    CHECK(s.of[PLT_LIFETIME_RUNS] > 0, "%s", name_of(c));
    CHECK((s.touched > 0) == c->options.count_touched, "%s: %u bytes", name_of(c),
          (unsigned)s.touched);
    for (unsigned i = PLT_LIFETIME_VALIDATES; i < PLT_LIFETIMES; i++) {
        greatest[i] += need_of(&s) == s.of[PLT_LIFETIME_STAYS] + s.of[i];
    }
    valid_ones++;
}

/* ---- opening ---------------------------------------------------------------------------- */

typedef struct opened {
    plt_engine *e;
    void *arena;
    hostile_stream stream;
    plt_fault fault;
    int status;
} opened;

/* In an arena of exactly so many bytes; freed by the caller. */
static opened open_in(const combination *c, size_t bytes) {
    opened o = {NULL, room_get(bytes), {0}, {0, 0, 0, 0, NULL}, PLT_OK};
    const hostile_stream stream = {c->s->image.bytes, c->s->image.size, 0};
    const plt_source fetched = {NULL, c->s->image.size, &o.stream, hostile_start, hostile_wait};
    const plt_source source = c->mapped ? rig_source(&c->s->image) : fetched;
    o.stream = stream;
    memset(o.arena, 0xA5, bytes);
    o.status = plt_open(&o.e, o.arena, bytes, &source, &c->options, &o.fault);
    CHECK((o.e != NULL) == (o.status == PLT_OK) && !o.stream.beyond, "%s: status %d", name_of(c),
          o.status);
    return o;
}

static uint32_t opened_ones;

/* Parts that stay and parts that run, of the tree that was read or built. */
static uint64_t running_bytes(const combination *c, const plt_engine *e) {
    plt_layout layout;
    uint64_t bytes = 0;
    plt_layout_set(&layout, c->info, plt_engine_info(e), c->mapped, &c->options);
    for (unsigned i = 0; i < PLT_PARTS_COUNT; i++) {
        const enum plt_lifetime lifetime = plt_part_lifetime((enum plt_part)i);
        const int runs = lifetime == PLT_LIFETIME_STAYS || lifetime == PLT_LIFETIME_RUNS;
        bytes += runs ? layout.bytes[i] : 0;
    }
    return bytes;
}

static void opens(const combination *c) {
    if (!c->valid) {
        return;
    }
    const size_t need = plt_arena_need(c->info, c->mapped, &c->options);
    const sums s = add_up(c);
    const uint64_t running = s.of[PLT_LIFETIME_STAYS] + s.of[PLT_LIFETIME_RUNS];
    const opened o = open_in(c, need);
    CHECK(o.status == PLT_OK, "%s: %s", name_of(c), o.fault.message);
    if (o.e != NULL) {
        const size_t used = plt_arena_used(o.e), peak = plt_arena_peak(o.e);
        CHECK(used <= peak && peak <= need, "%s: used %zu, peak %zu, need %zu", name_of(c), used,
              peak, need);
        CHECK(used == running_bytes(c, o.e), "%s: used %zu, not %llu", name_of(c), used,
              (unsigned long long)running_bytes(c, o.e));
        CHECK(c->builds || used == running, "%s: used %zu, not %llu", name_of(c), used,
              (unsigned long long)running);
        CHECK(c->builds || peak == need, "%s: peak %zu, not %zu", name_of(c), peak, need);
        opened_ones++;
    }
    free(o.arena);
}

static void short_of(const combination *c) {
    if (!c->valid || c->builds) {
        return;
    }
    const size_t need = plt_arena_need(c->info, c->mapped, &c->options);
    for (size_t less = PLT_ALIGN; less <= need; less += less < 64 ? PLT_ALIGN : need / 3) {
        const opened o = open_in(c, need - less);
        CHECK(o.status == PLT_ERR_ARENA && o.fault.need_bytes == need,
              "%s: %zu bytes less: status %d, need %zu of %zu", name_of(c), less, o.status,
              o.fault.need_bytes, need);
        free(o.arena);
    }
}

/* ---- touched blocks ------------------------------------------------------------------------ */

typedef struct result {
    plt_hit hits[2 * RAYS];
    plt_stats stats;
    size_t used;
} result;

static void trace(const combination *c, result *r) {
    plt_ray rays[RAYS];
    const opened o = open_in(c, plt_arena_need(c->info, c->mapped, &c->options));
    memset(r, 0, sizeof *r);
    for (uint32_t i = 0; i < RAYS && o.e != NULL; i++) {
        const float x = (float)(i % 16) / 8.0f - 1.0f, y = (float)(i / 16) / 4.0f - 1.0f;
        const plt_ray ray = {{x, y, -3.0f}, 0.0f, {0.1f, 0.05f, 1.0f}, 1e30f};
        rays[i] = ray;
    }
    if (o.e != NULL) {
        plt_trace(o.e, rays, r->hits, RAYS, 0);
        plt_trace(o.e, rays, r->hits + RAYS, RAYS, 1);
        plt_stats_get(o.e, &r->stats);
        r->used = plt_arena_used(o.e);
    }
    free(o.arena);
}

static uint64_t met, touched_bytes;

/* Of combinations that count touched blocks, the same without. */
static void counts_touched(const combination *c) {
    static result with, without;
    combination other = *c;
    other.options.count_touched = 0;
    if (!c->valid || !c->options.count_touched) {
        return;
    }
    trace(c, &with);
    trace(&other, &without);
    const uint64_t touched = with.stats.bytes_touched_once;
    const sums s = add_up(c), none = add_up(&other);
    CHECK(without.stats.bytes_touched_once == 0 && none.touched == 0, "%s", name_of(c));
    CHECK(touched <= with.stats.bytes_fetched && (touched > 0) == (with.stats.bytes_fetched > 0),
          "%s: %u bytes once", name_of(c), (unsigned)touched);
    CHECK(with.used - without.used <= s.touched &&
              (c->builds || with.used - without.used == s.touched),
          "%s: %zu bytes, not %u", name_of(c), with.used - without.used, (unsigned)s.touched);
    CHECK(memcmp(with.hits, without.hits, sizeof with.hits) == 0, "%s: hits differ", name_of(c));
    with.stats.bytes_touched_once = 0;
    CHECK(memcmp(&with.stats, &without.stats, sizeof with.stats) == 0, "%s: statistics differ",
          name_of(c));
    for (int i = 0; i < RAYS; i++) {
        met += with.hits[i].triangle != PLT_MISS;
    }
    touched_bytes += touched;
}

/* ---- what is out of range ------------------------------------------------------------------- */

/* No need, no parts, and opening says so. */
static void refuse(const combination *c) {
    plt_arena_part part;
    CHECK(plt_arena_need(c->info, c->mapped, &c->options) == 0, "%s: a need", name_of(c));
    for (unsigned i = 0; i <= PLT_PARTS_COUNT; i++) {
        CHECK(plt_arena_part_get(c->info, c->mapped, &c->options, i, &part) == PLT_ERR_ARGUMENT,
              "%s: part %u", name_of(c), i);
    }
    const opened o = open_in(c, 65536);
    CHECK(o.status == PLT_ERR_ARGUMENT, "%s: status %d", name_of(c), o.status);
    free(o.arena);
}

static void invalid_options(const combination *c) {
    for (unsigned value = 0; value < 256; value++) {
        combination other = *c;
        other.options.packet_side = (uint8_t)value;
        if ((value != 0 && value != 2 && value != 4 && value != 8 && value != 16) ||
            value > PLT_PACKET_SIDE_MAX) {
            refuse(&other);
        }
        other.options = c->options;
        other.options.order = (uint8_t)value;
        if (value > (c->info->nodes_format == PLT_NODES_THESIS ? 1 : 0)) {
            refuse(&other);
        }
        other.options = c->options;
        other.options.count_touched = (uint8_t)value;
        if (value > 1) {
            refuse(&other);
        }
    }
}

/* Of each image one valid combination, spoilt. */
static void out_of_range(void) {
    for (int i = 0; i < IMAGES; i++) {
        const plt_options options = {.packet_side = 2, .count_touched = 1};
        const plt_info *info = &subjects[i].image.info;
        const combination c = {&subjects[i], info, options,
                               i % 2,        1,    info->build == PLT_BUILD_DEVICE};
        invalid_options(&c);
        plt_info no_treelets = *info;
        plt_arena_part part;
        no_treelets.treelet_nodes = 0;
        CHECK(plt_arena_need(&no_treelets, 1, &options) == 0 &&
                  plt_arena_part_get(&no_treelets, 1, &options, 0, &part) == PLT_ERR_ARGUMENT,
              "%s: treelets of no nodes", subjects[i].name);
    }
}

/* An arena of `bytes` gets packets as large as it has room for: of the side whose need is the
 * greatest that is no more. */
static void chooses(const combination *c, size_t bytes) {
    unsigned due = 0;
    combination other = *c;
    for (unsigned side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
        other.options.packet_side = (uint8_t)side;
        if (plt_arena_need(c->info, c->mapped, &other.options) <= bytes) {
            due = side;
        }
    }
    other.options.packet_side = 0;
    const opened o = open_in(&other, bytes);
    CHECK((o.status == PLT_OK) == (due > 0), "%s: %zu bytes, status %d", name_of(c), bytes,
          o.status);
    if (o.status == PLT_OK) {
        CHECK(plt_packet_side(o.e) == due, "%s: %zu bytes, packets of %u, not %u", name_of(c),
              bytes, plt_packet_side(o.e), due);
    }
    free(o.arena);
}

static void room_for_packets(const combination *c) {
    if (c->valid && !c->builds) {
        const size_t need = plt_arena_need(c->info, c->mapped, &c->options);
        chooses(c, need - PLT_ALIGN);
        chooses(c, need);
        chooses(c, need + 100000);
        plt_options least = c->options;
        least.packet_side = 0;
        const size_t at_least = plt_arena_need(c->info, c->mapped, &least);
        least.packet_side = 2;
        CHECK(at_least == plt_arena_need(c->info, c->mapped, &least), "%s: the need of side 0",
              name_of(c));
    }
}

static void beyond_the_last(const combination *c) {
    static const unsigned beyond[4] = {PLT_PARTS_COUNT, PLT_PARTS_COUNT + 1, 256, 0xFFFFFFFFu};
    plt_arena_part part;
    for (int i = 0; i < 4 && c->valid; i++) {
        CHECK(plt_arena_part_get(c->info, c->mapped, &c->options, beyond[i], &part) ==
                  PLT_ERR_ARGUMENT,
              "%s: part %u", name_of(c), beyond[i]);
    }
}

int main(void) {
    enum {
        SIDES = 1 + (PLT_PACKET_SIDE_MAX >= 4) + (PLT_PACKET_SIDE_MAX >= 8) +
                (PLT_PACKET_SIDE_MAX >= 16)
    };
    /* Three kinds in both orders, four in one. */
    const uint32_t valid = SIZES * 10 * 2 * 2 * SIDES;
    test("an arena's need is what stays and the greatest of the other sums of its parts");
    make_subjects();
    const uint32_t all = each(adds_up);
    CHECK(valid_ones == valid && valid_ones + invalid_ones == all, "%u of %u are valid, not %u",
          valid_ones, all, valid);
    for (unsigned i = PLT_LIFETIME_VALIDATES; i < PLT_LIFETIMES; i++) {
        /* A tiny build validates few levels. */
        const int never = i == PLT_LIFETIME_VALIDATES && rig_is_tiny();
        CHECK(greatest[i] > 0 || never, "the sum of lifetime %u is never the greatest", i);
    }
    test("opening cuts the parts that stay and those that run, and its peak is the need");
    each(opens);
    CHECK(opened_ones == valid, "%u of %u were opened", opened_ones, valid);
    test("an image with a finished tree opens in no byte less, and the fault says how many");
    each(short_of);
    test("touched blocks are counted only if asked for, and change nothing else");
    each(counts_touched);
    CHECK(met > 0 && touched_bytes > 0, "nothing was hit or touched");
    test("packets of no size that was asked for are as large as the arena has room for");
    each(room_for_packets);
    test("a part beyond the last is refused");
    each(beyond_the_last);
    test("options out of range have no need and no parts, and open nothing");
    out_of_range();
    for (int i = 0; i < IMAGES; i++) {
        pack_free(&subjects[i].image);
    }
    return test_done();
}
