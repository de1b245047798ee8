/* open - see open.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/open.h"

#include "engine/base/fault.h"
#include "engine/scene/open_formats.h"

void plt_scene_describe(plt_scene *scene, const plt_header *header) {
    scene->info = header->info;
    scene->format = (uint8_t)plt_format_of(&header->info);
    scene->box = plt_box_empty();
    for (int a = 0; a < 3 && header->info.triangles > 0; a++) {
        scene->box.lo[a] = header->info.lo[a];
        scene->box.hi[a] = header->info.hi[a];
    }
}

static int left_out(const plt_opening *o, const char *message) {
    return plt_limit(o->fault, message);
}

/* The one place that chooses how a format is opened. */
int plt_scene_open(const plt_opening *o, const plt_header *header, plt_compact_build **build) {
    *build = NULL;
    if (!PLT_WITH_BUILDER && header->info.build == PLT_BUILD_DEVICE) {
        return left_out(o, "this build of the engine has no builder (PLT_WITH_BUILDER)");
    }
    switch (o->scene->format) {
#if PLT_WITH_COMPACT
    case PLT_FORMAT_COMPACT:
        return plt_open_compact(o, header, build);
#else
    case PLT_FORMAT_COMPACT:
        return left_out(o, "this build of the engine has no compact blocks (PLT_WITH_COMPACT)");
#endif
#if PLT_WITH_THESIS
    case PLT_FORMAT_LIST:
        return plt_open_list(o, header);
    default:
        return plt_open_thesis(o, header);
#else
    default:
        return left_out(o, "this build of the engine has no thesis nodes (PLT_WITH_THESIS)");
#endif
    }
}

int plt_scene_build_step(const plt_opening *o, plt_compact_build *build, uint32_t steps) {
#if PLT_WITH_COMPACT && PLT_WITH_BUILDER
    return plt_build_compact_step(o, build, steps);
#else
    (void)build;
    (void)steps;
    return left_out(o, "this build of the engine has no builder (PLT_WITH_BUILDER)");
#endif
}
