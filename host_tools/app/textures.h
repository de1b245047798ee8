/* textures - whether surfaces have the textures of an image, by the flags
 *
 * SPDX-License-Identifier: MIT */
#ifndef TEXTURES_H
#define TEXTURES_H

#include "host_tools/app/args.h"
#include "host_tools/app/scene.h"
#include "host_tools/base/output.h"

#define TEXTURES_FLAGS                                                                             \
    {"--textures", "bilinear|nearest|none",                                                        \
     "smooth or whitted: textures of the image, mixed between four texels, or in squares, or not " \
     "at all (default bilinear)"},                                                                 \
    {                                                                                              \
        "--texture-room", "BYTES",                                                                 \
            "likewise, with --source read or dma, or streamed: memory for their tiles, 140 each, " \
            "140 to 1073741824 (default 8960)"                                                     \
    }

/* Reads the flags into the scene, for frames of that shader. Refuses through args_complain. */
void textures_read(scene *s, args *a, uint8_t shader);

/* Says that an image has textures, normals or colours which the frames do not have, if nobody asked
 * for that. */
void textures_say(const scene *s, const char *path);

/* JSON members, each ending in ",\n", if there are textures. */
void textures_print(output *o, const scene *s, fail *f);

#endif
