/* header_at - where the fields of the header lie (SPEC.md, section 2)
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_IMAGE_HEADER_AT_H
#define PLT_IMAGE_HEADER_AT_H

enum plt_header_at {
    PLT_AT_VERSION = 8,
    PLT_AT_HEADER_BYTES = 12,
    PLT_AT_IMAGE_BYTES = 16,
    PLT_AT_HEADER_CRC = 20,
    PLT_AT_COUNTS = 24, /* 11 words, see `count_field` */
    PLT_AT_ROOT = 68,
    PLT_AT_LO = 72,
    PLT_AT_HI = 84,
    PLT_AT_SPLITS = 96,
    PLT_AT_BUILD = 97,
    PLT_AT_NODE_FORMAT = 98,
    PLT_AT_GEOMETRY_FORMAT = 99,
    PLT_AT_SECTIONS = 100,
    PLT_AT_SECTION = 104, /* 16 bytes each, four */
    PLT_AT_ORIGIN = 168,
    PLT_AT_STEP = 180,
    PLT_AT_BITS = 184,
    PLT_AT_LATTICE_BOX = 188,
    PLT_AT_VERTICES = 188, /* of a sequence, in thesis images; there is no lattice box there */
    PLT_AT_FRAMES = 192,
    PLT_AT_FRAME_RATE = 196,
    PLT_AT_KEY_EVERY = 200,
    PLT_AT_FRAME_BYTES = 204,
    PLT_AT_SEQUENCE_END = 208,
    PLT_AT_BLOCK_VERTICES = 208, /* of a sequence of compact blocks */
    PLT_AT_BODIES = 188,         /* of instances, in thesis images: there are no vertices */
    PLT_AT_INSTANCES = 208,      /* behind the other fields of a sequence */
    PLT_AT_PLACED_TRIANGLES = 212,
    PLT_AT_INSTANCES_END = 216,
    PLT_AT_SOURCE_TRIANGLES = 212,
    PLT_AT_PRIMITIVE_ID_BITS = 216,
    PLT_AT_NODE_BYTES = 220,
    PLT_AT_TRIANGLE_BYTES = 224,
    PLT_AT_RESERVED = 228,
    PLT_AT_FURTHER = 228, /* how many sections there are behind those of the table */
    PLT_AT_SHIFT = 232    /* three doubles, not for the engine; they end the header */
};

#endif
