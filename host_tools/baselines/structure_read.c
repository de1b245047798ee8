/* structure_read - structures and their switches as words: "wbvh:sah,4x4"
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "host_tools/baselines/base/kind.h"
#include "host_tools/baselines/structure.h"

/* A list of words, as a sentence has them: "a, b or c". */
typedef struct words {
    char text[320];
    const char *last; /* not in the text yet; NULL: there is none */
    unsigned count;
} words;

static void append(words *w, const char *text) {
    strncat(w->text, text, sizeof w->text - strlen(w->text) - 1);
}

static void add_word(words *w, const char *word) {
    if (w->last != NULL) {
        append(w, w->count > 1 ? ", " : "");
        append(w, w->last);
    }
    w->last = word;
    w->count++;
}

static const char *end_words(words *w) {
    if (w->last != NULL) {
        append(w, w->count > 1 ? " or " : "");
        append(w, w->last);
    }
    return w->text;
}

static const structure_kind *read_name(const char *text, size_t length, const char *what, fail *f) {
    words w = {"", NULL, 0};
    for (const structure_kind *const *k = structure_kinds(); *k != NULL; k++) {
        const char *name = structure_name(*k);
        if (strlen(name) == length && memcmp(name, text, length) == 0) {
            return *k;
        }
        add_word(&w, name);
    }
    fail_set(f, what, "no structure is called '%.*s'; choose %s", (int)length, text, end_words(&w));
    return NULL;
}

/* What the kind has; of one group, or of all. */
static const char *names_of(const structure_kind *kind, int group, words *w) {
    for (const structure_switch *s = structure_switches(kind); s->name != NULL; s++) {
        if (group < 0 || s->group == group) {
            add_word(w, s->name);
        }
    }
    return end_words(w);
}

static const structure_switch *find_switch(const structure_kind *kind, const char *text,
                                           size_t length) {
    const structure_switch *s = structure_switches(kind);
    while (s->name != NULL && (strlen(s->name) != length || memcmp(s->name, text, length) != 0)) {
        s++;
    }
    return s->name != NULL ? s : NULL;
}

static int read_switch(const structure_kind *kind, const char *text, size_t length,
                       const char *what, structure_options *o, fail *f) {
    const structure_switch *s = find_switch(kind, text, length);
    words w = {"", NULL, 0};
    if (structure_switches(kind)->name == NULL) {
        return fail_set(f, what, "%s has no switches; leave ':%.*s' out", structure_name(kind),
                        (int)length, text);
    }
    if (s == NULL) {
        return fail_set(f, what, "%s has no switch '%.*s'; choose %s", structure_name(kind),
                        (int)length, text, names_of(kind, -1, &w));
    }
    if (o->choice[s->group] != 0) {
        return fail_set(f, what, "'%s' is a second choice of one kind; give one of %s", s->name,
                        names_of(kind, s->group, &w));
    }
    o->choice[s->group] = s->value;
    return 0;
}

int structure_suits(const structure_kind *kind, const structure_options *options, fail *f) {
    return kind->suits != NULL ? kind->suits(options, f) : 0;
}

const structure_kind *structure_read(const char *text, const char *what, structure_options *options,
                                     fail *f) {
    const size_t name = strcspn(text, ":");
    const structure_kind *kind = read_name(text, name, what, f);
    structure_options o = {.packet_side = 0};
    int status = kind != NULL ? 0 : -1;
    for (const char *at = text + name; *at != '\0' && status == 0;) {
        const size_t length = strcspn(++at, ",");
        status = read_switch(kind, at, length, what, &o, f);
        at += length;
    }
    if (status != 0 || structure_suits(kind, &o, f) != 0) {
        return NULL;
    }
    const uint8_t side = o.choice[STRUCTURE_SIDE];
    o.one_by_one = side == 0 ? kind->one_by_one : side == 1;
    o.packet_side = side > 1 ? side : 0;
    *options = o;
    return kind;
}

/* ---- the help ------------------------------------------------------------------------- */

enum { COLUMN = 16, WIDTH = 79 };

/* Words from a column on, as a line and those it goes on in. */
static void print_words(FILE *to, const char *text, unsigned *at) {
    while (*text != '\0') {
        const unsigned length = (unsigned)strcspn(text, " ");
        if (*at > COLUMN && *at + 1 + length > WIDTH) {
            fprintf(to, "\n%*s", COLUMN, "");
            *at = COLUMN;
        }
        fprintf(to, "%s%.*s", *at > COLUMN ? " " : "", (int)length, text);
        *at += length + (*at > COLUMN);
        text += length;
        text += *text == ' ';
    }
}

static void print_entry(FILE *to, const char *name, const char *about) {
    unsigned at = COLUMN;
    fprintf(to, "  %-*s", COLUMN - 2, name);
    print_words(to, about, &at);
    fputc('\n', to);
}

/* "median|sah leaf-1|leaf-2 ..." */
static void print_groups(FILE *to, const structure_switch *s) {
    char text[320] = "";
    unsigned at = COLUMN;
    for (int group = -1; s->name != NULL; group = s->group, s++) {
        strncat(text,
                group < 0           ? ""
                : s->group == group ? "|"
                                    : " ",
                sizeof text - strlen(text) - 1);
        strncat(text, s->name, sizeof text - strlen(text) - 1);
    }
    if (text[0] != '\0') {
        fprintf(to, "%*s", COLUMN, "");
        print_words(to, text, &at);
        fputc('\n', to);
    }
}

/* Whether a kind in front of this one has that switch, too. */
static int is_known(const structure_kind *const *until, const char *name) {
    for (const structure_kind *const *k = structure_kinds(); k != until; k++) {
        if (find_switch(*k, name, strlen(name)) != NULL) {
            return 1;
        }
    }
    return 0;
}

void structure_print_kinds(FILE *to) {
    for (const structure_kind *const *k = structure_kinds(); *k != NULL; k++) {
        print_entry(to, structure_name(*k), structure_about(*k));
        print_groups(to, structure_switches(*k));
    }
    fprintf(to, "\nWhat switches mean:\n");
    for (const structure_kind *const *k = structure_kinds(); *k != NULL; k++) {
        for (const structure_switch *s = structure_switches(*k); s->name != NULL; s++) {
            if (!is_known(k, s->name)) {
                print_entry(to, s->name, s->about);
            }
        }
    }
}
