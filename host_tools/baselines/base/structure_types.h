/* structure_types - what every structure is asked for, and what it counts
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_STRUCTURE_TYPES_H
#define BASELINES_STRUCTURE_TYPES_H

#include <stdint.h>

/* Since structure_open, or, of rays, since structure_forget. What is not counted is 0. */
typedef struct structure_statistics {
    uint64_t rays;
    uint64_t node_visits;    /* nodes, leaves too, or cells; of packets once per packet */
    uint64_t box_tests;      /* planes or boxes that a ray, or four rays, were held against */
    uint64_t triangle_tests; /* a ray, or four rays, against a triangle */
    uint64_t sieved;         /* triangles put aside by less than a test */
    uint64_t build_work;     /* triangles of ranges or cells that were split, once each time */
    uint64_t bytes;          /* now: nodes, and what leads from them to triangles */
    uint64_t triangle_bytes; /* now: the triangles themselves, and what belongs to each */
    uint32_t nodes;          /* now: inner ones */
    uint32_t leaves;         /* now: that are not empty */
    uint32_t unsplit;        /* now: left until a ray comes */
    uint32_t references;     /* now: of leaves to triangles */
    uint32_t strays;         /* now: likewise, of triangles that are not in them (kd_stray.h) */
} structure_statistics;

typedef struct structure_options {
    uint8_t packet_side; /* of those that have packets; 0: 8 */
    uint8_t
        one_by_one; /* 1: all rays are traced for themselves by those that can; 0: as they look */
} structure_options;

#endif
