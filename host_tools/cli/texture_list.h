/* texture_list - the textures of an image, for planelet info
 *
 * SPDX-License-Identifier: MIT */
#ifndef TEXTURE_LIST_H
#define TEXTURE_LIST_H
#include "engine/texture/directory.h"

typedef struct texture_list {
    unsigned char *section; /* owned; NULL: there is none */
    plt_directory directory;
    uint64_t bytes, texels; /* bytes: of both sections */
} texture_list;

/* Those of an image whose header is valid. PLT_OK, or why it is refused: R13, R20, of the section
 * of textures. */
int texture_list_read(texture_list *l, const plt_source *source, plt_fault *fault);
void texture_list_print(const texture_list *l);
void texture_list_print_json(const texture_list *l); /* members that end in ",\n" */
void texture_list_free(texture_list *l);

#endif
