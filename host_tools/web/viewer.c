/* viewer - see viewer.h; here: a scene comes, and is opened
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/web/viewer.h"

#include "board/web/web.h"
#include "host_tools/app/daylight.h"
#include "host_tools/web/viewing.h"

enum { OPEN_SPLITS = 64, FIRST_LEVEL = COARSE_PLAIN + 2 };

viewing viewed;

const char *viewer_why(void) {
    return viewed.why.text;
}

void *viewer_begin(uint32_t bytes, int where, int is_same) {
    viewed.why.text[0] = '\0';
    viewed.engine = viewed.opening = NULL;
    viewed.is_rendering = viewed.is_new = 0;
    viewed.complete = (picture){NULL, 0, 0}; /* its memory is given to others */
    viewed.where = where;
    if (!is_same) {
        viewed.has_camera = viewed.has_lighting = 0;
        viewed.coarse = (coarse){.first = FIRST_LEVEL}; /* there is something to see at once */
    }
    web_room_begin();
    web_scene_of_page(&viewed.source, bytes);
    void *image = NULL;
    if (where == VIEW_MAPPED) {
        image = web_room_take(bytes);
        viewed.source = (plt_source){.mapped = image, .bytes = bytes};
        if (image == NULL) {
            fail_set(&viewed.why, "image", "its %u bytes are more than the browser has; stream it",
                     bytes);
        }
    }
    viewed.before_arena = web_room_mark();
    return image;
}

int viewing_fault(int status, const plt_fault *fault) {
    viewed.need_bytes = status == PLT_ERR_ARENA ? fault->need_bytes : 0;
    if (status == PLT_ERR_ARENA) {
        fail_set(&viewed.why, "arena",
                 "the scene needs %u bytes and there are %u; choose a larger one%s",
                 (unsigned)fault->need_bytes, viewed.arena_bytes,
                 viewed.where == VIEW_FETCHED    ? ", or leave the scene where it lies"
                 : viewed.where == VIEW_STREAMED ? ""
                                                 : ", or stream the scene");
    } else if (fault->rule > 0) {
        fail_set(&viewed.why, "image",
                 "%s (rule %c%u, byte %u); pack the mesh again, or copy the file "
                 "again",
                 fault->message, fault->kind, fault->rule, fault->offset);
    } else if (status == PLT_ERR_SOURCE) {
        fail_set(&viewed.why, "file", "byte %u cannot be read; copy the file again, it may be cut",
                 fault->offset);
    } else {
        fail_set(&viewed.why, "scene", "%s; choose another shader, or pack it otherwise",
                 fault->message);
    }
    return status;
}

/* What a scene is opened for depends on what its frames are to show. */
static void choose_options(const plt_info *info, unsigned shader) {
    const int has_surface = info->normal_bytes > 0 || info->colour_bytes > 0 ||
                            info->texcoord_bytes > 0 || info->page_bytes > 0;
    viewed.options = (plt_options){
        .residency = viewed.where == VIEW_STREAMED ? PLT_RESIDENCY_STREAMED : PLT_RESIDENCY_WHOLE};
    viewed.options.surface = shader == PLT_SHADE_SMOOTH;
    if (shader == PLT_SHADE_WHITTED) {
        viewed.options.whitted =
            1 + (viewed.has_lighting ? viewed.lighting.bounces : DAYLIGHT_BOUNCES);
        viewed.options.surface = has_surface;
        if (plt_arena_need(info, 0, &viewed.options) == 0) {
            viewed.options.surface = 0; /* not streamed, unless they are in pages */
        }
    }
    if (viewed.options.surface && info->texture_bytes > 0) {
        viewed.options.textures = PLT_TEXTURES_BILINEAR;
    }
}

static int opened(int status, const plt_fault *fault) {
    if (status < PLT_OK) {
        viewed.opening = NULL;
        return viewing_fault(status, fault);
    }
    if (status == PLT_OK) {
        viewed.engine = viewed.opening;
        viewed.opening = NULL;
        viewed.before_pixels = web_room_mark();
    }
    return status;
}

int viewer_open(uint32_t arena_bytes, unsigned shader, unsigned samples) {
    plt_info info;
    plt_fault fault = {.message = ""};
    viewed.why.text[0] = '\0';
    viewed.need_bytes = 0;
    viewed.engine = NULL;
    web_room_back(viewed.before_arena);
    viewed.arena = web_room_take(arena_bytes);
    viewed.arena_bytes = arena_bytes;
    if (viewed.arena == NULL) {
        return fail_set(&viewed.why, "arena",
                        "its %u bytes are more than the browser has; choose a "
                        "smaller one",
                        arena_bytes);
    }
    int status = plt_image_info(&viewed.source, &info, &fault);
    if (status != PLT_OK) {
        return viewing_fault(status, &fault);
    }
    choose_options(&info, shader);
    viewed.frame.shader = (uint8_t)shader;
    viewed.samples = (uint8_t)samples;
    web_stack_paint();
    status = plt_open_begin(&viewed.opening, viewed.arena, arena_bytes, &viewed.source,
                            &viewed.options, &fault);
    return opened(status, &fault);
}

int viewer_open_step(void) {
    plt_fault fault;
    const int status =
        viewed.opening != NULL ? plt_open_step(viewed.opening, OPEN_SPLITS, &fault) : PLT_OK;
    return viewed.opening != NULL ? opened(status, &fault) : status;
}
