/* pack_json - what pack has read, lost and packed, for programs
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_JSON_H
#define PACK_JSON_H
#include "host_tools/base/output.h"
#include "host_tools/cli/pack_memory.h"
#include "host_tools/cli/pack_meshes.h"
#include "host_tools/pack/pack.h"
#include "host_tools/pack/surface.h"

/* `loss` is NULL where no vertex is on a lattice. */
int pack_json_write(output *o, const pack_meshes *in, const packed *image, const lattice_loss *loss,
                    const quality_stats *quality, const surface_stats *surface,
                    const pack_memory *memory, fail *f);

#endif
