/* structure - what finds hits: the engine's trees and grids, and what others have built
 *
 * One interface for all that hits can be asked of, so that tools and measuring programs compare
 * them without knowing them. All give the hits of the engine, bit for bit (BASELINES.md).
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_STRUCTURE_H
#define BASELINES_STRUCTURE_H

#include <stdio.h>

#include "engine/planelet.h"
#include "host_tools/base/fail.h"
#include "host_tools/baselines/base/structure_types.h"
#include "host_tools/mesh/mesh.h"

typedef struct structure_kind structure_kind;
typedef struct built_structure built_structure;

/* All kinds, by name; NULL ends them. */
const structure_kind *const *structure_kinds(void);
const structure_kind *structure_find(const char *name); /* NULL: there is none */
const char *structure_name(const structure_kind *kind);
const char *structure_about(const structure_kind *kind);

/* Its switches; one without a name ends them. */
const structure_switch *structure_switches(const structure_kind *kind);

/* "NAME" or "NAME:SWITCH,SWITCH,...": the kind and its options. NULL: there is no such kind, or no
 * such switch, or two of them do not go together; `f` says what there is. `what` is for errors. */
const structure_kind *structure_read(const char *text, const char *what, structure_options *options,
                                     fail *f);

/* Whether what is chosen goes together; -1: as above. */
int structure_suits(const structure_kind *kind, const structure_options *options, fail *f);

/* The kinds and their switches, as lines of a help. A name means the same for all kinds. */
void structure_print_kinds(FILE *to);

/* Builds one of `m`, which is not needed any more; ids are places in it. `name` is for errors. NULL
 * when there is no memory, or the mesh is beyond what the kind can hold. */
built_structure *structure_open(const structure_kind *kind, const mesh *m,
                                const structure_options *options, const char *name, fail *f);
/* An engine that is open, in the mode that it was opened with, as one of them: rays, counts and
 * moves go to it. It stays its owner's, and has to outlive the structure. NULL: no memory. */
built_structure *structure_of_engine(plt_engine *engine, const char *name, fail *f);

void structure_close(built_structure *s); /* NULL is allowed */

/* The same triangles, moved: what the kind does before it traces a frame. -1: another number of
 * them; or no memory, and then it can be moved again, or closed. */
int structure_move(built_structure *s, const mesh *m, fail *f);

/* As plt_trace, with its hits, bit for bit. -1: what is built on demand had no memory; as
 * above. */
int structure_trace(built_structure *s, const plt_ray *rays, plt_hit *hits, uint32_t count, int any,
                    fail *f);

structure_statistics structure_count(const built_structure *s);
void structure_forget(built_structure *s); /* of rays */

#endif
