/* readers - one reader per mesh file format, all with the same contract
 *
 * Each appends what `in` holds to `m`, or returns -1 with `m` as it was.
 * `in->path` is what failures name.
 *
 * SPDX-License-Identifier: MIT */
#ifndef READERS_H
#define READERS_H
#include "host_tools/base/input.h"
#include "host_tools/mesh/mesh.h"

int ply_is(const input *in);
int ply_read(mesh *m, const input *in, mesh_report *report, fail *f);

int obj_is(const input *in); /* for files whose name says nothing */
int obj_read(mesh *m, const input *in, mesh_report *report, fail *f);

int stl_is(const input *in);
int stl_may_be(const input *in); /* for files whose name says nothing, after all others */
int stl_read(mesh *m, const input *in, mesh_report *report, fail *f);

#endif
