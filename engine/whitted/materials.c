/* materials - see materials.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted/materials.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/further.h"

#if PLT_WITH_MATERIALS

enum { AT_COUNT = 0, AT_BITS = 4, AT_RUNS = 8, AT_TRIANGLES = 12, AT_RESERVED = 16 };
enum { AT_TRANSPARENCY = 52 }; /* in a material */
enum { FLOATS = 15 };          /* of a material, before its exponent */

static uint64_t index_bytes(const plt_materials *m) {
    return m->bits > 0 ? ((uint64_t)m->triangles * m->bits + 7) / 8 : 5ull * m->runs;
}

static uint64_t used_bytes(const plt_materials *m) {
    return PLT_MATERIALS_HEAD + (uint64_t)m->count * PLT_MATERIAL_BYTES + index_bytes(m);
}

uint64_t plt_materials_bytes(const plt_materials *m) {
    return (used_bytes(m) + 63) & ~63ull;
}

/* The most that each float of a material may be; the least is 0, of an index 1. */
static float most_of(unsigned i) {
    return i < 6 || i > 12 ? 1.0f : i == 12 ? 4.0f : 1048576.0f;
}

static int is_material(const unsigned char *at) {
    int good = 1;
    for (unsigned i = 0; i < FLOATS; i++) {
        const float x = plt_get_float(at + 4 * i), least = i == 12 ? 1.0f : 0.0f;
        good &= x >= least && x <= most_of(i); /* false for NaN */
    }
    const uint32_t exponent = plt_get_u32(at + 4 * FLOATS);
    return good && exponent >= 1 && exponent <= PLT_EXPONENT_MOST;
}

static uint32_t run_begin(const plt_materials *m, uint32_t run) {
    return plt_get_u32(m->index + 4 * (size_t)run);
}

static uint32_t run_material(const plt_materials *m, uint32_t run) {
    return m->index[4 * (size_t)m->runs + run];
}

static uint32_t packed_index(const plt_materials *m, uint32_t triangle) {
    const uint64_t bit = (uint64_t)triangle * m->bits;
    return (uint32_t)m->index[bit / 8] >> bit % 8 & ((1u << m->bits) - 1u);
}

/* Runs begin with triangle 0, each behind the one before, and their materials are there. */
static int are_runs(const plt_materials *m) {
    int good = run_begin(m, 0) == 0;
    for (uint32_t i = 0; i < m->runs; i++) {
        good &= i == 0 || run_begin(m, i) > run_begin(m, i - 1);
        good &= run_begin(m, i) < m->triangles && run_material(m, i) < m->count;
    }
    return good;
}

static int are_indices(const plt_materials *m) {
    int good = 1;
    for (uint32_t i = 0; i < m->triangles; i++) {
        good &= packed_index(m, i) < m->count;
    }
    return good;
}

static int are_counts(const plt_materials *m, const unsigned char *section, uint32_t triangles) {
    const int packed = m->bits == 1 || m->bits == 2 || m->bits == 4 || m->bits == 8;
    const int runs = m->bits == 0 && m->runs > 0 && m->runs <= m->triangles;
    int good = m->count > 0 && m->count <= PLT_MATERIALS_MOST && m->triangles == triangles &&
               ((packed && m->runs == 0) || runs);
    for (unsigned i = AT_RESERVED; i < PLT_MATERIALS_HEAD; i++) {
        good &= section[i] == 0;
    }
    return good;
}

static int refused(plt_fault *fault, uint32_t offset, const char *message) {
    return plt_refused(fault, PLT_R19_MATERIALS, offset, message);
}

int plt_materials_read(plt_materials *m, const unsigned char *section, uint32_t bytes,
                       uint32_t triangles, uint32_t offset, plt_fault *fault) {
    m->table = section + PLT_MATERIALS_HEAD;
    m->count = plt_get_u32(section + AT_COUNT);
    m->bits = plt_get_u32(section + AT_BITS);
    m->runs = plt_get_u32(section + AT_RUNS);
    m->triangles = plt_get_u32(section + AT_TRIANGLES);
    const plt_section all = {.bytes = bytes};
    if (!are_counts(m, section, triangles) || !plt_further_is_full(&all, section, used_bytes(m))) {
        return refused(fault, offset, "a count of the materials is out of range");
    }
    m->index = m->table + (size_t)m->count * PLT_MATERIAL_BYTES;
    m->has_glass = 0;
    for (uint32_t i = 0; i < m->count; i++) {
        const unsigned char *at = m->table + (size_t)i * PLT_MATERIAL_BYTES;
        if (!is_material(at)) {
            return refused(fault, offset + PLT_MATERIALS_HEAD + i * PLT_MATERIAL_BYTES,
                           "a number of a material is out of range");
        }
        m->has_glass |= plt_get_float(at + AT_TRANSPARENCY) > 0.0f;
    }
    if (!(m->bits > 0 ? are_indices(m) : are_runs(m))) {
        return refused(fault, offset + PLT_MATERIALS_HEAD + m->count * PLT_MATERIAL_BYTES,
                       "a triangle has a material that is not there, or runs do not follow "
                       "each other");
    }
    return PLT_OK;
}

/* The last run that does not begin behind the triangle: halving. */
static uint32_t run_of(const plt_materials *m, uint32_t triangle) {
    uint32_t first = 0, count = m->runs;
    while (count > 1) {
        const uint32_t half = count / 2;
        const int behind = run_begin(m, first + half) <= triangle;
        first = behind ? first + half : first;
        count = behind ? count - half : half;
    }
    return first;
}

uint32_t plt_materials_find(const plt_materials *m, uint32_t triangle) {
    if (m->table == NULL || triangle >= m->triangles) {
        return 0;
    }
    return m->bits > 0 ? packed_index(m, triangle) : run_material(m, run_of(m, triangle));
}

/* What is seen of an image without materials. */
static const plt_material clay = {
    {0.72f, 0.67f, 0.60f}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1.0f, 0.0f, 0.0f, 1};

void plt_materials_get(const plt_materials *m, uint32_t number, plt_material *to) {
    if (m->table == NULL) {
        *to = clay;
        return;
    }
    const unsigned char *at = m->table + (size_t)number * PLT_MATERIAL_BYTES;
    plt_get_floats(to->diffuse, at, 3);
    plt_get_floats(to->specular, at + 12, 3);
    plt_get_floats(to->emission, at + 24, 3);
    plt_get_floats(to->absorption, at + 36, 3);
    to->index = plt_get_float(at + 48);
    to->transparency = plt_get_float(at + AT_TRANSPARENCY);
    to->mirror = plt_get_float(at + 56);
    to->exponent = plt_get_u32(at + 60);
}

#endif
