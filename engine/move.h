/* move - what is left to do when triangles have moved
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_MOVE_H
#define PLT_MOVE_H

#include "engine/engine.h"

/* Records of a movable scene, which lie in the arena. */
plt_record *plt_engine_records(plt_engine *e);

/* Records have new corners: refits the tree, and takes over the new box. */
void plt_engine_moved(plt_engine *e);

#endif
