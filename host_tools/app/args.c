/* args - see args.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/args.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/base/fail.h"

/* fail_set makes one line of it: the words may hold control characters. */
void args_complain(args *a, const char *format, ...) {
    const arg_command *c = a->command;
    char text[400];
    fail line = {""};
    va_list list;
    if (a->wrong) {
        return; /* one line: the first mistake */
    }
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    fail_set(&line, NULL, "%s %s: %s; see %s %s --help", a->program, c->name, text, a->program,
             c->name);
    fprintf(stderr, "%s\n", line.text);
    a->wrong = 1;
}

enum { HELP_COLUMN = 30, HELP_WIDTH = 80 };

/* Prints words from column `at` on, further lines from `indent`. */
static void print_words(const char *text, size_t at, size_t indent) {
    while (*text != '\0') {
        const size_t length = strcspn(text, " ");
        if (at > indent && at + 1 + length > HELP_WIDTH) {
            printf("\n%*s", (int)indent, "");
            at = indent;
        } else if (at > indent) {
            putchar(' ');
            at++;
        }
        printf("%.*s", (int)length, text);
        at += length;
        text += length + (text[length] == ' ');
    }
    putchar('\n');
}

static void print_flag(const arg_flag *f) {
    const int n =
        printf("  %s%s%s", f->name, f->value == NULL ? "" : " ", f->value == NULL ? "" : f->value);
    if (n < HELP_COLUMN) {
        printf("%*s", HELP_COLUMN - n, "");
    } else {
        printf("\n%*s", HELP_COLUMN, "");
    }
    print_words(f->help, HELP_COLUMN, HELP_COLUMN);
}

void args_help(const char *program, const arg_command *c) {
    const arg_flag help = {"--help", NULL, "this text"};
    printf("%s %s %s\n\n", program, c->name, c->synopsis);
    print_words(c->about, 0, 0);
    putchar('\n');
    for (const arg_flag *f = c->flags; f->name != NULL; f++) {
        print_flag(f);
    }
    print_flag(&help);
    if (c->notes != NULL) {
        printf("\n%s", c->notes);
    }
    if (c->print_notes != NULL) {
        putchar('\n');
        c->print_notes(stdout);
    }
}

/* The flag whose name is the first `length` characters of `word`, or -1. */
static int flag_index(const arg_command *c, const char *word, size_t length) {
    for (int i = 0; c->flags[i].name != NULL; i++) {
        if (strncmp(c->flags[i].name, word, length) == 0 && c->flags[i].name[length] == '\0') {
            return i;
        }
    }
    return -1;
}

static int is_flag(const arg_command *c, const char *word) {
    return flag_index(c, word, strlen(word)) >= 0;
}

/* Reads the flag in argv[*i] and its value, which follows a '=' or is the next
 * word. */
static void read_flag(args *a, int argc, char **argv, int *i) {
    const char *word = argv[*i];
    const char *equals = strncmp(word, "--", 2) == 0 ? strchr(word, '=') : NULL;
    const size_t length = equals == NULL ? strlen(word) : (size_t)(equals - word);
    const int index = flag_index(a->command, word, length);
    if (index < 0) {
        args_complain(a, "there is no flag %.*s", (int)length, word);
        return;
    }
    const char *value = a->command->flags[index].value;
    if (value == NULL && equals == NULL) {
        a->value[index] = "";
    } else if (value == NULL) {
        args_complain(a, "%.*s takes no value", (int)length, word);
    } else if (equals != NULL) {
        a->value[index] = equals + 1;
    } else if (*i + 1 == argc || is_flag(a->command, argv[*i + 1])) {
        args_complain(a, "%s takes a value: %s %s", word, word, value);
    } else {
        a->value[index] = argv[++*i];
    }
}

static int is_help(const char *word) {
    return strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0;
}

int args_parse(args *a, const char *program, const arg_command *command, int argc, char **argv) {
    memset(a, 0, sizeof *a);
    a->program = program;
    a->command = command;
    a->file = malloc((size_t)(argc + 1) * sizeof *a->file);
    if (a->file == NULL) {
        fprintf(stderr, "%s %s: out of memory; close other programs\n", program, command->name);
        return 1;
    }
    int files_only = 0; /* after a "--" */
    for (int i = 0; i < argc && !a->wrong; i++) {
        if (files_only || argv[i][0] != '-' || argv[i][1] == '\0') {
            a->file[a->files++] = argv[i];
        } else if (strcmp(argv[i], "--") == 0) {
            files_only = 1;
        } else if (is_help(argv[i])) {
            args_help(program, command);
            return 0;
        } else {
            read_flag(a, argc, argv, &i);
        }
    }
    if (!a->wrong && (a->files < command->files_least || a->files > command->files_most)) {
        args_complain(a, "use it as: %s %s %s", program, command->name, command->synopsis);
    }
    return a->wrong ? 2 : ARGS_GO_ON;
}

void args_free(args *a) {
    free(a->file);
    a->file = NULL;
}

const char *args_text(const args *a, const char *flag, const char *otherwise) {
    const int index = flag_index(a->command, flag, strlen(flag));
    return index >= 0 && a->value[index] != NULL ? a->value[index] : otherwise;
}

int args_has(const args *a, const char *flag) {
    return args_text(a, flag, NULL) != NULL;
}

uint64_t args_number(args *a, const char *flag, uint64_t otherwise, uint64_t least, uint64_t most) {
    const char *text = args_text(a, flag, NULL);
    if (text == NULL) {
        return otherwise;
    }
    char *end;
    errno = 0;
    const unsigned long long value = strtoull(text, &end, 10);
    if (text[0] < '0' || text[0] > '9' || *end != '\0' || errno != 0 || value < least ||
        value > most) {
        args_complain(a, "%s takes a number from %llu to %llu, not '%s'", flag,
                      (unsigned long long)least, (unsigned long long)most, text);
        return otherwise;
    }
    return value;
}

/* "depth or two-stage" */
static void list_words(char *list, size_t room, const char *const *words) {
    list[0] = '\0';
    for (unsigned i = 0; words[i] != NULL; i++) {
        strncat(list, i > 0 ? " or " : "", room - strlen(list) - 1);
        strncat(list, words[i], room - strlen(list) - 1);
    }
}

unsigned args_choice(args *a, const char *flag, const char *const *words, unsigned otherwise) {
    const char *text = args_text(a, flag, NULL);
    char list[160];
    if (text == NULL) {
        return otherwise;
    }
    for (unsigned i = 0; words[i] != NULL; i++) {
        if (strcmp(words[i], text) == 0) {
            return i;
        }
    }
    list_words(list, sizeof list, words);
    args_complain(a, "%s takes %s, not '%s'", flag, list, text);
    return otherwise;
}

/* The word that is the first `length` characters of `text`, as a bit; 0: none. */
static unsigned word_bit(const char *const *words, const char *text, size_t length) {
    for (unsigned i = 0; words[i] != NULL; i++) {
        if (strncmp(words[i], text, length) == 0 && words[i][length] == '\0') {
            return 1u << i;
        }
    }
    return 0;
}

unsigned args_set(args *a, const char *flag, const char *const *words, unsigned otherwise) {
    const char *text = args_text(a, flag, NULL);
    unsigned set = 0;
    for (const char *at = text; at != NULL;) {
        const size_t length = strcspn(at, ",");
        const unsigned bit = word_bit(words, at, length);
        if (bit == 0) {
            char list[160];
            list_words(list, sizeof list, words);
            args_complain(a, "%s takes %s, several with commas between, not '%s'", flag, list,
                          text);
            return otherwise;
        }
        set |= bit;
        at = at[length] == ',' ? at + length + 1 : NULL;
    }
    return text != NULL ? set : otherwise;
}

static void complain_numbers(args *a, const char *flag, unsigned count, const char *text) {
    if (count == 1) {
        args_complain(a, "%s takes a number, not '%s'", flag, text);
    } else {
        args_complain(a, "%s takes %u numbers separated by commas, not '%s'", flag, count, text);
    }
}

/* Each number rounded once to what was asked for: the other one is NULL. */
static int read_numbers(args *a, const char *flag, float *single, double *wide, unsigned count) {
    const char *text = args_text(a, flag, NULL);
    const char *at = text;
    if (text == NULL) {
        return 0;
    }
    for (unsigned i = 0; i < count; i++) {
        char *end;
        const double value = single != NULL ? (double)strtof(at, &end) : strtod(at, &end);
        if (end == at || !isfinite(value) || *end != (i + 1 < count ? ',' : '\0')) {
            complain_numbers(a, flag, count, text);
            return 0;
        }
        if (single != NULL) {
            single[i] = (float)value;
        } else {
            wide[i] = value;
        }
        at = end + 1;
    }
    return 1;
}

int args_floats(args *a, const char *flag, float *values, unsigned count) {
    return read_numbers(a, flag, values, NULL, count);
}

int args_doubles(args *a, const char *flag, double *values, unsigned count) {
    return read_numbers(a, flag, NULL, values, count);
}

int args_size(args *a, const char *flag, unsigned most, unsigned *width, unsigned *height) {
    const char *text = args_text(a, flag, NULL);
    if (text == NULL) {
        return 0;
    }
    unsigned w = 0, h = 0;
    int length = 0;
    if (sscanf(text, "%5ux%5u%n", &w, &h, &length) != 2 || text[length] != '\0' || w < 1 || h < 1 ||
        w > most || h > most) {
        args_complain(a, "%s takes WIDTHxHEIGHT, each 1 to %u, not '%s'", flag, most, text);
        return 0;
    }
    *width = w;
    *height = h;
    return 1;
}
