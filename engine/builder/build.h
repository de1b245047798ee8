/* build - a BPH with treelets from triangle records, in place
 *
 * Records are permuted until every list lies in a row; nodes come straight
 * from the splits, no other hierarchy is ever kept. The same code runs in the
 * host's packer and, over an arena, on the device.
 *
 * Memory beside records and nodes: bins and a stack of ranges while splitting; then, to
 * put the nodes into treelets, 4 bytes per node and 4 per slot of a treelet. The greater
 * of both is plt_build_scratch_bytes.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BUILDER_BUILD_H
#define PLT_BUILDER_BUILD_H

#include <stddef.h>
#include <stdint.h>

#include "engine/planelet.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"
#include "engine/tree/thesis/treelets.h"

typedef struct plt_build_job {
    plt_record *records;     /* permuted; primitive ids set, last bits rewritten */
    uint32_t count;          /* records, at most PLT_INDEX_MAX */
    plt_node *nodes;         /* out */
    uint32_t room;           /* node slots there */
    uint32_t leaf_triangles; /* K: 1, 2 or 4 (any from 1 works) */
    uint32_t treelet_nodes;  /* N: 1 .. PLT_INDEX_MAX */
    uint8_t splits;          /* enum plt_splits */
    void *scratch;           /* aligned to PLT_ALIGN */
    size_t scratch_bytes;
#if PLT_WITH_REBUILD
    plt_treelet_forming treelets; /* between steps */
#endif
#if PLT_WITH_SUBTREES
    uint32_t depth;     /* of a subtree: nodes above it, else 0 */
    uint32_t is_paced;  /* 1: `room` nodes are enough, if they are for any tree: where the
                         * splits take more than their share, ranges are divided by count */
    uint32_t depth_max; /* result: nodes on the longest path, with those above */
#endif
    /* results */
    uint32_t nodes_used, node_slots, root;
    plt_box box;
} plt_build_job;

/* Most inner nodes that `count` triangles can take: n - 1 less one intermediate node. */
static inline uint32_t plt_build_nodes_bound(uint32_t count) {
    return count < 3 ? 0 : count - 2;
}

/* Most node slots of `nodes` nodes in treelets of `treelet_nodes`. */
uint32_t plt_build_slots_bound(uint32_t nodes, uint32_t treelet_nodes);

/* Scratch that is enough for `nodes` nodes. */
size_t plt_build_scratch_bytes(uint32_t nodes, uint32_t treelet_nodes);

/* PLT_OK, PLT_ERR_ARENA (room or scratch too small; the bounds above are
 * always enough), PLT_ERR_LIMIT (more triangles than PLT_DEPTH_MAX levels can
 * hold). Deterministic: equal records give equal bytes on every machine.
 * Cost: about log2(count / K) passes over the records. */
int plt_build(plt_build_job *job);

#if PLT_WITH_REBUILD
/* The same in steps, of a job whose `box` the caller knows. Begin, and split until it is done, each
 * step about `triangles` records, as often as ranges of them are looked at: ranges of more are
 * divided, those of 64 at most are not. Then treelets, about `nodes` at a time, and one treelet at
 * least. PLT_MORE: another step. */
int plt_build_begin(plt_build_job *job);
int plt_build_split(plt_build_job *job, uint32_t triangles);
int plt_build_treelets_begin(plt_build_job *job);
int plt_build_treelets(plt_build_job *job, uint32_t nodes);
#endif

#endif
