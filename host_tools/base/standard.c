/* standard - see standard.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/standard.h"

#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

static int was_closed[3]; /* by number */

/* A folder: it can neither be read nor written, nor opened to be written under a name. */
static int open_in_place(int fd) {
    const int there = open("/", O_RDONLY);
    return there == fd || (there == -1 && open("/dev/null", O_RDONLY) == fd) ? 0 : -1;
}

int standard_open(void) {
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
        was_closed[fd] = fcntl(fd, F_GETFD) == -1 && errno == EBADF;
        if (was_closed[fd] && open_in_place(fd) != 0) {
            return -1;
        }
    }
    return 0;
}

int standard_was_closed(const struct stat *file) {
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
        struct stat about;
        if (was_closed[fd] && fstat(fd, &about) == 0 && about.st_dev == file->st_dev &&
            about.st_ino == file->st_ino) {
            return 1;
        }
    }
    return 0;
}

static int is_open_but_for(int fd, int wrong) {
    const int flags = fcntl(fd, F_GETFL);
    const int is_closed = fd >= STDIN_FILENO && fd <= STDERR_FILENO && was_closed[fd];
    if (is_closed || (flags != -1 && (flags & O_ACCMODE) == wrong)) {
        errno = EBADF;
        return 0;
    }
    return flags != -1;
}

int standard_can_read(int fd) {
    return is_open_but_for(fd, O_WRONLY);
}

int standard_can_write(int fd) {
    return is_open_but_for(fd, O_RDONLY);
}
