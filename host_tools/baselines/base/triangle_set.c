/* triangle_set - see triangle_set.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/base/triangle_set.h"

#include "host_tools/base/heap.h"
#include "host_tools/pack/pack.h"

int triangle_set_fill(triangle_set *t, const mesh *m) {
    if (t->record == NULL) {
        t->record = heap_get((uint64_t)m->triangles * sizeof *t->record + 1);
        t->count = (uint32_t)m->triangles;
    }
    if (t->record == NULL) {
        return -1;
    }
    for (uint32_t i = 0; i < t->count; i++) {
        pack_record(&t->record[i], m, i);
    }
    t->box = plt_records_box(t->record, 0, t->count);
    return 0;
}

void triangle_set_free(triangle_set *t) {
    heap_drop(t->record);
    *t = (triangle_set){.record = NULL};
}

void triangle_set_move(plt_record *records, uint32_t count, const mesh *m) {
    for (uint32_t i = 0; i < count; i++) {
        plt_record *r = &records[i];
        const int is_last = plt_record_is_last(r);
        pack_record(r, m, plt_primitive_id(plt_get_u32(&r->word[9])));
        plt_record_set_last(r, is_last);
    }
}
