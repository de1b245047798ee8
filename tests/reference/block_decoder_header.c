/* block_decoder_header - header and sections of a compact image
 *
 * Source: SPEC.md, sections 2, 3, 4.1 and 4.7.
 *
 * SPDX-License-Identifier: MIT */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "tests/reference/block_decoder.h"
#include "tests/reference/block_decoder_bytes.h"

enum { HEADER_BYTES = 256, BUILD_HOST = 0, NODES_COMPACT = 1, KIND_RECORDS = 2 };

int block_decode_wrong(decoded_image *image, const char *format, ...) {
    if (image->wrong[0] == '\0') {
        va_list list;
        va_start(list, format);
        vsnprintf(image->wrong, sizeof image->wrong, format, list);
        va_end(list);
    }
    return -1;
}

float block_decode_float(const decoded_header *header, int axis, int32_t number) {
    const float product = header->step * (float)number;
    return header->origin[axis] + product;
}

static void read_counts(decoded_header *h, decoder_bytes *in) {
    uint32_t *const count[] = {
        &h->triangles,          &h->nodes,        &h->node_slots,    &h->leaf_lists,
        &h->intermediate_lists, &h->treelets,     &h->treelet_nodes, &h->leaf_triangles,
        &h->local_stack,        &h->global_stack, &h->depth_stack,   &h->root_link};
    for (size_t i = 0; i < sizeof count / sizeof count[0]; i++) {
        *count[i] = decoder_u32(in, 24 + 4 * i);
    }
}

static void read_lattice(decoded_header *h, decoder_bytes *in) {
    for (size_t a = 0; a < 3; a++) {
        h->lo[a] = decoder_float(in, 72 + 4 * a);
        h->hi[a] = decoder_float(in, 84 + 4 * a);
        h->origin[a] = decoder_float(in, 168 + 4 * a);
        h->lattice_lo[a] = decoder_u32(in, 188 + 4 * a);
        h->lattice_hi[a] = decoder_u32(in, 200 + 4 * a);
    }
    h->step = decoder_float(in, 180);
    h->lattice_bits = decoder_u32(in, 184);
    h->source_triangles = decoder_u32(in, 212);
    h->primitive_id_bits = decoder_u32(in, 216);
    h->id_checks = h->primitive_id_bits >= 256 ? 1 : 0;
    h->primitive_id_bits -= 256 * h->id_checks;
    h->node_bytes = decoder_u32(in, 220);
    h->triangle_bytes = decoder_u32(in, 224);
}

static void read_header(decoded_header *h, decoder_bytes *in) {
    h->major = decoder_u16(in, 8);
    h->minor = decoder_u16(in, 10);
    h->bytes = decoder_u32(in, 12);
    h->image_bytes = decoder_u32(in, 16);
    h->crc = decoder_u32(in, 20);
    h->splits = decoder_bits(in, 8 * 96, 8);
    h->build = decoder_bits(in, 8 * 97, 8);
    h->node_format = decoder_bits(in, 8 * 98, 8);
    h->geometry_format = decoder_bits(in, 8 * 99, 8);
    h->sections = decoder_u32(in, 100);
    read_counts(h, in);
    read_lattice(h, in);
    for (size_t s = 0; s < 2 && s < h->sections; s++) {
        decoded_section *section = &h->section[s];
        section->kind = decoder_u32(in, 104 + 16 * s);
        section->offset = decoder_u32(in, 108 + 16 * s);
        section->bytes = decoder_u32(in, 112 + 16 * s);
        section->crc = decoder_u32(in, 116 + 16 * s);
    }
}

static int check_reserved(decoded_image *image, decoder_bytes *in) {
    const size_t table_end = 104 + 16 * (size_t)image->header.sections;
    if (!decoder_is_zero(in, 8 * table_end, 8 * (size_t)168) ||
        !decoder_is_zero(in, 8 * (size_t)228, 8 * (size_t)HEADER_BYTES)) {
        return block_decode_wrong(image, "header: a reserved byte is not 0");
    }
    return 0;
}

static int check_values(decoded_image *image, const unsigned char *bytes, size_t size) {
    const decoded_header *h = &image->header;
    if (memcmp(bytes, "PLANELET", 8) != 0 || h->major != 1 || h->bytes != HEADER_BYTES) {
        return block_decode_wrong(image, "header: magic, version or header size");
    }
    if (h->image_bytes != size) {
        return block_decode_wrong(image, "header: image size");
    }
    if (h->crc != decoder_crc(bytes, HEADER_BYTES, 20, 4)) {
        return block_decode_wrong(image, "header: CRC");
    }
    if (h->build != BUILD_HOST || h->node_format != NODES_COMPACT || h->geometry_format > 1 ||
        h->splits > 1) {
        return block_decode_wrong(image,
                                  "header: build or formats that this decoder does not read");
    }
    const uint32_t k = h->leaf_triangles, id = h->primitive_id_bits;
    if (id > 29 || id == 1 || (id == 0 && h->id_checks)) {
        return block_decode_wrong(image, "header: primitive id bits");
    }
    if (h->lattice_bits < 12 || h->lattice_bits > 21 || (k != 1 && k != 2 && k != 4) ||
        h->treelet_nodes != 64 || h->local_stack != 0 || h->global_stack != 0 ||
        h->node_slots != h->nodes) {
        return block_decode_wrong(image, "header: lattice bits, K, N, slots or stacks");
    }
    return 0;
}

/* The box at 72 is the one at 188 in floats, bit for bit; with float records it lies
 * within that. */
static int check_box(decoded_image *image) {
    const decoded_header *h = &image->header;
    for (int a = 0; a < 3 && h->triangles > 0; a++) {
        const float lo = block_decode_float(h, a, (int32_t)h->lattice_lo[a]);
        const float hi = block_decode_float(h, a, (int32_t)h->lattice_hi[a]);
        const int same =
            memcmp(&lo, &h->lo[a], sizeof lo) == 0 && memcmp(&hi, &h->hi[a], sizeof hi) == 0;
        const int around = lo <= h->lo[a] && h->lo[a] <= h->hi[a] && h->hi[a] <= hi;
        if (h->geometry_format == 1 ? !same : !around) {
            return block_decode_wrong(image, "header: boxes differ on axis %d", a);
        }
        if (h->lattice_lo[a] > h->lattice_hi[a] || h->lattice_hi[a] >> h->lattice_bits != 0) {
            return block_decode_wrong(image, "header: lattice box on axis %d", a);
        }
    }
    return 0;
}

static size_t round_64(size_t bytes) {
    return (bytes + 63) / 64 * 64;
}

/* Bytes of a section before they are rounded up. */
static size_t section_bytes(const decoded_header *h, uint32_t kind) {
    switch (kind) {
    case 2:
        return 40 * (size_t)h->triangles;
    case 3:
        return (size_t)h->node_bytes + h->triangle_bytes + 8;
    case 4:
        return ((size_t)h->triangles * h->primitive_id_bits + 7) / 8 + 8;
    default:
        return 0;
    }
}

static int check_section(decoded_image *image, const unsigned char *bytes, uint32_t s,
                         size_t offset, uint32_t kind) {
    const decoded_section *section = &image->header.section[s];
    const size_t used = section_bytes(&image->header, kind), padded = round_64(used);
    if (section->kind != kind || section->offset != offset || section->bytes != padded ||
        offset + padded > image->header.image_bytes) {
        return block_decode_wrong(image, "section %u: kind, offset or size", s);
    }
    const uint32_t crc = padded > 0 ? decoder_crc(bytes + offset, padded, 0, 0) : 0;
    if (section->crc != crc) {
        return block_decode_wrong(image, "section %u: CRC", s);
    }
    decoder_bytes in = {bytes + offset, padded, 0};
    if (!decoder_is_zero(&in, 8 * used, 8 * padded)) {
        return block_decode_wrong(image, "section %u: padding", s);
    }
    return 0;
}

static int check_sections(decoded_image *image, const unsigned char *bytes) {
    const decoded_header *h = &image->header;
    uint32_t kind[2] = {3, 0}, sections = 1;
    if (h->geometry_format == 0) {
        kind[sections++] = KIND_RECORDS;
    } else if (h->primitive_id_bits != 0) {
        kind[sections++] = 4;
    }
    if (h->sections != sections) {
        return block_decode_wrong(image, "header: %u sections", h->sections);
    }
    size_t offset = HEADER_BYTES;
    for (uint32_t s = 0; s < sections; s++) {
        if (check_section(image, bytes, s, offset, kind[s]) != 0) {
            return -1;
        }
        offset += h->section[s].bytes;
    }
    return offset == h->image_bytes ? 0
                                    : block_decode_wrong(image, "image: bytes after the sections");
}

int block_decode_header(decoded_image *image, const unsigned char *bytes, size_t size) {
    memset(image, 0, sizeof *image);
    if (size < HEADER_BYTES) {
        return block_decode_wrong(image, "image: fewer than 256 bytes");
    }
    decoder_bytes in = {bytes, HEADER_BYTES, 0};
    read_header(&image->header, &in);
    if (check_values(image, bytes, size) != 0 || check_sections(image, bytes) != 0 ||
        check_reserved(image, &in) != 0) {
        return -1;
    }
    return check_box(image);
}
