/* material_section - see material_section.h
 *
 * Runs of triangles, or an index of 1, 2, 4 or 8 bits for each, whichever takes less.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/material_section.h"

#include <string.h>

#include "engine/base/bytes.h"
#include "engine/image/header.h"
#include "engine/whitted/materials.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/further_add.h"
#include "host_tools/pack/image_size.h"

typedef struct section {
    const mesh_materials *m;
    uint16_t *number; /* of each material in the section; MATERIAL_UNUSED: it has none */
    plt_materials as; /* counts alone */
} section;

static uint32_t number_at(const section *s, uint32_t triangle) {
    return s->number[s->m->of[triangle]];
}

/* Numbers by first use; 0: there are too many. */
static int choose(section *s) {
    memset(s->number, 0xFF, s->m->count * sizeof *s->number);
    for (uint32_t i = 0; i < s->as.triangles; i++) {
        uint16_t *number = &s->number[s->m->of[i]];
        if (*number == MATERIAL_UNUSED) {
            if (s->as.count == PLT_MATERIALS_MOST) {
                return 0;
            }
            *number = (uint16_t)s->as.count++;
        }
        s->as.runs += i == 0 || number_at(s, i) != number_at(s, i - 1);
    }
    plt_materials indexed = s->as;
    indexed.bits = s->as.count <= 2 ? 1 : s->as.count <= 4 ? 2 : s->as.count <= 16 ? 4 : 8;
    indexed.runs = 0;
    if (plt_materials_bytes(&indexed) < plt_materials_bytes(&s->as)) {
        s->as = indexed;
    }
    return 1;
}

static void put_material(unsigned char *to, const material_values *v) {
    plt_put_floats(to, v->diffuse, 3);
    plt_put_floats(to + 12, v->specular, 3);
    plt_put_floats(to + 24, v->emission, 3);
    plt_put_floats(to + 36, v->absorption, 3);
    plt_put_float(to + 48, v->index);
    plt_put_float(to + 52, v->transparency);
    plt_put_float(to + 56, v->mirror);
    plt_put_u32(to + 60, v->exponent);
}

static void put_index(unsigned char *to, const section *s) {
    uint32_t run = 0;
    for (uint32_t i = 0; i < s->as.triangles; i++) {
        const uint32_t number = number_at(s, i);
        if (s->as.bits > 0) {
            const uint64_t bit = (uint64_t)i * s->as.bits;
            to[bit / 8] |= (unsigned char)(number << bit % 8);
        } else if (i == 0 || number != number_at(s, i - 1)) {
            plt_put_u32(to + 4 * (size_t)run, i);
            to[4 * (size_t)s->as.runs + run++] = (unsigned char)number;
        }
    }
}

/* `to` is zero. */
static void put_section(unsigned char *to, const section *s) {
    plt_put_u32(to, s->as.count);
    plt_put_u32(to + 4, s->as.bits);
    plt_put_u32(to + 8, s->as.runs);
    plt_put_u32(to + 12, s->as.triangles);
    unsigned char *table = to + PLT_MATERIALS_HEAD;
    for (size_t i = 0; i < s->m->count; i++) {
        if (s->number[i] != MATERIAL_UNUSED) {
            put_material(table + s->number[i] * PLT_MATERIAL_BYTES, &s->m->material[i].values);
        }
    }
    put_index(table + s->as.count * PLT_MATERIAL_BYTES, s);
}

static int add(packed *image, section *s, const char *name, material_stats *stats, fail *f) {
    if (!choose(s)) {
        return fail_set(f, name,
                        "has more than 256 materials; merge some, or use --materials none");
    }
    const uint64_t size = plt_materials_bytes(&s->as);
    const char *remedy = "use --materials none, or --reduce";
    if (image_size_check(name, image->info.triangles, image->size + size + FURTHER_ADD_MORE, 0,
                         remedy, f) != 0) {
        return -1;
    }
    unsigned char *bytes = heap_get_zeroed(size);
    if (bytes == NULL) {
        return fail_set(f, name, "out of memory; use a larger machine");
    }
    put_section(bytes, s);
    const int status = further_add(image, PLT_SECTION_MATERIALS, bytes, (uint32_t)size, name, f);
    heap_drop(bytes);
    *stats = (material_stats){s->as.count, (uint32_t)size, s->as.bits, s->as.runs};
    return status;
}

int material_section_add(packed *image, const mesh_materials *m, uint16_t *number, const char *name,
                         material_stats *stats, fail *f) {
    section s = {.m = m, .as = {.triangles = image->info.source_triangles}};
    s.number = heap_get(m->count * sizeof *s.number);
    if (s.number == NULL) {
        return fail_set(f, name, "out of memory; use a larger machine");
    }
    const int status = add(image, &s, name, stats, f);
    if (status == 0 && number != NULL) {
        memcpy(number, s.number, m->count * sizeof *number);
    }
    heap_drop(s.number);
    return status;
}
