/* ray_file - rays from a file, and hits into one
 *
 * Ray file: 32 bytes per ray, little-endian float32: org[3] tmin dir[3] tmax.
 * Hit file: 16 bytes per ray: t u v and the primitive id.
 *
 * SPDX-License-Identifier: MIT */
#ifndef RAY_FILE_H
#define RAY_FILE_H
#include <stdint.h>

#include "engine/planelet.h"
#include "host_tools/base/fail.h"
#include "host_tools/base/output.h"

typedef struct ray_file {
    plt_ray *rays;
    plt_hit *hits; /* as many */
    uint32_t count;
    uint32_t *place; /* number i of the file is ray place[i]; NULL: ray i */
} ray_file;

/* Into one that is all 0 or has been read; `path` may be - for standard input. `sorts`: the rays
 * so that neighbours begin and point alike. */
int ray_file_read(ray_file *r, const char *path, int sorts, fail *f);
void ray_file_free(ray_file *r);

/* In the order of the file. */
int ray_file_write_hits(const ray_file *r, output *o, fail *f);

#endif
