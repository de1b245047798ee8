/* command_line - see command_line.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/command_line.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FILES_SHOWN = 8 };

/* Letters that no shell looks at. */
static int is_plain(const char *word) {
    static const char plain[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
        "_-+.,:/=@%";
    return word[0] != '\0' && word[strspn(word, plain)] == '\0';
}

static void put_word(FILE *to, const char *before, const char *word) {
    if (is_plain(word)) {
        fprintf(to, " %s%s", before, word);
        return;
    }
    fprintf(to, " '%s", before);
    for (; *word != '\0'; word++) {
        if (*word == '\'') {
            fputs("'\\''", to);
        } else {
            fputc(*word, to);
        }
    }
    fputc('\'', to);
}

char *command_line(const args *a) {
    char *text = NULL;
    size_t bytes = 0;
    FILE *to = open_memstream(&text, &bytes);
    if (to == NULL) {
        return NULL;
    }
    fprintf(to, "%s %s", a->program, a->command->name);
    for (int i = 0; i < a->files && i < FILES_SHOWN; i++) {
        const char *name = a->file[i]; /* no flag, whatever it begins with */
        put_word(to, name[0] == '-' && name[1] != '\0' ? "./" : "", name);
    }
    if (a->files > FILES_SHOWN) {
        fprintf(to, " (and %d more)", a->files - FILES_SHOWN);
    }
    for (int i = 0; a->command->flags[i].name != NULL; i++) {
        if (a->value[i] != NULL) {
            fprintf(to, " %s", a->command->flags[i].name);
            if (a->command->flags[i].value != NULL) {
                put_word(to, "", a->value[i]);
            }
        }
    }
    if (fclose(to) != 0) {
        free(text);
        return NULL;
    }
    return text;
}
