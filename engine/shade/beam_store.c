/* beam_store - triangles of compact blocks that pixels may have, as records
 *
 * SPDX-License-Identifier: MIT */
#include "engine/lanes/unroll.h"
#include "engine/shade/beam.h"
#include "engine/tree/canonical.h"

const plt_record *plt_beam_store(plt_beam *b, const plt_leaf *leaf, uint32_t triangle,
                                 uint32_t index) {
    plt_record *r = plt_beam_free_record(b);
    const uint32_t *position[3];
    uint64_t key[3];
    PLT_UNROLLED for (unsigned c = 0; c < 3; c++) {
        position[c] = leaf->vertex[plt_leaf_corner(leaf, triangle, c)].number;
        key[c] = plt_lattice_key(position[c]);
    }
    uint32_t from = plt_canonical_first(key[1] < key[0], key[2] < key[0], key[2] < key[1]);
    for (unsigned c = 0; c < 3; c++) {
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            plt_put_float(&r->word[3 * c + (unsigned)a],
                          plt_lattice_float(&b->tree->lattice, a, position[from][a]));
        }
        from = from < 2 ? from + 1 : 0;
    }
    const plt_primitive_ids *ids = b->tree->ids.bytes == NULL ? NULL : &b->tree->ids;
    plt_put_u32(&r->word[9], plt_primitive_word_find(ids, index));
#if PLT_WITH_PAGES
    if (b->index != NULL) {
        b->index[r - b->store] = index;
    }
#endif
    return r;
}
