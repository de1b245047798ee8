/* header - see header.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/image/header.h"

#include <string.h>

#include "engine/base/bytes.h"
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/header_at.h"
#include "engine/planelet_crc32.h"

static const unsigned char magic[8] = {'P', 'L', 'A', 'N', 'E', 'L', 'E', 'T'};

#define COUNTS 11

/* A thesis image with checks has that many sections, one without has one less. */
enum { THESIS_SECTIONS_CHECKED = 3 };

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

static uint32_t header_crc(const unsigned char *bytes) {
    const unsigned char zero[4] = {0, 0, 0, 0};
    uint32_t crc = plt_crc32(0, bytes, PLT_AT_HEADER_CRC);
    crc = plt_crc32(crc, zero, sizeof zero);
    return plt_crc32(crc, bytes + PLT_AT_HEADER_CRC + 4, PLT_HEADER_BYTES - PLT_AT_HEADER_CRC - 4);
}

/* R2 to R6: is it one of our headers at all, whole and of this version? */
static int check_identity(const unsigned char *bytes, uint32_t image_bytes, plt_fault *fault) {
    if (memcmp(bytes, magic, sizeof magic) != 0) {
        return plt_refused(fault, PLT_R2_MAGIC, 0, "this is no Planelet scene image");
    }
    if (bytes[PLT_AT_VERSION] != PLT_IMAGE_MAJOR || bytes[PLT_AT_VERSION + 1] != 0) {
        return plt_refused(fault, PLT_R3_VERSION, PLT_AT_VERSION,
                           "the image is of another version; pack it anew");
    }
    if (plt_get_u32(bytes + PLT_AT_HEADER_BYTES) != PLT_HEADER_BYTES) {
        return plt_refused(fault, PLT_R4_HEADER_BYTES, PLT_AT_HEADER_BYTES,
                           "the header size is not 256");
    }
    if (header_crc(bytes) != plt_get_u32(bytes + PLT_AT_HEADER_CRC)) {
        return plt_refused(fault, PLT_R5_HEADER_CRC, PLT_AT_HEADER_CRC,
                           "the header is damaged (checksum)");
    }
    if (plt_get_u32(bytes + PLT_AT_IMAGE_BYTES) != image_bytes) {
        return plt_refused(fault, PLT_R6_IMAGE_BYTES, PLT_AT_IMAGE_BYTES,
                           "the image is shorter or longer than its header says");
    }
    return PLT_OK;
}

/* Of ids with checks 256 more than the bits of one. */
enum { ID_CHECKS = 0x100 };

static void read_id_bits(plt_info *info, uint32_t field) {
    info->has_checks = field / ID_CHECKS == 1;
    info->primitive_id_bits = (uint8_t)(field < 2 * ID_CHECKS ? field % ID_CHECKS : 255);
}

static void read_lattice(plt_header *h, const unsigned char *bytes) {
    plt_get_floats(h->lattice.origin, bytes + PLT_AT_ORIGIN, 3);
    h->lattice.origin[3] = 0.0f;
    h->lattice.step = plt_get_float(bytes + PLT_AT_STEP);
    h->lattice.bits = plt_get_u32(bytes + PLT_AT_BITS);
    for (int a = 0; a < 3; a++) {
        h->lattice_box.lo[a] = plt_get_u32(bytes + PLT_AT_LATTICE_BOX + 4 * a);
        h->lattice_box.hi[a] = plt_get_u32(bytes + PLT_AT_LATTICE_BOX + 12 + 4 * a);
    }
    plt_info *info = &h->info;
    info->lattice_bits = (uint8_t)(h->lattice.bits <= 255 ? h->lattice.bits : 255);
    info->source_triangles = plt_get_u32(bytes + PLT_AT_SOURCE_TRIANGLES);
    read_id_bits(info, plt_get_u32(bytes + PLT_AT_PRIMITIVE_ID_BITS));
    info->node_bytes = plt_get_u32(bytes + PLT_AT_NODE_BYTES);
    info->triangle_bytes = plt_get_u32(bytes + PLT_AT_TRIANGLE_BYTES);
}

#if PLT_WITH_BLOCK_MOTION
/* The lattice coordinate of a float that is one; of others, and where the lattice is none that
 * R14 allows, some number. */
static uint32_t coordinate_of(const plt_lattice *l, int axis, float p) {
    const float steps = (p - l->origin[axis]) / l->step;
    const uint32_t near = steps >= 0.5f && steps < 4194304.0f ? (uint32_t)(int32_t)steps : 0;
    uint32_t q = near > 0 ? near - 1 : 0;
    while (q < near + 2 && plt_lattice_float(l, axis, q) < p) {
        q++;
    }
    return q;
}

static void read_moving(plt_header *h, const unsigned char *bytes) {
    h->info.block_vertices = plt_get_u32(bytes + PLT_AT_BLOCK_VERTICES);
    for (int a = 0; a < 3; a++) {
        h->lattice_box.lo[a] = coordinate_of(&h->lattice, a, h->info.lo[a]);
        h->lattice_box.hi[a] = coordinate_of(&h->lattice, a, h->info.hi[a]);
    }
}
#endif

#if PLT_WITH_SEQUENCE || PLT_WITH_INSTANCES
static void read_sequence(plt_info *info, const unsigned char *bytes) {
    info->vertices = plt_get_u32(bytes + PLT_AT_VERTICES);
    info->frames = plt_get_u32(bytes + PLT_AT_FRAMES);
    info->frame_rate = plt_get_u32(bytes + PLT_AT_FRAME_RATE);
    info->key_every = plt_get_u32(bytes + PLT_AT_KEY_EVERY);
    info->frame_bytes = plt_get_u32(bytes + PLT_AT_FRAME_BYTES);
#if PLT_WITH_INSTANCES
    if (info->nodes_format == PLT_NODES_THESIS) { /* compact blocks have another number there */
        info->instances = plt_get_u32(bytes + PLT_AT_INSTANCES);
    }
    if (info->instances > 0) {
        info->bodies = info->vertices;
        info->vertices = 0;
        info->placed_triangles = plt_get_u32(bytes + PLT_AT_PLACED_TRIANGLES);
    }
#endif
}

static void write_sequence(unsigned char *bytes, const plt_header *h) {
    const plt_info *info = &h->info;
    if (info->lattice_bits > 0) {
        plt_put_floats(bytes + PLT_AT_ORIGIN, h->lattice.origin, 3);
        plt_put_float(bytes + PLT_AT_STEP, h->lattice.step);
        plt_put_u32(bytes + PLT_AT_BITS, h->lattice.bits);
    }
    plt_put_u32(bytes + PLT_AT_VERTICES, info->vertices);
    plt_put_u32(bytes + PLT_AT_FRAMES, info->frames);
    plt_put_u32(bytes + PLT_AT_FRAME_RATE, info->frame_rate);
    plt_put_u32(bytes + PLT_AT_KEY_EVERY, info->key_every);
    plt_put_u32(bytes + PLT_AT_FRAME_BYTES, info->frame_bytes);
    if (plt_header_moves(info)) {
        plt_put_u32(bytes + PLT_AT_BLOCK_VERTICES, info->block_vertices);
    }
#if PLT_WITH_INSTANCES
    if (info->instances > 0) {
        plt_put_u32(bytes + PLT_AT_BODIES, info->bodies);
        plt_put_u32(bytes + PLT_AT_INSTANCES, info->instances);
        plt_put_u32(bytes + PLT_AT_PLACED_TRIANGLES, info->placed_triangles);
    }
#endif
}
#endif

static void write_lattice(unsigned char *bytes, const plt_header *h) {
    plt_put_floats(bytes + PLT_AT_ORIGIN, h->lattice.origin, 3);
    plt_put_float(bytes + PLT_AT_STEP, h->lattice.step);
    plt_put_u32(bytes + PLT_AT_BITS, h->lattice.bits);
    for (int a = 0; a < 3; a++) {
        plt_put_u32(bytes + PLT_AT_LATTICE_BOX + 4 * a, h->lattice_box.lo[a]);
        plt_put_u32(bytes + PLT_AT_LATTICE_BOX + 12 + 4 * a, h->lattice_box.hi[a]);
    }
    plt_put_u32(bytes + PLT_AT_SOURCE_TRIANGLES, h->info.source_triangles);
    plt_put_u32(bytes + PLT_AT_PRIMITIVE_ID_BITS,
                h->info.primitive_id_bits + ID_CHECKS * h->info.has_checks);
    plt_put_u32(bytes + PLT_AT_NODE_BYTES, h->info.node_bytes);
    plt_put_u32(bytes + PLT_AT_TRIANGLE_BYTES, h->info.triangle_bytes);
}

int plt_header_read(plt_header *header, const unsigned char bytes[PLT_HEADER_BYTES],
                    uint32_t image_bytes, plt_fault *fault) {
    const int status = check_identity(bytes, image_bytes, fault);
    if (status != PLT_OK) {
        return status;
    }
    plt_info *info = &header->info;
    info->vertices = info->frames = info->frame_rate = info->key_every = info->frame_bytes = 0;
    info->block_vertices = 0;
    info->bodies = info->instances = info->placed_triangles = 0;
#if PLT_WITH_SURFACE
    info->normal_bytes = info->colour_bytes = 0;
#endif
#if PLT_WITH_PAGES
    info->page_bytes = 0;
#endif
#if PLT_WITH_TEXCOORDS
    info->texcoord_bytes = 0;
#endif
#if PLT_WITH_MATERIALS
    info->material_bytes = 0;
#endif
#if PLT_WITH_TEXTURE
    info->texture_bytes = info->tile_bytes = 0;
#endif
    for (int i = 0; i < COUNTS; i++) {
        *count_field(info, i) = plt_get_u32(bytes + PLT_AT_COUNTS + 4 * i);
    }
    info->image_bytes = image_bytes;
    header->root = plt_get_u32(bytes + PLT_AT_ROOT);
    plt_get_floats(info->lo, bytes + PLT_AT_LO, 3);
    plt_get_floats(info->hi, bytes + PLT_AT_HI, 3);
    for (int a = 0; a < 3 && info->triangles == 0; a++) { /* whatever the bytes say */
        info->lo[a] = PLT_BOX_FAR;
        info->hi[a] = -PLT_BOX_FAR;
    }
    info->splits = bytes[PLT_AT_SPLITS];
    info->build = bytes[PLT_AT_BUILD];
    info->nodes_format = bytes[PLT_AT_NODE_FORMAT];
    info->geometry_format = bytes[PLT_AT_GEOMETRY_FORMAT];
    for (int i = 0; i < PLT_SECTIONS_MOST; i++) {
        const unsigned char *at = bytes + PLT_AT_SECTION + 16 * i;
        const plt_section s = {plt_get_u32(at), plt_get_u32(at + 4), plt_get_u32(at + 8),
                               plt_get_u32(at + 12)};
        header->section[i] = s;
    }
    read_lattice(header, bytes);
    if (info->nodes_format == PLT_NODES_THESIS) {
        info->node_bytes = header->section[0].bytes;
        info->triangle_bytes = header->section[1].bytes;
        info->source_triangles = info->triangles;
#if PLT_WITH_SEQUENCE || PLT_WITH_INSTANCES
        read_sequence(info, bytes);
#endif
        info->has_checks =
            info->frames == 0 && plt_get_u32(bytes + PLT_AT_SECTIONS) == THESIS_SECTIONS_CHECKED;
    }
#if PLT_WITH_BLOCK_MOTION
    if (plt_header_moves(info)) {
        read_sequence(info, bytes);
        read_moving(header, bytes);
    }
#endif
    info->primitive_id_bytes =
        info->primitive_id_bits > 0
            ? (uint32_t)plt_header_section_bytes(info, PLT_SECTION_PRIMITIVE_IDS)
            : 0;
#if PLT_WITH_FURTHER
    header->further_count = plt_get_u32(bytes + PLT_AT_FURTHER);
    const int status_of_all = plt_header_check(header, bytes, fault);
    header->further_at = status_of_all == PLT_OK ? plt_header_end(info) : 0;
    return status_of_all;
#else
    return plt_header_check(header, bytes, fault);
#endif
}

static void set_sections(plt_header *h) {
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
    set_sections(header);
    memset(bytes, 0, PLT_HEADER_BYTES);
    memcpy(bytes, magic, sizeof magic);
    bytes[PLT_AT_VERSION] = PLT_IMAGE_MAJOR;
    bytes[PLT_AT_VERSION + 2] = PLT_IMAGE_MINOR;
    plt_put_u32(bytes + PLT_AT_HEADER_BYTES, PLT_HEADER_BYTES);
    plt_put_u32(bytes + PLT_AT_IMAGE_BYTES, info->image_bytes);
    for (int i = 0; i < COUNTS; i++) {
        plt_put_u32(bytes + PLT_AT_COUNTS + 4 * i, *count_field(info, i));
    }
    plt_put_u32(bytes + PLT_AT_ROOT, header->root);
    plt_put_floats(bytes + PLT_AT_LO, info->lo, 3);
    plt_put_floats(bytes + PLT_AT_HI, info->hi, 3);
    bytes[PLT_AT_SPLITS] = info->splits;
    bytes[PLT_AT_BUILD] = info->build;
    bytes[PLT_AT_NODE_FORMAT] = info->nodes_format;
    bytes[PLT_AT_GEOMETRY_FORMAT] = info->geometry_format;
    uint32_t kind[PLT_SECTIONS_MOST];
    plt_put_u32(bytes + PLT_AT_SECTIONS, plt_header_kinds(info, kind));
    if (info->nodes_format == PLT_NODES_COMPACT) {
        write_lattice(bytes, header);
    }
#if PLT_WITH_SEQUENCE || PLT_WITH_INSTANCES
    if (info->frames > 0) {
        write_sequence(bytes, header);
    }
#endif
    for (int i = 0; i < PLT_SECTIONS_MOST; i++) {
        unsigned char *at = bytes + PLT_AT_SECTION + 16 * i;
        const plt_section *s = &header->section[i];
        plt_put_u32(at, s->kind);
        plt_put_u32(at + 4, s->offset);
        plt_put_u32(at + 8, s->bytes);
        plt_put_u32(at + 12, s->crc);
    }
    plt_header_seal(bytes);
}

void plt_header_seal(unsigned char bytes[PLT_HEADER_BYTES]) {
    plt_put_u32(bytes + PLT_AT_HEADER_CRC, header_crc(bytes));
}
