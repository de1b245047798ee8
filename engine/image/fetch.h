/* fetch - bytes of an image from wherever it lies
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_IMAGE_FETCH_H
#define PLT_IMAGE_FETCH_H

#include "engine/planelet.h"

/* Copies `count` bytes from `offset` of the source to `to` and waits until
 * they are there, two transfers of PLT_TRANSFER_BYTES in flight. The range
 * lies inside the source. PLT_OK or PLT_ERR_SOURCE. */
int plt_fetch(const plt_source *source, uint32_t offset, void *to, uint32_t count,
              plt_fault *fault);

#endif
