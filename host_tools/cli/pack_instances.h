/* pack_instances - the image of pack --instances, from its text and meshes
 *
 * SPDX-License-Identifier: MIT */
#ifndef PACK_INSTANCES_FILE_H
#define PACK_INSTANCES_FILE_H
#include "host_tools/app/args.h"
#include "host_tools/pack/pack.h"

#define PACK_INSTANCES_FLAG                                                                        \
    {                                                                                              \
        "--instances", NULL,                                                                       \
            "the one MESH is a text of bodies, instances of them and a matrix for each per "       \
            "frame, described below; thesis nodes of --build host"                                 \
    }

typedef struct pack_instances_order {
    int wanted; /* --instances; else all else is 0 */
    uint32_t frame_rate;
    int repair;
    double weld;              /* 0: none */
    int is_high;              /* --quality */
    uint32_t quality_seconds; /* per body; 0: no limit */
} pack_instances_order;

/* Reads the flags that are its own. Refuses, through args_complain, those that are not for it. */
void pack_instances_read(pack_instances_order *o, args *a);

/* `options`: how each body is packed. Says on standard error what their meshes have lost. */
int pack_instances(packed *image, const char *path, const pack_instances_order *o,
                   const pack_options *options, fail *f);

#endif
