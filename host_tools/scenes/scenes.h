/* scenes - meshes that need no download, the same on every machine
 *
 * Bit for bit the same wherever float and double are IEEE 754 and computed
 * as written (FLT_EVAL_METHOD 0, no fused multiply-add): integer random
 * numbers, + - * / and square roots alone, sine and cosine from cos_sin.h.
 *
 * Every scene appends to `m`, y up, triangles counter-clockwise seen from
 * outside. On failure `m` is as it was before and `f` holds the remedy.
 *
 * SPDX-License-Identifier: MIT */
#ifndef SCENES_H
#define SCENES_H
#include "host_tools/mesh/mesh.h"

#define SCENE_TRIANGLES_MAX 10000000u

/* A flat slab of 12 triangles, 20 x 0.5 x 20, its top at y = 0 (the thesis's
 * "ground"). */
int scene_ground(mesh *m, fail *f);

/* Marbles of radius 1 rolling in an eight-sided tray 34 wide, which have 80
 * triangles each: as many as make about `triangles` (SCENE_MARBLES_LEAST ..
 * SCENE_MARBLES_MOST, never more), 1 to 109; frame `frame` of an animation at 25
 * frames per second, of any length. Vertices and indices keep their order from frame
 * to frame. A call simulates from frame 0 on, about 1 ms per frame, or
 * from the frame of the last call if that was earlier and had as many marbles. It keeps
 * that state: not for two threads at once. */
#define SCENE_MARBLES_LEAST 160u
#define SCENE_MARBLES_MOST 8800u
int scene_marbles(mesh *m, uint64_t triangles, unsigned frame, fail *f);

/* The same as bodies, a tray that is level and a ball about 0, and a matrix for each: of the tray,
 * then of the balls, three rows of four. Returns how many; `triangles` as of scene_marbles, in
 * range. */
#define SCENE_MARBLES_INSTANCES 110u
int scene_marbles_tray(mesh *m, fail *f);
int scene_marbles_ball(mesh *m, fail *f);
unsigned scene_marbles_matrices(uint64_t triangles, unsigned frame,
                                double matrix[SCENE_MARBLES_INSTANCES][12]);

/* A city of 168 houses, 260 x 260, and 576 people, who stand on the lift of a skyscraper in frame
 * 0, are on the ground 25 frames later and go to streets all over the city; from there one in three
 * goes up to a roof and one down below the ground, until frame 140; 25 frames per second.
 * SCENE_CITY_TRIANGLES, of which the last SCENE_CITY_MOVING move. Vertices and indices keep
 * their order. */
#define SCENE_CITY_TRIANGLES 44844u
#define SCENE_CITY_MOVING 13824u
int scene_city(mesh *m, unsigned frame, fail *f);

/* A height field of mountains and valleys over 20 x 20 of about `triangles`
 * (2 .. SCENE_TRIANGLES_MAX) triangles. With c = floor(sqrt(triangles / 2))
 * columns and r = floor(triangles / 2 / c) rows they are 2 c r: never more
 * than asked for, and fewer by less than 2 c. */
int scene_terrain(mesh *m, uint64_t triangles, fail *f);

/* A closed trefoil tube of about `triangles` (24 .. SCENE_TRIANGLES_MAX)
 * triangles. With a = max(3, floor(sqrt(triangles / 20))) sides and
 * b = floor(triangles / 2 / a) rings they are 2 a b: never more than asked for,
 * and fewer by less than 2 a. */
int scene_knot(mesh *m, uint64_t triangles, fail *f);

/* A closed room, 6 x 2.7 x 4.8 inside, with furniture, of about `triangles`
 * (SCENE_ROOM_LEAST .. SCENE_TRIANGLES_MAX) triangles: never more than asked for. Every
 * surface in it is closed; walls, floor and ceiling are a box and the cavity in it. Books,
 * chairs, fruit, leaves and balls are where `seed` says. SCENE_ROOM_VIEW has all of it in the
 * picture, from inside. */
#define SCENE_ROOM_LEAST 24000u
#define SCENE_ROOM_VIEW "--eye 2.7,1.6,2.1 --look -0.9,0.72,-0.7 --fov 60"
int scene_room(mesh *m, uint64_t triangles, uint32_t seed, fail *f);

#endif
