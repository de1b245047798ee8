/* board - the firmware of boards as a program of an operating system, for hashes.sh
 *
 * Its arguments are the firmware's parameters; scene= names a file.
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "board/parameters.h"

static _Alignas(PLT_ALIGN) unsigned char image[1 << 18];
static _Alignas(PLT_ALIGN) unsigned char arena[1 << 18];
static uint8_t *rgb;
static size_t width, height;

const char *board_name(void) {
    return "cpu";
}

unsigned char *board_arena(size_t *bytes) {
    *bytes = sizeof arena;
    return arena;
}

int board_scene(const char *parameters, plt_source *source) {
    parameter found;
    char name[256];
    FILE *file = NULL;
    if (parameter_find(parameters, "scene", &found) &&
        parameter_copy(&found, name, sizeof name) == 0) {
        file = fopen(name, "rb");
    }
    if (file == NULL) {
        printf("error: scene= names no file\n");
        return -1;
    }
    source->mapped = image;
    source->bytes = (uint32_t)fread(image, 1, sizeof image, file);
    const int is_whole = fgetc(file) == EOF;
    fclose(file);
    if (!is_whole) {
        printf("error: %s has more than %zu bytes\n", name, sizeof image);
    }
    return is_whole ? 0 : -1;
}

int board_frame_begin(uint16_t w, uint16_t h) {
    width = w, height = h;
    free(rgb);
    rgb = malloc(3 * width * height);
    return rgb != NULL ? 0 : -1;
}

void board_tile(const plt_tile *tile) {
    for (size_t y = 0; y < tile->height; y++) {
        memcpy(rgb + 3 * ((tile->y + y) * width + tile->x), tile->rgb + 3 * y * tile->width,
               (size_t)3 * tile->width);
    }
}

const uint8_t *board_frame_end(const char *parameters) {
    (void)parameters;
    return rgb;
}

void board_print(const char *text) {
    fputs(text, stdout);
}

uint32_t board_ticks(void) {
    return 0;
}

uint32_t board_ticks_per_second(void) {
    return 1;
}

void board_stack(uint32_t *used_bytes, uint32_t *size_bytes) {
    *used_bytes = *size_bytes = 0;
}

int main(int count, char **items) {
    static char parameters[1024];
    for (int i = 1; i < count; i++) {
        const size_t used = strlen(parameters);
        snprintf(parameters + used, sizeof parameters - used, "%s ", items[i]);
    }
    const int status = firmware(parameters);
    free(rgb);
    return status;
}
