/* header - the 256 bytes that an image begins with
 *
 * Byte offsets of SPEC.md, section 2; reading and writing them here means
 * that packer and engine cannot disagree.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_IMAGE_HEADER_H
#define PLT_IMAGE_HEADER_H

#include <stdint.h>

#include "engine/base/lattice.h"
#include "engine/planelet.h"

/* Version of the image format, which is not that of the interface (planelet.h). */
#define PLT_IMAGE_MAJOR 1
#define PLT_IMAGE_MINOR 0

#define PLT_HEADER_BYTES 256
#define PLT_SECTION_ALIGN 64
#define PLT_SECTIONS_MOST 4
#define PLT_FURTHER_MOST 7 /* whose table has 128 bytes at most */

enum plt_section_kind {
    PLT_SECTION_NONE = 0,
    PLT_SECTION_NODES = 1,         /* thesis nodes in their slots */
    PLT_SECTION_TRIANGLES = 2,     /* float records */
    PLT_SECTION_BLOCKS = 3,        /* compact blocks */
    PLT_SECTION_PRIMITIVE_IDS = 4, /* primitive ids (primitive_id.h) */
    PLT_SECTION_CORNERS = 5,       /* lattice corners, for the device to build from */
    PLT_SECTION_CHECKS = 6,        /* of thesis nodes, a byte each (thesis/checks.h) */
    PLT_SECTION_TOPOLOGY = 7,      /* of a sequence: vertices of each triangle */
    PLT_SECTION_FRAMES = 8,        /* ... and their positions, frame by frame */
    PLT_SECTION_STILLS = 9,        /* compact blocks, all of them once for each frame */
    PLT_SECTION_BODIES = 10,       /* of instances: bodies, and which one each has */
    PLT_SECTION_MATRICES = 11,     /* ... and where they are, frame by frame */
    PLT_SECTION_NORMALS = 12,      /* further ones: normals of corners */
    PLT_SECTION_COLOURS = 13,      /* ... and their colours */
    PLT_SECTION_MATERIALS = 14,    /* ... and what triangles are made of */
    PLT_SECTION_TEXCOORDS = 15,    /* ... and where textures lie on them */
    PLT_SECTION_TEXTURES = 16,     /* ... and textures, and which materials have them */
    PLT_SECTION_TILES = 17,        /* ... and their texels */
    PLT_SECTION_PAGES = 18,        /* ... and all that corners have, page by page */
};

typedef struct plt_section {
    uint32_t kind, offset, bytes, crc;
} plt_section;

typedef struct plt_header {
    plt_info info;
    uint32_t root;
    plt_section section[PLT_SECTIONS_MOST]; /* as they lie; PLT_SECTION_NONE behind */
    plt_lattice lattice;
    plt_lattice_box lattice_box; /* of all triangles */
#if PLT_WITH_FURTHER
    uint32_t further_at;                   /* byte of the image where the others end */
    uint32_t further_count;                /* 0: there is no table */
    plt_section further[PLT_FURTHER_MOST]; /* plt_further_read; PLT_SECTION_NONE behind */
#endif
} plt_header;

/* An image of compact blocks that move: its header has the counts of a sequence where others have
 * the lattice's box. */
static inline int plt_header_moves(const plt_info *info) {
    return PLT_WITH_BLOCK_MOTION && info->nodes_format == PLT_NODES_COMPACT &&
           (info->geometry_format == PLT_GEOMETRY_MOVING ||
            (PLT_WITH_STILLS && info->geometry_format == PLT_GEOMETRY_STILLS));
}

/* ... whose frames are blocks, each, instead of differences. */
static inline int plt_header_has_stills(const plt_info *info) {
    return PLT_WITH_STILLS && info->nodes_format == PLT_NODES_COMPACT &&
           info->geometry_format == PLT_GEOMETRY_STILLS;
}

/* The section of blocks, or of those of frame 0. */
static inline uint32_t plt_header_blocks_kind(const plt_info *info) {
    return plt_header_has_stills(info) ? PLT_SECTION_STILLS : PLT_SECTION_BLOCKS;
}

/* Numbers of vertices in the topology of a sequence: three per triangle, or one for each vertex of
 * each block. */
static inline uint64_t plt_header_numbers(const plt_info *info) {
    return plt_header_moves(info) ? info->block_vertices : (uint64_t)info->triangles * 3;
}

/* The sections that an image of these formats has, in order; returns how many. */
unsigned plt_header_kinds(const plt_info *info, uint32_t kind[PLT_SECTIONS_MOST]);

/* Bytes of a section, padding included. */
uint64_t plt_header_section_bytes(const plt_info *info, uint32_t kind);

/* Float records there, with those that fill up the last page of records with checks. */
uint32_t plt_header_records(const plt_info *info);

/* The section of a kind, or NULL. */
const plt_section *plt_header_section(const plt_header *header, uint32_t kind);

#if PLT_WITH_FURTHER
/* Where the sections of the header's table end, if an image is that long. */
uint32_t plt_header_end(const plt_info *info);
#endif

/* Bytes of a section of `count` items, padding included. */
uint64_t plt_section_bytes(uint32_t count, uint32_t item_bytes);

/* Checks R1 .. R12 and R14 .. R16 of SPEC.md and fills `header`; `image_bytes` is what the
 * source says it has. Touches `bytes` only. */
int plt_header_read(plt_header *header, const unsigned char bytes[PLT_HEADER_BYTES],
                    uint32_t image_bytes, plt_fault *fault);

/* R7 to R12 and R14 to R16 alone, of a header that has been read from `bytes`. */
int plt_header_check(const plt_header *header, const unsigned char bytes[PLT_HEADER_BYTES],
                     plt_fault *fault);

/* The same 256 bytes from `header`, its CRC included. Offsets and sizes of
 * the sections are worked out here; their CRCs are the caller's. */
void plt_header_write(unsigned char bytes[PLT_HEADER_BYTES], plt_header *header);

/* Makes the header's checksum right again after a change of its bytes. */
void plt_header_seal(unsigned char bytes[PLT_HEADER_BYTES]);

#endif
