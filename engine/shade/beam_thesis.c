/* beam_thesis - the beam on its way through thesis nodes over records
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/beam.h"

#define BEAM_TRACE plt_beam_trace_nodes
#define BEAM_LEAF(b, t, first, lists) plt_beam_lists(b, first, lists, 0)
#include "engine/shade/beam_nodes.h"
