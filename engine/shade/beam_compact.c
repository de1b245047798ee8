/* beam_compact - the beam on its way through resident compact blocks
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/blocks_resident.h"

#define BEAM_BLOCKS resident
#include "engine/shade/beam_blocks.h"
