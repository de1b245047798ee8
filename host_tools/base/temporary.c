/* temporary - see temporary.h
 *
 * Keeps: every temporary file on disk is in the list `alive`, so that the
 * exit and signal handlers find it. The signals are blocked while the
 * list and the disk disagree.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/temporary.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { NAME_BYTES = 64, TRIES = 100 };

static temporary *volatile alive;

/* All of POSIX that end a program and can be caught, but for SIGXFSZ, which output.c ignores.
 * A program that crashes (a mapped file that somebody shortens is a SIGBUS) also leaves
 * nothing. */
static const int END_SIGNALS[] = {SIGINT,  SIGTERM, SIGHUP,    SIGPIPE, SIGQUIT, SIGALRM,
                                  SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF, SIGXCPU, SIGABRT,
                                  SIGBUS,  SIGFPE,  SIGILL,    SIGSEGV, SIGSYS,  SIGTRAP};
enum { END_SIGNAL_COUNT = sizeof END_SIGNALS / sizeof END_SIGNALS[0] };

static sigset_t end_signals(void) {
    sigset_t set;
    sigemptyset(&set);
    for (int i = 0; i < END_SIGNAL_COUNT; i++) {
        sigaddset(&set, END_SIGNALS[i]);
    }
    return set;
}

static sigset_t block_signals(void) {
    const sigset_t set = end_signals();
    sigset_t before;
    sigprocmask(SIG_BLOCK, &set, &before);
    return before;
}

/* A signal that came meanwhile ends the program here. */
static void restore_signals(const sigset_t *before) {
    sigprocmask(SIG_SETMASK, before, NULL);
}

/* Async-signal-safe. */
static void remove_all(void) {
    for (const temporary *t = alive; t; t = t->next) {
        if (t->owner == getpid()) {
            unlink(t->path);
        }
    }
}

/* Both change only while the signals are blocked. Once set they stay: the terminal may
 * discard even a reset of the colours that was already written. */
static int coloured = -1; /* the terminal's file; -1: none */
static pid_t colours_owner;

/* Async-signal-safe. A terminal that accepts no bytes (Ctrl-S, or nobody reads it)
 * keeps its colours: if this waited for it, no signal could end the program. */
static void reset_colours(void) {
    static const char reset[] = "\x1b[0m";
    struct pollfd terminal = {.fd = coloured, .events = POLLOUT};
    if (coloured < 0 || colours_owner != getpid() || poll(&terminal, 1, 0) != 1 ||
        write(coloured, reset, sizeof reset - 1) < 0) {
        return; /* nothing more can be done */
    }
}

static int terminal_in = -1, terminal_out; /* -1: its modes are its own */
static pid_t terminal_owner;
static struct termios terminal_modes;
static const char *terminal_text;

/* Async-signal-safe. Of a terminal that is gone, or takes no bytes, what can be put back is. */
static void restore_terminal(void) {
    struct pollfd out = {.fd = terminal_out, .events = POLLOUT};
    const int in = terminal_in;
    if (in < 0 || terminal_owner != getpid()) {
        return;
    }
    terminal_in = -1;
    if (poll(&out, 1, 100) == 1 && (out.revents & POLLOUT) != 0 &&
        write(terminal_out, terminal_text, strlen(terminal_text)) < 0) {
        /* its modes are all the more to be put back */
    }
    tcflush(in, TCIFLUSH);
    tcsetattr(in, TCSANOW, &terminal_modes);
}

/* SA_RESETHAND restored the default action, which follows the return. */
static void on_end_signal(int number) {
    remove_all();
    reset_colours();
    restore_terminal();
    raise(number);
}

/* An ignored signal (nohup) stays ignored. */
static void install_handlers(void) {
    static int installed;
    if (installed) {
        return;
    }
    installed = 1;
    atexit(remove_all);
    atexit(restore_terminal);
    struct sigaction action = {.sa_handler = on_end_signal, .sa_flags = (int)SA_RESETHAND};
    action.sa_mask = end_signals();
    for (int i = 0; i < END_SIGNAL_COUNT; i++) {
        struct sigaction before;
        if (sigaction(END_SIGNALS[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL) {
            sigaction(END_SIGNALS[i], &action, NULL);
        }
    }
}

/* O_EXCL never opens what somebody else put there. */
static int create_file(temporary *t, const char *target) {
    static unsigned serial;
    const char *slash = strrchr(target, '/');
    const size_t directory = slash ? (size_t)(slash - target) + 1 : 0;
    t->path = malloc(directory + NAME_BYTES);
    if (!t->path) {
        errno = ENOMEM;
        return -1;
    }
    memcpy(t->path, target, directory);
    for (int i = 0; i < TRIES; i++) {
        snprintf(t->path + directory, NAME_BYTES, ".planelet-%ld-%u.tmp", (long)t->owner, serial++);
        const int fd = open(t->path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0 || errno != EEXIST) {
            return fd;
        }
    }
    return -1;
}

/* Call with the signals blocked. */
static void take(temporary *t, int is_there) {
    const int error = errno;
    if (is_there) {
        t->next = alive;
        alive = t;
    } else {
        free(t->path);
        t->path = NULL;
    }
    errno = error;
}

int temporary_create(temporary *t, const char *target) {
    install_handlers();
    const sigset_t before = block_signals();
    t->owner = getpid();
    const int fd = create_file(t, target);
    take(t, fd >= 0);
    restore_signals(&before);
    return fd;
}

int temporary_make(temporary *t, const char *path, int (*make)(void *), void *context) {
    install_handlers();
    const sigset_t before = block_signals();
    t->owner = getpid();
    t->path = strdup(path);
    const int status = t->path != NULL ? make(context) : -1;
    take(t, status == 0);
    restore_signals(&before);
    return status;
}

/* Call with the signals blocked. */
static void forget(temporary *t) {
    temporary *volatile *link = &alive;
    while (*link != t) {
        link = &(*link)->next;
    }
    *link = t->next;
    free(t->path);
    t->path = NULL;
}

static int finish(temporary *t, const char *target) {
    if (!t->path) {
        return 0;
    }
    const sigset_t before = block_signals();
    const int error = target && rename(t->path, target) != 0 ? errno : 0;
    if (!target || error) {
        unlink(t->path);
    }
    forget(t);
    restore_signals(&before);
    return error;
}

int temporary_keep(temporary *t, const char *target) {
    return finish(t, target);
}

void temporary_remove(temporary *t) {
    finish(t, NULL);
}

void temporary_colours(int file) {
    install_handlers();
    const sigset_t before = block_signals();
    colours_owner = getpid();
    coloured = file;
    restore_signals(&before);
}

void temporary_terminal(int in, int out, const struct termios *modes, const char *text) {
    install_handlers();
    const sigset_t before = block_signals();
    terminal_in = in;
    terminal_out = out;
    terminal_modes = *modes;
    terminal_text = text;
    terminal_owner = getpid();
    restore_signals(&before);
}

void temporary_terminal_restore(void) {
    const sigset_t before = block_signals();
    restore_terminal();
    restore_signals(&before);
}
