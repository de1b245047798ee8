/* count_list - see count_list.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/count_list.h"

#include <stdio.h>

void count_list_add(count_list *c, uint64_t count, const char *one, const char *many) {
    if (count > 0 && c->used < sizeof c->text) {
        const int n =
            snprintf(c->text + c->used, sizeof c->text - c->used, "%s%llu %s",
                     c->used > 0 ? ", " : "", (unsigned long long)count, count == 1 ? one : many);
        c->used += n > 0 ? (size_t)n : 0;
    }
}
