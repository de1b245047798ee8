/* header_sections - the sections of an image, and how large they are
 *
 * SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "engine/base/bits.h"
#include "engine/image/header.h"
#include "engine/image/items.h"

static uint64_t padded(uint64_t bytes) {
    return (bytes + PLT_SECTION_ALIGN - 1) & ~(uint64_t)(PLT_SECTION_ALIGN - 1);
}

uint64_t plt_section_bytes(uint32_t count, uint32_t item_bytes) {
    return padded((uint64_t)count * item_bytes);
}

unsigned plt_header_kinds(const plt_info *info, uint32_t kind[PLT_SECTIONS_MOST]) {
    unsigned count = 0;
    if (info->nodes_format == PLT_NODES_THESIS) {
        kind[count++] = PLT_SECTION_NODES;
        kind[count++] = PLT_SECTION_TRIANGLES;
        if (info->has_checks && info->build == PLT_BUILD_HOST) {
            kind[count++] = PLT_SECTION_CHECKS;
        }
#if PLT_WITH_INSTANCES
        if (info->instances > 0) {
            kind[count++] = PLT_SECTION_BODIES;
            kind[count++] = PLT_SECTION_MATRICES;
            return count;
        }
#endif
#if PLT_WITH_SEQUENCE
        if (info->frames > 0 && !info->has_checks) { /* there are not both */
            kind[count++] = PLT_SECTION_TOPOLOGY;
            kind[count++] = PLT_SECTION_FRAMES;
        }
#endif
    } else {
        kind[count++] = info->build == PLT_BUILD_DEVICE ? (uint32_t)PLT_SECTION_CORNERS
                                                        : plt_header_blocks_kind(info);
        if (info->geometry_format == PLT_GEOMETRY_FLOAT) {
            kind[count++] = PLT_SECTION_TRIANGLES;
        }
        if (info->primitive_id_bits > 0) {
            kind[count++] = PLT_SECTION_PRIMITIVE_IDS;
        }
#if PLT_WITH_BLOCK_MOTION
        if (plt_header_moves(info) && !plt_header_has_stills(info)) {
            kind[count++] = PLT_SECTION_TOPOLOGY;
            kind[count++] = PLT_SECTION_FRAMES;
        }
#endif
    }
    return count;
}

uint32_t plt_header_records(const plt_info *info) {
    const int pages = info->has_checks && info->nodes_format == PLT_NODES_THESIS;
    return pages ? (info->triangles + PLT_PAGE_RECORDS - 1) & ~(PLT_PAGE_RECORDS - 1)
                 : info->triangles;
}

uint64_t plt_header_section_bytes(const plt_info *info, uint32_t kind) {
    const uint64_t used = (uint64_t)info->node_bytes + info->triangle_bytes;
    switch (kind) {
    case PLT_SECTION_NODES:
        return plt_section_bytes(info->node_slots, PLT_NODE_BYTES);
    case PLT_SECTION_TRIANGLES:
        return plt_section_bytes(plt_header_records(info), PLT_RECORD_BYTES);
    case PLT_SECTION_CHECKS:
        return plt_section_bytes(info->node_slots, 1);
    case PLT_SECTION_CORNERS:
        return plt_section_bytes(info->triangles, plt_corners_bytes(info->lattice_bits));
#if PLT_WITH_SEQUENCE
    case PLT_SECTION_TOPOLOGY:
        return padded((plt_header_numbers(info) * plt_index_bits(info->vertices) + 7) / 8 +
                      PLT_BITS_BEHIND);
    case PLT_SECTION_FRAMES:
        return padded((uint64_t)info->frame_bytes + PLT_BITS_BEHIND);
#endif
#if PLT_WITH_STILLS
    case PLT_SECTION_STILLS:
        return padded(used * info->frames + PLT_BITS_BEHIND);
#endif
#if PLT_WITH_INSTANCES
    case PLT_SECTION_BODIES:
        return padded((uint64_t)info->bodies * PLT_BODY_BYTES + 4 * (uint64_t)info->instances);
    case PLT_SECTION_MATRICES:
        return padded(info->frame_bytes);
#endif
    case PLT_SECTION_PRIMITIVE_IDS:
        return padded(((uint64_t)info->triangles * info->primitive_id_bits + 7) / 8 +
                      PLT_BITS_BEHIND);
    default:
        return padded(used + PLT_BITS_BEHIND);
    }
}

#if PLT_WITH_FURTHER
uint32_t plt_header_end(const plt_info *info) {
    uint32_t kind[PLT_SECTIONS_MOST];
    uint64_t end = PLT_HEADER_BYTES;
    for (unsigned i = plt_header_kinds(info, kind); i-- > 0;) {
        end += plt_header_section_bytes(info, kind[i]);
    }
    return end < UINT32_MAX ? (uint32_t)end : UINT32_MAX;
}
#endif

const plt_section *plt_header_section(const plt_header *header, uint32_t kind) {
    for (unsigned i = 0; i < PLT_SECTIONS_MOST; i++) {
        if (header->section[i].kind == kind) {
            return &header->section[i];
        }
    }
    return NULL;
}
