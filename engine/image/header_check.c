/* header_check - may an engine rely on this header?
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/bytes.h"
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/header.h"
#include "engine/image/header_at.h"
#include "engine/image/items.h"

static int is_number_between(float x, float least, float most) {
    return x >= least && x <= most;
}

/* The lattice (the scene's quantisation grid) has the scene's box, or one around it where
 * triangles lie between its points. False for NaN. */
static int boxes_agree(const plt_header *h) {
    const plt_info *info = &h->info;
    plt_box box;
    plt_lattice_to_box(&h->lattice, &h->lattice_box, &box);
    for (int a = 0; a < 3 && info->triangles > 0; a++) {
        const int same = box.lo[a] == info->lo[a] && box.hi[a] == info->hi[a];
        const int around = box.lo[a] <= info->lo[a] && info->hi[a] <= box.hi[a];
        if (!(info->geometry_format != PLT_GEOMETRY_FLOAT ? same : around)) {
            return 0;
        }
    }
    return 1;
}

/* Coordinates become exact floats, and the lattice's box holds what it must. */
static int lattice_in_range(const plt_header *h) {
    const plt_lattice *l = &h->lattice;
    int good = l->bits >= PLT_LATTICE_BITS_LEAST && l->bits <= PLT_LATTICE_BITS_MOST &&
               is_number_between(l->step, 1.0e-30f, PLT_COORD_MAX);
    for (int a = 0; a < 3; a++) {
        good &= is_number_between(l->origin[a], -PLT_COORD_MAX, PLT_COORD_MAX);
        good &= h->info.triangles == 0 ||
                (h->lattice_box.lo[a] <= h->lattice_box.hi[a] && l->bits <= PLT_LATTICE_BITS_MOST &&
                 h->lattice_box.hi[a] < 1u << l->bits);
    }
    return good;
}

/* An entry of the primitive ids holds an id and two bits of rotation. */
static int id_bits_in_range(const plt_info *info) {
    return (info->primitive_id_bits == 0 && !info->has_checks) ||
           (info->primitive_id_bits >= 2 && info->primitive_id_bits <= 29 &&
            info->build == PLT_BUILD_HOST && info->geometry_format != PLT_GEOMETRY_FLOAT);
}

/* What a compact image may hold beside the lattice. */
static int blocks_in_range(const plt_info *info) {
    return info->leaf_triangles <= 4 && info->leaf_triangles != 3 &&
           info->treelet_nodes == PLT_BLOCK_NODES_MOST && info->build != PLT_BUILD_NONE &&
           info->node_bytes <= PLT_BLOCKS_BYTES_MAX && info->triangle_bytes <= PLT_BLOCKS_BYTES_MAX;
}

/* R14, of compact images only. */
static int check_lattice(const plt_header *h, plt_fault *fault) {
    if (!lattice_in_range(h) || !blocks_in_range(&h->info) || !id_bits_in_range(&h->info)) {
        return plt_refused(fault, PLT_R14_LATTICE, PLT_AT_ORIGIN,
                           "the lattice, or what lies on it, is out of range");
    }
    if (!boxes_agree(h)) {
        return plt_refused(fault, PLT_R14_LATTICE, PLT_AT_LATTICE_BOX,
                           "the lattice's box is not that of the scene");
    }
    return PLT_OK;
}

#if PLT_WITH_SEQUENCE
/* All coordinates that a sequence's lattice has are in range; without one there is nothing of it.
 */
static int is_sequence_lattice(const plt_header *h) {
    const plt_lattice *l = &h->lattice;
    int good = l->bits >= PLT_LATTICE_BITS_LEAST && l->bits <= PLT_LATTICE_BITS_MOST &&
               is_number_between(l->step, 1.0e-30f, PLT_COORD_MAX);
    if (l->bits == 0) {
        return l->step == 0 && l->origin[0] == 0 && l->origin[1] == 0 && l->origin[2] == 0;
    }
    for (int a = 0; a < 3 && good; a++) {
        good = is_number_between(l->origin[a], -PLT_COORD_MAX, PLT_COORD_MAX) &&
               plt_lattice_float(l, a, (1u << l->bits) - 1) <= PLT_COORD_MAX;
    }
    return good;
}

static int refused_sequence(plt_fault *fault) {
    return plt_refused(fault, PLT_R15_SEQUENCE, PLT_AT_VERTICES,
                       "a count of the sequence, or its lattice, is out of range");
}

/* R15, of images with a sequence. */
static int check_sequence(const plt_header *h, plt_fault *fault) {
    const plt_info *info = &h->info;
    const int counts = info->triangles > 0 && info->vertices > 0 &&
                       info->vertices <= PLT_INDEX_MAX && info->key_every > 0 &&
                       info->frame_rate > 0 && info->frame_rate <= PLT_FRAME_RATE_MOST &&
                       (plt_header_has_stills(info) ? info->frame_bytes == 0
                                                    : info->frame_bytes / 4 > info->frames);
#if PLT_WITH_BLOCK_MOTION
    if (plt_header_moves(info) &&
        (info->frames == 0 || (info->has_checks && !plt_header_has_stills(info)) ||
         info->block_vertices > 3 * info->triangles)) {
        return refused_sequence(fault);
    }
#endif
    return counts && is_sequence_lattice(h) ? PLT_OK : refused_sequence(fault);
}
#endif

#if PLT_WITH_INSTANCES
/* R16, of images with instances: matrices are all that differs from frame to frame. */
static int check_instances(const plt_header *h, plt_fault *fault) {
    const plt_info *info = &h->info;
    const uint64_t bytes =
        info->frames * (PLT_MATRICES_HEAD + (uint64_t)info->instances * PLT_MATRIX_BYTES);
    const int counts = info->bodies > 0 && info->bodies <= info->triangles &&
                       info->instances <= PLT_INSTANCES_MOST &&
                       info->placed_triangles >= info->instances &&
                       info->placed_triangles <= PLT_PLACED_MOST && info->frames > 0 &&
                       info->frame_rate > 0 && info->frame_rate <= PLT_FRAME_RATE_MOST;
    const int rest = info->key_every == 1 && bytes == info->frame_bytes &&
                     info->build == PLT_BUILD_HOST && info->nodes_format == PLT_NODES_THESIS &&
                     h->root == PLT_LINK_NONE;
    return counts && rest ? PLT_OK
                          : plt_refused(fault, PLT_R16_INSTANCES, PLT_AT_INSTANCES,
                                        "a count of bodies, instances or frames is out of range");
}
#endif

/* R7 to R9, R14 to R16: values whose range does not depend on the rest of the image. */
static int check_values(const plt_header *h, plt_fault *fault) {
    const plt_info *info = &h->info;
    if (info->triangles > PLT_INDEX_MAX || info->node_slots > PLT_INDEX_MAX) {
        return plt_refused(fault, PLT_R7_COUNTS, PLT_AT_COUNTS,
                           "more than 2^27 - 1 triangles or nodes");
    }
    if (info->leaf_triangles < 1 || info->treelet_nodes < 1 ||
        info->treelet_nodes > PLT_INDEX_MAX || info->nodes > info->node_slots ||
        (info->nodes_format == PLT_NODES_THESIS && info->node_slots % info->treelet_nodes != 0)) {
        return plt_refused(fault, PLT_R7_COUNTS, PLT_AT_COUNTS, "a count is out of range");
    }
    if (info->build != PLT_BUILD_HOST && (info->node_slots != 0 || info->treelets != 0)) {
        return plt_refused(fault, PLT_R7_COUNTS, PLT_AT_COUNTS + 4,
                           "nodes in an image without a tree");
    }
    if (info->build == PLT_BUILD_DEVICE && h->root != PLT_LINK_NONE) {
        return plt_refused(fault, PLT_R7_COUNTS, PLT_AT_ROOT, "a root in an image without a tree");
    }
    if (info->splits > PLT_SPLIT_MEDIAN || info->build > PLT_BUILD_NONE ||
        info->nodes_format > PLT_NODES_COMPACT ||
        (info->geometry_format > info->nodes_format && !plt_header_moves(info)) ||
        (info->nodes_format != info->geometry_format && info->build != PLT_BUILD_HOST)) {
        return plt_refused(fault, PLT_R8_FORMATS, PLT_AT_SPLITS,
                           "a format that this version does not know");
    }
    const int lattice = info->nodes_format == PLT_NODES_COMPACT ? check_lattice(h, fault) : PLT_OK;
    if (lattice != PLT_OK) {
        return lattice;
    }
    for (int a = 0; a < 3 && info->triangles > 0; a++) {
        const float lo = info->lo[a], hi = info->hi[a];
        if (!(lo >= -PLT_COORD_MAX && lo <= hi && hi <= PLT_COORD_MAX)) {
            return plt_refused(fault, PLT_R9_BOX, PLT_AT_LO, "the scene's box is not a box");
        }
    }
#if PLT_WITH_INSTANCES
    if (info->instances > 0) {
        return check_instances(h, fault);
    }
#endif
#if PLT_WITH_SEQUENCE
    if (info->frames > 0 || plt_header_moves(info)) {
        return check_sequence(h, fault);
    }
#endif
    return PLT_OK;
}

/* Behind the section table and the reserved bytes: where the first ones that are used begin and
 * end. */
static unsigned used_begin_of(const plt_info *info) {
    return PLT_WITH_INSTANCES && info->instances > 0 ? PLT_AT_BODIES : PLT_AT_ORIGIN;
}

static unsigned used_end_of(const plt_info *info) {
    if (info->nodes_format == PLT_NODES_COMPACT) {
        return PLT_AT_RESERVED;
    }
    if (PLT_WITH_INSTANCES && info->instances > 0) {
        return PLT_AT_INSTANCES_END;
    }
    return PLT_WITH_SEQUENCE && info->frames > 0 ? PLT_AT_SEQUENCE_END : 0;
}

/* A constant where there are none. */
#if PLT_WITH_FURTHER
#define HAS_FURTHER(h) ((h)->further_count > 0)
#else
#define HAS_FURTHER(h) 0
#endif

/* R10 to R12: the sections lie where they must and fill the image. */
static int check_sections(const plt_header *h, const unsigned char *bytes, plt_fault *fault) {
    uint32_t kind[PLT_SECTIONS_MOST] = {0, 0, 0, 0};
    const unsigned count = plt_header_kinds(&h->info, kind);
    uint64_t offset = PLT_HEADER_BYTES;
    if (plt_get_u32(bytes + PLT_AT_SECTIONS) != count) {
        return plt_refused(fault, PLT_R10_SECTIONS, PLT_AT_SECTIONS,
                           "the number of sections is wrong");
    }
    for (unsigned i = 0; i < count; i++) {
        const plt_section *s = &h->section[i];
        const uint64_t due = plt_header_section_bytes(&h->info, kind[i]);
        if (s->kind != kind[i] || s->offset != offset || s->bytes != due) {
            return plt_refused(fault, PLT_R11_SECTION, PLT_AT_SECTION + 16u * i,
                               "a section is not where or what it must be");
        }
        offset += due;
    }
    if (HAS_FURTHER(h) && offset > h->info.image_bytes) {
        return plt_refused(fault, PLT_R17_FURTHER, PLT_AT_IMAGE_BYTES,
                           "the image ends before its table of further sections");
    }
    if (offset != h->info.image_bytes && !HAS_FURTHER(h)) {
        return plt_refused(fault, PLT_R11_SECTION, PLT_AT_IMAGE_BYTES,
                           "the sections do not fill the image");
    }
    const unsigned used_begin = used_begin_of(&h->info), used_end = used_end_of(&h->info);
    for (unsigned i = PLT_AT_SECTION + 16 * count; i < PLT_AT_SHIFT; i++) {
        const int used =
            (i >= used_begin && i < used_end) || (PLT_WITH_FURTHER && i >= PLT_AT_FURTHER);
        if (!used && bytes[i] != 0) {
            return plt_refused(fault, PLT_R12_RESERVED, i, "a reserved byte is not zero");
        }
    }
    return PLT_OK;
}

int plt_header_check(const plt_header *header, const unsigned char bytes[PLT_HEADER_BYTES],
                     plt_fault *fault) {
    const int values = check_values(header, fault);
    return values == PLT_OK ? check_sections(header, bytes, fault) : values;
}
