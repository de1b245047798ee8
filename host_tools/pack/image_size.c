/* image_size - see image_size.h
 *
 * A tree of n inner nodes has n + 1 leaves of at most 2K triangles each: a list, or two in a row.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/image_size.h"

#include <inttypes.h>

#include "engine/image/header.h"
#include "engine/image/items.h"

static uint64_t least_nodes(uint64_t triangles, uint32_t leaf_triangles) {
    const uint64_t most = 2 * (uint64_t)leaf_triangles;
    return triangles > most ? (triangles + most - 1) / most - 1 : 0;
}

static uint64_t least_thesis(uint64_t triangles, const pack_options *o) {
    const uint64_t nodes =
        o->build == PLT_BUILD_HOST ? least_nodes(triangles, o->leaf_triangles) : 0;
    return PLT_HEADER_BYTES + triangles * PLT_RECORD_BYTES + nodes * PLT_NODE_BYTES +
           (o->checks ? nodes : 0);
}

/* A node has six planes and nine bits; a triangle on the lattice three bits (SPEC.md, 4.9 and
 * 4.10). */
static uint64_t least_blocks(uint64_t triangles, const compact_options *o) {
    const uint64_t nodes = least_nodes(triangles, o->leaf_triangles);
    return o->build == PLT_BUILD_HOST ? nodes * 57 / 8 + (o->floats ? 0 : triangles * 3 / 8) : 0;
}

static uint64_t least_compact(uint64_t triangles, const compact_options *o, uint32_t width) {
    const uint64_t blocks = PLT_HEADER_BYTES + least_blocks(triangles, o);
    return o->build == PLT_BUILD_DEVICE ? PLT_HEADER_BYTES + triangles * 9 * width
           : o->floats                  ? blocks + triangles * PLT_RECORD_BYTES
                                        : blocks;
}

/* Blocks of the largest size and behind them the permutation; or, of few triangles, the worst
 * case: nine corners of `bits` bits, references and a node each. */
uint64_t image_size_room_blocks(uint64_t triangles) {
    const uint64_t worst = triangles * 40, most = PLT_BLOCKS_BYTES_MAX + triangles * 4;
    return ((worst < most ? worst : most) + 65536) & ~(uint64_t)7;
}

const char *image_size_remedy_thesis(const pack_options *o) {
    return o->build == PLT_BUILD_HOST && o->leaf_triangles < 4
               ? "use --nodes compact, a larger --leaf, or --reduce"
               : "use --nodes compact, or --reduce";
}

const char *image_size_remedy_compact(const compact_options *o) {
    return o->build == PLT_BUILD_DEVICE ? "use --build host, at most 16 bits, or --reduce"
           : o->floats                  ? "use --geometry lattice, or --reduce"
           : o->numbers                 ? "use --numbers none, or --reduce"
                                        : "use --reduce";
}

int image_size_check(const char *name, uint64_t triangles, uint64_t bytes, int at_least,
                     const char *remedy, fail *f) {
    if (triangles > PLT_INDEX_MAX) {
        return fail_set(f, name,
                        "%" PRIu64
                        " triangles: an image holds at most %u; use --reduce, or pack "
                        "parts of it",
                        triangles, PLT_INDEX_MAX);
    }
    if (bytes > UINT32_MAX) {
        return fail_set(f, name,
                        "%" PRIu64 " triangles: the image would have %s%" PRIu64
                        " bytes, and must have fewer than 4294967296; %s",
                        triangles, at_least ? "at least " : "", bytes, remedy);
    }
    return 0;
}

static int check_blocks(const char *name, uint64_t triangles, uint64_t bytes, fail *f) {
    if (bytes > PLT_BLOCKS_BYTES_MAX) {
        return fail_set(f, name,
                        "%" PRIu64 " triangles: the blocks would have at least %" PRIu64
                        " bytes, and must have at most %u; use a larger --leaf, --nodes thesis, "
                        "or --reduce",
                        triangles, bytes, PLT_BLOCKS_BYTES_MAX);
    }
    return 0;
}

int image_size_check_thesis(const char *name, uint64_t triangles, const pack_options *o, fail *f) {
    return image_size_check(name, triangles, least_thesis(triangles, o), 1,
                            image_size_remedy_thesis(o), f);
}

int image_size_check_lattice(const char *name, uint64_t triangles, const compact_options *o,
                             uint32_t width, fail *f) {
    return image_size_check(name, triangles, least_compact(triangles, o, width), 1,
                            image_size_remedy_compact(o), f) == 0
               ? check_blocks(name, triangles, least_blocks(triangles, o), f)
               : -1;
}

int image_size_check_compact(const char *name, uint64_t triangles, const compact_options *o,
                             fail *f) {
    return o->floats ? image_size_check_lattice(name, triangles, o, 0, f)
                     : image_size_check(name, triangles, 0, 1, "", f);
}
