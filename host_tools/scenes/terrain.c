/* terrain - a height field of mountain ridges, valleys and a valley floor
 *
 * A ridged fractal whose finer ridges show only where coarser ones are
 * high, on a ground bent by a slower noise, above broad uplands; valleys
 * wind along the zeros of another noise. Neighbouring quads share their
 * vertices.
 *
 * Source: F. K. Musgrave in D. Ebert et al., "Texturing and Modeling: A
 * Procedural Approach", 3rd ed., 2003, chapter 16 (ridged multifractal).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/counts.h"
#include "host_tools/scenes/noise.h"

#define HALF 10.0
#define OCTAVES 10u
#define SCALE 0.13 /* coarsest ridges per unit of length */

static double clamp01(double x) {
    return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x;
}

/* About 0 .. 1.5. Each octave is rotated by the angle of the 3-4-5 triangle:
 * the axes of the octaves' grids do not coincide. */
static double ridges(double x, double z, unsigned octaves) {
    double sum = 0.0, share = 0.6, weight = 1.0;
    for (unsigned i = 0; i < octaves; i++) {
        const double n = noise_gradient(x, z, 100 + i);
        const double fold = 1.0 - 1.6 * (n < 0.0 ? -n : n);
        const double ridge = (fold < 0.0 ? 0.0 : fold * fold) * weight;
        sum += share * ridge;
        weight = clamp01(1.8 * ridge);
        share *= 0.5;
        const double rotated = 2.03 * (0.8 * x - 0.6 * z);
        z = 2.03 * (0.6 * x + 0.8 * z);
        x = rotated;
    }
    return sum;
}

static double height(double x, double z, unsigned octaves) {
    const double u = SCALE * x, v = SCALE * z;
    const double bent_u = u + 0.35 * noise_gradient(1.3 * u + 7.1, 1.3 * v + 2.9, 1);
    const double bent_v = v + 0.35 * noise_gradient(1.3 * u + 3.7, 1.3 * v + 9.2, 2);
    const double upland = clamp01(0.5 + 0.9 * noise_gradient(0.9 * bent_u, 0.9 * bent_v, 3));
    const double river = noise_gradient(0.6 * bent_u + 0.2, 0.6 * bent_v + 0.6, 4);
    const double bank = clamp01(0.05 + 5.0 * (river < 0.0 ? -river : river));
    const double valley = bank * bank * (3.0 - 2.0 * bank); /* 0 along the river */
    const double h =
        valley * (0.5 * upland + (0.25 + 1.1 * upland) * ridges(bent_u, bent_v, octaves));
    /* Below `low` the land flattens smoothly into the valley floor. */
    const double low = 0.6;
    return 2.6 * (h > low ? h - 0.5 * low : 0.5 * h * h / low);
}

/* Octaves finer than the grid would only be noise: two quads per wave. */
static unsigned octaves_for(uint32_t columns) {
    unsigned octaves = 1;
    double waves = 2.0 * HALF * SCALE;
    while (octaves < OCTAVES && 4.0 * waves < columns) {
        waves *= 2.03;
        octaves++;
    }
    return octaves;
}

static int add(mesh *m, uint32_t first, uint32_t columns, uint32_t rows, fail *f) {
    const unsigned octaves = octaves_for(columns);
    for (uint32_t k = 0; k <= rows; k++) {
        const double z = HALF * (2.0 * k / rows - 1.0);
        for (uint32_t i = 0; i <= columns; i++) {
            const double x = HALF * (2.0 * i / columns - 1.0);
            if (mesh_add_vertex(m, (float)x, (float)height(x, z, octaves), (float)z, f)) {
                return -1;
            }
        }
    }
    for (uint32_t k = 0; k < rows; k++) {
        for (uint32_t i = 0; i < columns; i++) {
            const uint32_t a = first + k * (columns + 1) + i, b = a + columns + 1;
            if (mesh_add_triangle(m, a, b, b + 1, f) || mesh_add_triangle(m, a, b + 1, a + 1, f)) {
                return -1;
            }
        }
    }
    return 0;
}

int scene_terrain(mesh *m, uint64_t triangles, fail *f) {
    const size_t vertices = m->vertices, before = m->triangles;
    if (count_check(m, "terrain", triangles, 2, SCENE_TRIANGLES_MAX, f)) {
        return -1;
    }
    const uint32_t columns = count_root(triangles / 2);
    const uint32_t rows = (uint32_t)(triangles / 2 / columns);
    if (add(m, (uint32_t)vertices, columns, rows, f) == 0) {
        return 0;
    }
    m->vertices = vertices;
    m->triangles = before;
    return -1;
}
