/* test_hid_pipe - planelet-hid show -, fed by a slow program
 *
 * SPDX-License-Identifier: MIT */
#include <signal.h>
#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host_tools/base/clock.h"
#include "host_tools/hid/commands.h"
#include "platform/wire/wire_format.h"
#include "tests/hid/model.h"
#include "tests/reference/fake_hidapi.h"
#include "tests/test.h"

enum { WIDTH = 64, HEIGHT = 48 };

typedef struct bench {
    model *model;
    unsigned hellos, changes, last; /* sessions asked for; frames that came; grey of the last */
    double heard, silence;          /* clock; seconds, the longest */
    const char *part;               /* not NULL: all that the writer writes before it waits */
} bench;

static void on_output(void *context, const uint8_t *report, size_t bytes) {
    bench *b = context;
    const double now = clock_seconds(), gap = b->heard > 0.0 ? now - b->heard : 0.0;
    b->silence = gap > b->silence ? gap : b->silence;
    b->heard = now;
    if (b->part != NULL && gap > 0.1) { /* the host waits, and asks whether we are there */
        raise(SIGTERM);
    }
    b->hellos += report[5] == 0x80 && report[6] == 0x10; /* control, HELLO */
    b->model->kind->output(b->model, report, bytes);
}

static size_t on_input(void *context, uint8_t *report, size_t room) {
    bench *b = context;
    return b->model->kind->input(b->model, report, room);
}

static void on_change(void *context, model *m) {
    bench *b = context;
    b->changes += m->rgb[0] != b->last;
    b->last = m->rgb[0];
}

/* A film of 25 frames per second whose frames come `ms` apart, in two halves. */
static void write_film(int to, unsigned frames, unsigned ms) {
    static uint8_t luma[WIDTH * HEIGHT];
    FILE *film = fdopen(to, "wb");
    fprintf(film, "YUV4MPEG2 W%d H%d F25:1 Cmono XCOLORRANGE=FULL\n", WIDTH, HEIGHT);
    for (unsigned n = 0; n < frames; n++) {
        memset(luma, (int)(40 * (n + 1)), sizeof luma);
        fprintf(film, "FRAME\n");
        fwrite(luma, 1, sizeof luma / 2, film);
        fflush(film);
        clock_sleep(1e-3 * (n > 0 ? ms : 0));
        fwrite(luma, 1, sizeof luma / 2, film);
        fflush(film);
    }
    fclose(film);
}

static void write_part(int to, const char *part) {
    if (write(to, part, strlen(part)) >= 0) {
        pause();
    }
}

static pid_t start_writer(const char *part, unsigned frames, unsigned ms) {
    int ends[2];
    if (pipe(ends) != 0) {
        return -1;
    }
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        if (part != NULL) {
            write_part(ends[1], part);
        }
        write_film(ends[1], frames, ms);
        _exit(0);
    }
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    close(ends[1]);
    return child;
}

static int run(bench *b, const char *part, unsigned frames, unsigned ms) {
    char *words[] = {"-"};
    const fake_device device = {.path = "1-1:1.0",
                                .vendor = 0x1209,
                                .product = 0x0001,
                                .context = b,
                                .output = on_output,
                                .input = on_input};
    args a;
    int status = -1;
    const model_shape shape = {.width = WIDTH, .height = HEIGHT, .format = WIRE_GREY8, .reads = 1};
    *b = (bench){.model = model_make(&model_planelet, shape), .part = part};
    b->model->changed = on_change;
    b->model->context = b;
    fake_bus_reset();
    fake_plug(0, &device);
    const pid_t child = start_writer(part, frames, ms);
    if (child > 0 && args_parse(&a, "planelet-hid", &hid_command_show, 1, words) == ARGS_GO_ON) {
        status = hid_run_show(&a);
        args_free(&a);
    }
    kill(child, SIGKILL);
    waitpid(child, NULL, 0);
    CHECK(fake_bus.open == 0 && fake_bus.wrong == 0, "hidapi was used as it should");
    model_free(b->model);
    return status;
}

/* What `show` with these words ends with, before it looks for a display. */
static int status_of(char **words, int count) {
    args a;
    int status = args_parse(&a, "planelet-hid", &hid_command_show, count, words);
    if (status == ARGS_GO_ON) {
        fake_bus_reset();
        status = hid_run_show(&a);
        args_free(&a);
    }
    return status;
}

static void words(void) {
    char *both[] = {"-", "--near", "auto", "--fps", "20"},
         *every[] = {"-", "--fps", "20", "--every"};
    char *fixed[] = {"-", "--near", "3", "--fps", "20"}, *wrong[] = {"-", "--near", "some"};
    test("--fps goes with --near auto, and nothing else with either");
    CHECK(status_of(both, 5) == 1, "auto and a goal: no display");
    CHECK(status_of(fixed, 5) == 2 && status_of(every, 4) == 2, "a goal that is not auto's");
    CHECK(status_of(wrong, 3) == 2, "a word");
}

/* Runs that end well, all else being a matter of how busy the machine is: the best
 * of three is looked at. */
static int is_played(bench *b, unsigned frames, unsigned ms, double silence) {
    CHECK(run(b, NULL, frames, ms) == 0, "failed");
    CHECK(b->last == 40 * frames, "the last is of grey %u", b->last);
    return b->hellos == 1 && b->silence < silence && b->changes == frames;
}

static void films(void) {
    bench b;
    int is_right = 0;
    test("a film that stops for 1.2 s in the middle of a frame does not end the session");
    for (int i = 0; i < 3 && !is_right; i++) {
        is_right = is_played(&b, 2, 1200, 0.7);
    }
    CHECK(is_right, "%u sessions asked for, %.3f s of silence, %u frames", b.hellos, b.silence,
          b.changes);
    test("of a film that comes slower than it should, every frame is shown");
    is_right = 0;
    for (int i = 0; i < 3 && !is_right; i++) {
        is_right = is_played(&b, 5, 150, 1e9);
    }
    CHECK(is_right, "%u sessions asked for, %u frames", b.hellos, b.changes);
}

static void interrupted(void) {
    static const char *const parts[] = {"", "P", "P5 6", "YUV4MPEG2 W64 H4",
                                        "YUV4MPEG2 W64 H48 Cmono\nFRAME\n"};
    test("a signal while the first bytes, a head or a frame are waited for is no failure");
    for (unsigned i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        bench b;
        CHECK(run(&b, parts[i], 0, 0) == 0, "'%s': failed", parts[i]);
        CHECK(b.changes == 0, "'%s': %u frames", parts[i], b.changes);
    }
}

int main(void) {
    /* Its messages on standard error are meant for a person. */
    if (freopen("/dev/null", "w", stderr) == NULL) {
        return 1;
    }
    words();
    films();
    interrupted();
    return test_done();
}
