/* pack_frames - the frames of pack --sequence, from their files
 *
 * Each file is read twice, before the lattice is chosen and to be coded; beside the first frame,
 * which is the scene, one is in memory at a time.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_FRAMES_H
#define PACK_FRAMES_H
#include "host_tools/app/args.h"
#include "host_tools/app/frame_range.h"
#include "host_tools/cli/pack_meshes.h"
#include "host_tools/pack/sequence.h"

#define PACK_FRAMES_FLAGS                                                                          \
    {"--sequence", NULL,                                                                           \
     "the meshes are frames of one sequence, in this order: the same triangles, vertices that "    \
     "move; on a lattice of 16 bits unless --geometry says other bits, or float of thesis nodes"}, \
        {"--frames", "A:B",                                                                        \
         "of --sequence with one MESH, a recipe with sequences or a name with '{}' for 000, 001 "  \
         "...: frames A to B - 1, 0 to 99999"},                                                    \
        {"--stills", NULL,                                                                         \
         "of --sequence with --nodes compact: all blocks once for each frame instead of how "      \
         "vertices move, some 8 bytes per triangle and frame instead of 2: any frame can be "      \
         "streamed"},                                                                              \
        {"--tree-for", "first|all",                                                                \
         "of --sequence: the frames that the tree is made for, its first or up to 8 that are "     \
         "evenly spread; all takes --quality high, three times as long as that alone and more, "   \
         "and gives up to half as many visits where triangles move apart (default first)"},        \
        {"--rate", "N", "of --sequence, --instances: frames per second, 1 to 1000 (default 25)"},  \
    {                                                                                              \
        "--key", "N",                                                                              \
            "of --sequence: every N-th frame does not depend on others, so that any frame takes N" \
            " at most, 1 to 100000 (default 16)"                                                   \
    }

typedef struct pack_frames {
    int wanted; /* --sequence; else all else is 0 */
    char **path;
    int is_numbered; /* one path for all frames, by number */
    frame_range range;
    lattice_wish wish; /* bits 0: floats */
    sequence_options options;
    sequence code;
    int for_all; /* --tree-for */
    poses poses; /* of those frames; none, unless for_all */
    char *first; /* the file of the first frame; owned */
} pack_frames;

/* Reads the flags, and which files there are. Refuses through args_complain. */
void pack_frames_read(pack_frames *p, args *a);

/* Reads all frames but the first, which `in` has read, compares them with it and chooses the
 * lattice; then moves the first onto that, and the poses, which are of that first one. */
int pack_frames_scan(pack_frames *p, pack_meshes *in, fail *f);

/* Reads them again, and puts them behind the image of the first one. */
int pack_frames_add(pack_frames *p, const pack_meshes *in, packed *image, fail *f);

void pack_frames_free(pack_frames *p);

#endif
