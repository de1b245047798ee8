/* job - what the firmware is to do, read from its parameters
 *
 * SPDX-License-Identifier: MIT */
#include "board/job.h"

#include "board/line.h"
#include "board/parameters.h"

#if PLT_WITH_GRID
#define KEYS_OF_GRIDS " structure"
#else
#define KEYS_OF_GRIDS ""
#endif

#if PLT_WITH_WAVE
#define KEYS_OF_WAVE " flight rays"
#else
#define KEYS_OF_WAVE ""
#endif

#if PLT_WITH_WHITTED
#define KEYS_OF_LIGHTS " sun point sky ground depth shadows" KEYS_OF_WAVE
#else
#define KEYS_OF_LIGHTS ""
#endif

#if PLT_WITH_SAMPLES
#define KEYS_OF_SAMPLES " samples"
#else
#define KEYS_OF_SAMPLES ""
#endif
#if PLT_WITH_TEXTURE
#define KEYS_OF_TEXTURES " textures"
#else
#define KEYS_OF_TEXTURES ""
#endif

static const char keys[] =
    "size eye look up tan packet walk shader visits arena residency store schedule batch prefetch "
    "scene bytes frame hold" KEYS_OF_GRIDS KEYS_OF_LIGHTS KEYS_OF_SAMPLES KEYS_OF_TEXTURES;

enum { GIVEN_EYE = 1, GIVEN_LOOK = 2, GIVEN_UP = 4, GIVEN_TAN = 8 };

static int complain(const char *what, const parameter *p, const char *wanted) {
    line l;
    line_start(&l);
    line_text(&l, "error: ");
    line_text(&l, what);
    line_text(&l, " '");
    line_some(&l, p->text, p->length);
    line_text(&l, "'; ");
    line_text(&l, wanted);
    line_print(&l);
    return -1;
}

int job_u32(const char *all, const char *key, uint32_t least, uint32_t most, uint32_t *value) {
    parameter p;
    uint32_t read;
    if (!parameter_find(all, key, &p)) {
        return 0;
    }
    if (parameter_u32(&p, &read) < 0 || read < least || read > most) {
        return complain(key, &p, "an integer in its range is wanted");
    }
    *value = read;
    return 1;
}

static int read_floats(const char *all, const char *key, float *values, unsigned count) {
    parameter p;
    if (!parameter_find(all, key, &p)) {
        return 0;
    }
    if (parameter_floats(&p, values, count) < 0) {
        return complain(key, &p, "decimal numbers or 0x and the bits of floats are wanted");
    }
    return 1;
}

int job_word(const char *all, const char *key, const char *const *words, unsigned count,
             uint8_t *choice) {
    parameter p;
    if (!parameter_find(all, key, &p)) {
        return 0;
    }
    for (unsigned i = 0; i < count; i++) {
        if (parameter_is(&p, words[i])) {
            *choice = (uint8_t)i;
            return 1;
        }
    }
    return complain(key, &p, "not one of the words it may be");
}

static int read_size(const char *all, plt_frame *frame) {
    parameter p;
    uint32_t width = 320, height = 240;
    if (parameter_find(all, "size", &p) && (parameter_size(&p, &width, &height) < 0 || width < 1 ||
                                            width > 65535 || height < 1 || height > 65535)) {
        return complain("size", &p, "WIDTHxHEIGHT, each 1 .. 65535, is wanted");
    }
    frame->width = (uint16_t)width;
    frame->height = (uint16_t)height;
    return 0;
}

static int read_camera(const char *all, job *j) {
    plt_camera *c = &j->frame.camera;
    const int eye = read_floats(all, "eye", c->eye, 3);
    const int look = read_floats(all, "look", c->look, 3);
    const int up = read_floats(all, "up", c->up, 3);
    const int tan = read_floats(all, "tan", &c->tan_half_fov, 1);
    if (eye < 0 || look < 0 || up < 0 || tan < 0) {
        return -1;
    }
    j->given = (eye ? GIVEN_EYE : 0u) | (look ? GIVEN_LOOK : 0u) | (up ? GIVEN_UP : 0u) |
               (tan ? GIVEN_TAN : 0u);
    return 0;
}

/* textures=, as `planelet render` has it. */
static int read_textures(const char *all, job *j) {
#if PLT_WITH_TEXTURE
    static const char *const filters[] = {"none", "nearest", "bilinear"};
    j->options.textures = PLT_TEXTURES_BILINEAR;
    return job_word(all, "textures", filters, 3, &j->options.textures);
#else
    (void)all;
    (void)j;
    return 0;
#endif
}

#if PLT_WITH_WHITTED
/* Where it shines from, power, radius and samples. */
enum { LIGHT_NUMBERS = 6, DEPTH_USUAL = 4 };

static int read_light(const char *all, const char *key, uint8_t kind, plt_lighting *to) {
    float n[LIGHT_NUMBERS];
    const int status = read_floats(all, key, n, LIGHT_NUMBERS);
    if (status > 0) {
        const float samples = n[5] >= 1.0f && n[5] <= 255.0f ? n[5] : 0.0f; /* 0 is refused */
        const plt_light light = {
            {n[0], n[1], n[2]}, {n[3], n[3], n[3]}, n[4], kind, (uint8_t)samples};
        to->light[to->lights++] = light;
    }
    return status;
}

/* flight= and rays=: how many are in flight in a wave, and which go by it. */
static int read_wave(const char *all, job *j) {
#if PLT_WITH_WAVE
    static const char *const kinds[] = {"auto", "coherent", "incoherent"};
    uint32_t rays = 0;
    const int is_read = job_u32(all, "flight", 16, 64, &rays);
    j->options.rays_in_flight = (uint8_t)rays;
    return is_read < 0 ? is_read : job_word(all, "rays", kinds, 3, &j->options.rays);
#else
    (void)all;
    (void)j;
    return 0;
#endif
}

/* sun=, point=, sky=, ground=, depth= and shadows=, likewise. */
static int read_lights(const char *all, job *j) {
    static const char *const shadows[] = {"clear", "solid"};
    uint32_t depth = DEPTH_USUAL;
    plt_lighting *l = &j->lighting;
    if (read_light(all, "sun", PLT_LIGHT_DISTANT, l) < 0 ||
        read_light(all, "point", PLT_LIGHT_POINT, l) < 0 ||
        read_floats(all, "sky", l->sky, 3) < 0 || read_floats(all, "ground", l->ground, 3) < 0 ||
        job_u32(all, "depth", 0, PLT_BOUNCES_MOST, &depth) < 0 || read_wave(all, j) < 0) {
        return -1;
    }
    if (job_word(all, "shadows", shadows, 2, &l->solid_shadows) < 0) {
        return -1;
    }
    l->bounces = (uint8_t)depth;
    j->options.whitted = (uint8_t)(1 + depth);
    return 0;
}

#endif

/* Those that come after the first three are of engines that have them. */
static int read_shader(const char *all, job *j) {
    static const char *const shaders[] = {
        "eyelight",
        "normal",
        "triangle",
#if PLT_WITH_SURFACE
        "smooth",
#endif
#if PLT_WITH_DIAGRAMS
        "depth",
        "heat",
#endif
#if PLT_WITH_WHITTED
        "whitted",
#endif
    };
    static const uint8_t numbers[] = {
        PLT_SHADE_EYELIGHT,
        PLT_SHADE_NORMAL,
        PLT_SHADE_TRIANGLE,
#if PLT_WITH_SURFACE
        PLT_SHADE_SMOOTH,
#endif
#if PLT_WITH_DIAGRAMS
        PLT_SHADE_DEPTH,
        PLT_SHADE_HEAT,
#endif
#if PLT_WITH_WHITTED
        PLT_SHADE_WHITTED,
#endif
    };
    uint8_t named = 0;
    if (job_word(all, "shader", shaders, sizeof shaders / sizeof shaders[0], &named) < 0) {
        return -1;
    }
    j->frame.shader = numbers[named];
#if PLT_WITH_WHITTED
    if (j->frame.shader == PLT_SHADE_WHITTED && read_lights(all, j) < 0) {
        return -1;
    }
#endif
#if PLT_WITH_SURFACE
    j->options.surface =
        j->frame.shader == PLT_SHADE_SMOOTH || j->frame.shader == PLT_SHADE_WHITTED;
#endif
    return j->options.surface ? read_textures(all, j) : 0;
}

static int read_words(const char *all, job *j) {
    static const char *const walks[] = {"depth", "two"};
    static const char *const residencies[] = {"resident", "streamed"};
    static const char *const schedules[] = {"branch", "batch", "task"};
    if (job_word(all, "walk", walks, 2, &j->options.order) < 0 ||
        job_word(all, "residency", residencies, PLT_WITH_STREAMED ? 2 : 1, &j->options.residency) <
            0 ||
        job_word(all, "schedule", schedules, 1 + PLT_WITH_BATCH + PLT_WITH_TASK,
                 &j->options.schedule) < 0) {
        return -1;
    }
    return read_shader(all, j);
}

/* structure=, where there are grids. */
static int read_structure(const char *all, job *j) {
#if PLT_WITH_GRID
    static const char *const structures[] = {"tree", "grid"};
    return job_word(all, "structure", structures, 2, &j->options.structure);
#else
    (void)all;
    (void)j;
    return 0;
#endif
}

/* samples=, where there are several. */
static int read_samples(const char *all, job *j) {
#if PLT_WITH_SAMPLES
    static const char *const words[] = {"1", "4", "16", "adaptive"};
    static const uint8_t samples[] = {PLT_SAMPLES_ONE, PLT_SAMPLES_FOUR, PLT_SAMPLES_SIXTEEN,
                                      PLT_SAMPLES_ADAPTIVE};
    uint8_t choice = 0;
    const int status = job_word(all, "samples", words, 4, &choice);
    j->frame.samples = samples[choice];
    return status;
#else
    (void)all;
    (void)j;
    return 0;
#endif
}

int job_read(job *j, const char *parameters, const char *more_keys, size_t *arena_bytes) {
    uint32_t arena = (uint32_t)*arena_bytes;
    uint32_t packet = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8, batch = 0, prefetch = 0;
    parameter item;
    *j = (job){.visits = 20000};
    if (parameter_unknown(parameters, keys, more_keys, &item)) {
        return complain("unknown parameter", &item, "KEY=VALUE is wanted");
    }
    if (read_size(parameters, &j->frame) < 0 || read_camera(parameters, j) < 0 ||
        read_words(parameters, j) < 0 || read_structure(parameters, j) < 0 ||
        read_samples(parameters, j) < 0 ||
        job_u32(parameters, "packet", 2, PLT_PACKET_SIDE_MAX, &packet) < 0 ||
        job_u32(parameters, "store", PLT_STORE_LEAST, arena, &j->options.store_bytes) < 0 ||
        job_u32(parameters, "batch", 1, PLT_BATCH_MOST, &batch) < 0 ||
        job_u32(parameters, "prefetch", 0, PLT_WITH_PREFETCH ? PLT_PREFETCH_MOST : 0, &prefetch) <
            0 ||
        job_u32(parameters, "visits", 1, UINT32_MAX, &j->visits) < 0 ||
        job_u32(parameters, "arena", 0, arena, &arena) < 0) {
        return -1;
    }
    j->options.packet_side = (uint8_t)packet;
    j->options.batch = (uint16_t)batch;
    j->options.prefetch = (uint8_t)prefetch;
    *arena_bytes = arena;
    return 0;
}

void job_set_camera(job *j, const plt_info *info) {
    static const float from[3] = {0.9f, 0.7f, 1.9f}; /* from there the whole box is in view */
    plt_camera *c = &j->frame.camera;
    float square = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float side = info->hi[a] - info->lo[a];
        square += side * side;
    }
    const float radius = 0.5f * __builtin_sqrtf(square);
    for (int a = 0; a < 3; a++) {
        const float centre = 0.5f * info->lo[a] + 0.5f * info->hi[a];
        c->look[a] = j->given & GIVEN_LOOK ? c->look[a] : centre;
        c->eye[a] = j->given & GIVEN_EYE ? c->eye[a] : centre + from[a] * radius;
        c->up[a] = j->given & GIVEN_UP ? c->up[a] : (a == 1 ? 1.0f : 0.0f);
    }
    c->tan_half_fov = j->given & GIVEN_TAN ? c->tan_half_fov : 0.5f;
}
