/* counts - the arithmetic of scenes that come in any size
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/counts.h"

#include <inttypes.h>

int count_check(const mesh *m, const char *scene, uint64_t triangles, unsigned least, unsigned most,
                fail *f) {
    if (triangles < least || triangles > most) {
        return fail_set(f, scene, "%" PRIu64 " triangles: a %s has %u to %u; ask for such a number",
                        triangles, scene, least, most);
    }
    if (m->vertices > UINT32_MAX - 2 * (size_t)SCENE_TRIANGLES_MAX) {
        return fail_set(f, scene, "the mesh has %zu vertices already; start with an empty one",
                        m->vertices);
    }
    return 0;
}

uint32_t count_root(uint64_t square) {
    uint64_t root = 0;
    for (uint64_t bit = (uint64_t)1 << 31; bit; bit >>= 1) {
        const uint64_t with = root | bit;
        root = with * with <= square ? with : root;
    }
    return (uint32_t)root;
}
