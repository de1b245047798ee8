/* surface_place - see surface_place.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/scene/surface_place.h"

#if PLT_WITH_SURFACE && PLT_WITH_GROUPS

#include "engine/tree/compact/block_record.h"

static void set_records(const plt_record *records, uint32_t count, uint32_t *place) {
    for (uint32_t i = 0; i < count; i++) {
        place[plt_primitive_id(plt_get_u32(&records[i].word[9]))] = i;
    }
}

#if PLT_WITH_COMPACT
static uint32_t word_of(const plt_block_tree *tree, uint32_t index) {
    return tree->leaf_kind == PLT_LEAF_RECORDS
               ? plt_get_u32(&tree->records[index].word[9])
               : plt_primitive_word_find(tree->ids.bytes != NULL ? &tree->ids : NULL, index);
}

static void set_blocks(const plt_block_tree *tree, uint32_t *place, uint16_t *within) {
    for (uint32_t at = 0, next; at < tree->used; at = next) {
        uint32_t first, count;
        next = plt_block_triangles(tree, at, &first, &count);
        for (uint32_t i = 0; i < count; i++) {
            const uint32_t id = plt_primitive_id(word_of(tree, first + i));
            place[id] = at / 8;
            within[id] = (uint16_t)i;
        }
    }
}
#endif

/* A scene without nodes has no block at all. */
void plt_surface_places_set(plt_scene *s, void *room) {
    plt_surface_data *d = &s->surface;
    uint32_t *place = room;
    d->triangles = plt_surface_ids(&s->info);
    d->place = place;
    d->within = NULL;
    for (uint32_t i = 0; i < d->triangles; i++) {
        place[i] = 0;
    }
#if PLT_WITH_COMPACT
    if (s->format == PLT_FORMAT_COMPACT) {
        uint16_t *within = (uint16_t *)(void *)(place + d->triangles);
        for (uint32_t i = 0; i < d->triangles; i++) {
            within[i] = 0;
        }
        d->within = within;
        set_blocks(&s->compact, place, within);
        d->triangles = s->compact.used > 0 ? d->triangles : 0;
        return;
    }
#endif
    set_records(plt_scene_records(s), s->info.triangles, place);
}

const plt_record *plt_surface_record(const plt_scene *s, uint32_t id, plt_record *room) {
    const plt_surface_data *d = &s->surface;
#if PLT_WITH_COMPACT
    if (d->within != NULL) {
        plt_block_record(&s->compact, 8 * d->place[id], d->within[id], room);
        return room;
    }
#else
    (void)room;
#endif
    return &plt_scene_records(s)[d->place[id]];
}

#if PLT_WITH_PAGES
uint32_t plt_surface_index(const plt_scene *s, uint32_t id) {
    const plt_surface_data *d = &s->surface;
#if PLT_WITH_COMPACT
    if (d->within != NULL) {
        uint32_t first, count;
        plt_block_triangles(&s->compact, 8 * d->place[id], &first, &count);
        return first + d->within[id];
    }
#endif
    return d->place[id];
}
#endif

#endif
