/* test_camera_packet - packets of a camera, set up at a glance and shaded in lanes, are what each
 * group set up, and each pixel shaded, would be
 *
 * Cameras look in all directions, along axes and diagonals, too, through fields of all widths;
 * squares lie in the frame, or reach beyond it; some miss the scene, which no ray of theirs may
 * meet then. Normals are of all sizes, and 0.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "engine/shade/packet_shade.h"
#include "engine/trace/boxes.h"
#include "tests/reference/random.h"
#include "tests/test.h"

#if PLT_WITH_GROUPS

enum { CAMERAS = 20000, GROUPS = PLT_GROUPS_MAX, ROW_BYTES = 3 * PLT_PACKET_SIDE_MAX + 5 };

typedef struct subject {
    plt_frame frame;
    plt_view view;
    plt_pixels pixels;
    plt_box scene;
    plt_packet got, due;
    int is_plain; /* a view of few values: how many packets are left out is not counted */
    _Alignas(16) unsigned char got_memory[64 * 1024], due_memory[64 * 1024];
} subject;

typedef struct counts {
    unsigned packets, at_axis[4], mixed, cut, missed, in_vain;
} counts;

static float of_few(random_state *r) {
    return (float)((int)random_below(r, 5) - 2);
}

/* Directions of few values and of all lengths, none among them: some are largest along two axes,
 * some are no directions. */
static void make_plain_view(subject *s, random_state *r) {
    const float scale = ldexpf(1.0f, (int)random_below(r, 4) ? 0 : (int)random_below(r, 126) - 63);
    plt_view *v = &s->view;
    s->frame.width = s->frame.height = 20;
    for (int a = 0; a < 3; a++) {
        v->eye[a] = of_few(r);
        v->corner[a] = scale * of_few(r);
        v->right[a] = scale * of_few(r) / 16;
        v->down[a] = scale * of_few(r) / 16;
    }
}

/* PLT_ERR_ARGUMENT now and then. */
static int make_view(subject *s, random_state *r) {
    plt_camera *c = &s->frame.camera;
    const int is_plain = random_below(r, 3) == 0;
    for (int a = 0; a < 3; a++) {
        c->eye[a] = is_plain ? of_few(r) : random_float(r, -3.0f, 3.0f);
        c->look[a] = is_plain ? of_few(r) : random_float(r, -3.0f, 3.0f);
        c->up[a] = is_plain ? of_few(r) : random_float(r, -1.0f, 1.0f);
        s->scene.lo[a] = -1.0f;
        s->scene.hi[a] = 1.0f;
    }
    c->tan_half_fov = ldexpf(random_float(r, 0.5f, 1.0f), (int)random_below(r, 24) - 12);
    s->frame.width = (uint16_t)(1 + random_below(r, 700));
    s->frame.height = (uint16_t)(1 + random_below(r, 700));
    s->frame.shader = (uint8_t)(random_below(r, 4) == 0 ? random_below(r, 3) : PLT_SHADE_EYELIGHT);
    const int status = plt_view_set(&s->view, &s->frame);
    s->is_plain = random_below(r, 4) == 0;
    if (status == PLT_OK && s->is_plain) {
        make_plain_view(s, r);
    }
    return status;
}

static void make_square(subject *s, random_state *r) {
    plt_pixels *p = &s->pixels;
    p->side = 2u << random_below(r, PLT_PACKET_SIDE_MAX >= 16 ? 4 : 1);
    p->x_end = s->frame.width;
    p->y_end = s->frame.height;
    p->x = random_below(r, p->x_end) / p->side * p->side;
    p->y = random_below(r, p->y_end) / p->side * p->side;
}

/* Group by group. */
static void set_due(subject *s) {
    const plt_pixels *p = &s->pixels;
    plt_packet_begin(&s->due, &s->scene, p->side * p->side / 4, 0);
    plt_packet_want_normals(&s->due);
    for (uint32_t k = 0; k < p->side * p->side; k += 4) {
        float dir[3][4], tmax[4];
        f4 org[3];
        for (uint32_t i = 0; i < 4; i++) {
            const uint32_t x = p->x + plt_z_order_x(k + i), y = p->y + plt_z_order_y(k + i);
            float one[3];
            plt_view_direction(&s->view, x, y, one);
            for (int a = 0; a < 3; a++) {
                dir[a][i] = one[a];
                org[a] = f4_all(s->view.eye[a]);
            }
            tmax[i] = x < p->x_end && y < p->y_end ? PLT_VIEW_FAR : -1.0f;
        }
        const f4 d[3] = {f4_load(dir[0]), f4_load(dir[1]), f4_load(dir[2])};
        plt_packet_set_group(&s->due, k / 4, org, d, f4_zero(), f4_load(tmax), 4);
    }
    plt_packet_finish(&s->due);
}

static int same_group(const subject *s, unsigned i) {
    const plt_group_rays *g = &s->got.rays[i], *d = &s->due.rays[i];
    const plt_group_slabs *gs = &s->got.slabs.group[i], *ds = &s->due.slabs.group[i];
    if (g->valid != d->valid || memcmp(g->id, d->id, sizeof g->id) != 0) {
        return 0;
    }
    return g->valid == 0 || (memcmp(g->org, d->org, sizeof g->org) == 0 &&
                             memcmp(g->dir, d->dir, sizeof g->dir) == 0 &&
                             memcmp(g->slope, d->slope, sizeof g->slope) == 0 &&
                             memcmp(g->axis_lanes, d->axis_lanes, sizeof g->axis_lanes) == 0 &&
                             memcmp(gs->tmin, ds->tmin, sizeof gs->tmin) == 0 &&
                             memcmp(gs->tmax, ds->tmax, sizeof gs->tmax) == 0);
}

static int same_packet(const subject *s) {
    const plt_packet *g = &s->got, *d = &s->due;
    if (g->active != d->active || g->groups != d->groups || g->any != d->any ||
        g->axis != d->axis || g->slabs.coherence != d->slabs.coherence) {
        return 0;
    }
#if PLT_WITH_HULLS
    if (g->along != d->along || g->surfaces != d->surfaces ||
        (g->active != 0 && memcmp(&g->least_sure, &d->least_sure, sizeof g->least_sure) != 0)) {
        return 0;
    }
#endif
    return g->active == 0 || (memcmp(g->org, d->org, sizeof g->org) == 0 &&
                              memcmp(&g->reach, &d->reach, sizeof g->reach) == 0 &&
                              memcmp(&g->least_slack, &d->least_slack, sizeof g->reach) == 0);
}

/* A packet that was left out has no group that meets the scene's box, or no ray. */
static int meets(subject *s) {
    plt_packet_make_ready(&s->due);
    return plt_box_groups(&s->due.slabs, &s->scene, s->due.active) != 0;
}

static void check_packet(subject *s, counts *c) {
    plt_view_packet(&s->view, &s->scene, &s->got, &s->pixels);
    set_due(s);
    if (PLT_WITH_HULLS && s->got.active == 0) {
        CHECK(s->due.active == 0 || !meets(s), "a packet of side %u at %u, %u may not be left out",
              s->pixels.side, s->pixels.x, s->pixels.y);
        c->missed += !s->is_plain;
        return;
    }
    CHECK(same_packet(s), "a packet of side %u at %u, %u differs", s->pixels.side, s->pixels.x,
          s->pixels.y);
    for (unsigned i = 0; i < s->due.groups; i++) {
        CHECK(same_group(s, i), "group %u of side %u at %u, %u differs", i, s->pixels.side,
              s->pixels.x, s->pixels.y);
    }
    c->packets++;
    c->in_vain += !s->is_plain && !meets(s);
    c->at_axis[s->due.axis]++;
    c->mixed += s->due.slabs.coherence == PLT_MIXED;
    c->cut += s->pixels.x + s->pixels.side > s->pixels.x_end;
}

/* Some pixels miss, some triangles are slivers. */
static void make_hits(plt_packet *p, random_state *r) {
    for (unsigned i = 0; i < p->groups; i++) {
        plt_group_rays *g = &p->rays[i];
        const uint32_t misses = random_below(r, 3);
        for (int lane = 0; lane < 4; lane++) {
            const float size = ldexpf(1.0f, (int)random_below(r, 150) - 100);
            const int none = random_below(r, 10) == 0;
            for (int a = 0; a < 3; a++) {
                g->normal[a][lane] = none ? 0.0f : random_float(r, -size, size);
            }
            if ((g->valid >> lane & 1) != 0 && random_below(r, 2) >= misses) {
                g->id[lane] = random_below(r, 1000);
            }
        }
    }
}

static void due_colour(const subject *s, uint32_t k, const uint8_t *sky, uint8_t rgb[3]) {
    const plt_group_rays *g = &s->got.rays[k / 4];
    const unsigned lane = k % 4;
    if (s->got.active == 0 || g->id[lane] == PLT_MISS) {
        memcpy(rgb, sky, 3);
        return;
    }
    const float normal[3] = {g->normal[0][lane], g->normal[1][lane], g->normal[2][lane]};
    const float dir[3] = {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]};
    plt_surface surface;
    plt_surface_set(&surface, normal);
    plt_surface_colour(&surface, s->frame.shader, g->id[lane], dir, rgb);
}

/* Nothing but the pixels of the frame is written. */
static void check_colours(subject *s, random_state *r) {
    uint8_t got[ROW_BYTES * PLT_PACKET_SIDE_MAX], due[sizeof got], sky[3 * PLT_PACKET_SIDE_MAX];
    for (unsigned i = 0; i < sizeof sky; i++) {
        sky[i] = (uint8_t)random_below(r, 256);
    }
    memset(got, 0xA5, sizeof got);
    memset(due, 0xA5, sizeof due);
    if (s->got.active != 0) {
        make_hits(&s->got, r);
    }
    plt_packet_shade(&s->got, &s->frame, &s->pixels, sky, got, ROW_BYTES);
    for (uint32_t k = 0; k < s->pixels.side * s->pixels.side; k++) {
        const uint32_t x = plt_z_order_x(k), y = plt_z_order_y(k);
        if (s->pixels.x + x < s->pixels.x_end && s->pixels.y + y < s->pixels.y_end) {
            due_colour(s, k, &sky[3 * y], &due[y * ROW_BYTES + 3 * x]);
        }
    }
    CHECK(memcmp(got, due, sizeof got) == 0, "colours of side %u, shader %u differ", s->pixels.side,
          s->frame.shader);
}

int main(void) {
    static subject s;
    random_state r = {20261129};
    counts c = {0};
    const unsigned few = PLT_PACKET_SIDE_MAX < 16 ? 20 : 100; /* rays of small squares agree */
    test("a packet of a camera is what its groups would be, its colours what its pixels would");
    for (int i = 0; i < CAMERAS; i++) {
        if (make_view(&s, &r) != PLT_OK) {
            continue;
        }
        make_square(&s, &r);
        plt_packet_init(&s.got, s.got_memory, s.pixels.side);
        plt_packet_init(&s.due, s.due_memory, s.pixels.side);
        check_packet(&s, &c);
        check_colours(&s, &r);
    }
    CHECK(c.packets > CAMERAS / 4 && c.mixed > few && c.cut > 20, "%u packets, %u mixed, %u cut",
          c.packets, c.mixed, c.cut);
    CHECK(!PLT_WITH_HULLS || (c.missed > 10 * c.in_vain && c.missed > 1000),
          "%u packets were left out, %u might have been", c.missed, c.in_vain);
    CHECK(c.at_axis[0] > 100 && c.at_axis[1] > 100 && c.at_axis[2] > 100 && c.at_axis[3] > few,
          "axes %u %u %u, differ %u", c.at_axis[0], c.at_axis[1], c.at_axis[2], c.at_axis[3]);
    return test_done();
}

#else

int main(void) {
    return test_done();
}

#endif
