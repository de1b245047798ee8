/* block_decoder_nodes - the nodes part of a compact block
 *
 * Source: SPEC.md, section 4.9.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/block_decoder_part.h"

enum { MIN_X, MIN_Y, MIN_Z, MAX_X, MAX_Y, MAX_Z };

static size_t whole_bytes(size_t bits) {
    return (bits + 7) / 8;
}

enum decoded_kind decoder_slot_kind(decoder_part *part, uint32_t slot) {
    const uint32_t a = decoder_bits(&part->in, part->mask_a + slot, 1);
    const uint32_t b = decoder_bits(&part->in, part->mask_b + slot, 1);
    if (a) {
        return b ? DECODED_EDGE : DECODED_INNER;
    }
    return b ? DECODED_PAIR : DECODED_LEAF;
}

static int same_rank(enum decoded_kind x, enum decoded_kind y) {
    const int both_units = x >= DECODED_LEAF && y >= DECODED_LEAF;
    return x == y || both_units;
}

uint32_t decoder_slot_rank(decoder_part *part, uint32_t slot) {
    const enum decoded_kind kind = decoder_slot_kind(part, slot);
    uint32_t rank = 0;
    for (uint32_t before = 0; before < slot; before++) {
        rank += (uint32_t)same_rank(decoder_slot_kind(part, before), kind);
    }
    return rank;
}

static void count_kinds(decoder_part *part, uint32_t *inner) {
    decoded_block *block = part->block;
    for (uint32_t slot = 0; slot < 2 * block->nodes; slot++) {
        const enum decoded_kind kind = decoder_slot_kind(part, slot);
        *inner += kind == DECODED_INNER;
        block->edges += kind == DECODED_EDGE;
        block->leaves += kind >= DECODED_LEAF;
    }
}

/* Where the rows of the nodes part lie; how many there are of each kind. */
static int lay_out(decoded_image *image, decoder_part *part) {
    decoded_block *block = part->block;
    const size_t begin = block->address, n = block->nodes;
    const size_t frame_bytes = image->header.lattice_bits <= 16 ? 12 : 16;
    size_t at = begin + 4 + frame_bytes;
    part->mask_a = 8 * at;
    at += whole_bytes(2 * n);
    part->mask_b = 8 * at;
    at += whole_bytes(2 * n);
    part->owners = 8 * at;
    at += whole_bytes(5 * n);
    part->planes = 8 * at;
    at += 6 * n;
    part->links = 8 * at;
    uint32_t inner = 0;
    count_kinds(part, &inner);
    at += 4 * (size_t)block->edges;
    const size_t end = begin + (at - begin + 3) / 4 * 4;
    block->nodes_bytes = (uint32_t)(end - begin);
    part->end = 8 * end;
    if (inner != n - 1 || block->edges + block->leaves != n + 1) {
        return block_decode_wrong(image, "block %u: %u inner of %u nodes", block->address, inner,
                                  block->nodes);
    }
    return decoder_is_zero(&part->in, 8 * at, 8 * end)
               ? 0
               : block_decode_wrong(image, "block %u: padding", block->address);
}

/* Bits behind the last one of a string that begins a row. */
static int rows_end_in_zeros(decoder_part *part) {
    const size_t n = part->block->nodes;
    return decoder_is_zero(&part->in, part->mask_a + 2 * n, part->mask_b) &&
           decoder_is_zero(&part->in, part->mask_b + 2 * n, part->owners) &&
           decoder_is_zero(&part->in, part->owners + 5 * n, part->planes);
}

static void set_floats(const decoded_header *header, decoded_box *box) {
    for (int a = 0; a < 3; a++) {
        box->float_lo[a] = block_decode_float(header, a, box->lo[a]);
        box->float_hi[a] = block_decode_float(header, a, box->hi[a]);
    }
}

static int read_frame(decoded_image *image, decoder_part *part) {
    const decoded_header *h = &image->header;
    const unsigned w = h->lattice_bits <= 16 ? 16 : 21;
    const size_t frame = 8 * ((size_t)part->block->address + 4);
    decoded_box *box = &part->block->frame;
    for (size_t a = 0; a < 3; a++) {
        box->lo[a] = (int32_t)decoder_bits(&part->in, frame + a * w, w);
        box->hi[a] = (int32_t)decoder_bits(&part->in, frame + (3 + a) * w, w);
        if (box->lo[a] > box->hi[a] || box->lo[a] < (int32_t)h->lattice_lo[a] ||
            box->hi[a] > (int32_t)h->lattice_hi[a]) {
            return block_decode_wrong(image, "block %u: frame", part->block->address);
        }
    }
    set_floats(h, box);
    return decoder_is_zero(&part->in, frame + (size_t)6 * w, part->mask_a)
               ? 0
               : block_decode_wrong(image, "block %u: behind the frame", part->block->address);
}

static int32_t step_of(int32_t extent) {
    return extent <= 255 ? 1 : (extent + 254) / 255;
}

/* Whether child `child` owns plane `plane` of node `node`. */
static int owns(decoder_part *part, uint32_t node, int plane, uint32_t child) {
    static const int bit_of[6] = {[MIN_Y] = 0, [MIN_Z] = 1, [MAX_X] = 2, [MAX_Y] = 3, [MAX_Z] = 4};
    if (plane == MIN_X) {
        return child == 1;
    }
    const size_t bit = part->owners + 5 * (size_t)node + (size_t)bit_of[plane];
    return decoder_bits(&part->in, bit, 1) == child;
}

static int32_t plane_byte(decoder_part *part, uint32_t node, int plane) {
    const size_t bit = part->planes + 8 * (6 * (size_t)node + (size_t)plane);
    return (int32_t)decoder_bits(&part->in, bit, 8);
}

static decoded_box child_box(const decoded_header *header, decoder_part *part, uint32_t node,
                             const decoded_box *own, uint32_t child) {
    decoded_box box = *own;
    for (int a = 0; a < 3; a++) {
        const int32_t step = step_of(own->hi[a] - own->lo[a]);
        if (owns(part, node, MIN_X + a, child)) {
            box.lo[a] = own->lo[a] + plane_byte(part, node, MIN_X + a) * step;
        }
        if (owns(part, node, MAX_X + a, child)) {
            box.hi[a] = own->hi[a] - plane_byte(part, node, MAX_X + a) * step;
        }
    }
    set_floats(header, &box);
    return box;
}

/* Index of what the child is; of an edge its address, until all are known. */
static uint32_t child_which(decoder_part *part, uint32_t slot, enum decoded_kind kind) {
    const uint32_t rank = decoder_slot_rank(part, slot);
    if (kind == DECODED_INNER) {
        return part->block->first_node + 1 + rank;
    }
    if (kind == DECODED_EDGE) {
        return 8 * decoder_bits(&part->in, part->links + 32 * (size_t)rank, 24);
    }
    return part->block->first_leaf + rank;
}

static int add_node(decoded_image *image, decoder_part *part, uint32_t number) {
    const uint32_t index = part->block->first_node + number;
    decoded_node *node = &image->node[index];
    node->block = image->blocks;
    for (uint32_t c = 0; c < 2; c++) {
        decoded_child *child = &node->child[c];
        child->kind = decoder_slot_kind(part, 2 * number + c);
        child->which = child_which(part, 2 * number + c, child->kind);
        child->box = child_box(&image->header, part, number, &node->box, c);
        if (child->kind == DECODED_INNER) {
            if (child->which <= index || child->which >= image->nodes) {
                return block_decode_wrong(image, "block %u: nodes are no tree",
                                          part->block->address);
            }
            image->node[child->which].box = child->box;
        }
    }
    return 0;
}

int decoder_nodes_part(decoded_image *image, decoder_part *part) {
    decoded_block *block = part->block;
    const size_t head = 8 * (size_t)block->address;
    block->nodes = 1 + decoder_bits(&part->in, head, 6);
    block->geometry_bytes = 8 * decoder_bits(&part->in, head + 6, 10);
    block->first_node = image->nodes;
    block->first_leaf = image->leaves;
    if (lay_out(image, part) != 0 || read_frame(image, part) != 0) {
        return -1;
    }
    if (part->in.overrun || !rows_end_in_zeros(part)) {
        return block_decode_wrong(image, "block %u: ends of rows", block->address);
    }
    const uint32_t check = decoder_check(&part->in, block->address, block->nodes_bytes, 2);
    if (check != decoder_bits(&part->in, head + 16, 16)) {
        return block_decode_wrong(image, "block %u: check of the nodes part", block->address);
    }
    for (uint32_t i = 0; i < block->nodes; i++) {
        image->node = decoder_room(image->node, image->nodes++, sizeof *image->node);
    }
    image->node[block->first_node].box = block->frame;
    for (uint32_t i = 0; i < block->nodes; i++) {
        if (add_node(image, part, i) != 0) {
            return -1;
        }
    }
    return 0;
}
