/* make_materials - marbles of glass, metal and paint in a wooden tray, as OBJ and MTL
 *
 * SPDX-License-Identifier: MIT */
#ifndef MAKE_MATERIALS_H
#define MAKE_MATERIALS_H
#include "host_tools/base/fail.h"
#include "host_tools/scenes/painted.h"

/* A name that ends in .obj. */
int make_materials_has_name(const char *out);

/* Writes what still_marbles made, and NAME.mtl beside NAME.obj. */
int make_materials(const painted *p, const char *out, fail *f);

#endif
