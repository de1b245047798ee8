/* viewer_aim - where a scene is seen from, and its lights; see viewer.h
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "host_tools/app/aim.h"
#include "host_tools/app/daylight.h"
#include "host_tools/app/view.h"
#include "host_tools/web/viewer.h"
#include "host_tools/web/viewing.h"

#define DEGREE 0.017453292519943295

void viewer_camera(float eye_x, float eye_y, float eye_z, float look_x, float look_y, float look_z,
                   float fov) {
    viewed.first = (plt_camera){.eye = {eye_x, eye_y, eye_z},
                                .look = {look_x, look_y, look_z},
                                .up = {0.0f, 1.0f, 0.0f},
                                .tan_half_fov = (float)tan(0.5 * (double)fov * DEGREE)};
    viewed.has_camera = 1;
    pose_begin(&viewed.pose, &viewed.first);
}

static void begin_lighting(void) {
    if (!viewed.has_lighting) {
        viewed.lighting = (plt_lighting){
            .sky = DAYLIGHT_SKY, .ground = DAYLIGHT_GROUND, .bounces = DAYLIGHT_BOUNCES};
        viewed.has_lighting = 1;
    }
}

void viewer_sun(float x, float y, float z, float power, float radius, unsigned samples) {
    begin_lighting();
    viewed.lighting.light[0] = (plt_light){.at = {x, y, z},
                                           .power = {power, power, power},
                                           .radius = radius,
                                           .kind = PLT_LIGHT_DISTANT,
                                           .samples = (uint8_t)samples};
    viewed.lighting.lights = 1;
}

void viewer_sky(float r, float g, float b, float r_below, float g_below, float b_below) {
    begin_lighting();
    viewed.lighting.sky[0] = r, viewed.lighting.sky[1] = g, viewed.lighting.sky[2] = b;
    viewed.lighting.ground[0] = r_below, viewed.lighting.ground[1] = g_below,
    viewed.lighting.ground[2] = b_below;
}

/* That of `planelet render`: all that is seen as large as it fits. */
static void usual_camera(void) {
    const plt_info *info = plt_engine_info(viewed.engine);
    const sight seen = {.engine = info->frames == 0 ? viewed.engine : NULL};
    const aim to = {.info = info, .seen = &seen, .aspect = (double)viewed.width / viewed.height};
    view_of_all(info, viewed.width, viewed.height, &viewed.first);
    aim_camera(&to, &viewed.first);
    viewed.has_camera = 1;
    pose_begin(&viewed.pose, &viewed.first);
}

void viewing_aim(void) {
    if (!viewed.has_camera) {
        usual_camera();
    }
    begin_lighting();
    if (viewed.lighting.lights == 0) {
        daylight_sun(&viewed.lighting.light[0], &viewed.first);
        viewed.lighting.lights = 1;
    }
}

static void moved(int has_moved) {
    if (has_moved) {
        coarse_moved(&viewed.coarse);
    }
}

void viewer_steer(unsigned action) {
    moved(viewed.has_camera && action < STEER_ACTIONS &&
          steer(&viewed.pose, (enum steer_action)action));
}

void viewer_turn(double azimuth, double elevation) {
    moved(viewed.has_camera && pose_turn(&viewed.pose, azimuth, elevation));
}

void viewer_zoom(double factor) {
    moved(viewed.has_camera && pose_zoom(&viewed.pose, factor));
}
