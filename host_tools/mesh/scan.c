/* scan - lines and words of a text that is not trusted
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/scan.h"

#include <string.h>

#include "host_tools/mesh/decimal.h"

scan scan_begin(const unsigned char *bytes, size_t size) {
    const size_t mark = size >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    return (scan){.at = bytes + mark, .end = bytes + size, .line = 1};
}

int byte_is_filler(unsigned char c) {
    return c == 0 || c == 0x1a;
}

scan scan_begin_filled(const unsigned char *bytes, size_t size) {
    const unsigned char *first = bytes, *last = bytes + size;
    while (first < last && byte_is_filler(*first)) {
        first++;
    }
    while (last > first && byte_is_filler(last[-1])) {
        last--;
    }
    return scan_begin(first, (size_t)(last - first));
}

static int is_blank(unsigned char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/* Bytes of the line end at `at`: 0 when there is none. */
static size_t line_end(const scan *s, const unsigned char *at) {
    if (at == s->end) {
        return 0;
    }
    if (*at == '\r') {
        return s->end - at > 1 && at[1] == '\n' ? 2 : 1;
    }
    return *at == '\n';
}

/* Bytes of the joint of two lines at `at`: 0 when there is none. */
static size_t joint(const scan *s, const unsigned char *at) {
    if (!s->continued || at == s->end || *at != '\\') {
        return 0;
    }
    const unsigned char *after = at + 1;
    while (after < s->end && is_blank(*after)) {
        after++;
    }
    const size_t ending = line_end(s, after);
    return ending ? (size_t)(after - at) + ending : 0;
}

static int ends_word(const scan *s, const unsigned char *at) {
    return at == s->end || is_blank(*at) || *at == '\n' || *at == '\r' || joint(s, at);
}

static void skip_blanks(scan *s) {
    while (s->at < s->end) {
        const size_t joined = joint(s, s->at);
        if (joined) {
            s->at += joined;
            s->line++;
        } else if (is_blank(*s->at)) {
            s->at++;
        } else {
            return;
        }
    }
}

int scan_line_done(scan *s) {
    skip_blanks(s);
    return s->at == s->end || *s->at == '\n' || *s->at == '\r';
}

int scan_next_line(scan *s) {
    while (s->at < s->end && *s->at != '\n' && *s->at != '\r') {
        s->at++;
    }
    if (s->at == s->end) {
        return 0;
    }
    s->at += line_end(s, s->at);
    if (s->at == s->end) {
        return 0;
    }
    s->line++;
    return 1;
}

word scan_word(scan *s) {
    skip_blanks(s);
    const unsigned char *first = s->at;
    while (!ends_word(s, s->at)) {
        s->at++;
    }
    return (word){(const char *)first, (size_t)(s->at - first)};
}

static int advance(scan *s, const unsigned char *after) {
    if (!after || !ends_word(s, after)) {
        return -1;
    }
    s->at = after;
    return 0;
}

int scan_float(scan *s, float *value) {
    skip_blanks(s);
    return advance(s, decimal_float(s->at, s->end, value));
}

int scan_real(scan *s, real *value) {
    skip_blanks(s);
    return advance(s, decimal_real(s->at, s->end, value));
}

int scan_integer(scan *s, int64_t *value) {
    skip_blanks(s);
    return advance(s, decimal_integer(s->at, s->end, value));
}

int word_is(word w, const char *text) {
    return strlen(text) == w.length && memcmp(w.text, text, w.length) == 0;
}

int word_is_in_any_case(word w, const char *lower) {
    size_t i = 0;
    while (i < w.length && lower[i] && (w.text[i] == lower[i] || (w.text[i] | 0x20) == lower[i])) {
        i++;
    }
    return i == w.length && !lower[i];
}

int word_is_word(word a, word b) {
    return a.length == b.length && memcmp(a.text, b.text, a.length) == 0;
}

int word_integer(word w, int64_t *value) {
    const unsigned char *at = (const unsigned char *)w.text, *end = at + w.length;
    return decimal_integer(at, end, value) == end && w.length > 0 ? 0 : -1;
}

word scan_rest(scan *s) {
    word w = {NULL, 0};
    while (!scan_line_done(s)) {
        const word next = scan_word(s);
        w.text = w.length == 0 ? next.text : w.text;
        w.length = (size_t)(next.text + next.length - w.text);
    }
    return w;
}
