/* materials - what the triangles of meshes are made of, as OBJ and MTL say
 *
 * Kept apart from the mesh, by triangle: whoever wants them hangs one on `mesh.materials` before
 * files are read. Names are those of a file: two files may mean different things by one.
 *
 * SPDX-License-Identifier: MIT */
#ifndef MESH_MATERIALS_H
#define MESH_MATERIALS_H
#include <stddef.h>
#include <stdint.h>

enum { MATERIALS_MOST = 65535, MATERIALS_TROUBLES_KEPT = 16, MATERIALS_LIBRARIES_MOST = 256 };

/* As a section of an image has it (SPEC.md, 4.20). */
typedef struct material_values {
    float diffuse[3], specular[3], emission[3], absorption[3];
    float index, transparency, mirror;
    uint32_t exponent;
} material_values;

/* The picture of map_Kd, and how it lies. */
typedef struct material_map {
    char *path; /* owned; NULL: there is none */
    float scale[3], offset[3];
    int clamp;
} material_map;

typedef struct mesh_material {
    char *name;    /* owned; NULL: of triangles without one */
    size_t length; /* of the name, whose bytes may be any */
    material_values values;
    material_map map;
    int is_defined; /* some file says what it is; else it has the values of none */
} mesh_material;

/* What could not be found, for a line about it: "FILE: what", without control characters. */
typedef struct materials_trouble {
    char text[320];
} materials_trouble;

typedef struct mesh_materials {
    mesh_material *material; /* [0]: of triangles that have none; owned */
    size_t count, room;
    uint16_t *by_name; /* numbers from `scope` on; owned */
    uint16_t *of;      /* by triangle of the mesh; owned */
    size_t of_room;
    size_t filled;    /* triangles that have one */
    size_t scope;     /* first of the names of this file */
    uint16_t current; /* of the faces that follow */
    materials_trouble trouble[MATERIALS_TROUBLES_KEPT];
    size_t troubles; /* all of them, of which the first are kept */
    char **library;  /* names of those that this file has read; owned */
    size_t libraries;
    int has_names;      /* some face has a material */
    uint32_t maps_left; /* bits of maps and their options that are there, and not read */
} mesh_materials;

/* A white that is not too bright, without highlights. */
material_values material_none(void);

/* Each -1 when memory is out, or there are more than MATERIALS_MOST. A file begins whose triangles
 * are those from `triangles` on. */
int materials_begin(mesh_materials *m, size_t triangles);
/* The number of a name, which need not be defined yet; -1. */
int materials_find(mesh_materials *m, const char *name, size_t length);
/* Whether a library of this file is to be read: 0 if it was, or, which becomes a trouble, if
 * MATERIALS_LIBRARIES_MOST were. */
int materials_library(mesh_materials *m, const char *path, const char *name, size_t length);
/* `triangles` are there; those that follow have material `number`. */
int materials_use(mesh_materials *m, size_t triangles, int number);
/* The file ends: names that were used and are not defined become troubles. */
int materials_end(mesh_materials *m, const char *path, size_t triangles);
void materials_complain(mesh_materials *m, const char *path, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* How MTL names what a bit of maps_left stands for, in lower case; NULL: it has no such bit. */
const char *materials_map_left(unsigned bit);
void materials_free(mesh_materials *m);

#endif
