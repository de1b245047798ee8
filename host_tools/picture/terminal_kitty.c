/* terminal_kitty - a picture by kitty's protocol, see terminal_graphics.h
 *
 * Source: K. Goyal, "The terminal graphics protocol" (kitty): a=T transmits and shows, f=24 is RGB,
 * o=z zlib, q=2 asks for no answer, C=1 leaves the cursor; at most 4096 letters of base64 per
 * piece, m=1 if more come. RFC 4648, section 4 (base64).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/bits.h"
#include "host_tools/picture/deflate.h"
#include "host_tools/picture/terminal_graphics.h"

enum { PIECE = 3072 }; /* bytes that make 4096 letters */

static void base64(FILE *to, const uint8_t *bytes, size_t count) {
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < count; i += 3) {
        const size_t left = count - i;
        const uint32_t word = (uint32_t)bytes[i] << 16 |
                              (left > 1 ? (uint32_t)bytes[i + 1] << 8 : 0) |
                              (left > 2 ? bytes[i + 2] : 0u);
        fputc(letters[word >> 18], to);
        fputc(letters[word >> 12 & 63], to);
        fputc(left > 1 ? letters[word >> 6 & 63] : '=', to);
        fputc(left > 2 ? letters[word & 63] : '=', to);
    }
}

int terminal_kitty(FILE *to, const picture *p, unsigned columns, unsigned rows) {
    bits packed = {0};
    if (deflate_zlib(&packed, p->rgb, 3 * (size_t)p->width * p->height) != 0) {
        bits_free(&packed);
        return -1;
    }
    for (size_t at = 0; at < packed.size; at += PIECE) {
        const size_t left = packed.size - at;
        fputs("\x1b_G", to);
        if (at == 0) {
            fprintf(to, "a=T,i=1,p=1,q=2,C=1,f=24,o=z,s=%u,v=%u,c=%u,r=%u,", p->width, p->height,
                    columns, rows);
        }
        fprintf(to, "m=%d;", left > PIECE);
        base64(to, packed.bytes + at, left < PIECE ? left : PIECE);
        fputs("\x1b\\", to);
    }
    bits_free(&packed);
    return 0;
}

void terminal_kitty_end(FILE *to) {
    fputs("\x1b_Ga=d,d=I,i=1,q=2\x1b\\", to);
}
