/* test_pack_poses - a tree for all frames is a tree, is better for them, and gives the same hits
 *
 * What it costs in a frame is computed here once more, from the finished image's links and the
 * frame's triangles.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/heap.h"
#include "host_tools/pack/list_tree.h"
#include "host_tools/pack/poses.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/mover.h"

enum { FRAMES_MOST = 24 };

typedef struct film {
    mesh frame[FRAMES_MOST];
    uint32_t frames;
    poses poses;
} film;

/* ---- what a tree costs ------------------------------------------------------------ */

typedef struct whole {
    const plt_node *nodes;
    const plt_record *records;
    const mesh *m;
    double areas; /* of all inner nodes, intermediate ones included */
} whole;

/* Returns the record behind the list. */
static uint32_t add_list(const whole *w, uint32_t at, plt_box *box) {
    for (;; at++) {
        const uint32_t id = plt_primitive_id(plt_get_u32(&w->records[at].word[9]));
        for (unsigned c = 0; c < 3; c++) {
            plt_box_add_point(box, shape_corner(w->m, id, c));
        }
        if (plt_record_is_last(&w->records[at])) {
            return at + 1;
        }
    }
}

/* Where the frame's triangles are, whatever the image's planes say. */
static plt_box box_below(whole *w, uint32_t link) {
    plt_box box = plt_box_empty();
    if (plt_link_is_leaf(link)) {
        const uint32_t second = add_list(w, plt_link_index(link), &box);
        if (plt_link_lists(link) == 1) {
            return box;
        }
        add_list(w, second, &box);
    } else {
        for (int c = 0; c < 2; c++) {
            const plt_box child = box_below(w, plt_node_link(&w->nodes[plt_link_index(link)], c));
            plt_box_add(&box, &child);
        }
    }
    w->areas += list_tree_half_area(&box);
    return box;
}

static double cost_of(const packed *image, const mesh *m) {
    const tree_view v = tree_view_of(image);
    whole w = {(const plt_node *)(const void *)v.nodes, (const plt_record *)(const void *)v.records,
               m, 0.0};
    const plt_box box = box_below(&w, v.root);
    const double root = list_tree_half_area(&box);
    return root > 0.0 ? w.areas / root : 0.0;
}

static double cost_of_all(const packed *image, const film *f) {
    double sum = 0.0;
    for (uint32_t i = 0; i < f->frames; i++) {
        sum += cost_of(image, &f->frame[i]);
    }
    return sum / f->frames;
}

/* The mean over the frames that have an area. */
static double cost_of_poses(const packed *image, const film *f) {
    double sum = 0.0;
    uint32_t flat = 0;
    for (uint32_t i = 0; i <= f->poses.count; i++) {
        const uint32_t frame = i == 0 ? 0 : poses_frame(i - 1, f->poses.count, f->frames);
        sum += cost_of(image, &f->frame[frame]);
        flat += f->poses.weight[i] == 0.0;
    }
    return flat <= f->poses.count ? sum / (f->poses.count + 1 - flat) : 0.0;
}

/* ---- films ------------------------------------------------------------------------ */

/* Each triangle goes somewhere, with its own corners. */
static void scatter(mesh *m, uint64_t seed) {
    random_state r = {seed};
    for (uint32_t i = 0; i < m->triangles; i++) {
        float to[3];
        for (int a = 0; a < 3; a++) {
            to[a] = random_float(&r, -1.0f, 1.0f);
        }
        for (unsigned c = 0; c < 3; c++) {
            for (int a = 0; a < 3; a++) {
                m->vertex[9 * i + 3 * c + (size_t)a] += to[a];
            }
        }
    }
}

static void choose_poses(film *f) {
    const uint32_t wanted = poses_wanted(f->frames, f->frame[0].triangles);
    poses_begin(&f->poses, &f->frame[0]);
    for (uint32_t i = 0; i < wanted; i++) {
        CHECK(poses_add(&f->poses, &f->frame[poses_frame(i, wanted, f->frames)]) == 0, "memory");
    }
    poses_weigh(&f->poses);
}

/* Frame 0 as it is; `way` of mover.h leads to the others, farther each time. */
static void deform(film *f, uint32_t frames, unsigned way) {
    f->frames = frames;
    for (uint32_t i = 1; i < frames; i++) {
        f->frame[i] = shape_copy(&f->frame[0]);
        mover_deform(&f->frame[i], way);
        for (size_t k = 0; k < 3 * f->frame[i].vertices; k++) {
            const float part = (float)i / (float)(frames - 1), from = f->frame[0].vertex[k];
            f->frame[i].vertex[k] = from + part * (f->frame[i].vertex[k] - from);
        }
    }
    choose_poses(f);
}

static void film_free(film *f) {
    poses_free(&f->poses);
    for (uint32_t i = 0; i < f->frames; i++) {
        mesh_free(&f->frame[i]);
    }
    *f = (film){.frames = 0};
}

/* ---- checks ----------------------------------------------------------------------- */

static void check_costs(const film *f, const packed *first, const packed *all,
                        const quality_stats *q, const char *name) {
    const double before = cost_of_poses(first, f), after = cost_of_poses(all, f);
    CHECK(q->frames == f->poses.count + 1, "%s: %u frames", name, (unsigned)q->frames);
    CHECK(q->after <= q->before && fabs(q->before - before) <= 1e-4 * before, "%s: %g, was %g, %g",
          name, q->after, q->before, before);
    /* Short lists may become one, which takes an intermediate node away. */
    CHECK(after <= q->after * (1.0 + 1e-4), "%s: %g, %g by the image", name, q->after, after);
}

/* Every frame, as if packed anew. */
static void check_frames(const film *f, const rig_config *config, const char *name) {
    mover v = {.bytes = 0};
    const int status = mover_open(&v, &f->frame[0], config, 1);
    if (rig_is_tiny() && status == PLT_ERR_LIMIT) {
        mover_close(&v);
        return; /* more of the global stack than small limits have */
    }
    CHECK(status == PLT_OK, "%s: not opened: %s", name, v.fault.message);
    for (uint32_t i = 0; i < f->frames && status == PLT_OK; i++) {
        rig_config fresh = *config;
        fresh.pack.poses = NULL;
        CHECK(mover_move(&v, &f->frame[i]) == PLT_OK, "%s: %s", name, v.fault.message);
        mover_compare(&v, &f->frame[i], &fresh, name);
    }
    mover_close(&v);
}

static void check_tree(const packed *image, const char *name) {
    const tree_view view = tree_view_of(image);
    const tree_facts facts = tree_check(&view);
    CHECK(facts.broken == 0, "%s: %u rules broken, first: %s", name, facts.broken, facts.sentence);
    CHECK(facts.levels <= PLT_DEPTH_MAX, "%s: %u levels", name, facts.levels);
}

/* Returns the share of the first frame's tree's cost that remains, over all frames. */
static double check_film(const film *f, uint32_t k, uint32_t n, const char *name) {
    rig_config config = rig_config_of(k, mover_treelet(n), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    packed first, all, again;
    quality_stats stats, second;
    fail why = {""};
    CHECK(pack_mesh(&first, &f->frame[0], &config.pack, name, &why) == 0, "%s", why.text);
    config.pack.poses = &f->poses;
    CHECK(pack_mesh_better(&all, &f->frame[0], &config.pack, 0, &stats, name, &why) == 0, "%s",
          why.text);
    CHECK(pack_mesh_better(&again, &f->frame[0], &config.pack, 0, &second, name, &why) == 0, "%s",
          why.text);
    CHECK(all.size == again.size && memcmp(all.bytes, again.bytes, all.size) == 0,
          "%s: another image the second time", name);
    check_tree(&all, name);
    if (stats.passes > 0) {
        check_costs(f, &first, &all, &stats, name);
    }
    check_frames(f, &config, name);
    const double before = cost_of_all(&first, f), after = cost_of_all(&all, f);
    pack_free(&first);
    pack_free(&all);
    pack_free(&again);
    return before > 0.0 ? after / before : 1.0;
}

static void check_lists(film *f, const char *name) {
    static const uint32_t k[] = {1, 2, 4, 2}, n[] = {64, 64, 1, 3};
    test(name);
    for (int i = 0; i < 4; i++) {
        check_film(f, k[i], n[i], name);
    }
    film_free(f);
}

/* ---- films ------------------------------------------------------------------------ */

static void test_ways(void) {
    static const char *const names[MOVER_WAYS] = {"stays",       "shivers",  "twists",
                                                  "is mirrored", "flattens", "scatters",
                                                  "collapses",   "goes far"};
    for (unsigned way = 0; way < MOVER_WAYS; way++) {
        film f = {.frames = 0};
        shape_soup(&f.frame[0], rig_triangles(300, 1), 0.5f, way + 1);
        deform(&f, 2 + 2 * (way % 4), way);
        check_lists(&f, names[way]);
    }
}

static void test_odd_ones(void) {
    film f = {.frames = 0};
    shape_soup(&f.frame[0], rig_triangles(200, 1), 0.5f, 3);
    deform(&f, 1, 0);
    check_lists(&f, "a single frame");
    shape_soup(&f.frame[0], rig_triangles(200, 1), 0.5f, 3);
    deform(&f, 5, 1);
    mover_deform(&f.frame[0], 6);
    poses_weigh(&f.poses);
    check_lists(&f, "all in one point, in the first frame");
    shape_coincident(&f.frame[0], rig_triangles(60, 1) - 2);
    deform(&f, 4, 1);
    check_lists(&f, "the same triangle many times, in the first frame");
    shape_exponential(&f.frame[0], rig_triangles(120, 1));
    deform(&f, 3, 2);
    check_lists(&f, "every triangle half as large as the one before");
    shape_degenerate(&f.frame[0]);
    deform(&f, 3, 1);
    check_lists(&f, "points and lines");
    for (uint32_t few = 1; few < 8; few++) {
        shape_soup(&f.frame[0], few, 0.7f, few);
        deform(&f, 3, 5);
        check_lists(&f, "few triangles");
    }
}

/* Neighbours in the first frame, and nowhere near each other in any other. */
static void test_gain(void) {
    film f = {.frames = 0};
    shape_soup(&f.frame[0], rig_triangles(3000, 1), 0.05f, 9);
    test("triangles that were elsewhere in the first frame");
    for (uint32_t i = 1; i < 6; i++) {
        f.frame[i] = shape_copy(&f.frame[0]);
        scatter(&f.frame[i], 4);
    }
    f.frames = 6;
    choose_poses(&f);
    for (uint32_t k = 1; k <= 4; k *= 2) {
        const double share = check_film(&f, k, 64, "scattered");
        CHECK(share < (rig_is_tiny() ? 0.9 : 0.5), "K = %u: %.3f of the cost remains", (unsigned)k,
              share);
    }
    film_free(&f);
}

/* All triangles have one centre at first: only the other frames say which belong together. */
static void test_one_place(void) {
    film f = {.frames = 0};
    test("triangles that come from one place");
    shape_soup(&f.frame[0], rig_triangles(3000, 1), 0.05f, 9);
    for (uint32_t i = 0; i < f.frame[0].triangles; i++) {
        float *corner = f.frame[0].vertex + 9 * (size_t)i;
        for (int a = 0; a < 3; a++) {
            corner[a] = -0.05f;
            corner[3 + a] = 0.05f;
            corner[6 + a] = a == 0 ? 0.05f : -0.05f;
        }
    }
    for (uint32_t i = 1; i < 6; i++) {
        f.frame[i] = shape_copy(&f.frame[0]);
        scatter(&f.frame[i], 4);
    }
    f.frames = 6;
    choose_poses(&f);
    const double share = check_film(&f, 2, 64, "from one place");
    CHECK(share < (rig_is_tiny() ? 0.9 : 0.22), "%.3f of the cost remains", share);
    film_free(&f);
}

static void test_city(void) {
    film f = {.frames = FRAMES_MOST};
    fail why = {""};
    if (rig_is_tiny()) {
        return;
    }
    test("people who leave a lift");
    for (uint32_t i = 0; i < f.frames; i++) {
        CHECK(scene_city(&f.frame[i], 6 * i, &why) == 0, "%s", why.text);
    }
    choose_poses(&f);
    const double share = check_film(&f, 2, 64, "city");
    CHECK(share < 0.85, "%.3f of the cost remains", share);
    film_free(&f);
}

/* ---- which frames, and memory ------------------------------------------------------ */

static void test_choice(void) {
    test("which frames");
    CHECK(poses_wanted(0, 10) == 0 && poses_wanted(1, 10) == 0, "one is enough for one");
    CHECK(poses_wanted(3, 10) == 2 && poses_wanted(3, 0) == 2, "all of a few");
    CHECK(poses_wanted(500, 10) == POSES_MOST, "no more than there is room for");
    CHECK(poses_wanted(500, 2796202) == 3 && poses_wanted(500, 100000000) == 1,
          "fewer of large meshes");
    for (uint32_t frames = 2; frames < 200; frames++) {
        const uint32_t count = poses_wanted(frames, 1);
        uint32_t last = 0;
        for (uint32_t i = 0; i < count; i++) {
            const uint32_t frame = poses_frame(i, count, frames);
            CHECK(frame > last && frame - last <= (frames - 1) / count + 1, "%u of %u: %u",
                  (unsigned)i, (unsigned)frames, (unsigned)frame);
            last = frame;
        }
        CHECK(last == frames - 1, "the last one is among them");
    }
}

static void test_memory(void) {
    film f = {.frames = 0};
    rig_config config = rig_config_of(2, mover_treelet(64), PLT_BUILD_HOST, PLT_SPLIT_SAH);
    unsigned refused = 0;
    test("memory that is not given");
    shape_soup(&f.frame[0], rig_triangles(500, 1), 0.5f, 3);
    deform(&f, 4, 5);
    config.pack.poses = &f.poses;
    for (uint64_t more = 0, done = 0; !done; more += 5000) {
        const uint64_t before = heap_used();
        packed image;
        quality_stats stats;
        fail why = {""};
        heap_limit(before + more);
        done = pack_mesh_better(&image, &f.frame[0], &config.pack, 0, &stats, "it", &why) == 0;
        heap_limit(UINT64_MAX);
        CHECK(done || strstr(why.text, "out of memory") != NULL, "%s", why.text);
        refused += !done;
        if (done) {
            check_tree(&image, "memory");
            pack_free(&image);
        }
        CHECK(heap_used() == before, "%llu bytes are left",
              (unsigned long long)(heap_used() - before));
    }
    CHECK(refused > (rig_is_tiny() ? 1 : 20), "refused %u times", refused);
    film_free(&f);
}

int main(void) {
    test_ways();
    test_odd_ones();
    test_gain();
    test_one_place();
    test_city();
    test_choice();
    test_memory();
    return test_done();
}
