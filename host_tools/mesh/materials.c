/* materials - see materials.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/materials.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/base/fail.h"
#include "host_tools/base/heap.h"

material_values material_none(void) {
    return (material_values){
        .diffuse = {0.72f, 0.67f, 0.60f}, .index = 1.0f, .exponent = 1}; /* the engine's clay */
}

static char *copy_of(const char *name, size_t length) {
    char *copy = heap_get(length + 1);
    if (copy != NULL) {
        memcpy(copy, name, length);
        copy[length] = '\0';
    }
    return copy;
}

static int make_room(mesh_materials *m) {
    const size_t room = 2 * m->room + 16;
    mesh_material *more = heap_resize(m->material, (uint64_t)room * sizeof *more);
    m->material = more != NULL ? more : m->material;
    uint16_t *names = heap_resize(m->by_name, (uint64_t)room * sizeof *names);
    m->by_name = names != NULL ? names : m->by_name;
    if (more == NULL || names == NULL) {
        return -1;
    }
    m->room = room;
    return 0;
}

static int add(mesh_materials *m, const char *name, size_t length) {
    if (m->count == m->room && make_room(m) != 0) {
        return -1;
    }
    char *copy = name != NULL ? copy_of(name, length) : NULL;
    if (name != NULL && copy == NULL) {
        return -1;
    }
    m->material[m->count] =
        (mesh_material){.name = copy, .length = length, .values = material_none()};
    return (int)m->count++;
}

static void forget_libraries(mesh_materials *m) {
    while (m->libraries > 0) {
        heap_drop(m->library[--m->libraries]);
    }
}

int materials_begin(mesh_materials *m, size_t triangles) {
    if (m->count == 0 && add(m, NULL, 0) < 0) {
        return -1;
    }
    m->filled = m->filled < triangles ? m->filled : triangles; /* --repair may have dropped some */
    const int status = materials_use(m, triangles, 0);         /* of files that have none */
    m->scope = m->count;
    forget_libraries(m);
    return status;
}

static int compare(const mesh_material *m, const char *name, size_t length) {
    const int order = memcmp(m->name, name, m->length < length ? m->length : length);
    return order != 0 ? order : (m->length > length) - (m->length < length);
}

/* By halves: a file may change its material with every face, and have thousands. */
int materials_find(mesh_materials *m, const char *name, size_t length) {
    const size_t names = m->count - m->scope;
    size_t low = 0, high = names;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        const int order = compare(&m->material[m->by_name[middle]], name, length);
        if (order == 0) {
            return m->by_name[middle];
        }
        low = order < 0 ? middle + 1 : low;
        high = order < 0 ? high : middle;
    }
    const int number = m->count >= MATERIALS_MOST ? -1 : add(m, name, length);
    if (number >= 0) {
        memmove(m->by_name + low + 1, m->by_name + low, (names - low) * sizeof *m->by_name);
        m->by_name[low] = (uint16_t)number;
    }
    return number;
}

int materials_library(mesh_materials *m, const char *path, const char *name, size_t length) {
    for (size_t i = 0; i < m->libraries; i++) {
        if (strlen(m->library[i]) == length && memcmp(m->library[i], name, length) == 0) {
            return 0;
        }
    }
    if (m->libraries == MATERIALS_LIBRARIES_MOST) {
        materials_complain(m, path, "has more than %d material libraries, and the rest is not read",
                           MATERIALS_LIBRARIES_MOST);
        return 0;
    }
    if (m->library == NULL) {
        m->library = heap_get(MATERIALS_LIBRARIES_MOST * sizeof *m->library);
    }
    char *copy = m->library != NULL ? copy_of(name, length) : NULL;
    if (copy == NULL) {
        return -1;
    }
    m->library[m->libraries++] = copy;
    return 1;
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

void materials_complain(mesh_materials *m, const char *path, const char *format, ...) {
    fail f = {""};
    char text[sizeof m->trouble->text];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (m->troubles++ < MATERIALS_TROUBLES_KEPT) {
        fail_set(&f, path, "%s", text);
        snprintf(m->trouble[m->troubles - 1].text, sizeof text, "%.*s", (int)sizeof text - 1,
                 f.text);
    }
}

int materials_end(mesh_materials *m, const char *path, size_t triangles) {
    const int status = materials_use(m, triangles, 0);
    for (size_t i = m->scope; i < m->count && status == 0; i++) {
        if (!m->material[i].is_defined) {
            materials_complain(m, path, "no library defines the material '%.80s'",
                               m->material[i].name);
        }
    }
    return status;
}

void materials_free(mesh_materials *m) {
    for (size_t i = 0; i < m->count; i++) {
        heap_drop(m->material[i].name);
        heap_drop(m->material[i].map.path);
    }
    forget_libraries(m);
    heap_drop(m->library);
    heap_drop(m->material);
    heap_drop(m->by_name);
    heap_drop(m->of);
    *m = (mesh_materials){.material = NULL};
}
