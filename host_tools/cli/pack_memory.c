/* pack_memory - see pack_memory.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/pack_memory.h"

#include <inttypes.h>

#include "host_tools/app/note.h"
#include "host_tools/base/heap.h"
#include "host_tools/cli/pack_lines.h"
#include "host_tools/mesh/reduce.h"
#include "host_tools/pack/pack_need.h"

static const uint64_t MUCH = (uint64_t)1 << 30;

static uint64_t greater(uint64_t a, uint64_t b) {
    return a > b ? a : b;
}

/* Of the file that takes most, beside the meshes. */
static uint64_t most_of_files(const pack_meshes *in, int looks) {
    uint64_t most = 0;
    for (int i = 0; i < in->files; i++) {
        const pack_file *file = &in->file[i];
        const uint64_t vertices = file->vertices, triangles = file->end - file->first;
        most = greater(most, in->weld > 0 ? weld_near_bytes(vertices) : 0);
        most = greater(most, looks ? weld_near_suggest_bytes(vertices, triangles) : 0);
    }
    return most;
}

static uint64_t need_of_build(const pack_plan *plan, const pack_counts *counts) {
    return plan->compact->lattice_bits > 0 ? pack_need_compact(plan->compact, counts)
                                           : pack_need_thesis(plan->thesis, plan->is_high, counts);
}

/* What is left to build, at most. */
static pack_counts counts_of(const pack_meshes *in) {
    pack_counts n = {.vertices = in->m.vertices, .triangles = in->m.triangles};
    n.mesh = 12 * (n.vertices + n.triangles);
    n.held = heap_used();
    if (in->most > 0 && n.triangles > in->most) {
        n.held -= n.mesh;
        n.triangles = in->most;
        n.mesh = 12 * (n.vertices + n.triangles);
        n.held += n.mesh;
    }
    return n;
}

/* Another way to pack that the limit allows; the first that does. */
static const char *other_way(const pack_plan *plan, const pack_counts *counts) {
    compact_options compact = *plan->compact;
    const uint64_t limit = heap_limit_bytes();
    if (plan->is_high) {
        pack_plan fast = {plan->thesis, &compact, 0};
        compact.quality = NULL;
        if (need_of_build(&fast, counts) <= limit) {
            return ", or --quality fast";
        }
    }
    compact = (compact_options){.lattice_bits = 16,
                                .numbers = 1,
                                .checks = plan->compact->checks,
                                .spend = plan->compact->spend,
                                .meshes = plan->compact->meshes,
                                .leaf_triangles = 2};
    return plan->compact->lattice_bits == 0 && plan->thesis->treelet_nodes == 64 &&
                   plan->thesis->build != PLT_BUILD_NONE &&
                   pack_need_compact(&compact, counts) <= limit
               ? ", or --nodes compact"
               : "";
}

int pack_memory_plan(pack_memory *memory, const pack_meshes *in, const pack_plan *plan, fail *f) {
    const pack_counts counts = counts_of(in);
    const uint64_t reducing = in->most > 0 && in->m.triangles > in->most
                                  ? mesh_reduce_bytes(in->m.vertices, in->most)
                                  : 0;
    const uint64_t hard = greater(need_of_build(plan, &counts), heap_used() + reducing);
    memory->least = greater(heap_peak(), greater(hard, heap_used() + most_of_files(in, 0)));
    memory->needed = greater(memory->least, heap_used() + most_of_files(in, 1));
    if (memory->least <= heap_limit_bytes()) {
        return 0;
    }
    return fail_set(f, pack_shown(&in->file[0]),
                    "%zu triangles take up to %" PRIu64
                    " bytes of memory to pack, and --memory "
                    "gives %" PRIu64 "; use --memory %" PRIu64 "%s",
                    in->m.triangles, memory->least, heap_limit_bytes(), memory->least,
                    hard == memory->least ? other_way(plan, &counts) : "");
}

void pack_memory_note(const pack_memory *memory, const char *name) {
    if (heap_limit_bytes() != UINT64_MAX || memory->needed >= MUCH) {
        note("%s: packing takes up to %" PRIu64 " bytes of memory", name,
             memory->needed <= heap_limit_bytes() ? memory->needed : memory->least);
    }
}

void pack_memory_explain(const char *name, fail *f) {
    if (heap_refused() > 0) {
        f->text[0] = '\0';
        fail_set(f, name,
                 "takes more than the %" PRIu64 " bytes that --memory gives; use --memory %" PRIu64
                 " or more",
                 heap_limit_bytes(), 2 * heap_limit_bytes());
    }
}
