/* counts - the arithmetic of scenes that come in any size
 *
 * SPDX-License-Identifier: MIT */
#ifndef COUNTS_H
#define COUNTS_H
#include "host_tools/scenes/scenes.h"

/* Refuses a count outside least .. most, at most SCENE_TRIANGLES_MAX, and one for which
 * `m` has no vertex indices left. */
int count_check(const mesh *m, const char *scene, uint64_t triangles, unsigned least, unsigned most,
                fail *f);
uint32_t count_root(uint64_t square); /* floor(sqrt(square)), square < 2^62 */

#endif
