/* test_picture_graphics - what a terminal says is understood, and pixels come to it as they are
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/picture/inflate.h"
#include "host_tools/picture/terminal_graphics.h"
#include "host_tools/picture/terminal_input.h"
#include "tests/reference/random.h"
#include "tests/test.h"

/* ---- input ------------------------------------------------------------------------------- */

static const struct {
    const char *bytes;
    terminal_event event;
} known[] = {{"q", {TERMINAL_KEY, 'q', 0, 0}},
             {"\x03", {TERMINAL_KEY, 3, 0, 0}},
             {"\x1b[A", {TERMINAL_KEY, TERMINAL_UP, 0, 0}},
             {"\x1b[B", {TERMINAL_KEY, TERMINAL_DOWN, 0, 0}},
             {"\x1bOC", {TERMINAL_KEY, TERMINAL_RIGHT, 0, 0}},
             {"\x1b[1;5D", {TERMINAL_KEY, TERMINAL_LEFT, 0, 0}},
             {"\x1b[<0;12;7M", {TERMINAL_PRESS, 0, 12, 7}},
             {"\x1b[<32;120;70M", {TERMINAL_DRAG, 0, 120, 70}},
             {"\x1b[<0;1;1m", {TERMINAL_RELEASE, 0, 1, 1}},
             {"\x1b[<64;3;4M", {TERMINAL_PRESS, TERMINAL_WHEEL_UP, 3, 4}},
             {"\x1b[<81;3;4M", {TERMINAL_PRESS, TERMINAL_WHEEL_DOWN, 3, 4}},
             {"\x1b[?62;22c", {TERMINAL_ATTRIBUTES, 0, 0, 0}},
             {"\x1b[?62;4;22c", {TERMINAL_ATTRIBUTES, 1, 0, 0}},
             {"\x1b[?4;22c", {TERMINAL_ATTRIBUTES, 0, 0, 0}},
             {"\x1b[6;18;9t", {TERMINAL_CELL, 0, 9, 18}},
             {"\x1b_Gi=31;OK\x1b\\", {TERMINAL_KITTY, 1, 0, 0}},
             {"\x1b_Gi=31;ENOENT:no\x1b\\", {TERMINAL_KITTY, 0, 0, 0}},
             {"\x1b]11;rgb:0/0/0\a", {TERMINAL_OTHER, 0, 0, 0}},
             {"\x1b[5~", {TERMINAL_OTHER, '~', 0, 0}}};
enum { KNOWN = sizeof known / sizeof known[0] };

static void add(terminal_input *in, const char *bytes, size_t count) {
    size_t room;
    uint8_t *to = terminal_input_room(in, &room);
    CHECK(count <= room, "room for %zu, not %zu", room, count);
    memcpy(to, bytes, count);
    terminal_input_add(in, count);
}

static void expect(terminal_input *in, const terminal_event *due, const char *name) {
    const terminal_event e = terminal_input_take(in);
    CHECK(e.kind == due->kind && e.code == due->code && e.x == due->x && e.y == due->y,
          "ESC%s: kind %d code %d at %d, %d", name + (name[0] == 27), (int)e.kind, e.code, e.x,
          e.y);
}

/* Cut anywhere, an event comes once, when it is whole. */
static void check_events(void) {
    for (size_t i = 0; i < KNOWN; i++) {
        const size_t length = strlen(known[i].bytes);
        for (size_t cut = 0; cut < length; cut++) {
            terminal_input in = {.count = 0};
            const terminal_event nothing = {TERMINAL_NOTHING, 0, 0, 0};
            add(&in, known[i].bytes, cut);
            expect(&in, &nothing, known[i].bytes);
            add(&in, known[i].bytes + cut, length - cut);
            add(&in, "z", 1);
            expect(&in, &known[i].event, known[i].bytes);
            expect(&in, &(terminal_event){TERMINAL_KEY, 'z', 0, 0}, known[i].bytes);
        }
    }
}

/* Alt and a key may look like the beginning of a string, and must not make the viewer deaf. */
static void check_broken(void) {
    static const char *const begun[] = {"\x1bP", "\x1b]",    "\x1b_",  "\x1b^",   "\x1bX",
                                        "\x1b[", "\x1b[<12", "\x1b]a", "\x1b_Gi="};
    const terminal_event other = {TERMINAL_OTHER, 0, 0, 0}, end = {TERMINAL_KEY, 3, 0, 0};
    const terminal_event up = {TERMINAL_KEY, TERMINAL_UP, 0, 0}, q = {TERMINAL_KEY, 'q', 0, 0};
    const terminal_event nothing = {TERMINAL_NOTHING, 0, 0, 0};
    for (size_t i = 0; i < sizeof begun / sizeof begun[0]; i++) {
        terminal_input in = {.count = 0};
        add(&in, begun[i], strlen(begun[i]));
        expect(&in, &nothing, begun[i]);
        add(&in, "\3\x1b[A", 4);
        expect(&in, &other, begun[i]);
        expect(&in, &end, begun[i]);
        expect(&in, &up, begun[i]);
        add(&in, begun[i], strlen(begun[i]));
        add(&in, "\x1b[A", 3);
        expect(&in, &other, begun[i]);
        expect(&in, &up, begun[i]);
    }
    for (size_t i = 0; i < 5; i++) { /* strings */
        terminal_input in = {.count = 0};
        add(&in, begun[i], 2);
        terminal_input_pause(&in);
        add(&in, "q", 1);
        expect(&in, &q, begun[i]);
    }
    terminal_input in = {.count = 0};
    add(&in, "\x1b[", 2); /* a key may come in two parts */
    terminal_input_pause(&in);
    add(&in, "A", 1);
    expect(&in, &up, "[A");
}

/* Whatever comes, it is taken in the end. */
static void check_noise(void) {
    static const char letters[] = "\x1b\x1b\x1b[]_PO;;<?0123456789ABMmct\\\a zq\xff";
    random_state random = {1};
    terminal_input in = {.count = 0};
    for (unsigned i = 0; i < 200000; i++) {
        size_t room;
        uint8_t *to = terminal_input_room(&in, &room);
        const size_t count = 1 + random_below(&random, room < 30 ? (uint32_t)room : 30);
        CHECK(room > 0 && room <= TERMINAL_INPUT_BYTES, "room for %zu", room);
        for (size_t k = 0; k < count; k++) {
            to[k] = (uint8_t)letters[random_below(&random, sizeof letters - 1)];
        }
        terminal_input_add(&in, count);
        for (unsigned events = 0; terminal_input_take(&in).kind != TERMINAL_NOTHING; events++) {
            CHECK(events <= TERMINAL_INPUT_BYTES, "events without end");
        }
    }
}

/* ---- pictures ------------------------------------------------------------------------------ */

static picture make_picture(unsigned width, unsigned height) {
    picture p;
    fail f = {""};
    random_state random = {7};
    CHECK(picture_make(&p, width, height, &f) == 0, "%s", f.text);
    for (size_t i = 0; i < 3 * (size_t)width * height; i++) {
        const size_t pixel = i / 3;
        const unsigned ramp[3] = {(unsigned)(pixel % width * 255 / width),
                                  (unsigned)(pixel / width * 255 / height), 90};
        p.rgb[i] = (uint8_t)(ramp[i % 3] + random_below(&random, 4) * (ramp[i % 3] < 252));
    }
    return p;
}

static char *printed(int (*print)(FILE *, const picture *), const picture *p, size_t *count) {
    static char *text;
    FILE *to = open_memstream(&text, count);
    CHECK(to != NULL && print(to, p) == 0, "memory");
    fclose(to);
    return text;
}

static int print_kitty(FILE *to, const picture *p) {
    return terminal_kitty(to, p, 40, 20);
}

static unsigned value_of(char letter) {
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = strchr(letters, letter);
    return at == NULL || letter == '\0' ? 64 : (unsigned)(at - letters);
}

/* The bytes of all pieces; checks what stands around them. */
static size_t unpack(const char *text, size_t count, uint8_t *to) {
    size_t n = 0, at = 0;
    unsigned more = 1;
    while (at < count) {
        const char *body = memchr(text + at, ';', count - at);
        const char *end = body == NULL ? NULL : strstr(body, "\x1b\\");
        CHECK(more == 1 && memcmp(text + at, "\x1b_G", 3) == 0 && end != NULL, "piece at %zu", at);
        CHECK(end - body - 1 <= 4096, "a piece of %zu letters", (size_t)(end - body - 1));
        more = (unsigned)(body[-1] - '0');
        for (const char *p = body + 1; p < end; p += 4) {
            const unsigned word = value_of(p[0]) << 18 | value_of(p[1]) << 12 |
                                  (value_of(p[2]) & 63) << 6 | (value_of(p[3]) & 63);
            to[n++] = (uint8_t)(word >> 16);
            to[n] = (uint8_t)(word >> 8);
            n += p[2] != '=';
            to[n] = (uint8_t)word;
            n += p[3] != '=';
        }
        at = (size_t)(end + 2 - text);
    }
    CHECK(more == 0, "the last piece promises more");
    return n;
}

/* A zlib stream: two bytes of header, and four of a check behind it. */
static void check_inflated(const uint8_t *packed, size_t count, const picture *p, uint8_t *out) {
    const size_t bytes = 3 * (size_t)p->width * p->height;
    CHECK(count > 6 && inflate_bytes(packed + 2, count - 2, out, bytes) == bytes, "%zu bytes",
          count);
    CHECK(memcmp(out, p->rgb, bytes) == 0, "other pixels");
}

static void check_kitty(void) {
    static const unsigned sizes[][2] = {{1, 1}, {2, 3}, {97, 61}, {320, 200}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        picture p = make_picture(sizes[i][0], sizes[i][1]);
        const size_t bytes = 3 * (size_t)p.width * p.height;
        size_t count;
        char *text = printed(print_kitty, &p, &count), head[128];
        uint8_t *packed = malloc(count + 8), *out = malloc(bytes + 1);
        snprintf(head, sizeof head,
                 "\x1b_Ga=T,i=1,p=1,q=2,C=1,f=24,o=z,s=%u,v=%u,c=40,r=20,m=", p.width, p.height);
        CHECK(strncmp(text, head, strlen(head)) == 0, "%.90s", text + 1);
        const size_t n = unpack(text, count, packed);
        check_inflated(packed, n, &p, out);
        free(out);
        free(packed);
        free(text);
        picture_free(&p);
    }
}

/* A terminal of sixels: a register per colour, and pixels that are set. */
typedef struct sixels {
    unsigned colour[256][3];
    uint8_t *rgb, *is_set;
    unsigned width, height;
} sixels;

static void set_column(sixels *s, unsigned x, unsigned top, unsigned bits, unsigned colour) {
    for (unsigned k = 0; k < 6; k++) {
        if (bits >> k & 1) {
            const size_t at = (size_t)(top + k) * s->width + x;
            CHECK(x < s->width && top + k < s->height && !s->is_set[at], "pixel %u, %u", x,
                  top + k);
            s->is_set[at] = 1;
            for (unsigned c = 0; c < 3; c++) {
                s->rgb[3 * at + c] = (uint8_t)((s->colour[colour][c] * 255 + 50) / 100);
            }
        }
    }
}

static void draw_sixels(sixels *s, const char *at) {
    unsigned x = 0, top = 0, colour = 0, times = 1;
    while (*at != 27) {
        char *end = NULL;
        if (*at == '#') {
            unsigned v[4];
            int length = 0;
            colour = (unsigned)strtoul(at + 1, &end, 10) & 255;
            at = end;
            if (sscanf(at, ";2;%u;%u;%u%n", &v[0], &v[1], &v[2], &length) == 3) {
                memcpy(s->colour[colour], v, 3 * sizeof v[0]);
                CHECK(v[0] <= 100 && v[1] <= 100 && v[2] <= 100, "above 100 per cent");
                at += length;
            }
        } else if (*at == '!') {
            times = (unsigned)strtoul(at + 1, &end, 10);
            at = end;
        } else if (*at == '$' || *at == '-') {
            x = 0;
            top += *at++ == '-' ? 6 : 0;
        } else {
            CHECK(*at >= '?' && *at <= '~', "letter %d", *at);
            for (; times > 0; times--) {
                set_column(s, x++, top, (unsigned)(*at - '?'), colour);
            }
            times = 1;
            at++;
        }
    }
    CHECK(strcmp(at, "\x1b\\") == 0, "no string terminator");
}

/* Every pixel once, none farther off than a step of its channel, and no shift of the mean. */
static void check_sixel(void) {
    static const unsigned sizes[][2] = {{1, 1}, {5, 7}, {97, 61}, {320, 200}};
    static const int step[3] = {52, 44, 52};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        picture p = make_picture(sizes[i][0], sizes[i][1]);
        const size_t pixels = (size_t)p.width * p.height;
        sixels s = {.width = p.width, .height = p.height};
        long sum[3] = {0, 0, 0};
        size_t count;
        int length = 0;
        unsigned w = 0, h = 0;
        char *text = printed(terminal_sixel, &p, &count);
        s.rgb = calloc(3, pixels);
        s.is_set = calloc(1, pixels);
        CHECK(sscanf(text, "\x1bP0;1;0q\"1;1;%u;%u%n", &w, &h, &length) == 2 && w == p.width &&
                  h == p.height,
              "%.30s", text + 1);
        draw_sixels(&s, text + length);
        for (size_t k = 0; k < 3 * pixels; k++) {
            const int off = (int)s.rgb[k] - (int)p.rgb[k];
            CHECK(s.is_set[k / 3] && abs(off) <= step[k % 3], "pixel %zu is off by %d", k / 3, off);
            sum[k % 3] += off;
        }
        for (int c = 0; c < 3 && pixels > 1000; c++) {
            CHECK(labs(sum[c]) < 3 * (long)pixels, "channel %d: the mean is off by %g", c,
                  (double)sum[c] / (double)pixels);
        }
        free(s.rgb);
        free(s.is_set);
        free(text);
        picture_free(&p);
    }
}

int main(void) {
    test("keys, the mouse and answers are understood, wherever their bytes are cut");
    check_events();
    test("whatever a terminal sends is taken in the end");
    check_broken();
    check_noise();
    test("kitty's protocol brings every pixel, in pieces of at most 4096 letters");
    check_kitty();
    test("sixels set every pixel once, in a colour near its own");
    check_sixel();
    return test_done();
}
