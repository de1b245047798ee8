/* block_decoder_part - what the files of block_decoder tell each other
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_BLOCK_DECODER_PART_H
#define REFERENCE_BLOCK_DECODER_PART_H
#include "tests/reference/block_decoder.h"
#include "tests/reference/block_decoder_bytes.h"

/* The block in hand. Places are bits from the start of the blocks section. */
typedef struct decoder_part {
    decoder_bytes in; /* the blocks section, up to the end of the last block */
    decoder_bytes records, numbers;
    decoded_block *block;
    size_t mask_a, mask_b, owners, planes, links, end;
    size_t counts[2], start, swap, fresh, refs, positions;
    unsigned ref_bits, position_bits[3];
    int32_t vertex_lo[3];
} decoder_part;

/* Kind of a slot, and how many slots before it are of its kind (leaves and
 * pairs are one kind). */
enum decoded_kind decoder_slot_kind(decoder_part *part, uint32_t slot);
uint32_t decoder_slot_rank(decoder_part *part, uint32_t slot);

/* Reads the nodes part at the block's address, then appends its nodes. */
int decoder_nodes_part(decoded_image *image, decoder_part *part);

/* Appends the block's leaves and triangles; the nodes part comes first. */
int decoder_geometry_part(decoded_image *image, decoder_part *part);

/* The check of 16 bits over `size` bytes at byte `at`, the two bytes of the
 * check itself at byte `hole` of them. */
uint32_t decoder_check(const decoder_bytes *in, size_t at, size_t size, size_t hole);

/* `array` with room for one more than `count` elements; fills it with 0. */
void *decoder_room(void *array, uint32_t count, size_t element_bytes);

#endif
