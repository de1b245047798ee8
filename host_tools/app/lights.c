/* lights - see lights.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/lights.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/app/daylight.h"

enum { SAMPLES_USUAL = 8, NUMBERS = 6, RAYS_IN_FLIGHT = 32 };

static const char *const KINDS[] = {"point:", "sun:", "area:"};
enum { POINT, SUN, AREA, KINDS_END };

/* "1,2,3" up to the end of the word, which is at a '/' or the text's; returns how many, 0: it is
 * none, or has more than there is room for. */
static unsigned read_numbers(const char **at, float *to, unsigned most) {
    unsigned count = 0;
    for (;;) {
        char *end;
        to[count] = strtof(*at, &end);
        if (end == *at || count + 1 > most || !isfinite(to[count])) {
            return 0;
        }
        count++;
        *at = end;
        if (*end == '\0' || *end == '/') {
            return count;
        }
        if (*end != ',' || count == most) {
            return 0;
        }
        ++*at;
    }
}

static int is_between(float x, float least, float most) {
    return x >= least && x <= most;
}

/* False if a number is out of range. */
static int set_light(plt_light *to, unsigned kind, const float *n, unsigned count) {
    int good = count >= (kind == AREA ? 5u : 4u) && (kind != POINT || count == 4);
    for (int a = 0; a < 3; a++) {
        to->at[a] = n[a];
        to->power[a] = n[3];
        good = good && is_between(n[a], -PLT_COORD_MAX, PLT_COORD_MAX);
    }
    good = good && is_between(n[3], 0.0f, PLT_COORD_MAX) &&
           (kind != SUN || n[0] != 0.0f || n[1] != 0.0f || n[2] != 0.0f);
    to->radius = count > 4 ? n[4] : 0.0f;
    good = good && is_between(to->radius, 0.0f, PLT_COORD_MAX);
    const float samples = count > 5 ? n[5] : to->radius > 0.0f ? SAMPLES_USUAL : 1.0f;
    good = good && is_between(samples, 1.0f, (float)PLT_LIGHT_SAMPLES_MOST) &&
           samples == floorf(samples);
    to->samples = good ? (uint8_t)samples : 1;
    to->kind = kind == SUN ? PLT_LIGHT_DISTANT : PLT_LIGHT_POINT;
    return good;
}

static int read_light(const char **at, plt_light *to) {
    float n[NUMBERS];
    for (unsigned kind = 0; kind < KINDS_END; kind++) {
        const size_t length = strlen(KINDS[kind]);
        if (strncmp(*at, KINDS[kind], length) == 0) {
            *at += length;
            const unsigned count = read_numbers(at, n, NUMBERS);
            return count > 0 && set_light(to, kind, n, count);
        }
    }
    return 0;
}

static void read_lights(plt_lighting *l, args *a) {
    const char *text = args_text(a, "--light", ""), *at = text;
    while (l->lights < PLT_LIGHTS_MOST && read_light(&at, &l->light[l->lights])) {
        l->lights++;
        if (*at == '\0') {
            return;
        }
        at++; /* a '/' */
    }
    args_complain(a,
                  "--light takes point:x,y,z,POWER, sun:x,y,z,POWER or area:x,y,z,POWER,RADIUS, up "
                  "to 8 with '/' between them, not '%s'",
                  text);
}

uint8_t lights_shader(args *a) {
    static const char *const names[] = {"eyelight", "normal", "triangle", "smooth",
                                        "depth",    "heat",   "whitted",  NULL};
    const unsigned named = args_choice(a, "--shader", names, PLT_SHADE_EYELIGHT);
    return (uint8_t)(named > PLT_SHADE_HEAT ? (unsigned)PLT_SHADE_WHITTED : named);
}

static void read_colour(args *a, const char *flag, float to[3]) {
    if (args_floats(a, flag, to, 3) &&
        !(is_between(to[0], 0, 1000) && is_between(to[1], 0, 1000) && is_between(to[2], 0, 1000))) {
        args_complain(a, "%s takes red, green and blue from 0 to 1000, not '%s'", flag,
                      args_text(a, flag, ""));
    }
}

void lights_read(lights *l, args *a, uint8_t shader, plt_options *options) {
    static const char *const WORDS[] = {"clear", "solid", NULL};
    static const char *const RAYS[] = {"auto", "coherent", "incoherent", NULL};
    static const char *const FLAGS[] = {"--light", "--sky",     "--ground",
                                        "--depth", "--shadows", "--rays"};
    *l = (lights){.is_on = shader == PLT_SHADE_WHITTED, .has_lights = args_has(a, "--light")};
    l->lighting = (plt_lighting){.sky = DAYLIGHT_SKY, .ground = DAYLIGHT_GROUND};
    if (!l->is_on) {
        for (int i = 0; i < 6; i++) {
            if (args_has(a, FLAGS[i])) {
                args_complain(a, "%s is for --shader whitted; add that", FLAGS[i]);
            }
        }
        return;
    }
    if (l->has_lights) {
        read_lights(&l->lighting, a);
    }
    read_colour(a, "--sky", l->lighting.sky);
    read_colour(a, "--ground", l->lighting.ground);
    l->lighting.bounces = (uint8_t)args_number(a, "--depth", DAYLIGHT_BOUNCES, 0, PLT_BOUNCES_MOST);
    l->lighting.solid_shadows = (uint8_t)args_choice(a, "--shadows", WORDS, 0);
    options->whitted = (uint8_t)(1 + l->lighting.bounces);
    options->rays = (uint8_t)args_choice(a, "--rays", RAYS, PLT_RAYS_AUTO);
    if (options->rays != PLT_RAYS_COHERENT) {
        options->rays_in_flight = RAYS_IN_FLIGHT;
        options->wide = 1;
    }
    if (strcmp(args_text(a, "--schedule", "branch"), "branch") != 0) {
        args_complain(a, "--shader whitted takes --schedule branch");
    }
}

void lights_set(lights *l, const plt_camera *camera, crew *c) {
    if (l->is_on && !l->has_lights) {
        daylight_sun(&l->lighting.light[0], camera);
        l->lighting.lights = 1;
    }
    for (unsigned i = 0; l->is_on && i < c->count; i++) {
        plt_lighting_set(c->worker[i].engine, &l->lighting);
    }
}
