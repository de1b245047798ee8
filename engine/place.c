/* place - the public calls by which instances are placed and told apart
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/engine.h"
#include "engine/instances_room.h"

static int has_instances(const plt_engine *e) {
    return e->scene.format == PLT_FORMAT_INSTANCES;
}

int plt_place(plt_engine *e, const float (*matrices)[12], plt_fault *fault) {
    plt_fault_set(fault, PLT_OK, 0, "no fault");
    if (!has_instances(e)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "the image has no instances");
    }
    if (matrices == NULL) { /* which would be those of a frame, come or not */
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "there are no matrices");
    }
    const uint32_t refused = plt_instances_place(e, matrices);
    return refused == e->scene.info.instances
               ? PLT_OK
               : plt_fault_set(fault, PLT_ERR_ARGUMENT, refused,
                               "a matrix cannot be inverted, or places a body beyond 2^40");
}

/* The last one whose first id is not above the id. */
int plt_instance_find(const plt_engine *e, uint32_t id, plt_instance *to) {
    if (!has_instances(e) || id >= e->scene.info.placed_triangles) {
        return PLT_ERR_ARGUMENT;
    }
    const plt_placed *placed = e->scene.instanced.placed;
    uint32_t least = 0, above = e->scene.info.instances;
    while (above - least > 1) {
        const uint32_t middle = least + (above - least) / 2;
        if (placed[middle].first_id <= id) {
            least = middle;
        } else {
            above = middle;
        }
    }
    to->instance = least;
    to->body = placed[least].body;
    to->triangle = id - placed[least].first_id;
    return PLT_OK;
}
