/* args - see args.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/args.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void args_complain(args *a, const char *format, ...) {
    va_list list;
    va_start(list, format);
    fprintf(stderr, "planelet %s: ", a->command->name);
    vfprintf(stderr, format, list);
    fprintf(stderr, "; see planelet %s --help\n", a->command->name);
    va_end(list);
    a->wrong = 1;
}

void args_help(const arg_command *c) {
    printf("planelet %s %s\n\n%s\n\n", c->name, c->synopsis, c->about);
    for (const arg_flag *f = c->flags; f->name != NULL; f++) {
        char left[64];
        snprintf(left, sizeof left, "%s %s", f->name, f->value == NULL ? "" : f->value);
        printf("  %-28s %s\n", left, f->help);
    }
    printf("  %-28s %s\n", "--help", "this text");
}

static int flag_number(const arg_command *c, const char *name) {
    for (int i = 0; c->flags[i].name != NULL; i++) {
        if (strcmp(c->flags[i].name, name) == 0) {
            return i;
        }
    }
    return -1;
}

/* Takes argv[*i], and its value if it has one. */
static void take_word(args *a, int argc, char **argv, int *i) {
    const char *word = argv[*i];
    if (word[0] != '-' || word[1] == '\0') {
        a->file[a->files++] = argv[*i];
        return;
    }
    const int number = flag_number(a->command, word);
    if (number < 0) {
        args_complain(a, "there is no flag %s", word);
    } else if (a->command->flags[number].value == NULL) {
        a->value[number] = "";
    } else if (*i + 1 == argc) {
        args_complain(a, "%s takes a value", word);
    } else {
        a->value[number] = argv[++*i];
    }
}

int args_parse(args *a, const arg_command *command, int argc, char **argv) {
    memset(a, 0, sizeof *a);
    a->command = command;
    a->file = malloc((size_t)(argc + 1) * sizeof *a->file);
    if (a->file == NULL) {
        args_complain(a, "out of memory");
        return 1;
    }
    for (int i = 0; i < argc && !a->wrong; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            args_help(command);
            return 0;
        }
        take_word(a, argc, argv, &i);
    }
    if (!a->wrong && (a->files < command->files_least || a->files > command->files_most)) {
        args_complain(a, "use it as: planelet %s %s", command->name, command->synopsis);
    }
    return a->wrong ? 2 : ARGS_GO_ON;
}

void args_free(args *a) {
    free(a->file);
    a->file = NULL;
}

const char *args_text(const args *a, const char *flag, const char *otherwise) {
    const int number = flag_number(a->command, flag);
    return number >= 0 && a->value[number] != NULL ? a->value[number] : otherwise;
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

unsigned args_choice(args *a, const char *flag, const char *const *words, unsigned otherwise) {
    const char *text = args_text(a, flag, NULL);
    char list[160] = "";
    if (text == NULL) {
        return otherwise;
    }
    for (unsigned i = 0; words[i] != NULL; i++) {
        if (strcmp(words[i], text) == 0) {
            return i;
        }
        strncat(list, i > 0 ? " or " : "", sizeof list - strlen(list) - 1);
        strncat(list, words[i], sizeof list - strlen(list) - 1);
    }
    args_complain(a, "%s takes %s, not '%s'", flag, list, text);
    return otherwise;
}

int args_floats(args *a, const char *flag, float *values, unsigned count) {
    const char *text = args_text(a, flag, NULL);
    const char *at = text;
    if (text == NULL) {
        return 0;
    }
    for (unsigned i = 0; i < count; i++) {
        char *end;
        values[i] = strtof(at, &end);
        if (end == at || !isfinite(values[i]) || *end != (i + 1 < count ? ',' : '\0')) {
            args_complain(a, "%s takes %u number%s parted by commas, not '%s'", flag, count,
                          count == 1 ? "" : "s", text);
            return 0;
        }
        at = end + 1;
    }
    return 1;
}

int args_size(args *a, const char *flag, unsigned *width, unsigned *height) {
    const char *text = args_text(a, flag, NULL);
    if (text == NULL) {
        return 0;
    }
    unsigned w = 0, h = 0;
    int length = 0;
    if (sscanf(text, "%5ux%5u%n", &w, &h, &length) != 2 || text[length] != '\0' || w < 1 ||
        h < 1 || w > 65535 || h > 65535) {
        args_complain(a, "%s takes WIDTHxHEIGHT, each 1 to 65535, not '%s'", flag, text);
        return 0;
    }
    *width = w;
    *height = h;
    return 1;
}
