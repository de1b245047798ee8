/* test_grid_fuzz - random scenes through a grid against the same through a tree, bit for bit
 *
 * Scenes of all shapes that are bad for cells, at scales of 2^-30 to 2^30 and far from 0, in arenas
 * from just the need on, with triangles that move; rays of all kinds in one array, so that packets
 * are coherent or not. PLANELET_SOAK=1 makes a hundred times as many scenes.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "tests/reference/grid_rig.h"
#include "tests/reference/grid_scenes.h"
#include "tests/reference/mover.h"

enum { SCENES = 60, RAYS = 320, MOVES = 2 };

/* What has happened, so that a test says if it no longer tests what it should. */
static struct { unsigned long scenes, hits, rays, crowded, one_cell, many_cells, moved; } tally;

/* ---- rays -------------------------------------------------------------------------- */

typedef struct aim {
    const mesh *m;
    const plt_grid *grid;
    float lo[3], hi[3], longest;
} aim;

static aim aim_of(const mesh *m, const grid_rig *g) {
    aim a = {.m = m, .grid = grid_of(g)};
    shape_box(m, a.lo, a.hi);
    for (int i = 0; i < 3; i++) {
        a.longest = fmaxf(a.longest, a.hi[i] - a.lo[i]);
    }
    a.longest = a.longest > 0.0f ? a.longest : 1.0f;
    return a;
}

static float near_to(float x, random_state *r) {
    const unsigned way = random_below(r, 6);
    return way == 0 ? nextafterf(x, INFINITY) : way == 1 ? nextafterf(x, -INFINITY) : x;
}

/* A corner of a cell, or of the scene's box, or almost. */
static void cell_corner(const aim *a, float p[3], random_state *r) {
    const plt_grid_level *l = &a->grid->top;
    for (int i = 0; i < 3; i++) {
        p[i] = near_to(l->lo[i] + (float)random_below(r, l->cells[i] + 1) * l->size[i], r);
    }
}

static void vertex_of(const aim *a, float p[3], random_state *r) {
    const uint32_t triangle = random_below(r, (uint32_t)a->m->triangles);
    memcpy(p, shape_corner(a->m, triangle, random_below(r, 3)), 3 * sizeof *p);
}

static void inside(const aim *a, float p[3], random_state *r) {
    random_point(r, a->lo, a->hi, p);
}

static void around(const aim *a, float p[3], random_state *r) {
    const float off = a->longest * ldexpf(1.0f, (int)random_below(r, 12) - 8);
    for (int i = 0; i < 3; i++) {
        p[i] = random_float(r, a->lo[i] - off, a->hi[i] + off);
    }
}

/* Up to 2^20 scenes away, or as far as origins may be. */
static void far_away(const aim *a, float p[3], random_state *r) {
    const float off = a->longest * ldexpf(1.0f, (int)random_below(r, 20));
    const unsigned axis = random_below(r, 3);
    around(a, p, r);
    p[axis] += random_below(r, 2) ? off : -off;
    p[axis] = fminf(fmaxf(p[axis], -PLT_COORD_MAX), PLT_COORD_MAX);
}

static void some_point(const aim *a, float p[3], random_state *r) {
    static void (*const ways[])(const aim *, float[3], random_state *) = {
        cell_corner, vertex_of, inside, around, around, far_away};
    ways[random_below(r, 6)](a, p, r);
}

/* Components become zeros of either sign; what is left is no ray if it is nothing. */
static void flatten_ray(plt_ray *ray, random_state *r) {
    const unsigned keep = 1 + random_below(r, 6);
    for (unsigned i = 0; i < 3; i++) {
        if ((keep >> i & 1u) == 0) {
            ray->dir[i] = random_below(r, 2) ? -0.0f : 0.0f;
        }
    }
}

/* What rays in a row have in common. */
enum sort { ONE_ORIGIN, PARALLEL, ONE_END, APART, SORTS };

static uint32_t add_rays(plt_ray *rays, uint32_t most, const aim *a, random_state *r) {
    const enum sort sort = (enum sort)random_below(r, SORTS);
    const uint32_t count = 1 + random_below(r, most < 96 ? most : 96);
    const int is_flat = random_below(r, 4) == 0, is_back = random_below(r, 4) == 0;
    const float width = a->longest * ldexpf(1.0f, -(int)random_below(r, 16));
    const float length = ldexpf(1.0f, random_below(r, 3) == 0 ? (int)random_below(r, 60) - 30 : 0);
    float org[3], end[3];
    some_point(a, org, r);
    some_point(a, end, r);
    for (uint32_t i = 0; i < count; i++) {
        float from[3], to[3];
        memcpy(from, org, sizeof from);
        memcpy(to, end, sizeof to);
        for (int k = 0; k < 3; k++) {
            const float off = random_float(r, -width, width);
            from[k] += sort == PARALLEL || sort == ONE_END ? off : 0.0f;
            to[k] += sort == PARALLEL || sort == ONE_ORIGIN ? off : 0.0f;
        }
        if (sort == APART) {
            some_point(a, from, r);
            some_point(a, to, r);
        }
        rays[i] = ray_between(from, to);
        if (is_flat) {
            flatten_ray(&rays[i], r);
        }
        for (int k = 0; k < 3; k++) {
            rays[i].dir[k] *= is_back && sort == APART ? -length : length;
        }
    }
    return count;
}

/* Intervals that end at a hit, or begin at one, or just beside it, or anywhere. */
static void limit_rays(plt_ray *rays, const plt_hit *hits, random_state *r) {
    for (uint32_t i = 0; i < RAYS; i++) {
        const float t = hits[i].triangle == PLT_MISS ? random_float(r, 0.0f, 2.0f) : hits[i].t;
        switch (random_below(r, 6)) {
        case 0:
            rays[i].tmax = near_to(t, r);
            break;
        case 1:
            rays[i].tmin = near_to(t, r);
            break;
        case 2:
            rays[i].tmin = rays[i].tmax = t;
            break;
        case 3:
            rays[i].tmin = 0.5f * t;
            rays[i].tmax = random_below(r, 2) ? INFINITY : 2.0f * t;
            break;
        case 4:
            rays[i].tmin = -1.0f;
            rays[i].tmax = 0.0f;
            break;
        default:
            break;
        }
    }
}

/* ---- what is to be the same ---------------------------------------------------------- */

static void compare_hits(grid_rig *g, const plt_ray *rays, plt_hit *due, const char *name) {
    static plt_hit hits[RAYS];
    for (int any = 1; any >= 0; any--) {
        uint32_t wrong = 0;
        CHECK(plt_trace(g->engine, rays, hits, RAYS, any) == PLT_OK, "%s", name);
        CHECK(plt_trace(g->tree.engine, rays, due, RAYS, any) == PLT_OK, "%s", name);
        for (uint32_t i = 0; i < RAYS; i++) {
            wrong += memcmp(&hits[i], &due[i], sizeof *hits) != 0;
            tally.hits += !any && due[i].triangle != PLT_MISS;
        }
        tally.rays += !any ? RAYS : 0;
        CHECK(wrong == 0, "%s, any %d: %u hits differ", name, any, wrong);
    }
}

static void compare(grid_rig *g, const mesh *m, random_state *r, const char *name) {
    static plt_ray rays[RAYS];
    static plt_hit hits[RAYS];
    const aim a = aim_of(m, g);
    for (unsigned times = 0; times < 2; times++) {
        for (uint32_t i = 0; i < RAYS;) {
            i += add_rays(rays + i, RAYS - i, &a, r);
        }
        compare_hits(g, rays, hits, name);
        limit_rays(rays, hits, r);
        compare_hits(g, rays, hits, name);
    }
}

/* ---- scenes -------------------------------------------------------------------------- */

/* Few triangles may be a list, which is slow. */
static rig_config config_of(const mesh *m, random_state *r) {
    const uint32_t nodes = rig_is_tiny() ? 1 : 1 + random_below(r, 32);
    const uint8_t build = (uint8_t)random_below(r, m->triangles < 60 ? 3 : 2);
    rig_config c = rig_config_of(1 + random_below(r, 4), nodes, build, (uint8_t)random_below(r, 2));
    c.run.packet_side = (uint8_t)(2u << random_below(r, 4));
    if (c.run.packet_side > PLT_PACKET_SIDE_MAX) {
        c.run.packet_side = PLT_PACKET_SIDE_MAX;
    }
    c.run.movable = (uint8_t)random_below(r, 2);
    c.run.moves_some = (uint8_t)(c.run.movable && random_below(r, 2));
    return c;
}

/* With a byte less than the need there is no engine, and it is said what would do. */
static void refuse_less(const grid_rig *g, const rig_config *config, const char *name) {
    plt_options o = config->run;
    plt_engine *e = NULL;
    plt_fault fault;
    o.structure = PLT_STRUCTURE_GRID;
    const plt_source source = rig_source(&g->tree.image);
    const size_t need = plt_arena_need(&g->tree.image.info, 1, &o);
    unsigned char *arena = aligned_alloc(PLT_ALIGN, (need + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN);
    memset(arena, 0x5A, need);
    const int status = plt_open(&e, arena, need - 1, &source, &o, &fault);
    CHECK(status == PLT_ERR_ARENA && e == NULL && fault.need_bytes == need,
          "%s: need %zu, status %d, %zu", name, need, status, (size_t)fault.need_bytes);
    CHECK(arena[need - 1] == 0x5A, "%s: written behind the arena", name);
    free(arena);
}

static int move_both(grid_rig *g, const mesh *m, float bad) {
    float(*corners)[9] = mover_corners(m);
    plt_fault fault;
    if (bad != 0.0f) {
        corners[m->triangles / 2][4] = bad;
    }
    const int status = plt_move(g->engine, (const float(*)[9])corners, &g->fault);
    CHECK(plt_move(g->tree.engine, (const float(*)[9])corners, &fault) == status, "%s",
          fault.message);
    free(corners);
    return status;
}

/* A move that is refused changes nothing; one that is not makes the grid anew. */
static void move(grid_rig *g, mesh *m, random_state *r, const char *name) {
    for (unsigned i = 0; i < MOVES; i++) {
        static const float bad[] = {NAN, INFINITY, 2.0f * PLT_COORD_MAX};
        if (random_below(r, 3) == 0) {
            CHECK(move_both(g, m, bad[random_below(r, 3)]) == PLT_ERR_ARGUMENT, "%s", name);
            compare(g, m, r, name);
        }
        grid_scene_deform(m, grid_of(g), r);
        CHECK(move_both(g, m, 0.0f) == PLT_OK, "%s: %s", name, g->fault.message);
        compare(g, m, r, name);
        tally.moved++;
    }
}

static void fuzz(uint64_t seed) {
    random_state r = {seed};
    mesh m = {0};
    grid_rig g;
    char name[80];
    const unsigned kind = grid_scene_make(&m, &r);
    const rig_config c = config_of(&m, &r);
    const size_t spare = random_below(&r, 3) == 0 ? 0 : random_below(&r, 120) * m.triangles;
    snprintf(name, sizeof name, "seed %lu, scene of kind %u", (unsigned long)seed, kind);
    if (grid_rig_open(&g, &m, &c, spare)) {
        const uint32_t cells = plt_grid_cells(&grid_of(&g)->top);
        tally.scenes++;
        tally.crowded += grid_of(&g)->crowded_count > 0;
        tally.one_cell += cells == 1;
        tally.many_cells += cells > m.triangles / 4;
        refuse_less(&g, &c, name);
        compare(&g, &m, &r, name);
        if (c.run.movable) {
            move(&g, &m, &r, name);
        }
    }
    grid_rig_close(&g);
    mesh_free(&m);
}

int main(int argc, char **argv) {
    const char *soak = getenv("PLANELET_SOAK");
    const uint64_t first = argc > 1 ? strtoull(argv[1], NULL, 10) : 0;
    const uint64_t scenes = argc > 1 ? 1 : SCENES * (soak != NULL && soak[0] == '1' ? 100u : 1u);
    test("random scenes and rays: hits through a grid are those of a tree, also after moves");
    for (uint64_t i = 0; i < scenes; i++) {
        fuzz(first + i);
    }
    test("... of many cells and of one, with crowded ones, and rays that hit and do not");
    CHECK(
        argc > 1 || rig_is_tiny() ||
            (tally.crowded >= scenes / 32 && tally.one_cell >= scenes / 8 &&
             tally.many_cells >= scenes / 8 && tally.moved >= scenes / 2 &&
             tally.hits >= tally.rays / 8 && tally.hits <= tally.rays * 7 / 8),
        "%lu scenes, %lu with crowded cells, %lu of one cell, %lu of many, %lu moves, %lu hits of "
        "%lu rays",
        tally.scenes, tally.crowded, tally.one_cell, tally.many_cells, tally.moved, tally.hits,
        tally.rays);
    if (soak != NULL) {
        printf(
            "    %lu scenes, %lu with crowded cells, %lu of one cell, %lu of many, %lu moves, "
            "%lu hits of %lu rays\n",
            tally.scenes, tally.crowded, tally.one_cell, tally.many_cells, tally.moved, tally.hits,
            tally.rays);
    }
    return test_done();
}
