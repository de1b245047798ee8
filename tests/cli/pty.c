/* pty - runs a command whose standard error, or both outputs, are a terminal
 *
 * pty err|both COMMAND ARGUMENT...: what the command writes to the terminal
 * (80 x 24) comes out on standard output, line feeds as the terminal makes
 * them (CR LF); with `err` its own standard output goes to standard error.
 * Ends with the command's status, 128 + n when signal n ended it, or 125 when
 * there is no terminal to be had.
 *
 * SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

enum { NO_TERMINAL = 125, NO_COMMAND = 127 };

static int open_master(void) {
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    return master >= 0 && grantpt(master) == 0 && unlockpt(master) == 0 ? master : -1;
}

static int open_slave(int master) {
    const char *name = ptsname(master);
    const int slave = name == NULL ? -1 : open(name, O_RDWR | O_NOCTTY);
#ifdef TIOCSWINSZ
    const struct winsize size = {.ws_row = 24, .ws_col = 80};
    if (slave >= 0) {
        ioctl(slave, TIOCSWINSZ, &size);
    }
#endif
    return slave;
}

static void become(char **command, int slave, int both) {
    dup2(both ? slave : STDERR_FILENO, STDOUT_FILENO);
    dup2(slave, STDERR_FILENO);
    close(slave);
    execvp(command[0], command);
    _exit(NO_COMMAND);
}

/* Until the last writer has closed the terminal; Linux then says EIO. */
static void copy(int master) {
    char bytes[4096];
    ssize_t got;
    while ((got = read(master, bytes, sizeof bytes)) > 0) {
        fwrite(bytes, 1, (size_t)got, stdout);
    }
    fflush(stdout);
}

int main(int argc, char **argv) {
    const int master = open_master();
    const int slave = master < 0 || argc < 3 ? -1 : open_slave(master);
    if (slave < 0) {
        return NO_TERMINAL;
    }
    const pid_t child = fork();
    if (child == 0) {
        close(master);
        become(argv + 2, slave, strcmp(argv[1], "both") == 0);
    }
    close(slave);
    copy(master);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) < 0) {
        return NO_TERMINAL;
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}
