/* test_app_view - where the camera of planelet render is
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "host_tools/app/view.h"
#include "tests/reference/random.h"
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
