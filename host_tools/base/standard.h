/* standard - standard input, output and error, which a program may be started without
 *
 * A file that is opened gets the lowest number that is free: without standard error the
 * next message would land in a picture.
 *
 * SPDX-License-Identifier: MIT */
#ifndef STANDARD_H
#define STANDARD_H
#include <sys/stat.h>

/* Before anything else is opened: a stream that is closed becomes one on which nothing can be
 * read or written, and fails with EBADF as if it were closed. -1: that is not possible here. */
int standard_open(void);

/* Whether what a name such as /dev/stdout leads to is what stands for a closed stream. */
int standard_was_closed(const struct stat *file);

/* Whether an open file can be read, or written; else errno is EBADF. */
int standard_can_read(int fd);
int standard_can_write(int fd);

#endif
