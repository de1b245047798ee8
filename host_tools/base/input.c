/* input - a whole file in memory, with the errors a person can act on
 *
 * Keeps: memory grows with the bytes that were read or, for a regular
 * file, with its size, and never past what the machine has.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/input.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host_tools/base/files.h"
#include "host_tools/base/heap.h"
#include "host_tools/base/standard.h"

/* A stream may never end: it gets this many bytes at most. */
static const uint64_t STREAM_BYTES_MAX = (uint64_t)1 << 32;
enum { FIRST_ROOM = 65536 };

static const char *shown(const char *path) {
    return strcmp(path, "-") == 0 ? "standard input" : path;
}

static uint64_t memory_bytes(void) {
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
    const uint64_t most = SIZE_MAX / 2;
    if (pages <= 0 || page <= 0 || (uint64_t)pages > most / (uint64_t)page) {
        return most;
    }
    return (uint64_t)pages * (uint64_t)page;
}

static int fail_memory(const input *in, uint64_t bytes, fail *f) {
    if (bytes == STREAM_BYTES_MAX) {
        return fail_set(f, shown(in->path),
                        "more than %llu bytes, the most that is read of a stream; name the file",
                        (unsigned long long)bytes);
    }
    return fail_set(f, shown(in->path),
                    "%llu bytes do not fit into memory; split the file or use a larger machine",
                    (unsigned long long)bytes);
}

static int fail_open(const char *path, int error, fail *f) {
    const char *remedy = "check the path";
    if (error == ENOENT || error == ENOTDIR) {
        remedy = "check the spelling and the directory you are in";
    } else if (error == EACCES || error == EPERM) {
        remedy = "make it readable with chmod +r, or run as its owner";
    } else if (error == EBADF) {
        remedy = "the stream is closed: redirect a file to it";
    } else if (error == EMFILE || error == ENFILE) {
        remedy = "too many files are open: raise the limit with ulimit -n";
    }
    return fail_set(f, shown(path), "cannot open: %s; %s", strerror(error), remedy);
}

/* The file counts as memory of the program, which may be limited. */
static int count(input *in, size_t bytes) {
    if (heap_count(bytes - in->counted) != 0) {
        return -1;
    }
    in->counted = bytes;
    return 0;
}

static int grow(input *in, size_t *room, uint64_t limit, fail *f) {
    if (*room >= limit) {
        return fail_memory(in, *room, f);
    }
    const size_t more = *room > limit / 2 ? (size_t)limit : *room * 2;
    unsigned char *bytes = count(in, more + 1) == 0 ? realloc(in->bytes, more + 1) : NULL;
    if (!bytes) {
        return fail_memory(in, more, f);
    }
    in->bytes = bytes;
    *room = more;
    return 0;
}

/* Reads to the end; the end is known only by a read that returns 0. */
static int read_all(input *in, int fd, size_t room, uint64_t limit, fail *f) {
    for (;;) {
        unsigned char probe;
        const int full = in->size == room;
        void *into = full ? &probe : in->bytes + in->size;
        const ssize_t got = read(fd, into, full ? 1 : room - in->size);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got < 0) {
            return fail_set(f, shown(in->path), "cannot read at byte %zu: %s; check the disk",
                            in->size, strerror(errno));
        }
        if (got == 0) {
            return 0;
        }
        if (full) {
            if (grow(in, &room, limit, f) != 0) {
                return -1;
            }
            in->bytes[in->size] = probe;
        }
        in->size += (size_t)got;
    }
}

static int read_open(input *in, int fd, int is_stream, fail *f) {
    struct stat about;
    if (!standard_can_read(fd) || fstat(fd, &about) != 0) {
        return fail_open(in->path, errno, f);
    }
    if (S_ISDIR(about.st_mode)) {
        return fail_set(f, shown(in->path), "is a directory; name a file in it");
    }
    if (!is_stream && (S_ISCHR(about.st_mode) || S_ISBLK(about.st_mode))) {
        return fail_set(f, shown(in->path), "is a device; name a file, or - for standard input");
    }
    if (files_read(fd, shown(in->path), f) != 0) {
        return -1;
    }
    uint64_t limit = memory_bytes();
    size_t room = FIRST_ROOM;
    if (S_ISREG(about.st_mode) && about.st_size > 0) {
        if ((uint64_t)about.st_size >= limit) {
            return fail_memory(in, (uint64_t)about.st_size, f);
        }
        room = (size_t)about.st_size;
    } else {
        limit = limit / 2 < STREAM_BYTES_MAX ? limit / 2 : STREAM_BYTES_MAX;
    }
    in->bytes = count(in, room + 1) == 0 ? malloc(room + 1) : NULL;
    if (!in->bytes) {
        return fail_memory(in, room, f);
    }
    if (read_all(in, fd, room, limit, f) != 0) {
        return -1;
    }
    if (in->size == 0) {
        return fail_set(f, shown(in->path), "is empty; write the file again");
    }
    in->bytes[in->size] = 0;
    return 0;
}

int input_claim(const char *path, fail *f) {
    if (path[0] == '\0' || strcmp(path, "-") == 0) {
        return 0; /* input_read has a word to say, or standard input is known */
    }
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0) {
        return fail_open(path, errno, f);
    }
    const int status = files_read(fd, path, f);
    close(fd);
    return status;
}

int input_read(input *in, const char *path, fail *f) {
    *in = (input){.path = path};
    if (path[0] == '\0') {
        return fail_set(f, NULL, "the input has no name; give one, or - for standard input");
    }
    const int is_stream = strcmp(path, "-") == 0;
    const int fd = is_stream ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0) {
        return fail_open(path, errno, f);
    }
    const int result = read_open(in, fd, is_stream, f);
    if (!is_stream) {
        close(fd);
    }
    if (result != 0) {
        input_free(in);
    }
    return result;
}

void input_free(input *in) {
    free(in->bytes);
    heap_uncount(in->counted);
    in->bytes = NULL;
    in->size = in->counted = 0;
}
