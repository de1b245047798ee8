/* test_picture_terminal - pictures in character cells, string for string
 *
 * SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* posix_openpt */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host_tools/picture/terminal.h"
#include "tests/test.h"

#define UP "\xE2\x96\x80"
#define FOLDER "build/test-tmp"

static char shown[1 << 20];

static void show(const picture *p, picture_ink ink, unsigned columns, unsigned rows) {
    FILE *file = fopen(FOLDER "/terminal.txt", "w+b");
    CHECK(file != NULL, "no file");
    if (file) {
        CHECK(picture_show(file, p, ink, columns, rows) == 0, "not written");
        rewind(file);
        shown[fread(shown, 1, sizeof shown - 1, file)] = '\0';
        fclose(file);
    }
}

/* Escapes, so that a failing test can be read. */
static const char *readable(void) {
    static char text[400];
    size_t n = 0;
    for (const char *s = shown; *s && n + 5 < sizeof text; s++) {
        const int plain = *s >= ' ' && *s <= '~';
        n += (size_t)snprintf(text + n, 6, plain ? "%c" : "\\x%02X", (unsigned char)*s);
    }
    text[n] = '\0';
    return text;
}

static void test_exact(void) {
    uint8_t four[12] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    uint8_t same[12] = {9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9};
    uint8_t three[9] = {0, 0, 0, 255, 255, 255, 255, 255, 255};
    uint8_t greys[33];
    const picture p = {four, 2, 2}, flat = {same, 2, 2}, odd = {three, 1, 3};
    test("colour: four pixels are two half blocks, reset at the end of the line");
    show(&p, PICTURE_COLOUR, 80, 24);
    CHECK(!strcmp(shown, "\x1b[38;2;1;2;3m\x1b[48;2;7;8;9m" UP
                         "\x1b[38;2;4;5;6m\x1b[48;2;10;11;12m" UP "\x1b[0m\n"),
          "%s", readable());

    test("colour: a colour is sent once for a run of cells");
    show(&flat, PICTURE_COLOUR, 80, 24);
    CHECK(!strcmp(shown, "\x1b[38;2;9;9;9m\x1b[48;2;9;9;9m" UP UP "\x1b[0m\n"), "%s", readable());

    test("colour: the last line of an odd height has no background, colours start anew");
    show(&odd, PICTURE_COLOUR, 80, 24);
    CHECK(!strcmp(shown, "\x1b[38;2;0;0;0m\x1b[48;2;255;255;255m" UP "\x1b[0m\n"
                         "\x1b[38;2;255;255;255m" UP "\x1b[0m\n"),
          "%s", readable());

    test("plain: brightness goes up the ramp, a cell is the mean of its two pixels");
    show(&odd, PICTURE_PLAIN, 80, 24);
    CHECK(!strcmp(shown, "=\n@\n"), "%s", readable());
    for (unsigned i = 0; i < 33; i++) {
        greys[i] = (uint8_t)(i / 3 * 255 / 10);
    }
    const picture ramp = {greys, 11, 1};
    show(&ramp, PICTURE_PLAIN, 80, 24);
    CHECK(!strcmp(shown, "  .:-=+*#%@\n"), "%s", readable());

    test("shrinking: 3 x 3 pixels in one cell are their exact mean");
    uint8_t nine[27] = {0};
    memset(nine, 90, 3); /* one pixel of 90, eight of 0: the mean is 10 */
    const picture square = {nine, 3, 3};
    show(&square, PICTURE_COLOUR, 1, 1);
    CHECK(!strcmp(shown, "\x1b[38;2;10;10;10m" UP "\x1b[0m\n"), "%s", readable());

    uint8_t steps[6] = {10, 10, 10, 11, 12, 13}; /* halves are rounded up */
    const picture pair = {steps, 2, 1};
    show(&pair, PICTURE_COLOUR, 1, 1);
    CHECK(!strcmp(shown, "\x1b[38;2;11;11;12m" UP "\x1b[0m\n"), "%s", readable());

    test("shrinking: 3 columns into 2 share the middle one in equal halves");
    uint8_t row[9] = {30, 30, 30, 60, 60, 60, 90, 90, 90};
    const picture line = {row, 3, 1};
    show(&line, PICTURE_COLOUR, 2, 5);
    CHECK(!strcmp(shown, "\x1b[38;2;40;40;40m" UP "\x1b[38;2;80;80;80m" UP "\x1b[0m\n"), "%s",
          readable());
}

/* Cells of `shown`: the widest line and the number of lines. */
static void count_cells(unsigned *columns, unsigned *rows) {
    unsigned x = 0;
    *columns = *rows = 0;
    for (const char *s = shown; *s; s++) {
        if (*s == '\x1b') {
            s += strcspn(s, "m");
        } else if (*s == '\n') {
            ++*rows;
            x = 0;
        } else {
            x += (*s & 0xC0) != 0x80; /* not within a character */
            *columns = x > *columns ? x : *columns;
        }
    }
}

static void test_sizes(void) {
    static const unsigned sides[][2] = {{1, 1},    {640, 480}, {480, 640}, {1000, 1}, {1, 1000},
                                        {199, 67}, {80, 48},   {81, 48},   {80, 49},  {7, 300}};
    static const unsigned cells[][2] = {{80, 24}, {1, 1}, {3, 50}, {200, 2}, {79, 23}};
    test("size: never more cells than asked for, filled in one direction, aspect kept");
    for (unsigned i = 0; i < 10 * 5 * 2; i++) {
        const unsigned *side = sides[i % 10], *room = cells[i / 10 % 5];
        unsigned columns, rows;
        picture p;
        fail f = {""};
        picture_make(&p, side[0], side[1], &f);
        show(&p, i < 50 ? PICTURE_COLOUR : PICTURE_PLAIN, room[0], room[1]);
        count_cells(&columns, &rows);
        CHECK(columns >= 1 && columns <= room[0] && rows >= 1 && rows <= room[1], "%ux%u: %ux%u",
              side[0], side[1], columns, rows);
        const int whole = columns == side[0] && rows == (side[1] + 1) / 2;
        CHECK(whole || columns == room[0] || rows == room[1], "%ux%u left room: %ux%u", side[0],
              side[1], columns, rows);
        /* columns / (2 rows) = width / height to within the rounding of either */
        const double wide = (double)columns * side[1], tall = 2.0 * rows * side[0];
        const double slack = 2.0 * side[0] + side[1];
        CHECK(wide - tall <= slack && tall - wide <= slack, "%ux%u: %ux%u", side[0], side[1],
              columns, rows);
        picture_free(&p);
    }
}

static void test_environment(void) {
    unsigned columns, rows;
    FILE *file = fopen(FOLDER "/terminal.txt", "wb");
    test("size: COLUMNS and LINES for what is no terminal, 80 x 24 when they say nothing");
    CHECK(file != NULL, "no file");
    if (!file) {
        return;
    }
    setenv("COLUMNS", "100", 1);
    setenv("LINES", "30", 1);
    picture_terminal_size(file, &columns, &rows);
    CHECK(columns == 100 && rows == 30, "%u x %u", columns, rows);
    static const char *const nonsense[] = {"", "0", "-5", "x", "12x", "99999999999"};
    for (unsigned i = 0; i < 6; i++) {
        setenv("COLUMNS", nonsense[i], 1);
        setenv("LINES", nonsense[i], 1);
        picture_terminal_size(file, &columns, &rows);
        CHECK(columns == 80 && rows == 24, "\"%s\": %u x %u", nonsense[i], columns, rows);
    }
    unsetenv("COLUMNS");
    unsetenv("LINES");
    picture_terminal_size(file, &columns, &rows);
    CHECK(columns == 80 && rows == 24, "%u x %u", columns, rows);
    fclose(file);
}

/* What a terminal of 30 x 10 cells is sent. 0: no pseudo terminals here. */
static int show_terminal(const picture *p, picture_ink ink) {
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    if (master < 0 || grantpt(master) || unlockpt(master)) {
        return 0;
    }
    FILE *slave = fopen(ptsname(master), "r+");
    if (!slave) {
        close(master);
        return 0;
    }
    struct winsize size = {.ws_row = 10, .ws_col = 30};
    unsigned columns, rows;
    ioctl(fileno(slave), TIOCSWINSZ, &size);
    setenv("COLUMNS", "99", 1);
    picture_terminal_size(slave, &columns, &rows);
    CHECK(columns == 30 && rows == 10, "%u x %u", columns, rows);
    CHECK(picture_show(slave, p, ink, 0, 0) == 0, "not written");
    const ssize_t count = read(master, shown, sizeof shown - 1);
    shown[count > 0 ? count : 0] = '\0';
    fclose(slave);
    close(master);
    return 1;
}

static void test_terminal(void) {
    static const struct {
        const char *term, *no_colour;
        picture_ink ink;
        int coloured;
    } cases[] = {
        {"xterm", NULL, PICTURE_AUTO, 1},  {"xterm", "", PICTURE_AUTO, 1},
        {"xterm", "1", PICTURE_AUTO, 0},   {"dumb", NULL, PICTURE_AUTO, 0},
        {NULL, NULL, PICTURE_AUTO, 0},     {"", NULL, PICTURE_AUTO, 0},
        {"xterm", NULL, PICTURE_PLAIN, 0}, {"dumb", "1", PICTURE_COLOUR, 1},
    };
    uint8_t pixel[3] = {255, 255, 255};
    const picture p = {pixel, 1, 1};
    test("terminal: colour unless NO_COLOR, TERM=dumb or no TERM; its own size is used");
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        cases[i].term ? setenv("TERM", cases[i].term, 1) : unsetenv("TERM");
        cases[i].no_colour ? setenv("NO_COLOR", cases[i].no_colour, 1) : unsetenv("NO_COLOR");
        CHECK(show_terminal(&p, cases[i].ink), "no pseudo terminals; is /dev/pts mounted?");
        CHECK((strchr(shown, '\x1b') != NULL) == cases[i].coloured, "case %u: %s", i, readable());
    }
    setenv("TERM", "xterm", 1);
    unsetenv("NO_COLOR");
    show(&p, PICTURE_AUTO, 80, 24);
    CHECK(!strcmp(shown, "@\n"), "a file got colours: %s", readable());
}

static void test_full(void) {
    picture p;
    fail f = {""};
    test("full disk: showing a small or a large picture returns -1");
    for (unsigned side = 1; side <= 201; side += 200) {
        FILE *full = fopen("/dev/full", "w");
        CHECK(full != NULL, "no /dev/full here");
        picture_make(&p, side, side, &f);
        errno = 0;
        CHECK(full && picture_show(full, &p, PICTURE_COLOUR, 300, 300) == -1, "written?");
        CHECK(errno == ENOSPC, "errno %d", errno);
        picture_free(&p);
        if (full) {
            fclose(full);
        }
    }
}

int main(void) {
    mkdir("build", 0777);
    mkdir(FOLDER, 0777);
    test_exact();
    test_sizes();
    test_environment();
    test_terminal();
    test_full();
    return test_done();
}
