/* room - a closed room with furniture, of about as many triangles as asked for
 *
 * All curved surfaces get as fine as the number of triangles allows: the room is counted at a
 * detail before it is made, and the greatest that is not too large is found by halving.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/room.h"

#include "host_tools/scenes/counts.h"

#define DETAIL_MOST 4096u

static void furnish(room *r) {
    room_walls(r);
    room_openings(r);
    room_pictures(r);
    room_dining(r);
    room_tableware(r);
    room_shelf(r);
    room_sofa(r);
    room_lamps(r);
    room_plant(r);
    room_toys(r);
}

static uint64_t count_at(unsigned detail, uint32_t seed) {
    room r = {.s = {.detail = detail}, .seed = seed};
    furnish(&r);
    return r.s.triangles;
}

static unsigned detail_for(uint64_t triangles, uint32_t seed) {
    unsigned detail = 0;
    for (unsigned bit = DETAIL_MOST / 2; bit > 0; bit /= 2) {
        detail += count_at(detail + bit, seed) <= triangles ? bit : 0;
    }
    return detail;
}

int scene_room(mesh *m, uint64_t triangles, uint32_t seed, fail *f) {
    const size_t vertices = m->vertices, before = m->triangles;
    if (count_check(m, "room", triangles, SCENE_ROOM_LEAST, SCENE_TRIANGLES_MAX, f)) {
        return -1;
    }
    room r = {.s = {.m = m, .detail = detail_for(triangles, seed), .f = f}, .seed = seed};
    furnish(&r);
    if (!r.s.wrong) {
        return 0;
    }
    m->vertices = vertices;
    m->triangles = before;
    return -1;
}
