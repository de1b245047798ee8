/* triangle_lanes - see triangle.h; for packets with hulls
 *
 * Candidates of a whole leaf are found first, without a jump, and tested for hits then. There is
 * code of its own for each axis of the shear, and for packets of one origin.
 *
 * Error bounds: triangle_common.h.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/leaf_records.h"
#include "engine/trace/planes.h"
#include "engine/trace/triangle.h"
#include "engine/trace/triangle_record.h"

#if PLT_WITH_HULLS

/* A triangle made ready for all groups of a packet. */
typedef struct prepared {
    f4 corner[3];    /* x, y, z */
    f4 across[3][3]; /* [corner]: along both axes across the shear's, and along that; in all
                        lanes. PER_PACKET: minus the origin */
    f4 slack;        /* 72 u R L + 320 u^2 R^2, R being the largest reach of the packet */
    float longest;
    uint32_t word;
    const plt_primitive_ids *ids;
    int has_surface; /* what only candidates for a hit need, set for the first of them: */
    float corner_floats[3][3];
    float normal[4];
    float numerator;   /* PER_PACKET: normal . (corner 0 - origin) */
    plt_planes planes; /* of its own box */
} prepared;

/* In all lanes, the component along axis z and along the two after it. */
static inline void spread(f4 to[3], f4 v, int z) {
    const f4 x = f4_lane(v, 0), y = f4_lane(v, 1), w = f4_lane(v, 2);
    to[0] = z == 0 ? y : z == 1 ? w : x;
    to[1] = z == 0 ? w : z == 1 ? x : y;
    to[2] = z == 0 ? x : z == 1 ? y : w;
}

PLT_INLINED void prepare(prepared *t, const plt_packet *p, int z, enum sharing sharing) {
    const f4 org = f4_load(p->org);
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        spread(t->across[c], sharing == PER_PACKET ? f4_sub(t->corner[c], org) : t->corner[c], z);
    }
}

static inline f4 from_origin(const prepared *t, const plt_group_rays *g, int corner, int k, int z,
                             enum sharing sharing) {
    const f4 at = t->across[corner][k];
    const int axis = k == 2 ? z : k == 0 ? plt_axis_after[z] : plt_axis_after[plt_axis_after[z]];
    return sharing == PER_GROUP ? f4_sub(at, f4_load(g->org[axis])) : at;
}

/* The edge functions as seen along axis z. */
PLT_INLINED edges edges_of(const prepared *t, const plt_group_rays *g, int z,
                           enum sharing sharing) {
    const f4 slope_x = f4_load(g->slope[0]), slope_y = f4_load(g->slope[1]);
    edges e;
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        const f4 depth = from_origin(t, g, c, 2, z, sharing);
        e.x[c] = f4_sub(from_origin(t, g, c, 0, z, sharing), f4_mul(slope_x, depth));
        e.y[c] = f4_sub(from_origin(t, g, c, 1, z, sharing), f4_mul(slope_y, depth));
    }
    set_weights(&e);
    return e;
}

/* Lanes that the triangle covers, or may cover. */
static inline unsigned may_cover(const prepared *t, const edges *e) {
    return m4_mask(m4_or(f4_le(f4_neg(t->slack), e->least), f4_le(e->most, t->slack)));
}

/* Where the rays are inside the triangle's own box, as boxes.c would say. */
static inline m4 own_box(const prepared *t, const plt_group_slabs *s, enum plt_coherence kind,
                         f4 *enter, f4 *leave) {
    f4 n[3], f[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 rdir = f4_load(s->rdir[a]);
        plt_plane_depths(&t->planes, a, s, rdir, rdir, kind, &n[a], &f[a]);
    }
    *enter = f4_max(f4_max(n[0], n[1]), n[2]);
    *leave = f4_min(f4_min(f[0], f[1]), f[2]);
    return f4_le(*enter, *leave);
}

/* What only candidates need of a triangle. */
RARELY void set_surface(prepared *t, const plt_packet *p) {
    const f4 lo = f4_min(f4_min(t->corner[0], t->corner[1]), t->corner[2]);
    const f4 hi = larger3(t->corner[0], t->corner[1], t->corner[2]);
    const f4 first = f4_sub(t->corner[1], t->corner[0]),
             second = f4_sub(t->corner[2], t->corner[0]);
    const f4 first_y = f4_turn(first), second_y = f4_turn(second);
    f4_store(t->normal,
             f4_sub(f4_mul(first_y, f4_turn(second_y)), f4_mul(f4_turn(first_y), second_y)));
    t->has_surface = 1;
    for (int c = 0; c < 3; c++) {
        float at[4];
        f4_store(at, t->corner[c]);
        memcpy(t->corner_floats[c], at, sizeof t->corner_floats[c]);
    }
    switch (p->slabs.coherence) {
    case PLT_ONE_ORIGIN:
        plt_planes_set(&t->planes, &p->slabs, lo, hi, PLT_ONE_ORIGIN);
        float from[4];
        f4_store(from, f4_sub(t->corner[0], f4_load(p->org)));
        t->numerator = 0.0f;
        for (int a = 0; a < 3; a++) {
            t->numerator = t->numerator + t->normal[a] * from[a];
        }
        break;
    case PLT_ONE_SIGN:
        plt_planes_set(&t->planes, &p->slabs, lo, hi, PLT_ONE_SIGN);
        break;
    default:
        plt_planes_set(&t->planes, &p->slabs, lo, hi, PLT_MIXED);
        break;
    }
}

PLT_INLINED unsigned record_kind(const prepared *t, plt_packet *p, unsigned index, edges *e, int z,
                                 unsigned lanes, enum plt_coherence kind) {
    passing at;
    at.corner = t->corner_floats;
    at.longest = t->longest;
    at.word = t->word;
    at.ids = t->ids;
    memcpy(at.normal, t->normal, sizeof at.normal);
    at.numerator = kind == PLT_ONE_ORIGIN
                       ? f4_all(t->numerator)
                       : plane_numerator(t->corner_floats[0], t->normal, &p->rays[index]);
    at.in_box = own_box(t, &p->slabs.group[index], kind, &at.enter, &at.leave);
    const unsigned hits = record_passing(&at, p, index, e, z, lanes);
    p->changed |= plt_mask_of(index, hits != 0);
    return hits;
}

RARELY unsigned record_hits(prepared *t, plt_packet *p, unsigned index, edges *e, int z,
                            unsigned lanes) {
    plt_group_make_ready(p, index);
    if (!t->has_surface) {
        set_surface(t, p);
    }
    switch (p->slabs.coherence) {
    case PLT_ONE_ORIGIN:
        return record_kind(t, p, index, e, z, lanes, PLT_ONE_ORIGIN);
    case PLT_ONE_SIGN:
        return record_kind(t, p, index, e, z, lanes, PLT_ONE_SIGN);
    default:
        return record_kind(t, p, index, e, z, lanes, PLT_MIXED);
    }
}

/* Groups that have a ray which may meet a triangle: candidates of all records of a leaf, or of
 * as many as there is room for. */
enum { FOUND_MOST = 64 };

typedef struct found {
    uint8_t group[FOUND_MOST + PLT_GROUPS_MAX];
    const plt_record *record[FOUND_MOST + PLT_GROUPS_MAX];
    unsigned count;
} found;

/* Nothing here depends on which they are but what is written: a jump that is taken for one group
 * in three is mostly foreseen wrong. */
PLT_INLINED void find_candidates(const prepared *t, const plt_packet *p, const plt_record *record,
                                 plt_mask groups, int z, enum sharing sharing, found *f) {
    for (plt_mask m = groups; m != 0; m &= m - 1) {
        const unsigned index = plt_mask_first(m);
        const edges e = edges_of(t, &p->rays[index], z, sharing);
        f->group[f->count] = (uint8_t)index;
        f->record[f->count] = record;
        f->count += may_cover(t, &e) != 0;
    }
}

PLT_INLINED void test_candidate(prepared *t, plt_packet *p, unsigned index, int z,
                                enum sharing sharing) {
    const plt_group_rays *g = &p->rays[index];
    edges e = edges_of(t, g, z, sharing);
    const unsigned may = may_cover(t, &e) & g->axis_lanes[z];
    if (may != 0 && record_hits(t, p, index, &e, z, may) != 0 && p->any) {
        retire_group(p, index);
    }
}

PLT_INLINED void test_groups(prepared *t, plt_packet *p, plt_mask groups, int z,
                             enum sharing sharing) {
    found f;
    f.count = 0;
    prepare(t, p, z, sharing);
    find_candidates(t, p, NULL, groups, z, sharing, &f);
    for (unsigned i = 0; i < f.count; i++) {
        test_candidate(t, p, f.group[i], z, sharing);
    }
}

/* Of groups whose rays differ in axis, those that have one of it. */
static void test_axes(prepared *t, plt_packet *p, plt_mask groups) {
    for (int z = 0; z < 3; z++) {
        plt_mask along = 0;
        for (plt_mask m = groups; m != 0; m &= m - 1) {
            const unsigned index = plt_mask_first(m);
            along |= plt_mask_of(index, p->rays[index].axis_lanes[z] != 0);
        }
        test_groups(t, p, along, z, PER_GROUP);
    }
}

/* A way through the code of its own for each axis, and for one origin: constants there. */
#define FOR_EACH_WAY(p, CALL)                                                                      \
    switch (((p)->slabs.coherence == PLT_ONE_ORIGIN ? 0 : 4) + (p)->axis) {                        \
    case 0:                                                                                        \
        CALL(0, PER_PACKET);                                                                       \
        break;                                                                                     \
    case 1:                                                                                        \
        CALL(1, PER_PACKET);                                                                       \
        break;                                                                                     \
    case 2:                                                                                        \
        CALL(2, PER_PACKET);                                                                       \
        break;                                                                                     \
    case 4:                                                                                        \
        CALL(0, PER_GROUP);                                                                        \
        break;                                                                                     \
    case 5:                                                                                        \
        CALL(1, PER_GROUP);                                                                        \
        break;                                                                                     \
    case 6:                                                                                        \
        CALL(2, PER_GROUP);                                                                        \
        break;                                                                                     \
    default:                                                                                       \
        CALL(PLT_AXES_DIFFER, PER_GROUP);                                                          \
        break;                                                                                     \
    }

/* A corner each, x, y, z; the fourth lane means nothing. */
static inline void record_rows(const plt_record *r, f4 corner[3]) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    float c[3][3 + 1] = {{0.0f}};
    for (int i = 0; i < 9; i++) {
        c[i / 3][i % 3] = plt_record_float(r, i / 3, i % 3);
    }
    corner[0] = f4_load(c[0]);
    corner[1] = f4_load(c[1]);
    corner[2] = f4_load(c[2]);
#else
    const float *word = (const float *)(const void *)r->word;
    corner[0] = f4_load(word);
    corner[1] = f4_load(word + 3);
    corner[2] = f4_load(word + 6);
#endif
}

static inline float slack_of(const plt_packet *p, float longest) {
    return 72.0f * PLT_U * longest * p->reach + p->least_slack;
}

void plt_triangle_groups(plt_packet *p, const plt_triangle *triangle, plt_mask groups) {
    prepared t;
    t.corner[0] = f4_load(triangle->corner[0]);
    t.corner[1] = f4_load(triangle->corner[1]);
    t.corner[2] = f4_load(triangle->corner[2]); /* and what lies behind it */
    t.longest = triangle->longest;
    t.slack = f4_all(slack_of(p, t.longest));
    t.word = triangle->word;
    t.ids = triangle->ids;
    t.has_surface = 0;
#define TEST_TRIANGLE(z, sharing)                                                                  \
    ((z) == PLT_AXES_DIFFER ? test_axes(&t, p, groups) : test_groups(&t, p, groups, (z), (sharing)))
    FOR_EACH_WAY(p, TEST_TRIANGLE)
}

PLT_INLINED void set_record(prepared *t, const plt_packet *p, const plt_record *record, int z,
                            enum sharing sharing) {
    record_rows(record, t->corner);
    prepare(t, p, z, sharing);
}

PLT_INLINED void test_found(prepared *t, plt_packet *p, const found *f, int z,
                            enum sharing sharing) {
    const plt_record *record = NULL;
    for (unsigned i = 0; i < f->count; i++) {
        if (f->record[i] != record) {
            record = f->record[i];
            set_record(t, p, record, z, sharing);
            t->word = plt_get_u32(&record->word[9]);
            t->has_surface = 0;
        }
        test_candidate(t, p, f->group[i], z, sharing);
    }
}

PLT_INLINED uint32_t test_records(plt_packet *p, const plt_record *record, uint32_t lists,
                                  float longest, plt_mask groups, int z, enum sharing sharing) {
    const plt_record *at = record;
    prepared t;
    found f;
    f.count = 0;
    t.longest = longest;
    t.slack = f4_all(slack_of(p, longest));
    t.ids = NULL;
    for (; lists > 0; at++) {
        set_record(&t, p, at, z, sharing);
        find_candidates(&t, p, at, groups, z, sharing, &f);
        lists -= (uint32_t)plt_record_is_last(at);
        if (f.count > FOUND_MOST) {
            test_found(&t, p, &f, z, sharing);
            f.count = 0;
            groups &= p->any ? p->active : groups;
        }
    }
    test_found(&t, p, &f, z, sharing);
    return (uint32_t)(at - record);
}

static uint32_t test_records_axes(plt_packet *p, const plt_record *record, uint32_t lists,
                                  float longest, plt_mask groups) {
    const plt_record *at = record;
    prepared t;
    t.longest = longest;
    t.slack = f4_all(slack_of(p, longest));
    t.ids = NULL;
    for (; lists > 0; at++) {
        record_rows(at, t.corner);
        t.word = plt_get_u32(&at->word[9]);
        t.has_surface = 0;
        test_axes(&t, p, p->any ? groups & p->active : groups);
        lists -= (uint32_t)plt_record_is_last(at);
    }
    return (uint32_t)(at - record);
}

uint32_t plt_records_groups(plt_packet *p, const plt_record *record, uint32_t lists, float longest,
                            plt_mask groups) {
    uint32_t count;
#define TEST_RECORDS(z, sharing)                                                                   \
    count = (z) == PLT_AXES_DIFFER                                                                 \
                ? test_records_axes(p, record, lists, longest, groups)                             \
                : test_records(p, record, lists, longest, groups, (z), (sharing))
    FOR_EACH_WAY(p, TEST_RECORDS)
    return count;
}

#endif
