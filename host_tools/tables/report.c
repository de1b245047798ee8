/* report - see report.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/report.h"

#include <string.h>

#include "host_tools/picture/formats.h"
#include "host_tools/tables/markup.h"

static const char head[] =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width\">\n"
    "<title>Planelet: the thesis's tables beside ours</title>\n<style>\n"
    "body { font-family: sans-serif;color: #202020;margin: 2em auto;max-width: 68em;"
    "padding: 0 1em;line-height: 1.4;}\n"
    "h1 { font-size: 1.5em;} h2 { font-size: 1.15em;margin-top: 2.4em;}\n"
    ".wide { overflow-x: auto;}\n"
    "table { border-collapse: collapse;font-size: 0.85em;font-variant-numeric: tabular-nums;}\n"
    "th, td { padding: 0.1em 0.55em;text-align: right;white-space: nowrap;}\n"
    "th { border-bottom: 1px solid #808080;vertical-align: bottom;}\n"
    "td.row, td.what, th.row { text-align: left;} td.what { color: #606060;}\n"
    "tr.first td { border-top: 1px solid #c0c0c0;} td.row { font-weight: bold;}\n"
    "tr.printed td { color: #606060;} tr.ratio td { font-style: italic;}\n"
    "td.group, th.group { border-left: 1px solid #c0c0c0;}\n"
    "ul.notes { font-size: 0.85em;color: #404040;}\n"
    ".scenes { display: flex;flex-wrap: wrap;gap: 0.8em;}\n"
    ".scenes figure { margin: 0;width: 10.5em;font-size: 0.8em;}\n"
    ".scenes img { width: 100%;height: auto;display: block;}\n"
    "svg { max-width: 100%;height: auto;}\n"
    "</style>\n</head>\n<body>\n";

/* RFC 4648, section 4. */
static void put_base64(const uint8_t *bytes, size_t count, output *o, fail *f) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < count; i += 3) {
        const size_t left = count - i;
        const uint32_t three = (uint32_t)bytes[i] << 16 |
                               (left > 1 ? (uint32_t)bytes[i + 1] << 8 : 0u) |
                               (left > 2 ? (uint32_t)bytes[i + 2] : 0u);
        const char four[4] = {digits[three >> 18], digits[three >> 12 & 63u],
                              left > 1 ? digits[three >> 6 & 63u] : '=',
                              left > 2 ? digits[three & 63u] : '='};
        output_write(o, four, sizeof four, f);
    }
}

static int put_picture(const book_scene *s, unsigned number, output *o, fail *f) {
    bits png = {0};
    const int status = png_pack(&png, &s->picture, f);
    if (status == 0) {
        output_print(o, f, "<figure><img alt=\"%s\" src=\"data:image/png;base64,",
                     printed_scenes[number].name);
        put_base64(png.bytes, png.size, o, f);
        output_print(o, f, "\"><figcaption><b>%s%s</b>, %u triangles", printed_scenes[number].name,
                     s->about.stands_in ? "*" : "", s->triangles);
        output_print(o, f, "%s", s->about.stands_in ? "; " : "");
        markup_text(o, s->about.note, f);
        output_print(o, f, "</figcaption></figure>\n");
    }
    bits_free(&png);
    return status;
}

static int put_pictures(const report *r, output *o, fail *f) {
    int status = 0;
    output_print(o, f, "<h2>The scenes</h2>\n<div class=\"scenes\">\n");
    for (unsigned i = 0; i < PRINTED_SCENES && status == 0; i++) {
        const book_scene *s = &r->book->scene[i];
        if (s->is_there && s->picture.rgb != NULL) {
            status = put_picture(s, i, o, f);
        }
    }
    output_print(o, f, "</div>\n");
    return status;
}

static int starts_group(const sheet *s, unsigned c) {
    return c > 0 && strcmp(s->group[c], s->group[c - 1]) != 0;
}

static void put_heads(const sheet *s, output *o, fail *f) {
    if (s->group[0][0] != '\0') {
        output_print(o, f, "<tr><th class=\"row\"></th><th></th>");
        for (unsigned c = 0, end; c < s->columns; c = end) {
            for (end = c + 1; end < s->columns && !starts_group(s, end); end++) {
            }
            output_print(o, f, "<th class=\"group\" colspan=\"%u\">", end - c);
            markup_text(o, s->group[c], f);
            output_print(o, f, "</th>");
        }
        output_print(o, f, "</tr>\n");
    }
    output_print(o, f, "<tr><th class=\"row\">Scene</th><th></th>");
    for (unsigned c = 0; c < s->columns; c++) {
        output_print(o, f, "<th%s>", starts_group(s, c) ? " class=\"group\"" : "");
        markup_text(o, s->column[c], f);
        output_print(o, f, "</th>");
    }
    output_print(o, f, "</tr>\n");
}

static void put_line(const sheet *s, const sheet_line *line, output *o, fail *f) {
    const char *kind = strncmp(line->what, "printed", 7) == 0 ? " printed"
                       : strncmp(line->what, "ratio", 5) == 0 ? " ratio"
                                                              : "";
    output_print(o, f, "<tr class=\"%s%s\"><td class=\"row\">",
                 line->row[0] != '\0' ? "first" : "next", kind);
    markup_text(o, line->row, f);
    output_print(o, f, "</td><td class=\"what\">");
    markup_text(o, line->what, f);
    output_print(o, f, "</td>");
    for (unsigned c = 0; c < s->columns; c++) {
        output_print(o, f, "<td%s>", starts_group(s, c) ? " class=\"group\"" : "");
        markup_text(o, line->cell[c].text, f);
        output_print(o, f, "</td>");
    }
    output_print(o, f, "</tr>\n");
}

static void put_sheet(const sheet *s, output *o, fail *f) {
    output_print(o, f, "<h2>%s: ", s->name);
    markup_text(o, s->title, f);
    output_print(o, f, "</h2>\n<div class=\"wide\"><table>\n");
    put_heads(s, o, f);
    for (unsigned i = 0; i < s->lines; i++) {
        put_line(s, &s->line[i], o, f);
    }
    output_print(o, f, "</table></div>\n<ul class=\"notes\">\n");
    for (unsigned i = 0; i < s->notes; i++) {
        output_print(o, f, "<li>");
        markup_text(o, s->note[i], f);
        output_print(o, f, "</li>\n");
    }
    output_print(o, f, "</ul>\n");
}

static void put_about(const report *r, output *o, fail *f) {
    output_print(o, f,
                 "<h1>Planelet: the thesis's tables beside ours</h1>\n<p>R. Karrenberg, "
                 "&#8220;Memory Aware Realtime Ray Tracing: The Bounding Plane "
                 "Hierarchy&#8221;, Saarland University, 2007: Tables 5.1 to 5.6 and Figures "
                 "5.3 to 5.5. Rows with a star are of meshes that stand in for the "
                 "thesis&#8217;s. ");
    if (r->where != NULL) {
        output_print(o, f, "Meshes are from ");
        markup_text(o, r->where, f);
        output_print(o, f, ". ");
    } else {
        output_print(o, f, "All meshes are made by planelet. ");
    }
    output_print(o, f, "Rays are those of pictures of %ux%u, from %u side%s.</p>\n",
                 r->book->meter.look.side, r->book->meter.look.side, r->book->meter.look.views,
                 r->book->meter.look.views == 1 ? "" : "s");
}

int report_write(const report *r, output *o, fail *f) {
    output_print(o, f, "%s", head);
    put_about(r, o, f);
    if (put_pictures(r, o, f) != 0) {
        return -1;
    }
    for (unsigned i = 0; i < r->sheets; i++) {
        put_sheet(&r->sheet[i], o, f);
    }
    for (unsigned i = 0; i < r->charts; i++) {
        output_print(o, f, "<h2>%s</h2>\n<div class=\"wide\">\n", r->chart[i].title);
        drawing_svg(r->chart[i].drawing, o, f);
        output_print(o, f, "</div>\n");
    }
    return output_print(o, f, "</body>\n</html>\n");
}
