/* scan - lines and words of a text that is not trusted
 *
 * Keeps: nothing is read at `end` or after it. A line ends in LF, CRLF or CR.
 *
 * SPDX-License-Identifier: MIT */
#ifndef SCAN_H
#define SCAN_H
#include <stddef.h>
#include <stdint.h>

#include "host_tools/mesh/real.h"

typedef struct scan {
    const unsigned char *at, *end;
    size_t line;   /* from 1 */
    int continued; /* 1: a backslash before the line end joins the lines, also one with
                    * blanks behind it */
} scan;

typedef struct word {
    const char *text; /* in the scanned bytes, without a zero byte after it */
    size_t length;    /* 0: the line has no more words */
} word;

/* The text begins behind an UTF-8 mark. */
scan scan_begin(const unsigned char *bytes, size_t size);

/* Zero bytes, and 0x1A, with which old systems ended a text: they may fill a file up. */
int byte_is_filler(unsigned char c);

/* The same without fillers around it. */
scan scan_begin_filled(const unsigned char *bytes, size_t size);

int scan_line_done(scan *s); /* skips blanks; 1 at the line's or text's end */
int scan_next_line(scan *s); /* 0: there is none */
word scan_word(scan *s);
word scan_rest(scan *s); /* all words of the line, with the blanks between them */

/* The next word as a number: 0, or -1 when it is none; then it is still
 * the next word. */
int scan_float(scan *s, float *value);
int scan_real(scan *s, real *value);
int scan_integer(scan *s, int64_t *value);

int word_is(word w, const char *text);
int word_is_in_any_case(word w, const char *lower);
int word_is_word(word a, word b);
int word_integer(word w, int64_t *value); /* 0 or -1 */

/* For "%.*s": at most the first 40 bytes of a word. */
#define WORD_SHOWN(w) (int)((w).length < 40 ? (w).length : 40), (w).text

#endif
