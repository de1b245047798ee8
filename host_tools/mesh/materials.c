/* materials - see materials.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/materials.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/base/heap.h"

material_values material_none(void) {
    return (material_values){
        .diffuse = {0.72f, 0.67f, 0.60f}, .index = 1.0f, .exponent = 1}; /* the engine's clay */
}

static int add(mesh_materials *m, const char *name, size_t length) {
    if (m->count == m->room) {
        const size_t room = 2 * m->room + 16;
        mesh_material *more = heap_resize(m->material, (uint64_t)room * sizeof *more);
        if (more == NULL) {
            return -1;
        }
        m->material = more;
        m->room = room;
    }
    char *copy = NULL;
    if (name != NULL) {
        copy = heap_get(length + 1);
        if (copy == NULL) {
            return -1;
        }
        memcpy(copy, name, length);
        copy[length] = '\0';
    }
    m->material[m->count] = (mesh_material){.name = copy, .values = material_none()};
    return (int)m->count++;
}

int materials_begin(mesh_materials *m, size_t triangles) {
    if (m->count == 0 && add(m, NULL, 0) < 0) {
        return -1;
    }
    m->filled = m->filled < triangles ? m->filled : triangles; /* --repair may have dropped some */
    const int status = materials_use(m, triangles, 0);         /* of files that have none */
    m->scope = m->count;
    return status;
}

int materials_find(mesh_materials *m, const char *name, size_t length) {
    for (size_t i = m->scope; i < m->count; i++) {
        if (strlen(m->material[i].name) == length &&
            memcmp(m->material[i].name, name, length) == 0) {
            return (int)i;
        }
    }
    return m->count >= MATERIALS_MOST ? -1 : add(m, name, length);
}

int materials_use(mesh_materials *m, size_t triangles, int number) {
    if (triangles > m->of_room) {
        const size_t room = triangles + triangles / 2;
        uint16_t *more = heap_resize(m->of, (uint64_t)room * sizeof *more);
        if (more == NULL) {
            return -1;
        }
        m->of = more;
        m->of_room = room;
    }
    while (m->filled < triangles) {
        m->of[m->filled++] = m->current;
    }
    m->current = (uint16_t)number;
    m->has_names |= number > 0;
    return 0;
}

int materials_complain(mesh_materials *m, const char *path, const char *format, ...) {
    if (m->troubles == m->trouble_room) {
        const size_t room = 2 * m->trouble_room + 16;
        materials_trouble *more = heap_resize(m->trouble, (uint64_t)room * sizeof *more);
        if (more == NULL) {
            return -1;
        }
        m->trouble = more;
        m->trouble_room = room;
    }
    char *text = m->trouble[m->troubles++].text;
    const size_t size = sizeof m->trouble->text;
    const int used = snprintf(text, size, "%s: ", path);
    va_list arguments;
    va_start(arguments, format);
    if (used >= 0 && (size_t)used < size) {
        vsnprintf(text + used, size - (size_t)used, format, arguments);
    }
    va_end(arguments);
    return 0;
}

int materials_end(mesh_materials *m, const char *path, size_t triangles) {
    int status = materials_use(m, triangles, 0);
    for (size_t i = m->scope; i < m->count && status == 0; i++) {
        if (!m->material[i].is_defined) {
            status = materials_complain(m, path, "no library defines the material '%.80s'",
                                        m->material[i].name);
        }
    }
    return status;
}

void materials_free(mesh_materials *m) {
    for (size_t i = 0; i < m->count; i++) {
        heap_drop(m->material[i].name);
    }
    heap_drop(m->material);
    heap_drop(m->of);
    heap_drop(m->trouble);
    *m = (mesh_materials){0};
}
