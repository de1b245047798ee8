/* header - see header.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/image/header.h"

#include "engine/image/bytes.h"
#include "engine/image/crc32.h"
#include "engine/image/fault.h"
#include "engine/tree/block.h"
#include "engine/tree/node.h"
#include "engine/tree/record.h"

static const unsigned char magic[8] = {'P', 'L', 'A', 'N', 'E', 'L', 'E', 'T'};

/* SPEC.md, section 2. */
enum at {
    AT_VERSION = 8,
    AT_HEADER_BYTES = 12,
    AT_IMAGE_BYTES = 16,
    AT_HEADER_CRC = 20,
    AT_COUNTS = 24, /* 11 words, see `counts` */
    AT_ROOT = 68,
    AT_LO = 72,
    AT_HI = 84,
    AT_SPLITS = 96,
    AT_BUILD = 97,
    AT_NODE_FORMAT = 98,
    AT_GEOMETRY_FORMAT = 99,
    AT_SECTIONS = 100,
    AT_SECTION = 104, /* 16 bytes each, four */
    AT_ORIGIN = 168,
    AT_STEP = 180,
    AT_BITS = 184,
    AT_LATTICE_BOX = 188,
    AT_SOURCE_TRIANGLES = 212,
    AT_NUMBER_BITS = 216,
    AT_NODE_BYTES = 220,
    AT_TRIANGLE_BYTES = 224,
    AT_RESERVED = 228
};

#define COUNTS 11

static uint32_t *count_field(plt_info *info, int i) {
    uint32_t *const field[COUNTS] = {
        &info->triangles,           &info->nodes,
        &info->node_slots,          &info->leaf_lists,
        &info->intermediate_lists,  &info->treelets,
        &info->treelet_nodes,       &info->leaf_triangles,
        &info->local_stack_entries, &info->global_stack_entries,
        &info->depth_stack_entries,
    };
    return field[i];
}

uint64_t plt_section_bytes(uint32_t count, uint32_t item_bytes) {
    const uint64_t bytes = (uint64_t)count * item_bytes;
    return (bytes + PLT_SECTION_ALIGN - 1) & ~(uint64_t)(PLT_SECTION_ALIGN - 1);
}

unsigned plt_header_kinds(const plt_info *info, uint32_t kind[PLT_SECTIONS_MOST]) {
    unsigned count = 0;
    if (info->nodes_format == PLT_NODES_THESIS) {
        kind[count++] = PLT_SECTION_NODES;
        kind[count++] = PLT_SECTION_TRIANGLES;
    } else {
        kind[count++] = info->build == PLT_BUILD_DEVICE ? PLT_SECTION_CORNERS : PLT_SECTION_BLOCKS;
        if (info->geometry_format == PLT_GEOMETRY_FLOAT) {
            kind[count++] = PLT_SECTION_TRIANGLES;
        }
    }
    if (info->number_bits > 0) {
        kind[count++] = PLT_SECTION_NUMBERS;
    }
    return count;
}

/* Readers of bits look a little behind the last one. */
#define BEHIND 8

uint64_t plt_header_section_bytes(const plt_info *info, uint32_t kind) {
    const uint64_t used = (uint64_t)info->node_bytes + info->triangle_bytes;
    switch (kind) {
    case PLT_SECTION_NODES:
        return plt_section_bytes(info->node_slots, PLT_NODE_BYTES);
    case PLT_SECTION_TRIANGLES:
        return plt_section_bytes(info->triangles, PLT_RECORD_BYTES);
    case PLT_SECTION_CORNERS:
        return plt_section_bytes(info->triangles, info->lattice_bits <= 16 ? 18 : 36);
    case PLT_SECTION_NUMBERS:
        return (((uint64_t)info->triangles * info->number_bits + 7) / 8 + BEHIND + 63) & ~63ull;
    default:
        return (used + BEHIND + 63) & ~63ull;
    }
}

const plt_section *plt_header_section(const plt_header *header, uint32_t kind) {
    for (unsigned i = 0; i < PLT_SECTIONS_MOST; i++) {
        if (header->section[i].kind == kind) {
            return &header->section[i];
        }
    }
    return NULL;
}

static uint32_t header_crc(const unsigned char *bytes) {
    const unsigned char zero[4] = {0, 0, 0, 0};
    uint32_t crc = plt_crc32(0, bytes, AT_HEADER_CRC);
    crc = plt_crc32(crc, zero, sizeof zero);
    return plt_crc32(crc, bytes + AT_HEADER_CRC + 4, PLT_HEADER_BYTES - AT_HEADER_CRC - 4);
}

/* R2 to R6: is it one of our headers at all, whole and of this version? */
static int check_identity(const unsigned char *bytes, uint32_t image_bytes, plt_fault *fault) {
    if (memcmp(bytes, magic, sizeof magic) != 0) {
        return plt_refused(fault, 2, 0, "this is no Planelet scene image");
    }
    if (bytes[AT_VERSION] != PLT_VERSION_MAJOR || bytes[AT_VERSION + 1] != 0) {
        return plt_refused(fault, 3, AT_VERSION, "the image is of another version; pack it anew");
    }
    if (plt_get_u32(bytes + AT_HEADER_BYTES) != PLT_HEADER_BYTES) {
        return plt_refused(fault, 4, AT_HEADER_BYTES, "the header size is not 256");
    }
    if (header_crc(bytes) != plt_get_u32(bytes + AT_HEADER_CRC)) {
        return plt_refused(fault, 5, AT_HEADER_CRC, "the header is damaged (checksum)");
    }
    if (plt_get_u32(bytes + AT_IMAGE_BYTES) != image_bytes) {
        return plt_refused(fault, 6, AT_IMAGE_BYTES,
                           "the image is shorter or longer than its header says");
    }
    return PLT_OK;
}

static int is_number_between(float x, float least, float most) {
    return x >= least && x <= most;
}

/* R14: a lattice whose numbers become floats without surprise. */
static int check_lattice(const plt_header *h, plt_fault *fault) {
    const plt_lattice *l = &h->lattice;
    const plt_info *info = &h->info;
    int good = l->bits >= PLT_LATTICE_BITS_LEAST && l->bits <= PLT_LATTICE_BITS_MOST &&
               is_number_between(l->step, 1.0e-30f, PLT_COORD_MAX) && info->leaf_triangles <= 4 &&
               info->leaf_triangles != 3 && info->treelet_nodes == PLT_BLOCK_NODES_MOST &&
               info->build != PLT_BUILD_NONE;
    for (int a = 0; a < 3; a++) {
        good &= is_number_between(l->origin[a], -PLT_COORD_MAX, PLT_COORD_MAX);
        good &= info->triangles == 0 ||
                (h->lattice_box.lo[a] <= h->lattice_box.hi[a] && l->bits <= PLT_LATTICE_BITS_MOST &&
                 h->lattice_box.hi[a] < 1u << l->bits);
    }
    /* An entry of the numbers holds any number and two bits more. */
    good &= info->number_bits == 0 ||
            (info->number_bits >= 2 && info->number_bits <= 29 && info->build == PLT_BUILD_HOST &&
             info->geometry_format == PLT_GEOMETRY_LATTICE);
    if (!good || info->node_bytes > 8u * 0xFFFFFFu || info->triangle_bytes > 8u * 0xFFFFFFu) {
        return plt_refused(fault, 14, AT_ORIGIN,
                           "the lattice, or what lies on it, is out of range");
    }
    for (int a = 0; a < 3 && info->triangles > 0; a++) {
        if (plt_lattice_float(l, a, h->lattice_box.lo[a]) != info->lo[a] ||
            plt_lattice_float(l, a, h->lattice_box.hi[a]) != info->hi[a]) {
            return plt_refused(fault, 14, AT_LATTICE_BOX, "the scene's two boxes differ");
        }
    }
    return PLT_OK;
}

/* R7 to R9: values whose range does not depend on the rest of the image. */
static int check_values(const plt_header *h, plt_fault *fault) {
    const plt_info *info = &h->info;
    if (info->triangles > PLT_INDEX_MAX || info->node_slots > PLT_INDEX_MAX) {
        return plt_refused(fault, 7, AT_COUNTS, "more than 2^27 - 1 triangles or nodes");
    }
    if (info->leaf_triangles < 1 || info->treelet_nodes < 1 ||
        info->treelet_nodes > PLT_INDEX_MAX || info->nodes > info->node_slots ||
        (info->nodes_format == PLT_NODES_THESIS && info->node_slots % info->treelet_nodes != 0)) {
        return plt_refused(fault, 7, AT_COUNTS, "a count is out of range");
    }
    if (info->build != PLT_BUILD_HOST && (info->node_slots != 0 || info->treelets != 0)) {
        return plt_refused(fault, 7, AT_COUNTS + 4, "nodes in an image without a tree");
    }
    if (info->build == PLT_BUILD_DEVICE && h->root != PLT_LINK_NONE) {
        return plt_refused(fault, 7, AT_ROOT, "a root in an image without a tree");
    }
    if (info->splits > PLT_SPLIT_MEDIAN || info->build > PLT_BUILD_NONE ||
        info->nodes_format > PLT_NODES_COMPACT || info->geometry_format > info->nodes_format ||
        (info->nodes_format != info->geometry_format && info->build != PLT_BUILD_HOST)) {
        return plt_refused(fault, 8, AT_SPLITS, "a format that this version does not know");
    }
    const int lattice = info->nodes_format == PLT_NODES_COMPACT ? check_lattice(h, fault) : PLT_OK;
    if (lattice != PLT_OK) {
        return lattice;
    }
    for (int a = 0; a < 3 && info->triangles > 0; a++) {
        const float lo = info->lo[a], hi = info->hi[a];
        if (!(lo >= -PLT_COORD_MAX && lo <= hi && hi <= PLT_COORD_MAX)) {
            return plt_refused(fault, 9, AT_LO, "the scene's box is not a box");
        }
    }
    return PLT_OK;
}

/* R10 to R12: the sections lie where they must and fill the image. */
static int check_sections(const plt_header *h, const unsigned char *bytes, plt_fault *fault) {
    uint32_t kind[PLT_SECTIONS_MOST] = {0, 0, 0, 0};
    const unsigned count = plt_header_kinds(&h->info, kind);
    uint64_t offset = PLT_HEADER_BYTES;
    if (plt_get_u32(bytes + AT_SECTIONS) != count) {
        return plt_refused(fault, 10, AT_SECTIONS, "the number of sections is wrong");
    }
    for (unsigned i = 0; i < count; i++) {
        const plt_section *s = &h->section[i];
        const uint64_t due = plt_header_section_bytes(&h->info, kind[i]);
        if (s->kind != kind[i] || s->offset != offset || s->bytes != due) {
            return plt_refused(fault, 11, AT_SECTION + 16u * i,
                               "a section is not where or what it must be");
        }
        offset += due;
    }
    if (offset != h->info.image_bytes) {
        return plt_refused(fault, 11, AT_IMAGE_BYTES, "the sections do not fill the image");
    }
    const int lattice = h->info.nodes_format == PLT_NODES_COMPACT;
    for (unsigned i = AT_SECTION + 16 * count; i < PLT_HEADER_BYTES; i++) {
        const int used = lattice && i >= AT_ORIGIN && i < AT_RESERVED;
        if (!used && bytes[i] != 0) {
            return plt_refused(fault, 12, i, "a reserved byte is not zero");
        }
    }
    return PLT_OK;
}

static void read_lattice(plt_header *h, const unsigned char *bytes) {
    plt_get_floats(h->lattice.origin, bytes + AT_ORIGIN, 3);
    h->lattice.step = plt_get_float(bytes + AT_STEP);
    h->lattice.bits = plt_get_u32(bytes + AT_BITS);
    for (int a = 0; a < 3; a++) {
        h->lattice_box.lo[a] = plt_get_u32(bytes + AT_LATTICE_BOX + 4 * a);
        h->lattice_box.hi[a] = plt_get_u32(bytes + AT_LATTICE_BOX + 12 + 4 * a);
    }
    plt_info *info = &h->info;
    info->lattice_bits = (uint8_t)(h->lattice.bits <= 255 ? h->lattice.bits : 255);
    info->source_triangles = plt_get_u32(bytes + AT_SOURCE_TRIANGLES);
    const uint32_t number_bits = plt_get_u32(bytes + AT_NUMBER_BITS);
    info->number_bits = (uint8_t)(number_bits <= 255 ? number_bits : 255);
    info->node_bytes = plt_get_u32(bytes + AT_NODE_BYTES);
    info->triangle_bytes = plt_get_u32(bytes + AT_TRIANGLE_BYTES);
}

static void write_lattice(unsigned char *bytes, const plt_header *h) {
    plt_put_floats(bytes + AT_ORIGIN, h->lattice.origin, 3);
    plt_put_float(bytes + AT_STEP, h->lattice.step);
    plt_put_u32(bytes + AT_BITS, h->lattice.bits);
    for (int a = 0; a < 3; a++) {
        plt_put_u32(bytes + AT_LATTICE_BOX + 4 * a, h->lattice_box.lo[a]);
        plt_put_u32(bytes + AT_LATTICE_BOX + 12 + 4 * a, h->lattice_box.hi[a]);
    }
    plt_put_u32(bytes + AT_SOURCE_TRIANGLES, h->info.source_triangles);
    plt_put_u32(bytes + AT_NUMBER_BITS, h->info.number_bits);
    plt_put_u32(bytes + AT_NODE_BYTES, h->info.node_bytes);
    plt_put_u32(bytes + AT_TRIANGLE_BYTES, h->info.triangle_bytes);
}

int plt_header_read(plt_header *header, const unsigned char bytes[PLT_HEADER_BYTES],
                    uint32_t image_bytes, plt_fault *fault) {
    const int status = check_identity(bytes, image_bytes, fault);
    if (status != PLT_OK) {
        return status;
    }
    plt_info *info = &header->info;
    for (int i = 0; i < COUNTS; i++) {
        *count_field(info, i) = plt_get_u32(bytes + AT_COUNTS + 4 * i);
    }
    info->image_bytes = image_bytes;
    header->root = plt_get_u32(bytes + AT_ROOT);
    plt_get_floats(info->lo, bytes + AT_LO, 3);
    plt_get_floats(info->hi, bytes + AT_HI, 3);
    for (int a = 0; a < 3 && info->triangles == 0; a++) { /* whatever the bytes say */
        info->lo[a] = PLT_BOX_FAR;
        info->hi[a] = -PLT_BOX_FAR;
    }
    info->splits = bytes[AT_SPLITS];
    info->build = bytes[AT_BUILD];
    info->nodes_format = bytes[AT_NODE_FORMAT];
    info->geometry_format = bytes[AT_GEOMETRY_FORMAT];
    for (int i = 0; i < PLT_SECTIONS_MOST; i++) {
        const unsigned char *at = bytes + AT_SECTION + 16 * i;
        const plt_section s = {plt_get_u32(at), plt_get_u32(at + 4), plt_get_u32(at + 8),
                               plt_get_u32(at + 12)};
        header->section[i] = s;
    }
    read_lattice(header, bytes);
    if (info->nodes_format == PLT_NODES_THESIS) {
        info->node_bytes = header->section[0].bytes;
        info->triangle_bytes = header->section[1].bytes;
        info->source_triangles = info->triangles;
    }
    info->number_bytes =
        info->number_bits > 0 ? (uint32_t)plt_header_section_bytes(info, PLT_SECTION_NUMBERS) : 0;
    const int values = check_values(header, fault);
    return values == PLT_OK ? check_sections(header, bytes, fault) : values;
}

static void place_sections(plt_header *h) {
    uint32_t kind[PLT_SECTIONS_MOST] = {0, 0, 0, 0};
    const unsigned count = plt_header_kinds(&h->info, kind);
    uint32_t offset = PLT_HEADER_BYTES;
    for (unsigned i = 0; i < count; i++) {
        plt_section *s = &h->section[i];
        s->kind = kind[i];
        s->offset = offset;
        s->bytes = (uint32_t)plt_header_section_bytes(&h->info, kind[i]);
        offset += s->bytes;
    }
    if (h->info.nodes_format == PLT_NODES_THESIS) {
        h->info.node_bytes = h->section[0].bytes;
        h->info.triangle_bytes = h->section[1].bytes;
    }
    h->info.image_bytes = offset;
}

void plt_header_write(unsigned char bytes[PLT_HEADER_BYTES], plt_header *header) {
    plt_info *info = &header->info;
    place_sections(header);
    memset(bytes, 0, PLT_HEADER_BYTES);
    memcpy(bytes, magic, sizeof magic);
    bytes[AT_VERSION] = PLT_VERSION_MAJOR;
    bytes[AT_VERSION + 2] = PLT_VERSION_MINOR;
    plt_put_u32(bytes + AT_HEADER_BYTES, PLT_HEADER_BYTES);
    plt_put_u32(bytes + AT_IMAGE_BYTES, info->image_bytes);
    for (int i = 0; i < COUNTS; i++) {
        plt_put_u32(bytes + AT_COUNTS + 4 * i, *count_field(info, i));
    }
    plt_put_u32(bytes + AT_ROOT, header->root);
    plt_put_floats(bytes + AT_LO, info->lo, 3);
    plt_put_floats(bytes + AT_HI, info->hi, 3);
    bytes[AT_SPLITS] = info->splits;
    bytes[AT_BUILD] = info->build;
    bytes[AT_NODE_FORMAT] = info->nodes_format;
    bytes[AT_GEOMETRY_FORMAT] = info->geometry_format;
    uint32_t kind[PLT_SECTIONS_MOST];
    plt_put_u32(bytes + AT_SECTIONS, plt_header_kinds(info, kind));
    if (info->nodes_format == PLT_NODES_COMPACT) {
        write_lattice(bytes, header);
    }
    for (int i = 0; i < PLT_SECTIONS_MOST; i++) {
        unsigned char *at = bytes + AT_SECTION + 16 * i;
        const plt_section *s = &header->section[i];
        plt_put_u32(at, s->kind);
        plt_put_u32(at + 4, s->offset);
        plt_put_u32(at + 8, s->bytes);
        plt_put_u32(at + 12, s->crc);
    }
    plt_put_u32(bytes + AT_HEADER_CRC, header_crc(bytes));
}
