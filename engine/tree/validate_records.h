/* validate_records - are float records what the header says?
 *
 * Both formats may carry them. They are checked once, when an image is opened;
 * nothing behind that checks again (SPEC.md, section 5).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_VALIDATE_RECORDS_H
#define PLT_TREE_VALIDATE_RECORDS_H

#include "engine/image/header.h"
#include "engine/tree/record.h"

/* I5 and I7: corners finite and inside the scene's box, id words in range. */
int plt_records_validate(const plt_header *header, const plt_record *records, plt_fault *fault);

#if PLT_WITH_VERTICES
/* The same of `count` of them, of which `records` has just those; `first` is the first one. */
int plt_records_validate_some(const plt_header *header, const plt_record *records, uint32_t first,
                              uint32_t count, plt_fault *fault);
#endif

#endif
