/* count_list - a list of counts in words: "2 points, 1 normal"
 *
 * SPDX-License-Identifier: MIT */
#ifndef COUNT_LIST_H
#define COUNT_LIST_H
#include <stddef.h>
#include <stdint.h>

typedef struct count_list {
    char text[400];
    size_t used; /* of `text`; what does not fit is cut off */
} count_list;

/* Adds "COUNT ONE" or "COUNT MANY"; nothing for a count of 0. */
void count_list_add(count_list *c, uint64_t count, const char *one, const char *many);

#endif
