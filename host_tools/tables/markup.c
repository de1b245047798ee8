/* markup - see markup.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/markup.h"

void markup_text(output *o, const char *text, fail *f) {
    for (; *text != '\0'; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '<' || c == '>' || c == '&' || c == '"') {
            output_print(o, f, "&#%u;", (unsigned)c);
        } else {
            output_print(o, f, "%c", c >= ' ' && c != 127 ? c : '?');
        }
    }
}
