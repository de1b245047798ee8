/* mesh_files - writes small mesh files and checks what a reader returns
 *
 * Everything is written below MESH_FOLDER.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_FILES_H
#define MESH_FILES_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "engine/planelet_config.h"
#include "host_tools/mesh/mesh.h"
#include "tests/test.h"

#define MESH_FOLDER TEST_FOLDER "mesh/"

static inline void mesh_folder(void) {
    mkdir(TEST_FOLDER, 0777);
    mkdir(MESH_FOLDER, 0777);
}

static inline void file_write(const char *path, const void *bytes, size_t size) {
    FILE *file = fopen(path, "wb");
    const int good = file && fwrite(bytes, 1, size, file) == size;
    if (!file || fclose(file) != 0 || !good) {
        printf("cannot write %s\n", path);
        exit(1);
    }
}

/* A file being put together. */
typedef struct blob {
    unsigned char bytes[65536];
    size_t size;
} blob;

static inline void put(blob *b, const void *bytes, size_t size) {
    if (size > sizeof b->bytes - b->size) {
        printf("blob is full\n");
        exit(1);
    }
    memcpy(b->bytes + b->size, bytes, size);
    b->size += size;
}

static inline void put_text(blob *b, const char *text) {
    put(b, text, strlen(text));
}

static inline void put_number(blob *b, uint64_t bits, size_t size, int big) {
    for (size_t i = 0; i < size; i++) {
        const unsigned char byte = (unsigned char)(bits >> 8 * (big ? size - 1 - i : i));
        put(b, &byte, 1);
    }
}

static inline void put_float(blob *b, float value, int big) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_number(b, bits, sizeof bits, big);
}

static inline void put_double(blob *b, double value, int big) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_number(b, bits, sizeof bits, big);
}

static inline int read_blob(mesh *m, const char *path, const blob *b, mesh_report *report,
                            fail *f) {
    file_write(path, b->bytes, b->size);
    f->text[0] = '\0';
    return mesh_read(m, path, 0, report, f);
}

static inline int read_text(mesh *m, const char *path, const char *text, mesh_report *report,
                            fail *f) {
    file_write(path, text, strlen(text));
    f->text[0] = '\0';
    return mesh_read(m, path, 0, report, f);
}

/* Reads into an empty mesh without repair: it must succeed. */
static inline mesh must_read_text(const char *path, const char *text) {
    mesh m = {0};
    mesh_report report = {0};
    fail f;
    CHECK(read_text(&m, path, text, &report, &f) == 0, "%s", f.text);
    return m;
}

static inline mesh must_read_blob(const char *path, const blob *b) {
    mesh m = {0};
    mesh_report report = {0};
    fail f;
    CHECK(read_blob(&m, path, b, &report, &f) == 0, "%s", f.text);
    return m;
}

/* Reading must fail with exactly this text after "PATH: ". */
static inline void must_fail_blob(const char *path, const blob *b, const char *expected) {
    mesh m = {0};
    mesh_report report = {0};
    fail f;
    char whole[sizeof f.text];
    snprintf(whole, sizeof whole, "%s: %s", path, expected);
    CHECK(read_blob(&m, path, b, &report, &f) == -1, "read without failure, wanted: %s", whole);
    CHECK(strcmp(f.text, whole) == 0, "said '%s', not '%s'", f.text, whole);
    CHECK(m.vertices == 0 && m.triangles == 0, "%zu vertices left", m.vertices);
    mesh_free(&m);
}

static inline void must_fail_text(const char *path, const char *text, const char *expected) {
    blob b = {.size = 0};
    put_text(&b, text);
    must_fail_blob(path, &b, expected);
}

static inline void check_vertices(const mesh *m, const float *expected, size_t vertices) {
    CHECK(m->vertices == vertices, "%zu vertices, not %zu", m->vertices, vertices);
    if (m->vertices == vertices) {
        for (size_t i = 0; i < 3 * vertices; i++) {
            CHECK(memcmp(&m->vertex[i], &expected[i], sizeof expected[i]) == 0,
                  "coordinate %zu is %.9g, not %.9g", i, (double)m->vertex[i], (double)expected[i]);
        }
    }
}

static inline void check_triangles(const mesh *m, const uint32_t *expected, size_t triangles) {
    CHECK(m->triangles == triangles, "%zu triangles, not %zu", m->triangles, triangles);
    if (m->triangles == triangles) {
        for (size_t i = 0; i < 3 * triangles; i++) {
            CHECK(m->triangle[i] == expected[i], "corner %zu is %u, not %u", i, m->triangle[i],
                  expected[i]);
        }
    }
}

/* Checks what holds for every mesh that a reader returns; 1 when it does. */
static inline int mesh_is_valid(const mesh *m) {
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        if (!(fabsf(m->vertex[i]) <= PLT_COORD_MAX)) {
            return 0;
        }
    }
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        if (m->triangle[i] >= m->vertices) {
            return 0;
        }
    }
    return m->vertices <= m->vertex_room && m->triangles <= m->triangle_room;
}

#endif
