/* test_base_colours - signals reset a terminal's colours, and end the program in any case
 *
 * SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "host_tools/base/clock.h"
#include "host_tools/base/temporary.h"
#include "tests/test.h"

enum terminal_state { ACCEPTS, IS_STOPPED, IS_FULL };

static void fill(int terminal) {
    static const char blanks[512];
    const int flags = fcntl(terminal, F_GETFL);
    fcntl(terminal, F_SETFL, flags | O_NONBLOCK);
    while (write(terminal, blanks, sizeof blanks) > 0 || write(terminal, blanks, 1) > 0) {
    }
    fcntl(terminal, F_SETFL, flags);
}

/* A program whose terminal is in colours; says on `ready` that it waits. */
static _Noreturn void draw(int terminal, enum terminal_state state, int ready) {
    temporary_colours(terminal);
    if (state == IS_STOPPED) {
        tcflow(terminal, TCOOFF);
    } else if (state == IS_FULL) {
        fill(terminal);
    }
    while (write(ready, "", 1) == 1) {
        pause();
    }
    _exit(0);
}

/* The signal that ended it; 0: none within two seconds. */
static int wait_for_end(pid_t child) {
    int status = 0;
    for (int i = 0; i < 200; i++) {
        if (waitpid(child, &status, WNOHANG) == child) {
            return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        }
        clock_sleep(0.01);
    }
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return 0;
}

/* Runs it, sends the signal, and returns how many bytes came out; `ended`: which
 * signal it was that ended it. */
static ssize_t end_by(int number, enum terminal_state state, char *came, size_t room, int *ended) {
    int ends[2];
    char byte;
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    CHECK(master >= 0 && grantpt(master) == 0 && unlockpt(master) == 0, "no terminal");
    const int terminal = open(ptsname(master), O_RDWR | O_NOCTTY);
    CHECK(terminal >= 0 && pipe(ends) == 0, "no terminal: %s", strerror(errno));
    const pid_t child = fork();
    if (child == 0) {
        draw(terminal, state, ends[1]);
    }
    CHECK(read(ends[0], &byte, 1) == 1 && kill(child, number) == 0, "it does not run");
    *ended = wait_for_end(child);
    struct pollfd p = {.fd = master, .events = POLLIN};
    const ssize_t bytes = poll(&p, 1, 0) == 1 ? read(master, came, room) : 0;
    close(ends[0]);
    close(ends[1]);
    close(terminal);
    close(master);
    return bytes;
}

int main(void) {
    static const int numbers[] = {SIGTERM, SIGHUP, SIGINT};
    char came[64];
    int ended;
    for (unsigned i = 0; i < 3; i++) {
        signal(numbers[i], SIG_DFL); /* nohup, a shell's background */
    }
    test("a signal resets the colours of a terminal, then ends the program");
    for (unsigned i = 0; i < 3; i++) {
        const ssize_t bytes = end_by(numbers[i], ACCEPTS, came, sizeof came, &ended);
        CHECK(ended == numbers[i], "signal %d: ended by %d", numbers[i], ended);
        CHECK(bytes == 4 && memcmp(came, "\x1b[0m", 4) == 0, "signal %d: %zd bytes", numbers[i],
              bytes);
    }
    test("a terminal that was stopped, or that nobody reads, does not keep it from ending");
    for (unsigned i = 0; i < 3; i++) {
        end_by(numbers[i], IS_STOPPED, came, sizeof came, &ended);
        CHECK(ended == numbers[i], "stopped, signal %d: ended by %d", numbers[i], ended);
        end_by(numbers[i], IS_FULL, came, sizeof came, &ended);
        CHECK(ended == numbers[i], "full, signal %d: ended by %d", numbers[i], ended);
    }
    return test_done();
}
