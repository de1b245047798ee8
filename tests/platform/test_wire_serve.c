/* test_wire_serve - reports over byte streams, and both peers in two processes
 *
 * SPDX-License-Identifier: MIT */
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host_tools/link/emulated.h"
#include "host_tools/link/serve.h"
#include "tests/reference/random.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* ---- stuffing ---------------------------------------------------------------------------- */

static size_t random_report(random_state *r, uint8_t *to) {
    const size_t count = 1 + random_below(r, WIRE_REPORT_BYTES_MAX);
    const uint32_t zeros = random_below(r, 3);
    for (size_t i = 0; i < count; i++) {
        const uint8_t byte = (uint8_t)random_bits(r);
        to[i] = zeros == 0 ? (uint8_t)(byte | 1) : zeros == 1 ? (uint8_t)(byte & 3) : byte;
    }
    return count;
}

static void test_stuffing(void) {
    static wire_bytes_reader reader;
    static uint8_t report[WIRE_REPORT_BYTES_MAX], bytes[WIRE_BYTES_MOST];
    random_state r = {1};
    test("a report of any bytes survives the byte stream, with no zero inside");
    for (int n = 0; n < 4000; n++) {
        const size_t count = random_report(&r, report), used = wire_bytes_put(bytes, report, count);
        size_t got = 0;
        for (size_t i = 0; i < used; i++) {
            CHECK((bytes[i] == 0) == (i + 1 == used), "a zero at %zu of %zu", i, used);
            got = wire_bytes_read(&reader, bytes[i]);
        }
        CHECK(got == count && memcmp(reader.report, report, count) == 0, "%zu of %zu bytes", got,
              count);
    }
    test("after bytes were lost or added, the report after the next zero is right again");
    for (int n = 0; n < 4000; n++) {
        size_t count = random_report(&r, report), used = wire_bytes_put(bytes, report, count),
               got = 0;
        const size_t at = random_below(&r, (uint32_t)used);
        for (size_t i = 0; i < used; i++) {
            if (i == at) {
                wire_bytes_read(&reader, (uint8_t)random_bits(&r));
            } else if (i != at + 1 || i + 1 == used) {
                wire_bytes_read(&reader, bytes[i]);
            }
        }
        wire_bytes_read(&reader, 0);
        count = random_report(&r, report);
        used = wire_bytes_put(bytes, report, count);
        for (size_t i = 0; i < used; i++) {
            got = wire_bytes_read(&reader, bytes[i]);
        }
        CHECK(got == count && memcmp(reader.report, report, count) == 0, "%zu of %zu", got, count);
    }
}

/* ---- serving ------------------------------------------------------------------------------- */

enum { WIDTH = 64, HEIGHT = 50, FRAMES = 3, MEMORY = 1 << 18 };

static rig direct;
static uint8_t frames[FRAMES][WIDTH * HEIGHT * 3];
static unsigned frames_taken;

static void view_of(void *context, unsigned number, wire_view *v) {
    (void)context;
    *v = (wire_view){.eye = {3.0f - (float)number, 2, 4}, .up = {0, 1, 0}, .tan_half_fov = 0.4f};
}

static int keep_frame(void *context, unsigned number, const picture *p, fail *f) {
    (void)context, (void)f;
    memcpy(frames[number % FRAMES], p->rgb, sizeof frames[0]);
    frames_taken++;
    return 0;
}

static serve_job job_of(uint32_t patience_ms) {
    return (serve_job){.image = direct.image.bytes,
                       .image_bytes = (uint32_t)direct.image.size,
                       .width = WIDTH,
                       .height = HEIGHT,
                       .format = WIRE_RGB888,
                       .report_bytes = 64,
                       .frames = FRAMES,
                       .patience_ms = patience_ms,
                       .view = view_of,
                       .frame = keep_frame};
}

static void check_frames(const char *how) {
    static uint8_t rgb[WIDTH * HEIGHT * 3];
    uint32_t pixels = 0;
    CHECK(frames_taken == FRAMES, "%s: %u frames came", how, frames_taken);
    for (unsigned i = 0; i < FRAMES; i++) {
        wire_view v;
        view_of(NULL, i, &v);
        plt_frame frame = {.width = WIDTH, .height = HEIGHT};
        memcpy(frame.camera.eye, v.eye, sizeof v.eye);
        memcpy(frame.camera.up, v.up, sizeof v.up);
        frame.camera.tan_half_fov = v.tan_half_fov;
        CHECK(plt_render_begin(direct.engine, &frame) == PLT_OK, "the camera");
        for (int status = PLT_MORE; status > 0;) {
            status = plt_render_step(direct.engine, 10000);
            plt_tile t;
            plt_render_tile(direct.engine, &t);
            for (unsigned y = 0; status == PLT_TILE && y < t.height; y++) {
                memcpy(rgb + 3 * ((t.y + y) * WIDTH + t.x), t.rgb + 3u * y * t.width, 3u * t.width);
                pixels += t.width;
            }
        }
        CHECK(memcmp(rgb, frames[i], sizeof rgb) == 0, "%s: frame %u differs", how, i);
    }
    CHECK(pixels == FRAMES * WIDTH * HEIGHT, "%s: %u pixels compared", how, pixels);
    memset(frames, 0, sizeof frames);
    frames_taken = 0;
}

/* A device that connects to what the link says, as a process. */
static pid_t connect_device(const stream_link *l) {
    const pid_t child = fork();
    if (child == 0) {
        stream_link own;
        struct sockaddr_un at = {.sun_family = AF_UNIX};
        int file = l->is_pty ? open(l->name, O_RDWR | O_NOCTTY) : socket(AF_UNIX, SOCK_STREAM, 0);
        snprintf(at.sun_path, sizeof at.sun_path, "%s", l->name);
        if (!l->is_pty && connect(file, (const struct sockaddr *)&at, sizeof at) != 0) {
            _exit(1);
        }
        link_of_file(&own, file);
        const transport t = link_transport(&own);
        emulated_device(&t, 64, MEMORY);
        _exit(0);
    }
    return child;
}

static void serve_over(stream_link *l, const char *how) {
    const transport t = link_transport(l);
    const serve_job job = job_of(20000);
    const pid_t child = connect_device(l);
    serve_result result;
    fail f = {""};
    CHECK(serve_run(&job, &t, &result, &f) == 0, "%s: %s", how, f.text);
    check_frames(how);
    link_close(l);
    int status;
    kill(child, SIGTERM);
    waitpid(child, &status, 0);
}

static void test_serving(void) {
    mesh m = {0};
    stream_link l;
    serve_result result;
    fail f = {""};
    const rig_config config = rig_config_of(2, 16, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    shape_icosphere(&m, rig_is_tiny() ? 1 : 3);
    CHECK(rig_open(&direct, &m, &config) == PLT_OK, "%s", direct.fault.message);
    test(
        "a device in another process renders what a direct render gives: by socket, by pseudo "
        "terminal");
    char path[108];
    snprintf(path, sizeof path, TEST_FOLDER "serve-%d", (int)getpid());
    mkdir(TEST_FOLDER, 0777);
    CHECK(link_open_socket(&l, path, &f) == 0, "%s", f.text);
    serve_over(&l, "socket");
    CHECK(link_open_pty(&l, &f) == 0, "%s", f.text);
    serve_over(&l, "pseudo terminal");
    test("a scene that does not fit, a device that is silent: a sentence that says so");
    serve_job job = job_of(300);
    CHECK(emulated_start(&l, 64, 2000, &f) == 0, "%s", f.text);
    transport t = link_transport(&l);
    CHECK(serve_run(&job, &t, &result, &f) != 0 && strstr(f.text, "bytes there, it has 2000"),
          "'%s'", f.text); /* nor can it be streamed in so few */
    link_close(&l);
    f.text[0] = '\0';
    CHECK(link_open_socket(&l, path, &f) == 0, "%s", f.text);
    t = link_transport(&l);
    CHECK(serve_run(&job, &t, &result, &f) != 0 && strstr(f.text, "did not answer"), "'%s'",
          f.text);
    link_close(&l);
    CHECK(access(path, F_OK) != 0, "the socket is left behind");
    rig_close(&direct);
    mesh_free(&m);
}

/* The device refuses to open, so its process ends. */
static void test_other_tiles(void) {
    static const uint8_t image[64];
    stream_link l;
    serve_result result;
    fail f = {""};
    test("a device built with tiles of another size does not answer, and the host says so");
    serve_job job = job_of(300);
    job.image = image;
    job.image_bytes = sizeof image;
    CHECK(emulated_start(&l, 64, MEMORY, &f) == 0, "%s", f.text);
    const transport t = link_transport(&l);
    CHECK(serve_run(&job, &t, &result, &f) != 0 && f.text[0] != '\0', "it answered");
    CHECK(frames_taken == 0, "%u frames came", frames_taken);
    link_close(&l);
}

int main(void) {
    test_stuffing();
    if (PLT_TILE_SIDE == WIRE_TILE_SIDE) {
        test_serving();
    } else {
        test_other_tiles();
    }
    return test_done();
}
