/* triangle_lanes - see triangle.h; for packets with hulls
 *
 * Candidates of a whole leaf are found first, without a jump, and tested for hits then. There is
 * code of its own for each axis of the shear, and for packets of one origin.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/leaf_records.h"
#include "engine/trace/triangle.h"

#if PLT_WITH_HULLS

#include "engine/trace/triangle_hits.h"
#include "engine/trace/triangle_sieve.h"
#include "engine/tree/record_rows.h"

/* Triangles that are rows, or records. A way through the code of its own for both. */
enum source { ROWS, RECORDS };

/* Triangles and groups to be tested. */
typedef struct batch {
    const plt_triangle_rows *triangle; /* ROWS */
    const plt_record *record;          /* RECORDS */
    uint32_t lists;                    /* to be tested; of ROWS each is one */
    unsigned tested;                   /* triangles; they end `lists_tested` */
    uint32_t lists_tested;
    plt_mask groups;
    f4 slack; /* of the sieve: 72 u R L + 192 u L^2 + 320 u^2 R^2 */
} batch;

PLT_INLINED void get_corners(const batch *b, unsigned k, enum source source, f4 to[3]) {
    if (source == RECORDS) {
        plt_record_rows(&b->record[k], to);
        return;
    }
    PLT_UNROLLED for (int c = 0; c < 3; c++) {
        to[c] = b->triangle[k].corner[c];
    }
}

static inline uint32_t word_of(const batch *b, unsigned k, enum source source) {
    return source == RECORDS ? plt_get_u32(&b->record[k].word[9]) : b->triangle[k].word;
}

static inline uint32_t ends_list(const batch *b, unsigned k, enum source source) {
    return source == RECORDS ? (uint32_t)plt_record_is_last(&b->record[k]) : 1;
}

/* Candidates: a triangle and a group that may meet it. */
enum { PER_TRIANGLE = 256 * SIFTED_LANES };

typedef struct found {
    unsigned count;
    uint32_t pair[PLT_TRIANGLES_MOST * PLT_GROUPS_MAX + 1]; /* PER_TRIANGLE * triangle + group */
} found;

/* Of as many triangles as there is room for. Where a list ends is asked after its triangle was
 * dealt with: the answer may be late, and a wrong guess should cost what lies behind it alone. */
PLT_INLINED void find_candidates(batch *b, const plt_packet *p, int z, enum sharing sharing,
                                 enum source source, int surely, found *f) {
    unsigned count = 0, k = 0;
    uint32_t lists = 0;
    sieve s;
    s.slack = b->slack;
    for (; lists < b->lists && k < PLT_TRIANGLES_MOST; k++) {
        f4 corner[3];
        get_corners(b, k, source, corner);
        set_sieve(&s, corner, p, z, sharing);
        count +=
            sift(&s, p->rays, b->groups, z, sharing, surely, PER_TRIANGLE * k, &f->pair[count]);
        lists += ends_list(b, k, source);
    }
    f->count = count;
    b->tested = k;
    b->lists_tested = lists;
}

/* `surely`, of one origin: hits have normals, and want no edge functions but where the sieve leaves
 * open whether a lane is covered. */
PLT_INLINED void test_batch(prepared *t, plt_packet *p, batch *b, int z, enum sharing sharing,
                            enum source source, int surely) {
    found f;
    unsigned ready = PLT_TRIANGLES_MOST; /* none */
    find_candidates(b, p, z, sharing, source, surely, &f);
    for (unsigned i = 0; i < f.count; i++) {
        const unsigned k = f.pair[i] / PER_TRIANGLE, index = f.pair[i] % SIFTED_LANES;
        if (k != ready) {
            ready = k;
            get_corners(b, k, source, t->corner);
            t->word = word_of(b, k, source);
            t->has_surface = 0;
            if (!surely) {
                prepare(t, p, z, sharing);
            }
        }
        if (surely) {
            test_surface(t, p, index, z, f.pair[i] / SIFTED_LANES);
        } else {
            test_candidate(t, p, index, z, sharing);
        }
    }
}

/* Of groups whose rays differ in axis, those that have one of it. */
PLT_INLINED void test_axes(prepared *t, plt_packet *p, batch *b, plt_mask groups,
                           enum source source) {
    for (int z = 0; z < 3; z++) {
        b->groups = 0;
        for (plt_mask m = groups; m != 0; m &= m - 1) {
            const unsigned index = plt_mask_first(m);
            b->groups |= plt_mask_of(index, p->rays[index].axis_lanes[z] != 0);
        }
        test_batch(t, p, b, z, PER_GROUP, source, 0);
    }
}

static inline void set_slacks(prepared *t, batch *b, const plt_packet *p, float longest) {
    const float by_size = 72.0f * PLT_U * longest * p->reach;
    t->longest = longest;
    t->slack = f4_all(by_size + p->least_slack);
    t->sure = f4_all(by_size + p->least_sure);
    b->slack = f4_all(by_size + 192.0f * PLT_U * longest * longest + p->least_slack);
}

/* A way through the code of its own for each axis, and for one origin: constants there. */
PLT_INLINED void test_groups(plt_packet *p, batch *b, const plt_primitive_ids *ids, float longest,
                             plt_mask groups, enum source source) {
    prepared t;
    t.ids = ids;
    set_slacks(&t, b, p, longest);
    b->groups = groups;
    const int one = p->slabs.coherence == PLT_ONE_ORIGIN;
    switch ((one ? p->surfaces ? 8 : 4 : 0) + p->axis) {
#define TEST_BATCH(kind, sharing, surely)                                                          \
    case (kind):                                                                                   \
        test_batch(&t, p, b, 0, sharing, source, surely);                                          \
        break;                                                                                     \
    case (kind) + 1:                                                                               \
        test_batch(&t, p, b, 1, sharing, source, surely);                                          \
        break;                                                                                     \
    case (kind) + 2:                                                                               \
        test_batch(&t, p, b, 2, sharing, source, surely);                                          \
        break;
        TEST_BATCH(0, PER_GROUP, 0)
        TEST_BATCH(4, PER_PACKET, 0)
        TEST_BATCH(8, PER_PACKET, 1)
#undef TEST_BATCH
    default:
        test_axes(&t, p, b, groups, source);
        break;
    }
}

void plt_triangles_groups(plt_packet *p, const plt_triangle_rows *triangles, unsigned count,
                          const plt_primitive_ids *ids, float longest, plt_mask groups) {
    batch b;
    b.triangle = triangles;
    b.lists = count;
    test_groups(p, &b, ids, longest, groups, ROWS);
}

void plt_triangle_groups(plt_packet *p, const plt_triangle *triangle, plt_mask groups) {
    plt_triangle_rows rows;
    rows.corner[0] = f4_load(triangle->corner[0]);
    rows.corner[1] = f4_load(triangle->corner[1]);
    rows.corner[2] = f4_load(triangle->corner[2]); /* and what lies behind it */
    rows.word = triangle->word;
    plt_triangles_groups(p, &rows, 1, triangle->ids, triangle->longest, groups);
}

uint32_t plt_records_groups(plt_packet *p, const plt_record *record, uint32_t lists, float longest,
                            plt_mask groups) {
    batch b;
    b.record = record;
    for (b.lists = lists; b.lists > 0; b.lists -= b.lists_tested) {
        test_groups(p, &b, NULL, longest, p->any ? groups & p->active : groups, RECORDS);
        b.record += b.tested;
    }
    return (uint32_t)(b.record - record);
}

#endif
