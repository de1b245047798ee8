/* daylight - what scenes are lit by unless somebody says otherwise
 *
 * SPDX-License-Identifier: MIT */
#ifndef DAYLIGHT_H
#define DAYLIGHT_H
#include "engine/planelet.h"

/* Linear light from above and below, and rays one after another. */
#define DAYLIGHT_SKY                                                                               \
    { 0.36f, 0.45f, 0.60f }
#define DAYLIGHT_GROUND                                                                            \
    { 0.17f, 0.15f, 0.13f }
enum { DAYLIGHT_BOUNCES = 4 };

/* A sun behind the camera, above it and to the left: soft, as of a hazy day. */
void daylight_sun(plt_light *to, const plt_camera *camera);

#endif
