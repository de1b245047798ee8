/* checks - what a scene that stays in its source is checked by, part by part (SPEC.md, 4.14)
 *
 * SPDX-License-Identifier: MIT */
#ifndef CHECKS_H
#define CHECKS_H
#include <stdint.h>

#include "engine/image/header.h"
#include "engine/tree/record.h"
#include "engine/tree/thesis/node.h"

/* Into the unused bits of the id words: `records` is a multiple of PLT_PAGE_RECORDS. */
void checks_put_records(plt_record *record, uint32_t records);

/* A byte for each node. */
void checks_put_nodes(unsigned char *to, const plt_node *node, uint32_t nodes);

/* Those of primitive ids, into the blocks of a header that describes them; both sections are as
 * the image will have them. */
void checks_put_ids(unsigned char *blocks, const unsigned char *ids, const plt_header *header);

#endif
