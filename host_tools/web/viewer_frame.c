/* viewer_frame - frames in steps, coarse ones first, as pixels for the page; see viewer.h
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "board/hash.h"
#include "board/web/web.h"
#include "host_tools/app/frame.h"
#include "host_tools/web/viewer.h"
#include "host_tools/web/viewing.h"

enum { STEP_VISITS = 1000 };

static int take_pixels(void) {
    const uint32_t count = viewed.width * viewed.height;
    web_room_back(viewed.before_pixels);
    viewed.coming = (picture){web_room_take(3 * count), viewed.width, viewed.height};
    viewed.complete = (picture){web_room_take(3 * count), 0, 0}; /* until a frame is complete */
    viewed.rgba = web_room_take(4 * count);
    viewed.is_new = 0;
    if (viewed.coming.rgb == NULL || viewed.complete.rgb == NULL || viewed.rgba == NULL) {
        return fail_set(&viewed.why, "picture",
                        "%u x %u pixels are more than the browser has; choose "
                        "fewer",
                        viewed.width, viewed.height);
    }
    return PLT_OK;
}

int viewer_size(unsigned width, unsigned height) {
    viewed.is_rendering = 0;
    viewed.width = width;
    viewed.height = height;
    if (viewed.engine == NULL || take_pixels() != PLT_OK) {
        return PLT_ERR_ARGUMENT;
    }
    viewing_aim();
    if (viewed.options.whitted > 0 && plt_lighting_set(viewed.engine, &viewed.lighting) != PLT_OK) {
        return fail_set(&viewed.why, "lights", "their numbers are out of range");
    }
    coarse_moved(&viewed.coarse);
    return PLT_OK;
}

/* The finest frame has as many pixels as the screen, and of each all samples. */
static int begin_frame(void) {
    viewed.level = viewed.coarse.level;
    const int is_finest = viewed.level == COARSE_FINEST;
    viewed.frame.width =
        (uint16_t)(is_finest ? viewed.width : coarse_side(&viewed.coarse, viewed.width));
    viewed.frame.height =
        (uint16_t)(is_finest ? viewed.height : coarse_side(&viewed.coarse, viewed.height));
    viewed.frame.samples = is_finest ? viewed.samples : (uint8_t)PLT_SAMPLES_ONE;
    viewed.frame.camera = pose_camera(&viewed.pose);
    viewed.coarse.is_due = 0;
    viewed.coming.width = viewed.frame.width;
    viewed.coming.height = viewed.frame.height;
    viewed.steps = viewed.tiles = 0;
    viewed.busy_ms = viewed.longest_ms = 0.0;
    memset(viewed.rgba, 0, (size_t)4 * viewed.frame.width * viewed.frame.height);
    plt_stats_reset(viewed.engine);
    const int status = plt_render_begin(viewed.engine, &viewed.frame);
    viewed.is_rendering = status == PLT_OK;
    if (status != PLT_OK) {
        fail_set(&viewed.why, "frame",
                 "this scene cannot be shown so; choose another shader, or fewer "
                 "samples");
    }
    return status;
}

static void take_tile(void) {
    plt_tile t;
    plt_render_tile(viewed.engine, &t);
    frame_copy_tile(viewed.engine, &viewed.coming);
    for (unsigned y = 0; y < t.height; y++) {
        const uint8_t *from = t.rgb + 3 * (size_t)y * t.width;
        uint8_t *to = viewed.rgba + 4 * ((size_t)(t.y + y) * viewed.frame.width + t.x);
        for (unsigned x = 0; x < t.width; x++, from += 3, to += 4) {
            to[0] = from[0];
            to[1] = from[1];
            to[2] = from[2];
            to[3] = 255;
        }
    }
    viewed.tiles++;
}

static void end_frame(void) {
    const size_t bytes = (size_t)3 * viewed.frame.width * viewed.frame.height;
    viewed.is_rendering = 0;
    memcpy(viewed.complete.rgb, viewed.coming.rgb, bytes);
    viewed.complete.width = viewed.frame.width;
    viewed.complete.height = viewed.frame.height;
    viewed.hash = hash_bytes(viewed.complete.rgb, bytes);
    viewed.is_new = 1;
    if (!viewed.coarse.is_due) { /* else the camera has moved on */
        coarse_complete(&viewed.coarse, 1e-3 * viewed.busy_ms);
        viewed.coarse.is_due =
            viewed.coarse.is_due && (viewed.level > COARSE_PLAIN || viewed.samples > 1);
    }
}

static int step(void) {
    const double at = web_clock();
    const int status = plt_render_step(viewed.engine, STEP_VISITS);
    const double took = web_clock() - at;
    viewed.busy_ms += took;
    viewed.longest_ms = took > viewed.longest_ms ? took : viewed.longest_ms;
    viewed.steps++;
    return status;
}

static int failed(int status) {
    plt_fault fault;
    viewed.is_rendering = 0;
    plt_fault_get(viewed.engine, &fault);
    return viewing_fault(status, &fault);
}

int viewer_work(double until) {
    int news = 0, status = PLT_MORE;
    if (viewed.engine == NULL || (!viewed.is_rendering && !viewed.coarse.is_due)) {
        return 0;
    }
    if (!viewed.is_rendering ||
        (viewed.coarse.is_due &&
         coarse_give_up(&viewed.coarse, viewed.level, 1e-3 * viewed.busy_ms))) {
        status = begin_frame();
        if (status != PLT_OK) {
            return status;
        }
    }
    do {
        status = step();
        if (status == PLT_TILE) {
            take_tile();
            news |= VIEW_NEWS_TILES;
        }
    } while (status > PLT_OK && web_clock() < until);
    if (status < PLT_OK) {
        return failed(status);
    }
    if (status == PLT_OK) {
        end_frame();
        news |= VIEW_NEWS_COMPLETE;
    }
    return news;
}

const uint8_t *viewer_pixels(void) {
    return viewed.rgba;
}

uint64_t viewer_hash(void) {
    return viewed.hash;
}

const picture *viewer_picture(void) {
    return &viewed.complete;
}

int viewer_is_new(void) {
    const int is_new = viewed.is_new;
    viewed.is_new = 0;
    return is_new;
}
