/* pty - runs a command whose standard error, or both outputs, are a terminal
 *
 * pty err|both|BYTES COMMAND ARGUMENT...: what the command writes to the terminal
 * (80 x 24) comes out on standard output, line feeds as the terminal makes
 * them (CR LF); with `err` its own standard output goes to standard error.
 * BYTES is `both`, and somebody presses Ctrl-C as soon as so many bytes came: the
 * command and all it started are then interrupted, as the terminal does it.
 * Ends with the command's status, 128 + n when signal n ended it, 124 when
 * something that it started is still there a second later, or 125 when there is
 * no terminal to be had. When it is killed itself, the command and its group are, too (on
 * Linux).
 *
 * SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { LEFT_BEHIND = 124, NO_TERMINAL = 125, NO_COMMAND = 127, CTRL_C = 3 };

static int open_master(void) {
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    return master >= 0 && grantpt(master) == 0 && unlockpt(master) == 0 ? master : -1;
}

static int open_slave(int master, int flags) {
    const char *name = ptsname(master);
    const int slave = name == NULL ? -1 : open(name, O_RDWR | flags);
#ifdef TIOCSWINSZ
    const struct winsize size = {.ws_row = 24, .ws_col = 80};
    if (slave >= 0) {
        ioctl(slave, TIOCSWINSZ, &size);
    }
#endif
    return slave;
}

/* The signal that comes when the parent ends; it may have ended before. */
static void end_with(pid_t parent, int number) {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, number, 0, 0, 0);
    if (getppid() != parent) {
        raise(number);
    }
#else
    (void)parent, (void)number;
#endif
}

static void become(char **command, int slave, int both) {
    signal(SIGTERM, SIG_DFL);
    signal(SIGINT, SIG_DFL); /* a shell's background commands ignore these two */
    signal(SIGQUIT, SIG_DFL);
    dup2(both ? slave : STDERR_FILENO, STDOUT_FILENO);
    dup2(slave, STDERR_FILENO);
    close(slave);
    execvp(command[0], command);
    _exit(NO_COMMAND);
}

static void pause_20_ms(void) {
    const struct timespec t = {0, 20000000};
    nanosleep(&t, NULL);
}

/* Whether the command has ended, with `status`; it is asked for once only. */
static int has_ended(pid_t child, int *status) {
    static int ended;
    ended = ended || waitpid(child, status, WNOHANG) == child;
    return ended;
}

/* Until the last writer has closed the terminal (Linux then says EIO), or, when
 * Ctrl-C was pressed, the command has ended: others may have stayed. */
static void copy(int master, pid_t child, int *status, long until_ctrl_c) {
    const char ctrl_c = CTRL_C;
    const int presses = until_ctrl_c > 0;
    char bytes[512];
    for (;;) {
        struct pollfd p = {master, POLLIN, 0};
        if (poll(&p, 1, 100) == 0) {
            if (presses && has_ended(child, status)) {
                break;
            }
            continue;
        }
        const ssize_t got = read(master, bytes, sizeof bytes);
        if (got <= 0) {
            break;
        }
        fwrite(bytes, 1, (size_t)got, stdout);
        until_ctrl_c -= got;
        if (until_ctrl_c <= 0 && until_ctrl_c + got > 0 && write(master, &ctrl_c, 1) != 1) {
            break;
        }
    }
    fflush(stdout);
}

/* What the command leaves becomes a child of this process: the ended are
 * still in its group until somebody has waited for them. */
static void inherit(void) {
#ifdef __linux__
    prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
#endif
}

/* Of the command's group, a second after its end at most. */
static int is_somebody_left(pid_t group) {
    for (int i = 0; i < 50; i++) {
        while (waitpid(-group, NULL, WNOHANG) > 0) {
        }
        if (kill(-group, 0) != 0 && errno == ESRCH) {
            return 0;
        }
        pause_20_ms();
    }
    return 1;
}

static volatile sig_atomic_t group; /* of the command, in a session of its own; 0: none */

static void kill_group(int number) {
    (void)number;
    if (group > 0) {
        kill(-group, SIGKILL);
        while (waitpid(-group, NULL, 0) > 0) {
        }
    }
    _exit(LEFT_BEHIND);
}

static int run(char **command, int master, int slave, int both, long until_ctrl_c) {
    inherit();
    const pid_t self = getpid(), child = fork();
    if (child == 0) {
        end_with(self, SIGKILL);
        close(master);
        if (until_ctrl_c > 0) {
            setpgid(0, 0);
        }
        become(command, slave, both);
    }
    if (until_ctrl_c > 0) {
        setpgid(child, child);
        group = child;
        tcsetpgrp(slave, child);
    }
    close(slave);
    if (child < 0) {
        return NO_TERMINAL;
    }
    int status = 0;
    copy(master, child, &status, until_ctrl_c);
    while (!has_ended(child, &status)) {
        pause_20_ms();
    }
    if (until_ctrl_c > 0 && is_somebody_left(child)) {
        return LEFT_BEHIND;
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/* A session whose terminal this is, as a login shell begins one; its end would
 * end all that is in it, as when a window is closed. */
static int run_in_session(char **command, int master, long until_ctrl_c) {
    int status = 0;
    const pid_t self = getpid(), leader = fork();
    if (leader == 0) {
        signal(SIGTERM, kill_group);
        end_with(self, SIGTERM);
        setsid();
        const int slave = open_slave(master, 0);
        _exit(slave < 0 ? NO_TERMINAL : run(command, master, slave, 1, until_ctrl_c));
    }
    close(master);
    return leader < 0 || waitpid(leader, &status, 0) < 0 ? NO_TERMINAL : WEXITSTATUS(status);
}

int main(int argc, char **argv) {
    const int master = open_master();
    const long until_ctrl_c = argc < 3 ? 0 : atol(argv[1]);
    if (master < 0 || argc < 3) {
        return NO_TERMINAL;
    }
    if (until_ctrl_c > 0) {
        return run_in_session(argv + 2, master, until_ctrl_c);
    }
    const int slave = open_slave(master, O_NOCTTY);
    return slave < 0 ? NO_TERMINAL : run(argv + 2, master, slave, strcmp(argv[1], "both") == 0, 0);
}
