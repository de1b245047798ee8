/* viewer - see viewer.h
 *
 * Memory: the image if it is mapped, the arena, then pixels, each behind the one before
 * (board/web/web.h).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/web/viewer.h"

#include <math.h>
#include <string.h>

#include "board/hash.h"
#include "board/web/web.h"
#include "host_tools/app/aim.h"
#include "host_tools/app/coarse.h"
#include "host_tools/app/daylight.h"
#include "host_tools/app/frame.h"
#include "host_tools/app/view.h"
#include "host_tools/base/fail.h"

#define DEGREE 0.017453292519943295

enum { STEP_VISITS = 1000, OPEN_SPLITS = 64, FIRST_LEVEL = COARSE_PLAIN + 2 };

typedef struct viewing {
    fail why;
    size_t need_bytes;
    plt_source source;
    int where;
    uint32_t before_arena, before_pixels; /* marks of the room */
    void *arena;
    uint32_t arena_bytes;
    plt_options options;
    plt_engine *engine; /* NULL: there is no scene, or it is not open yet */
    plt_engine *opening;
    plt_frame frame;
    unsigned width, height;       /* of the frame at rest */
    uint8_t samples;              /* likewise */
    int has_camera, has_lighting; /* first ones that were given, or are known already */
    plt_camera first;
    plt_lighting lighting;
    pose pose;
    coarse coarse;
    int is_rendering;
    unsigned level; /* of the frame that is rendered */
    picture coming, complete;
    uint8_t *rgba;
    int is_new;
    uint64_t hash;
    double busy_ms, longest_ms; /* of the frame */
    uint32_t steps, tiles;
} viewing;

static viewing v;

const char *viewer_why(void) {
    return v.why.text;
}

/* ---- opening ------------------------------------------------------------------------ */

void *viewer_begin(uint32_t bytes, int where, int is_same) {
    v.why.text[0] = '\0';
    v.engine = v.opening = NULL;
    v.is_rendering = v.is_new = 0;
    v.complete = (picture){NULL, 0, 0}; /* its memory is given to others */
    v.where = where;
    if (!is_same) {
        v.has_camera = v.has_lighting = 0;
        v.coarse = (coarse){.first = FIRST_LEVEL}; /* there is something to see at once */
    }
    web_room_begin();
    web_scene_of_page(&v.source, bytes);
    void *image = NULL;
    if (where == VIEW_MAPPED) {
        image = web_room_take(bytes);
        v.source = (plt_source){.mapped = image, .bytes = bytes};
        if (image == NULL) {
            fail_set(&v.why, "image", "its %u bytes are more than the browser has; stream it",
                     bytes);
        }
    }
    v.before_arena = web_room_mark();
    return image;
}

static int say_fault(int status, const plt_fault *fault) {
    v.need_bytes = status == PLT_ERR_ARENA ? fault->need_bytes : 0;
    if (status == PLT_ERR_ARENA) {
        fail_set(&v.why, "arena",
                 "the scene needs %u bytes and there are %u; choose a larger one%s",
                 (unsigned)fault->need_bytes, v.arena_bytes,
                 v.where == VIEW_FETCHED    ? ", or leave the scene where it lies"
                 : v.where == VIEW_STREAMED ? ""
                                            : ", or stream the scene");
    } else if (fault->rule > 0) {
        fail_set(&v.why, "image",
                 "%s (rule %c%u, byte %u); pack the mesh again, or copy the file "
                 "again",
                 fault->message, fault->kind, fault->rule, fault->offset);
    } else if (status == PLT_ERR_SOURCE) {
        fail_set(&v.why, "file", "byte %u cannot be read; copy the file again, it may be cut",
                 fault->offset);
    } else {
        fail_set(&v.why, "scene", "%s; choose another shader, or pack it otherwise",
                 fault->message);
    }
    return status;
}

/* What a scene is opened for depends on what its frames are to show. */
static void choose_options(const plt_info *info, unsigned shader) {
    const int has_surface = info->normal_bytes > 0 || info->colour_bytes > 0 ||
                            info->texcoord_bytes > 0 || info->page_bytes > 0;
    v.options = (plt_options){.residency = v.where == VIEW_STREAMED ? PLT_RESIDENCY_STREAMED
                                                                    : PLT_RESIDENCY_WHOLE};
    v.options.surface = shader == PLT_SHADE_SMOOTH;
    if (shader == PLT_SHADE_WHITTED) {
        v.options.whitted = 1 + (v.has_lighting ? v.lighting.bounces : DAYLIGHT_BOUNCES);
        v.options.surface = has_surface;
        if (plt_arena_need(info, 0, &v.options) == 0) {
            v.options.surface = 0; /* not streamed, unless they are in pages */
        }
    }
    if (v.options.surface && v.where != VIEW_STREAMED && info->texture_bytes > 0) {
        v.options.textures = PLT_TEXTURES_BILINEAR;
    }
}

static int opened(int status, const plt_fault *fault) {
    if (status < PLT_OK) {
        v.opening = NULL;
        return say_fault(status, fault);
    }
    if (status == PLT_OK) {
        v.engine = v.opening;
        v.opening = NULL;
        v.before_pixels = web_room_mark();
    }
    return status;
}

int viewer_open(uint32_t arena_bytes, unsigned shader, unsigned samples) {
    plt_info info;
    plt_fault fault = {.message = ""};
    v.why.text[0] = '\0';
    v.need_bytes = 0;
    v.engine = NULL;
    web_room_back(v.before_arena);
    v.arena = web_room_take(arena_bytes);
    v.arena_bytes = arena_bytes;
    if (v.arena == NULL) {
        return fail_set(&v.why, "arena",
                        "its %u bytes are more than the browser has; choose a "
                        "smaller one",
                        arena_bytes);
    }
    int status = plt_image_info(&v.source, &info, &fault);
    if (status != PLT_OK) {
        return say_fault(status, &fault);
    }
    choose_options(&info, shader);
    v.frame.shader = (uint8_t)shader;
    v.samples = (uint8_t)samples;
    web_stack_paint();
    status = plt_open_begin(&v.opening, v.arena, arena_bytes, &v.source, &v.options, &fault);
    return opened(status, &fault);
}

int viewer_open_step(void) {
    plt_fault fault;
    const int status = v.opening != NULL ? plt_open_step(v.opening, OPEN_SPLITS, &fault) : PLT_OK;
    return v.opening != NULL ? opened(status, &fault) : status;
}

/* ---- camera and light --------------------------------------------------------------- */

void viewer_camera(float eye_x, float eye_y, float eye_z, float look_x, float look_y, float look_z,
                   float fov) {
    v.first = (plt_camera){.eye = {eye_x, eye_y, eye_z},
                           .look = {look_x, look_y, look_z},
                           .up = {0.0f, 1.0f, 0.0f},
                           .tan_half_fov = (float)tan(0.5 * (double)fov * DEGREE)};
    v.has_camera = 1;
    pose_begin(&v.pose, &v.first);
}

static void begin_lighting(void) {
    if (!v.has_lighting) {
        v.lighting = (plt_lighting){
            .sky = DAYLIGHT_SKY, .ground = DAYLIGHT_GROUND, .bounces = DAYLIGHT_BOUNCES};
        v.has_lighting = 1;
    }
}

void viewer_sun(float x, float y, float z, float power, float radius, unsigned samples) {
    begin_lighting();
    v.lighting.light[0] = (plt_light){.at = {x, y, z},
                                      .power = {power, power, power},
                                      .radius = radius,
                                      .kind = PLT_LIGHT_DISTANT,
                                      .samples = (uint8_t)samples};
    v.lighting.lights = 1;
}

void viewer_sky(float r, float g, float b, float r_below, float g_below, float b_below) {
    begin_lighting();
    v.lighting.sky[0] = r, v.lighting.sky[1] = g, v.lighting.sky[2] = b;
    v.lighting.ground[0] = r_below, v.lighting.ground[1] = g_below, v.lighting.ground[2] = b_below;
}

/* That of `planelet render`: all that is seen as large as it fits. */
static void usual_camera(void) {
    const plt_info *info = plt_engine_info(v.engine);
    const sight seen = {.engine = info->frames == 0 ? v.engine : NULL};
    const aim to = {.info = info, .seen = &seen, .aspect = (double)v.width / v.height};
    view_of_all(info, v.width, v.height, &v.first);
    aim_camera(&to, &v.first);
    v.has_camera = 1;
    pose_begin(&v.pose, &v.first);
}

static void moved(int has_moved) {
    if (has_moved) {
        coarse_moved(&v.coarse);
    }
}

void viewer_steer(unsigned action) {
    moved(v.has_camera && action < STEER_ACTIONS && steer(&v.pose, (enum steer_action)action));
}

void viewer_turn(double azimuth, double elevation) {
    moved(v.has_camera && pose_turn(&v.pose, azimuth, elevation));
}

void viewer_zoom(double factor) {
    moved(v.has_camera && pose_zoom(&v.pose, factor));
}

/* ---- frames ------------------------------------------------------------------------- */

static int take_pixels(void) {
    const uint32_t count = v.width * v.height;
    web_room_back(v.before_pixels);
    v.coming = (picture){web_room_take(3 * count), v.width, v.height};
    v.complete = (picture){web_room_take(3 * count), 0, 0}; /* until a frame is complete */
    v.rgba = web_room_take(4 * count);
    v.is_new = 0;
    if (v.coming.rgb == NULL || v.complete.rgb == NULL || v.rgba == NULL) {
        return fail_set(&v.why, "picture",
                        "%u x %u pixels are more than the browser has; choose "
                        "fewer",
                        v.width, v.height);
    }
    return PLT_OK;
}

int viewer_size(unsigned width, unsigned height) {
    v.is_rendering = 0;
    v.width = width;
    v.height = height;
    if (v.engine == NULL || take_pixels() != PLT_OK) {
        return PLT_ERR_ARGUMENT;
    }
    if (!v.has_camera) {
        usual_camera();
    }
    begin_lighting();
    if (v.lighting.lights == 0) {
        daylight_sun(&v.lighting.light[0], &v.first);
        v.lighting.lights = 1;
    }
    if (v.options.whitted > 0 && plt_lighting_set(v.engine, &v.lighting) != PLT_OK) {
        return fail_set(&v.why, "lights", "their numbers are out of range");
    }
    coarse_moved(&v.coarse);
    return PLT_OK;
}

/* The finest frame has as many pixels as the screen, and of each all samples. */
static int begin_frame(void) {
    v.level = v.coarse.level;
    const int is_finest = v.level == COARSE_FINEST;
    v.frame.width = (uint16_t)(is_finest ? v.width : coarse_side(&v.coarse, v.width));
    v.frame.height = (uint16_t)(is_finest ? v.height : coarse_side(&v.coarse, v.height));
    v.frame.samples = is_finest ? v.samples : (uint8_t)PLT_SAMPLES_ONE;
    v.frame.camera = pose_camera(&v.pose);
    v.coarse.is_due = 0;
    v.coming.width = v.frame.width;
    v.coming.height = v.frame.height;
    v.steps = v.tiles = 0;
    v.busy_ms = v.longest_ms = 0.0;
    memset(v.rgba, 0, (size_t)4 * v.frame.width * v.frame.height);
    plt_stats_reset(v.engine);
    const int status = plt_render_begin(v.engine, &v.frame);
    v.is_rendering = status == PLT_OK;
    if (status != PLT_OK) {
        fail_set(&v.why, "frame",
                 "this scene cannot be shown so; choose another shader, or fewer "
                 "samples");
    }
    return status;
}

static void take_tile(void) {
    plt_tile t;
    plt_render_tile(v.engine, &t);
    frame_copy_tile(v.engine, &v.coming);
    for (unsigned y = 0; y < t.height; y++) {
        const uint8_t *from = t.rgb + 3 * (size_t)y * t.width;
        uint8_t *to = v.rgba + 4 * ((size_t)(t.y + y) * v.frame.width + t.x);
        for (unsigned x = 0; x < t.width; x++, from += 3, to += 4) {
            to[0] = from[0];
            to[1] = from[1];
            to[2] = from[2];
            to[3] = 255;
        }
    }
    v.tiles++;
}

static void end_frame(void) {
    const size_t bytes = (size_t)3 * v.frame.width * v.frame.height;
    v.is_rendering = 0;
    memcpy(v.complete.rgb, v.coming.rgb, bytes);
    v.complete.width = v.frame.width;
    v.complete.height = v.frame.height;
    v.hash = hash_bytes(v.complete.rgb, bytes);
    v.is_new = 1;
    if (!v.coarse.is_due) { /* else the camera has moved on */
        coarse_complete(&v.coarse, 1e-3 * v.busy_ms);
        v.coarse.is_due = v.coarse.is_due && (v.level > COARSE_PLAIN || v.samples > 1);
    }
}

static int step(void) {
    const double at = web_clock();
    const int status = plt_render_step(v.engine, STEP_VISITS);
    const double took = web_clock() - at;
    v.busy_ms += took;
    v.longest_ms = took > v.longest_ms ? took : v.longest_ms;
    v.steps++;
    return status;
}

static int failed(int status) {
    plt_fault fault;
    v.is_rendering = 0;
    plt_fault_get(v.engine, &fault);
    return say_fault(status, &fault);
}

int viewer_work(double until) {
    int news = 0, status = PLT_MORE;
    if (v.engine == NULL || (!v.is_rendering && !v.coarse.is_due)) {
        return 0;
    }
    if (!v.is_rendering ||
        (v.coarse.is_due && coarse_give_up(&v.coarse, v.level, 1e-3 * v.busy_ms))) {
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
    return v.rgba;
}

uint64_t viewer_hash(void) {
    return v.hash;
}

const picture *viewer_picture(void) {
    return &v.complete;
}

int viewer_is_new(void) {
    const int is_new = v.is_new;
    v.is_new = 0;
    return is_new;
}

/* ---- numbers ------------------------------------------------------------------------ */

static double of_scene(const plt_info *info, unsigned which) {
    switch (which) {
    case NUMBER_TRIANGLES:
        return info->placed_triangles > 0 ? info->placed_triangles : info->triangles;
    case NUMBER_HAS_SURFACE:
        return info->normal_bytes > 0 || info->colour_bytes > 0 || info->page_bytes > 0;
    case NUMBER_HAS_MATERIALS:
        return info->material_bytes > 0;
    default:
        return info->frames;
    }
}

static double of_engine(unsigned which) {
    plt_stats stats;
    plt_stats_get(v.engine, &stats);
    switch (which) {
    case NUMBER_ARENA_PEAK:
        return (double)plt_arena_peak(v.engine);
    case NUMBER_RAYS:
        return (double)stats.rays;
    case NUMBER_BYTES_FETCHED:
        return v.where == VIEW_STREAMED ? (double)stats.bytes_fetched : 0.0;
    case NUMBER_TILES_ALL:
        return v.is_rendering ? plt_render_tiles(v.engine) : v.tiles;
    default:
        return of_scene(plt_engine_info(v.engine), which);
    }
}

double viewer_number(unsigned which) {
    switch (which) {
    case NUMBER_IMAGE_BYTES:
        return v.source.bytes;
    case NUMBER_NEED_BYTES:
        return (double)v.need_bytes;
    case NUMBER_ARENA_BYTES:
        return v.arena_bytes;
    case NUMBER_STACK_USED:
        return web_stack_used();
    case NUMBER_STACK_BYTES:
        return web_stack_bytes();
    case NUMBER_WIDTH:
        return v.frame.width;
    case NUMBER_HEIGHT:
        return v.frame.height;
    case NUMBER_LEVEL:
        return v.level;
    case NUMBER_IS_DUE:
        return v.coarse.is_due || v.is_rendering;
    case NUMBER_STEPS:
        return v.steps;
    case NUMBER_LONGEST_MS:
        return v.longest_ms;
    case NUMBER_BUSY_MS:
        return v.busy_ms;
    case NUMBER_TILES:
        return v.tiles;
    case NUMBER_EYE_X:
    case NUMBER_EYE_Y:
    case NUMBER_EYE_Z:
        return (double)v.frame.camera.eye[which - NUMBER_EYE_X];
    case NUMBER_LOOK_X:
    case NUMBER_LOOK_Y:
    case NUMBER_LOOK_Z:
        return (double)v.frame.camera.look[which - NUMBER_LOOK_X];
    default:
        return v.engine != NULL && which < NUMBERS ? of_engine(which) : 0.0;
    }
}
