/* test_hid_stream - what cannot be read to its end is no end
 *
 * Standard input is a socket whose other end goes away without having read what
 * lies there for it: after the bytes that came, reading fails.
 *
 * SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include <errno.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "host_tools/hid/sources/frames_open.h"
#include "tests/test.h"

static int break_after(const char *bytes) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
        return -1;
    }
    const ssize_t there = (ssize_t)strlen(bytes);
    const int is_right =
        write(ends[0], "x", 1) == 1 && write(ends[1], bytes, strlen(bytes)) == there;
    close(ends[1]);
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    return is_right ? 0 : -1;
}

/* Frames that came; the last status in `status`. */
static int read_frames(int *status, fail *f) {
    static const arg_flag none[] = {{NULL, NULL, NULL}};
    static const arg_command command = {"show", "", "", none, 0, 1, NULL, NULL};
    args a = {.program = "planelet-hid", .command = &command};
    frames s = {0};
    picture p = {0};
    int count = 0;
    *status = frames_open(&s, &a, "-", 8, 8, f);
    while (*status == 0 && (*status = s.next(&s, &p, f)) == FRAMES_ONE) {
        count++;
        *status = 0;
    }
    frames_close(&s);
    picture_free(&p);
    return count;
}

static void broken(void) {
    static const struct {
        const char *bytes;
        int frames;
    } cases[] = {{"P5 2 1 255\nab", 1},
                 {"P5 2 1 255\nabP5 2", 1},
                 {"P5 2 1 255\na", 0},
                 {"YUV4MPEG2 W2 H1 Cmo", 0},
                 {"YUV4MPEG2 W2 H1 Cmono\n", 0},
                 {"YUV4MPEG2 W2 H1 Cmono\nFRAME\nab", 1},
                 {"YUV4MPEG2 W2 H1 Cmono\nFRAME\nabFRA", 1},
                 {"\x89PNG\r\n", 0}};
    test("a stream that breaks, between frames or inside, is said to be unreadable");
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fail f = {""};
        int status;
        CHECK(break_after(cases[i].bytes) == 0, "no socket: %s", strerror(errno));
        const int came = read_frames(&status, &f);
        CHECK(came == cases[i].frames && status == FRAMES_FAILED, "case %zu: %d frames, %d", i,
              came, status);
        CHECK(strstr(f.text, "standard input: cannot be read") != NULL, "case %zu: %s", i, f.text);
    }
}

static void half_open(void) {
    test("a file that was opened without memory to read it is closed");
    stream s = {.fd = dup(STDOUT_FILENO)}; /* as a failed stream_open leaves it */
    const int fd = s.fd;
    stream_close(&s);
    CHECK(fd >= 0 && fcntl(fd, F_GETFD) == -1 && errno == EBADF, "%d is open", fd);
    stream_close(&s);
    CHECK(fcntl(STDIN_FILENO, F_GETFD) != -1, "standard input was closed");
}

int main(void) {
    broken();
    half_open();
    return test_done();
}
