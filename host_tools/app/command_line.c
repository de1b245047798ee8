/* command_line - see command_line.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/command_line.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/app/quote.h"

enum { FILES_SHOWN = 8 };

/* -1 when memory is out. */
static int put_word(FILE *to, const char *text, int is_file) {
    const size_t room = quote_room_for(strlen(text));
    char *word = malloc(room);
    if (word == NULL) {
        return -1;
    }
    fprintf(to, " %s", is_file ? quote_word(word, room, text) : quote_value(word, room, text));
    free(word);
    return 0;
}

static int put_files(FILE *to, const args *a) {
    int status = 0;
    for (int i = 0; i < a->files && i < FILES_SHOWN; i++) {
        status |= put_word(to, a->file[i], strcmp(a->file[i], "-") != 0);
    }
    if (a->files > FILES_SHOWN) {
        fprintf(to, " (and %d more)", a->files - FILES_SHOWN);
    }
    return status;
}

static int put_flags(FILE *to, const args *a) {
    int status = 0;
    for (int i = 0; a->command->flags[i].name != NULL; i++) {
        if (a->value[i] != NULL) {
            fprintf(to, " %s", a->command->flags[i].name);
            if (a->command->flags[i].value != NULL) {
                status |= put_word(to, a->value[i], 0);
            }
        }
    }
    return status;
}

char *command_line(const args *a) {
    char *text = NULL;
    size_t bytes = 0;
    FILE *to = open_memstream(&text, &bytes);
    if (to == NULL) {
        return NULL;
    }
    fprintf(to, "%s %s", a->program, a->command->name);
    const int status = put_files(to, a) | put_flags(to, a);
    if (fclose(to) != 0 || status != 0) {
        free(text);
        return NULL;
    }
    return text;
}
