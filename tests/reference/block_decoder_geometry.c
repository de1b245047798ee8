/* block_decoder_geometry - the geometry part of a compact block
 *
 * Source: SPEC.md, sections 4.4 and 4.10 to 4.12.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "tests/reference/block_decoder_part.h"

enum { WORST_BLOCK_TRIANGLES = 520, WORST_BLOCK_VERTICES = 2047, ALL_PARTS_BITS = 64 };

/* Strips are read from the first reference of the block to the last. */
typedef struct strip_reader {
    uint32_t reference, known; /* references read, vertices met */
    uint32_t corner[3];        /* of the previous triangle, in strip order */
} strip_reader;

static int part_wrong(decoded_image *image, const decoder_part *part, const char *what) {
    return block_decode_wrong(image, "block %u: %s", part->block->address, what);
}

static uint32_t triangles_of_leaf(decoder_part *part, uint32_t k, uint32_t leaf, int pair) {
    uint32_t triangles = 1 + (pair ? k : 0);
    if (k >= 2) {
        triangles += decoder_bits(&part->in, part->counts[0] + leaf, 1);
    }
    if (k == 4) {
        triangles += 2 * decoder_bits(&part->in, part->counts[1] + leaf, 1);
    }
    return triangles;
}

static void add_leaves(decoded_image *image, decoder_part *part) {
    decoded_block *block = part->block;
    const uint32_t k = image->header.leaf_triangles;
    for (uint32_t slot = 0; slot < 2 * block->nodes; slot++) {
        const enum decoded_kind kind = decoder_slot_kind(part, slot);
        if (kind < DECODED_LEAF) {
            continue;
        }
        const uint32_t u = decoder_slot_rank(part, slot);
        const uint32_t triangles = triangles_of_leaf(part, k, u, kind == DECODED_PAIR);
        image->leaf = decoder_room(image->leaf, image->leaves, sizeof *image->leaf);
        image->leaf[image->leaves++] = (decoded_leaf){
            image->blocks, slot, block->first_triangle + block->triangles, triangles};
        image->pairs += kind == DECODED_PAIR;
        block->triangles += triangles;
    }
}

/* Header and counts, which every geometry part has; the bit after them. */
static size_t read_leaves(decoded_image *image, decoder_part *part) {
    decoded_block *block = part->block;
    const uint32_t k = image->header.leaf_triangles;
    const size_t header = part->end;
    block->first_triangle = decoder_bits(&part->in, header, 27);
    block->vertices = decoder_bits(&part->in, header + 27, 5);
    block->vertices |= decoder_bits(&part->in, header + 32, 6) << 5;
    block->mesh = decoder_bits(&part->in, header + 38, 10);
    part->counts[0] = header + ALL_PARTS_BITS;
    part->counts[1] = part->counts[0] + block->leaves;
    add_leaves(image, part);
    const size_t strings = k == 4 ? 2 : k == 2 ? 1 : 0;
    return part->counts[0] + strings * block->leaves;
}

/* Positions of the strings of lattice geometry; the bit after the last. */
static size_t lay_out(decoder_part *part, size_t at) {
    decoded_block *block = part->block;
    const decoded_box *bounds = &block->bounds;
    part->start = at;
    part->swap = part->start + block->triangles;
    part->fresh = part->swap + block->triangles;
    block->strips = decoder_ones(&part->in, part->start, 0, block->triangles);
    const uint32_t references = block->triangles + 2 * block->strips;
    part->refs = part->fresh + references;
    part->ref_bits = decoder_width(block->vertices - 1);
    part->positions = part->refs;
    if (references > block->vertices) {
        part->positions += (size_t)(references - block->vertices) * part->ref_bits;
    }
    unsigned vertex_bits = 0;
    for (int a = 0; a < 3; a++) {
        part->position_bits[a] = decoder_width((uint32_t)(bounds->hi[a] - bounds->lo[a]));
        vertex_bits += part->position_bits[a];
    }
    return part->positions + (size_t)block->vertices * vertex_bits;
}

static void read_position(decoder_part *part, uint32_t vertex, int32_t position[3]) {
    const unsigned *bits = part->position_bits;
    size_t at = part->positions + (size_t)vertex * (bits[0] + bits[1] + bits[2]);
    for (int a = 0; a < 3; a++) {
        position[a] = part->block->bounds.lo[a] + (int32_t)decoder_bits(&part->in, at, bits[a]);
        at += bits[a];
    }
}

static int check_positions(decoded_image *image, decoder_part *part) {
    const decoded_box *bounds = &part->block->bounds;
    for (uint32_t vertex = 0; vertex < part->block->vertices; vertex++) {
        int32_t position[3];
        read_position(part, vertex, position);
        for (int a = 0; a < 3; a++) {
            if (position[a] < bounds->lo[a] || position[a] > bounds->hi[a]) {
                return part_wrong(image, part, "a vertex outside the bounds");
            }
        }
    }
    return 0;
}

/* The vertex of the next reference. */
static int next_vertex(decoded_image *image, decoder_part *part, strip_reader *strip,
                       uint32_t *vertex) {
    const uint32_t i = strip->reference++;
    if (decoder_bits(&part->in, part->fresh + i, 1)) {
        *vertex = strip->known++;
        return *vertex < part->block->vertices ? 0 : part_wrong(image, part, "vertices");
    }
    const uint32_t entry = i - decoder_ones(&part->in, part->fresh, 0, i);
    *vertex = decoder_bits(&part->in, part->refs + (size_t)entry * part->ref_bits, part->ref_bits);
    return *vertex < strip->known ? 0 : part_wrong(image, part, "a vertex not yet met");
}

/* Corners of triangle t of the block, in strip order. */
static int next_triangle(decoded_image *image, decoder_part *part, strip_reader *strip,
                         uint32_t t) {
    uint32_t *corner = strip->corner;
    const uint32_t starts = decoder_bits(&part->in, part->start + t, 1);
    const uint32_t swap = decoder_bits(&part->in, part->swap + t, 1);
    if (starts) {
        for (int c = 0; c < 3; c++) {
            if (next_vertex(image, part, strip, &corner[c]) != 0) {
                return -1;
            }
        }
        return swap == 0 ? 0 : part_wrong(image, part, "a start with its swap bit set");
    }
    if (swap == 0) {
        corner[0] = corner[2]; /* (c, b, x) */
    } else {
        corner[1] = corner[2]; /* (a, c, x) */
    }
    return next_vertex(image, part, strip, &corner[2]);
}

static int is_less(const int32_t *p, const int32_t *q) {
    for (int a = 0; a < 3; a++) {
        if (p[a] != q[a]) {
            return p[a] < q[a];
        }
    }
    return 0;
}

/* The corners in canonical order, and their floats. */
static void set_corners(const decoded_header *header, decoder_part *part, const uint32_t vertex[3],
                        decoded_triangle *triangle) {
    int32_t given[3][3];
    int least = 0;
    for (int c = 0; c < 3; c++) {
        read_position(part, vertex[c], given[c]);
        least = is_less(given[c], given[least]) ? c : least;
    }
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            triangle->corner[c][a] = given[(least + c) % 3][a];
            triangle->point[c][a] = block_decode_float(header, a, triangle->corner[c][a]);
        }
    }
}

static int read_primitive_id(decoded_image *image, decoder_part *part, uint32_t index,
                             decoded_triangle *triangle) {
    const unsigned bits = image->header.primitive_id_bits;
    if (bits == 0) {
        triangle->primitive_id = index;
        return 0;
    }
    const size_t entry = (size_t)index * bits;
    triangle->rotation = decoder_bits(&part->primitive_ids, entry, 2);
    triangle->primitive_id = decoder_bits(&part->primitive_ids, entry + 2, bits - 2);
    if (triangle->rotation > 2 || triangle->primitive_id >= image->header.source_triangles) {
        return block_decode_wrong(image, "primitive id %u: out of range", index);
    }
    return 0;
}

static int starts_a_leaf(const decoded_image *image, const decoded_block *block, uint32_t t) {
    for (uint32_t u = 0; u < block->leaves; u++) {
        if (image->leaf[block->first_leaf + u].first == block->first_triangle + t) {
            return 1;
        }
    }
    return 0;
}

static int read_strips(decoded_image *image, decoder_part *part) {
    const decoded_block *block = part->block;
    strip_reader strip = {0, 0, {0, 0, 0}};
    if (check_positions(image, part) != 0) {
        return -1;
    }
    for (uint32_t t = 0; t < block->triangles; t++) {
        const uint32_t index = block->first_triangle + t;
        if (starts_a_leaf(image, block, t) && !decoder_bits(&part->in, part->start + t, 1)) {
            return part_wrong(image, part, "a leaf that does not start a strip");
        }
        if (next_triangle(image, part, &strip, t) != 0) {
            return -1;
        }
        image->triangle = decoder_room(image->triangle, index, sizeof *image->triangle);
        image->triangles++;
        set_corners(&image->header, part, strip.corner, &image->triangle[index]);
        if (read_primitive_id(image, part, index, &image->triangle[index]) != 0) {
            return -1;
        }
    }
    const uint32_t references = block->triangles + 2 * block->strips;
    return strip.reference == references && strip.known == block->vertices
               ? 0
               : part_wrong(image, part, "references or vertices left over");
}

static int read_records(decoded_image *image, decoder_part *part) {
    const decoded_block *block = part->block;
    for (uint32_t t = 0; t < block->triangles; t++) {
        const uint32_t index = block->first_triangle + t;
        image->triangle = decoder_room(image->triangle, index, sizeof *image->triangle);
        image->triangles++;
        decoded_triangle *triangle = &image->triangle[index];
        for (size_t i = 0; i < 9; i++) {
            const size_t at = 40 * (size_t)index + 4 * i;
            triangle->point[i / 3][i % 3] = decoder_float(&part->records, at);
        }
        const uint32_t word = decoder_u32(&part->records, 40 * (size_t)index + 36);
        triangle->primitive_id = word & 0x7FFFFFFu;
        triangle->rotation = word >> 29 & 3u;
        if (triangle->primitive_id >= image->header.triangles || triangle->rotation > 2 ||
            (word >> 27 & 3u) != 0) {
            return block_decode_wrong(image, "record %u: primitive id word", index);
        }
    }
    return 0;
}

/* The last two bytes of the part: the check of the bytes that hold the block's primitive ids. */
static int check_ids(decoded_image *image, decoder_part *part, size_t at) {
    const decoded_block *block = part->block;
    const size_t bits = image->header.primitive_id_bits;
    const size_t from = block->first_triangle * bits / 8;
    const size_t to = ((block->first_triangle + (size_t)block->triangles) * bits + 7) / 8;
    if (to > part->primitive_ids.size) {
        return part_wrong(image, part, "primitive ids beyond their section");
    }
    const uint32_t crc = decoder_crc(part->primitive_ids.at + from, to - from, 0, 0);
    return decoder_bits(&part->in, at, 16) == ((crc ^ crc >> 16) & 0xFFFF)
               ? 0
               : part_wrong(image, part, "check of the primitive ids");
}

static int check_part(decoded_image *image, decoder_part *part, size_t strings_end) {
    const decoded_block *block = part->block;
    const size_t bytes = block->geometry_bytes, at = part->end / 8;
    const size_t room_end = part->end + 8 * bytes - 16 * (size_t)image->header.id_checks;
    const int lattice = image->header.geometry_format == 1;
    if (part->in.overrun || strings_end > room_end || lattice != (block->vertices > 0) ||
        block->triangles > WORST_BLOCK_TRIANGLES || block->vertices > WORST_BLOCK_VERTICES ||
        block->first_triangle != image->triangles) {
        return part_wrong(image, part, "counts of the geometry part");
    }
    if (!decoder_is_zero(&part->in, strings_end, room_end)) {
        return part_wrong(image, part, "bits after the strings");
    }
    if (image->header.id_checks && check_ids(image, part, room_end) != 0) {
        return -1;
    }
    const uint32_t check = decoder_check(&part->in, at, bytes, 6);
    return check == decoder_bits(&part->in, part->end + 48, 16)
               ? 0
               : part_wrong(image, part, "check of the geometry part");
}

int decoder_geometry_part(decoded_image *image, decoder_part *part) {
    decoded_block *block = part->block;
    const int lattice = image->header.geometry_format == 1;
    block->first_triangle = image->triangles;
    if (block->leaves == 0) {
        return block->geometry_bytes == 0 ? 0 : part_wrong(image, part, "geometry without leaves");
    }
    const size_t counts_end = read_leaves(image, part);
    const size_t strings_end = lattice ? lay_out(part, counts_end) : counts_end;
    if (check_part(image, part, strings_end) != 0) {
        return -1;
    }
    return lattice ? read_strips(image, part) : read_records(image, part);
}
