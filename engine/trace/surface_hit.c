/* surface_hit - see surface_hit.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/surface_hit.h"

#if PLT_WITH_SURFACE

#include "engine/scene/surface_place.h"
#include "engine/trace/kept.h"

#if PLT_WITH_PAGES
static void set_resident(const plt_surface_data *d, const plt_record *record, uint32_t index,
                         plt_surface_corners *corners) {
    plt_surface_data page;
    const uint32_t number = index >> d->pages.shift;
    plt_surface_page_view(&page, d, plt_surface_page_bytes(&d->pages, number));
    plt_surface_corners_set(corners, &page, record);
}

/* The stream's fetcher; no block or treelet is the current one any more. */
static plt_fetcher *fetcher_of(plt_traversal *t) {
#if PLT_WITH_STREAMED_THESIS
    if (t->scene->format == PLT_FORMAT_STREAMED_THESIS) {
        plt_treelet_stream *s = t->state;
        s->first = PLT_MISS;
        return &s->fetcher;
    }
#endif
#if PLT_WITH_STREAMED_COMPACT
    plt_stream *s = t->state;
    s->current = NULL;
    return &s->fetcher;
#else
    return NULL; /* never */
#endif
}

static int set_streamed(plt_traversal *t, const plt_record *record, uint32_t index,
                        plt_surface_corners *corners) {
    const plt_surface_data *d = &t->scene->surface;
    plt_surface_data page;
    const uint32_t bit = 32 * plt_touched_words((enum plt_format)t->scene->format, &t->scene->info);
    const int status = plt_page_fetch(fetcher_of(t), d, bit, index >> d->pages.shift, &page);
    if (status == PLT_OK) {
        plt_surface_corners_set(corners, &page, record);
    }
    return status;
}
#endif

int plt_surface_of_record(plt_traversal *t, const plt_record *record, uint32_t index,
                          plt_surface_corners *corners) {
    const plt_surface_data *d = &t->scene->surface;
#if PLT_WITH_PAGES
    if (d->is_paged && d->pages.resident == NULL) {
        return set_streamed(t, record, index, corners);
    }
    if (d->is_paged) {
        set_resident(d, record, index, corners);
        return PLT_OK;
    }
#else
    (void)index;
#endif
    plt_surface_corners_set(corners, d, record);
    return PLT_OK;
}

#if PLT_WITH_GROUPS
void plt_surface_of_id(const plt_scene *scene, uint32_t id, plt_surface_corners *corners) {
    plt_record room;
    const plt_record *record = plt_surface_record(scene, id, &room);
#if PLT_WITH_PAGES
    if (scene->surface.is_paged) {
        set_resident(&scene->surface, record, plt_surface_index(scene, id), corners);
        return;
    }
#endif
    plt_surface_corners_set(corners, &scene->surface, record);
}

int plt_surface_of_ray(plt_traversal *t, const plt_packet *p, uint32_t ray,
                       plt_surface_corners *corners) {
#if PLT_WITH_PAGES
    if (plt_is_streamed(t->scene->format)) {
        const plt_kept *kept = &t->kept[ray];
        return plt_surface_of_record(t, &kept->record, kept->index, corners);
    }
#endif
    plt_surface_of_id(t->scene, p->rays[ray / 4].id[ray % 4], corners);
    return PLT_OK;
}
#endif

#endif
