/* phase - see phase.h
 *
 * SIGALRM ticks once per second. Keeps: the handler touches only this file's
 * state, which changes only while no alarm is set, and calls only write.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/phase.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { WHAT_SHOWN = 40 }; /* bytes: the line must fit a narrow terminal */

static char line[120]; /* "\r\033[Kreading bunny.ply, " and room for the seconds */
static size_t line_length;
static volatile sig_atomic_t seconds;

/* Appends `number` and " s" at `at`; returns the length. */
static size_t put_seconds(char *at, unsigned number) {
    char digits[12];
    size_t count = 0, length = 0;
    do {
        digits[count++] = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0);
    while (count > 0) {
        at[length++] = digits[--count];
    }
    at[length++] = ' ';
    at[length++] = 's';
    return length;
}

static void on_alarm(int number) {
    const int before = errno;
    (void)number;
    seconds = seconds + 1;
    const size_t length = line_length + put_seconds(line + line_length, (unsigned)seconds);
    const ssize_t written = write(STDERR_FILENO, line, length);
    (void)written; /* a terminal that is gone shows no progress */
    alarm(1);
    errno = before;
}

static void prepare(const char *doing, const char *what) {
    const size_t length = strlen(what);
    const int cut = length > WHAT_SHOWN;
    const int n = snprintf(line, sizeof line - 16, "\r\033[K%s %s%s, ", doing, cut ? "..." : "",
                           cut ? what + length - WHAT_SHOWN : what);
    line_length = n < 0 ? 0 : strlen(line);
    for (size_t i = 4; i < line_length; i++) {
        if ((unsigned char)line[i] < 0x20 || line[i] == 0x7f) {
            line[i] = '?';
        }
    }
}

void phase_begin(const char *doing, const char *what) {
    if (!isatty(STDERR_FILENO)) {
        return;
    }
    struct sigaction action = {.sa_handler = on_alarm, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    prepare(doing, what);
    seconds = 0;
    if (sigaction(SIGALRM, &action, NULL) == 0) {
        alarm(1);
    }
}

void phase_end(void) {
    alarm(0);
    if (seconds > 0) {
        fputs("\r\033[K", stderr);
        fflush(stderr);
    }
    seconds = 0;
}
