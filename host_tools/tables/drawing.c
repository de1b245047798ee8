/* drawing - see drawing.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/drawing.h"

#include <stdio.h>
#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/tables/markup.h"

void drawing_free(drawing *d) {
    heap_drop(d->item);
    memset(d, 0, sizeof *d);
}

static void add(drawing *d, const drawing_item *item) {
    if (d->items == d->room && !d->wrong) {
        const unsigned room = 2 * d->room + 64;
        drawing_item *grown = heap_resize(d->item, (uint64_t)room * sizeof *grown);
        d->wrong = grown == NULL;
        d->item = d->wrong ? d->item : grown;
        d->room = d->wrong ? d->room : room;
    }
    if (!d->wrong) {
        d->item[d->items++] = *item;
    }
}

void drawing_rectangle(drawing *d, double x, double y, double x2, double y2, uint32_t colour) {
    const drawing_item item = {
        .shape = DRAWING_RECTANGLE, .x = x, .y = y, .x2 = x2, .y2 = y2, .colour = colour};
    add(d, &item);
}

void drawing_line(drawing *d, double x, double y, double x2, double y2, double width,
                  uint32_t colour) {
    const drawing_item item = {.shape = DRAWING_LINE,
                               .x = x,
                               .y = y,
                               .x2 = x2,
                               .y2 = y2,
                               .width = width,
                               .colour = colour};
    add(d, &item);
}

void drawing_letters(drawing *d, double x, double y, drawing_anchor anchor, unsigned scale,
                     uint32_t colour, const char *text) {
    drawing_item item = {.shape = DRAWING_LETTERS,
                         .anchor = anchor,
                         .x = x,
                         .y = y,
                         .width = scale,
                         .colour = colour};
    snprintf(item.text, sizeof item.text, "%s", text);
    add(d, &item);
}

static void svg_item(const drawing_item *i, output *o, fail *f) {
    static const char *const anchors[] = {"start", "middle", "end"};
    if (i->shape == DRAWING_RECTANGLE) {
        output_print(o, f,
                     "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" "
                     "fill=\"#%06x\"/>\n",
                     i->x, i->y, i->x2 - i->x, i->y2 - i->y, (unsigned)i->colour);
    } else if (i->shape == DRAWING_LINE) {
        output_print(o, f,
                     "<line x1=\"%.2f\" y1=\"%.2f\" x2=\"%.2f\" y2=\"%.2f\" stroke=\"#%06x\" "
                     "stroke-width=\"%.2f\"/>\n",
                     i->x, i->y, i->x2, i->y2, (unsigned)i->colour, i->width);
    } else {
        output_print(o, f,
                     "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"%s\" font-size=\"%.0f\" "
                     "fill=\"#%06x\">",
                     i->x, i->y, anchors[i->anchor], 10.0 * i->width, (unsigned)i->colour);
        markup_text(o, i->text, f);
        output_print(o, f, "</text>\n");
    }
}

int drawing_svg(const drawing *d, output *o, fail *f) {
    output_print(o, f,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%u\" height=\"%u\" "
                 "viewBox=\"0 0 %u %u\" font-family=\"monospace\">\n"
                 "<rect width=\"%u\" height=\"%u\" fill=\"#ffffff\"/>\n",
                 d->width, d->height, d->width, d->height, d->width, d->height);
    for (unsigned i = 0; i < d->items; i++) {
        svg_item(&d->item[i], o, f);
    }
    return output_print(o, f, "</svg>\n");
}
