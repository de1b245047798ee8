/* ray_file - see ray_file.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/ray_file.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/bytes.h"
#include "host_tools/app/ray_order.h"
#include "host_tools/base/input.h"

enum { RAY_BYTES = 32, HIT_BYTES = 16 };

/* Decodes the little-endian rays into floats of this machine. */
static int decode_rays(ray_file *r, const input *in, const char *name, fail *f) {
    if (in->size % RAY_BYTES != 0) {
        return fail_set(f, name,
                        "byte %zu: the last ray is cut short (a ray has 32 bytes); write it again",
                        in->size - in->size % RAY_BYTES);
    }
    if (in->size / RAY_BYTES > UINT32_MAX) {
        return fail_set(f, name, "more than 2^32 - 1 rays; split the file");
    }
    r->count = (uint32_t)(in->size / RAY_BYTES);
    r->rays = malloc(in->size + 1);
    r->hits = malloc((size_t)r->count * sizeof *r->hits + 1);
    if (r->rays == NULL || r->hits == NULL) {
        return fail_set(f, name, "out of memory for %" PRIu32 " rays; split the file", r->count);
    }
    for (uint32_t i = 0; i < r->count; i++) {
        plt_get_floats(r->rays[i].org, in->bytes + RAY_BYTES * (size_t)i, 8);
    }
    return 0;
}

/* Rays in that order; and where each of the file is then. */
static void put_in_order(ray_file *r, plt_ray *sorted, const uint32_t *order) {
    for (uint32_t i = 0; i < r->count; i++) {
        sorted[i] = r->rays[order[i]];
        r->place[order[i]] = i;
    }
    free(r->rays);
    r->rays = sorted;
}

static int sort_rays(ray_file *r, const char *name, fail *f) {
    plt_ray *sorted = malloc((size_t)r->count * sizeof *sorted + 1);
    uint32_t *order = malloc((size_t)r->count * sizeof *order + 1);
    r->place = malloc((size_t)r->count * sizeof *r->place + 1);
    const int is_sorted = sorted != NULL && order != NULL && r->place != NULL &&
                          ray_order_sort(r->rays, r->count, order) == 0;
    if (is_sorted) {
        put_in_order(r, sorted, order);
    } else {
        free(sorted);
    }
    free(order);
    return is_sorted ? 0
                     : fail_set(f, name,
                                "out of memory to sort %" PRIu32 " rays; leave out --order sorted",
                                r->count);
}

int ray_file_read(ray_file *r, const char *path, int sorts, fail *f) {
    const char *name = strcmp(path, "-") == 0 ? "standard input" : path;
    input in;
    ray_file_free(r);
    if (input_read(&in, path, f) != 0) {
        return -1;
    }
    const int status = decode_rays(r, &in, name, f);
    input_free(&in);
    return status == 0 && sorts ? sort_rays(r, name, f) : status;
}

void ray_file_free(ray_file *r) {
    free(r->rays);
    free(r->hits);
    free(r->place);
    *r = (ray_file){.count = 0};
}

int ray_file_write_hits(const ray_file *r, output *o, fail *f) {
    for (uint32_t i = 0; i < r->count; i++) {
        const plt_hit *hit = &r->hits[r->place != NULL ? r->place[i] : i];
        unsigned char bytes[HIT_BYTES];
        const float tuv[3] = {hit->t, hit->u, hit->v};
        plt_put_floats(bytes, tuv, 3);
        plt_put_u32(bytes + 12, hit->triangle);
        if (output_write(o, bytes, sizeof bytes, f) != 0) {
            return -1;
        }
    }
    return 0;
}
