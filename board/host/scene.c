/* scene - scene images in files or memory of the host, mapped or fetched
 *
 * SPDX-License-Identifier: MIT */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "board/host/host.h"

static int fail_with(host_scene *scene, const char *what, const char *remedy) {
    snprintf(scene->why, sizeof scene->why, "%s; %s", what, remedy);
    host_scene_close(scene);
    return -1;
}

static int check_kind(host_scene *scene, const struct stat *status) {
    if (S_ISDIR(status->st_mode)) {
        return fail_with(scene, "is a directory", "name the .plt file itself");
    }
    if (!S_ISREG(status->st_mode)) {
        return fail_with(scene, "is not a regular file", "store the scene in a file first");
    }
    if (status->st_size == 0) {
        return fail_with(scene, "is empty", "pack the scene again");
    }
    if ((uint64_t)status->st_size > UINT32_MAX) {
        return fail_with(scene, "is 4 GiB or larger", "a scene image is smaller; is it one?");
    }
    return 0;
}

/* O_NONBLOCK: a named pipe must be refused, not waited for. */
static int open_scene(host_scene *scene, const char *path) {
    struct stat status;
    memset(scene, 0, sizeof *scene);
    scene->file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (scene->file < 0 || fstat(scene->file, &status) < 0) {
        return fail_with(scene, strerror(errno), "check its name and permissions");
    }
    if (check_kind(scene, &status) < 0) {
        return -1;
    }
    scene->source.bytes = (uint32_t)status.st_size;
    return 0;
}

int host_scene_map(host_scene *scene, const char *path) {
    if (open_scene(scene, path) < 0) {
        return -1;
    }
    void *map = mmap(NULL, scene->source.bytes, PROT_READ, MAP_PRIVATE, scene->file, 0);
    if (map == MAP_FAILED) {
        const int error = errno;
        return fail_with(
            scene, strerror(error),
            error == ENOMEM
                ? "no room for it; raise the limit with ulimit -v, or close other programs"
                : "the file system cannot map it; use --source read");
    }
    scene->source.mapped = map;
    return 0;
}

static int scene_start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    host_scene *scene = context;
    for (int i = 0; i < HOST_TRANSFERS; i++) {
        host_transfer *t = &scene->pending[i];
        if (t->tag_bit == 0) {
            *t = (host_transfer){UINT32_C(1) << (tag & 31), offset, count, to};
            return 0;
        }
    }
    return -1;
}

static int move_in_memory(const host_scene *scene, const host_transfer *t) {
    if ((uint64_t)t->offset + t->count > scene->source.bytes) {
        return -1;
    }
    memcpy(t->to, (const char *)scene->memory + t->offset, t->count);
    return 0;
}

static int move_from_file(const host_scene *scene, const host_transfer *t) {
    uint32_t moved = 0;
    while (moved < t->count) {
        const ssize_t n = pread(scene->file, (char *)t->to + moved, t->count - moved,
                                (off_t)t->offset + (off_t)moved);
        if (n == 0 || (n < 0 && errno != EINTR)) {
            return -1; /* the file has become shorter, or the disk fails */
        }
        moved += n > 0 ? (uint32_t)n : 0;
    }
    return 0;
}

static int move(host_scene *scene, const host_transfer *t) {
    if ((scene->memory ? move_in_memory(scene, t) : move_from_file(scene, t)) < 0) {
        return -1;
    }
    scene->transfers++;
    scene->bytes_moved += t->count;
    return 0;
}

static int scene_wait(void *context, uint32_t tags) {
    host_scene *scene = context;
    int status = 0;
    for (int i = 0; i < HOST_TRANSFERS; i++) {
        if (scene->pending[i].tag_bit & tags) {
            status |= move(scene, &scene->pending[i]);
            scene->pending[i].tag_bit = 0;
        }
    }
    return status;
}

static void set_fetched(host_scene *scene) {
    scene->source.context = scene;
    scene->source.start = scene_start;
    scene->source.wait = scene_wait;
}

int host_scene_fetch(host_scene *scene, const char *path) {
    if (open_scene(scene, path) < 0) {
        return -1;
    }
    set_fetched(scene);
    return 0;
}

void host_scene_hold(host_scene *scene, const void *bytes, uint32_t count, int fetched) {
    memset(scene, 0, sizeof *scene);
    scene->file = -1;
    scene->memory = bytes;
    scene->source.bytes = count;
    if (fetched) {
        set_fetched(scene);
    } else {
        scene->source.mapped = bytes;
    }
}

void host_scene_share(host_scene *scene, const host_scene *of) {
    memset(scene, 0, sizeof *scene);
    scene->file = of->file;
    scene->memory = of->memory;
    scene->source.bytes = of->source.bytes;
    if (of->source.mapped) {
        scene->source.mapped = of->source.mapped;
    } else {
        set_fetched(scene);
    }
}

void host_scene_close(host_scene *scene) {
    if (scene->source.mapped && !scene->memory) {
        munmap((void *)(uintptr_t)scene->source.mapped, scene->source.bytes);
    }
    scene->source.mapped = scene->memory = NULL;
    if (scene->file >= 0) {
        close(scene->file);
        scene->file = -1;
    }
}
