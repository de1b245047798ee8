/* quote - see quote.h
 *
 * Source: IEEE Std 1003.1-2024, Shell and Utilities, section 2.2 (quoting).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/quote.h"

#include <stdio.h>
#include <string.h>

typedef struct word {
    char *at, *end;
    int is_full;
} word;

static void put(word *w, const char *text) {
    const size_t length = strlen(text);
    if (w->is_full || length >= (size_t)(w->end - w->at)) {
        w->is_full = 1;
        return;
    }
    memcpy(w->at, text, length + 1);
    w->at += length;
}

static int is_control(char c) {
    return (unsigned char)c < 0x20 || c == 0x7f;
}

static int has_control(const char *name) {
    for (; *name != '\0'; name++) {
        if (is_control(*name)) {
            return 1;
        }
    }
    return 0;
}

/* No shell takes one of these for anything else, wherever it is in a word. */
static int is_plain(const char *name) {
    static const char plain[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
        "_-./,:+@%";
    return name[0] != '\0' && name[strspn(name, plain)] == '\0';
}

static void put_with_controls(word *w, const char *before, const char *name) {
    put(w, "$'");
    put(w, before);
    for (; *name != '\0'; name++) {
        char text[8] = {*name};
        if (is_control(*name)) {
            snprintf(text, sizeof text, "\\%03o", (unsigned)*name);
        } else if (*name == '\'' || *name == '\\') {
            snprintf(text, sizeof text, "\\%c", *name);
        }
        put(w, text);
    }
    put(w, "'");
}

static void put_in_quotes(word *w, const char *before, const char *name) {
    put(w, "'");
    put(w, before);
    for (; *name != '\0'; name++) {
        const char text[2] = {*name};
        put(w, *name == '\'' ? "'\\''" : text);
    }
    put(w, "'");
}

static const char *quote(char *to, size_t room, const char *before, const char *text) {
    word w = {to, to + room, 0};
    if (is_plain(text)) {
        put(&w, before);
        put(&w, text);
    } else if (has_control(text)) {
        put_with_controls(&w, before, text);
    } else {
        put_in_quotes(&w, before, text);
    }
    return w.is_full ? NULL : to;
}

const char *quote_word(char *to, size_t room, const char *name) {
    return quote(to, room, name[0] == '-' ? "./" : "", name); /* else it would be a flag */
}

const char *quote_value(char *to, size_t room, const char *value) {
    return quote(to, room, "", value);
}
