/* pages - see pages.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/pages.h"

#include <stdio.h>
#include <string.h>

#include "host_tools/tables/page_kinds.h"

static void note_stand_in(sheet *s, const char *name, const gallery_about *about,
                          unsigned triangles) {
    if (about->stands_in) {
        char count[SHEET_TEXT];
        sheet_with_commas(count, sizeof count, triangles);
        sheet_note(s, "%s*: %s (%s triangles), for lack of the thesis's mesh.", name, about->note,
                   count);
    }
}

static void note_stand_ins(sheet *s, const book *b, unsigned table) {
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        const book_scene *scene = &b->scene[i];
        if (scene->is_there) {
            note_stand_in(s, printed_scenes[i].name, &scene->about, scene->triangles);
        }
    }
    for (unsigned i = 0; i < PRINTED_ANIMATIONS && table == 3; i++) {
        const book_animation *a = &b->animation[i];
        if (a->is_there) {
            note_stand_in(s, printed_animations[i].name, &a->about, a->triangles);
        }
    }
}

int pages_make(sheet *s, const book *b, unsigned table, fail *f) {
    static void (*const make[PRINTED_TABLES])(sheet *, const book *) = {
        page_sizes, page_intermediates, page_speed, page_packets, page_treelets, page_overhead};
    const printed_table *p = printed_of(table);
    snprintf(s->name, sizeof s->name, "Table %s", p->number);
    s->title = p->title;
    s->columns = p->columns;
    for (unsigned c = 0; c < p->columns; c++) {
        s->group[c] = p->group[c];
        s->column[c] = p->column[c];
    }
    make[table - 1](s, b);
    if (b->options.rows != (1u << PRINTED_SCENES) - 1 && (table == 2 || table > 4)) {
        sheet_note(s, "Printed means are of the thesis's eleven scenes, ours of the rows here.");
    }
    note_stand_ins(s, b, table);
    for (unsigned i = 0; p->remark[i] != NULL; i++) {
        sheet_note(s, "As printed: %s", p->remark[i]);
    }
    return s->wrong ? fail_set(f, s->name, "out of memory; close other programs") : 0;
}
