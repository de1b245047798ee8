/* test_hulls - hulls leave nothing out that their rays would meet, and little else in
 *
 * Packets of all sides are made of rays that share an origin or start on a small surface, with
 * signs that are equal or not, some of them no rays at all; boxes lie on their way, or close to
 * it. A ray that meets a box, by the slabs of its group, must be in a lane that meets it in every
 * hull above, no deeper than the ray. How many lanes meet a box without a ray that does is
 * counted: a hull that lets everything through would be right, and of no use.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/lanes/lanes.h"
#include "engine/planelet.h"
#include "engine/trace/packet.h"
#include "tests/reference/random.h"
#include "tests/test.h"

#if PLT_WITH_HULLS && PLT_PACKET_SIDE_MAX >= 4

#include "engine/trace/hull_test.h"
#include "engine/trace/packet_plain.h"
#include "engine/trace/rays.h"

enum { RAYS_MOST = 256, PACKETS = 600, BOXES = 60 };

typedef struct subject {
    plt_packet packet;
    plt_box scene;
    plt_ray rays[RAYS_MOST];
    uint32_t count, side;
    float scale;
    _Alignas(16) unsigned char memory[64 * 1024];
} subject;

typedef struct counts {
    unsigned packets, mixed, apart, met, lanes, lanes_of_rays;
} counts;

/* Through a plane at depth 1 before the eye, in Z order or nearly so; some are odd. */
static void make_rays(subject *s, random_state *r, int apart, int mixed, int odd) {
    const int axis = (int)random_below(r, 3), x = (axis + 1) % 3, y = (axis + 2) % 3;
    const float back = random_below(r, 2) ? -s->scale : s->scale,
                spread = random_float(r, 0.01f, 0.3f);
    const float at_x = mixed ? -spread / 2 : random_float(r, 0.0f, 0.6f);
    const float at_y = random_float(r, -0.6f, 0.6f), far = apart ? 0.05f * s->scale : 0.0f;
    for (uint32_t i = 0; i < s->count; i++) {
        plt_ray *ray = &s->rays[i];
        const float column = (float)((i & 1) | (i >> 1 & 2) | (i >> 2 & 4) | (i >> 3 & 8));
        const float row = (float)((i >> 1 & 1) | (i >> 2 & 2) | (i >> 3 & 4) | (i >> 4 & 8));
        ray->dir[axis] = back;
        ray->dir[x] = s->scale * (at_x + spread * column / 16.0f);
        ray->dir[y] = s->scale * (at_y + spread * row / 16.0f);
        for (int a = 0; a < 3; a++) {
            ray->org[a] = a == axis ? -back * 1.5f : far * random_float(r, -1.0f, 1.0f);
        }
        ray->tmin = apart ? 0.25f : 0.0f;
        ray->tmax = odd && random_below(r, 4) == 0 ? random_float(r, 0.3f, 3.0f) : INFINITY;
        if (!odd) {
            continue;
        }
        if (random_below(r, 40) == 0) {
            ray->dir[random_below(r, 3)] = random_below(r, 2) ? NAN : 0.0f;
        }
        if (random_below(r, 60) == 0) {
            ray->org[random_below(r, 3)] = random_below(r, 2) ? NAN : 1e30f;
        }
        if (random_below(r, 40) == 0) {
            ray->dir[x] = random_below(r, 2) ? -0.0f : ldexpf(s->scale, -120);
        }
    }
}

static void make_subject(subject *s, random_state *r, int apart, int mixed, int odd) {
    s->side = 4u << random_below(r, plt_hull_levels(PLT_PACKET_SIDE_MAX));
    s->count = random_below(r, 3) == 0 ? 1 + random_below(r, s->side * s->side) : s->side * s->side;
    s->scale = ldexpf(1.0f, (int)random_below(r, 3) * 30 - 30);
    for (int a = 0; a < 3; a++) {
        s->scene.lo[a] = -s->scale;
        s->scene.hi[a] = s->scale;
    }
    make_rays(s, r, apart, mixed, odd);
}

/* A packet without an odd ray now and then. */
static int make_packet(subject *s, random_state *r, int apart, int mixed) {
    make_subject(s, r, apart, mixed, random_below(r, 4) != 0);
    plt_packet_init(&s->packet, s->memory, s->side);
    plt_packet_set_rays(&s->packet, &s->scene, s->rays, s->count, 0);
    if (s->packet.along) {
        plt_hulls_set(&s->packet);
    }
    for (plt_mask m = s->packet.along ? s->packet.active : 0; m != 0; m &= m - 1) {
        plt_group_make_ready(&s->packet, plt_mask_first(m));
    }
    return s->packet.along;
}

/* On the way of one of the rays, small or large, at times beside it. */
static void make_box(const subject *s, random_state *r, float lo[4], float hi[4]) {
    const plt_ray *ray = &s->rays[random_below(r, s->count)];
    const float t = random_float(r, 0.2f, 2.6f),
                half = s->scale * ldexpf(1.0f, -(int)random_below(r, 12));
    for (int a = 0; a < 3; a++) {
        const float d = isfinite(ray->dir[a]) ? ray->dir[a] : 0.0f;
        const float at = ray->org[a] + t * d + half * random_float(r, -1.5f, 1.5f);
        lo[a] = fmaxf(at - half * random_float(r, 0.0f, 1.0f), -s->scale);
        hi[a] = fmaxf(lo[a], fminf(at + half * random_float(r, 0.0f, 1.0f), s->scale));
    }
    lo[3] = hi[3] = 0.0f;
}

static unsigned meet(const subject *s, unsigned hull, const plt_planes *planes, float enter[4]) {
    const plt_four four = plt_four_of(&s->packet, hull);
    f4 depth;
    unsigned met;
    switch (s->packet.slabs.coherence) {
    case PLT_ONE_ORIGIN:
        met = plt_four_meet(&four, planes, PLT_ONE_ORIGIN, &depth);
        break;
    case PLT_ONE_SIGN:
        met = plt_four_meet(&four, planes, PLT_ONE_SIGN, &depth);
        break;
    default:
        met = plt_four_meet(&four, planes, PLT_MIXED, &depth);
        break;
    }
    f4_store(enter, depth);
    return met;
}

static void set_planes(const subject *s, const float lo[4], const float hi[4], plt_planes *to) {
    const plt_slab_array *slabs = &s->packet.slabs;
    switch (slabs->coherence) {
    case PLT_ONE_ORIGIN:
        plt_planes_set(to, slabs, f4_load(lo), f4_load(hi), PLT_ONE_ORIGIN);
        break;
    case PLT_ONE_SIGN:
        plt_planes_set(to, slabs, f4_load(lo), f4_load(hi), PLT_ONE_SIGN);
        break;
    default:
        plt_planes_set(to, slabs, f4_load(lo), f4_load(hi), PLT_MIXED);
        break;
    }
}

/* Every lane above a group that has a ray with this depth of entry. */
static void check_above(unsigned hull, const unsigned met[], float enter[][4], double depth) {
    for (unsigned at = hull; at > 0; at = (at - 1) / 4) {
        const unsigned above = (at - 1) / 4, lane = (at - 1) % 4;
        CHECK(met[above] >> lane & 1u, "hull %u leaves out lane %u", above, lane);
        CHECK((double)enter[above][lane] <= depth, "hull %u, lane %u: %g, and a ray at %g", above,
              lane, (double)enter[above][lane], depth);
    }
}

static void check_box(const subject *s, const float lo[4], const float hi[4], counts *n) {
    static unsigned met[85], rays[85];
    static float enter[85][4];
    const plt_packet *p = &s->packet;
    plt_planes planes;
    set_planes(s, lo, hi, &planes);
    memset(rays, 0, sizeof rays);
    for (unsigned i = 0; i < p->first_group; i++) {
        met[i] = meet(s, i, &planes, enter[i]);
    }
    for (plt_mask m = p->active; m != 0; m &= m - 1) {
        const unsigned group = plt_mask_first(m), hull = p->first_group + group;
        met[hull] = meet(s, hull, &planes, enter[hull]);
        for (unsigned lane = 0; lane < 4; lane++) {
            if (met[hull] >> lane & 1u) {
                const double along = fabs((double)p->rays[group].dir[p->axis][lane]);
                check_above(hull, met, enter, (double)enter[hull][lane] * along * (1 + 1e-6));
                n->met++;
            }
        }
        rays[hull] = met[hull] != 0;
    }
    for (unsigned at = p->first_group + p->capacity; at-- > 1;) {
        rays[(at - 1) / 4] |= (unsigned)(rays[at] != 0) << (at - 1) % 4;
    }
    for (unsigned i = 0; i < p->first_group; i++) {
        n->lanes += (unsigned)__builtin_popcount(met[i]);
        n->lanes_of_rays += (unsigned)__builtin_popcount(rays[i]);
    }
}

static void test_boxes(int apart, int mixed, double spare) {
    static subject s;
    random_state r = {(uint64_t)(1 + apart + 2 * mixed)};
    counts n = {0};
    for (int i = 0; i < PACKETS; i++) {
        if (!make_packet(&s, &r, apart, mixed)) {
            continue;
        }
        n.packets++;
        n.mixed += s.packet.slabs.coherence == PLT_MIXED;
        n.apart += s.packet.slabs.coherence == PLT_ONE_SIGN;
        for (int k = 0; k < BOXES; k++) {
            float lo[4], hi[4];
            make_box(&s, &r, lo, hi);
            check_box(&s, lo, hi, &n);
        }
    }
    printf(
        "    %u packets, %u of mixed signs, %u from many origins; rays met %u boxes; %.2f lanes "
        "for one with a ray\n",
        n.packets, n.mixed, n.apart, n.met, (double)n.lanes / n.lanes_of_rays);
    CHECK(n.packets > PACKETS / 4 && n.met > (PLT_PACKET_SIDE_MAX < 16 ? 5000 : 50000), "too few");
    CHECK(n.lanes < spare * n.lanes_of_rays, "hulls let too much through");
}

/* ---- packets that are set up at a glance, and group by group ------------------------ */

static void set_groups(const subject *s, plt_packet *p, void *memory) {
    plt_packet_init(p, memory, s->side);
    plt_packet_begin(p, &s->scene, (s->count + 3) / 4, 0);
    for (uint32_t i = 0; i < p->groups; i++) {
        plt_packet_load_rays(p, i, s->rays + 4 * i, s->count - 4 * i);
    }
    plt_packet_finish(p);
}

/* u, v and normals are not set before there is a hit. */
static void check_groups(const plt_packet *p, const plt_packet *q) {
    for (plt_mask m = p->active; m != 0; m &= m - 1) {
        const unsigned i = plt_mask_first(m);
        const plt_group_rays *a = &p->rays[i], *b = &q->rays[i];
        const plt_group_slabs *s = &p->slabs.group[i], *t = &q->slabs.group[i];
        CHECK(memcmp(a->org, b->org, sizeof a->org) == 0 &&
                  memcmp(a->dir, b->dir, sizeof a->dir) == 0 &&
                  memcmp(a->slope, b->slope, sizeof a->slope) == 0 &&
                  memcmp(a->axis_lanes, b->axis_lanes, sizeof a->axis_lanes) == 0,
              "rays of group %u", i);
        CHECK(a->valid == b->valid && memcmp(a->id, b->id, sizeof a->id) == 0, "lanes of %u", i);
        CHECK(memcmp(s->tmin, t->tmin, sizeof s->tmin) == 0 &&
                  memcmp(s->tmax, t->tmax, sizeof s->tmax) == 0,
              "interval of group %u", i);
    }
}

static void check_alike(const plt_packet *p, const plt_packet *q) {
    const plt_slab_array *a = &p->slabs, *b = &q->slabs;
    CHECK(p->active == q->active && p->axis == q->axis && p->along == q->along &&
              a->coherence == b->coherence,
          "axis %u, coherence %u; by groups %u, %u", p->axis, a->coherence, q->axis, b->coherence);
    CHECK(memcmp(a->near_org, b->near_org, sizeof a->near_org) == 0 &&
              memcmp(a->far_org, b->far_org, sizeof a->far_org) == 0 &&
              memcmp(a->backwards, b->backwards, sizeof a->backwards) == 0 &&
              memcmp(a->negative, b->negative, sizeof a->negative) == 0 &&
              memcmp(p->org, q->org, sizeof p->org) == 0 && p->reach == q->reach &&
              p->least_slack == q->least_slack && p->least_sure == q->least_sure,
          "what the first ray decides");
    check_groups(p, q);
}

/* One ray of a packet made odd, or of two signs, or of another axis; or none. */
static void make_one_odd(subject *s, random_state *r) {
    static const float odd[] = {NAN, INFINITY, -INFINITY, 3e38f, -0.0f, 1e-30f, -1e-3f};
    plt_ray *ray = &s->rays[random_below(r, s->count)];
    const float value = odd[random_below(r, sizeof odd / sizeof odd[0])];
    switch (random_below(r, 5)) {
    case 0:
        ray->org[random_below(r, 3)] = value;
        break;
    case 1:
        ray->dir[random_below(r, 3)] = value;
        break;
    case 2:
        ray->tmin = value;
        break;
    case 3:
        ray->tmax = value;
        break;
    default:
        break;
    }
}

static void test_plain(void) {
    static subject s;
    static plt_packet groups, glance;
    static _Alignas(16) unsigned char memory[sizeof s.memory];
    random_state r = {77};
    unsigned plain = 0, unbounded = 0;
    for (int i = 0; i < 4 * PACKETS; i++) {
        make_subject(&s, &r, i & 1, i >> 1 & 1, 0);
        make_one_odd(&s, &r);
        set_groups(&s, &groups, memory);
        plt_packet_init(&glance, s.memory, s.side);
        plt_packet_begin(&glance, &s.scene, (s.count + 3) / 4, 0);
        if (plt_packet_set_plain(&glance, s.rays, s.count)) {
            check_alike(&glance, &groups);
            plain++;
            unbounded += glance.unbounded;
        }
    }
    printf("    %u of %d packets are plain, %u seek hits anywhere\n", plain, 4 * PACKETS,
           unbounded);
    CHECK(plain > PACKETS && unbounded > PACKETS / 2 && plain > unbounded + PACKETS / 2, "too few");
}

static void check_narrowed(const subject *s) {
    const plt_packet *p = &s->packet;
    for (unsigned i = 0; i < p->first_group; i++) {
        for (unsigned lane = 0; lane < 4; lane++) {
            unsigned from = plt_hull_below(i, lane), to = from;
            for (; from < p->first_group; from = plt_hull_below(from, 0)) {
                to = plt_hull_below(to, 3);
            }
            double most = -INFINITY;
            for (unsigned g = from - p->first_group; g <= to - p->first_group; g++) {
                for (unsigned k = 0; k < 4 && p->active >> g & 1u; k++) {
                    most = fmax(most, (double)p->slabs.group[g].tmax[k] *
                                          fabs((double)p->rays[g].dir[p->axis][k]));
                }
            }
            const double has = (double)p->hull[i].slabs.tmax[lane];
            CHECK(has >= most, "hull %u, lane %u: up to %g of %g", i, lane, has, most);
            CHECK(most < 0 || has <= most * 1.00001, "hull %u, lane %u: %g is too much for %g", i,
                  lane, has, most);
        }
    }
}

static void test_narrowed(void) {
    static subject s;
    random_state r = {99};
    unsigned packets = 0;
    for (int i = 0; i < PACKETS; i++) {
        if (!make_packet(&s, &r, i & 1, i >> 1 & 1)) {
            continue;
        }
        packets++;
        check_narrowed(&s);
        for (int round = 0; round < 6; round++) {
            for (plt_mask m = s.packet.active; m != 0; m &= m - 1) {
                const unsigned group = plt_mask_first(m);
                float *tmax = s.packet.slabs.group[group].tmax;
                for (unsigned k = 0; k < 4 && random_below(&r, 3) == 0; k++) {
                    tmax[k] = fminf(tmax[k], random_float(&r, 0.2f, 2.0f));
                    s.packet.changed |= plt_mask_of(group, 1);
                }
            }
            plt_hulls_narrow(&s.packet);
            check_narrowed(&s);
        }
    }
    CHECK(packets > PACKETS / 4, "too few");
}

int main(void) {
    test("what a ray of one origin meets, every hull above it meets, no deeper");
    test_boxes(0, 0, 1.6);
    test("... of mixed signs, where each plane that is near to some ray counts");
    test_boxes(0, 1, 1.6);
    test("... of many origins");
    test_boxes(1, 0, 3.5);
    test("... and of mixed signs");
    test_boxes(1, 1, 3.5);
    test("packets that are set up at a glance are as they are group by group");
    test_plain();
    test("after hits hulls reach as far as the rays of each lane do, and no further");
    test_narrowed();
    return test_done();
}

#else

int main(void) {
    test("without lanes in registers, or with packets of 2 x 2 alone, there are no hulls");
    CHECK(plt_hull_count(PLT_PACKET_SIDE_MAX) == 0, "%u", (unsigned)PLT_PACKET_SIDE_MAX);
    return test_done();
}

#endif
