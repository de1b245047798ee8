/* test_grid - packets through a grid against the same through a tree, and against every triangle
 *
 * Hits and frames are the same, bit for bit, whatever the grid: in arenas of every size, of scenes
 * that are flat, thin, huge, crowded, empty or have moved.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "engine/trace/grid_state.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/frames.h"
#include "tests/reference/grid_rig.h"
#include "tests/reference/rays.h"
#include "tests/reference/shapes.h"

enum { RAYS = 384, ROOMY = 200 }; /* bytes per triangle: enough for every cell that is wanted */

/* ---- scenes ------------------------------------------------------------------------ */

/* A floor, and a small ball that lies in a cell or two of it. */
static void stadium(mesh *m) {
    shape_icosphere(m, rig_is_tiny() ? 0 : 3);
    shape_transform(m, 0.02f, 13.3f, 0.05f, -7.7f);
    mesh floor = {0};
    shape_sheet(&floor, rig_is_tiny() ? 2 : 16, 1);
    shape_transform(&floor, 50.0f, 0.0f, 0.0f, 0.0f);
    const uint32_t first = (uint32_t)m->vertices;
    fail f = {""};
    mesh_reserve(m, m->vertices + floor.vertices, m->triangles + floor.triangles, &f);
    memcpy(m->vertex + 3 * m->vertices, floor.vertex, 12 * floor.vertices);
    for (size_t i = 0; i < 3 * floor.triangles; i++) {
        m->triangle[3 * m->triangles + i] = first + floor.triangle[i];
    }
    m->vertices += floor.vertices;
    m->triangles += floor.triangles;
    mesh_free(&floor);
}

/* Triangles as long as the scene, across each other. */
static void spokes(mesh *m, uint32_t triangles) {
    random_state r = {triangles};
    shape_soup(m, triangles, 0.01f, 5);
    for (size_t i = 0; i < m->triangles; i++) {
        float *v = m->vertex + 3 * (size_t)m->triangle[3 * i];
        for (int a = 0; a < 3; a++) {
            v[a] = random_float(&r, -1.0f, 1.0f);
        }
    }
}

enum { SCENES = 20 };

static void flat_soup(mesh *m, uint32_t triangles) {
    shape_soup(m, triangles, 0.2f, 3);
    for (size_t i = 0; i < m->vertices; i++) {
        m->vertex[3 * i + 2] = 0.125f;
    }
}

static mesh make(unsigned scene) {
    mesh m = {0};
    const uint32_t many = rig_triangles(900, 2);
    switch (scene) {
    case 0:
        shape_soup(&m, many, 0.1f, 1);
        break;
    case 1:
        shape_soup(&m, many, 1.0f, 2);
        break;
    case 2: /* all in few cells */
        shape_soup(&m, rig_triangles(400, 2), 3.0f, 3);
        break;
    case 3:
    case 4:
    case 5:
        shape_sheet(&m, rig_is_tiny() ? 2 : 15, (int)scene - 3);
        break;
    case 6:
        shape_needles(&m, 40);
        break;
    case 7:
        shape_coincident(&m, rig_is_tiny() ? 9 : 150);
        break;
    case 8:
        shape_degenerate(&m);
        break;
    case 9:
        shape_exponential(&m, 40);
        break;
    case 10:
        shape_soup(&m, many, 0.1f, 4);
        shape_transform(&m, 1e11f, 2e11f, -3e11f, 0.0f);
        break;
    case 11: /* corners are coarser than cells */
        shape_soup(&m, many, 0.1f, 5);
        shape_transform(&m, 1.0f, 1e6f, -1e6f, 1e7f);
        break;
    case 12:
        shape_soup(&m, many, 0.1f, 6);
        shape_transform(&m, 1e-20f, 0.0f, 0.0f, 0.0f);
        break;
    case 13:
        stadium(&m);
        break;
    case 14:
        spokes(&m, rig_triangles(300, 2));
        break;
    case 15:
        flat_soup(&m, rig_triangles(300, 2));
        break;
    case 16:
    case 17:
        shape_soup(&m, scene - 15, 1.0f, 7);
        break;
    case 18:
        shape_icosphere(&m, rig_is_tiny() ? 0 : 4);
        break;
    default:
        shape_cube(&m);
    }
    return m;
}

/* ---- rays -------------------------------------------------------------------------- */

/* Along planes between cells and through their corners, as exactly as floats allow. */
static void rays_cells(plt_ray *rays, uint32_t count, const plt_grid *g, random_state *r) {
    for (uint32_t i = 0; i < count; i++) {
        float from[3], to[3];
        for (int a = 0; a < 3; a++) {
            const uint32_t cells = g->top.cells[a];
            const float size = g->top.size[a];
            from[a] = g->top.lo[a] + (float)random_below(r, cells + 1) * size;
            to[a] = random_below(r, 2) ? from[a]
                                       : g->top.lo[a] + (float)random_below(r, cells + 1) * size;
        }
        rays[i] = ray_between(from, to);
        const float *d = rays[i].dir;
        if (fabsf(d[0]) + fabsf(d[1]) + fabsf(d[2]) < 1e-15f) {
            rays[i].dir[i % 3] = i % 2 ? 1.0f : -1.0f;
        }
    }
}

/* From where others hit towards one light, or anywhere. */
static void rays_from_hits(plt_ray *rays, const plt_hit *hits, uint32_t count, int to_light,
                           random_state *r) {
    const float light[3] = {0.3f, 2.5f, -0.7f};
    for (uint32_t i = 0; i < count; i++) {
        plt_ray *ray = &rays[i];
        const float t = hits[i].triangle == PLT_MISS ? 0.0f : hits[i].t;
        for (int a = 0; a < 3; a++) {
            ray->org[a] += t * ray->dir[a];
            ray->dir[a] = to_light ? light[a] - ray->org[a] : random_float(r, -1.0f, 1.0f);
        }
        ray->tmin = i % 3 == 0 ? 1e-3f : 0.0f;
        ray->tmax = to_light ? 1.0f : RAYS_FAR;
    }
}

static void make_rays(plt_ray *rays, unsigned kind, const mesh *m, const plt_grid *g,
                      random_state *r) {
    switch (kind) {
    case 0:
        rays_camera(rays, RAYS, m, r);
        break;
    case 1:
        rays_mixed(rays, RAYS, m, r);
        break;
    case 2:
        rays_edges(rays, RAYS, m, r);
        break;
    default:
        rays_cells(rays, RAYS, g, r);
    }
}
enum { KINDS = 4 };

/* ---- what is to be the same -------------------------------------------------------- */

static void compare_rays(const grid_rig *g, const plt_ray *rays, uint32_t count, const char *name) {
    static plt_hit grid[RAYS], tree[RAYS];
    for (int any = 0; any < 2; any++) {
        uint32_t wrong = 0;
        CHECK(plt_trace(g->engine, rays, grid, count, any) == PLT_OK, "%s", name);
        CHECK(plt_trace(g->tree.engine, rays, tree, count, any) == PLT_OK, "%s", name);
        for (uint32_t i = 0; i < count; i++) {
            wrong += memcmp(&grid[i], &tree[i], sizeof *grid) != 0;
        }
        CHECK(wrong == 0, "%s, %u rays, any %d: %u hits differ", name, count, any, wrong);
    }
}

static void compare_kind(grid_rig *g, const mesh *m, unsigned kind, random_state *r,
                         const char *name) {
    static plt_ray rays[RAYS];
    static plt_hit hits[RAYS];
    static const uint32_t some[] = {1, 3, 5, 64, 67, 255};
    make_rays(rays, kind, m, grid_of(g), r);
    compare_rays(g, rays, RAYS, name);
    for (unsigned i = 0; i < sizeof some / sizeof *some; i++) {
        compare_rays(g, rays + random_below(r, RAYS - 255), some[i], name);
    }
    for (int to_light = 1; to_light >= 0; to_light--) {
        plt_trace(g->tree.engine, rays, hits, RAYS, 0);
        rays_from_hits(rays, hits, RAYS, to_light, r);
        compare_rays(g, rays, RAYS, name);
    }
}

static void compare_frames(grid_rig *g, const char *name) {
    static const float from[3] = {0.3f, 0.4f, 1.1f};
    const plt_info *info = plt_engine_info(g->engine);
    float eye[3], look[3];
    for (int a = 0; a < 3; a++) {
        look[a] = 0.5f * (info->lo[a] + info->hi[a]);
        eye[a] = look[a] + from[a] * (info->hi[0] - info->lo[0]);
    }
    for (uint8_t shader = 0; shader <= PLT_SHADE_TRIANGLE; shader++) {
        const plt_frame f = frame_of(eye, look, 53, 47, shader);
        const uint64_t tree = frame_hash(g->tree.engine, &f, 500);
        CHECK(frame_hash(g->engine, &f, 0xFFFFFFFFu) == tree, "%s: frame", name);
        CHECK(frame_hash(g->engine, &f, 1) == tree, "%s: frame in the smallest steps", name);
    }
}

/* Every triangle within its box is a reference of each cell that its box reaches into. */
static void check_cells(const grid_rig *g, const char *name) {
    const plt_grid *grid = grid_of(g);
    const plt_grid_level *top = &grid->top;
    const uint32_t cells = top->cells[0] * top->cells[1] * top->cells[2];
    uint64_t sum = 0;
    for (uint32_t i = 0; i < g->engine->scene.gridded.count; i++) {
        const plt_box b = plt_record_box(&g->engine->scene.gridded.records[i]);
        uint64_t reached = 1;
        for (int a = 0; a < 3; a++) {
            const float lo = (b.lo[a] - top->lo[a]) * top->scale[a];
            const float hi = (b.hi[a] - top->lo[a]) * top->scale[a];
            const uint32_t last = top->cells[a] - 1;
            const uint32_t from = lo < (float)last ? (uint32_t)lo : last;
            const uint32_t to = hi < (float)last ? (uint32_t)hi : last;
            reached *= to - from + 1;
        }
        sum += reached;
    }
    CHECK(sum == grid->references && top->start[cells] == sum && top->start[0] == 0,
          "%s: %u references, %llu are due", name, grid->references, (unsigned long long)sum);
    CHECK(grid->bytes <= g->engine->grid_bytes &&
              (unsigned char *)g->engine->grid_room + g->engine->grid_bytes <= g->arena + g->bytes,
          "%s: it lies in its room", name);
}

/* A slice's rectangle is that of its occupied cells, no larger. */
static void check_rectangles(const plt_grid *grid, const char *name) {
    const plt_grid_level *top = &grid->top;
    for (int a = 0; a < 3; a++) {
        const int x = (a + 1) % 3, y = (a + 2) % 3;
        for (uint32_t slice = 0; slice < top->cells[a]; slice++) {
            plt_grid_rect due = {{UINT16_MAX, UINT16_MAX}, {0, 0}};
            for (uint32_t i = 0; i < top->cells[x] * top->cells[y]; i++) {
                const uint16_t at[2] = {(uint16_t)(i % top->cells[x]),
                                        (uint16_t)(i / top->cells[x])};
                const uint32_t *start =
                    &top->start[slice * top->stride[a] + at[0] * top->stride[x] +
                                at[1] * top->stride[y]];
                for (int k = 0; k < 2 && start[0] != start[1]; k++) {
                    due.lo[k] = at[k] < due.lo[k] ? at[k] : due.lo[k];
                    due.hi[k] = at[k] > due.hi[k] ? at[k] : due.hi[k];
                }
            }
            CHECK(memcmp(&due, &grid->rect[a][slice], sizeof due) == 0, "%s: axis %d, slice %u",
                  name, a, slice);
        }
    }
}

static void compare(grid_rig *g, const mesh *m, unsigned kinds, const char *name) {
    random_state r = {m->triangles};
    check_cells(g, name);
    check_rectangles(grid_of(g), name);
    for (unsigned kind = 0; kind < kinds; kind++) {
        char text[120];
        snprintf(text, sizeof text, "%s, rays %u", name, kind);
        compare_kind(g, m, kind, &r, text);
    }
    compare_frames(g, name);
}

static rig_config config_of(unsigned i) {
    rig_config c = rig_config_of(1 + i % 3, rig_is_tiny() ? 1 : 16, i % 2, i / 2 % 2);
    c.run.packet_side = (uint8_t)(2u << i % 4);
    if (c.run.packet_side > PLT_PACKET_SIDE_MAX) {
        c.run.packet_side = PLT_PACKET_SIDE_MAX;
    }
    return c;
}

static void every_scene(void) {
    for (unsigned scene = 0; scene < SCENES; scene++) {
        for (unsigned side = 0; side < 4; side += 2) {
            const rig_config c = config_of(side + scene);
            mesh m = make(scene);
            grid_rig g;
            char name[80];
            snprintf(name, sizeof name, "scene %u, packets of %u", scene, c.run.packet_side);
            if (grid_rig_open(&g, &m, &c, ROOMY * m.triangles)) {
                compare(&g, &m, KINDS, name);
            }
            grid_rig_close(&g);
            mesh_free(&m);
        }
    }
}

/* The box of a level's triangles. */
static plt_box box_of_level(const grid_rig *g, const plt_grid_level *l) {
    plt_box box = plt_box_empty();
    for (uint32_t i = 0; i < l->start[plt_grid_cells(l)]; i++) {
        const plt_box b = plt_record_box(&g->engine->scene.gridded.records[l->reference[i]]);
        plt_box_add(&box, &b);
    }
    return box;
}

/* A level reaches beyond its cell by more than what planes are off by, if its triangles do: 2e-4
 * of the cell, and 2 u of its coordinates. */
static void check_level(const grid_rig *g, uint32_t cell, const plt_grid_level *l) {
    const plt_grid_level *top = &grid_of(g)->top;
    const plt_box items = box_of_level(g, l);
    for (int a = 0; a < 3; a++) {
        const uint32_t at = cell / top->stride[a] % top->cells[a];
        const double size = (double)top->size[a], lo = (double)top->lo[a] + at * size;
        const double off = 2e-4 * size + 1.2e-7 * fmax(fabs(lo), fabs(lo + size));
        const double end = (double)l->lo[a] + (double)l->size[a] * l->cells[a];
        const double rounding = 1e-7 * (double)l->size[a] * l->cells[a];
        CHECK((double)l->lo[a] <= fmax((double)items.lo[a], lo - off) &&
                  end + rounding >= fmin((double)items.hi[a], lo + size + off),
              "axis %d of cell %u", a, cell);
    }
}

/* Only a stadium has cells in a cell, and it has to; one is at 0, one so far away that coordinates
 * are coarse. */
static void crowded_cells(void) {
    for (unsigned i = 0; i < 2; i++) {
        const rig_config c = config_of(3);
        mesh m = make(13);
        grid_rig g;
        uint32_t levels = 0;
        shape_transform(&m, 1.0f, i * -4e5f, i * 3e5f, i * 2e5f);
        if (grid_rig_open(&g, &m, &c, ROOMY * m.triangles)) {
            const plt_grid *grid = grid_of(&g);
            CHECK(rig_is_tiny() || grid->crowded_count > 0, "no cell is crowded");
            for (uint32_t cell = 0; cell < plt_grid_cells(&grid->top); cell++) {
                const uint32_t first = grid->top.start[cell], end = grid->top.start[cell + 1];
                if (first < end && (grid->top.reference[first] & PLT_GRID_CROWDED) != 0) {
                    check_level(&g, cell, &grid->crowded[levels++]);
                }
            }
            CHECK(levels == grid->crowded_count, "%u levels", levels);
            compare(&g, &m, KINDS, "a stadium");
        }
        grid_rig_close(&g);
        mesh_free(&m);
    }
}

/* A large triangle that rays of one origin graze: t is so far off that a hit may be ahead of the
 * origin, whose exact point is behind it, where the rays' bounds do not hold. All corners are
 * beyond one of them. Returns how many such hits there are. */
static uint32_t graze(const grid_rig *g, float cosine, float sine) {
    plt_ray rays[16];
    plt_hit hits[16];
    uint32_t count = 0;
    for (unsigned i = 0; i < 16; i++) {
        const float slope = -(float)i / 15.0f, org[3] = {0, 0, 0};
        const float dir[3] = {slope * cosine, slope * sine, 1};
        rays[i] = ray_make(org, dir, 0.0f, RAYS_FAR);
    }
    compare_rays(g, rays, 16, "grazing rays");
    plt_trace(g->tree.engine, rays, hits, 16, 0);
    for (unsigned i = 0; i < 16; i++) {
        count += hits[i].triangle != PLT_MISS;
    }
    return count;
}

/* The plane is y = slope (z + behind), turned about z, so that its normal is rounded; two corners
 * are beyond the bound along x at their depths, by little more than what is left to it. */
static mesh grazed(float cosine, float sine, random_state *r) {
    const float slope = random_float(r, 2.5e-4f, 6e-4f), behind = random_float(r, 5e-5f, 3e-4f);
    const float end = random_float(r, 0.5f, 1.0f), depth[3] = {-end, end, -end};
    mesh m = {0};
    fail f = {""};
    for (int k = 0; k < 3; k++) {
        const float z = depth[k], y = slope * (z + behind);
        const float x = k == 2 ? -end : -z + (sine * y - 2e-5f) / cosine;
        mesh_add_vertex(&m, cosine * x - sine * y, sine * x + cosine * y, z, &f);
    }
    mesh_add_triangle(&m, 0, 1, 2, &f);
    return m;
}

static void behind_origins(void) {
    const rig_config c = config_of(3);
    random_state r = {5};
    uint32_t found = 0;
    for (unsigned i = 0; i < 400; i++) {
        const float turned = random_float(&r, 0.2f, 1.2f), cosine = cosf(turned),
                    sine = sinf(turned);
        mesh m = grazed(cosine, sine, &r);
        grid_rig g;
        if (grid_rig_open(&g, &m, &c, ROOMY)) {
            found += graze(&g, cosine, sine);
        }
        grid_rig_close(&g);
        mesh_free(&m);
    }
    CHECK(found > 0, "no hit is ahead of a point behind");
}

/* From an arena of just the need to one with room for all. */
static void every_arena(void) {
    static const unsigned scenes[] = {0, 1, 13, 14}; /* 1 and 14: of long triangles */
    for (unsigned i = 0; i < 4; i++) {
        uint32_t cells = 0, most = 0;
        for (size_t spare = 0; spare <= 128; spare = 2 * spare + 4) {
            const rig_config c = config_of(i + (unsigned)spare);
            mesh m = make(scenes[i]);
            grid_rig g;
            char name[80];
            snprintf(name, sizeof name, "scene %u, %u bytes per triangle", scenes[i],
                     (unsigned)spare);
            if (grid_rig_open(&g, &m, &c, spare * m.triangles)) {
                const uint32_t *n = grid_of(&g)->top.cells;
                CHECK(spare > 0 || n[0] * n[1] * n[2] == 1, "%s: more than one cell", name);
                CHECK(n[0] * n[1] * n[2] >= cells, "%s: more room, fewer cells", name);
                cells = n[0] * n[1] * n[2];
                most = (uint32_t)m.triangles;
                compare(&g, &m, KINDS, name);
            }
            grid_rig_close(&g);
            mesh_free(&m);
        }
        const uint32_t due = PLT_GRID_TRIANGLE_BYTES < 64 ? 1 : i % 2 ? 8 : most / 4;
        CHECK(cells > due, "scene %u: %u cells at last", scenes[i], cells);
    }
}

/* Against the list of all triangles, which no box is before. */
static void brute_force(void) {
    for (unsigned scene = 0; scene < SCENES; scene++) {
        rig_config c = config_of(scene);
        c.pack.build = PLT_BUILD_NONE;
        mesh m = make(scene);
        grid_rig g;
        if (m.triangles < 500 && grid_rig_open(&g, &m, &c, ROOMY * m.triangles)) {
            compare(&g, &m, KINDS, "a list");
            grid_rig_close(&g);
        }
        mesh_free(&m);
    }
}

/* ---- triangles that move ------------------------------------------------------------ */

static void deform(mesh *m, unsigned way, random_state *r) {
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        float *p = &m->vertex[i];
        switch (way) {
        case 0:
            *p += random_float(r, -0.02f, 0.02f);
            break;
        case 1:
            *p = random_float(r, -30.0f, 30.0f);
            break;
        case 2:
            *p = i % 3 == 1 ? 0.25f : *p;
            break;
        case 3:
            *p = *p * 1e6f + 1e11f;
            break;
        default:
            *p = 0.5f;
        }
    }
}

static int move_to(plt_engine *e, const mesh *m, plt_fault *fault) {
    float(*corners)[9] = malloc((m->triangles + 1) * sizeof *corners);
    for (uint32_t i = 0; i < m->triangles; i++) {
        for (unsigned k = 0; k < 3; k++) {
            memcpy(&corners[i][3 * k], shape_corner(m, i, k), 3 * sizeof(float));
        }
    }
    const int status = plt_move(e, (const float(*)[9])corners, fault);
    free(corners);
    return status;
}

/* Both are moved: that a tree is then as one that is packed anew, test_move says. */
static void moved(void) {
    for (unsigned i = 0; i < 12; i++) {
        rig_config c = config_of(i);
        c.run.movable = 1;
        mesh m = {0};
        grid_rig g;
        random_state r = {i};
        shape_soup(&m, rig_triangles(i * i * i / 4, 2), 0.2f, i);
        if (grid_rig_open(&g, &m, &c, (i % 3 == 0 ? 0 : 20 * (i % 3)) * m.triangles)) {
            for (unsigned way = 0; way < 5; way++) {
                char name[40];
                snprintf(name, sizeof name, "%u, way %u", i, way);
                deform(&m, way, &r);
                CHECK(move_to(g.engine, &m, &g.fault) == PLT_OK, "%s", g.fault.message);
                CHECK(move_to(g.tree.engine, &m, &g.fault) == PLT_OK, "%s", g.fault.message);
                if (m.triangles > 0) {
                    compare(&g, &m, 2, name);
                }
            }
        }
        grid_rig_close(&g);
        mesh_free(&m);
    }
}

static void empty_scene(void) {
    const rig_config c = config_of(2);
    const plt_ray ray = {{0, 0, -5}, 0, {0, 0, 1}, RAYS_FAR};
    plt_hit hit = {1, 1, 1, 1};
    mesh m = {0};
    grid_rig g;
    if (grid_rig_open(&g, &m, &c, 0)) {
        CHECK(plt_trace(g.engine, &ray, &hit, 1, 0) == PLT_OK && hit.triangle == PLT_MISS, "a hit");
        compare_frames(&g, "empty");
    }
    grid_rig_close(&g);
}

/* Rays that are none hit nothing, and keep no other from its hit. */
static void odd_rays(void) {
    static const float odd[] = {NAN, INFINITY, -INFINITY, 1e30f, 0.0f};
    static plt_ray rays[RAYS];
    for (unsigned i = 0; i < 4; i++) {
        const rig_config c = config_of(i);
        mesh m = make(0);
        grid_rig g;
        random_state r = {i};
        if (grid_rig_open(&g, &m, &c, ROOMY * m.triangles)) {
            rays_camera(rays, RAYS, &m, &r);
            for (uint32_t k = 0; k < RAYS; k += 1 + random_below(&r, 9)) {
                float *const part = random_below(&r, 2) ? rays[k].org : rays[k].dir;
                part[random_below(&r, 3)] = odd[random_below(&r, 5)];
                rays[k].tmax = random_below(&r, 4) ? rays[k].tmax : -1.0f;
            }
            compare_rays(&g, rays, RAYS, "odd rays");
        }
        grid_rig_close(&g);
        mesh_free(&m);
    }
}

/* Marks of bundles have 32 bits: after the last comes the first, and nothing has it. */
static void marks_run_out(void) {
    for (unsigned i = 0; i < 4; i++) {
        const rig_config c = config_of(i);
        mesh m = make(0);
        grid_rig g;
        if (grid_rig_open(&g, &m, &c, ROOMY * m.triangles)) {
            plt_grid_state *s = plt_grid_state_of(&g.engine->traversal);
            compare(&g, &m, KINDS, "marks from 1 on");
            CHECK(s->stamp > 100, "%u bundles", s->stamp);
            s->stamp = UINT32_MAX - 20;
            compare(&g, &m, KINDS, "marks from 1 on again");
            CHECK(s->stamp < UINT32_MAX - 20, "the last mark was not passed");
        }
        grid_rig_close(&g);
        mesh_free(&m);
    }
}

static void refusals(void) {
    const rig_config c = config_of(1);
    mesh m = make(0);
    rig r;
    CHECK(rig_open(&r, &m, &c) == PLT_OK, "%s", r.fault.message);
    const plt_info *info = &r.image.info;
    plt_options o = c.run;
    o.structure = 2;
    CHECK(plt_arena_need(info, 1, &o) == 0, "an unknown structure");
    o.structure = PLT_STRUCTURE_GRID;
    CHECK(plt_arena_need(info, 1, &o) > 0, "a grid");
    o.residency = PLT_RESIDENCY_STREAMED;
    CHECK(plt_arena_need(info, 0, &o) == 0, "a streamed scene");
    o.residency = PLT_RESIDENCY_WHOLE;
    o.rays_in_flight = 32;
    CHECK(plt_arena_need(info, 1, &o) > 0, "a wave, which goes in packets");
    o.wide = 1;
    CHECK(plt_arena_need(info, 1, &o) == 0, "a wide form");
    o.wide = o.rays_in_flight = 0;
    o.order = PLT_ORDER_TWO_STAGE;
    CHECK(plt_arena_need(info, 1, &o) == 0, "two stages");
    rig_close(&r);
    compact_config blocks = compact_config_of(2, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    blocks.run.structure = PLT_STRUCTURE_GRID;
    CHECK(compact_open(&r, &m, &blocks) == PLT_ERR_ARGUMENT && strstr(r.fault.message, "records"),
          "%s", r.fault.message);
    rig_close(&r);
    mesh_free(&m);
}

/* ---- patches ------------------------------------------------------------------------ */

/* Bounds that are no numbers of cells are not made whole. */
static void patches(void) {
    static const struct {
        float from, to;
        int there;
    } at[8] = {{-1e30f, 1e30f, 1}, {1e30f, 2e30f, 0}, {-2e30f, -1e30f, 0}, {1.5f, -1e30f, 0},
               {1e30f, 2.0f, 0},   {NAN, 2.0f, 0},    {1.0f, NAN, 0},      {2.9f, 3.1f, 1}};
    for (unsigned i = 0; i < 8; i++) {
        plt_grid_patch p = {{-7, -7}, {-7, -7}};
        const int there = plt_grid_between(&p, 1, at[i].from, at[i].to, 5.0f);
        const int32_t from = there ? (at[i].from > 0.0f ? 2 : 0) : -7;
        const int32_t to = there ? (at[i].to < 5.0f ? 3 : 5) : -7;
        CHECK(there == at[i].there && p.from[1] == from && p.to[1] == to && p.from[0] == -7,
              "from %g to %g: %d, cells %d to %d", (double)at[i].from, (double)at[i].to, there,
              p.from[1], p.to[1]);
    }
}

int main(void) {
    test("cells between two bounds, however far they are");
    patches();
    test("a grid: hits and frames of all scenes and packets are a tree's");
    every_scene();
    test("... and those of a list of all triangles");
    brute_force();
    test("a cell that is crowded has cells of its own");
    crowded_cells();
    test("hits ahead of an origin whose exact point is behind it");
    behind_origins();
    test("a grid is as coarse as the arena wants it, down to one cell");
    every_arena();
    test("triangles move, and the grid is made anew");
    moved();
    test("a scene without triangles");
    empty_scene();
    test("marks of bundles begin anew");
    marks_run_out();
    test("rays that are none");
    odd_rays();
    test("what has no grid is refused");
    refusals();
    return test_done();
}
