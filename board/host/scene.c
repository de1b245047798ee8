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
    scene->source.mapped = scene->map = map;
    return 0;
}

static int scene_start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    host_scene *scene = context;
    if (scene->pending_count == HOST_TRANSFERS) {
        return -1;
    }
    scene->pending[scene->pending_count++] =
        (host_transfer){UINT32_C(1) << (tag & 31), offset, count, to};
    return 0;
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
    const unsigned count = scene->pending_count;
    int status = 0;
    scene->pending_count = 0;
    for (unsigned i = 0; i < count; i++) {
        if (scene->pending[i].tag_bit & tags) {
            status |= move(scene, &scene->pending[i]);
        } else {
            scene->pending[scene->pending_count++] = scene->pending[i];
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

/* The same file, whatever its name is now, but with an entry of its own in the kernel's table:
 * threads that read through one entry wait for each other. Without /proc they do. */
static int open_again(int file) {
    char name[32];
    snprintf(name, sizeof name, "/proc/self/fd/%d", file);
    const int own = open(name, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    return own >= 0 ? own : fcntl(file, F_DUPFD_CLOEXEC, 0);
}

void host_scene_share(host_scene *scene, const host_scene *of) {
    memset(scene, 0, sizeof *scene);
    scene->file = of->file >= 0 && !of->source.mapped ? open_again(of->file) : -1;
    scene->memory = of->memory;
    scene->source.bytes = of->source.bytes;
    if (of->source.mapped) {
        scene->source.mapped = of->source.mapped;
    } else {
        set_fetched(scene);
    }
}

void host_scene_close(host_scene *scene) {
    if (scene->map) {
        munmap(scene->map, scene->source.bytes);
    }
    scene->map = NULL;
    scene->source.mapped = scene->memory = NULL;
    if (scene->file >= 0) {
        close(scene->file);
    }
    scene->file = -1;
}
