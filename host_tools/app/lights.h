/* lights - what frames of --shader whitted are lit by
 *
 * SPDX-License-Identifier: MIT */
#ifndef LIGHTS_H
#define LIGHTS_H
#include "engine/planelet.h"
#include "host_tools/app/args.h"
#include "host_tools/app/crew.h"

#define LIGHTS_FLAGS                                                                               \
    {"--light", "KIND:x,y,z,POWER[,RADIUS[,SAMPLES]]",                                             \
     "whitted: point:, sun: (x,y,z is the direction towards it) or area:, a disc of that radius "  \
     "with soft shadows, 1 to 16 samples (default 8); POWER is what white shows, of a point at a " \
     "distance of 1; up to 8 with '/' between them (default: a sun behind the camera)"},           \
        {"--sky", "r,g,b", "whitted: light from above, linear (default 0.36,0.45,0.60)"},          \
        {"--ground", "r,g,b", "whitted: light from below (default 0.17,0.15,0.13)"},               \
        {"--shadows", "clear|solid",                                                               \
         "whitted: of glass: light comes through it, or none, for less work (default clear)"},     \
        {"--rays", "auto|coherent|incoherent",                                                     \
         "whitted: those off surfaces in packets, one by one in a wave, or as they look; the "     \
         "picture is the same (default auto)"},                                                    \
    {                                                                                              \
        "--depth", "N",                                                                            \
            "whitted: rays one after another that mirrors and glass send out, 0 to 8 "             \
            "(default 4)"                                                                          \
    }

typedef struct lights {
    int is_on;      /* --shader whitted */
    int has_lights; /* --light; else a sun */
    plt_lighting lighting;
} lights;

/* --shader of a command that has these flags, as view_shader, and `depth`, `heat` and
 * `whitted`. */
uint8_t lights_shader(args *a);

/* The flags, and room for it among the options; what is wrong sets a->wrong. */
void lights_read(lights *l, args *a, uint8_t shader, plt_options *options);
/* Lights of engines that are open, for frames that begin with this camera. */
void lights_set(lights *l, const plt_camera *camera, crew *c);

#endif
