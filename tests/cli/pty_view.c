/* pty_view - runs a command in a terminal of its own, presses keys, and looks at what is left
 *
 * pty_view STEP... -- COMMAND ARGUMENT...: the command is a job in the foreground of a
 * session whose terminal has 80 x 24 cells, and whose leader does what a shell does for its jobs.
 * Steps, one after the other: settle          until nothing has come for 0.7 s (20 s at most), then
 * prints "picture HASH BYTES": of what came since the last CSI H send=TEXT       \e is Escape, \NNN
 * an octal byte answer=TEXT     what the terminal says, once, to CSI c resize=CxR      another size
 *   signal=NUMBER   to the command
 *   deaf=MS         takes nothing that comes for so many milliseconds
 *   close           the terminal is gone
 *   stopped         waits until the command is stopped, then prints "stopped modes same|changed
 * screen back|kept"
 *   fg              lets it go on, in the foreground
 *   type=TEXT       keys that the command need not read: they must not be left
 * At the end prints "status N" (128 + n: by signal n; 199: it did not end), "modes same|changed",
 * "left N" (bytes in the terminal's queue), and all that came to the file `screen`.
 *
 * SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE 1
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

enum { NO_TERMINAL = 125, NOT_ENDED = 199 };

static int master = -1;
static unsigned char *all;
static size_t count, room, answered;
static char answer[256];

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* "\e" and "\NNN" become bytes. */
static size_t unescape(const char *text, char *to, size_t most) {
    size_t n = 0;
    while (*text != '\0' && n < most) {
        if (text[0] == '\\' && text[1] == 'e') {
            to[n++] = 27;
            text += 2;
        } else if (text[0] == '\\' && text[1] >= '0' && text[1] <= '7') {
            char *end, digits[4] = {text[1], text[2], text[2] ? text[3] : '\0', 0};
            to[n++] = (char)strtol(digits, &end, 8);
            text += 1 + (end - digits);
        } else {
            to[n++] = *text++;
        }
    }
    return n;
}

static void send_text(const char *text) {
    char bytes[256];
    const size_t n = unescape(text, bytes, sizeof bytes);
    if (write(master, bytes, n) != (ssize_t)n) {
        perror("pty_view: write");
    }
}

static void answer_query(void) {
    for (size_t i = answered; answer[0] != '\0' && i + 3 <= count; i++) {
        if (memcmp(all + i, "\x1b[c", 3) == 0) {
            send_text(answer);
            answer[0] = '\0';
        }
    }
    answered = count > 2 ? count - 2 : 0;
}

/* Reads for so long; returns whether something came. -1: the terminal is closed. */
static int listen_for(double seconds) {
    struct pollfd p = {master, POLLIN, 0};
    if (master < 0 || poll(&p, 1, (int)(1000 * seconds)) <= 0) {
        return master < 0 ? -1 : 0;
    }
    if (room - count < 65536) {
        room = 2 * room + 65536;
        all = realloc(all, room);
    }
    const ssize_t got = all == NULL ? -1 : read(master, all + count, room - count);
    if (got <= 0) {
        return -1;
    }
    count += (size_t)got;
    answer_query();
    return 1;
}

static void settle(void) {
    const double end = now() + 20;
    size_t home = 0;
    uint64_t hash = 14695981039346656037u;
    while (now() < end && listen_for(0.7) > 0) {
    }
    for (size_t i = 0; i + 3 <= count; i++) {
        home = memcmp(all + i, "\x1b[H", 3) == 0 ? i : home;
    }
    for (size_t i = home; i < count; i++) {
        hash = (hash ^ all[i]) * 1099511628211u;
    }
    printf("picture %016llx %zu\n", (unsigned long long)hash, count - home);
}

static void resize(int file, const char *text) {
    unsigned columns = 80, rows = 24;
    sscanf(text, "%ux%u", &columns, &rows);
    const struct winsize size = {.ws_row = (unsigned short)rows, .ws_col = (unsigned short)columns};
    ioctl(file, TIOCSWINSZ, &size);
}

/* What the leader says: the job's number, then S for every time that it is stopped. */
static int from_leader = -1;
static pid_t job;

static int is_same(const struct termios *a, const struct termios *b) {
    return a->c_iflag == b->c_iflag && a->c_oflag == b->c_oflag && a->c_cflag == b->c_cflag &&
           a->c_lflag == b->c_lflag && memcmp(a->c_cc, b->c_cc, sizeof a->c_cc) == 0;
}

static int ends_with(const char *text) {
    const size_t length = strlen(text);
    return count >= length && memcmp(all + count - length, text, length) == 0;
}

static void await_stop(int slave, const struct termios *before) {
    struct pollfd p = {from_leader, POLLIN, 0};
    struct termios is;
    const double end = now() + 10;
    char said = 0;
    while (now() < end && poll(&p, 1, 0) == 0) {
        listen_for(0.02);
    }
    if (poll(&p, 1, 0) <= 0 || read(from_leader, &said, 1) != 1 || said != 'S' ||
        tcgetattr(slave, &is) != 0) {
        printf("not stopped\n");
        return;
    }
    while (listen_for(0.0) > 0) {
    }
    printf("stopped modes %s screen %s\n", is_same(&is, before) ? "same" : "changed",
           ends_with("\x1b[?25h\x1b[?1049l") ? "back" : "kept");
}

static void step(const char *text, pid_t leader) {
    const char *equals = strchr(text, '=');
    const char *value = equals == NULL ? "" : equals + 1;
    if (strcmp(text, "settle") == 0) {
        settle();
    } else if (strncmp(text, "send=", 5) == 0 || strncmp(text, "type=", 5) == 0) {
        send_text(value);
    } else if (strncmp(text, "answer=", 7) == 0) {
        snprintf(answer, sizeof answer, "%s", value);
    } else if (strncmp(text, "resize=", 7) == 0) {
        resize(master, value);
    } else if (strncmp(text, "signal=", 7) == 0) {
        kill(job, atoi(value));
    } else if (strcmp(text, "fg") == 0) {
        kill(leader, SIGUSR1);
    } else if (strncmp(text, "deaf=", 5) == 0) {
        const struct timespec t = {atoi(value) / 1000, atoi(value) % 1000 * 1000000L};
        nanosleep(&t, NULL);
    } else if (strcmp(text, "close") == 0) {
        close(master);
        master = -1;
    }
}

static int wait_for(pid_t child) {
    const double end = now() + 10;
    int status;
    while (now() < end) {
        if (waitpid(child, &status, WNOHANG) == child) {
            while (listen_for(0.0) > 0) {
            }
            return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
        }
        if (listen_for(0.02) < 0) {
            const struct timespec t = {0, 20000000};
            nanosleep(&t, NULL);
        }
    }
    kill(job, SIGKILL);
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return NOT_ENDED;
}

static void on_signal(int number) {
    (void)number;
}

static void take_terminal(pid_t group) {
    tcsetpgrp(STDIN_FILENO, group);
}

/* Never returns: as a shell, for the one job that it has. */
static void lead(pid_t number, int say) {
    const struct sigaction wakes = {.sa_handler = on_signal};
    int status;
    signal(SIGHUP, SIG_IGN);
    sigaction(SIGUSR1, &wakes, NULL);
    for (;;) {
        if (waitpid(number, &status, WUNTRACED) != number) { /* SIGUSR1 */
            take_terminal(number);
            kill(-number, SIGCONT);
        } else if (WIFSTOPPED(status)) {
            take_terminal(getpid());
            if (write(say, "S", 1) != 1) {
                _exit(127);
            }
        } else {
            _exit(WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
        }
    }
}

/* In a session of its own, whose terminal this is. */
static void become(char **command, const char *name, int say) {
    setsid();
    const int slave = open(name, O_RDWR);
    close(master);
    for (int i = 0; i < 3; i++) {
        dup2(slave, i);
    }
    close(slave);
    signal(SIGTTOU, SIG_IGN); /* to give the terminal to others from the background */
    const pid_t number = fork();
    if (number != 0) {
        setpgid(number, number);
        if (write(say, &number, sizeof number) != sizeof number) {
            _exit(127);
        }
        lead(number, say);
    }
    close(say);
    setpgid(0, 0);
    take_terminal(getpid());
    signal(SIGTTOU, SIG_DFL);
    execvp(command[0], command);
    _exit(127);
}

static void report(int slave, const struct termios *before, int status) {
    struct termios after;
    int left = -1;
    printf("status %d\n", status);
    if (master >= 0 && tcgetattr(slave, &after) == 0) {
        const int same = is_same(&after, before);
        after.c_lflag &= ~(tcflag_t)ICANON; /* else bytes of an unfinished line are not counted */
        tcsetattr(slave, TCSANOW, &after);
        ioctl(slave, FIONREAD, &left);
        printf("modes %s\nleft %d\n", same ? "same" : "changed", left);
    }
    FILE *screen = fopen("screen", "wb");
    if (screen != NULL) {
        fwrite(all, 1, count, screen);
        fclose(screen);
    }
}

int main(int argc, char **argv) {
    struct termios before;
    int i = 1;
    master = posix_openpt(O_RDWR | O_NOCTTY);
    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) {
        return NO_TERMINAL;
    }
    const char *name = ptsname(master);
    const int slave = name == NULL ? -1 : open(name, O_RDWR | O_NOCTTY);
    if (slave < 0 || tcgetattr(slave, &before) != 0) {
        return NO_TERMINAL;
    }
    resize(slave, "80x24");
    while (i < argc && strcmp(argv[i], "--") != 0) {
        i++;
    }
    if (i + 1 >= argc) {
        return NO_TERMINAL;
    }
    int says[2];
    if (pipe(says) != 0) {
        return NO_TERMINAL;
    }
    const pid_t child = fork();
    if (child == 0) {
        close(slave);
        close(says[0]);
        become(argv + i + 1, name, says[1]);
    }
    close(says[1]);
    from_leader = says[0];
    if (read(from_leader, &job, sizeof job) != sizeof job) {
        return NO_TERMINAL;
    }
    for (int k = 1; k < i; k++) {
        if (strcmp(argv[k], "close") == 0) {
            close(slave);
        }
        if (strcmp(argv[k], "stopped") == 0) {
            await_stop(slave, &before);
        } else {
            step(argv[k], child);
        }
        fflush(stdout);
    }
    report(slave, &before, wait_for(child));
    return 0;
}
