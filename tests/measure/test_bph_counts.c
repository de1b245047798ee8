/* test_bph_counts [MESH...] - what the switches of the thesis's BPH give, counted
 *
 * Of each mesh three tables, of one view of all of it, 512 x 512 pixels: sizes, beside Tables 5.1
 * and 5.2 of the thesis where it has the scene (known by its file's name); packets by nodes,
 * triangles and masks, beside Table 5.4, by both ways to split; and one line for each switch.
 * Counts are the same every time. Without a MESH it takes a knot and is one test more.
 *
 * Source: Karrenberg 2007, chapter 5.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdlib.h>

#include "host_tools/baselines/bph/bph_trace.h"
#include "host_tools/baselines/structure.h"
#include "tests/measure/meshes.h"
#include "tests/reference/frame_rays.h"

static unsigned side = 512;

/* Tables 5.1, 5.2 and 5.4 (nodes, triangles, per cent masked out; by packets of 4x4, 8x8, 16x16),
 * and the nodes that follow from the first two. */
typedef struct printed {
    const char *name;
    uint32_t triangles, nodes, intermediates;
    double kilobytes, kilobytes_two;
    unsigned at_nodes[3], at_triangles[3], masked[3];
} printed;

static const printed thesis[] = {
    {"shuttle", 616, 378, 237, 12, 0.8, {6, 6, 2}, {1, 1, 3}, {10, 32, 57}},
    {"wooddoll", 5378, 3266, 2111, 105, 66, {8, 10, 7}, {1, 3, 9}, {31, 66, 86}},
    {"toasters", 11141, 6900, 4240, 221, 141, {22, 25, 13}, {4, 7, 18}, {20, 50, 76}},
    {"hand", 15855, 9700, 6154, 310, 198, {13, 17, 15}, {3, 6, 12}, {33, 67, 87}},
    {"bunny", 69451, 40149, 29301, 1285, 755, {16, 23, 35}, {4, 11, 82}, {48, 81, 94}},
    {"ben", 78029, 47161, 30867, 1509, 955, {12, 18, 30}, {3, 9, 53}, {48, 81, 94}},
    {"dragon", 871414, 541709, 329704, 17335, 10975, {26, 59, 162}, {11, 42, 473}, {69, 92, 98}},
};

static const printed *printed_of(const char *name, const mesh *m) {
    const char *slash = strrchr(name, '/');
    const char *file = slash != NULL ? slash + 1 : name;
    for (size_t i = 0; i < sizeof thesis / sizeof *thesis; i++) {
        const size_t length = strlen(thesis[i].name);
        if (strncmp(file, thesis[i].name, length) == 0 && m->triangles == thesis[i].triangles) {
            return &thesis[i];
        }
    }
    return NULL;
}

static built_structure *open_by(const char *text, const mesh *m) {
    structure_options o;
    fail f = {""};
    const structure_kind *kind = structure_read(text, "it", &o, &f);
    built_structure *s = kind != NULL ? structure_open(kind, m, &o, "it", &f) : NULL;
    CHECK(s != NULL, "%s: %s", text, f.text);
    return s;
}

/* ---- sizes ------------------------------------------------------------------------------ */

static structure_statistics print_size(const char *text, const mesh *m, double shown) {
    built_structure *s = open_by(text, m);
    const structure_statistics c = structure_count(s);
    printf("  %-22s %8" PRIu32 " %8" PRIu32 " %10" PRIu64 " %6.2f %5.1f", text, c.nodes,
           c.intermediates, c.bytes, (double)c.bytes / (double)m->triangles,
           100.0 * c.intermediates / c.leaves);
    if (shown > 0.0) {
        printf(" %8g %7.4f", shown, (double)c.bytes / 1000.0 / shown);
    }
    putchar('\n');
    structure_close(s);
    return c;
}

/* A scene that is the thesis's own has the thesis's tree, but for a few splits of equals. */
static void print_sizes(const mesh *m, const printed *p) {
    printf("  %-22s %8s %8s %10s %6s %5s %8s %7s\n", "", "nodes", "interm.", "bytes", "B/tri",
           "% lvs", "thesis K", "ratio");
    const structure_statistics one = print_size("bph:median", m, p != NULL ? p->kilobytes : 0.0);
    print_size("bph:median,unmerged", m, 0.0);
    print_size("bph:median,leaf-2", m, p != NULL ? p->kilobytes_two : 0.0);
    print_size("bph:median,leaf-4", m, 0.0);
    print_size("bph:median,counts", m, 0.0);
    print_size("bph:sah", m, 0.0);
    print_size("bph:sah,leaf-2", m, 0.0);
    print_size("bph:sah,counts", m, 0.0);
    if (p != NULL) {
        const double off = fabs((double)one.nodes / p->nodes - 1.0);
        printf("  the thesis: %" PRIu32 " nodes, %" PRIu32 " intermediate ones\n", p->nodes,
               p->intermediates);
        CHECK(one.nodes + one.intermediates + 1 == m->triangles, "nodes");
        CHECK(off < 0.03, "%" PRIu32 " nodes, the thesis %" PRIu32, one.nodes, p->nodes);
        CHECK(strcmp(p->name, "bunny") != 0 || off < 0.0005, "bunny: %" PRIu32 " nodes", one.nodes);
    }
}

/* ---- packets ---------------------------------------------------------------------------- */

static plt_hit *first_hits; /* all switches have the same */

static structure_statistics trace_by(const char *text, const mesh *m, const plt_ray *rays) {
    const uint32_t count = side * side;
    built_structure *s = open_by(text, m);
    plt_hit *hits = malloc(count * sizeof *hits);
    fail f = {""};
    CHECK(structure_trace(s, rays, hits, count, 0, &f) == 0, "%s", f.text);
    const structure_statistics c = structure_count(s);
    structure_close(s);
    if (first_hits == NULL) {
        first_hits = hits;
    } else {
        CHECK(memcmp(first_hits, hits, count * sizeof *hits) == 0, "%s: other hits", text);
        free(hits);
    }
    return c;
}

static double per(uint64_t x, uint64_t of) {
    return of > 0 ? (double)x / (double)of : 0.0;
}

static void print_beside(double ours, const unsigned *shown) {
    if (shown != NULL) {
        printf(" %7.1f %4u %5.2f", ours, *shown, *shown > 0 ? ours / *shown : 0.0);
    } else {
        printf(" %7.1f %4s %5s", ours, "-", "-");
    }
}

static void print_packets(const mesh *m, const plt_ray *rays, const printed *p) {
    static const char *const sides[3] = {"4x4", "8x8", "16x16"};
    printf("  %-22s %18s %18s %18s %18s %6s\n", "per packet, printed, x", "nodes", "triangles",
           "% out at triangles", "% out at nodes", "% sgn");
    for (int i = 0; i < 6; i++) {
        char text[40];
        snprintf(text, sizeof text, "bph:%s,%s", i < 3 ? "median" : "sah", sides[i % 3]);
        const structure_statistics c = trace_by(text, m, rays);
        printf("  %-22s", text);
        print_beside(per(c.packet_nodes, c.packets), p != NULL ? &p->at_nodes[i % 3] : NULL);
        print_beside(per(c.packet_triangles, c.packets),
                     p != NULL ? &p->at_triangles[i % 3] : NULL);
        print_beside(100.0 * per(c.masked_at_triangles, c.rays_at_triangles),
                     p != NULL ? &p->masked[i % 3] : NULL);
        print_beside(100.0 * per(c.masked_at_nodes, c.rays_at_nodes),
                     p != NULL ? &p->masked[i % 3] : NULL);
        printf(" %6.2f\n", 100.0 * per(c.one_sign, c.packets));
    }
}

/* ---- switches --------------------------------------------------------------------------- */

static void print_switches(const mesh *m, const plt_ray *rays) {
    static const char *const lines[] = {"bph:8x8",
                                        "bph:8x8,naive",
                                        "bph:8x8,range",
                                        "bph:8x8,all",
                                        "bph:8x8,mixed",
                                        "bph:8x8,left",
                                        "bph:8x8,frustum",
                                        "bph:8x8,early",
                                        "bph:8x8,early,frustum",
                                        "bph:8x8,early,frustum,range",
                                        "bph:8x8,early,frustum,naive",
                                        "bph:8x8,recompute",
                                        "bph:8x8,unmerged",
                                        "bph:8x8,leaf-2",
                                        "bph:8x8,leaf-2,recompute",
                                        "bph:8x8,leaf-4",
                                        "bph:8x8,counts",
                                        "bph:8x8,sah",
                                        "bph:8x8,sah,counts",
                                        "bph:8x8,sah,early,frustum"};
    printf("  %-28s %7s %7s %6s %8s %7s %7s %13s %13s %6s %6s\n", "", "nodes", "tri.", "% out",
           "dist/ray", "mat/ray", "tri/ray", "early hits", "frustum exits", "recon.", "recomp");
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        const structure_statistics c = trace_by(lines[i], m, rays);
        printf("  %-28s %7.1f %7.1f %6.1f %8.1f %7.2f %7.2f %6.1f/%6.1f %6.1f/%6.1f %6.2f %6.1f\n",
               lines[i], per(c.packet_nodes, c.packets), per(c.packet_triangles, c.packets),
               100.0 * per(c.masked_at_nodes, c.rays_at_nodes), per(c.box_tests, c.rays),
               per(c.plane_matches, c.rays), per(c.triangle_tests, c.rays),
               per(c.early_hits, c.packets), per(c.early_tests, c.packets),
               per(c.frustum_misses, c.packets), per(c.frustum_tests, c.packets),
               per(c.reconstructions, c.packets), per(c.recomputed, c.packets));
    }
}

/* What waits on the stack for a child, by packets. */
static void print_entries(void) {
    static const char *const lines[] = {"bph:4x4", "bph:16x16", "bph:16x16,range",
                                        "bph:16x16,early,frustum", "bph:16x16,naive"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        structure_options o;
        fail f = {""};
        CHECK(structure_read(lines[i], "it", &o, &f) != NULL, "%s", f.text);
        const bph_way way = bph_way_of(&o);
        printf("  %-28s %6" PRIu32 " bytes to a stack entry\n", lines[i],
               bph_trace_entry_bytes(&way, (uint32_t)o.packet_side * o.packet_side));
    }
}

static void measure(const mesh *m, const char *name) {
    const printed *p = printed_of(name, m);
    side = rig_is_tiny() ? 32 : m->triangles == 20000 ? 128 : 512;
    plt_ray *rays = frame_rays(m, side, 16);
    printf("%s: %zu triangles\n", name, m->triangles);
    print_sizes(m, p);
    print_packets(m, rays, p);
    print_switches(m, rays);
    print_entries();
    free(rays);
    free(first_hits);
    first_hits = NULL;
}

int main(int argc, char **argv) {
    return measure_meshes(argc, argv, "all switches of a BPH have the same hits in a view",
                          measure);
}
