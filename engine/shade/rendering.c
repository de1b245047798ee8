/* rendering - see rendering.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/rendering.h"

#include "engine/base/small_stack.h"
#include "engine/shade/mixing.h"
#include "engine/shade/packet_shade.h"
#include "engine/shade/smooth.h"
#include "engine/shade/tile_sky.h"
#include "engine/shade/whitted_frame.h"
#include "engine/shade/whitted_mix.h"
#include "engine/trace/kept.h"
#include "engine/whitted/whitted.h"

/* A constant where there is no choice, and the compiler leaves the other way out. */
#define HAS_BEAMS(r) (PLT_WITH_BEAMS && (!PLT_WITH_GROUPS || (r)->beams))

#if PLT_WITH_STREAMED
#define HAS_CURVES(r) ((r)->curves)
#else
#define HAS_CURVES(r) 0
#endif

#if PLT_WITH_BATCH
#define HAS_BATCHES(r) ((r)->batch != NULL)
#else
#define HAS_BATCHES(r) 0
#endif

#if PLT_WITH_WHITTED
#define HAS_LIGHTS(r) ((r)->frame.shader == PLT_SHADE_WHITTED)
#else
#define HAS_LIGHTS(r) 0
#endif

/* Packets are traced elsewhere (frame_packets.h). */
#if PLT_WITH_TASK
#define HAS_TASKS(r) ((r)->by_tasks)
#else
#define HAS_TASKS(r) 0
#endif

#if PLT_WITH_SURFACE
#define IS_SMOOTH(r) ((r)->frame.shader == PLT_SHADE_SMOOTH)
#else
#define IS_SMOOTH(r) 0
#endif

void plt_rendering_init(plt_rendering *r, uint8_t *tile, void *beam, uint32_t packet_side) {
    const plt_rendering idle = {.beam = beam, .tile = tile, .side = packet_side, .done = 1};
    *r = idle;
}

/* Beams keep to the depth-first order. They take the fewest instructions, but depend on one
 * another: where four lanes are one register, groups are faster on large meshes (DESIGN.md,
 * section 6). */
static int has_beams(const plt_rendering *r, const plt_traversal *t) {
    const unsigned format = t->scene->format;
    return !PLT_LANES_REGISTERS && t->order == PLT_ORDER_DEPTH_FIRST && !HAS_BATCHES(r) &&
           !HAS_TASKS(r) && !HAS_LIGHTS(r) && plt_has_beams(format) &&
           (!plt_has_store(format) || r->side >= PLT_BEAM_BLOCKS_LEAST);
}

#if PLT_WITH_INSTANCES
/* Rays may meet an instance where they miss its box by that much. */
static void set_box(plt_rendering *r, const plt_scene *scene) {
    const plt_box *box = &scene->box;
    float reach = 0.0f;
    if (scene->format != PLT_FORMAT_INSTANCES) {
        return;
    }
    for (int a = 0; a < 3; a++) {
        const float below = __builtin_fabsf(box->lo[a] - r->view.eye[a]);
        const float above = __builtin_fabsf(box->hi[a] - r->view.eye[a]);
        reach = below > reach ? below : reach;
        reach = above > reach ? above : reach;
    }
    for (int a = 0; a < 3; a++) {
        float margin[4];
        f4_store(margin, plt_placed_margin(scene->instanced.spread, f4_all(2.0f * reach),
                                           f4_all(r->view.eye[a])));
        r->box.lo[a] = box->lo[a] - margin[0];
        r->box.hi[a] = box->hi[a] + margin[0];
    }
}
#endif

#if PLT_WITH_GROUPS
static const plt_box *box_of(const plt_rendering *r, const plt_traversal *t) {
#if PLT_WITH_INSTANCES
    if (t->scene->format == PLT_FORMAT_INSTANCES) {
        return &r->box;
    }
#endif
    (void)r;
    return &t->scene->box;
}
#endif

/* Both orders begin with the first tile of the first row. */
static void set_order(plt_rendering *r, int curves) {
#if PLT_WITH_STREAMED
    const plt_tile_order order = {.columns = plt_tiles_along(r->frame.width),
                                  .rows = plt_tiles_along(r->frame.height)};
    r->at.order = order;
    r->curves = (uint8_t)curves;
#else
    (void)r;
    (void)curves;
#endif
}

/* The rays of a packet, and how many of them lie in the frame. */
static uint32_t pixels_at(const plt_rendering *r, const plt_frame_place *at, plt_pixels *pixels) {
#if PLT_WITH_SAMPLES
    plt_samples_at(r, at, pixels);
#else
    const plt_pixels all = {r->side, at->x + at->px, at->y + at->py, r->frame.width,
                            r->frame.height};
    *pixels = all;
#endif
    return plt_least(r->side, pixels->x_end - pixels->x) *
           plt_least(r->side, pixels->y_end - pixels->y);
}

static inline void set_beam(plt_rendering *r, const plt_traversal *t) {
    if (HAS_BEAMS(r)) {
        plt_beam_init(r->beam, &r->view, &r->frame, t->scene, r->side);
    }
}

#if PLT_WITH_GROUPS
static int wants_weights(const plt_rendering *r, const plt_traversal *t) {
#if PLT_WITH_WHITTED
    return HAS_LIGHTS(r) && plt_whitted_frame_wants_weights(t);
#else
    (void)r;
    (void)t;
    return 0;
#endif
}

static void begin_lights(plt_rendering *r, const plt_packet *p, const plt_pixels *pixels) {
#if PLT_WITH_WHITTED
    if (HAS_LIGHTS(r)) {
        plt_whitted_frame_begin(r->whitted, &r->view, p, pixels);
    }
#else
    (void)r;
    (void)p;
    (void)pixels;
#endif
}
#endif

/* Pixels with lights, wherever they are in the square, that are traced again. */
static inline int has_some(const plt_rendering *r) {
#if PLT_WITH_WHITTED && PLT_WITH_SAMPLES
    return HAS_LIGHTS(r) && r->sampling.adapts && r->sampling.across == 4;
#else
    (void)r;
    return 0;
#endif
}

/* What packets keep of hits lies where beams of the frame before may have kept numbers. */
static void set_kept(const plt_rendering *r, const plt_traversal *t) {
#if PLT_WITH_PAGES && PLT_WITH_GROUPS
    if (t->scene->surface.is_open && plt_is_streamed(t->scene->format) && !HAS_BEAMS(r)) {
        plt_kept_init(t->kept, r->side * r->side);
    }
#else
    (void)r;
    (void)t;
#endif
}

/* What packets of the view have in common. */
static inline void set_view_of_lights(const plt_rendering *r) {
#if PLT_WITH_WHITTED
    if (HAS_LIGHTS(r)) {
        plt_whitted_frame_view(r->whitted, &r->frame, &r->view);
    }
#else
    (void)r;
#endif
}

PLT_APART_ON_SMALL_STACKS static void begin_packet(plt_rendering *r, plt_traversal *t,
                                                   plt_packet *p, const plt_pixels *pixels,
                                                   uint32_t rays) {
    r->tracing = 1;
    set_view_of_lights(r);
#if PLT_WITH_MIXES
    r->visits = t->stats.node_visits;
    if (r->sampling.adapts) {
        set_beam(r, t);
    }
#endif
    if ((HAS_CURVES(r) ? r->at.px == 0 : pixels->x == 0) && r->at.py == 0) {
        plt_tile_sky(&r->frame, &r->at, r->sky);
    }
    if (HAS_BEAMS(r)) {
        plt_beam_begin(r->beam, pixels, t, rays);
        return;
    }
#if PLT_WITH_WHITTED && PLT_WITH_SAMPLES
    if (has_some(r)) {
        plt_whitted_mix_again(r->whitted, t, p, &r->view, &r->sampling, r->at.x + r->at.px,
                              r->at.y + r->at.py);
        return;
    }
#endif
#if PLT_WITH_GROUPS
    plt_view_packet(&r->view, box_of(r, t), p, pixels);
    const int keeps = IS_SMOOTH(r) || wants_weights(r, t);
    if (keeps) {
        plt_packet_want_weights(p);
    }
#if PLT_WITH_PAGES
    t->keeps = (uint8_t)(keeps && plt_is_streamed(t->scene->format));
#endif
    plt_traversal_begin(t, p, rays);
    begin_lights(r, p, pixels);
#else
    (void)p;
#endif
}

#if PLT_WITH_WHITTED
static void shade_lights(plt_rendering *r, const plt_pixels *pixels, uint8_t *rgb,
                         uint32_t row_bytes) {
#if PLT_WITH_SAMPLES
    if (has_some(r)) {
        plt_whitted_mix_finer(r->whitted, &r->sampling, rgb, row_bytes);
        return;
    }
    if (r->sampling.across > 1) {
        plt_whitted_mix(r->whitted, &r->sampling, pixels, rgb, row_bytes);
        return;
    }
#endif
    plt_whitted_frame_shade(r->whitted, &r->frame, pixels, rgb, row_bytes);
}
#endif

static void shade_packet(plt_rendering *r, const plt_packet *p, const plt_pixels *pixels) {
#if PLT_WITH_GROUPS
    const uint32_t width = plt_tile_width(&r->frame, &r->at);
#if PLT_WITH_WHITTED
    if (HAS_LIGHTS(r)) {
        shade_lights(r, pixels, &r->tile[3 * (r->at.py * width + r->at.px)], 3 * width);
        return;
    }
#endif
#if PLT_WITH_MIXES
    if (plt_mixes(r)) {
        plt_packet_mix(p, &r->sampling, pixels, plt_mix_sky(r), plt_mix_tile(r), 3 * width);
        return;
    }
#endif
    plt_packet_shade(p, &r->frame, pixels, &r->sky[3 * r->at.py],
                     &r->tile[3 * (r->at.py * width + r->at.px)], 3 * width);
#else
    (void)r;
    (void)p;
    (void)pixels;
#endif
}

static void shade_square(plt_rendering *r) {
#if PLT_WITH_BEAMS
    const uint32_t width = plt_tile_width(&r->frame, &r->at);
#if PLT_WITH_MIXES
    if (plt_mixes(r)) {
        plt_beam_mix(r->beam, &r->sampling, plt_mix_sky(r), plt_mix_tile(r), 3 * width);
        return;
    }
#endif
    plt_beam_shade(r->beam, &r->frame, &r->sky[3 * r->at.py],
                   &r->tile[3 * (r->at.py * width + r->at.px)], 3 * width);
#else
    (void)r;
#endif
}

#if PLT_WITH_SURFACE && PLT_WITH_SAMPLES
static int mix_smooth(plt_rendering *r, const plt_smooth *how, const plt_packet *p,
                      const plt_pixels *pixels) {
    const uint32_t row_bytes = 3 * plt_tile_width(&r->frame, &r->at);
    uint8_t *rgb = plt_mix_tile(r);
    const uint8_t *sky = plt_mix_sky(r);
#if PLT_WITH_BEAMS
    if (HAS_BEAMS(r)) {
        return plt_beam_smooth_mix(r->beam, how, &r->sampling, sky, rgb, row_bytes);
    }
#endif
#if PLT_WITH_GROUPS
    return plt_smooth_mix(how, p, &r->sampling, pixels, sky, rgb, row_bytes);
#endif
    (void)p;
    (void)pixels;
    return PLT_OK;
}
#endif

/* The colours of a square, or packet, by normals and colours of corners. PLT_OK, or what a fetch
 * failed with. */
PLT_APART_ON_SMALL_STACKS static int shade_smooth(plt_rendering *r, plt_traversal *t,
                                                  const plt_packet *p, const plt_pixels *pixels) {
#if PLT_WITH_SURFACE
    const uint32_t width = plt_tile_width(&r->frame, &r->at);
    uint8_t *rgb = &r->tile[3 * (r->at.py * width + r->at.px)];
    const uint8_t *sky = &r->sky[3 * r->at.py];
#if PLT_WITH_TEXTURE
    r->paint.angle = plt_view_pixel_angle(&r->view, &r->frame);
    const plt_smooth how = {.traversal = t, .paint = &r->paint};
#else
    const plt_smooth how = {.traversal = t};
#endif
#if PLT_WITH_SAMPLES
    if (r->sampling.across > 1) {
        return mix_smooth(r, &how, p, pixels);
    }
#endif
#if PLT_WITH_BEAMS
    if (HAS_BEAMS(r)) {
        return plt_beam_smooth(r->beam, &how, sky, rgb, 3 * width);
    }
#endif
#if PLT_WITH_GROUPS
    return plt_smooth_shade(&how, p, pixels, sky, rgb, 3 * width);
#endif
#endif
    (void)r;
    (void)t;
    (void)p;
    (void)pixels;
    return PLT_OK;
}

/* What one packet, and no other, has traced. */
PLT_APART_ON_SMALL_STACKS static void shade(plt_rendering *r, const plt_traversal *t,
                                            const plt_packet *p, const plt_pixels *pixels) {
#if PLT_WITH_DIAGRAMS
    if (r->frame.shader == PLT_SHADE_HEAT) {
        plt_mix_heat(r, t->stats.node_visits - r->visits);
        return;
    }
#else
    (void)t;
#endif
    if (HAS_BEAMS(r)) {
        shade_square(r);
    } else {
        shade_packet(r, p, pixels);
    }
}

/* Whether there is such a shader, of this scene. */
static int is_shader(uint8_t shader, const plt_scene *scene) {
#if PLT_WITH_SURFACE
    if (shader == PLT_SHADE_SMOOTH) {
        return scene->surface.is_open;
    }
#endif
    (void)scene;
    return shader <= PLT_SHADE_TRIANGLE ||
           (PLT_WITH_DIAGRAMS && (shader == PLT_SHADE_DEPTH || shader == PLT_SHADE_HEAT));
}

#if PLT_WITH_BATCH
/* ---- many packets at a time ------------------------------------------------ */

enum { BATCH_ADDS, BATCH_TRACES, BATCH_SHADES };

void plt_rendering_begin_batches(plt_rendering *r, uint32_t tiles) {
    r->ahead = r->at;
    r->tiles_ahead = tiles;
    r->all_added = 0;
    r->phase = BATCH_ADDS;
    if (r->batch != NULL) {
        plt_batch_clear(r->batch);
    }
}

int plt_rendering_ahead(plt_rendering *r) {
    return plt_place_next_packet(&r->ahead, &r->frame, plt_rendering_side(r)) ||
           (--r->tiles_ahead > 0 && plt_place_next_tile(&r->ahead, &r->frame, HAS_CURVES(r)));
}

PLT_APART_ON_SMALL_STACKS static int add_packet(plt_rendering *r, plt_traversal *t) {
    plt_pixels pixels;
    plt_batch *b = r->batch;
    if (r->all_added) { /* of what was wanted; the caller goes on */
        plt_rendering_begin_batches(r, UINT32_MAX);
    }
    const uint32_t rays = pixels_at(r, &r->ahead, &pixels);
    plt_view_packet(&r->view, box_of(r, t), &b->packet[b->count], &pixels);
    plt_batch_add(b, t, rays);
    r->all_added = (uint8_t)!plt_rendering_ahead(r);
    if (r->all_added || b->count == b->most) {
        r->phase = BATCH_TRACES;
    }
    return PLT_MORE;
}

static int trace_batch(plt_rendering *r, plt_traversal *t, uint32_t visits) {
    const int status = plt_batch_trace(r->batch, t, visits);
    if (status == PLT_OK) {
        r->phase = BATCH_SHADES;
        r->shaded = 0;
        return PLT_MORE;
    }
    r->done = status < 0;
    return status;
}

PLT_APART_ON_SMALL_STACKS static int shade_next(plt_rendering *r) {
    plt_batch *b = r->batch;
    if (r->at.px == 0 && r->at.py == 0) {
        plt_tile_sky(&r->frame, &r->at, r->sky);
    }
    plt_pixels pixels;
    pixels_at(r, &r->at, &pixels);
    shade_packet(r, &b->packet[r->shaded++], &pixels);
    if (r->shaded == b->count) {
        plt_batch_clear(b);
        r->phase = BATCH_ADDS;
    }
    return plt_place_next_packet(&r->at, &r->frame, plt_rendering_side(r)) ? PLT_MORE : PLT_TILE;
}

PLT_APART_ON_SMALL_STACKS static int step_batch(plt_rendering *r, plt_traversal *t,
                                                uint32_t visits) {
    switch (r->phase) {
    case BATCH_ADDS:
        return add_packet(r, t);
    case BATCH_TRACES:
        return trace_batch(r, t, visits);
    default:
        return shade_next(r);
    }
}

#else
static int step_batch(plt_rendering *r, plt_traversal *t, uint32_t visits) {
    (void)r;
    (void)t;
    return (int)visits;
}
#endif

static int has_lights(const plt_rendering *r, const plt_frame *frame) {
#if PLT_WITH_WHITTED
    return plt_whitted_frame_valid(r->whitted, frame);
#else
    (void)r;
    (void)frame;
    return 0;
#endif
}

int plt_rendering_begin(plt_rendering *r, const plt_frame *frame, const plt_traversal *t) {
    r->done = 1;
    if (frame->width == 0 || frame->height == 0 ||
        !(is_shader(frame->shader, t->scene) || has_lights(r, frame))) {
        return PLT_ERR_ARGUMENT;
    }
#if PLT_WITH_MIXES
    if (!plt_mixing_allowed(r, frame, HAS_BATCHES(r) || HAS_TASKS(r))) {
        return PLT_ERR_ARGUMENT;
    }
#endif
    r->frame = *frame;
    const int status = plt_view_set(&r->view, frame);
    if (status == PLT_OK) {
#if PLT_WITH_MIXES
        plt_mixing_begin(r, &t->scene->box);
#endif
#if PLT_WITH_INSTANCES
        set_box(r, t->scene);
#endif
#if PLT_WITH_WHITTED
        plt_whitted_frame_set(r->whitted, &r->frame, box_of(r, t));
#endif
        r->beams = (uint8_t)has_beams(r, t);
        set_beam(r, t);
        set_kept(r, t);
        set_order(r, plt_is_streamed(t->scene->format));
        r->at.x = r->at.y = r->at.px = r->at.py = 0;
        r->tracing = r->done = 0;
        plt_rendering_begin_batches(r, UINT32_MAX);
    }
    return status;
}

static int trace(plt_rendering *r, plt_traversal *t, plt_packet *p, uint32_t visits) {
#if PLT_WITH_WHITTED
    if (HAS_LIGHTS(r)) {
        return plt_whitted_step(r->whitted, t, p, visits);
    }
#endif
    return HAS_BEAMS(r) ? plt_beam_trace(r->beam, t, visits) : plt_traverse(t, p, visits);
}

int plt_rendering_step(plt_rendering *r, plt_traversal *t, plt_packet *p, uint32_t visits) {
    if (!r->done && r->at.py >= plt_tile_height(&r->frame, &r->at)) {
        r->done = (uint8_t)!plt_place_next_tile(&r->at, &r->frame, HAS_CURVES(r));
    }
    if (r->done) {
        return PLT_OK;
    }
    visits = visits > 0 ? visits : 1;
    if (HAS_BATCHES(r)) {
        return step_batch(r, t, visits);
    }
    plt_pixels pixels;
    const uint32_t rays = pixels_at(r, &r->at, &pixels);
    if (!r->tracing) {
        begin_packet(r, t, p, &pixels, rays);
    }
    int status = trace(r, t, p, visits);
    if (IS_SMOOTH(r) && status == PLT_OK) { /* which may have to fetch */
        status = shade_smooth(r, t, p, &pixels);
    }
    if (status < 0) {
        r->done = 1;
    }
    if (status != PLT_OK) {
        return status;
    }
    if (!IS_SMOOTH(r)) {
        shade(r, t, p, &pixels);
    }
    r->tracing = 0;
#if PLT_WITH_SAMPLES
    if (plt_samples_again(r)) {
        return PLT_MORE;
    }
#endif
    return plt_place_next_packet(&r->at, &r->frame, plt_rendering_side(r)) ? PLT_MORE : PLT_TILE;
}

void plt_rendering_tile(const plt_rendering *r, plt_tile *tile) {
    tile->rgb = r->tile;
    tile->x = (uint16_t)r->at.x;
    tile->y = (uint16_t)r->at.y;
    tile->width = (uint16_t)plt_tile_width(&r->frame, &r->at);
    tile->height = (uint16_t)plt_tile_height(&r->frame, &r->at);
}
