/* cmd_tables - planelet tables: the thesis's Tables 5.1 to 5.6 and Figures 5.3 to 5.5, beside ours
 *
 * SPDX-License-Identifier: MIT */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "host_tools/app/note.h"
#include "host_tools/base/clock.h"
#include "host_tools/base/heap.h"
#include "host_tools/cli/commands.h"
#include "host_tools/picture/picture_file.h"
#include "host_tools/tables/charts.h"
#include "host_tools/tables/pages.h"
#include "host_tools/tables/report.h"

enum { SIDE_MOST = 2048, VIEWS_MOST = 16, STEPS_MOST = 500, ROUNDS_MOST = 100, PATH = 4096 };

static const arg_flag flags[] = {
    {"--scenes", "DIR",
     "a folder with the thesis's meshes, or some of them (host_tools/MEASURING.md has their "
     "names); those that are not there are made (default: all are made)"},
    {"-o", "DIR",
     "write tables.html, which has all of it, and the figures as SVG and PNG to this folder, and "
     "keep what was measured in it, in tables.cache, for the next run"},
    {"--rows", "LIST",
     "these scenes alone, with commas between: ground, shuttle, wooddoll, marbles, toasters, hand, "
     "bunny, ben, fairy, dragon, buddha (default all)"},
    {"--size", "N", "rays of pictures N x N; a multiple of 16, to 2048 (default 512)"},
    {"--views", "N", "pictures from so many sides; 1 to 16 (default 3)"},
    {"--frames", "N", "so many frames of each animation, evenly spread; 2 to 500 (default 8)"},
    {"--rounds", "N", "Table 5.3: the best of so many turns; 1 to 100 (default 3)"},
    {"--json", "FILE", "write all tables to this file; - is standard output, without the tables"},
    {NULL, NULL, NULL}};

const arg_command command_tables = {
    .name = "tables",
    .synopsis = "[1 2 3 4 5 6 | figures] [--scenes DIR] [-o DIR]",
    .about =
        "Measures what the thesis measured, and prints its tables 5.1 to 5.6 with ours beside "
        "the printed figures; of those that are named, or all. figures are 5.3 to 5.5, for "
        "-o.",
    .flags = flags,
    .files_least = 0,
    .files_most = PRINTED_TABLES + 1,
    .notes =
        "Rows with a star are of meshes that stand in for the thesis's. Frames per\n"
        "second are given as how many times as fast a structure is as our wBVH in the\n"
        "same run, and as cycles per ray, or nanoseconds where the system does not let\n"
        "cycles be counted.\n"};

typedef struct tables {
    book book;
    cache cache;
    const char *scenes, *folder, *json; /* NULL: not given */
    unsigned shown;                     /* tables, a bit each */
    int has_figures;
    sheet sheet[PRINTED_TABLES];
    unsigned sheets;
    drawing drawing[CHARTS];
    report_chart chart[CHARTS];
    output *text, *out_json;
} tables;

static void read_words(tables *t, args *a) {
    for (int i = 0; i < a->files; i++) {
        const char *word = a->file[i];
        if (strcmp(word, "figures") == 0) {
            t->has_figures = 1;
        } else if (word[0] >= '1' && word[0] <= '6' && word[1] == '\0') {
            t->shown |= 1u << (word[0] - '1');
        } else {
            args_complain(a, "there is no table '%s': 1 to 6, or figures", word);
            return;
        }
    }
    if (a->files == 0) {
        t->shown = (1u << PRINTED_TABLES) - 1;
        t->has_figures = 1;
    }
}

static void read_flags(tables *t, args *a) {
    static const char *names[PRINTED_SCENES + 1];
    for (unsigned i = 0; i < PRINTED_SCENES; i++) {
        names[i] = printed_scenes[i].name;
    }
    read_words(t, a);
    t->scenes = args_text(a, "--scenes", NULL);
    t->folder = args_text(a, "-o", NULL);
    t->json = args_text(a, "--json", NULL);
    book *b = &t->book;
    b->options.rows = args_set(a, "--rows", names, ~0u) & ((1u << PRINTED_SCENES) - 1);
    b->meter.look.side = (unsigned)args_number(a, "--size", 512, 16, SIDE_MOST);
    b->meter.look.views = (unsigned)args_number(a, "--views", 3, 1, VIEWS_MOST);
    b->options.steps = (unsigned)args_number(a, "--frames", 8, 2, STEPS_MOST);
    b->meter.rounds = (unsigned)args_number(a, "--rounds", 3, 1, ROUNDS_MOST);
    if (b->meter.look.side % 16 != 0) {
        args_complain(a, "--size takes multiples of 16, not '%s'", args_text(a, "--size", ""));
    }
    if (t->shown == 0 && t->folder == NULL) {
        args_complain(a, "figures need -o DIR, the folder they go to");
    }
    b->options.tables = t->shown;
    for (unsigned i = CHARTS_FIRST; i <= CHARTS_LAST && t->has_figures && t->folder != NULL; i++) {
        b->options.tables |= charts_need(i);
    }
    b->options.pictures = t->folder != NULL;
}

/* ---- what is written ------------------------------------------------------ */

static int path_in(char to[PATH], const tables *t, const char *name, fail *f) {
    const int n = snprintf(to, PATH, "%s/%s", t->folder, name);
    return n > 0 && n < PATH ? 0
                             : fail_set(f, t->folder, "the name is too long; choose a shorter one");
}

/* A folder that is not there is made, in one that is. */
static int make_folder(const char *folder, fail *f) {
    struct stat about;
    if (mkdir(folder, 0777) == 0 || (stat(folder, &about) == 0 && S_ISDIR(about.st_mode))) {
        return 0;
    }
    return fail_set(f, folder, "cannot make this folder: %s; choose another one for -o",
                    errno == EEXIST ? "it is a file" : strerror(errno));
}

static int finish(output *o, int status, fail *f) {
    if (status != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

static int write_svg(const tables *t, const drawing *d, const char *name, fail *f) {
    char path[PATH];
    output *o = path_in(path, t, name, f) == 0 ? output_open_text(path, f) : NULL;
    return o != NULL ? finish(o, drawing_svg(d, o, f), f) : -1;
}

static int write_png(const tables *t, const drawing *d, const char *name, fail *f) {
    char path[PATH];
    picture p = {0};
    int status = drawing_paint(d, &p, f);
    output *o = status == 0 && path_in(path, t, name, f) == 0 ? output_open(path, f) : NULL;
    if (o != NULL) {
        status = picture_begin(o, PICTURE_PNG, p.width, p.height, 1, f);
        status = finish(o, status == 0 ? picture_frame(o, PICTURE_PNG, &p, f) : -1, f);
    } else {
        status = -1;
    }
    picture_free(&p);
    return status;
}

static int write_charts(tables *t, fail *f) {
    int status = 0;
    for (unsigned i = 0; i < CHARTS && status == 0; i++) {
        char name[32];
        status = charts_make(&t->drawing[i], &t->book, CHARTS_FIRST + i, f);
        t->chart[i] = (report_chart){charts_titles[i], &t->drawing[i]};
        snprintf(name, sizeof name, "figure_5_%u.svg", CHARTS_FIRST + i);
        status = status == 0 ? write_svg(t, &t->drawing[i], name, f) : status;
        snprintf(name, sizeof name, "figure_5_%u.png", CHARTS_FIRST + i);
        status = status == 0 ? write_png(t, &t->drawing[i], name, f) : status;
    }
    return status;
}

static int write_report(tables *t, fail *f) {
    char path[PATH];
    const report r = {.book = &t->book,
                      .where = t->scenes,
                      .sheet = t->sheet,
                      .sheets = t->sheets,
                      .chart = t->chart,
                      .charts = t->has_figures ? CHARTS : 0};
    output *o = path_in(path, t, "tables.html", f) == 0 ? output_open_text(path, f) : NULL;
    return o != NULL ? finish(o, report_write(&r, o, f), f) : -1;
}

static int write_sheets(tables *t, fail *f) {
    int status = 0;
    for (unsigned i = 1; i <= PRINTED_TABLES && status == 0; i++) {
        if (t->shown >> (i - 1) & 1u) {
            sheet *s = &t->sheet[t->sheets++];
            status = pages_make(s, &t->book, i, f);
            if (status == 0 && t->text != NULL) {
                status = sheet_print(s, t->text, f);
            }
        }
    }
    return status;
}

static int write_json(tables *t, fail *f) {
    output *o = t->out_json;
    output_print(o, f, "{\n  \"size\": %u,\n  \"views\": %u,\n  \"tables\": [\n",
                 t->book.meter.look.side, t->book.meter.look.views);
    for (unsigned i = 0; i < t->sheets; i++) {
        output_print(o, f, "  ");
        sheet_print_json(&t->sheet[i], o, f);
        output_print(o, f, "%s\n", i + 1 < t->sheets ? "," : "");
    }
    t->out_json = NULL;
    return finish(o, output_print(o, f, "  ]\n}\n"), f);
}

/* Outputs of one name are opened before the long run, so that it is not for nothing; behind the
 * folder, which the JSON may go to. */
static int open_outputs(tables *t, fail *f) {
    if (t->folder != NULL) {
        if (make_folder(t->folder, f) != 0 || cache_open(&t->cache, t->folder, f) != 0) {
            return -1;
        }
        t->book.cache = &t->cache;
    }
    if (t->json == NULL || strcmp(t->json, "-") != 0) {
        t->text = output_open_text("-", f);
        if (t->text == NULL) {
            return -1;
        }
    }
    if (t->json != NULL && (t->out_json = output_open_text(t->json, f)) == NULL) {
        return -1;
    }
    return 0;
}

/* Before the run. */
static void say_size(const tables *t) {
    const stage_options *o = &t->book.meter.look;
    note("%u pictures of %u x %u: %llu rays for each structure, %d of them at a time", o->views,
         o->side, o->side, (unsigned long long)o->views * o->side * o->side, TURNS_BATCH);
    note("%.0f MB of memory at most, with meshes as large as those of the thesis",
         1e-6 * (double)book_bytes(&t->book));
}

static void say_time(const tables *t, double seconds) {
    note("%u figures measured in %.0f s, %u from %s", t->book.measured, seconds, t->book.from_cache,
         t->book.cache != NULL ? t->cache.path : "no cache");
    note("%.0f MB of memory were in use at most", 1e-6 * (double)heap_peak());
    if (t->cache.refused > 0) {
        note("%s: %u lines are damaged and were not used", t->cache.path, t->cache.refused);
    }
}

static int run_all(tables *t, fail *f) {
    const double began = clock_seconds();
    if (gallery_open(&t->book.gallery, t->scenes, f) != 0 || open_outputs(t, f) != 0) {
        return -1;
    }
    say_size(t);
    if (book_write(&t->book, f) != 0 || write_sheets(t, f) != 0) {
        return -1;
    }
    if (t->folder != NULL &&
        ((t->has_figures && write_charts(t, f) != 0) || write_report(t, f) != 0)) {
        return -1;
    }
    if (t->out_json != NULL && write_json(t, f) != 0) {
        return -1;
    }
    output *o = t->text;
    t->text = NULL;
    say_time(t, clock_seconds() - began);
    return o != NULL ? output_commit(o, f) : 0;
}

static void close_all(tables *t) {
    output_abandon(t->text);
    output_abandon(t->out_json);
    book_free(&t->book);
    cache_close(&t->cache);
    for (unsigned i = 0; i < PRINTED_TABLES; i++) {
        sheet_free(&t->sheet[i]);
    }
    for (unsigned i = 0; i < CHARTS; i++) {
        drawing_free(&t->drawing[i]);
    }
}

int run_tables(args *a) {
    tables t = {.cache = {.file = -1}};
    fail f = {""};
    read_flags(&t, a);
    const int status = a->wrong ? -1 : run_all(&t, &f);
    close_all(&t);
    if (a->wrong) {
        return 2;
    }
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
        return 1;
    }
    return 0;
}
