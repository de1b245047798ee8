/* move - what all ways to move triangles share
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOVE_H
#define PLT_MOVE_H

#include "engine/engine.h"

plt_record *plt_records_of(plt_engine *e);

/* New boxes for all nodes; the scene's. */
void plt_refit_all(plt_engine *e);

/* What all moves do at their end: the scene has its new box. */
void plt_moved(plt_engine *e);

#endif
