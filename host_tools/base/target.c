/* target - see target.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/target.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LINKS_MOST = 40, TEXT_BYTES = 4096 }; /* as in Linux: MAXSYMLINKS, PATH_MAX */

/* Where a link at `path` leads that holds `text`: from its own folder on. */
static char *join(const char *path, const char *text, size_t length) {
    const char *slash = strrchr(path, '/');
    const size_t folder = text[0] == '/' || slash == NULL ? 0 : (size_t)(slash - path) + 1;
    char *to = malloc(folder + length + 1);
    if (to != NULL) {
        memcpy(to, path, folder);
        memcpy(to + folder, text, length);
        to[folder + length] = '\0';
    }
    return to;
}

/* The next path of a chain; `path` itself when it is no link; NULL with errno set. */
static char *follow(char *path) {
    char text[TEXT_BYTES];
    struct stat about;
    if (lstat(path, &about) != 0 || !S_ISLNK(about.st_mode)) {
        return path;
    }
    const ssize_t length = readlink(path, text, sizeof text);
    char *next = NULL;
    if (length == (ssize_t)sizeof text) {
        errno = ENAMETOOLONG;
    } else if (length >= 0) {
        next = join(path, text, (size_t)length);
    }
    free(path);
    return next;
}

char *target_of(const char *name) {
    char *path = strdup(name);
    for (int i = 0; path != NULL && i <= LINKS_MOST; i++) {
        char *next = follow(path);
        if (next == path) {
            return path;
        }
        path = next;
    }
    if (path != NULL) {
        free(path);
        errno = ELOOP;
    }
    return NULL;
}
