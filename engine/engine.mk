# engine - its files, and which of them make a part of it
#
# PARTS is empty (all of it) or a list of words:
#   render   no builder: images whose tree is finished
#   thesis   thesis nodes and lists, no compact blocks
#   compact  compact blocks alone
#   wave     with the wave for incoherent rays, which firmware is without unless it asks for it
#   stream   with scenes that stay in their source, part by part, which firmware is without,
#            too
#   batch    with packets that meet at the blocks of such scenes
#   task     ... and go from there to workers, on other cores (plt_task_next)
#   seek     with plt_render_seek, for boards whose cores share a frame; other firmware is without
#   prefetch  ... whose blocks may be on their way before they are needed, likewise
#   motion   with plt_move, for triangles of thesis nodes, and, unless it is `render`, with
#            plt_rebuild_begin; other firmware is without
#   some     ... and with plt_move_some, likewise
#   subtree  ... and with plt_options.rebuild_most, likewise
#   sequence ... and with plt_sequence_show, for frames that an image holds; of compact blocks,
#            which move by frames alone, `compact motion sequence`
#   vertices ... and without records, where the arena has no room for them (plt_options.records)
#   background  with frames before one colour (plt_frame.background), likewise
#   grid     with grids instead of trees (plt_options.structure), for thesis nodes; likewise
#   instances with bodies that instances place (plt_place), for thesis nodes; likewise
#   surface  with normals and colours (plt_options.surface); likewise
#   texcoords ... and texture coordinates (plt_surface_point.texcoord), likewise
#   texture  ... and textures (plt_options.textures), likewise
#   whitted  with frames that have lights, shadows, mirrors and glass (PLT_SHADE_WHITTED), which
#            firmware is without unless it asks for it
#   samples  with several rays per pixel (plt_frame.samples), which firmware is without, too
#   small    compiled for size, all of it, with fewer ways through a beam: an eighth less code
#   diagrams with pictures of distances and of node visits, likewise
#   frames   nothing but frames, no plt_trace: with `thesis` or `compact`; of scenes that stay
#            in their source with `compact` alone
# Frames are traced by beams, everything else by groups of four rays. The whole engine has both;
# `thesis` and `compact` have groups, with `frames` beams.
# Whatever a part leaves out is refused when an image asks for it (planelet_config.h).
# SPDX-License-Identifier: MIT

PARTS ?=
ENGINE_ALL := $(sort $(wildcard engine/*.c engine/*/*.c engine/*/*/*.c))

builder_files := $(wildcard engine/builder/*.c engine/scene/build_*.c engine/scene/worst_tree.c \
    engine/tree/thesis/treelets.c engine/image/record_cache.c)
compact_files := $(wildcard engine/tree/compact/*.c engine/memory/block_cache.c \
    engine/memory/stream.c engine/image/record_cache.c engine/scene/*_compact.c \
    engine/scene/*_streamed.c engine/trace/*_compact.c engine/trace/*_streamed.c \
    engine/trace/frustum.c engine/builder/blocks*.c engine/builder/strips.c \
    engine/builder/split_lattice.c engine/builder/split_given.c engine/shade/beam_compact.c \
    engine/shade/beam_streamed.c engine/shade/beam_sight.c engine/shade/beam_store.c \
    engine/shade/beam_strips.c engine/motion/block_*.c)
thesis_files := $(wildcard engine/tree/thesis/*.c engine/memory/treelet_stream.c \
    engine/scene/*_thesis.c engine/scene/*_list.c \
    engine/trace/*_thesis.c engine/trace/*_list.c engine/builder/build.c \
    engine/builder/split_records.c engine/shade/beam_thesis.c)

wave_files := $(wildcard engine/trace/wave*.c engine/trace/wide_form.c engine/trace/collapse_*.c \
    engine/trace/ray_block.c engine/trace/coherence.c)
seek_files := engine/seek.c engine/shade/seek.c
stream_files := $(addprefix engine/memory/,store.c wanted.c fetcher.c prefetch.c stream.c) \
    engine/memory/treelet_stream.c engine/tree/thesis/validate_treelet.c \
    engine/tree/thesis/checks.c \
    $(wildcard engine/scene/open_streamed*.c engine/trace/traverse_streamed*.c) \
    engine/shade/tile_order.c engine/shade/beam_streamed.c
task_files := engine/task.c engine/schedule/dispatch.c engine/schedule/worker.c \
    engine/shade/frame_packets.c
batch_files := engine/trace/tasks.c $(wildcard engine/schedule/*.c)
sequence_files := engine/sequence.c engine/frame_put.c \
    $(wildcard engine/motion/frame_*.c engine/motion/sequence*.c \
    engine/motion/block_*.c) engine/motion/vertices.c engine/tree/compact/turns.c
vertices_files := engine/beside.c engine/motion/beside.c engine/motion/refit_vertices.c \
    engine/scene/open_vertices.c engine/tree/vertex_lists.c engine/trace/traverse_vertices.c \
    engine/shade/beam_vertices.c
some_files := engine/move_some.c engine/motion/dirty.c
subtree_files := $(wildcard engine/motion/subtree*.c)
rebuild_files := engine/rebuild.c engine/motion/rebuild.c $(subtree_files)
records_files := engine/move_some.c engine/rebuild.c $(addprefix engine/motion/,corners.c dirty.c \
    node_box.c rebuild.c refit.c vertices.c) \
    $(subtree_files)
motion_files := engine/move.c engine/motion_room.c engine/move_some.c engine/rebuild.c \
    $(wildcard engine/motion/*.c)
grid_files := $(wildcard engine/grid/*.c engine/grid_room.c engine/scene/open_grid.c \
    engine/trace/grid_*.c engine/trace/traverse_grid.c engine/shade/beam_grid.c \
    engine/shade/beam_references.c engine/shade/beam_slopes.c)
instances_files := $(wildcard engine/instances/*.c) engine/instances_room.c engine/place.c \
    engine/scene/open_instances.c engine/trace/traverse_instances.c
surface_files := $(wildcard engine/surface/*.c) engine/surface_room.c \
    engine/shade/smooth.c engine/shade/beam_smooth.c engine/scene/surface_place.c \
    engine/tree/compact/block_record.c engine/trace/kept.c engine/trace/surface_hit.c
texcoord_files := engine/surface/texcoords.c
further_files := engine/image/further.c
material_files := engine/whitted/materials.c engine/materials_room.c
whitted_files := $(filter-out $(material_files),$(wildcard engine/whitted/*.c)) \
    engine/whitted_room.c engine/shade/whitted_frame.c engine/shade/whitted_mix.c
texture_files := $(wildcard engine/texture/*.c) engine/texture_room.c engine/whitted/paint.c \
    engine/shade/smooth_paint.c
samples_files := engine/shade/light.c engine/shade/beam_samples.c engine/shade/whitted_mix.c
diagrams_files := engine/shade/diagram.c
mixes_files := engine/shade/mixing.c engine/shade/beam_mix.c engine/shade/packet_mix.c
groups_files := $(addprefix engine/trace/,triangle.c triangle_cull.c triangle_lanes.c hulls.c \
    packet_set.c packet_plain.c packet_quick.c boxes.c rays.c packet_rays.c \
    leaf_compact.c frustum.c) \
    $(wildcard engine/trace/traverse*.c) $(wildcard engine/trace/grid_*.c) \
    engine/shade/camera_packet.c \
    engine/shade/camera_ranges.c \
    engine/shade/packet_shade.c engine/shade/packet_mix.c
beams_files := $(wildcard engine/shade/beam*.c) engine/shade/margins.c \
    engine/trace/triangle_ray.c

left_out_render := $(builder_files) $(rebuild_files)
left_out_thesis := $(compact_files)
left_out_compact := $(thesis_files) $(records_files) $(vertices_files) $(grid_files) \
    $(instances_files)
flags_render := -DPLT_WITH_BUILDER=0
flags_thesis := -DPLT_WITH_COMPACT=0
flags_compact := -DPLT_WITH_THESIS=0
flags_small := -DPLT_SMALL_CODE=1

ifneq ($(filter-out render thesis compact wave stream batch task prefetch seek motion some \
    subtree sequence vertices background grid instances surface texcoords whitted texture \
    samples diagrams small frames,$(PARTS)),)
$(error PARTS is a list of render, thesis and compact, and wave, stream, batch, task, prefetch, \
    seek, motion, some, subtree, sequence, vertices, background, grid, instances, surface, \
    texcoords, whitted, texture, samples, diagrams, small or frames; it has $(PARTS))
endif
both_formats := $(filter thesis compact,$(PARTS))
ifeq ($(words $(both_formats)),2)
$(error PARTS=thesis leaves compact out and PARTS=compact thesis: leave both away for all)
endif
ifeq ($(filter stream,$(PARTS))$(filter batch,$(PARTS)),batch)
$(error PARTS with batch has stream: make PARTS='render compact stream batch')
endif
ifeq ($(filter batch,$(PARTS))$(filter task,$(PARTS)),task)
$(error PARTS with task has stream and batch: make PARTS='render compact stream batch task')
endif
ifeq ($(filter compact,$(PARTS))$(filter motion,$(PARTS))$(filter sequence,$(PARTS)),compactmotion)
$(error PARTS with motion has thesis nodes, or compact ones with frames: make PARTS='render \
    thesis motion' or 'render compact motion sequence')
endif
ifeq ($(filter compact,$(PARTS))$(filter some,$(PARTS)),compactsome)
$(error PARTS with some has thesis nodes: make PARTS='render thesis motion some')
endif
ifeq ($(filter motion,$(PARTS))$(filter sequence,$(PARTS)),sequence)
$(error PARTS with sequence has motion: make PARTS='render thesis motion sequence')
endif
ifeq ($(filter sequence,$(PARTS))$(filter vertices,$(PARTS)),vertices)
$(error PARTS with vertices has sequence: make PARTS='render thesis motion sequence vertices')
endif
ifeq ($(filter motion,$(PARTS))$(filter some,$(PARTS)),some)
$(error PARTS with some has motion: make PARTS='render thesis motion some')
endif
ifeq ($(filter motion,$(PARTS))$(filter subtree,$(PARTS)),subtree)
$(error PARTS with subtree has motion: make PARTS='thesis motion subtree')
endif
ifeq ($(filter render,$(PARTS))$(filter subtree,$(PARTS)),rendersubtree)
$(error PARTS with subtree has a builder: make PARTS='thesis motion subtree')
endif
ifeq ($(filter compact,$(PARTS))$(filter grid,$(PARTS)),compactgrid)
$(error PARTS with grid has thesis nodes: make PARTS='render thesis grid')
endif
ifeq ($(filter compact,$(PARTS))$(filter instances,$(PARTS)),compactinstances)
$(error PARTS with instances has thesis nodes: make PARTS='render thesis instances')
endif
ifeq ($(filter surface,$(PARTS))$(filter texcoords,$(PARTS)),texcoords)
$(error PARTS with texcoords has surface: make PARTS='render thesis surface texcoords')
endif
ifeq ($(filter texcoords,$(PARTS))$(filter texture,$(PARTS)),texture)
$(error PARTS with texture has surface and texcoords: make PARTS='render thesis surface \
    texcoords texture')
endif
ifeq ($(filter stream,$(PARTS))$(filter prefetch,$(PARTS)),prefetch)
$(error PARTS with prefetch has stream: make PARTS='render compact stream prefetch')
endif
ifneq ($(filter frames,$(PARTS)),)
ifeq ($(filter thesis compact,$(PARTS)),)
$(error PARTS with frames has thesis or compact: make PARTS='render thesis frames')
endif
ifneq ($(filter wave batch instances whitted,$(PARTS)),)
$(error PARTS with frames has no wave, batch, instances or whitted: make PARTS='render \
    thesis frames')
endif
ifeq ($(filter stream,$(PARTS))$(filter thesis,$(PARTS)),streamthesis)
$(error PARTS with frames and stream has compact: make PARTS='render compact frames stream')
endif
left_out_frames := $(groups_files)
flags_frames := -DPLT_WITH_GROUPS=0
else
left_out_thesis += $(beams_files)
flags_thesis += -DPLT_WITH_BEAMS=0
left_out_compact += $(beams_files)
flags_compact += -DPLT_WITH_BEAMS=0
endif
without_stream := $(if $(filter host,$(BOARD))$(filter stream,$(PARTS)),,yes)
without_batch := $(if $(filter host,$(BOARD))$(filter batch,$(PARTS)),,yes)
without_task := $(if $(filter host,$(BOARD))$(filter task,$(PARTS)),,yes)
without_motion := $(if $(filter host,$(BOARD))$(filter motion,$(PARTS)),,yes)
without_sequence := $(if $(filter host,$(BOARD))$(filter sequence,$(PARTS)),,yes)
without_vertices := $(if $(filter host,$(BOARD))$(filter vertices,$(PARTS)),,yes)
without_some := $(if $(filter host,$(BOARD))$(filter some,$(PARTS)),,yes)
without_subtree := $(if $(filter host,$(BOARD))$(filter subtree,$(PARTS)),,yes)
without_background := $(if $(filter host,$(BOARD))$(filter background,$(PARTS)),,yes)
without_grid := $(if $(filter host,$(BOARD))$(filter grid,$(PARTS)),,yes)
without_instances := $(if $(filter host,$(BOARD))$(filter instances,$(PARTS)),,yes)
without_whitted := $(if $(filter host,$(BOARD))$(filter whitted,$(PARTS)),,yes)
without_surface := $(if $(filter host,$(BOARD))$(filter surface,$(PARTS)),,yes)
without_texcoords := $(if $(filter host,$(BOARD))$(filter texcoords,$(PARTS)),,yes)
without_texture := $(if $(filter host,$(BOARD))$(filter texture,$(PARTS)),,yes)
without_further := $(if $(without_whitted),$(without_surface))
without_materials := $(and $(without_whitted),$(without_texture))
without_seek := $(if $(filter host,$(BOARD))$(filter seek,$(PARTS)),,yes)
without_prefetch := $(if $(filter host,$(BOARD))$(filter prefetch,$(PARTS)),,yes)
without_wave := $(if $(filter host,$(BOARD))$(filter wave,$(PARTS)),,yes)
without_samples := $(if $(filter host,$(BOARD))$(filter samples,$(PARTS)),,yes)
without_diagrams := $(if $(filter host,$(BOARD))$(filter diagrams,$(PARTS)),,yes)
without_mixes := $(and $(without_samples),$(without_diagrams))
# Frames are shown by the same calls, whatever moves.
shown_files := $(if $(filter instances,$(PARTS)),engine/sequence.c)
ENGINE := $(filter-out $(foreach part,$(PARTS),$(left_out_$(part))) \
    $(if $(without_wave),$(wave_files)) $(if $(without_stream),$(stream_files)) \
    $(if $(without_batch),$(batch_files)) $(if $(without_task),$(task_files)) \
    $(if $(without_seek),$(seek_files)) $(if $(without_motion),$(motion_files)) \
    $(if $(without_some),$(some_files)) $(if $(without_subtree),$(subtree_files)) \
    $(if $(without_sequence),$(filter-out $(shown_files),$(sequence_files))) \
    $(if $(without_vertices),$(vertices_files)) $(if $(without_instances),$(instances_files)) \
    $(if $(without_whitted),$(whitted_files)) $(if $(without_surface),$(surface_files)) \
    $(if $(without_texcoords),$(texcoord_files)) \
    $(if $(without_further),$(further_files)) $(if $(without_texture),$(texture_files)) \
    $(if $(without_materials),$(material_files)) \
    $(if $(without_samples),$(samples_files)) $(if $(without_diagrams),$(diagrams_files)) \
    $(if $(without_mixes),$(mixes_files)) $(if $(without_grid),$(grid_files)),$(ENGINE_ALL))
PARTS_FLAGS := $(foreach part,$(PARTS),$(flags_$(part))) \
    $(if $(without_wave),-DPLT_WITH_WAVE=0) $(if $(without_stream),-DPLT_WITH_STREAMED=0) \
    $(if $(without_batch),-DPLT_WITH_BATCH=0) $(if $(without_task),-DPLT_WITH_TASK=0) \
    $(if $(without_motion),-DPLT_WITH_MOTION=0) $(if $(without_sequence),-DPLT_WITH_SEQUENCE=0) \
    $(if $(without_vertices),-DPLT_WITH_VERTICES=0) \
    $(if $(without_some),-DPLT_WITH_MOVE_SOME=0) $(if $(without_grid),-DPLT_WITH_GRID=0) \
    $(if $(without_instances),-DPLT_WITH_INSTANCES=0) \
    $(if $(without_surface),-DPLT_WITH_SURFACE=0) \
    $(if $(without_texcoords),-DPLT_WITH_TEXCOORDS=0) \
    $(if $(without_whitted),-DPLT_WITH_WHITTED=0) \
    $(if $(without_texture),-DPLT_WITH_TEXTURE=0) \
    $(if $(without_background),-DPLT_WITH_BACKGROUND=0) \
    $(if $(without_samples),-DPLT_WITH_SAMPLES=0) \
    $(if $(without_diagrams),-DPLT_WITH_DIAGRAMS=0) \
    $(if $(without_prefetch),-DPLT_WITH_PREFETCH=0) \
    $(if $(without_subtree),-DPLT_WITH_SUBTREES=0)
# What runs when a scene is opened, once per frame or packet, and for the few rays that single
# precision cannot decide: firmware compiles it for size.
ENGINE_SELDOM := $(wildcard engine/image/*.c engine/layout.c engine/open.c engine/calls.c \
    engine/motion_room.c \
    engine/base/between.c engine/move.c engine/move_some.c engine/rebuild.c \
    engine/motion/dirty.c engine/motion/moving.c engine/motion/rebuild.c engine/scene/*.c \
    engine/tree/*/validate*.c \
    engine/builder/b*.c engine/builder/strips.c engine/tree/thesis/treelets.c \
    engine/base/arena.c engine/trace/traversal.c engine/trace/rays.c \
    engine/trace/packet_rays.c engine/trace/triangle_seldom.c engine/trace/exact.c \
    engine/trace/wide.c engine/grid/build.c engine/grid/crowded.c engine/grid_room.c \
    engine/trace/collapse_*.c engine/trace/wide_form.c \
    engine/shade/margins.c engine/shade/tile_order.c engine/shade/camera.c \
    engine/shade/rendering.c engine/shade/mixing.c engine/seek.c engine/shade/seek.c \
    engine/sequence.c engine/frame_put.c engine/beside.c engine/motion/beside.c \
    engine/motion/sequence*.c engine/motion/frame_reader.c \
    engine/instances/*.c engine/instances_room.c engine/place.c engine/surface_room.c \
    engine/surface/surface_data.c engine/surface/surface_pages.c engine/surface/page_fetch.c \
    engine/whitted_room.c engine/whitted/materials.c engine/materials_room.c \
    engine/texture_room.c engine/texture/directory.c engine/texture/tiles.c)
# With `small` all of it is, but for the files that take most instructions per byte that is saved.
ENGINE_FOR_SIZE := $(if $(filter small,$(PARTS)),$(filter-out $(addprefix engine/shade/,beam.c \
    beam_lists.c beam_shade.c),$(ENGINE_ALL)),$(ENGINE_SELDOM))
# In the names of folders: -render, -render-thesis.
empty :=
space := $(empty) $(empty)
PARTS_NAME := $(addprefix -,$(subst $(space),-,$(strip $(sort $(PARTS)))))
