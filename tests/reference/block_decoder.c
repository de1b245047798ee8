/* block_decoder - the walk over all blocks of a compact image
 *
 * Blocks are met depth first, so in the order of their addresses: each shall
 * begin where the one before it ended.
 *
 * Source: SPEC.md, sections 3, 4.8 and 5.3.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/block_decoder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/reference/block_decoder_part.h"

#define LINK_NONE 0xFFFFFFFFu

/* A link that waits, and the nodes above what it leads to. */
typedef struct waiting {
    uint32_t address, nodes_bytes, depth;
} waiting;

typedef struct block_walk {
    decoder_part part;
    waiting *stack;
    uint32_t waiting;
    uint32_t end; /* where the block before ended */
    uint32_t geometry_bytes;
} block_walk;

void *decoder_room(void *array, uint32_t count, size_t element_bytes) {
    if ((count & (count - 1)) == 0) {
        array = realloc(array, (count == 0 ? 1 : 2 * (size_t)count) * element_bytes);
        if (array == NULL) {
            fprintf(stderr, "block_decoder: out of memory\n");
            exit(1);
        }
    }
    memset((char *)array + count * element_bytes, 0, element_bytes);
    return array;
}

uint32_t decoder_check(const decoder_bytes *in, size_t at, size_t size, size_t hole) {
    if (at > in->size || size > in->size - at) {
        return 0x10000; /* no check of 16 bits */
    }
    const uint32_t crc = decoder_crc(in->at + at, size, hole, 2);
    return (crc ^ crc >> 16) & 0xFFFFu;
}

static void push(block_walk *walk, uint32_t link, uint32_t depth) {
    walk->stack = decoder_room(walk->stack, walk->waiting, sizeof *walk->stack);
    walk->stack[walk->waiting++] = (waiting){8 * (link & 0xFFFFFFu), 4 * (link >> 24), depth};
}

/* The stack's part from `from` on, so that the least address is on top. */
static void sort_down(block_walk *walk, uint32_t from) {
    for (uint32_t i = from; i < walk->waiting; i++) {
        for (uint32_t k = i; k > from; k--) {
            waiting *later = &walk->stack[k], *sooner = &walk->stack[k - 1];
            if (sooner->address < later->address) {
                const waiting swapped = *later;
                *later = *sooner;
                *sooner = swapped;
            }
        }
    }
}

/* Nodes above each node of the block, and the edges of each. */
static void push_edges(decoded_image *image, block_walk *walk) {
    const decoded_block *block = walk->part.block;
    uint32_t depth[64];
    const uint32_t from = walk->waiting;
    depth[0] = block->depth;
    for (uint32_t i = 0; i < block->nodes; i++) {
        const decoded_node *node = &image->node[block->first_node + i];
        image->depth = image->depth > depth[i] + 1 ? image->depth : depth[i] + 1;
        for (uint32_t c = 0; c < 2; c++) {
            const decoded_child *child = &node->child[c];
            if (child->kind == DECODED_INNER) {
                depth[child->which - block->first_node] = depth[i] + 1;
            } else if (child->kind == DECODED_EDGE) {
                const uint32_t rank = decoder_slot_rank(&walk->part, 2 * i + c);
                const size_t place = walk->part.links + 32 * (size_t)rank;
                push(walk, decoder_bits(&walk->part.in, place, 32), depth[i] + 1);
            }
        }
    }
    sort_down(walk, from);
}

/* Padding of the block, and where it ends. */
static int end_block(decoded_image *image, block_walk *walk) {
    decoded_block *block = walk->part.block;
    const uint32_t used = block->nodes_bytes + block->geometry_bytes;
    block->takes_bytes = (used + 7) / 8 * 8;
    const size_t used_end = (size_t)block->address + used;
    const size_t end = (size_t)block->address + block->takes_bytes;
    if (!decoder_is_zero(&walk->part.in, 8 * used_end, 8 * end) || walk->part.in.overrun) {
        return block_decode_wrong(image, "block %u: its end", block->address);
    }
    walk->end = (uint32_t)end;
    walk->geometry_bytes += block->geometry_bytes;
    return 0;
}

static int read_block(decoded_image *image, block_walk *walk, const waiting *link) {
    image->block = decoder_room(image->block, image->blocks, sizeof *image->block);
    decoded_block *block = &image->block[image->blocks];
    block->address = link->address;
    block->depth = link->depth;
    walk->part.block = block;
    if (block->address != walk->end) {
        return block_decode_wrong(image, "block %u: expected at %u", block->address, walk->end);
    }
    if (decoder_nodes_part(image, &walk->part) != 0 ||
        decoder_geometry_part(image, &walk->part) != 0 || end_block(image, walk) != 0) {
        return -1;
    }
    if (block->nodes_bytes != link->nodes_bytes) {
        return block_decode_wrong(image, "block %u: nodes part is not the link's", block->address);
    }
    push_edges(image, walk);
    image->blocks++;
    return 0;
}

/* Edges held addresses so far. */
static int resolve_edges(decoded_image *image) {
    for (uint32_t i = 0; i < 2 * image->nodes; i++) {
        decoded_child *child = &image->node[i / 2].child[i % 2];
        uint32_t block = image->node[i / 2].block;
        if (child->kind != DECODED_EDGE) {
            continue;
        }
        while (block < image->blocks && image->block[block].address != child->which) {
            block++;
        }
        if (block == image->blocks) {
            return block_decode_wrong(image, "edge to %u: no block", child->which);
        }
        child->which = block;
    }
    return 0;
}

static int check_counts(decoded_image *image, const block_walk *walk) {
    const decoded_header *h = &image->header;
    if (h->triangles != image->triangles || h->nodes != image->nodes ||
        h->leaf_lists != image->leaves - image->pairs || h->intermediate_lists != image->pairs ||
        h->treelets != image->blocks || h->depth_stack != image->depth) {
        return block_decode_wrong(image, "header: counts are not the blocks'");
    }
    if (h->triangle_bytes != walk->geometry_bytes ||
        h->node_bytes != walk->end - walk->geometry_bytes) {
        return block_decode_wrong(image, "header: node bytes or triangle bytes");
    }
    return 0;
}

/* The box at 72 is that of the triangles, no more and no less. */
static int check_tight(decoded_image *image) {
    for (int a = 0; a < 3 && image->triangles > 0; a++) {
        float lo = image->triangle[0].point[0][a], hi = lo;
        for (uint32_t i = 0; i < 3 * image->triangles; i++) {
            const float p = image->triangle[i / 3].point[i % 3][a];
            lo = p < lo ? p : lo;
            hi = p > hi ? p : hi;
        }
        if (lo != image->header.lo[a] || hi != image->header.hi[a]) {
            return block_decode_wrong(image, "header: not the triangles' box on axis %d", a);
        }
    }
    return 0;
}

static decoder_bytes section_of(const decoded_header *h, const unsigned char *bytes,
                                uint32_t kind) {
    for (uint32_t s = 0; s < h->sections; s++) {
        if (h->section[s].kind == kind) {
            return (decoder_bytes){bytes + h->section[s].offset, h->section[s].bytes, 0};
        }
    }
    return (decoder_bytes){bytes, 0, 0};
}

static int walk_blocks(decoded_image *image, block_walk *walk) {
    if (image->header.root_link != LINK_NONE) {
        push(walk, image->header.root_link, 0);
    }
    while (walk->waiting > 0) {
        const waiting link = walk->stack[--walk->waiting];
        if (read_block(image, walk, &link) != 0) {
            return -1;
        }
    }
    return resolve_edges(image) != 0 || check_counts(image, walk) != 0 ? -1 : check_tight(image);
}

int block_decode(decoded_image *image, const unsigned char *bytes, size_t size) {
    if (block_decode_header(image, bytes, size) != 0) {
        return -1;
    }
    const decoded_header *h = &image->header;
    block_walk walk = {0};
    walk.part.in = section_of(h, bytes, 3);
    walk.part.in.size = (size_t)h->node_bytes + h->triangle_bytes;
    walk.part.records = section_of(h, bytes, 2);
    walk.part.numbers = section_of(h, bytes, 4);
    const int status = walk_blocks(image, &walk);
    free(walk.stack);
    if (status == 0 && (walk.part.records.overrun || walk.part.numbers.overrun)) {
        return block_decode_wrong(image, "image: read behind a section");
    }
    return status;
}

void block_decode_free(decoded_image *image) {
    free(image->block);
    free(image->node);
    free(image->leaf);
    free(image->triangle);
    image->block = NULL;
    image->node = NULL;
    image->leaf = NULL;
    image->triangle = NULL;
}
