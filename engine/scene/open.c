/* open - see open.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/open.h"

#include "engine/base/fault.h"
#include "engine/scene/build_compact.h"
#include "engine/scene/open_formats.h"

#define NEEDS "this build of the engine does not have what the image needs: "

const char *plt_scene_left_out(const plt_info *info, unsigned residency, unsigned structure) {
    const int wants_tree = !PLT_WITH_GRID || structure == PLT_STRUCTURE_TREE;
    if (!PLT_WITH_BUILDER && info->build == PLT_BUILD_DEVICE && wants_tree) {
        return NEEDS "the builder (PLT_WITH_BUILDER)";
    }
    switch (plt_format_of(info, residency, structure)) {
#define LEFT_OUT(NAME, name, with, text)                                                           \
    case PLT_FORMAT_##NAME:                                                                        \
        return with ? NULL : NEEDS text;
        PLT_FORMATS(LEFT_OUT)
#undef LEFT_OUT
    default:
        return NULL;
    }
}

static void describe(plt_scene *scene, const plt_header *header, const plt_opening *o) {
    scene->info = header->info;
    scene->format = (uint8_t)plt_format_of(&header->info, o->residency, o->structure);
    if (PLT_WITH_VERTICES && o->over_vertices) {
        scene->format = PLT_FORMAT_VERTICES;
    }
    scene->box = plt_box_empty();
    for (int a = 0; a < 3 && header->info.triangles > 0; a++) {
        scene->box.lo[a] = header->info.lo[a];
        scene->box.hi[a] = header->info.hi[a];
    }
}

int plt_scene_open(const plt_opening *o, const plt_header *header,
                   struct plt_compact_build **build) {
    *build = NULL;
    describe(o->scene, header, o);
    switch (o->scene->format) {
#define OPEN(NAME, name, with, text)                                                               \
    PLT_IF(with, case PLT_FORMAT_##NAME : return plt_open_##name(o, header, build);)
        PLT_FORMATS(OPEN)
#undef OPEN
    default: /* plt_scene_left_out has said no */
        return PLT_ERR_LIMIT;
    }
}

int plt_scene_build_step(const plt_opening *o, struct plt_compact_build *build, uint32_t steps) {
#if PLT_WITH_COMPACT && PLT_WITH_BUILDER
    return plt_build_compact_step(o, build, steps);
#else
    (void)o;
    (void)build;
    (void)steps;
    return PLT_OK; /* never: nothing returned PLT_MORE */
#endif
}
