/* test_app_view - where the camera of planelet render is
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "engine/shade/camera.h"
#include "host_tools/app/view.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/random.h"
#include "tests/reference/rig.h"
#include "tests/test.h"

static const arg_flag flags[] = {VIEW_FLAGS, {NULL, NULL, NULL}};
static const arg_command command = {.name = "view", .flags = flags};

/* The camera for a box and these words. */
static plt_camera camera_of(const plt_info *info, unsigned width, unsigned height, int words,
                            char **word) {
    args a;
    plt_camera c;
    CHECK(args_parse(&a, "view", &command, words, word) == ARGS_GO_ON, "the words are wrong");
    view_camera(&a, info, width, height, &c);
    CHECK(!a.wrong, "the values are wrong");
    args_free(&a);
    return c;
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void minus(const float a[3], const float b[3], double to[3]) {
    for (int i = 0; i < 3; i++) {
        to[i] = (double)a[i] - (double)b[i];
    }
}

static void unit_cross(const double a[3], const double b[3], double to[3]) {
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[i] = a[j] * b[k] - a[k] * b[j];
    }
    const double length = sqrt(dot(to, to));
    for (int i = 0; i < 3; i++) {
        to[i] /= length;
    }
}

/* The farthest that a corner of the box reaches towards the frame's border:
 * 1 is the border; 2 when a corner is behind the eye. */
static double reach(const plt_camera *c, const plt_info *info, double aspect) {
    double forward[3], right[3], above[3], most = 0.0;
    const double up[3] = {(double)c->up[0], (double)c->up[1], (double)c->up[2]};
    minus(c->look, c->eye, forward);
    const double length = sqrt(dot(forward, forward));
    for (int i = 0; i < 3; i++) {
        forward[i] /= length;
    }
    unit_cross(forward, up, right);
    unit_cross(right, forward, above);
    for (int k = 0; k < 8; k++) {
        float corner[3];
        double q[3];
        for (int i = 0; i < 3; i++) {
            corner[i] = k >> i & 1 ? info->hi[i] : info->lo[i];
        }
        minus(corner, c->eye, q);
        const double depth = dot(q, forward) * (double)c->tan_half_fov;
        if (depth <= 0.0) {
            return 2.0;
        }
        most = fmax(most, fabs(dot(q, above)) / depth);
        most = fmax(most, fabs(dot(q, right)) / (depth * aspect));
    }
    return most;
}

static plt_info random_box(random_state *r) {
    plt_info info = {.triangles = 1};
    for (int i = 0; i < 3; i++) {
        const float size = powf(10.0f, random_float(r, -2.0f, 2.0f));
        info.lo[i] = random_float(r, -10.0f, 10.0f);
        info.hi[i] = info.lo[i] + size;
    }
    return info;
}

static void check_fit(void) {
    static const char *const ups[] = {"0,1,0", "0,0,1", "1,0,0", "0,-1,0", "0,0,-2", "1,2,-3"};
    random_state random = {1};
    for (unsigned i = 0; i < 3000; i++) {
        const plt_info info = random_box(&random);
        const unsigned width = 1 + random_below(&random, 2000);
        const unsigned height = 1 + random_below(&random, 2000);
        char fov[32], up[16];
        snprintf(fov, sizeof fov, "%g", (double)random_float(&random, 5.0f, 120.0f));
        snprintf(up, sizeof up, "%s", ups[i % 6]);
        char *words[] = {"--fov", fov, "--up", up};
        const plt_camera c = camera_of(&info, width, height, 4, words);
        const double far = reach(&c, &info, (double)width / height);
        CHECK(far < 1.0, "box %u: reaches to %g", i, far);
        CHECK(far > 0.5, "box %u: fills only %g", i, far);
    }
}

static const char *const sides[] = {"front",  "back", "left",  "right",  "side",    "top",
                                    "bottom", "iso",  "usual", "30,-40", "-100,89", "0,90"};
enum { SIDES = sizeof sides / sizeof sides[0] };

/* The camera of view_fit, by these words, for a box of which no more is known. */
static plt_camera fit_of(const plt_info *info, unsigned width, unsigned height, int circles,
                         int words, char **word) {
    const view_subject all = {.info = info, .circles = circles};
    args a;
    plt_camera c;
    CHECK(args_parse(&a, "view", &command, words, word) == ARGS_GO_ON, "the words are wrong");
    view_fit(&a, &all, width, height, &c);
    CHECK(!a.wrong, "the values are wrong");
    args_free(&a);
    return c;
}

/* A box of which no side is more than five times as long as another: the eye stays outside. */
static plt_info random_block(random_state *r) {
    plt_info info = {.triangles = 1};
    for (int i = 0; i < 3; i++) {
        info.lo[i] = random_float(r, -10.0f, 10.0f);
        info.hi[i] = info.lo[i] + random_float(r, 1.0f, 5.0f);
    }
    return info;
}

/* 0.94 of the way from the middle to the border is to be filled. */
static void check_sides(void) {
    random_state random = {2};
    for (unsigned i = 0; i < 3000; i++) {
        const plt_info info = random_block(&random);
        const unsigned width = 1 + random_below(&random, 2000);
        const unsigned height = 1 + random_below(&random, 2000);
        char fov[32], side[16];
        snprintf(fov, sizeof fov, "%g", (double)random_float(&random, 5.0f, 60.0f));
        snprintf(side, sizeof side, "%s", sides[i % SIDES]);
        char *words[] = {"--fov", fov, "--view", side};
        const plt_camera c = fit_of(&info, width, height, 0, 4, words);
        const double far = reach(&c, &info, (double)width / height);
        CHECK(far < 0.945, "box %u, %s: reaches to %g", i, side, far);
        CHECK(far > 0.8, "box %u, %s: fills only %g", i, side, far);
    }
}

/* From the middle of the box to the eye, and what is up in the picture. */
static void check_directions(void) {
    static const struct {
        const char *side, *up;
        double back[3], above[3];
    } cases[] = {
        {"front", "0,1,0", {0, 0, 1}, {0, 1, 0}},   {"back", "0,1,0", {0, 0, -1}, {0, 1, 0}},
        {"right", "0,1,0", {1, 0, 0}, {0, 1, 0}},   {"side", "0,1,0", {1, 0, 0}, {0, 1, 0}},
        {"left", "0,1,0", {-1, 0, 0}, {0, 1, 0}},   {"top", "0,1,0", {0, 1, 0}, {0, 0, -1}},
        {"bottom", "0,1,0", {0, -1, 0}, {0, 0, 1}}, {"front", "0,0,1", {0, -1, 0}, {0, 0, 1}},
        {"right", "0,0,1", {1, 0, 0}, {0, 0, 1}},   {"top", "0,0,1", {0, 0, 1}, {0, 1, 0}},
        {"iso", "0,1,0", {1, 1, 1}, {0, 1, 0}},     {"90,45", "0,1,0", {1, 1, 0}, {0, 1, 0}}};
    const plt_info info = {.triangles = 1, .lo = {-1, -1, -1}, .hi = {1, 1, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char side[16], up[16];
        snprintf(side, sizeof side, "%s", cases[i].side);
        snprintf(up, sizeof up, "%s", cases[i].up);
        char *words[] = {"--view", side, "--up", up};
        const plt_camera c = fit_of(&info, 100, 100, 0, 4, words);
        double arm[3], above[3];
        minus(c.eye, c.look, arm);
        const double along =
            dot(arm, cases[i].back) / sqrt(dot(arm, arm) * dot(cases[i].back, cases[i].back));
        CHECK(along > 0.999999, "%s, up %s: off by %g", side, up, 1.0 - along);
        for (int k = 0; k < 3; k++) {
            above[k] = (double)c.up[k];
        }
        CHECK(dot(above, cases[i].above) > 0.999999, "%s, up %s: is tilted", side, up);
    }
}

/* Every step of an orbit sees all of the box, and one comes near to the border. */
static void check_circles(void) {
    random_state random = {3};
    for (unsigned i = 0; i < 300; i++) {
        const plt_info info = random_box(&random);
        const unsigned width = 100 + random_below(&random, 300);
        char *words[] = {"--view", i % 2 ? "iso" : "usual"};
        const plt_camera c = fit_of(&info, width, 200, 1, 2, words);
        double most = 0.0;
        for (unsigned k = 0; k < 60; k++) {
            plt_camera now;
            view_orbit(&c, k / 60.0, &now);
            most = fmax(most, reach(&now, &info, width / 200.0));
        }
        CHECK(most < 1.0, "box %u: reaches to %g", i, most);
        CHECK(most > 0.8, "box %u: fills only %g", i, most);
    }
}

/* How far the picture of `c` is from empty at its borders: the least number of pixels between one
 * that is hit and a border, of each side. */
static void measure_margins(plt_engine *e, const plt_camera *c, unsigned side, unsigned margin[4]) {
    const plt_frame frame = {.camera = *c, .width = (uint16_t)side, .height = (uint16_t)side};
    plt_view view;
    CHECK(plt_view_set(&view, &frame) == PLT_OK, "the camera");
    margin[0] = margin[1] = margin[2] = margin[3] = side;
    for (unsigned i = 0; i < side * side; i++) {
        const unsigned x = i % side, y = i / side;
        plt_ray ray = {.tmax = PLT_VIEW_FAR};
        plt_hit hit;
        plt_view_direction(&view, x, y, ray.dir);
        memcpy(ray.org, view.eye, sizeof ray.org);
        CHECK(plt_trace(e, &ray, &hit, 1, 1) == PLT_OK, "the trace");
        if (hit.triangle) {
            const unsigned now[4] = {x, side - 1 - x, y, side - 1 - y};
            for (int k = 0; k < 4; k++) {
                margin[k] = now[k] < margin[k] ? now[k] : margin[k];
            }
        }
    }
}

static unsigned least(unsigned a, unsigned b) {
    return a < b ? a : b;
}

/* A twentieth of the picture is more than the 3 % and a ray of the search. What does not reach
 * from border to border is in the middle. */
static void check_seen_from(const char *side_name, const host_scene *file, plt_engine *asked,
                            plt_engine *e) {
    enum { SIDE = 100 };
    char side[16];
    snprintf(side, sizeof side, "%s", side_name);
    char *words[] = {"--view", side};
    unsigned m[4];
    args a;
    plt_camera c;
    const view_subject all = {.info = plt_engine_info(e), .file = file, .resident = asked};
    CHECK(args_parse(&a, "view", &command, 2, words) == ARGS_GO_ON, "the words are wrong");
    view_fit(&a, &all, SIDE, SIDE, &c);
    args_free(&a);
    measure_margins(e, &c, SIDE, m);
    const unsigned wide = least(m[0], m[1]), high = least(m[2], m[3]);
    CHECK(wide >= 1 && high >= 1, "%s: margins %u %u %u %u", side, m[0], m[1], m[2], m[3]);
    CHECK(least(wide, high) <= 5, "%s: margins %u %u %u %u", side, m[0], m[1], m[2], m[3]);
    CHECK(abs((int)m[0] - (int)m[1]) <= 4 && abs((int)m[2] - (int)m[3]) <= 4,
          "%s: not in the middle, %u %u %u %u", side, m[0], m[1], m[2], m[3]);
}

static void check_seen(void) {
    static const rig_config config = {
        .pack = {.leaf_triangles = 2, .treelet_nodes = 8},
        .run = {.packet_side = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8}};
    rig r;
    mesh m = {0};
    fail f = {""};
    host_scene file;
    CHECK(scene_knot(&m, rig_triangles(3000, 2), &f) == 0, "%s", f.text);
    const int status = rig_open(&r, &m, &config);
    CHECK(status == PLT_OK || rig_is_tiny(), "the scene is refused: %d", status);
    if (status == PLT_OK) {
        host_scene_hold(&file, r.image.bytes, r.image.size, 0);
        for (unsigned i = 0; i < SIDES; i++) {
            check_seen_from(sides[i], &file, r.engine, r.engine);
            check_seen_from(sides[i], &file, NULL, r.engine);
        }
        host_scene_close(&file);
    }
    rig_close(&r);
    mesh_free(&m);
}

static void check_empty(void) {
    const plt_info none = {.lo = {1, 1, 1}, .hi = {-1, -1, -1}};
    const plt_info point = {.triangles = 1, .lo = {5, 5, 5}, .hi = {5, 5, 5}};
    const plt_info *infos[] = {&none, &point};
    for (int k = 0; k < 2; k++) {
        const plt_camera c = camera_of(infos[k], 10, 10, 0, NULL);
        double arm[3];
        minus(c.eye, c.look, arm);
        CHECK(fabs(dot(arm, arm) - 1.0) < 1e-5, "%d: the distance is %g", k, sqrt(dot(arm, arm)));
    }
}

static void check_flags(void) {
    const plt_info info = {.triangles = 1, .lo = {-1, -2, -3}, .hi = {3, 2, 1}};
    char *words[] = {"--eye", "1,2,3", "--look", "4,5,6", "--up", "7,8,9", "--fov", "90"};
    plt_camera c = camera_of(&info, 10, 10, 8, words);
    for (int i = 0; i < 3; i++) {
        CHECK(c.eye[i] == (float)(1 + i) && c.look[i] == (float)(4 + i) &&
                  c.up[i] == (float)(7 + i),
              "axis %d", i);
    }
    CHECK(fabsf(c.tan_half_fov - 1.0f) < 1e-6f, "tangent %g", (double)c.tan_half_fov);
    c = camera_of(&info, 10, 10, 2, words);
    CHECK(c.look[0] == 1.0f && c.look[1] == 0.0f && c.look[2] == -1.0f, "not at the middle");
    CHECK(c.up[0] == 0.0f && c.up[1] == 1.0f && c.up[2] == 0.0f, "y is not up");
    CHECK(fabs((double)c.tan_half_fov - 0.41421356237309503) < 1e-7, "not 45 degrees");
}

static void check_orbit(void) {
    const plt_camera from = {.eye = {3, 4, 5}, .look = {1, 1, 1}, .up = {0, 2, 0}};
    for (int i = 0; i <= 16; i++) {
        const double circles = i / 16.0, angle = 6.283185307179586 * circles;
        plt_camera to;
        view_orbit(&from, circles, &to);
        const double x = 2 * cos(angle) + 4 * sin(angle), z = 4 * cos(angle) - 2 * sin(angle);
        CHECK(fabs((double)to.eye[0] - (1 + x)) < 1e-5 && fabs((double)to.eye[1] - 4) < 1e-5 &&
                  fabs((double)to.eye[2] - (1 + z)) < 1e-5,
              "%g circles: %g %g %g", circles, (double)to.eye[0], (double)to.eye[1],
              (double)to.eye[2]);
        CHECK(memcmp(to.look, from.look, sizeof to.look) == 0, "%g circles: looks elsewhere",
              circles);
    }
}

/* What view_refused says of the camera by these flags, of a box around the origin. */
static const char *refusal_of(float size, unsigned frames, int words, char **word) {
    static fail f;
    args a;
    plt_frame frame = {.width = 10, .height = 10};
    const plt_info info = {.triangles = 1, .lo = {-size, -size, -size}, .hi = {size, size, size}};
    f = (fail){""};
    CHECK(args_parse(&a, "view", &command, words, word) == ARGS_GO_ON, "the words are wrong");
    view_camera(&a, &info, 10, 10, &frame.camera);
    const int status = a.wrong ? 1 : view_refused(&a, &frame, frames, &f);
    CHECK(status == (f.text[0] == '\0' ? 0 : -1), "status %d with '%s'", status, f.text);
    args_free(&a);
    return f.text;
}

static void check_refusals(void) {
    static const struct {
        float size;
        unsigned frames;
        const char *words[6], *word;
    } cases[] = {{1, 100, {NULL}, ""},
                 {1, 1, {"--eye", "1,1,1", "--look", "1,1,1"}, "coincide"},
                 {1, 1, {"--eye", "0,5,0", "--look", "0,0,0"}, "runs along"},
                 {1, 1, {"--eye", "1,2,3", "--look", "3,6,9", "--up", "1,2,3"}, "runs along"},
                 {1, 1, {"--up", "0,0,0"}, "no direction"},
                 {1e12f, 1, {NULL}, "choose a nearer --eye"},
                 {1e12f, 1, {"--eye", "0,0,1.09e12"}, ""},
                 {1e7f, 1, {"--fov", "0.0002"}, "wider --fov"},
                 {1, 1, {"--eye", "1e12,0,1e12"}, ""},
                 {1, 8, {"--eye", "1e12,0,1e12"}, "its orbit goes beyond"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char words[6][32], *word[6];
        int count = 0;
        for (; count < 6 && cases[i].words[count] != NULL; count++) {
            snprintf(words[count], sizeof words[count], "%s", cases[i].words[count]);
            word[count] = words[count];
        }
        const char *text = refusal_of(cases[i].size, cases[i].frames, count, word);
        CHECK(cases[i].word[0] == '\0' ? text[0] == '\0' : strstr(text, cases[i].word) != NULL,
              "case %zu: '%s'", i, text);
    }
}

int main(void) {
    test("the default camera sees all of any box in any frame, and not from too far");
    check_fit();
    test("a view from any side sees all of any box, and fills the picture in one direction");
    check_sides();
    test("a view's name says where the eye is and what is up");
    check_directions();
    test("all of a box is seen from all around");
    check_circles();
    test("where an engine can say what is seen, that fills the picture, and is in its middle");
    check_seen();
    test("a scene without extent is looked at from a distance of 1");
    check_empty();
    test("every flag moves its part of the camera and no other");
    check_flags();
    test("an orbit rotates the eye about the axis through look along up");
    check_orbit();
    test("a camera that the engine refuses is refused with its reason, in orbits too");
    check_refusals();
    return test_done();
}
