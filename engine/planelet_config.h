/* planelet_config - every knob of the engine: unit, range, default, cost
 *
 * Set a knob with -DPLT_NAME=value; a value out of range does not compile.
 * The cost is what one more takes of the arena, unless said otherwise.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLANELET_CONFIG_H
#define PLANELET_CONFIG_H

#include <stdint.h>

/* Parts of the engine, 1 or 0; an image that needs a part which was left out is refused
 * with PLT_ERR_LIMIT. Cost: code. `make PARTS=...` sets them and leaves the files out. */
#ifndef PLT_WITH_THESIS
#define PLT_WITH_THESIS 1 /* thesis nodes, and lists without a tree */
#endif
#ifndef PLT_WITH_COMPACT
#define PLT_WITH_COMPACT 1 /* compact blocks */
#endif
#ifndef PLT_WITH_BUILDER
#define PLT_WITH_BUILDER 1 /* images whose tree is built in the arena */
#endif

/* Scenes that stay in their source, part by part fetched when a ray needs it; of both formats, or
 * of one. */
#ifndef PLT_WITH_STREAMED
#define PLT_WITH_STREAMED 1
#endif
#ifndef PLT_WITH_STREAMED_THESIS
#if PLT_WITH_STREAMED && PLT_WITH_THESIS
#define PLT_WITH_STREAMED_THESIS 1
#else
#define PLT_WITH_STREAMED_THESIS 0
#endif
#endif
#ifndef PLT_WITH_STREAMED_COMPACT
#if PLT_WITH_STREAMED && PLT_WITH_COMPACT
#define PLT_WITH_STREAMED_COMPACT 1
#else
#define PLT_WITH_STREAMED_COMPACT 0
#endif
#endif

#ifndef PLT_WITH_BATCH
#define PLT_WITH_BATCH PLT_WITH_STREAMED /* packets that meet at streamed blocks (schedule/) */
#endif

#ifndef PLT_WITH_TASK
#define PLT_WITH_TASK PLT_WITH_BATCH /* ... and go to workers from there (plt_task_next) */
#endif

#ifndef PLT_WITH_PREFETCH
#define PLT_WITH_PREFETCH PLT_WITH_STREAMED /* ... or before (plt_options.prefetch) */
#endif

#ifndef PLT_WITH_MOTION
#define PLT_WITH_MOTION 1 /* triangles that move (plt_move) */
#endif

#ifndef PLT_WITH_SEQUENCE
#define PLT_WITH_SEQUENCE PLT_WITH_MOTION /* ... as an image's frames say (plt_sequence_show) */
#endif

#ifndef PLT_WITH_BLOCK_MOTION /* ... of compact blocks */
#if PLT_WITH_SEQUENCE && PLT_WITH_COMPACT
#define PLT_WITH_BLOCK_MOTION 1
#else
#define PLT_WITH_BLOCK_MOTION 0
#endif
#endif

#ifndef PLT_WITH_STILLS /* ... that are streamed */
#if PLT_WITH_BLOCK_MOTION && PLT_WITH_STREAMED_COMPACT
#define PLT_WITH_STILLS 1
#else
#define PLT_WITH_STILLS 0
#endif
#endif

#ifndef PLT_WITH_VERTICES /* ... without records (plt_options.records) */
#if PLT_WITH_SEQUENCE && PLT_WITH_THESIS
#define PLT_WITH_VERTICES 1
#else
#define PLT_WITH_VERTICES 0
#endif
#endif

#ifndef PLT_WITH_MOVE_SOME
#if PLT_WITH_MOTION && PLT_WITH_THESIS
#define PLT_WITH_MOVE_SOME 1 /* ... some of them, for less (plt_move_some) */
#else
#define PLT_WITH_MOVE_SOME 0
#endif
#endif

#ifndef PLT_WITH_REBUILD
#if PLT_WITH_MOTION && PLT_WITH_BUILDER && PLT_WITH_THESIS
#define PLT_WITH_REBUILD 1 /* ... whose tree is built anew when it has become slow */
#else
#define PLT_WITH_REBUILD 0
#endif
#endif

#ifndef PLT_WITH_SUBTREES
#define PLT_WITH_SUBTREES PLT_WITH_REBUILD /* ... or a subtree, in its own slots */
#endif

#ifndef PLT_WITH_WAVE
#define PLT_WITH_WAVE 1 /* incoherent rays by the wave, wide forms (plt_options.rays_in_flight) */
#endif
#ifndef PLT_WITH_GROUPS
#define PLT_WITH_GROUPS 1 /* rays in groups of four: plt_trace, the two-stage order */
#endif
#ifndef PLT_SMALL_CODE
#define PLT_SMALL_CODE 0 /* beams: less code, more instructions per ray (PARTS with `small`) */
#endif

#ifndef PLT_WITH_BEAMS
#define PLT_WITH_BEAMS 1 /* frames by beams: faster, smaller */
#endif
#ifndef PLT_WITH_BACKGROUND
#define PLT_WITH_BACKGROUND 1 /* frames before one colour (plt_frame.background) */
#endif
#ifndef PLT_WITH_SAMPLES
#define PLT_WITH_SAMPLES 1 /* several rays per pixel (plt_frame.samples) */
#endif
#ifndef PLT_WITH_DIAGRAMS
#define PLT_WITH_DIAGRAMS 1 /* PLT_SHADE_DEPTH, PLT_SHADE_HEAT */
#endif
#define PLT_WITH_MIXES (PLT_WITH_SAMPLES || PLT_WITH_DIAGRAMS)
#ifndef PLT_WITH_GRID /* grids (plt_options.structure) */
#if PLT_WITH_THESIS
#define PLT_WITH_GRID 1
#else
#define PLT_WITH_GRID 0
#endif
#endif

/* Images of bodies that instances place by a matrix each (SPEC.md, 4.17). */
#ifndef PLT_WITH_INSTANCES
#if PLT_WITH_THESIS && PLT_WITH_GROUPS
#define PLT_WITH_INSTANCES 1
#else
#define PLT_WITH_INSTANCES 0
#endif
#endif

/* Normals and colours of an image (SPEC.md, 4.18 and on; plt_options.surface). */
#ifndef PLT_WITH_SURFACE
#define PLT_WITH_SURFACE 1
#endif

/* ... and its texture coordinates (SPEC.md, 4.21; plt_surface_point.texcoord). */
#ifndef PLT_WITH_TEXCOORDS
#define PLT_WITH_TEXCOORDS PLT_WITH_SURFACE
#endif

/* Frames with lights, shadows, mirrors and glass (PLT_SHADE_WHITTED). */
#ifndef PLT_WITH_WHITTED
#define PLT_WITH_WHITTED PLT_WITH_GROUPS
#endif
/* ... of scenes that are streamed, page by page. */
#define PLT_WITH_PAGES (PLT_WITH_SURFACE && PLT_WITH_STREAMED)
/* ... whose surfaces have textures (plt_options.textures). */
#ifndef PLT_WITH_TEXTURE
#define PLT_WITH_TEXTURE PLT_WITH_TEXCOORDS
#endif
/* Materials are of lights, and of textures, which lie on some of them. */
#define PLT_WITH_MATERIALS (PLT_WITH_WHITTED || PLT_WITH_TEXTURE)
/* Images may have sections behind those of tree and triangles. */
#define PLT_WITH_FURTHER (PLT_WITH_SURFACE || PLT_WITH_WHITTED)

/* Whether four lanes are one register everywhere, or only where something is left out
 * (engine/lanes/lanes.h). */
#if defined(PLT_LANES) && (!defined(PLT_LANES_FLUSHES) || !PLT_LANES_FLUSHES)
#define PLT_HAS_LANES 1
#else
#define PLT_HAS_LANES 0
#endif

/* The wave over compact blocks as they are, without a wide form (trace/wave_compact.h), where four
 * lanes are one register, or code is no matter: it takes 15 KB on a Cortex-M4F. */
#ifndef PLT_WITH_WAVE_COMPACT
#if PLT_WITH_WAVE && PLT_WITH_COMPACT && (PLT_HAS_LANES || UINTPTR_MAX > 0xFFFFFFFFu)
#define PLT_WITH_WAVE_COMPACT 1
#else
#define PLT_WITH_WAVE_COMPACT 0
#endif
#endif

/* Packets as trees of hulls (trace/hulls.h), where four lanes are one register; elsewhere they
 * cost more code than they save work. */
#ifndef PLT_WITH_HULLS
#if PLT_HAS_LANES
#define PLT_WITH_HULLS PLT_WITH_GROUPS
#else
#define PLT_WITH_HULLS 0
#endif
#endif

/* Largest packet, rays along one side: 2, 4, 8 or 16. Decides only what
 * `plt_options.packet_side` may be: the arena holds the packet asked for. */
#ifndef PLT_PACKET_SIDE_MAX
#define PLT_PACKET_SIDE_MAX 16
#endif

/* Tile buffer, pixels along one side: 2, 4, 8, 16 or 32, and at least the
 * packet side. Cost: 3 bytes per pixel (16: 768 bytes). */
#ifndef PLT_TILE_SIDE
#define PLT_TILE_SIDE 16
#endif

/* Most inner nodes on a path from the root: 8 .. 512. The builder keeps to it,
 * opening refuses a deeper tree. Cost: 12 to 80 bytes of the depth-first stack
 * (a scene takes what it needs, not the maximum; DESIGN.md, section 3). */
#ifndef PLT_DEPTH_MAX
#define PLT_DEPTH_MAX 64
#endif

/* 1: a program that builds compact blocks may give the tree (builder/split_given.c), as the host's
 * packer does; 0: nobody does (board/firmware.mk). Cost: about 250 bytes of code, and a pointer in
 * the arena while blocks are built. */
#ifndef PLT_BLOCKS_LEVELS
#define PLT_BLOCKS_LEVELS 1
#endif

/* Most entries of the global stack of the two-stage order: 16 .. 1048576.
 * Opening refuses a scene that needs more, whichever order is asked for: one
 * check serves both. Cost: as above. */
#ifndef PLT_GLOBAL_STACK_MAX
#define PLT_GLOBAL_STACK_MAX 65536
#endif

/* Bins per axis of the SAH builder: 4 .. 64. Cost: 128 bytes of build scratch. */
#ifndef PLT_SAH_BINS
#define PLT_SAH_BINS 32
#endif

/* Compact blocks that stay opened for the next visit (memory/block_cache.h): 1 .. 64; 8, or 16
 * where addresses have 64 bits. Cost: 324 bytes each (352), of scenes with compact nodes only. */
#ifndef PLT_BLOCK_CACHE_SLOTS
#if UINTPTR_MAX > 0xFFFFFFFFu
#define PLT_BLOCK_CACHE_SLOTS 16
#else
#define PLT_BLOCK_CACHE_SLOTS 8
#endif
#endif

/* Bytes per triangle that a grid takes of the arena at most, if there is room: 8 .. 1024. If its
 * cells want more, they are fewer. Cost: none, it takes what it needs; but if triangles move, which
 * nobody foresees, all of it. */
#ifndef PLT_GRID_TRIANGLE_BYTES
#define PLT_GRID_TRIANGLE_BYTES 64
#endif

/* 1: checksums by eight bytes at once (base/crc32_slices.h); 0: by halves of bytes, a tenth as
 * fast. 1 where addresses have 64 bits. Cost: 8 KB of constants. */
#ifndef PLT_CRC32_SLICES
#if UINTPTR_MAX > 0xFFFFFFFFu
#define PLT_CRC32_SLICES 1
#else
#define PLT_CRC32_SLICES 0
#endif
#endif

/* Bytes asked of a source in one transfer: 64 .. 1048576. Cost: none. */
#ifndef PLT_TRANSFER_BYTES
#define PLT_TRANSFER_BYTES 4096
#endif

/* How often a part of a streamed block is fetched, if it is late, short or wrong, before a
 * traversal fails: 1 .. 255. Cost: none. */
#ifndef PLT_FETCH_TRIES
#define PLT_FETCH_TRIES 3
#endif

/* What rebuilding a tree costs, in group tests per triangle: 1 .. 10000; and how much more work
 * rays are than in a new tree, in percent of the growth of its nodes' areas: 1 .. 10000
 * (plt_rebuild_due; DESIGN.md, section 5.3). Cost: none. */
#ifndef PLT_REBUILD_WORK
#define PLT_REBUILD_WORK 24
#endif
#ifndef PLT_GROWTH_WORK
#define PLT_GROWTH_WORK 100
#endif

/* Coordinates reach from -PLT_COORD_MAX to PLT_COORD_MAX (2^40), so that no
 * product of the ray/triangle test can overflow. Not a knob. */
#define PLT_COORD_MAX 1099511627776.0f

#if (PLT_WITH_THESIS != 0 && PLT_WITH_THESIS != 1) ||                                              \
    (PLT_WITH_COMPACT != 0 && PLT_WITH_COMPACT != 1) ||                                            \
    (PLT_WITH_BUILDER != 0 && PLT_WITH_BUILDER != 1) || (PLT_WITH_WAVE != 0 && PLT_WITH_WAVE != 1)
#error "PLT_WITH_THESIS, _COMPACT, _BUILDER and _WAVE are the digit 0 or 1"
#endif
#if (PLT_WITH_GROUPS != 0 && PLT_WITH_GROUPS != 1) || (PLT_WITH_BEAMS != 0 && PLT_WITH_BEAMS != 1)
#error "PLT_WITH_GROUPS and PLT_WITH_BEAMS are the digit 0 or 1"
#endif
#if (PLT_WITH_HULLS != 0 && PLT_WITH_HULLS != 1) || (PLT_WITH_HULLS && !PLT_WITH_GROUPS)
#error "PLT_WITH_HULLS is the digit 0, or with PLT_WITH_GROUPS 1"
#endif
#if PLT_CRC32_SLICES != 0 && PLT_CRC32_SLICES != 1
#error "PLT_CRC32_SLICES is the digit 0 or 1"
#endif
#if !PLT_WITH_THESIS && !PLT_WITH_COMPACT
#error "a format is wanted: PLT_WITH_THESIS or PLT_WITH_COMPACT"
#endif
#if PLT_SMALL_CODE != 0 && PLT_SMALL_CODE != 1
#error "PLT_SMALL_CODE is the digit 0 or 1"
#endif
#if !PLT_WITH_GROUPS && !PLT_WITH_BEAMS
#error "without PLT_WITH_GROUPS there are beams alone: PLT_WITH_BEAMS"
#endif
#if PLT_WITH_STREAMED == 1 && !PLT_WITH_STREAMED_THESIS && !PLT_WITH_STREAMED_COMPACT
#error "PLT_WITH_STREAMED wants a format: PLT_WITH_STREAMED_THESIS or PLT_WITH_STREAMED_COMPACT"
#endif
#if PLT_WITH_STREAMED != 0 && PLT_WITH_STREAMED != 1
#error "PLT_WITH_STREAMED is the digit 0 or 1"
#endif
#if (PLT_WITH_STREAMED_THESIS != 0 && PLT_WITH_STREAMED_THESIS != 1) ||                            \
    (PLT_WITH_STREAMED_THESIS && !(PLT_WITH_STREAMED && PLT_WITH_THESIS))
#error "PLT_WITH_STREAMED_THESIS is the digit 0, or with PLT_WITH_STREAMED and PLT_WITH_THESIS 1"
#endif
#if (PLT_WITH_STREAMED_COMPACT != 0 && PLT_WITH_STREAMED_COMPACT != 1) ||                          \
    (PLT_WITH_STREAMED_COMPACT && !(PLT_WITH_STREAMED && PLT_WITH_COMPACT))
#error "PLT_WITH_STREAMED_COMPACT is the digit 0, or with PLT_WITH_STREAMED and PLT_WITH_COMPACT 1"
#endif
#if (PLT_WITH_BATCH != 0 && PLT_WITH_BATCH != 1) || (PLT_WITH_BATCH && !PLT_WITH_STREAMED)
#error "PLT_WITH_BATCH is the digit 0, or with PLT_WITH_STREAMED 1"
#endif
#if (PLT_WITH_TASK != 0 && PLT_WITH_TASK != 1) || (PLT_WITH_TASK && !PLT_WITH_BATCH)
#error "PLT_WITH_TASK is the digit 0, or with PLT_WITH_BATCH 1"
#endif
#if (PLT_WITH_PREFETCH != 0 && PLT_WITH_PREFETCH != 1) || (PLT_WITH_PREFETCH && !PLT_WITH_STREAMED)
#error "PLT_WITH_PREFETCH is the digit 0, or with PLT_WITH_STREAMED 1"
#endif
#if (PLT_WITH_WAVE_COMPACT != 0 && PLT_WITH_WAVE_COMPACT != 1) ||                                  \
    (PLT_WITH_WAVE_COMPACT && !(PLT_WITH_WAVE && PLT_WITH_COMPACT))
#error "PLT_WITH_WAVE_COMPACT is the digit 0, or with PLT_WITH_WAVE and PLT_WITH_COMPACT 1"
#endif
#if (PLT_WITH_BLOCK_MOTION != 0 && PLT_WITH_BLOCK_MOTION != 1) ||                                  \
    (PLT_WITH_BLOCK_MOTION && !(PLT_WITH_SEQUENCE && PLT_WITH_COMPACT))
#error "PLT_WITH_BLOCK_MOTION is the digit 0, or with PLT_WITH_SEQUENCE and PLT_WITH_COMPACT 1"
#endif
#if (PLT_WITH_STILLS != 0 && PLT_WITH_STILLS != 1) ||                                              \
    (PLT_WITH_STILLS && !(PLT_WITH_BLOCK_MOTION && PLT_WITH_STREAMED_COMPACT))
#error "PLT_WITH_STILLS is the digit 0, or with PLT_WITH_BLOCK_MOTION and _STREAMED_COMPACT 1"
#endif
#if (PLT_WITH_MOTION != 0 && PLT_WITH_MOTION != 1) ||                                              \
    (PLT_WITH_MOTION && !(PLT_WITH_THESIS || PLT_WITH_BLOCK_MOTION))
#error "PLT_WITH_MOTION is the digit 0, or with PLT_WITH_THESIS or PLT_WITH_BLOCK_MOTION 1"
#endif
#if (PLT_WITH_SEQUENCE != 0 && PLT_WITH_SEQUENCE != 1) || (PLT_WITH_SEQUENCE && !PLT_WITH_MOTION)
#error "PLT_WITH_SEQUENCE is the digit 0, or with PLT_WITH_MOTION 1"
#endif
#if (PLT_WITH_VERTICES != 0 && PLT_WITH_VERTICES != 1) ||                                          \
    (PLT_WITH_VERTICES && !(PLT_WITH_SEQUENCE && PLT_WITH_THESIS))
#error "PLT_WITH_VERTICES is the digit 0, or with PLT_WITH_SEQUENCE and PLT_WITH_THESIS 1"
#endif
#if (PLT_WITH_MOVE_SOME != 0 && PLT_WITH_MOVE_SOME != 1) ||                                        \
    (PLT_WITH_MOVE_SOME && !(PLT_WITH_MOTION && PLT_WITH_THESIS))
#error "PLT_WITH_MOVE_SOME is the digit 0, or with PLT_WITH_MOTION and PLT_WITH_THESIS 1"
#endif
#if (PLT_WITH_REBUILD != 0 && PLT_WITH_REBUILD != 1) ||                                            \
    (PLT_WITH_REBUILD && !(PLT_WITH_MOTION && PLT_WITH_BUILDER && PLT_WITH_THESIS))
#error "PLT_WITH_REBUILD is the digit 0, or with PLT_WITH_MOTION, _BUILDER and _THESIS 1"
#endif
#if (PLT_WITH_SUBTREES != 0 && PLT_WITH_SUBTREES != 1) || (PLT_WITH_SUBTREES && !PLT_WITH_REBUILD)
#error "PLT_WITH_SUBTREES is the digit 0, or with PLT_WITH_REBUILD 1"
#endif
#if (PLT_WITH_GRID != 0 && PLT_WITH_GRID != 1) || (PLT_WITH_GRID && !PLT_WITH_THESIS)
#error "PLT_WITH_GRID is the digit 0, or with PLT_WITH_THESIS 1"
#endif
#if PLT_WITH_BACKGROUND != 0 && PLT_WITH_BACKGROUND != 1
#error "PLT_WITH_BACKGROUND is the digit 0 or 1"
#endif
#if PLT_WITH_SAMPLES != 0 && PLT_WITH_SAMPLES != 1
#error "PLT_WITH_SAMPLES is the digit 0 or 1"
#endif
#if PLT_WITH_DIAGRAMS != 0 && PLT_WITH_DIAGRAMS != 1
#error "PLT_WITH_DIAGRAMS is the digit 0 or 1"
#endif
#if (PLT_WITH_INSTANCES != 0 && PLT_WITH_INSTANCES != 1) ||                                        \
    (PLT_WITH_INSTANCES && !(PLT_WITH_THESIS && PLT_WITH_GROUPS))
#error "PLT_WITH_INSTANCES is the digit 0, or with PLT_WITH_THESIS and PLT_WITH_GROUPS 1"
#endif
#if PLT_WITH_SURFACE != 0 && PLT_WITH_SURFACE != 1
#error "PLT_WITH_SURFACE is the digit 0 or 1"
#endif
#if (PLT_WITH_TEXCOORDS != 0 && PLT_WITH_TEXCOORDS != 1) ||                                        \
    (PLT_WITH_TEXCOORDS && !PLT_WITH_SURFACE)
#error "PLT_WITH_TEXCOORDS is the digit 0, or with PLT_WITH_SURFACE 1"
#endif
#if (PLT_WITH_WHITTED != 0 && PLT_WITH_WHITTED != 1) || (PLT_WITH_WHITTED && !PLT_WITH_GROUPS)
#error "PLT_WITH_WHITTED is the digit 0, or with PLT_WITH_GROUPS 1"
#endif
#if (PLT_WITH_TEXTURE != 0 && PLT_WITH_TEXTURE != 1) || (PLT_WITH_TEXTURE && !PLT_WITH_TEXCOORDS)
#error "PLT_WITH_TEXTURE is the digit 0, or with PLT_WITH_TEXCOORDS 1"
#endif
#if PLT_GRID_TRIANGLE_BYTES < 8 || PLT_GRID_TRIANGLE_BYTES > 1024
#error "PLT_GRID_TRIANGLE_BYTES is 8 .. 1024"
#endif
#if PLT_WITH_STREAMED_THESIS && !PLT_WITH_GROUPS
#error "PLT_WITH_STREAMED_THESIS is for PLT_WITH_GROUPS"
#endif
#if PLT_WITH_BATCH && !PLT_WITH_GROUPS
#error "PLT_WITH_BATCH is for PLT_WITH_GROUPS"
#endif
#if PLT_WITH_WAVE && !PLT_WITH_GROUPS
#error "PLT_WITH_WAVE is for PLT_WITH_GROUPS"
#endif
#if PLT_PACKET_SIDE_MAX != 2 && PLT_PACKET_SIDE_MAX != 4 && PLT_PACKET_SIDE_MAX != 8 &&            \
    PLT_PACKET_SIDE_MAX != 16
#error "PLT_PACKET_SIDE_MAX is 2, 4, 8 or 16"
#endif
#if PLT_TILE_SIDE != 2 && PLT_TILE_SIDE != 4 && PLT_TILE_SIDE != 8 && PLT_TILE_SIDE != 16 &&       \
    PLT_TILE_SIDE != 32
#error "PLT_TILE_SIDE is 2, 4, 8, 16 or 32"
#endif
#if PLT_TILE_SIDE < PLT_PACKET_SIDE_MAX
#error "PLT_TILE_SIDE is at least PLT_PACKET_SIDE_MAX"
#endif
#if PLT_DEPTH_MAX < 8 || PLT_DEPTH_MAX > 512
#error "PLT_DEPTH_MAX is 8 .. 512"
#endif
#if PLT_BLOCKS_LEVELS != 0 && PLT_BLOCKS_LEVELS != 1
#error "PLT_BLOCKS_LEVELS is 0 or 1"
#endif
#if PLT_GLOBAL_STACK_MAX < 16 || PLT_GLOBAL_STACK_MAX > 1048576
#error "PLT_GLOBAL_STACK_MAX is 16 .. 1048576"
#endif
#if PLT_SAH_BINS < 4 || PLT_SAH_BINS > 64
#error "PLT_SAH_BINS is 4 .. 64"
#endif
#if PLT_BLOCK_CACHE_SLOTS < 1 || PLT_BLOCK_CACHE_SLOTS > 64
#error "PLT_BLOCK_CACHE_SLOTS is 1 .. 64"
#endif
#if PLT_FETCH_TRIES < 1 || PLT_FETCH_TRIES > 255
#error "PLT_FETCH_TRIES is 1 .. 255"
#endif
#if PLT_REBUILD_WORK < 1 || PLT_REBUILD_WORK > 10000
#error "PLT_REBUILD_WORK is 1 .. 10000"
#endif
#if PLT_GROWTH_WORK < 1 || PLT_GROWTH_WORK > 10000
#error "PLT_GROWTH_WORK is 1 .. 10000"
#endif
#if PLT_TRANSFER_BYTES < 64 || PLT_TRANSFER_BYTES > 1048576
#error "PLT_TRANSFER_BYTES is 64 .. 1048576"
#endif

#endif
