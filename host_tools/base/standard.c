/* standard - see standard.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/standard.h"

#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

/* Opened the wrong way round: reading standard input fails, and so does writing the others. */
int standard_open(void) {
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
        if (fcntl(fd, F_GETFD) == -1 && errno == EBADF &&
            open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) != fd) {
            return -1;
        }
    }
    return 0;
}

static int is_open_but_for(int fd, int wrong) {
    const int flags = fcntl(fd, F_GETFL);
    if (flags != -1 && (flags & O_ACCMODE) == wrong) {
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
