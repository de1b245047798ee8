/* files - what the program reads and writes: no file is both, and none is written twice
 *
 * Standard error is an output from the beginning. What an output has become keeps being one
 * after its end: no later output of another name replaces it.
 *
 * A file is known by its device and inode, not by its name: links and other spellings of
 * a name are found out. An output that does not exist yet is known by its directory and its
 * last name. Devices and terminals may be shared; a pipe is for one output, and for messages only
 * where that is text.
 *
 * SPDX-License-Identifier: MIT */
#ifndef FILES_H
#define FILES_H
#include <sys/stat.h>

#include "host_tools/base/fail.h"

/* An output that is being written. Caller's memory, at one address from files_write to
 * files_written. */
typedef struct file_written {
    struct file_written *next;
    const char *name; /* not owned */
    struct stat file; /* if it exists */
    struct stat folder;
    const char *last; /* its name in the folder, not owned; NULL: only the file is known */
    int exists;
} file_written;

/* What is no file (a pipe that nobody writes to) could be waited for without end. */
int files_is_file(const char *path);
/* A name that is a folder's. */
int files_is_directory(const char *path);

/* Before anything else: where standard error is a regular file, that is no input and no
 * output; where it is a pipe, no output but text. */
void files_open(void);

/* An open file is read, from now on to the end of the program. -1: it is being written, or
 * memory is out. */
int files_read(int fd, const char *name, fail *f);

/* `w` holds a name and nothing else; `target` is the path that is written, links followed,
 * or NULL: the open file `fd`. -1: it was read, was written, or is being written already. Text
 * on an open file or a pipe may be where standard error is: so it is at terminals. */
int files_write(file_written *w, const char *target, int fd, int is_text, fail *f);
void files_written(file_written *w); /* the end of it; more than once does no harm */
/* The same, when `target` holds it. */
void files_finished(file_written *w, const char *target);

#endif
