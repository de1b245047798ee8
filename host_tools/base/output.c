/* output - a file that appears whole or not at all
 *
 * Keeps: bytes reach the target's own name only by the rename of a commit
 * without any error before it, or directly when the target is no regular
 * file. After a failed write every further call fails.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/output.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host_tools/base/files.h"
#include "host_tools/base/standard.h"
#include "host_tools/base/target.h"
#include "host_tools/base/temporary.h"

static file_written printed; /* standard output, once text is printed to it */

struct output {
    temporary beside; /* without a file: written directly */
    file_written as;
    char *name;     /* as asked for: what failures name */
    char *target;   /* what is renamed over: links followed */
    int fd, failed; /* -1: closed; `failed`: errno of the first failed write */
    int is_finished;
    size_t used;
    unsigned char buffer[65536];
};

static const char *remedy(int error) {
    switch (error) {
    case ENOSPC:
        return "free some space or write to another disk";
    case EDQUOT:
        return "your quota is used up: remove files or write to another disk";
    case EFBIG:
        return "the file size limit is reached: raise it with ulimit -f";
    case ENOENT:
    case ENOTDIR:
        return "create the directory first, or correct the path";
    case EACCES:
    case EPERM:
        return "write to a directory you own, or change its permissions";
    case EROFS:
        return "the disk is read-only: write to another one";
    case ENAMETOOLONG:
        return "choose a shorter name";
    case EMFILE:
    case ENFILE:
        return "too many files are open: raise the limit with ulimit -n";
    case EPIPE:
        return "the reader went away: keep it running";
    case EBADF:
        return "the stream is closed: redirect it to a file";
    default:
        return "check the path and the disk";
    }
}

static const char *shown(const char *name) {
    return strcmp(name, "-") == 0 ? "standard output" : name;
}

static int fail_system(fail *f, const char *name, const char *action, int error) {
    return fail_set(f, shown(name), "cannot %s: %s; %s", action, strerror(error), remedy(error));
}

static void output_free(output *o) {
    files_written(&o->as);
    free(o->name);
    free(o->target);
    free(o);
}

static int open_beside(output *o, const struct stat *existing, fail *f) {
    if (files_write(&o->as, o->target, -1, 0, f) != 0) {
        return -1;
    }
    o->fd = temporary_create(&o->beside, o->target);
    if (o->fd < 0 && strcmp(o->name, o->target) != 0) {
        return fail_set(f, o->name, "is a link to %s: cannot create a file there: %s; %s",
                        o->target, strerror(errno), remedy(errno));
    }
    if (o->fd < 0) {
        return fail_system(f, o->name, "create a file there", errno);
    }
    if (existing) {
        (void)fchmod(o->fd, existing->st_mode & 0777);
    }
    return 0;
}

static int is_device_of(int fd, const struct stat *device) {
    struct stat about;
    return isatty(fd) && fstat(fd, &about) == 0 && about.st_rdev == device->st_rdev;
}

/* The terminal that somebody sits at, under whatever name. */
static int is_own_terminal(const struct stat *device) {
    struct stat own;
    return S_ISCHR(device->st_mode) &&
           (is_device_of(STDIN_FILENO, device) || is_device_of(STDOUT_FILENO, device) ||
            is_device_of(STDERR_FILENO, device) ||
            (stat("/dev/tty", &own) == 0 && own.st_rdev == device->st_rdev));
}

/* Another device that a name says is written as asked for, also if it is a terminal: a serial
 * line is one. */
static int open_direct(output *o, const struct stat *existing, int is_text, fail *f) {
    if (!is_text && is_own_terminal(existing)) {
        return fail_set(f, o->name,
                        "is your terminal, on which these bytes are no text; name a file");
    }
    if (files_write(&o->as, o->name, -1, is_text, f) != 0) {
        return -1;
    }
    o->fd = open(o->name, O_WRONLY | O_CLOEXEC);
    return o->fd >= 0 ? 0 : fail_system(f, o->name, "open it for writing", errno);
}

static int open_standard(output *o, int is_text, fail *f) {
    fflush(stdout);
    if (!standard_can_write(STDOUT_FILENO)) {
        return fail_system(f, o->name, "write", errno);
    }
    if (!is_text && isatty(STDOUT_FILENO)) {
        return fail_set(f, shown(o->name),
                        "is a terminal, on which these bytes are no text; name a file, or redirect "
                        "it to a file or a program");
    }
    if (is_text) { /* it follows what is printed */
        files_written(&printed);
    }
    if (files_write(&o->as, NULL, STDOUT_FILENO, is_text, f) != 0) {
        return -1;
    }
    o->fd = dup(STDOUT_FILENO);
    return o->fd >= 0 ? 0 : fail_system(f, o->name, "write", errno);
}

/* Of a file that was deleted while a stream had it open, /dev/stdout still is a link to it. */
static int has_name(const output *o, const struct stat *existing) {
    struct stat target;
    return stat(o->target, &target) == 0 && target.st_dev == existing->st_dev &&
           target.st_ino == existing->st_ino;
}

static int open_existing(output *o, const struct stat *existing, int is_text, fail *f) {
    if (standard_was_closed(existing)) {
        return fail_system(f, o->name, "write", EBADF);
    }
    if (S_ISDIR(existing->st_mode)) {
        return fail_set(f, o->name, "is a directory; name a file in it");
    }
    if (!S_ISREG(existing->st_mode)) {
        return open_direct(o, existing, is_text, f);
    }
    if (access(o->name, W_OK) != 0) {
        return fail_set(f, o->name, "is write-protected; choose another name or chmod u+w it");
    }
    if (!has_name(o, existing)) {
        return fail_set(f, o->name,
                        "is a file without a name; name another one, or - for standard "
                        "output");
    }
    return open_beside(o, existing, f);
}

/* A symbolic link stays: what it leads to is replaced, or made. */
static int open_target(output *o, int is_text, fail *f) {
    struct stat existing;
    const int exists = stat(o->name, &existing) == 0;
    if (!exists && errno != ENOENT) {
        return fail_system(f, o->name, "open it", errno);
    }
    o->target = target_of(o->name);
    if (!o->target) {
        return fail_system(f, o->name, "open it", errno);
    }
    if (exists) {
        return open_existing(o, &existing, is_text, f);
    }
    if (o->target[strlen(o->target) - 1] == '/') {
        return fail_set(f, o->name, "there is no such directory; create it and name a file in it");
    }
    return open_beside(o, NULL, f);
}

static int open_path(output *o, int is_text, fail *f) {
    if (o->name[0] == '\0') {
        return fail_set(f, NULL, "the output has no name; give one, or - for standard output");
    }
    return strcmp(o->name, "-") == 0 ? open_standard(o, is_text, f) : open_target(o, is_text, f);
}

/* SIGXFSZ is ignored so that a write past the file size limit returns
 * EFBIG, which can be explained. */
static output *open_any(const char *path, int is_text, fail *f) {
    signal(SIGXFSZ, SIG_IGN);
    output *o = malloc(sizeof *o);
    if (!o) {
        fail_system(f, path, "open it", ENOMEM);
        return NULL;
    }
    o->beside = (temporary){0};
    o->as = (file_written){0};
    o->target = NULL;
    o->fd = -1;
    o->failed = 0;
    o->is_finished = 0;
    o->used = 0;
    o->name = strdup(path);
    if (!o->name) {
        fail_system(f, path, "open it", ENOMEM);
    } else {
        o->as.name = shown(o->name);
        if (open_path(o, is_text, f) == 0) {
            return o;
        }
    }
    output_free(o);
    return NULL;
}

output *output_open(const char *path, fail *f) {
    return open_any(path, 0, f);
}

output *output_open_text(const char *path, fail *f) {
    return open_any(path, 1, f);
}

int output_print_standard(fail *f) {
    printed.name = shown("-");
    if (!standard_can_write(STDOUT_FILENO)) {
        return fail_system(f, "-", "write", errno);
    }
    files_written(&printed);
    return files_write(&printed, NULL, STDOUT_FILENO, 1, f);
}

static int write_all(output *o, const unsigned char *bytes, size_t count, fail *f) {
    while (count > 0) {
        const ssize_t done = write(o->fd, bytes, count);
        if (done < 0 && errno == EINTR) {
            continue;
        }
        if (done < 0) {
            o->failed = errno;
            return fail_system(f, o->name, "write", o->failed);
        }
        bytes += done;
        count -= (size_t)done;
    }
    return 0;
}

static int flush(output *o, fail *f) {
    const size_t count = o->used;
    o->used = 0;
    return write_all(o, o->buffer, count, f);
}

int output_write(output *o, const void *bytes, size_t count, fail *f) {
    if (o->failed) {
        return fail_system(f, o->name, "write", o->failed);
    }
    if (count > sizeof o->buffer - o->used && flush(o, f) != 0) {
        return -1;
    }
    if (count > sizeof o->buffer) {
        return write_all(o, bytes, count, f);
    }
    memcpy(o->buffer + o->used, bytes, count);
    o->used += count;
    return 0;
}

/* `length` as vsnprintf gave it: negative for more than INT_MAX bytes. */
static int print_long(output *o, int length, const char *format, va_list arguments, fail *f) {
    const size_t room = length < 0 ? 0 : (size_t)length + 1;
    char *text = room ? malloc(room) : NULL;
    if (!text) {
        o->failed = ENOMEM;
        return fail_system(f, o->name, "write", ENOMEM);
    }
    vsnprintf(text, room, format, arguments);
    const int written = output_write(o, text, room - 1, f);
    free(text);
    return written;
}

int output_print(output *o, fail *f, const char *format, ...) {
    char text[1024];
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int length = vsnprintf(text, sizeof text, format, arguments);
    const int fits = length >= 0 && (size_t)length < sizeof text;
    const int written =
        fits ? output_write(o, text, (size_t)length, f) : print_long(o, length, format, again, f);
    va_end(again);
    va_end(arguments);
    return written;
}

int output_finish(output *o, fail *f) {
    if (o->is_finished) {
        return 0;
    }
    if (o->failed || flush(o, f) != 0) {
        return fail_system(f, o->name, "write", o->failed);
    }
    const int status = close(o->fd);
    o->fd = -1;
    if (status != 0 && errno != EINTR) {
        o->failed = errno;
        return fail_system(f, o->name, "finish writing", errno);
    }
    o->is_finished = 1;
    return 0;
}

int output_commit(output *o, fail *f) {
    if (output_finish(o, f) != 0) {
        output_abandon(o);
        return -1;
    }
    const int is_beside = o->beside.path != NULL;
    const int error = temporary_keep(&o->beside, o->target);
    if (error) {
        fail_system(f, o->name, "give the finished file this name", error);
    } else if (is_beside) {
        files_finished(&o->as, o->target);
    }
    output_free(o);
    return error ? -1 : 0;
}

void output_abandon(output *o) {
    if (!o) {
        return;
    }
    if (o->fd >= 0) {
        close(o->fd);
    }
    temporary_remove(&o->beside);
    output_free(o);
}
