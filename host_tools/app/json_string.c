/* json_string - see json_string.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/json_string.h"

/* Bytes of the UTF-8 character at `c`, in a text that a zero byte ends: 0 when it is none. */
static size_t character_bytes(const unsigned char *c) {
    const size_t bytes = c[0] < 0x80 ? 1 : c[0] < 0xC2 ? 0 : c[0] < 0xE0 ? 2 : c[0] < 0xF0 ? 3 : 4;
    for (size_t i = 1; i < bytes; i++) {
        if (c[i] >> 6 != 2) {
            return 0;
        }
    }
    const int is_wrong = (c[0] == 0xE0 && c[1] < 0xA0) || (c[0] == 0xED && c[1] > 0x9F) ||
                         (c[0] == 0xF0 && c[1] < 0x90) || (c[0] == 0xF4 && c[1] > 0x8F) ||
                         c[0] > 0xF4;
    return is_wrong ? 0 : bytes;
}

int json_write_string(output *o, const char *text, fail *f) {
    int status = output_print(o, f, "\"");
    for (const unsigned char *c = (const unsigned char *)text; *c != '\0' && status == 0;) {
        const size_t bytes = character_bytes(c);
        status = bytes == 0                ? output_print(o, f, "\\ufffd")
                 : *c < 0x20 || *c == 0x7f ? output_print(o, f, "\\u%04x", *c)
                 : *c == '"' || *c == '\\' ? output_print(o, f, "\\%c", *c)
                                           : output_write(o, c, bytes, f);
        c += bytes > 0 ? bytes : 1;
    }
    return status == 0 ? output_print(o, f, "\"") : -1;
}
