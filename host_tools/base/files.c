/* files - see files.h
 *
 * What was read is in a table with open addressing that is at most half full; what is
 * being written in a list, as that is two files or three.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/files.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST_ROOM = 64, NAME_SHOWN = 200 };

typedef struct file_read {
    dev_t device;
    ino_t inode;
    char *name; /* owned; NULL: a free entry */
} file_read;

static struct {
    file_read *entry;
    size_t room, used; /* room: a power of 2, or 0 */
} inputs;

static file_written *outputs;

/* The end of a name: the message must still fit on its line. */
static const char *shown(const char *name) {
    const size_t length = strlen(name);
    return length > NAME_SHOWN ? name + length - NAME_SHOWN : name;
}

static int is_same(const struct stat *a, const struct stat *b) {
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* ---- what was read ------------------------------------------------------------------ */

/* The entry of this file, or the free one where it belongs. */
static file_read *find(const file_read *from, size_t room, dev_t device, ino_t inode) {
    const uint64_t key = ((uint64_t)inode ^ (uint64_t)device << 32) * UINT64_C(0x9E3779B97F4A7C15);
    for (size_t i = (size_t)(key >> 32);; i++) {
        const file_read *e = &from[i & (room - 1)];
        if (e->name == NULL || (e->device == device && e->inode == inode)) {
            return (file_read *)(uintptr_t)e;
        }
    }
}

static int make_room(void) {
    if (2 * (inputs.used + 1) <= inputs.room) {
        return 0;
    }
    const size_t room = inputs.room > 0 ? 2 * inputs.room : FIRST_ROOM;
    file_read *entry = calloc(room, sizeof *entry);
    if (entry == NULL) {
        return -1;
    }
    for (size_t i = 0; i < inputs.room; i++) {
        const file_read *e = &inputs.entry[i];
        if (e->name != NULL) {
            *find(entry, room, e->device, e->inode) = *e;
        }
    }
    free(inputs.entry);
    inputs.entry = entry;
    inputs.room = room;
    return 0;
}

static int remember(const struct stat *about, const char *name) {
    if (make_room() != 0) {
        return -1;
    }
    file_read *e = find(inputs.entry, inputs.room, about->st_dev, about->st_ino);
    if (e->name == NULL) {
        *e = (file_read){about->st_dev, about->st_ino, strdup(name)};
        inputs.used += e->name != NULL;
    }
    return e->name != NULL ? 0 : -1;
}

int files_read(int fd, const char *name, fail *f) {
    struct stat about;
    if (fstat(fd, &about) != 0 || !S_ISREG(about.st_mode)) {
        return 0;
    }
    for (const file_written *w = outputs; w != NULL; w = w->next) {
        if (w->exists && is_same(&w->file, &about)) {
            return fail_set(f, name, "is the same file as the output %s; write to another one",
                            shown(w->name));
        }
    }
    return remember(&about, name) == 0 ? 0
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
    if (w->exists && inputs.room > 0) {
        const file_read *e = find(inputs.entry, inputs.room, w->file.st_dev, w->file.st_ino);
        if (e->name != NULL) {
            return fail_set(f, w->name, "is the same file as the input %s; write to another one",
                            shown(e->name));
        }
    }
    for (const file_written *other = outputs; other != NULL; other = other->next) {
        if (collide(w, other)) {
            return fail_set(f, w->name, "is the same file as the output %s; write to another one",
                            shown(other->name));
        }
    }
    return 0;
}

int files_write(file_written *w, const char *target, int fd, fail *f) {
    w->exists = (target != NULL ? stat(target, &w->file) : fstat(fd, &w->file)) == 0;
    if (w->exists && !S_ISREG(w->file.st_mode)) {
        return 0;
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
