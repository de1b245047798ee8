/* header - see header.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/image/header.h"

#include "engine/image/bytes.h"
#include "engine/image/crc32.h"
#include "engine/image/fault.h"
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
    AT_SECTION = 104, /* 16 bytes each */
    AT_RESERVED = 136
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

/* R7 to R9: values whose range does not depend on the rest of the image. */
static int check_values(const plt_header *h, const unsigned char *bytes, plt_fault *fault) {
    const plt_info *info = &h->info;
    if (info->triangles > PLT_INDEX_MAX || info->node_slots > PLT_INDEX_MAX) {
        return plt_refused(fault, 7, AT_COUNTS, "more than 2^27 - 1 triangles or nodes");
    }
    if (info->leaf_triangles < 1 || info->treelet_nodes < 1 ||
        info->treelet_nodes > PLT_INDEX_MAX || info->nodes > info->node_slots ||
        info->node_slots % info->treelet_nodes != 0) {
        return plt_refused(fault, 7, AT_COUNTS, "a count is out of range");
    }
    if (info->build != PLT_BUILD_HOST && (info->node_slots != 0 || info->treelets != 0)) {
        return plt_refused(fault, 7, AT_COUNTS + 4, "nodes in an image without a tree");
    }
    if (info->build == PLT_BUILD_DEVICE && h->root != PLT_LINK_NONE) {
        return plt_refused(fault, 7, AT_ROOT, "a root in an image without a tree");
    }
    if (info->splits > PLT_SPLIT_MEDIAN || info->build > PLT_BUILD_NONE ||
        bytes[AT_NODE_FORMAT] != 0 || bytes[AT_GEOMETRY_FORMAT] != 0) {
        return plt_refused(fault, 8, AT_SPLITS, "a format that this version does not know");
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
    const uint64_t bytes_due[PLT_SECTIONS] = {
        plt_section_bytes(h->info.node_slots, PLT_NODE_BYTES),
        plt_section_bytes(h->info.triangles, PLT_RECORD_BYTES)};
    uint64_t offset = PLT_HEADER_BYTES;
    if (plt_get_u32(bytes + AT_SECTIONS) != PLT_SECTIONS) {
        return plt_refused(fault, 10, AT_SECTIONS, "the number of sections is not 2");
    }
    for (int i = 0; i < PLT_SECTIONS; i++) {
        const plt_section *s = &h->section[i];
        if (s->kind != (uint32_t)i + 1 || s->offset != offset || s->bytes != bytes_due[i]) {
            return plt_refused(fault, 11, AT_SECTION + 16u * (unsigned)i,
                               "a section is not where or what it must be");
        }
        offset += s->bytes;
    }
    if (offset != h->info.image_bytes) {
        return plt_refused(fault, 11, AT_IMAGE_BYTES, "the sections do not fill the image");
    }
    for (unsigned i = AT_RESERVED; i < PLT_HEADER_BYTES; i++) {
        if (bytes[i] != 0) {
            return plt_refused(fault, 12, i, "a reserved byte is not zero");
        }
    }
    return PLT_OK;
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
    for (int i = 0; i < PLT_SECTIONS; i++) {
        const unsigned char *at = bytes + AT_SECTION + 16 * i;
        const plt_section s = {plt_get_u32(at), plt_get_u32(at + 4), plt_get_u32(at + 8),
                               plt_get_u32(at + 12)};
        header->section[i] = s;
    }
    info->node_bytes = header->section[0].bytes;
    info->triangle_bytes = header->section[1].bytes;
    const int values = check_values(header, bytes, fault);
    return values == PLT_OK ? check_sections(header, bytes, fault) : values;
}

static void place_sections(plt_header *h) {
    plt_section *s = h->section;
    s[0].kind = PLT_SECTION_NODES;
    s[0].offset = PLT_HEADER_BYTES;
    s[0].bytes = (uint32_t)plt_section_bytes(h->info.node_slots, PLT_NODE_BYTES);
    s[1].kind = PLT_SECTION_TRIANGLES;
    s[1].offset = s[0].offset + s[0].bytes;
    s[1].bytes = (uint32_t)plt_section_bytes(h->info.triangles, PLT_RECORD_BYTES);
    h->info.node_bytes = s[0].bytes;
    h->info.triangle_bytes = s[1].bytes;
    h->info.image_bytes = s[1].offset + s[1].bytes;
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
    plt_put_u32(bytes + AT_SECTIONS, PLT_SECTIONS);
    for (int i = 0; i < PLT_SECTIONS; i++) {
        unsigned char *at = bytes + AT_SECTION + 16 * i;
        const plt_section *s = &header->section[i];
        plt_put_u32(at, s->kind);
        plt_put_u32(at + 4, s->offset);
        plt_put_u32(at + 8, s->bytes);
        plt_put_u32(at + 12, s->crc);
    }
    plt_put_u32(bytes + AT_HEADER_CRC, header_crc(bytes));
}
