/* view - see view.h
 *
 * Computed in double and rounded once: machines whose tangents differ in the last
 * bit still give the engine the same floats, but for rare ties.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/shade/camera.h"
#include "host_tools/app/aim.h"
#include "host_tools/app/fitting.h"

#define DEGREE 0.017453292519943295

/* The engine takes tangents from 1e-6 to 1e6: these are a little inside. */
static const float FOV_LEAST = 0.0002f, FOV_MOST = 179.999f;

/* False for what is no number, too. */
static int is_within(const float v[3]) {
    int within = 1;
    for (int i = 0; i < 3; i++) {
        within &= v[i] >= -PLT_COORD_MAX && v[i] <= PLT_COORD_MAX;
    }
    return within;
}

static void read_point(args *a, const char *flag, float v[3]) {
    if (args_floats(a, flag, v, 3) && !is_within(v)) {
        args_complain(a, "%s takes three numbers from -2^40 to 2^40, not '%s'", flag,
                      args_text(a, flag, ""));
    }
}

static void read_fov(args *a, float *fov) {
    if (args_floats(a, "--fov", fov, 1) && !(*fov >= FOV_LEAST && *fov <= FOV_MOST)) {
        args_complain(a, "--fov takes degrees from 0.0002 to 179.999, not '%s'",
                      args_text(a, "--fov", ""));
        *fov = 45.0f;
    }
}

static void look_at_the_middle(const plt_info *info, plt_camera *c) {
    c->up[0] = c->up[2] = 0.0f;
    c->up[1] = 1.0f;
    for (int i = 0; i < 3; i++) {
        c->look[i] = info->triangles > 0 ? 0.5f * info->lo[i] + 0.5f * info->hi[i] : 0.0f;
    }
}

static void set_fov(plt_camera *c, float degrees) {
    c->tan_half_fov = (float)tan(0.5 * (double)degrees * DEGREE);
}

/* Where --view says that the eye is. */
enum { SIDE_USUAL = 0, SIDE_BOX, SIDE_ANGLES };

static const struct {
    const char *name;
    double azimuth, elevation;
} sides[] = {
    {"front", 0, 0},  {"back", 180, 0}, {"right", 90, 0},   {"side", 90, 0},
    {"left", -90, 0}, {"top", 0, 90},   {"bottom", 0, -90}, {"iso", 45, 35.264389682754654}};

static int read_angles(args *a, aim *to) {
    const char *text = args_text(a, "--view", "");
    double angles[2];
    if (strchr(text, ',') == NULL) {
        args_complain(
            a,
            "--view takes front, back, left, right or side, top, bottom, iso, usual, box, "
            "or an azimuth and an elevation, not '%s'",
            text);
        return SIDE_USUAL;
    }
    if (args_doubles(a, "--view", angles, 2) &&
        !(fabs(angles[0]) <= 360.0 && fabs(angles[1]) <= 90.0)) {
        args_complain(a,
                      "--view takes an azimuth from -360 to 360 and an elevation from -90 to 90, "
                      "not '%s'",
                      text);
    }
    if (!a->wrong) {
        to->azimuth = angles[0];
        to->elevation = angles[1];
    }
    return SIDE_ANGLES;
}

static int read_side(args *a, aim *to, int otherwise) {
    const char *text = args_text(a, "--view", NULL);
    if (text == NULL) {
        return otherwise;
    }
    if (args_has(a, "--eye")) {
        args_complain(a, "--view and --eye both say where the camera is, give one of them");
    }
    if (strcmp(text, "usual") == 0 || strcmp(text, "box") == 0) {
        return text[0] == 'b' ? SIDE_BOX : SIDE_USUAL;
    }
    for (size_t i = 0; i < sizeof sides / sizeof sides[0]; i++) {
        if (strcmp(text, sides[i].name) == 0) {
            to->azimuth = sides[i].azimuth;
            to->elevation = sides[i].elevation;
            return SIDE_ANGLES;
        }
    }
    return read_angles(a, to);
}

static void read_camera(args *a, aim *to, unsigned width, unsigned height, int otherwise,
                        plt_camera *c) {
    float fov = 45.0f;
    to->aspect = (double)width / height;
    look_at_the_middle(to->info, c);
    read_point(a, "--up", c->up);
    read_point(a, "--look", c->look);
    read_fov(a, &fov);
    set_fov(c, fov);
    const int side = read_side(a, to, otherwise);
    to->has_side = side == SIDE_ANGLES;
    to->is_fixed = args_has(a, "--look");
    if (args_has(a, "--eye")) {
        read_point(a, "--eye", c->eye);
    } else if (side == SIDE_BOX) {
        aim_box(to->info, width, height, c);
    } else {
        aim_camera(to, c);
    }
}

void view_camera(args *a, const plt_info *info, unsigned width, unsigned height, plt_camera *c) {
    aim to = {.info = info};
    read_camera(a, &to, width, height, SIDE_BOX, c);
}

void view_of_all(const plt_info *info, unsigned width, unsigned height, plt_camera *c) {
    look_at_the_middle(info, c);
    set_fov(c, 45.0f);
    aim_box(info, width, height, c);
}

void view_fit(args *a, const view_subject *v, unsigned width, unsigned height, plt_camera *c) {
    sight seen = SIGHT_CLOSED;
    const int is_asked = !args_has(a, "--eye") && strcmp(args_text(a, "--view", ""), "box") != 0;
    if (is_asked && v->file != NULL) {
        sight_open(&seen, v->file, v->resident);
    }
    aim to = {.info = v->info, .seen = &seen, .circles = v->circles};
    read_camera(a, &to, width, height, SIDE_USUAL, c);
    sight_close(&seen);
}

static int refuse(const args *a, const plt_camera *c, fail *f) {
    if (!is_within(c->eye)) {
        return fail_set(f, "camera", "%s",
                        args_has(a, "--eye")
                            ? "its orbit goes beyond 2^40; move --eye nearer to --look"
                            : "all is seen only from beyond 2^40; choose a nearer --eye, or a "
                              "wider --fov");
    }
    if (c->eye[0] == c->look[0] && c->eye[1] == c->look[1] && c->eye[2] == c->look[2]) {
        return fail_set(f, "camera", "eye and look coincide; change --eye or --look");
    }
    if (c->up[0] == 0.0f && c->up[1] == 0.0f && c->up[2] == 0.0f) {
        return fail_set(f, "camera", "up has no direction; change --up");
    }
    return fail_set(f, "camera", "up runs along the view; change --eye, --look or --up");
}

void view_orbit(const plt_camera *from, double circles, plt_camera *to) {
    double axis[3], arm[3], side[3];
    for (int i = 0; i < 3; i++) {
        axis[i] = (double)from->up[i];
        arm[i] = (double)from->eye[i] - (double)from->look[i];
    }
    vector_normalise(axis);
    vector_cross(axis, arm, side);
    const double c = cos(360.0 * DEGREE * circles), s = sin(360.0 * DEGREE * circles);
    const double along = vector_dot(axis, arm);
    *to = *from;
    for (int i = 0; i < 3; i++) { /* Rodrigues */
        to->eye[i] =
            (float)((double)from->look[i] + arm[i] * c + side[i] * s + axis[i] * along * (1.0 - c));
    }
}

int view_refused(const args *a, const plt_frame *frame, unsigned frames, fail *f) {
    plt_frame now = *frame;
    plt_view view;
    for (unsigned i = 0; i < frames; i++) {
        if (i > 0) {
            view_orbit(&frame->camera, (double)i / frames, &now.camera);
        }
        if (plt_view_set(&view, &now) != PLT_OK) {
            return refuse(a, &now.camera, f);
        }
    }
    return 0;
}

uint8_t view_shader(args *a) {
    static const char *const names[] = {"eyelight", "normal", "triangle", "smooth", NULL};
    return (uint8_t)args_choice(a, "--shader", names, PLT_SHADE_EYELIGHT);
}

uint8_t view_shader_of_triangles(args *a) {
    static const char *const names[] = {"eyelight", "normal", "triangle", NULL};
    return (uint8_t)args_choice(a, "--shader", names, PLT_SHADE_EYELIGHT);
}

void view_background(args *a, plt_frame *frame) {
    const char *text = args_text(a, "--background", "sky");
    char *end;
    if (strcmp(text, "sky") == 0) {
        return;
    }
    if (strlen(text) != 6 || strspn(text, "0123456789abcdefABCDEF") != 6) {
        args_complain(a, "--background takes six hexadecimal digits as ff8000, or sky, not '%s'",
                      text);
        return;
    }
    const unsigned long colour = strtoul(text, &end, 16);
    frame->has_background = 1;
    for (int i = 0; i < 3; i++) {
        frame->background[i] = (uint8_t)(colour >> (16 - 8 * i));
    }
}

uint8_t view_samples(args *a) {
    static const char *const names[] = {"1", "4", "16", "adaptive", NULL};
    static const uint8_t samples[] = {PLT_SAMPLES_ONE, PLT_SAMPLES_FOUR, PLT_SAMPLES_SIXTEEN,
                                      PLT_SAMPLES_ADAPTIVE};
    return samples[args_choice(a, "--samples", names, 0)];
}
