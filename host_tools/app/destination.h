/* destination - where pictures go: -o, --show, --json, and what they say together
 *
 * The one check of all commands that give pictures, before any work and any wait.
 *
 * SPDX-License-Identifier: MIT */
#ifndef DESTINATION_H
#define DESTINATION_H

#include "host_tools/app/args.h"
#include "host_tools/picture/picture_file.h"

typedef struct destination {
    const char *out, *json; /* NULL: not given */
    picture_format format;  /* of `out`; of "-": PPM, or Y4M for several frames */
    int show;
    int is_numbered; /* a picture per frame, its number for the '{}' in `out` */
} destination;

/* For a command whose -o may be a film. */
#define DESTINATION_CHROMA_FLAG                                                                    \
    {                                                                                              \
        "--chroma", "420|444",                                                                     \
            "colour of a film: 420, which players play once ffmpeg -i film.y4m film.mp4 has "      \
            "compressed it (of even width and height), or 444, that of each pixel in full range "  \
            "(default 420)"                                                                        \
    }

/* Reads -o, --show, --chroma and --json, for so many frames. Refuses through args_complain: nowhere
 * to go, unless `is_enough`; a name without a format, several frames in a picture, two outputs that
 * would mix. With `is_stream` several frames may go into one PPM, one after another. */
void destination_read(destination *d, args *a, unsigned frames, int is_stream, int is_enough);

/* Notes, once the film is there, that players may not get one of this size. */
void destination_note(const destination *d, unsigned width, unsigned height);

/* Refuses outputs that are one word, unless it names a device, a terminal or a pipe. */
void destination_differ(args *a, const char *what, const char *one, const char *other);

#endif
