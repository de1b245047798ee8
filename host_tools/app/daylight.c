/* daylight - see daylight.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/daylight.h"

#include <math.h>

void daylight_sun(plt_light *to, const plt_camera *camera) {
    double back[3], up[3], left[3], length = 0.0, high = 0.0;
    for (int a = 0; a < 3; a++) {
        back[a] = (double)camera->eye[a] - (double)camera->look[a];
        up[a] = (double)camera->up[a];
        length += back[a] * back[a];
        high += up[a] * up[a];
    }
    for (int a = 0; a < 3; a++) {
        back[a] /= sqrt(length);
        up[a] /= sqrt(high);
    }
    left[0] = back[1] * up[2] - back[2] * up[1];
    left[1] = back[2] * up[0] - back[0] * up[2];
    left[2] = back[0] * up[1] - back[1] * up[0];
    *to = (plt_light){.kind = PLT_LIGHT_DISTANT, .samples = 4, .radius = 0.06f};
    for (int a = 0; a < 3; a++) {
        to->at[a] = (float)(0.5 * back[a] + up[a] + 0.6 * left[a]);
        to->power[a] = 0.75f;
    }
}
