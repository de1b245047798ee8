/* rules - the numbers of the rules that SPEC.md, section 5, gives
 *
 * R1 to R21 refuse an image by its header and checksums, I1 to I31 are invariants of
 * what its sections hold. SPEC.md has each in full; here they have names.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_RULES_H
#define PLT_BASE_RULES_H

enum plt_refusal {
    PLT_R1_SHORT = 1,         /* fewer bytes than a header */
    PLT_R2_MAGIC = 2,         /* no image of ours */
    PLT_R3_VERSION = 3,       /* of the image format */
    PLT_R4_HEADER_BYTES = 4,  /* size of the header */
    PLT_R5_HEADER_CRC = 5,    /* its checksum */
    PLT_R6_IMAGE_BYTES = 6,   /* size of the image */
    PLT_R7_COUNTS = 7,        /* counts out of range, K, N, the root */
    PLT_R8_FORMATS = 8,       /* formats that this version does not know */
    PLT_R9_BOX = 9,           /* the scene's box */
    PLT_R10_SECTIONS = 10,    /* how many sections */
    PLT_R11_SECTION = 11,     /* kind, offset and size of each */
    PLT_R12_RESERVED = 12,    /* bytes that must be zero */
    PLT_R13_SECTION_CRC = 13, /* checksum of a section */
    PLT_R14_LATTICE = 14,     /* the lattice and what a compact image may hold */
    PLT_R15_SEQUENCE = 15,    /* counts and lattice of a sequence */
    PLT_R16_INSTANCES = 16,   /* counts of bodies, instances and their frames */
    PLT_R17_FURTHER = 17,     /* the table of further sections */
    PLT_R18_SURFACE = 18,     /* what a section of normals or colours begins with */
    PLT_R19_MATERIALS = 19,   /* the section of materials */
    PLT_R20_TEXTURES = 20,    /* the section of textures, and of which materials have them */
    PLT_R21_PAGES = 21        /* what a section of pages begins with */
};

enum plt_invariant {
    PLT_I1_LINKS = 1,        /* links lead to nodes that are there, and say in which treelet */
    PLT_I2_TREE = 2,         /* the nodes form a tree */
    PLT_I3_LIST_ENDS = 3,    /* lists end before the last record does */
    PLT_I4_LIST_ORDER = 4,   /* lists follow each other and hold every record */
    PLT_I5_CORNERS = 5,      /* corners of records lie in the scene's box */
    PLT_I6_PLANES = 6,       /* planes lie in the scene's box */
    PLT_I7_ID_WORDS = 7,     /* primitive ids and rotations of records are in range */
    PLT_I8_COUNTS = 8,       /* the header's counts are the tree's */
    PLT_I10_SIZES = 10,      /* the parts fit the block's sizes and the section */
    PLT_I11_KINDS = 11,      /* n - 1 inner children, in breadth-first order */
    PLT_I12_BOUNDS = 12,     /* the bounds are a box inside the scene's */
    PLT_I13_CHECK = 13,      /* the checks of its parts are right */
    PLT_I14_GEOMETRY = 14,   /* counts, strips and vertices fit the geometry part */
    PLT_I15_LEAVES = 15,     /* every leaf begins a strip and has at most 2 K triangles */
    PLT_I16_REFERENCES = 16, /* references name vertices already met */
    PLT_I17_LINKS = 17,      /* links lead forward, to each block once */
    PLT_I18_COUNTS = 18,     /* the header's counts are the blocks' */
    PLT_I19_IDS = 19,        /* entries of the primitive ids are in range */
    PLT_I20_CORNERS = 20,    /* lattice corners lie in the lattice's box */
    PLT_I21_VERTICES = 21,   /* vertices lie inside the bounds */
    PLT_I22_CHECKS = 22,     /* checks of nodes and records that come part by part are right */
    PLT_I23_OFFSETS = 23,    /* frames of a sequence follow each other within the section */
    PLT_I24_TOPOLOGY = 24,   /* triangles of a sequence have vertices that are there */
    PLT_I25_FRAME = 25,      /* blocks of a frame fill it, and their checks are right */
    PLT_I26_POSITIONS = 26,  /* positions of a frame are within 2^40 */
    PLT_I27_BODIES = 27,   /* bodies follow each other and fill the sections; instances have one */
    PLT_I28_MATRICES = 28, /* the check of a frame of matrices is right */
    PLT_I29_PLACED = 29,   /* matrices can be inverted, and place bodies within 2^40 */
    PLT_I30_TILES = 30,    /* the check of a tile that is fetched is right */
    PLT_I31_PAGES = 31     /* pages of what corners have, and where they are, are right */
};

#endif
