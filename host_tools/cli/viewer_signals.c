/* viewer_signals - see viewer_signals.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/viewer_signals.h"

#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include "host_tools/picture/terminal_mode.h"

static volatile sig_atomic_t is_resized, is_to_stop, is_continued;
static int is_typed, can_stop;

static void on_signal(int number) {
    is_resized |= number == SIGWINCH;
    is_to_stop |= number == SIGTSTP;
    is_continued |= number == SIGCONT;
}

void viewer_signals_catch(void) {
    /* What is being written goes on; a wait for keys ends in any case. */
    const struct sigaction action = {.sa_handler = on_signal, .sa_flags = SA_RESTART};
    struct sigaction before;
    is_resized = is_to_stop = is_continued = is_typed = 0;
    can_stop = sigaction(SIGTSTP, NULL, &before) == 0 && before.sa_handler != SIG_IGN;
    sigaction(SIGWINCH, &action, NULL);
    sigaction(SIGCONT, &action, NULL);
    if (can_stop) {
        sigaction(SIGTSTP, &action, NULL);
    }
}

void viewer_signals_stop(void) {
    is_typed = is_to_stop = can_stop;
}

int viewer_signals_wait(void) {
    return is_resized || is_to_stop || is_continued;
}

/* Returns when somebody lets it go on. Ctrl-Z is for all that the terminal waits for, as a script
 * that runs this program. */
static int stop(void) {
    const struct sigaction usual = {.sa_handler = SIG_DFL};
    struct sigaction ours;
    fflush(stdout);
    terminal_mode_leave();
    sigaction(SIGTSTP, &usual, &ours);
    kill(is_typed ? 0 : getpid(), SIGTSTP);
    sigaction(SIGTSTP, &ours, NULL);
    is_typed = is_to_stop = is_continued = 0;
    return terminal_mode_enter(STDIN_FILENO, STDOUT_FILENO) == 0 ? 1 : -1;
}

int viewer_signals_take(void) {
    if (!viewer_signals_wait()) {
        return 0;
    }
    is_resized = 0;
    if (is_to_stop) {
        return stop();
    }
    if (is_continued) {
        is_continued = 0;
        return terminal_mode_again() == 0 ? 1 : -1;
    }
    return 1;
}
