/* planelet - ray tracing in one fixed block of memory: the public interface
 *
 * CONVENTIONS
 *          y
 *          |      right-handed world, y up unless the camera says otherwise;
 *          |      row 0 is the top, pixel (0,0) top left, rays through
 *          +--- x pixel centres; counter-clockwise or not makes no difference:
 *         /       both sides of a triangle are hit. Units are the scene's.
 *        z        A point on a ray is org + t * dir; dir needs no unit length.
 *
 * Nothing here allocates, prints, recurses or keeps static data: an engine
 * lives wholly inside the arena it was given, and any number of engines may
 * live side by side. Calls on one engine come from one thread at a time (but for plt_task_run,
 * which reads a dispatcher that others call meanwhile).
 *
 * Every function that can fail returns a negative PLT_ERR_ value; DESIGN.md
 * says why things are as they are, SPEC.md what an image is made of.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLANELET_H
#define PLANELET_H

#include <stddef.h>
#include <stdint.h>

#include "engine/planelet_config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* 2.0: the order of traversal is enum plt_order and plt_options.order; plt_info has
 * primitive_id_bytes and primitive_id_bits; the knob for opened blocks is
 * PLT_BLOCK_CACHE_SLOTS; touched blocks
 * are counted only if plt_options.count_touched asks for it; incoherent rays can go by a wave
 * (plt_options.rays_in_flight, wide, rays; plt_stats.wave_rays); packets may be as large as there
 * is room for (plt_options.packet_side 0, plt_packet_side); scenes can stay in their source
 * (plt_options.residency, store_bytes, prefetch, schedule, batch); a frame goes on with any tile
 * (plt_render_seek), or by tasks that workers ask for (plt_task_next); triangles can move
 * (plt_options.movable, plt_move, plt_move_some, plt_sequence_show), without records of them
 * (plt_options.records, beside; plt_motion.over_vertices, is_beside), and their tree be built anew
 * (plt_rebuild_begin); bodies can be placed by matrices (plt_place); rays can go through a grid
 * (plt_options.structure); hits have normals and colours (plt_options.surface, plt_surface_at,
 * PLT_SHADE_SMOOTH); frames can have lights, shadows, mirrors and glass
 * (plt_options.whitted, plt_lighting_set); plt_trace and
 * plt_render_step report a source that fails. Images are those of 1.0. */
#define PLT_VERSION_MAJOR 2
#define PLT_VERSION_MINOR 0

/* Alignment of the arena and of a mapped image. */
#define PLT_ALIGN 16

enum plt_status {
    PLT_OK = 0,
    PLT_MORE = 1,         /* a step did its work and more is left */
    PLT_TILE = 2,         /* a step finished a tile: fetch it before the next */
    PLT_WAIT = 3,         /* plt_task_next: nothing to do until another worker comes back */
    PLT_ERR_ARENA = -1,   /* the arena is too small: plt_fault.need_bytes */
    PLT_ERR_IMAGE = -2,   /* the image breaks a rule of SPEC.md: .rule, .offset */
    PLT_ERR_SOURCE = -3,  /* the source failed to deliver: .offset */
    PLT_ERR_LIMIT = -4,   /* the scene needs more than this build allows */
    PLT_ERR_ARGUMENT = -5 /* a value outside its stated range */
};

/* Where a scene image lies. All bytes are untrusted until `plt_open` has
 * returned PLT_OK, and must stay as they are from then on.
 *
 * Memory-mapped: `mapped` points at all `bytes` of the image, aligned to
 * PLT_ALIGN; nothing is copied (but see PLT_BUILD_DEVICE). Otherwise
 * `mapped` is NULL and the image is fetched into the arena: `start` begins
 * moving `count` bytes from `offset` to `to` under `tag` (0 .. 31) and may
 * return before they are there; `wait` returns when every transfer of the
 * tags in `tags` (bit n: tag n) has ended. Both return 0, or a negative
 * value when the transfer failed, now or for good; the engine then gives
 * PLT_ERR_SOURCE. (Tags are the Cell's MFC tag groups: thesis, section 4.3.) */
typedef struct plt_source {
    const void *mapped;
    uint32_t bytes; /* size of the image; images are smaller than 4 GiB */
    void *context;  /* handed to the two functions, never looked at */
    int (*start)(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count);
    int (*wait)(void *context, uint32_t tags);
} plt_source;

enum plt_order {
    PLT_ORDER_DEPTH_FIRST = 0, /* resident scenes: one stack, near child first */
    PLT_ORDER_TWO_STAGE = 1    /* of resident thesis nodes: local and global stack (section 4.2) */
};

/* Where the tree and the triangles of a finished image are while rays are traced. */
enum plt_residency {
    PLT_RESIDENCY_WHOLE = 0,   /* mapped, or fetched whole into the arena, and validated whole */
    PLT_RESIDENCY_STREAMED = 1 /* in the source: blocks are fetched into a store when a packet
                                * needs them, and validated then (SPEC.md, 5.5). Compact blocks
                                * with lattice geometry, or thesis nodes in treelets of
                                * PLT_STREAMED_TREELET_MOST at most; the source may be mapped,
                                * too */
};

/* Who goes where, when a scene is streamed. Hits and frames are the same, bit for bit. */
enum plt_schedule {
    PLT_SCHEDULE_BRANCH = 0, /* packet after packet: each fetches what it comes to (thesis, 4.3) */
    PLT_SCHEDULE_BATCH = 1,  /* many packets are alive at once and meet at a block before it is
                              * fetched: fewer bytes, for some 125 per ray and a pool of
                              * those that wait; nearest block first */
    PLT_SCHEDULE_TASK = 2,   /* a dispatcher: it has many packets, too, and hands each on, block by
                              * block, to the workers that ask (plt_task_next); it is one itself */
    PLT_SCHEDULE_WORKER = 3  /* a worker of such a dispatcher, of no use alone */
};

/* Packets of a batch at most. */
#define PLT_BATCH_MOST 1024u

/* Least bytes of a store, its table included: the largest parts that a block can have fit it
 * together, wherever they lie: 739 (nodes), 8,184 (geometry) and 1,886 (primitive ids); of thesis
 * nodes 8,192, and 640 of records. */
#define PLT_STORE_LEAST 28672u
#define PLT_STREAMED_TREELET_MOST 256u

/* Most parts on their way at once (plt_options.prefetch). */
#define PLT_PREFETCH_MOST 8u

enum plt_splits {
    PLT_SPLIT_SAH = 0,   /* binned surface area heuristic (Wald 2007) */
    PLT_SPLIT_MEDIAN = 1 /* spatial median of the longest axis (the thesis) */
};

enum plt_build {
    PLT_BUILD_HOST = 0,   /* the image holds the finished tree */
    PLT_BUILD_DEVICE = 1, /* the engine builds the tree in its arena */
    PLT_BUILD_NONE = 2    /* no tree: one list of all triangles (a reference) */
};

enum plt_nodes {
    PLT_NODES_THESIS = 0, /* 32 bytes each, six float planes (thesis, figure 3.5) */
    PLT_NODES_COMPACT = 1 /* blocks of up to 64 nodes, about 7.1 bytes each */
};

enum plt_geometry_format {
    PLT_GEOMETRY_FLOAT = 0,   /* 40 bytes per triangle, bit exact */
    PLT_GEOMETRY_LATTICE = 1, /* strips of vertices on the lattice, the scene's
                               * quantisation grid */
    PLT_GEOMETRY_MOVING = 2,  /* the same with room for any frame of a sequence */
    PLT_GEOMETRY_STILLS = 3   /* the same, all blocks once for each frame: it can be streamed */
};

/* What rays find triangles by; hits and frames are the same, bit for bit. */
enum plt_structure {
    PLT_STRUCTURE_TREE = 0, /* the image's tree, or list */
    PLT_STRUCTURE_GRID = 1  /* cells of one size, made when the scene is opened and again whenever
                             * triangles have moved: fast to make, slower than a good tree for rays
                             * that differ much. Of images with thesis nodes, or without a tree,
                             * whose nodes are not looked at; resident, depth first, no wide
                             * form. Coherent or not, rays go in packets */
};

/* Whether a movable scene with a sequence has records of its triangles in the arena, which is 40
 * bytes each, or makes them of vertices whenever a ray comes to their leaf. Hits and frames are the
 * same, bit for bit. Without records there are 24 bytes per vertex instead of 12, and of an image
 * that is not mapped 4 per triangle; rays take longer, showing a frame is shorter; and nothing but
 * frames can be shown: plt_move is refused. Of finished trees (PLT_BUILD_HOST); without grids,
 * plt_options.moves_some and rebuild. Opening reads frame 0. Rays go in packets, whatever
 * plt_options.rays_in_flight says */
enum plt_records {
    PLT_RECORDS_AUTO = 0, /* as the arena has room for, and the rest allows; with `beside` none. A
                           * need is that of PLT_RECORDS_ALWAYS, or with `beside` of _NEVER */
    PLT_RECORDS_ALWAYS = 1,
    PLT_RECORDS_NEVER = 2
};

/* How plt_trace traces its rays, and frames with lights those off surfaces: hits are the same, bit
 * for bit. */
enum plt_rays {
    PLT_RAYS_AUTO = 0,      /* as the next rays look, 64 or a packet at a time; where packets have
                             * been of little use, most go by the wave unseen */
    PLT_RAYS_COHERENT = 1,  /* neighbours point alike: in packets */
    PLT_RAYS_INCOHERENT = 2 /* each for itself: in a wave */
};

/* How an engine shall run; all zero is a good choice. */
typedef struct plt_options {
    uint8_t packet_side;    /* 2, 4, 8 or 16, at most PLT_PACKET_SIDE_MAX; 0: the largest that the
                             * arena has room for (a need is then that of 2) */
    uint8_t order;          /* enum plt_order */
    uint8_t count_touched;  /* 1: count plt_stats.bytes_touched_once, for a bit per treelet
                             * block, of compact blocks a bit per 8 bytes */
    uint8_t rays_in_flight; /* of a wave for incoherent rays: 16 .. 64, or 0: there are
                             * packets alone. Scenes without a tree are traced in packets,
                             * and so are compact blocks without a wide form where
                             * PLT_WITH_WAVE_COMPACT is 0. DESIGN.md, section 6, has the
                             * bytes */
    uint8_t wide;           /* 1: the wave has a wide form of the tree, made when the scene is
                             * opened: faster, for some 75 bytes per triangle (arena need: the
                             * bound, some 120). Scenes without a tree, or of more than 8
                             * million triangles, have none */
    uint8_t rays;           /* enum plt_rays; without a wave all are coherent */
    uint8_t residency;    /* enum plt_residency; a streamed scene has neither wave nor wide form */
    uint8_t prefetch;     /* streamed scenes: parts that may be on their way before a ray needs
                           * them, at most PLT_PREFETCH_MOST, under tags 2 to 9 of the source; 4 is
                           * a good choice if bytes move while the processor works. 0: none, nor if
                           * the source is mapped, or PLT_WITH_PREFETCH is 0. When a call returns,
                           * nothing is on its way */
    uint32_t store_bytes; /* streamed: bytes for blocks, PLT_STORE_LEAST (28,672) at least; 0:
                           * all the room that the arena has (a need is then that of the
                           * least). Bytes fetched depend on it, hits do not */
    uint8_t schedule;     /* enum plt_schedule; of streamed scenes, but for PLT_SCHEDULE_BRANCH */
    uint8_t movable;      /* 1: triangles can be moved (plt_move): float records, and the nodes of
                           * their tree, are copied into the arena even if they are mapped; of
                           * compact blocks those of an image with a sequence, which move by its
                           * frames alone; of stills (PLT_GEOMETRY_STILLS) nothing, as they are
                           * streamed. Not of other streamed scenes, not with a wide form, nor
                           * PLT_SCHEDULE_TASK and _WORKER.
                           * Of an image with a sequence, its frames can be shown as well
                           * (plt_sequence_show), for some 12 bytes per vertex and 2 to 10 per
                           * triangle. Without PLT_WITH_MOTION it is not looked at */
    uint16_t batch;       /* packets of a batch, 1 .. PLT_BATCH_MOST, or those that a dispatcher has
                           * begun at once: at least one per worker. 0: as many as there is room
                           * for beside the store, 256 at most (a dispatcher: 16), smaller ones if
                           * fewer than four fit (a need is then that of 1). Other schedules: 0 */
    uint8_t moves_some; /* movable scenes: 1: some triangles can be moved, too (plt_move_some), for
                         * 4 bytes and a bit per triangle, and 80 per level of the tree. No two
                         * records may have one id. Without PLT_WITH_MOVE_SOME: 0 */
    uint8_t rebuild;   /* movable scenes: 1: there is room for a second tree (plt_rebuild_begin): 40
                        * bytes per triangle, 36 per node slot and the builder's bins; and for
                        * growth 32 per node slot more. A need is that of the largest tree; an
                        * arena of less has fewer slots, down to those of the image. Stacks
                        * are as deep as PLT_DEPTH_MAX. Without PLT_WITH_REBUILD: 0 */
    uint8_t structure; /* enum plt_structure. A grid takes the room that there is: at most
                        * PLT_GRID_TRIANGLE_BYTES (64) and 8 per triangle, at least 8, of which
                        * few make it slow. Without PLT_WITH_GRID it is not looked at */
    uint32_t rebuild_most; /* with rebuild: 0: the whole tree is rebuilt at a time. Else subtrees of
                            * at most so many triangles are, PLT_SUBTREE_LEAST and up, in their own
                            * slots: 40 bytes and 36 per node for so many instead of for all, the
                            * builder's bins, and 72 per subtree (of a quarter of that at least), in
                            * place of a second tree. Not in PLT_ORDER_TWO_STAGE, whose stacks
                            * depend on treelets. Without PLT_WITH_SUBTREES: 0 */
    uint8_t records;       /* enum plt_records; of movable scenes with a sequence. Without
                            * PLT_WITH_VERTICES it is not looked at */
    uint8_t beside;  /* 1: the tree of a frame that comes is refitted in plt_sequence_step, beside
                      * the one that is shown, and plt_sequence_show is an exchange of both: of a
                      * scene without records, for 32 bytes per node slot if the arena has them
                      * (plt_motion.is_beside; a need has them). Not with PLT_RECORDS_ALWAYS.
                      * Without PLT_WITH_VERTICES it is not looked at */
    uint8_t surface; /* 1: hits have normals, colours and, with PLT_WITH_TEXCOORDS, texture
                      * coordinates (PLT_SHADE_SMOOTH, plt_surface_at): those of the image,
                      * for its bytes of them where it is not mapped; triangles that
                      * have none are flat, and white. Where there is plt_trace (PLT_WITH_GROUPS),
                      * also 4 bytes per triangle, of compact blocks 6, to find it by its number.
                      * Streamed: those that an image has in pages (SPEC.md, 4.23), by schedule
                      * branch, for 44 bytes per ray of a packet. Of scenes that are not movable and
                      * not of instances; compact blocks are not built here, and have no frames;
                      * grids have no pages. Without PLT_WITH_SURFACE: 0 */
    uint8_t whitted; /* room for frames of PLT_SHADE_WHITTED: 1 and the most bounces that they may
                      * have, up to 1 + PLT_BOUNCES_MOST, for 105 bytes per ray of a packet, 40 more
                      * per bounce (with textures 109 and 44), and the image's materials if it is
                      * not mapped; 0: none. With
                      * PLT_SCHEDULE_BRANCH. Without PLT_WITH_WHITTED it is not looked at */
#if PLT_WITH_TEXTURE
    uint8_t textures;       /* enum plt_texture_filter; of frames of PLT_SHADE_SMOOTH and WHITTED,
                             * which want `surface`. Room as for `whitted`: the image's materials,
                             * if it is not mapped. Of streamed scenes whose texture coordinates
                             * are in pages (SPEC.md, 4.23); others are shown without, and of an
                             * image without pages there is no room for any */
    uint32_t texture_bytes; /* with textures of an image that is not mapped: room for their tiles,
                             * 140 bytes each (PLT_TEXTURE_LEAST), as many as fit; 0: for
                             * PLT_TEXTURE_TILES. Less is fetched more often; pictures are alike */
#endif
} plt_options;

#if PLT_WITH_TEXTURE
/* Whether surfaces have their textures, and how texels become colours. */
enum plt_texture_filter {
    PLT_TEXTURES_NONE = 0,    /* none: they are as if their material had none */
    PLT_TEXTURES_NEAREST = 1, /* the texel that a point lies in */
    PLT_TEXTURES_BILINEAR = 2 /* the four around it, weighted */
};

#define PLT_TEXTURE_LEAST 140u /* a tile */
#define PLT_TEXTURE_TILES 64u  /* unless it is said how many */
#endif

/* Rays one after another that a mirror or glass may send out, at most. */
#define PLT_BOUNCES_MOST 8u

/* Fewer triangles are not worth the bytes that are kept of them. */
#define PLT_SUBTREE_LEAST 16u

/* Frames of a sequence per second at most. */
#define PLT_FRAME_RATE_MOST 1000u

/* What is known of an image; counts as in SPEC.md, section 3. */
typedef struct plt_info {
    uint32_t triangles;          /* records, in packing order ids 0 .. n-1 */
    uint32_t nodes;              /* inner nodes in use */
    uint32_t node_slots;         /* inner nodes allocated, holes included */
    uint32_t leaf_lists;         /* leaves of one list of triangles */
    uint32_t intermediate_lists; /* leaves of two adjacent lists */
    uint32_t treelets;
    uint32_t treelet_nodes;        /* N, most nodes per treelet */
    uint32_t leaf_triangles;       /* K, most triangles per list */
    uint32_t local_stack_entries;  /* exact need of the two-stage order ... */
    uint32_t global_stack_entries; /* ... and of its global stack */
    uint32_t depth_stack_entries;  /* exact need of the depth-first order */
    uint32_t image_bytes;
    uint32_t node_bytes;         /* all nodes; of compact blocks the nodes parts */
    uint32_t triangle_bytes;     /* all triangles; of compact blocks the geometry parts */
    uint32_t primitive_id_bytes; /* primitive ids, kept apart; 0: there are none */
    uint32_t source_triangles;   /* in packing order, with those that lost their area */
    float lo[3], hi[3];          /* box of all triangles; lo > hi when there are none */
    uint8_t splits, build;
    uint8_t nodes_format, geometry_format; /* enum plt_nodes, plt_geometry_format */
    uint8_t lattice_bits;                  /* 12 .. 21; 0 without a lattice */
    uint8_t primitive_id_bits;             /* bits per primitive id, 0 without */
    uint8_t has_checks;   /* 1: all that streaming fetches is checked (SPEC.md, 4.14) */
    uint32_t frames;      /* of a sequence (plt_sequence_show), the first is 0; 0: there is none */
    uint32_t vertices;    /* of each of them */
    uint32_t frame_rate;  /* frames per second, 1 .. PLT_FRAME_RATE_MOST */
    uint32_t key_every;   /* frames that are multiples of it do not depend on others */
    uint32_t frame_bytes; /* all frames, with 4 bytes of offset each and 4 more; of instances
                           * 48 each and 4 per frame */
    uint32_t block_vertices;   /* PLT_GEOMETRY_MOVING: of all blocks, shared ones counted in each */
    uint32_t bodies;           /* of an image with instances: trees that are placed; else 0 */
    uint32_t instances;        /* of those bodies, each with a matrix per frame (plt_place) */
    uint32_t placed_triangles; /* of all instances; `triangles` are those of the bodies */
#if PLT_WITH_SURFACE
    uint32_t normal_bytes; /* of the section of normals; 0: there are none */
    uint32_t colour_bytes; /* ... and of colours */
#endif
#if PLT_WITH_TEXCOORDS
    uint32_t texcoord_bytes; /* ... and of texture coordinates */
#endif
#if PLT_WITH_PAGES
    uint32_t page_bytes; /* ... and of all that corners have, page by page */
#endif
#if PLT_WITH_MATERIALS
    uint32_t material_bytes; /* ... and of materials; 0: there are none */
#endif
#if PLT_WITH_TEXTURE
    uint32_t texture_bytes; /* ... and of textures, and which materials have them */
    uint32_t tile_bytes;    /* ... and of their tiles */
#endif
} plt_info;

/* Why a call failed; zero where it does not apply. */
typedef struct plt_fault {
    size_t need_bytes;   /* PLT_ERR_ARENA: an arena that is enough; the smallest, unless
                          * the engine has to build the tree: then for the worst tree */
    uint32_t offset;     /* byte of the image where the trouble is */
    char kind;           /* 'R' refusal, 'I' invariant: PLT_ERR_IMAGE */
    uint8_t rule;        /* number of the rule in SPEC.md */
    const char *message; /* a sentence in static storage, never NULL */
} plt_fault;

typedef struct plt_engine plt_engine;

/* Reads the header of an image and checks it; fills `info`. Needs no arena.
 * Errors: PLT_ERR_IMAGE, PLT_ERR_SOURCE, PLT_ERR_ARGUMENT. Cost: one read of
 * 256 bytes, which lie on the stack meanwhile. */
int plt_image_info(const plt_source *source, plt_info *info, plt_fault *fault);

/* Bytes an arena must hold for such an image, source and options; for
 * PLT_BUILD_DEVICE the bound for the worst tree, which a real one is mostly
 * well below. Compact blocks that are built of an image that is not mapped read
 * its corners where they lie, through a window of 5 KB, 9 above 16 bits of
 * lattice. 0: an option is out of range, the order is not for these nodes, or this
 * build of the engine has no part that the image needs (planelet_config.h).
 * Arena parts: DESIGN.md, section 3. */
size_t plt_arena_need(const plt_info *info, int mapped, const plt_options *options);

/* When a part of an arena is in use. */
enum plt_lifetime {
    PLT_LIFETIME_STAYS,     /* as long as the engine */
    PLT_LIFETIME_VALIDATES, /* scratch, while a tree is validated */
    PLT_LIFETIME_BUILDS,    /* scratch, while a tree is built */
    PLT_LIFETIME_RUNS,      /* once the scene is open; lies where the scratch was */
    PLT_LIFETIMES           /* how many there are */
};

typedef struct plt_arena_part {
    const char *name; /* in static storage */
    uint64_t bytes;   /* 0: this image and these options do not need it */
    uint8_t lifetime; /* enum plt_lifetime */
} plt_arena_part;

/* Part `index` (from 0 on) of the sum above. PLT_ERR_ARGUMENT: there are fewer parts, or
 * plt_arena_need gives 0. The need is the sum of what stays and the greatest of the
 * sums of the other three lifetimes. */
int plt_arena_part_get(const plt_info *info, int mapped, const plt_options *options, unsigned index,
                       plt_arena_part *part);

/* Checks the whole image, builds the tree where the image asks for it, and
 * lays the engine out in `arena` (aligned to PLT_ALIGN, owned by the caller,
 * not to be touched until the engine is no longer used; there is nothing to
 * close). `source` is copied; what it points to must live on.
 * Errors: all of them; `fault` says why, *engine is then NULL, the arena's
 * contents are lost. Cost: one read of the image, one visit of every node. */
int plt_open(plt_engine **engine, void *arena, size_t arena_bytes, const plt_source *source,
             const plt_options *options, plt_fault *fault);

/* The same in pieces, for a main loop that must stay alive. Returns PLT_OK, as
 * plt_open, or PLT_MORE when compact blocks are to be built: then the engine
 * takes nothing but plt_open_step, each doing about `splits` splits of the
 * tree, until that returns PLT_OK. After an error *engine of the begin is of no
 * use. (Thesis nodes are built whole, in the begin. A split of the first block
 * looks at all triangles, later ones at ever fewer.) */
int plt_open_begin(plt_engine **engine, void *arena, size_t arena_bytes, const plt_source *source,
                   const plt_options *options, plt_fault *fault);
int plt_open_step(plt_engine *engine, uint32_t splits, plt_fault *fault);

const plt_info *plt_engine_info(const plt_engine *engine);

/* ---- rays ------------------------------------------------------------ */

/* Hits lie in tmin <= t <= tmax; a tmin below 0 counts as 0. Each component of
 * org must lie within +-2^40 (PLT_COORD_MAX, 1.0995e12), the largest component
 * of dir in 2^-60 .. 2^60. A ray with a NaN, an origin or a direction out of
 * range, or tmin > tmax hits nothing. 32 bytes. */
typedef struct plt_ray {
    float org[3], tmin, dir[3], tmax;
} plt_ray;

#define PLT_MISS 0xFFFFFFFFu

/* The hit point is (1-u-v)*p0 + u*p1 + v*p2; `triangle` is the primitive id, the
 * number in packing order, or PLT_MISS (then t = u = v = 0). Of equal t the lowest id
 * wins. For any-hit: `triangle` 1 or 0, the rest 0. 16 bytes.
 *
 * How exact a hit is, for triangles of any size and at any distance within those ranges:
 *
 *   met or not  Decided exactly for the line of a ray: no ray slips through an edge or a
 *               corner, and none hits what it passes by. Of no area, or with the ray in
 *               its plane, a triangle is not met; tilted by the least float, it is.
 *   t * |dir|   Off by at most 2^-19 D / (s c) + 2^-149 |dir|, D being the distance from
 *               org to the farthest corner, s the sine of the smallest angle, c the cosine between
 *               ray and normal, and by at most D / 8 + 2^-149 |dir|, however thin the
 *               triangle and however grazing the ray; and the hit point lies in the triangle's
 *               own box, grown by 2^-19 R + 2^-21 |org|. R is the distance along an axis
 *               from org to the farthest side of the scene's box, at least 2^-50. A hit whose
 *               exact t is closer than t's error to tmin (0 where that is less) or tmax
 *               may be lost, or be found just outside; no other. Let f be the sine of the first
 *               angle, at the corner of least x, then y, then z. With f c below 2^-17, and
 *               with f below 2^-14 for a ray that starts in the triangle's box, t is within
 *               2^-21 of itself, or 2^-149. t depends on neither tmin nor tmax: traced again
 *               with tmin = t, a ray has the same hit.
 *   u, v        Each in 0 .. 1, u + v at most 1 + 1/14. Off by at most 2^-17 R / (h c),
 *               h being the smallest height, and by 2^-22 if the triangle's box is no
 *               longer than 2^-27 R.
 *
 * tests/engine/test_trace_bounds.c checks each of these against integers, how close the
 * worst hits come to it, and what is just beyond. */
typedef struct plt_hit {
    float t, u, v;
    uint32_t triangle;
} plt_hit;

/* Traces `count` rays in packets of side^2 consecutive rays; every four are
 * a group that shares registers, so neighbours should point alike. Rays that do not are
 * faster in a wave, if there is one (plt_options.rays_in_flight): unless plt_options.rays says
 * which, each 64 rays, or packet if it is larger, are looked at. `any`:
 * only whether anything is hit. A hit depends on ray, triangle and the scene's
 * box alone: packet size, tree and order never change it. Ends a frame that was
 * being rendered. PLT_OK, or PLT_ERR_SOURCE: the source failed, or PLT_ERR_IMAGE: what came is not
 * valid (both of streamed scenes; plt_fault_get says where); hits before those of
 * the current packet, or batch, are right, its own and later ones are as they were; by tasks, hits
 * of a run that failed are of no use.
 * PLT_ERR_LIMIT: this build has no rays in groups (PLT_WITH_GROUPS). Cost: see DESIGN.md,
 * section 6. */
int plt_trace(plt_engine *engine, const plt_ray *rays, plt_hit *hits, uint32_t count, int any);

/* ---- surfaces -------------------------------------------------------- */

/* What a hit is shaded by. */
typedef struct plt_surface_point {
    float normal[3]; /* of length 1 up to rounding: those of the corners, weighted by u and v; the
                      * triangle's own where it has none, or they cancel out */
    float flat[3];   /* the triangle's own, likewise, by the winding of its corners; 0: no area */
    float colour[3]; /* red, green, blue, 0 .. 1 each, as packed (mostly sRGB), weighted alike; 1
                      * where there is none */
    uint8_t has_normal, has_colour; /* of corners */
#if PLT_WITH_TEXCOORDS
    uint8_t has_texcoord;
    float texcoord[2];    /* u to the right, v up, of a texture between 0 and 1, weighted alike; not
                           * wrapped: whoever samples does. Each within +-2^20. 0 without */
    float texcoord_scale; /* how much texture there is to the surface: the square root of the area
                           * that the triangle covers of it over the triangle's own, so in textures
                           * per length of 1; the same all over a triangle. 0: there are
                           * no coordinates, or one of the areas is 0 */
#endif
} plt_surface_point;

/* The surface where a ray of plt_trace has hit: of `hit` it looks at triangle, u and v, each of
 * which may be any number. The same bits on every machine. PLT_OK, or PLT_ERR_ARGUMENT:
 * plt_options.surface was 0, the scene is streamed, or there is no such triangle (PLT_MISS);
 * *point is then left as it was. Cost: three corners looked up, some 40 operations each, one square
 * root for each normal.
 *
 * Not there without PLT_WITH_SURFACE and PLT_WITH_GROUPS. */
int plt_surface_at(const plt_engine *engine, const plt_hit *hit, plt_surface_point *point);

/* ---- motion ---------------------------------------------------------- */

/* Moves all triangles, and refits the tree: nodes and lists stay what they are, their boxes become
 * those of the triangles (thesis, section 3.6). So hits and frames are those of a scene that is
 * packed anew, bit for bit; but the farther triangles have moved apart, the longer they take. A
 * grid is made anew, and no worse than before.
 *
 * `corners`: of each of the info's triangles, in packing order, x, y and z of three corners, each
 * within +-2^40; they may have lost their area. They are not needed any more after the call.
 * plt_engine_info has the new box afterwards, all else stays. Ends a frame that was being
 * rendered. PLT_ERR_ARGUMENT: plt_options.movable was 0, or the scene is of compact blocks or has
 * no records (plt_options.records), or a corner is out of range or no number: then fault->offset is
 * its triangle, and nothing has changed. Cost: each triangle and each node once, some 10 and 7 ns
 * on a PC; of a grid each triangle three times, some 60 ns.
 *
 * Not there without PLT_WITH_MOTION. */
int plt_move(plt_engine *engine, const float (*corners)[9], plt_fault *fault);

/* An image may hold a sequence: positions of all vertices, frame by frame, mostly as differences
 * from the frame before (SPEC.md, 4.15). An engine that is open with plt_options.movable shows any
 * of its info's frames, 0 .. frames - 1, in any order; frame 0 is what it shows first. The tree is
 * refitted as by plt_move, and hits and pictures are likewise those of the frame packed alone.
 *
 * plt_sequence_show: `frame` from now on, until plt_move or the next one. Ends a picture that was
 * being rendered. Cost: what is left of the steps below, then each triangle and node once.
 *
 * plt_sequence_begin and plt_sequence_step read a frame beforehand, while the last one is still
 * rendered: about `blocks` blocks, of 64 vertices each, per call. Frames follow each other for one
 * frame's work; any other takes those from the last frame that is a multiple of key_every, so that
 * many at most. Two transfers at a time, under tags 0 and 1 of a source that is not mapped; when a
 * call returns, none is on its way. PLT_MORE, or PLT_OK: the frame is there to be shown. With
 * plt_options.beside steps go on with its tree when its vertices are there, about four leaves per
 * block; what is shown stays whole meanwhile, and plt_sequence_show takes no time that depends on
 * the scene. Else it takes each triangle and node once, some 600 instructions per triangle of a
 * Cortex-M4F, without records 270.
 *
 * Of a streamed scene of stills there is nothing to be read beforehand: the frame's root is fetched
 * when it is shown, and all else when rays need it.
 *
 * Errors of all three: PLT_ERR_ARGUMENT: the image has no such frame, or is not open for it (or,
 * of a step, no frame was begun). PLT_ERR_SOURCE, PLT_ERR_IMAGE: a frame did not come, or is not
 * valid, after PLT_FETCH_TRIES attempts; `fault` says where, plt_sequence_failed which frame: it,
 * or one that it depends on. Then the last frame shown stays, and any other can be asked for.
 *
 * Not there without PLT_WITH_SEQUENCE or, for instances, PLT_WITH_INSTANCES. */
int plt_sequence_show(plt_engine *engine, uint32_t frame, plt_fault *fault);
int plt_sequence_begin(plt_engine *engine, uint32_t frame, plt_fault *fault);
int plt_sequence_step(plt_engine *engine, uint32_t blocks, plt_fault *fault);

/* The frame that could not be had when one of them failed last. */
uint32_t plt_sequence_failed(const plt_engine *engine);

/* An image may hold bodies instead, each a mesh with a tree of its own, and instances of them: each
 * has a matrix that brings the body's points into the world, three rows of four floats, the fourth
 * of which is added. Rays that meet an instance are brought into its body's space and traverse the
 * body's tree, which never changes: a frame costs its matrices alone. Such an engine is open
 * without plt_options.movable, and shows its image's frames by the three calls above (a block is
 * 64 matrices; a step reads, and the show places).
 *
 * A hit's `triangle` counts the triangles of instance 0, then those of instance 1, and so on, below
 * the info's placed_triangles; u and v belong to the body's corners, t is the ray's own. Of equal t
 * the lowest wins, whatever was placed where. An any-hit, frames, packets and orders are as of
 * other scenes; a wave or a grid there is not, and nothing is streamed. A hit is exact as plt_hit
 * says for the ray as the body sees it, which is rounded once more (DESIGN.md, section 5.7). A ray
 * whose origin or direction is out of range there meets nothing of it.
 *
 * plt_place: where all instances are from now on, until the next call or frame: a matrix for each
 * of the info's instances, in their order, which are not needed any more after the call. Any will
 * do that can be inverted well: rigid ones, mirrors, scales from 2^-20 to 2^20; the largest sum of
 * the sizes of a row's three columns, times that of the inverse, is at most 1024. Ends a frame that
 * was being rendered. PLT_ERR_ARGUMENT: there are no instances, or no matrices; or a matrix is not
 * one, or places its body beyond 2^40: then fault->offset is its instance; nothing has changed.
 * Cost: the inverse, twice, and the instance some log2(instances) times, for the tree over them.
 *
 * Not there without PLT_WITH_INSTANCES. */
int plt_place(plt_engine *engine, const float (*matrices)[12], plt_fault *fault);

/* What a hit's number means. */
typedef struct plt_instance {
    uint32_t instance, body; /* numbers in the image, from 0 */
    uint32_t triangle;       /* of the body's mesh, in packing order */
} plt_instance;

/* PLT_ERR_ARGUMENT: there are no instances, or not so many triangles. Cost: log2(instances).
 *
 * Not there without PLT_WITH_INSTANCES. */
int plt_instance_find(const plt_engine *engine, uint32_t triangle, plt_instance *to);

/* Moves triangles ids[0] .. ids[count - 1], in any order, to corners[0] .. corners[count - 1], of
 * an id that comes twice the last; all others stay. The result is that of plt_move, to the byte.
 * PLT_ERR_ARGUMENT: as plt_move, or plt_options.moves_some was 0, or an id is not below the info's
 * triangles; fault->offset is the index in both arrays, and nothing has changed. Cost: these
 * triangles, and the nodes above them; more than a quarter of all cost what all do.
 *
 * Not there without PLT_WITH_MOVE_SOME. */
int plt_move_some(plt_engine *engine, const uint32_t *ids, const float (*corners)[9],
                  uint32_t count, plt_fault *fault);

/* A tree that is refitted gets worse, and is built anew, in the arena and beside the old one
 * (plt_options.rebuild): from the triangles as they are when it begins, while they move on, and the
 * old tree is refitted and traced until the new one is whole. A frame of a main loop:
 *
 *     plt_move(engine, corners, &fault);
 *     if (plt_rebuild_due(engine, PLT_REBUILD_COST, 0)) {
 *         plt_rebuild_begin(engine, &fault);
 *     }
 *     plt_rebuild_step(engine, 20000, &fault); // a part of it, if one has begun
 *     // render the frame
 *
 * plt_rebuild_begin: PLT_OK; one that has begun goes on. PLT_ERR_ARGUMENT: plt_options.rebuild was
 * 0, or the scene has no tree.
 *
 * plt_rebuild_step: looks at about `triangles` of them, as often as ranges of them are split: some
 * log2(info's triangles) times all of them in all. What is not divided is 64 of them, the nodes of
 * a treelet, and of a subtree its slots and the swap. PLT_MORE, or PLT_OK: the tree is the new one,
 * or none had begun. The last step waits until the frame that is being rendered is
 * complete; a plt_move when the new tree is nearly whole puts it in its place, too. plt_engine_info
 * has the new counts then, and hits are what they were, bit for bit. PLT_ERR_ARENA: the new tree
 * has more nodes than there is room for (fault->need_bytes: an arena for any), PLT_ERR_LIMIT: it
 * needs more than this build allows; it is given up, and the old tree goes on.
 *
 * With plt_options.rebuild_most it is a subtree that is rebuilt, copied into its own slots in the
 * end: each time the one whose growth has cost the most work per triangle, or would cost. All of
 * the above is of that one; a tree that its slots do not hold gives PLT_ERR_ARENA without a need.
 * plt_engine_info's stack needs are upper bounds then. Nodes above the subtrees stay what they are,
 * and those of few triangles between them.
 *
 * plt_rebuild_due: 1: time to begin, by `when`; 0: not, or one has begun, or there is no room.
 * `percent`: of PLT_REBUILD_THRESHOLD, 1 and up. By threshold or cost, one that was given up is due
 * again when as much has been lost anew.
 *
 * Not there without PLT_WITH_REBUILD. */
enum plt_rebuild_when {
    PLT_REBUILD_NEVER = 0,     /* refits alone */
    PLT_REBUILD_ALWAYS = 1,    /* whenever none has begun */
    PLT_REBUILD_THRESHOLD = 2, /* degradation has reached `percent` (RT-DEFORM: 30 or 40) */
    PLT_REBUILD_COST = 3       /* work that a new tree would have saved has reached its cost */
};

int plt_rebuild_begin(plt_engine *engine, plt_fault *fault);
int plt_rebuild_step(plt_engine *engine, uint32_t triangles, plt_fault *fault);
int plt_rebuild_due(const plt_engine *engine, unsigned when, unsigned percent);

/* How a scene in motion is. Work is in group tests, of which a triangle test is two
 * (plt_stats); it does not depend on any clock. */
typedef struct plt_motion {
    uint32_t moves;      /* calls of plt_move and plt_move_some */
    uint32_t rebuilds;   /* that have become the scene's tree, or a part of it */
    float degradation;   /* 0.1: the ratio of a node's area to its children's together, summed over
                          * all nodes, is 10 % above what it was when the tree was built
                          * (RT-DEFORM); below 0: it is less. Without plt_options.rebuild, whose
                          * choice it is for, it is not counted, and 0 */
    float growth;        /* likewise of the sum of all nodes' areas, which says more of what rays
                          * cost: DESIGN.md, section 5.3 */
    uint8_t is_building; /* a rebuild has begun */
    uint8_t over_vertices; /* there are no records (plt_options.records) */
    uint8_t is_beside; /* frames are refitted beside the one that is shown (plt_options.beside) */
    uint64_t excess_work; /* since the last rebuild, of what a new tree would have saved: of work w,
                           * w d / (1 + d), d being PLT_GROWTH_WORK percent of the growth, if
                           * above 0 */
    uint64_t build_work;  /* what a rebuild costs: PLT_REBUILD_WORK per triangle */
    uint32_t subtrees;    /* that are rebuilt one by one (plt_options.rebuild_most); excess_work and
                           * build_work are of the next of them. 0: the whole tree is rebuilt */
    uint64_t rebuilt;     /* triangles of all rebuilds */
} plt_motion;

/* Not there without PLT_WITH_MOTION. */
void plt_motion_get(const plt_engine *engine, plt_motion *motion);

/* ---- frames ---------------------------------------------------------- */

typedef struct plt_camera {
    float eye[3], look[3], up[3];
    float tan_half_fov; /* tangent of half the vertical angle, > 0 */
} plt_camera;

enum plt_shader {
    PLT_SHADE_EYELIGHT = 0, /* grey by the angle to the ray (thesis, 5.1) */
    PLT_SHADE_NORMAL = 1,   /* colour by the direction of the surface */
    PLT_SHADE_TRIANGLE = 2, /* a flat colour per triangle */
    PLT_SHADE_SMOOTH = 3,   /* as eye light, by the normals and colours of plt_surface_at, and
                             * plt_options.textures; of scenes opened with plt_options.surface */
    PLT_SHADE_DEPTH = 4,    /* grey by the distance from the eye: white at the nearest point of the
                             * scene's box (the eye, if that is inside), black at its farthest
                             * corner, and black where nothing is hit */
    PLT_SHADE_HEAT = 5,     /* colour by the node visits of a pixel's packet (PLT_HEAT_LEVELS) */
    PLT_SHADE_WHITTED = 16  /* lights, shadows, mirrors and glass (plt_lighting_set), in sRGB; of
                             * engines that have room for it (plt_options.whitted) */
};

/* Node visits of a packet, over the pixels that it covers, as PLT_SHADE_HEAT has them: 0 (below
 * 1/1,024) is black, 1/64 blue, 1/4 cyan, 4 green, 64 yellow, 1,024 red, 16,384 and more white.
 * Between two of them colours go by the logarithm. */
#define PLT_HEAT_LEVELS 7

/* Rays per pixel, on a fixed rotated pattern: no two of a pixel share a row or a column. A pixel
 * is the mean of their colours in linear light; rgb is sRGB. With PLT_SHADE_SMOOTH, DEPTH and
 * WHITTED each has the colour of where it hits, which is a byte each of red, green and blue, as a
 * pixel's own would be; with the others that of the triangle that it hits, seen through the pixel's
 * middle. They take no memory beside the packet's. */
enum plt_samples {
    PLT_SAMPLES_ONE = 1, /* through the middle; 0 is the same */
    PLT_SAMPLES_FOUR = 4,
    PLT_SAMPLES_SIXTEEN = 16,
    PLT_SAMPLES_ADAPTIVE = 255 /* 4, and where these differ by more than PLT_SAMPLES_ALIKE 16 */
};

/* Of red, green and blue, 0 to 255: colours of a pixel's samples that differ no more are alike. */
#define PLT_SAMPLES_ALIKE 8

typedef struct plt_frame {
    plt_camera camera;
    uint16_t width, height; /* pixels, 1 .. 65535 */
    uint8_t shader;         /* enum plt_shader */
    uint8_t samples;        /* enum plt_samples */
#if PLT_WITH_BACKGROUND
    uint8_t has_background; /* 1: where nothing is hit, a pixel is `background`; 0: the sky. With
                             * PLT_SHADE_WHITTED where the eye's own rays hit nothing: those of
                             * mirrors and glass see sky and ground of plt_lighting */
    uint8_t background[3];  /* red, green, blue, as in plt_tile */
#endif
} plt_frame;

/* A finished piece of the frame: `rgb` holds height rows of width pixels of
 * 3 bytes, in the arena, until the next step. */
typedef struct plt_tile {
    const uint8_t *rgb;
    uint16_t x, y, width, height;
} plt_tile;

/* Starts a frame (and drops an unfinished one). Errors: PLT_ERR_ARGUMENT
 * for a camera without direction, a zero size, an unknown shader or number of samples; for 16
 * samples, or adaptive ones, where packets have 2 x 2 rays (plt_packet_side), as all rays of a
 * pixel are of one packet; for PLT_SHADE_HEAT and PLT_SAMPLES_ADAPTIVE where many packets are under
 * way (PLT_SCHEDULE_BATCH, PLT_SCHEDULE_TASK). Builds without samples
 * or pictures of distances and visits (PARTS says `samples`, `diagrams`: engine.mk) do not know
 * these shaders; without both `samples` is not looked at, and without `samples` alone only one is
 * known. */
int plt_render_begin(plt_engine *engine, const plt_frame *frame);

enum plt_light_kind {
    PLT_LIGHT_POINT = 0,  /* fades by the distance squared */
    PLT_LIGHT_DISTANT = 1 /* as a sun: from one direction, everywhere alike */
};

#define PLT_LIGHTS_MOST 8u
#define PLT_LIGHT_SAMPLES_MOST 16u

typedef struct plt_light {
    float at[3];     /* where it is; distant: the direction towards it, of any length. Components
                      * within +-2^40 */
    float power[3];  /* red, green and blue that a white surface shows which faces it at a distance
                      * of 1; of a distant one at any. 0 .. 2^40 */
    float radius;    /* of a disc that faces what it lights: shadows are soft; distant: of one at a
                      * distance of 1. 0: they are sharp. Up to 2^40 */
    uint8_t kind;    /* enum plt_light_kind */
    uint8_t samples; /* of the disc, a shadow ray each; 1 .. PLT_LIGHT_SAMPLES_MOST */
} plt_light;

/* What frames of PLT_SHADE_WHITTED are lit by. Light is linear: 1 is white, more is cut off. */
typedef struct plt_lighting {
    plt_light light[PLT_LIGHTS_MOST];
    float sky[3], ground[3]; /* light from above and from below, and what rays see that miss:
                              * between them by the angle to the frame's up. 0 .. 2^20 */
    uint8_t lights;          /* of `light` */
    uint8_t bounces;         /* rays that are not followed any further take the sky's light; at most
                              * those of plt_options.whitted */
    uint8_t solid_shadows;   /* 0: light comes through glass, straight, less what its surfaces
                              * reflect and it absorbs; 1: glass throws a shadow as what is opaque
                              * does, for less work */
} plt_lighting;

/* Copies it; until it is called there is no light at all. Ends a frame that was being rendered.
 * What triangles are made of their image says (SPEC.md, 4.20): of one that does not, and of
 * instances, all are of clay. PLT_ERR_ARGUMENT: a value is out of range, or there is no room for
 * it; nothing has changed.
 *
 * Not there without PLT_WITH_WHITTED. */
int plt_lighting_set(plt_engine *engine, const plt_lighting *lighting);

#if PLT_WITH_TEXTURE
/* Tiles of textures that were looked for in their room, since plt_stats_reset; all 0 where the
 * image is mapped. */
typedef struct plt_texture_stats {
    uint64_t found;   /* were there; a tile that is asked for again and again counts once */
    uint64_t fetched; /* came from the source */
    uint64_t bytes_fetched;
    uint64_t retries; /* came late, short or wrong */
} plt_texture_stats;

void plt_texture_stats_get(const plt_engine *engine, plt_texture_stats *stats);
#endif

/* Goes on with the frame for about `visits` node visits, so that a main loop stays alive: at least
 * one stack entry is worked off, which visits at most a treelet or a list, and a wave goes on by
 * at most two nodes per ray in flight. Returns PLT_MORE, PLT_TILE (fetch it with plt_render_tile)
 * or PLT_OK when the frame is complete or none is in progress; PLT_ERR_SOURCE, PLT_ERR_IMAGE: as
 * plt_trace, and the frame has ended. The engine can go on with the next. */
int plt_render_step(plt_engine *engine, uint32_t visits);
void plt_render_tile(const plt_engine *engine, plt_tile *tile);

/* Engines over one image can share a frame, each with a thread, a core or a machine of its own. All
 * begin the same frame. Each is then told which tile it goes on with, and counts the tiles
 * that come: as many of them as are its own, and no step after the last.
 *
 *     plt_render_begin(engine, &frame);
 *     while (take_run(&first, &count)) { // some tiles that nobody else has taken
 *         plt_render_seek(engine, first, count);
 *         while (count > 0 && (status = plt_render_step(engine, 1000)) > PLT_OK) {
 *             count -= status == PLT_TILE; // and fetch it
 *         }
 *     }
 *
 * plt_render_tiles: how many tiles the frame has, or 0 when none is in progress. They are
 * numbered from 0 in the order in which they come without a seek: row by row, but those of a
 * streamed scene along curves, so that neighbours follow each other. An engine fetches least when
 * most of its tiles are consecutive.
 *
 * plt_render_seek: the next step begins tile `tile`; one that is not finished is dropped. `count`:
 * so many are wanted, at least 1; batches end there, and begin anew if the caller goes on. What the
 * frame's pixels are does not depend on the order of tiles. PLT_ERR_ARGUMENT: there is no such
 * tile, count is 0, or no frame is in progress; nothing has changed. Cost: some 20 operations, of a
 * streamed scene up to 64 steps along a curve; one that drops a batch lays its pools out anew.
 * Firmware has both where PARTS says `seek` (engine.mk). */
uint32_t plt_render_tiles(const plt_engine *engine);
int plt_render_seek(plt_engine *engine, uint32_t tile, uint32_t count);

/* ---- tasks --------------------------------------------------------------------- */

/* Engines can also share the packets of a frame, or of an array of rays, treelet by treelet, as
 * the SPEs of the thesis do (section 4.3). One is the dispatcher (PLT_SCHEDULE_TASK): it has the
 * packets, and the edges that they wait at. The others (PLT_SCHEDULE_WORKER) have a store and a
 * traversal, over the same image and with packets of the dispatcher's size (options.packet_side =
 * plt_packet_side(dispatcher)). All ask for tasks, the dispatcher too, each on its own thread or
 * core, or in turns:
 *
 *     plt_render_begin(dispatcher, &frame); // or plt_trace_begin
 *     // each worker:
 *     do {
 *         lock();
 *         while ((status = plt_task_next(dispatcher, worker)) == PLT_TILE) {
 *             // plt_render_tile(dispatcher, ...)
 *         }
 *         unlock();
 *         if (status == PLT_MORE) {
 *             while (plt_task_run(dispatcher, worker, 1000) == PLT_MORE) {
 *             }
 *         }
 *     } while (status == PLT_MORE || status == PLT_WAIT);
 *
 * Tiles come in the same order as without workers, and pictures and hits are the same. While one
 * of them has a task, nothing else is called with either engine but these two. An engine of
 * PLT_SCHEDULE_TASK alone is its own worker in plt_render_step and plt_trace.
 *
 * plt_task_next: gives back what the worker's last task was for, and takes another. One call at a
 * time per dispatcher. PLT_MORE: plt_task_run has to be called until it is done. PLT_TILE: a tile
 * of the dispatcher's frame is finished, the worker has no task yet. PLT_WAIT: ask again when
 * another worker has. PLT_OK: frame or rays are done, or another worker's task has failed.
 * PLT_ERR_SOURCE, PLT_ERR_IMAGE: this worker's task has failed (plt_fault_get(worker)), and with it
 * frame or rays are over. PLT_ERR_ARGUMENT: not a dispatcher, or not a worker of its kind.
 *
 * plt_task_run: goes on with the task for about `visits` node visits, at the same time as other
 * workers. PLT_MORE, or PLT_OK: it is done, well or not.
 *
 * plt_trace_begin: plt_trace with workers; rays and hits must live until it is done, and hits of
 * a run that failed are of no use. PLT_ERR_ARGUMENT: not a dispatcher.
 *
 * A worker comes to one dispatcher until it has no task of it.
 *
 * Not there without PLT_WITH_TASK. */
int plt_trace_begin(plt_engine *dispatcher, const plt_ray *rays, plt_hit *hits, uint32_t count,
                    int any);
int plt_task_next(plt_engine *dispatcher, plt_engine *worker);
int plt_task_run(const plt_engine *dispatcher, plt_engine *worker, uint32_t visits);

/* What has passed between a dispatcher and its workers since plt_stats_reset, itself included. The
 * host's workers share its memory: bytes are what memories of their own would have to exchange. */
typedef struct plt_task_stats {
    uint64_t packets;       /* that are done */
    uint64_t tasks;         /* handed out; as many have come back */
    uint64_t edges;         /* given back: treelets that packets are to go on to */
    uint64_t packets_moved; /* from one worker to another */
    uint64_t bytes_out;     /* to workers: places, entries, packets that another had before */
    uint64_t bytes_back;    /* from workers: places, entries, those packets; hits, or pixels */
} plt_task_stats;

void plt_task_stats_get(const plt_engine *dispatcher, plt_task_stats *stats);

/* Why the last plt_trace or plt_render_step of a streamed scene failed: the byte of the image,
 * and the rule of SPEC.md that is broken, if one is. */
void plt_fault_get(const plt_engine *engine, plt_fault *fault);

/* ---- statistics ------------------------------------------------------ */

/* Frames, depth first, are traced by beams where four lanes are not one register (DESIGN.md,
 * section 6), but for those of streamed thesis nodes and of instances: a packet is then one beam,
 * and its triangles are tested once for all of its pixels. */
typedef struct plt_stats {
    uint64_t rays;           /* of packets that were begun, and of waves */
    uint64_t node_visits;    /* nodes decoded, once per packet, or per hull of its rays; of a grid
                                cells looked at */
    uint64_t group_tests;    /* four rays, four hulls of rays or a beam against a child's box;
                                not boxes tested again. Of a grid references of those cells */
    uint64_t triangle_tests; /* four rays against one triangle, as if every group that
                                reached a leaf met all of its triangles; or one beam */
    uint64_t treelet_fetches;
    uint64_t bytes_fetched;      /* of those treelets, had each been copied */
    uint64_t bytes_touched_once; /* of different treelets among them; if count_touched */
    uint64_t store_evictions;    /* streamed: parts given up for others; treelet_fetches and
                                  * bytes_fetched are then what really came, nodes, geometry and
                                  * ids, and bytes_touched_once what of it was different */
    uint64_t fetch_retries;      /* streamed: parts that came late, short or wrong */
    uint64_t mixed_packets;      /* packets whose rays differ in sign */
    uint64_t packets;
    uint64_t wave_rays; /* of `rays`, those that went by the wave. Each visits nodes for itself:
                         * a visit tests its children's boxes at once, one group_test; up to four
                         * triangles at once are one triangle_test. No treelets are counted.
                         * How many they are depends on the calls before, too, whether or not
                         * statistics were reset between them; hits do not. */
    uint64_t bytes_validated; /* streamed: of parts that were validated, which is when they are
                               * needed, and again when what they belong to has come anew */
} plt_stats;

void plt_stats_get(const plt_engine *engine, plt_stats *stats);
void plt_stats_reset(plt_engine *engine);

/* Rays along a packet's side: as asked for, or as there was room for. */
unsigned plt_packet_side(const plt_engine *engine);

/* Packets of a batch or of a dispatcher, likewise; 0: there are none. Not there without
 * PLT_WITH_BATCH. */
unsigned plt_batch_packets(const plt_engine *engine);

/* Bytes of the arena in use, and the most that ever were. Opening lends some that are free: they
 * make it faster, and do not count. */
size_t plt_arena_used(const plt_engine *engine);
size_t plt_arena_peak(const plt_engine *engine);

#ifdef __cplusplus
}
#endif
#endif
