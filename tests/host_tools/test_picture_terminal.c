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

static char shown[1 << 20];

static void show(const picture *p, picture_ink ink, unsigned columns, unsigned rows) {
    FILE *file = fopen(TEST_FOLDER "terminal.txt", "w+b");
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
    for (unsigned i = 0; i < 10 * 5 * PICTURE_INKS; i++) {
        const unsigned *side = sides[i % 10], *room = cells[i / 10 % 5];
        unsigned columns, rows;
        picture p;
        fail f = {""};
        picture_make(&p, side[0], side[1], &f);
        show(&p, (picture_ink)(i / 50), room[0], room[1]);
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
    FILE *file = fopen(TEST_FOLDER "terminal.txt", "wb");
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

static void set(const char *name, const char *value) {
    value ? setenv(name, value, 1) : unsetenv(name);
}

/* How the pixel of test_terminal looks in each ink. */
static const char *const looks[PICTURE_INKS] = {
    [PICTURE_PLAIN] = "+",
    [PICTURE_HUES] = "\x1b[1;31m@\x1b[0m",
    [PICTURE_256] = "\x1b[38;5;203m" UP "\x1b[0m",
    [PICTURE_256_BLANKS] = "\x1b[48;5;203m \x1b[0m",
    [PICTURE_COLOUR] = "\x1b[38;2;240;80;80m" UP "\x1b[0m",
    [PICTURE_COLOUR_BLANKS] = "\x1b[48;2;240;80;80m \x1b[0m",
};

static void test_terminal(void) {
    static const struct {
        const char *term, *colorterm, *no_color, *lc_all, *lc_ctype, *lang;
        picture_ink ink;
    } cases[] = {
        {"xterm", "truecolor", NULL, NULL, NULL, "C.UTF-8", PICTURE_COLOUR},
        {"xterm", "24bit", NULL, NULL, NULL, "C.UTF-8", PICTURE_COLOUR},
        {"xterm-direct", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_COLOUR},
        {"linux", "truecolor", NULL, NULL, NULL, "C.UTF-8", PICTURE_COLOUR},
        {"xterm", "yes", NULL, NULL, NULL, "C.UTF-8", PICTURE_256},
        {"xterm", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_256},
        {"xterm-256color", "", NULL, NULL, NULL, "C.UTF-8", PICTURE_256},
        {"never-heard-of", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_256},
        {"linux", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_HUES},
        {"linux", NULL, NULL, NULL, NULL, NULL, PICTURE_HUES},
        {"ansi", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_HUES},
        {"xterm-16color", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_HUES},
        {"xterm", NULL, "", NULL, NULL, "C.UTF-8", PICTURE_256},
        {"xterm", "truecolor", "1", NULL, NULL, "C.UTF-8", PICTURE_PLAIN},
        {"linux", NULL, "0", NULL, NULL, "C.UTF-8", PICTURE_PLAIN},
        {"dumb", "truecolor", NULL, NULL, NULL, "C.UTF-8", PICTURE_PLAIN},
        {"vt100", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_PLAIN},
        {"vt102", "truecolor", NULL, NULL, NULL, "C.UTF-8", PICTURE_PLAIN},
        {"vt220-8bit", NULL, NULL, NULL, NULL, NULL, PICTURE_PLAIN},
        {"vt52", NULL, NULL, NULL, NULL, NULL, PICTURE_PLAIN},
        {"vt525", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_256},
        {"xterm-mono", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_PLAIN},
        {"linux-m", NULL, NULL, NULL, NULL, NULL, PICTURE_PLAIN},
        {"rxvt-cygwin-mono2", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_256},
        {NULL, "truecolor", NULL, NULL, NULL, "C.UTF-8", PICTURE_PLAIN},
        {"", NULL, NULL, NULL, NULL, "C.UTF-8", PICTURE_PLAIN},
        /* which variable is the locale, and what names UTF-8 */
        {"xterm", NULL, NULL, NULL, NULL, NULL, PICTURE_256_BLANKS},
        {"xterm", NULL, NULL, "", "", "", PICTURE_256_BLANKS},
        {"xterm", NULL, NULL, "C", "C.UTF-8", "C.UTF-8", PICTURE_256_BLANKS},
        {"xterm", NULL, NULL, NULL, "de_DE.ISO-8859-1", "C.UTF-8", PICTURE_256_BLANKS},
        {"xterm", NULL, NULL, "POSIX", NULL, NULL, PICTURE_256_BLANKS},
        {"xterm", NULL, NULL, "C.UTF-8", "C", "C", PICTURE_256},
        {"xterm", NULL, NULL, "", "en_GB.utf8", "C", PICTURE_256},
        {"xterm", NULL, NULL, NULL, "UTF-8", NULL, PICTURE_256},
        {"xterm", NULL, NULL, NULL, NULL, "ca_ES.UTF-8@valencia", PICTURE_256},
        {"xterm", NULL, NULL, NULL, NULL, "de_DE.UTF-16", PICTURE_256_BLANKS},
        {"xterm", "24bit", NULL, NULL, NULL, "de_DE@euro", PICTURE_COLOUR_BLANKS},
    };
    uint8_t pixel[3] = {240, 80, 80};
    const picture p = {pixel, 1, 1};
    test("terminal: NO_COLOR, TERM, COLORTERM and the locale choose; its own size is used");
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        set("TERM", cases[i].term);
        set("COLORTERM", cases[i].colorterm);
        set("NO_COLOR", cases[i].no_color);
        set("LC_ALL", cases[i].lc_all);
        set("LC_CTYPE", cases[i].lc_ctype);
        set("LANG", cases[i].lang);
        CHECK(show_terminal(&p, PICTURE_AUTO), "no pseudo terminals; is /dev/pts mounted?");
        const size_t length = strlen(looks[cases[i].ink]);
        CHECK(!strncmp(shown, looks[cases[i].ink], length) && !strcmp(shown + length, "\r\n"),
              "case %u: %s", i, readable());
    }
    test("terminal: an ink that was asked for is used whatever the environment says");
    set("NO_COLOR", "1");
    for (unsigned ink = PICTURE_PLAIN; ink < PICTURE_INKS; ink++) {
        CHECK(show_terminal(&p, (picture_ink)ink), "no pseudo terminals; is /dev/pts mounted?");
        CHECK(!strncmp(shown, looks[ink], strlen(looks[ink])), "ink %u: %s", ink, readable());
    }
    set("NO_COLOR", NULL);
    set("TERM", "xterm");
    set("LANG", "C.UTF-8");
    show(&p, PICTURE_AUTO, 80, 24);
    CHECK(!strcmp(shown, "+\n"), "a file got colours: %s", readable());
}

/* Colour 16 to 255 as xterm shows it. */
static void colour_of(unsigned number, int rgb[3]) {
    for (unsigned i = 0, rest = number - 16; i < 3; i++, rest /= 6) {
        const int step = (int)(rest % 6);
        rgb[2 - i] = number >= 232 ? 8 + 10 * ((int)number - 232) : step ? 55 + 40 * step : 0;
    }
}

static int far(const uint8_t *a, const int b[3]) {
    int sum = 0;
    for (unsigned i = 0; i < 3; i++) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return sum;
}

static void test_nearest(void) {
    test("256 colours: of 35,937 colours and all greys none has a nearer one than is chosen");
    for (unsigned i = 0; i < 33 * 33 * 33 + 256; i++) {
        const unsigned grey = i - 33 * 33 * 33, step[3] = {i % 33, i / 33 % 33, i / 1089};
        uint8_t rgb[3];
        int least = 3 * 255 * 255, colour[3];
        for (unsigned k = 0; k < 3; k++) {
            rgb[k] = (uint8_t)(i >= 33 * 33 * 33 ? grey : step[k] == 32 ? 255 : 8 * step[k]);
        }
        for (unsigned number = 16; number < 256; number++) {
            colour_of(number, colour);
            least = far(rgb, colour) < least ? far(rgb, colour) : least;
        }
        const unsigned chosen = terminal_nearest_256(rgb);
        colour_of(chosen, colour);
        CHECK(chosen >= 16 && chosen < 256 && far(rgb, colour) == least, "%u %u %u: %u", rgb[0],
              rgb[1], rgb[2], chosen);
    }
}

static void test_hues(void) {
    static const struct {
        uint8_t rgb[3];
        unsigned hue;
    } cases[] = {{{0, 0, 0}, 7},      {{255, 255, 255}, 7}, {{90, 90, 90}, 7},
                 {{255, 0, 0}, 1},    {{0, 9, 0}, 2},       {{0, 0, 255}, 4},
                 {{80, 200, 200}, 6}, {{250, 240, 20}, 3},  {{200, 20, 200}, 5},
                 {{100, 61, 100}, 7}, {{100, 59, 100}, 5},  {{255, 120, 0}, 1},
                 {{255, 135, 0}, 3}};
    test("hues: of the channels that are nearer to the brightest than to the darkest");
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const unsigned hue = terminal_hue(cases[i].rgb);
        CHECK(hue == cases[i].hue, "case %u: %u", i, hue);
    }
    test("hues: a character is as bright as the brightest channel, a colour is sent once");
    uint8_t row[15] = {255, 0, 0, 128, 0, 0, 0, 0, 0, 128, 0, 0, 0, 0, 255};
    const picture p = {row, 5, 1};
    show(&p, PICTURE_HUES, 80, 24);
    CHECK(!strcmp(shown, "\x1b[1;31m@+ +\x1b[1;34m@\x1b[0m\n"), "%s", readable());
}

static void test_blanks(void) {
    uint8_t four[12] = {0, 0, 0, 10, 20, 30, 255, 255, 255, 11, 20, 33};
    const picture p = {four, 2, 2}, odd = {four, 1, 3};
    test("blanks: a cell is the mean of its two pixels, at an odd end the last one");
    show(&p, PICTURE_COLOUR_BLANKS, 80, 24);
    CHECK(!strcmp(shown, "\x1b[48;2;128;128;128m \x1b[48;2;11;20;32m \x1b[0m\n"), "%s", readable());
    show(&odd, PICTURE_256_BLANKS, 80, 24);
    CHECK(!strcmp(shown, "\x1b[48;5;232m \x1b[0m\n\x1b[48;5;231m \x1b[0m\n"), "%s", readable());
    test("256 colours: two half blocks, a colour is sent once for a run of cells");
    uint8_t same[12] = {250, 2, 3, 255, 1, 1, 96, 136, 176, 95, 135, 175};
    const picture run = {same, 2, 2};
    show(&run, PICTURE_256, 80, 24);
    CHECK(!strcmp(shown, "\x1b[38;5;196m\x1b[48;5;67m" UP UP "\x1b[0m\n"), "%s", readable());
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
    mkdir(TEST_FOLDER, 0777);
    test_exact();
    test_sizes();
    test_environment();
    test_terminal();
    test_nearest();
    test_hues();
    test_blanks();
    test_full();
    return test_done();
}
