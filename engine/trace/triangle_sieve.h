/* triangle_sieve - which groups may meet a triangle
 *
 * Edge functions are put together otherwise here than those that decide (triangle_hits.h), from
 * what groups have in common; their errors are no larger, or the slack is, so that no ray that
 * meets the triangle is left out (DESIGN.md, section 7.8).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_TRIANGLE_SIEVE_H
#define PLT_TRACE_TRIANGLE_SIEVE_H

#include "engine/trace/packet.h"
#include "engine/trace/triangle_record.h"

/* In all lanes, the component along axis z and along the two after it. */
PLT_INLINED void spread(f4 to[3], f4 v, int z) {
    const f4 x = f4_lane(v, 0), y = f4_lane(v, 1), w = f4_lane(v, 2);
    to[0] = z == 0 ? y : z == 1 ? w : x;
    to[1] = z == 0 ? w : z == 1 ? x : y;
    to[2] = z == 0 ? x : z == 1 ? y : w;
}

/* A triangle made ready for it, in all lanes. */
typedef struct sieve {
    f4 row[3][3]; /* PER_PACKET: of each edge function what belongs to both slopes, and the rest;
                     PER_GROUP: corner 0, and the edges from it to both others */
    f4 slack;
} sieve;

/* n of edge functions n . (slopes, 1), for corner x edge; the components of a product come out
 * as z, x, y. */
PLT_INLINED void set_plane(f4 to[3], f4 corner, f4 edge, int z) {
    const f4 n = f4_sub(f4_mul(corner, f4_turn(edge)), f4_mul(f4_turn(corner), edge));
    spread(to, n, z == 2 ? 0 : z + 1);
}

PLT_INLINED void set_sieve(sieve *s, const f4 c[3], const plt_packet *p, int z,
                           enum sharing sharing) {
    if (sharing == PER_GROUP) {
        spread(s->row[0], c[0], z);
        spread(s->row[1], f4_sub(c[1], c[0]), z);
        spread(s->row[2], f4_sub(c[2], c[0]), z);
        return;
    }
    const f4 org = f4_load(p->org);
    set_plane(s->row[0], f4_sub(c[2], org), f4_sub(c[1], c[2]), z);
    set_plane(s->row[1], f4_sub(c[0], org), f4_sub(c[2], c[0]), z);
    set_plane(s->row[2], f4_sub(c[1], org), f4_sub(c[0], c[1]), z);
}

/* Lanes that may meet the triangle; with `surely` in the next four bits those that surely do, in
 * front or behind: no edge function is as close to 0 as its error. */
PLT_INLINED unsigned passes(const sieve *s, f4 v, f4 w, f4 x, int surely) {
    const f4 least = f4_min(f4_min(v, w), x), most = larger3(v, w, x), below = f4_neg(s->slack);
    const unsigned may = m4_mask(m4_or(f4_le(below, least), f4_le(most, s->slack)));
    return surely ? may | m4_mask(m4_or(f4_lt(s->slack, least), f4_lt(most, below))) << 4 : may;
}

/* Lanes of one origin that may meet the triangle. */
PLT_INLINED unsigned sift_packet(const sieve *s, const plt_group_rays *g, int surely) {
    const f4 slope_x = f4_load(g->slope[0]), slope_y = f4_load(g->slope[1]);
    f4 weight[3];
    PLT_UNROLLED for (int i = 0; i < 3; i++) {
        weight[i] = f4_add(f4_mul(slope_x, s->row[i][0]),
                           f4_add(f4_mul(slope_y, s->row[i][1]), s->row[i][2]));
    }
    return passes(s, weight[0], weight[1], weight[2], surely);
}

/* ... of any origins: corner 0 and both edges are sheared; the edge functions follow from their
 * products. */
PLT_INLINED unsigned sift_group(const sieve *s, const plt_group_rays *g, int z) {
    const int ax = plt_axis_after[z], ay = plt_axis_after[ax];
    const f4 slope_x = f4_load(g->slope[0]), slope_y = f4_load(g->slope[1]);
    const f4 depth = f4_sub(s->row[0][2], f4_load(g->org[z]));
    f4 x[3], y[3];
    x[0] = f4_sub(f4_sub(s->row[0][0], f4_load(g->org[ax])), f4_mul(slope_x, depth));
    y[0] = f4_sub(f4_sub(s->row[0][1], f4_load(g->org[ay])), f4_mul(slope_y, depth));
    PLT_UNROLLED for (int i = 1; i < 3; i++) {
        x[i] = f4_sub(s->row[i][0], f4_mul(slope_x, s->row[i][2]));
        y[i] = f4_sub(s->row[i][1], f4_mul(slope_y, s->row[i][2]));
    }
    const f4 v = cross(x[0], y[0], x[2], y[2]), w = cross(x[1], y[1], x[0], y[0]);
    return passes(s, v, w, f4_sub(f4_sub(cross(x[2], y[2], x[1], y[1]), v), w), 0);
}

/* What it writes of a group: its number, and above that lanes as they passed. */
enum { SIFTED_LANES = 64 };

/* Writes `tag` + what each group that may meet it is, from `to` on. Returns how many there are; one
 * more may have been written. Nothing depends on which they are but what is written: a jump that
 * is taken for one group in three is mostly foreseen wrong. */
PLT_INLINED unsigned sift(const sieve *s, const plt_group_rays *rays, plt_mask groups, int z,
                          enum sharing sharing, int surely, unsigned tag, uint32_t *to) {
    const sieve kept = *s;
    unsigned count = 0;
    for (; groups != 0; groups &= groups - 1) {
        const unsigned index = plt_mask_first(groups);
        const plt_group_rays *g = &rays[index];
        const unsigned lanes =
            sharing == PER_PACKET ? sift_packet(&kept, g, surely) : sift_group(&kept, g, z);
        to[count] = tag + index + (surely ? SIFTED_LANES * lanes : 0);
        count += lanes != 0;
    }
    return count;
}

#endif
