/* test_trace_brute - every configuration against every triangle in double
 *
 * All packets, orders, K, N, builders and builds must agree bit for bit with the list of all
 * triangles, and that list with the reference.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/scenes/scenes.h"
#include "tests/reference/brute.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

#define MIXED 1200u
#define RAYS 1600u
#define SCENES 18

static const char *const scene_name[SCENES] = {
    "soup",         "fine soup",     "soup, 1e-6",      "soup, 1e6", "soup far away", "cube",
    "icosphere",    "sheet x",       "sheet y",         "sheet z",   "coincident",    "degenerate",
    "one triangle", "two triangles", "three triangles", "needles",   "exponential",   "knot"};

static void place_soup(mesh *m, int scene) {
    shape_soup(m, scene == 1 ? 128 : 90, scene == 1 ? 0.1f : 0.8f, (uint64_t)scene + 7);
    if (scene == 2) {
        shape_transform(m, 1e-6f, 0.0f, 0.0f, 0.0f);
    } else if (scene == 3) {
        shape_transform(m, 1e6f, 0.0f, 0.0f, 0.0f);
    } else if (scene == 4) {
        shape_transform(m, 1.0f, 1000.0f, -3000.0f, 20.0f);
    }
}

static mesh make(int scene) {
    mesh m = {0};
    fail f = {""};
    switch (scene) {
    case 5:
        shape_cube(&m);
        break;
    case 6:
        shape_icosphere(&m, 1);
        break;
    case 7:
    case 8:
    case 9:
        shape_sheet(&m, 6, scene - 7);
        break;
    case 10:
        shape_coincident(&m, 9);
        break;
    case 11:
        shape_degenerate(&m);
        break;
    case 12:
    case 13:
    case 14:
        shape_soup(&m, (uint32_t)scene - 11, 1.0f, 99);
        break;
    case 15:
        shape_needles(&m, 12);
        break;
    case 16:
        shape_exponential(&m, 40);
        break;
    case 17:
        scene_knot(&m, 128, &f);
        break;
    default:
        place_soup(&m, scene);
    }
    return m;
}

typedef struct trial {
    mesh m;
    plt_ray rays[RAYS];
    plt_hit hits[RAYS]; /* of the list of all triangles */
    const char *name;
} trial;

static trial trial_of(int scene) {
    trial t = {.m = make(scene), .name = scene_name[scene]};
    random_state r = {(uint64_t)scene + 1};
    rays_mixed(t.rays, MIXED, &t.m, &r);
    rays_edges(t.rays + MIXED, RAYS - MIXED, &t.m, &r);
    rig one;
    const rig_config config = rig_config_of(1, 1, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    CHECK(rig_open(&one, &t.m, &config) == PLT_OK, "%s: %s", t.name, one.fault.message);
    if (one.engine != NULL) {
        plt_trace(one.engine, t.rays, t.hits, RAYS, 0);
    }
    rig_close(&one);
    return t;
}

static void against_reference(const trial *t, uint32_t *hits, uint32_t *unsure) {
    for (uint32_t i = 0; i < RAYS; i++) {
        int open = 0;
        const plt_hit *h = &t->hits[i];
        const char *wrong = brute_objects(&t->m, &t->rays[i], h, &open);
        CHECK(wrong == NULL, "%s, ray %u: %s (triangle %u, t %g)", t->name, i, wrong, h->triangle,
              (double)h->t);
        *unsure += open && i < 2 * MIXED / 3; /* the others graze on purpose */
        *hits += h->triangle != PLT_MISS;
    }
}

static uint32_t same_hits(const trial *t, plt_engine *e) {
    plt_hit hits[RAYS];
    uint32_t wrong = 0;
    plt_trace(e, t->rays, hits, RAYS, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        wrong += memcmp(&hits[i], &t->hits[i], sizeof hits[i]) != 0;
    }
    return wrong;
}

static uint32_t compared, limited;

static void compare(const trial *t, const rig_config *config) {
    rig one;
    const int status = rig_open(&one, &t->m, config);
    if (status == PLT_ERR_LIMIT && rig_is_tiny()) {
        limited++;
    } else {
        CHECK(status == PLT_OK, "%s, %s: %s", t->name, rig_name(config), one.fault.message);
    }
    if (one.engine != NULL) {
        const uint32_t wrong = same_hits(t, one.engine);
        CHECK(wrong == 0, "%s, %s: %u hits differ", t->name, rig_name(config), wrong);
        compared++;
    }
    rig_close(&one);
}

static void compare_runs(const trial *t, rig_config config) {
    for (uint8_t order = 0; order < 2; order++) {
        for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
            config.run.packet_side = side;
            config.run.order = order;
            compare(t, &config);
        }
    }
}

static void compare_packings(const trial *t) {
    static const uint32_t nodes[3] = {2, 3, 64};
    for (uint32_t k = 1; k <= 4; k *= 2) {
        for (int n = 0; n < 3; n++) {
            for (uint8_t splits = 0; splits < 2; splits++) {
                compare_runs(t, rig_config_of(k, nodes[n], PLT_BUILD_HOST, splits));
                compare_runs(t, rig_config_of(k, nodes[n], PLT_BUILD_DEVICE, splits));
            }
        }
    }
    compare_runs(t, rig_config_of(1, 1, PLT_BUILD_NONE, PLT_SPLIT_SAH));
}

int main(void) {
    uint32_t hits = 0, unsure = 0;
    trial *t = malloc(SCENES * sizeof *t);
    test("every hit and miss agrees with testing all triangles in double precision");
    for (int i = 0; i < SCENES; i++) {
        t[i] = trial_of(i);
        against_reference(&t[i], &hits, &unsure);
    }
    test("the reference decides most rays, and many of them hit");
    CHECK(hits > SCENES * RAYS / 6, "%u hits of %u rays", hits, SCENES * RAYS);
    CHECK(unsure < SCENES * MIXED / 8, "%u of %u rays are undecided", unsure, SCENES * RAYS);
    printf("    %u rays, %u hits, %u undecided\n", SCENES * RAYS, hits, unsure);
    test("packet size, order, K, N, splits and build change no bit of any hit");
    for (int i = 0; i < SCENES; i++) {
        compare_packings(&t[i]);
        mesh_free(&t[i].m);
    }
    CHECK(compared > (rig_is_tiny() ? 100u : 5000u), "%u configurations compared", compared);
    printf("    %u configurations compared, %u beyond this build's limits\n", compared, limited);
    free(t);
    return test_done();
}
