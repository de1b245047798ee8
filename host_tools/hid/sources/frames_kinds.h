/* frames_kinds - the kinds of sources: films, pictures, a scene
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_FRAMES_KINDS_H
#define HID_FRAMES_KINDS_H

#include "host_tools/app/args.h"
#include "host_tools/hid/sources/frames.h"

/* Each is handed an open stream at its first byte, a scene behind its "PL". */
int frames_y4m(frames *s, fail *f);
int frames_pnm(frames *s, fail *f);
int frames_png(frames *s, fail *f);
int frames_scene(frames *s, args *a, unsigned width, unsigned height, fail *f);

#define FRAMES_SCENE_FLAGS                                                                         \
    {"--shader", "eyelight|normal|triangle|smooth",                                                \
     "a scene's colours; smooth is for scenes with normals or colours (pack --smooth)"},           \
        {"--turn", "SECONDS",                                                                      \
         "time of an orbit around a scene, until a key of the display turns it; 0: no motion "     \
         "(default 12)"},                                                                          \
    {                                                                                              \
        "--bare", NULL, "a scene without symbols of what the display's keys do"                    \
    }

#endif
