/* files - see files.h
 *
 * What was read, and what was written, are in tables with open addressing that are at most half
 * full; what is being written in a list, as that is two files or three.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/files.h"

#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FIRST_ROOM = 64, NAME_SHOWN = 200 };

typedef struct file_known {
    dev_t device;
    ino_t inode;
    char *name; /* owned; NULL: a free entry */
} file_known;

typedef struct file_table {
    file_known *entry;
    size_t room, used; /* room: a power of 2, or 0 */
} file_table;

static file_table inputs, finished;

static struct stat errors; /* standard error, where it is a regular file or a pipe */
static int has_errors;

static file_written *outputs;

/* The end of a name: the message must still fit on its line. */
static const char *shown(const char *name) {
    const size_t length = strlen(name);
    return length > NAME_SHOWN ? name + length - NAME_SHOWN : name;
}

static const char *kind_of(const struct stat *file) {
    return S_ISREG(file->st_mode) ? "file" : "pipe";
}

/* What only one output may write. */
static int is_exclusive(const struct stat *file) {
    return S_ISREG(file->st_mode) || S_ISFIFO(file->st_mode) || S_ISSOCK(file->st_mode);
}

static int fail_same(const char *name, const char *what, const char *kind, const char *other,
                     fail *f) {
    return fail_set(f, name, "is the same %s as the %s %s; write to another one", what, kind,
                    shown(other));
}

static int is_same(const struct stat *a, const struct stat *b) {
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* ---- what was read, and what was written ---------------------------------------------- */

/* The entry of this file, or the free one where it belongs. */
static file_known *find(file_known *from, size_t room, const struct stat *file) {
    const uint64_t bits = (uint64_t)file->st_ino ^ (uint64_t)file->st_dev << 32;
    const uint64_t key = bits * UINT64_C(0x9E3779B97F4A7C15);
    for (size_t i = (size_t)(key >> 32);; i++) {
        file_known *e = &from[i & (room - 1)];
        if (e->name == NULL || (e->device == file->st_dev && e->inode == file->st_ino)) {
            return e;
        }
    }
}

/* Its name; NULL: it is not there. */
static const char *name_in(const file_table *t, const struct stat *file) {
    return t->room > 0 ? find(t->entry, t->room, file)->name : NULL;
}

static int make_room(file_table *t) {
    if (2 * (t->used + 1) <= t->room) {
        return 0;
    }
    const size_t room = t->room > 0 ? 2 * t->room : FIRST_ROOM;
    file_known *entry = calloc(room, sizeof *entry);
    if (entry == NULL) {
        return -1;
    }
    for (size_t i = 0; i < t->room; i++) {
        const file_known *e = &t->entry[i];
        if (e->name != NULL) {
            const struct stat file = {.st_dev = e->device, .st_ino = e->inode};
            *find(entry, room, &file) = *e;
        }
    }
    free(t->entry);
    t->entry = entry;
    t->room = room;
    return 0;
}

static int remember(file_table *t, const struct stat *file, const char *name) {
    if (make_room(t) != 0) {
        return -1;
    }
    file_known *e = find(t->entry, t->room, file);
    if (e->name == NULL) {
        *e = (file_known){file->st_dev, file->st_ino, strdup(name)};
        t->used += e->name != NULL;
    }
    return e->name != NULL ? 0 : -1;
}

/* ---- standard error ------------------------------------------------------------------ */

void files_open(void) {
    has_errors = fstat(STDERR_FILENO, &errors) == 0 && is_exclusive(&errors);
}

static int is_errors(const struct stat *file) {
    return has_errors && is_same(file, &errors);
}

static int fail_errors(const char *name, fail *f) {
    return fail_set(f, name, "is the %s that standard error goes to; redirect that to another",
                    kind_of(&errors));
}

/* The sentence about an input that standard error would be appended to, and all after it, must
 * not be. It goes to standard output, on which nothing is before the inputs are read, unless
 * that is the same file. */
static void spare_input(void) {
    struct stat out;
    const int fd = fstat(STDOUT_FILENO, &out) == 0 && !is_errors(&out)
                       ? STDOUT_FILENO
                       : open("/dev/null", O_WRONLY | O_CLOEXEC);
    fflush(stderr);
    dup2(fd, STDERR_FILENO);
}

int files_read(int fd, const char *name, fail *f) {
    struct stat about;
    if (fstat(fd, &about) != 0 || !S_ISREG(about.st_mode)) {
        return 0;
    }
    if (is_errors(&about)) {
        spare_input();
        return fail_errors(name, f);
    }
    for (const file_written *w = outputs; w != NULL; w = w->next) {
        if (w->exists && is_same(&w->file, &about)) {
            return fail_same(name, "file", "output", w->name, f);
        }
    }
    return remember(&inputs, &about, name) == 0
               ? 0
               : fail_set(f, name, "out of memory; close other programs");
}

/* ---- what is being written ---------------------------------------------------------- */

/* Where a file of this path is, or would be. */
static void look_at_folder(file_written *w, const char *target) {
    const char *slash = strrchr(target, '/');
    const size_t length = slash != NULL ? (size_t)(slash - target) + 1 : 0;
    char *folder = malloc(length + 2);
    if (folder == NULL) {
        return;
    }
    memcpy(folder, target, length);
    memcpy(folder + length, ".", 2);
    w->last = stat(folder, &w->folder) == 0 ? target + length : NULL;
    free(folder);
}

static int collide(const file_written *a, const file_written *b) {
    return (a->exists && b->exists && is_same(&a->file, &b->file)) ||
           (a->last != NULL && b->last != NULL && strcmp(a->last, b->last) == 0 &&
            is_same(&a->folder, &b->folder));
}

static int check(const file_written *w, fail *f) {
    const char *input = w->exists ? name_in(&inputs, &w->file) : NULL;
    const char *output = w->exists ? name_in(&finished, &w->file) : NULL;
    if (input != NULL) {
        return fail_same(w->name, "file", "input", input, f);
    }
    for (const file_written *other = outputs; other != NULL; other = other->next) {
        if (collide(w, other)) {
            return fail_same(w->name, w->exists ? kind_of(&w->file) : "file", "output", other->name,
                             f);
        }
    }
    if (output != NULL && strcmp(output, w->name) != 0) { /* the same name: it is meant */
        return fail_same(w->name, "file", "output", output, f);
    }
    return 0;
}

int files_write(file_written *w, const char *target, int fd, int is_text, fail *f) {
    w->exists = (target != NULL ? stat(target, &w->file) : fstat(fd, &w->file)) == 0;
    if (w->exists && !is_exclusive(&w->file)) {
        return 0;
    }
    if (w->exists && is_errors(&w->file) &&
        (!is_text || (target != NULL && S_ISREG(w->file.st_mode)))) {
        return fail_errors(w->name, f);
    }
    if (target != NULL) {
        look_at_folder(w, target);
    }
    if (check(w, f) != 0) {
        return -1;
    }
    w->next = outputs;
    outputs = w;
    return 0;
}

void files_written(file_written *w) {
    for (file_written **link = &outputs; *link != NULL; link = &(*link)->next) {
        if (*link == w) {
            *link = w->next;
            return;
        }
    }
}

/* Without memory for its name it is not known: the output itself is whole. */
void files_finished(file_written *w, const char *target) {
    struct stat about;
    files_written(w);
    if (stat(target, &about) == 0 && S_ISREG(about.st_mode)) {
        remember(&finished, &about, w->name);
    }
}

int files_is_file(const char *path) {
    struct stat about;
    return stat(path, &about) == 0 && S_ISREG(about.st_mode);
}

int files_is_directory(const char *path) {
    struct stat about;
    return stat(path, &about) == 0 && S_ISDIR(about.st_mode);
}
