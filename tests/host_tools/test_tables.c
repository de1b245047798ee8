/* test_tables - sheets, plots, caches and twisted meshes of planelet tables
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "board/hash.h"
#include "host_tools/base/output.h"
#include "host_tools/scenes/scenes.h"
#include "host_tools/tables/cache.h"
#include "host_tools/tables/letters.h"
#include "host_tools/tables/plot.h"
#include "host_tools/tables/sheet.h"
#include "host_tools/tables/twist.h"
#include "tests/test.h"

#define FOLDER TEST_FOLDER "tables"

static char text[1 << 16];

static const char *read_back(const char *path) {
    FILE *file = fopen(path, "rb");
    const size_t got = file != NULL ? fread(text, 1, sizeof text - 1, file) : 0;
    text[got] = '\0';
    if (file != NULL) {
        fclose(file);
    }
    return text;
}

static void write_text(const char *path, const char *what) {
    FILE *file = fopen(path, "wb");
    if (file != NULL) {
        fputs(what, file);
        fclose(file);
    }
}

/* ---- sheets ---------------------------------------------------------------- */

static void fill_sheet(sheet *s) {
    static const char *const group[] = {"few", "a group of two", "a group of two"};
    static const char *const column[] = {"one", "two", "three"};
    snprintf(s->name, sizeof s->name, "Table 0");
    s->title = "a \"test\"";
    s->columns = 3;
    for (unsigned i = 0; i < 3; i++) {
        s->group[i] = group[i];
        s->column[i] = column[i];
    }
    sheet_line *line = sheet_add(s, "bunny", "printed");
    sheet_put_bytes(line, 0, 1284800.0);
    sheet_put(line, 1, 2.345, 1);
    sheet_put_text(line, 2, (double)NAN, "0.8K");
    line = sheet_add(s, "", "ours");
    sheet_put_bytes(line, 0, 192.0);
    sheet_put(line, 1, (double)NAN, 1);
    sheet_note(s,
               "%d words that go on and on, so that this note is longer than one line of ninety "
               "and eight columns holds",
               7);
}

static void check_sheet(void) {
    static const char due[] =
        "Table 0: a \"test\"\n\n"
        "                  few | a group of two\n"
        "Scene             one | two      three\n"
        "bunny  printed 1,285K | 2.3       0.8K\n"
        "       ours      0.2K |   -           \n\n"
        "* 7 words that go on and on, so that this note is longer than one line of ninety and "
        "eight columns\n"
        "  holds\n\n";
    sheet s = {.lines = 0};
    fail f = {""};
    fill_sheet(&s);
    output *o = output_open_text(FOLDER "/sheet.txt", &f);
    sheet_print(&s, o, &f);
    output_commit(o, &f);
    test("a sheet is printed in columns, its notes in lines of at most 100");
    CHECK(strcmp(read_back(FOLDER "/sheet.txt"), due) == 0, "%s\n%s", f.text, text);
    o = output_open_text(FOLDER "/sheet.json", &f);
    sheet_print_json(&s, o, &f);
    output_commit(o, &f);
    test("as JSON rows have their names again, and what is no number is null");
    read_back(FOLDER "/sheet.json");
    CHECK(strstr(text, "\"title\": \"a \\\"test\\\"\"") != NULL, "%s", text);
    CHECK(
        strstr(text, "{\"scene\": \"bunny\", \"line\": \"ours\", \"values\": [192, null, null]") !=
            NULL,
        "%s", text);
    CHECK(strstr(text, "\"columns\": [\"few one\", \"a group of two two\"") != NULL, "%s", text);
    sheet_free(&s);
}

static void check_many_lines(void) {
    sheet s = {.columns = 1, .title = "", .group = {""}, .column = {""}};
    test("a sheet keeps its lines as it grows");
    for (unsigned i = 0; i < 1000; i++) {
        sheet_put(sheet_add(&s, "row", "ours"), 0, i, 0);
    }
    CHECK(s.lines == 1000 && !s.wrong, "%u lines", s.lines);
    for (unsigned i = 0; i < s.lines; i++) {
        CHECK(s.line[i].cell[0].value == i, "line %u: %g", i, s.line[i].cell[0].value);
    }
    sheet_free(&s);
}

/* ---- plots ------------------------------------------------------------------ */

static void fill_plot(plot *p) {
    plot_clear(p);
    p->groups = 3;
    p->series = 2;
    snprintf(p->title, sizeof p->title, "A plot & its <title>");
    snprintf(p->unit, sizeof p->unit, "bytes");
    for (unsigned g = 0; g < 3; g++) {
        snprintf(p->group[g], PLOT_NAME, "group %u", g);
        snprintf(p->name[g % 2], PLOT_NAME, "series %u", g % 2);
        p->bar[g][0] = 10.0 * (g + 1);
        p->bar[g][1] = g == 1 ? (double)NAN : 25.0;
        p->mark[g][0] = 40.0;
    }
}

/* Heights of the bars of one colour, from the left; how many. Legends have no bars' feet. */
static unsigned bars_of(const drawing *d, uint32_t colour, double *to) {
    unsigned count = 0;
    for (unsigned i = 0; i < d->items; i++) {
        const drawing_item *at = &d->item[i];
        if (at->shape == DRAWING_RECTANGLE && at->colour == colour && at->y2 > 100.0) {
            to[count++ % 4] = at->y2 - at->y;
        }
    }
    return count;
}

static void check_plot(void) {
    drawing d = {.width = 300, .height = 200};
    picture p = {0};
    plot of;
    fail f = {""};
    fill_plot(&of);
    plot_draw(&of, &d, (plot_area){0, 0, 300, 200});
    test("bars are as high as their values");
    CHECK(drawing_paint(&d, &p, &f) == 0 && p.width == 600 && p.height == 400, "%s", f.text);
    double bar[4];
    CHECK(bars_of(&d, of.colour[0], bar) == 3 && fabs(bar[1] - 2.0 * bar[0]) < 0.05 &&
              fabs(bar[2] - 3.0 * bar[0]) < 0.05 && bar[0] > 10.0,
          "%g %g %g", bar[0], bar[1], bar[2]);
    CHECK(bars_of(&d, of.colour[1], bar) == 2, "a value that is none has a bar");
    test("the pixels of a plot are the same on every machine");
    const uint64_t hash = hash_bytes(p.rgb, 3 * (size_t)p.width * p.height);
    CHECK(hash == UINT64_C(0x5f8670a55c7f2347), "hash %016llx", (unsigned long long)hash);
    output *o = output_open_text(FOLDER "/plot.svg", &f);
    drawing_svg(&d, o, &f);
    output_commit(o, &f);
    test("as SVG its texts have no marks of their own");
    read_back(FOLDER "/plot.svg");
    CHECK(strstr(text, "A plot &#38; its &#60;title&#62;</text>") != NULL, "%s", text);
    CHECK(strncmp(text, "<svg xmlns=\"http://www.w3.org/2000/svg\"", 39) == 0, "%.60s", text);
    CHECK(strcmp(text + strlen(text) - 7, "</svg>\n") == 0, "no end");
    picture_free(&p);
    drawing_free(&d);
}

static void check_odd_plots(void) {
    const double values[] = {0.0, 1e-9, 1e12, (double)NAN};
    test(
        "a plot of nothing, or of the least and the most, alone or not, is drawn within its sheet");
    for (unsigned i = 0; i < 16; i++) {
        drawing d = {.width = 300, .height = 200};
        plot p;
        fill_plot(&p);
        p.is_log = i / 4 % 2;
        for (unsigned g = 0; g < 3; g++) {
            p.bar[g][0] = p.mark[g][0] = values[i % 4];
            p.bar[g][1] = i >= 8 ? 25.0 : (double)NAN;
        }
        plot_draw(&p, &d, (plot_area){0, 0, 300, 200});
        CHECK(!d.wrong && d.items > 8 && d.items < 200, "%u items", d.items);
        for (unsigned k = 0; k < d.items; k++) {
            const drawing_item *at = &d.item[k];
            CHECK(at->y >= 0.0 && at->y <= 200.0 && at->y2 >= 0.0 && at->y2 <= 200.0 &&
                      at->x <= 300.0,
                  "item %u at %g, %g", k, at->x, at->y);
        }
        drawing_free(&d);
    }
}

static void check_letters(void) {
    test("every letter has dots of its own");
    for (int a = '!'; a <= '~'; a++) {
        const uint8_t *rows = letter_rows((char)a);
        unsigned dots = 0;
        for (unsigned i = 0; i < LETTER_ROWS + LETTER_BELOW; i++) {
            dots += rows[i];
            CHECK(rows[i] < 1u << LETTER_COLUMNS, "%c", a);
        }
        CHECK(dots > 0, "%c is empty", a);
        for (int b = a + 1; b <= '~'; b++) {
            CHECK(memcmp(rows, letter_rows((char)b), LETTER_ROWS + LETTER_BELOW) != 0, "%c %c", a,
                  b);
        }
    }
    CHECK(letter_rows('\n') == letter_rows('\200'), "what is no letter is a frame");
}

/* ---- caches ------------------------------------------------------------------ */

static figures some(double seed) {
    figures f;
    for (unsigned i = 0; i < FIGURES; i++) {
        f.of[i] = i % 5 == 4 ? (double)NAN : seed / (i + 3);
    }
    return f;
}

static int same(const figures *a, const figures *b) {
    for (unsigned i = 0; i < FIGURES; i++) {
        if (isnan(a->of[i]) != isnan(b->of[i]) || (!isnan(a->of[i]) && a->of[i] != b->of[i])) {
            return 0;
        }
    }
    return 1;
}

#define CACHE FOLDER "/" CACHE_NAME

static void check_cache(void) {
    cache c;
    fail f = {""};
    figures got, first = some(1.0), second = some(1e9 / 7.0);
    unlink(CACHE);
    test("a cache gives back what it was given, bit for bit, also after it is opened again");
    CHECK(cache_open(&c, FOLDER, &f) == 0, "%s", f.text);
    CHECK(!cache_find(&c, 1, &got), "a figure that was never there");
    cache_add(&c, 1, &second, &f);
    cache_add(&c, UINT64_MAX, &second, &f);
    cache_add(&c, 1, &first, &f);
    for (int again = 0; again < 2; again++) {
        CHECK(cache_find(&c, 1, &got) && same(&got, &first), "not the last");
        CHECK(cache_find(&c, UINT64_MAX, &got) && same(&got, &second), "not the same");
        cache_close(&c);
        CHECK(cache_open(&c, FOLDER, &f) == 0 && c.entries == 3 && c.refused == 0, "%s %u", f.text,
              c.refused);
    }
    cache_close(&c);
}

/* One byte after the other is another one: never is a figure other than it was, and the rest is
 * kept. */
static void check_damage(void) {
    static char whole[4096], damaged[4096];
    const figures first = some(1.0), second = some(2.0);
    fail f = {""};
    cache c;
    unlink(CACHE);
    cache_open(&c, FOLDER, &f);
    cache_add(&c, 11, &first, &f);
    cache_add(&c, 12, &second, &f);
    cache_close(&c);
    snprintf(whole, sizeof whole, "%s", read_back(CACHE));
    const size_t size = strlen(whole), head = strcspn(whole, "\n") + 1;
    test("a damaged line is not used, and those beside it are");
    for (size_t at = head; at < size; at++) {
        for (unsigned how = 0; how < 3; how++) {
            figures got;
            fail g = {""};
            snprintf(damaged, sizeof damaged, "%s", whole);
            damaged[at] = how == 0 ? '7' : how == 1 ? '\n' : ' ';
            if (strcmp(damaged, whole) == 0) {
                continue;
            }
            write_text(CACHE, damaged);
            CHECK(cache_open(&c, FOLDER, &g) == 0, "%s", g.text);
            const int has_first = cache_find(&c, 11, &got);
            CHECK(!has_first || same(&got, &first), "byte %zu: other figures", at);
            const int has_second = cache_find(&c, 12, &got);
            CHECK(!has_second || same(&got, &second), "byte %zu: other figures", at);
            CHECK(has_first + has_second >= (whole[at] != '\n'), "byte %zu: both are lost", at);
            CHECK(c.refused > 0 && has_first + has_second < 2, "byte %zu: not seen", at);
            cache_close(&c);
        }
    }
    test("a line without its end is not used, and the next begins on a line of its own");
    for (size_t size_now = head; size_now < size; size_now++) {
        figures got;
        snprintf(damaged, size_now + 1, "%s", whole);
        write_text(CACHE, damaged);
        CHECK(cache_open(&c, FOLDER, &f) == 0, "%s", f.text);
        cache_add(&c, 13, &second, &f);
        cache_close(&c);
        CHECK(cache_open(&c, FOLDER, &f) == 0, "%s", f.text);
        CHECK(cache_find(&c, 13, &got) && same(&got, &second), "%zu bytes", size_now);
        cache_close(&c);
    }
}

static void limit_files(rlim_t bytes) {
    struct rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = bytes < limit.rlim_max ? bytes : limit.rlim_max;
    setrlimit(RLIMIT_FSIZE, &limit);
}

/* A limit of files' size stands in for a disk that fills up, byte for byte. */
static void check_full(void) {
    const figures first = some(1.0), second = some(2.0);
    fail f = {""};
    cache c;
    unlink(CACHE);
    cache_open(&c, FOLDER, &f);
    cache_add(&c, 11, &first, &f);
    cache_add(&c, 12, &second, &f);
    cache_close(&c);
    const size_t size = strlen(read_back(CACHE)), head = strcspn(text, "\n") + 1;
    const size_t one = head + strcspn(text + head, "\n") + 1;
    test("a full disk leaves whole lines, no new file without any, and says what to do");
    for (size_t room = 0; room <= size; room++) {
        const size_t due = room < head ? 0 : room < one ? head : room < size ? one : size;
        fail g = {""};
        unlink(CACHE);
        limit_files(room);
        int status = cache_open(&c, FOLDER, &g);
        if (status == 0) {
            status = cache_add(&c, 11, &first, &g) != 0 || cache_add(&c, 12, &second, &g) != 0;
            cache_close(&c);
        }
        limit_files(RLIM_INFINITY);
        CHECK((status == 0) == (room == size), "%zu bytes: status %d", room, status);
        CHECK(room == size || (strncmp(g.text, CACHE ": cannot write: ", strlen(CACHE) + 16) == 0 &&
                               strstr(g.text, "; free some space") != NULL),
              "%zu bytes: %s", room, g.text);
        CHECK((access(CACHE, F_OK) == 0) == (room >= head), "%zu bytes", room);
        CHECK(strlen(read_back(CACHE)) == due, "%zu bytes: %zu, not %zu", room, strlen(text), due);
    }
    test("... also behind lines that were there, and the next run goes on");
    for (size_t room = one; room <= size; room++) {
        figures got;
        unlink(CACHE);
        cache_open(&c, FOLDER, &f);
        cache_add(&c, 11, &first, &f);
        limit_files(room);
        const int status = cache_add(&c, 12, &second, &f);
        limit_files(RLIM_INFINITY);
        CHECK((status == 0) == (room == size), "%zu bytes", room);
        CHECK(strlen(read_back(CACHE)) == (room < size ? one : size), "%zu bytes", room);
        CHECK(cache_add(&c, 13, &second, &f) == 0, "%zu bytes", room);
        cache_close(&c);
        CHECK(cache_open(&c, FOLDER, &f) == 0 && c.refused == 0, "%zu bytes: %s", room, f.text);
        CHECK(cache_find(&c, 11, &got) && cache_find(&c, 13, &got), "%zu bytes", room);
        cache_close(&c);
    }
}

static void check_foreign(void) {
    static const char *const others[] = {"\n", "planelet tables cache 2\n", "planelet tables cache",
                                         "an essay\n"};
    cache c;
    test("a file that is no cache is refused, and stays as it is");
    for (unsigned i = 0; i < 4; i++) {
        fail f = {""};
        write_text(CACHE, others[i]);
        CHECK(cache_open(&c, FOLDER, &f) == -1 && strstr(f.text, "move it away") != NULL, "%s",
              f.text);
        CHECK(strcmp(read_back(CACHE), others[i]) == 0, "%s", text);
        CHECK(c.file == -1 && c.entry == NULL, "not closed");
    }
    unlink(CACHE);
    mkdir(CACHE, 0777);
    fail f = {""};
    CHECK(cache_open(&c, FOLDER, &f) == -1 && f.text[0] != '\0', "a folder is a cache");
    rmdir(CACHE);
}

/* ---- meshes that move ----------------------------------------------------------- */

static void check_twist(void) {
    mesh still = {0}, m = {0};
    double far[8];
    fail f = {""};
    scene_knot(&still, 1500, &f);
    test("a twist begins with the mesh, keeps heights and distances from the axis, and moves");
    for (unsigned step = 0; step < 8; step++) {
        double moved = 0.0, axis[2] = {0.0, 0.0};
        mesh_free(&m);
        m = (mesh){.vertices = 0};
        scene_knot(&m, 1500, &f);
        for (int a = 0; a < 2; a++) {
            double lo = 1e9, hi = -1e9;
            for (size_t i = 0; i < m.vertices; i++) {
                lo = fmin(lo, (double)m.vertex[3 * i + 2 * (size_t)a]);
                hi = fmax(hi, (double)m.vertex[3 * i + 2 * (size_t)a]);
            }
            axis[a] = 0.5 * (lo + hi);
        }
        twist_mesh(&m, step, 8);
        for (size_t i = 0; i < m.vertices; i++) {
            const float *p = m.vertex + 3 * i, *q = still.vertex + 3 * i;
            const double r = hypot((double)p[0] - axis[0], (double)p[2] - axis[1]);
            const double due = hypot((double)q[0] - axis[0], (double)q[2] - axis[1]);
            CHECK(p[1] == q[1] && fabs(r - due) < 1e-5, "vertex %zu", i);
            moved = fmax(moved, hypot((double)(p[0] - q[0]), (double)(p[2] - q[2])));
        }
        CHECK(step == 0 ? moved == 0.0 : moved > 0.1, "step %u: %g", step, moved);
        far[step] = moved;
    }
    CHECK(far[1] < far[2] && far[2] < far[4] && fabs(far[7] - far[1]) < 1e-6 &&
              fabs(far[6] - far[2]) < 1e-6,
          "%g, %g, %g does not come back", far[1], far[4], far[7]);
    mesh_free(&m);
    mesh_free(&still);
}

int main(void) {
    mkdir(TEST_FOLDER, 0777);
    mkdir(FOLDER, 0777);
    check_sheet();
    check_many_lines();
    check_plot();
    check_odd_plots();
    check_letters();
    check_cache();
    check_damage();
    check_full();
    check_foreign();
    check_twist();
    return test_done();
}
