# firmware - what every board except the host has in common
#
# Engine, firmware and board become one build/BOARD/firmware.elf; PROGRAM=wired
# uses board/wired and the wire instead of the job in board/firmware.c, and is
# built in build/BOARD-wired; PROGRAM=played uses board/played, which plays
# sequences; PROGRAM=faults is a test of start-up, PROGRAM=lanes one of the lanes header,
# PROGRAM=jpeg measures an encoder, all without the engine. The worst stack is computed from
# the call graph before linking, and the linker script refuses a smaller stack. No C library
# is linked; its headers are used. Of the compiler's own library, libgcc, boards have what they
# ask for by LIBGCC := yes, and its functions are in the call graph, too.
# SPDX-License-Identifier: MIT

PROGRAM ?=
# The usual parts of a board have no name in its folder's.
OUT := $(BUILD)/$(BOARD)$(addprefix -,$(PROGRAM))$(if $(filter-out \
       $(sort $(BOARD_PARTS)),$(PARTS))$(filter-out $(PARTS),$(BOARD_PARTS)),$(PARTS_NAME))
HOST_CC ?= cc
# An environment that has CC would hand this one on: the host's make gets its own.
override CC := $(CROSS)gcc
TEST_PROGRAMS :=

COMMON := $(filter-out board/firmware.c,$(wildcard board/*.c))
program_ := board/firmware.c
program_played := $(wildcard board/played/*.c)
program_faults := tests/boards/faults.c
program_lanes := tests/boards/lanes.c tests/lanes/compare.c
program_jpeg := tests/boards/jpeg.c $(wildcard host_tools/picture/jpeg*.c)
program_wired := $(wildcard board/wired/*.c board/$(BOARD)/wired/*.c platform/wire/*.c)
ifeq ($(program_$(PROGRAM)),)
$(error there is no program $(PROGRAM); leave it out, or PROGRAM=wired, played, faults or lanes)
endif
ifeq ($(PROGRAM)$(wildcard board/$(BOARD)/wired/*.c),wired)
$(error board/$(BOARD) has no serial line; copy board/template/wired there, and write its serial.c)
endif
FIRMWARE := $(sort $(COMMON) $(program_$(PROGRAM)) \
                   $(foreach folder,board/$(BOARD) $(SHARED),$(wildcard $(folder)/*.c)))
objects = $(patsubst %.c,$(OUT)/%.o,$(1))
LANES_PROBES := $(patsubst %,$(OUT)/tests/lanes/probe_%.o,$(sort scalar $(LANES)))
WITHOUT_ENGINE := faults lanes jpeg
FIRMWARE_OBJECTS := $(call objects,$(if $(filter $(WITHOUT_ENGINE),$(PROGRAM)),,$(ENGINE))) \
                    $(call objects,$(FIRMWARE)) \
                    $(if $(filter lanes,$(PROGRAM)),$(LANES_PROBES))

# Where calls by pointer lead, beyond the board's SOURCE_FUNCTIONS: what a wired board streams
# comes by the wire, which waits for reports.
POINTERS_wired := $(if $(without_stream),,plt_fetch>wire_source_start plt_fetch>wire_source_wait \
                  wire_source_wait>pump_held pump_held>await_reports)
POINTERS_lanes := run

STACK_ROOT ?= machine_start
SOURCE_FUNCTIONS ?= scene_start scene_wait
LINK_SCRIPT ?= board/$(BOARD)/memory.ld

OPTIMISE_FOR := -O2
$(call objects,$(ENGINE_FOR_SIZE)): OPTIMISE_FOR := -Os

LANES ?= scalar
ifneq ($(call lanes_line,$(LANES)),)
lacks := $(shell sh platform/lanes.sh lacks '$(call lanes_macro,$(LANES))' $(CC) $(CPU) \
         $(call lanes_needs,$(LANES)))
ifneq ($(lacks),)
$(error LANES=$(LANES) is not for $(BOARD), whose compiler and CPU flags lack $(lacks))
endif
endif

# Loops stay loops: memcpy must not become a call of itself, nor a search for
# the end of a text a call of strlen.
COMMAND = $(PROBE_COMMAND) $(lanes_flags)
PROBE_COMMAND = $(CC) $(STRICT) $(CPU) $(OPTIMISE_FOR) -g $(FREESTANDING) \
          -ffunction-sections -fdata-sections -fcallgraph-info=su,da \
          -fno-tree-loop-distribute-patterns \
          -DPLT_BLOCKS_LEVELS=0 \
          -DPLT_BOARD_NAME='"$(BOARD)"' $(BOARD_FLAGS) \
          -DPLT_BOARD_ARENA_BYTES=$(ARENA_BYTES)u $(PARTS_FLAGS) $(FIRMWARE_FLAGS)

##build make BOARD=name [PROGRAM=wired] [PARTS='render thesis compact']: build/name/firmware.elf
firmware all: $(OUT)/firmware.elf $(OUT)/libcount.so

# The board first: what is wrong with a new one is in its own files.
$(OUT)/firmware.elf: $(call objects,$(FIRMWARE)) $(FIRMWARE_OBJECTS) $(OUT)/stack.txt \
                     $(LINK_SCRIPT) platform/bare/sections.ld
	@echo "$(CC) $@"
	@$(CC) $(CPU) -nostdlib -L. -T $(LINK_SCRIPT) -Wl,--gc-sections,-Map=$(OUT)/firmware.map \
	    -Wl,--defsym=plt_arena_bytes=$(ARENA_BYTES),--defsym=plt_stack_bytes=$(STACK_BYTES) \
	    -Wl,--defsym=plt_stack_worst=$$(sed -n 's/^worst \([0-9]*\).*/\1/p' $(OUT)/stack.txt) \
	    -o $@ $(FIRMWARE_OBJECTS) $(if $(LIBGCC),-lgcc) 2>$(OUT)/link.txt || \
	    { awk -v board=$(BOARD) -v arena=$(ARENA_BYTES) -v stack=$(STACK_BYTES) \
	        -f board/tools/too_large.awk $(OUT)/firmware.map $(OUT)/link.txt >&2; exit 1; }
	@$(CROSS)size $@

# The deepest path from start-up; fails on recursion and on stack frames of
# unknown size.
$(OUT)/stack.txt: $(FIRMWARE_OBJECTS) board/tools/stack.awk board/tools/library.awk \
                  board/$(BOARD)/board.mk $(if $(LIBGCC),$(OUT)/libgcc.ci)
	@$(CROSS)objdump -d $(FIRMWARE_OBJECTS) | awk -v root='$(STACK_ROOT)' -v out='$(OUT)/' \
	    -v indirect='$(SOURCE_FUNCTIONS) $(POINTERS_$(PROGRAM))' \
	    -v interrupt='$(INTERRUPTS_$(PROGRAM))' \
	    -v entry='$(INTERRUPT_FRAME)' -f board/tools/stack.awk \
	    $(FIRMWARE_OBJECTS:.o=.ci) $(if $(LIBGCC),$(OUT)/libgcc.ci) - >$@ || \
	    { cat $@ >&2; exit 1; }

# The call graph of the compiler's library, from its code.
$(OUT)/libgcc.ci: $(OUT)/flags board/tools/library.awk
	@$(CROSS)objdump -dtr "$$($(CC) $(CPU) -print-libgcc-file-name)" | \
	    awk -f board/tools/library.awk >$@

$(OUT)/%.o: %.c $(OUT)/flags
	$(call compile,$(COMMAND))

$(OUT)/tests/boards/lanes.o: FIRMWARE_FLAGS += -DBOARD_LANES=$(LANES)
$(LANES_PROBES): $(OUT)/tests/lanes/probe_%.o: tests/lanes/probe.c platform/lanes.txt \
                                               platform/lanes.sh $(OUT)/flags
	$(call probe,$*,$(PROBE_COMMAND))

# The instruction counter is a program of the host.
$(OUT)/libcount.so: board/tools/count.c
	@mkdir -p $(@D)
	@echo "cc $@"
	@$(HOST_CC) $(STRICT) -O2 -shared -fPIC -o $@ $<

$(OUT)/flags: FORCE
	$(call remember,$(COMMAND))

##measure make BOARD=name play SCENE=x.plt [STRUCTURE=grid] [FRAMES=A:B]: frames of a sequence
# What plays is another program, with the parts that it takes: this make calls itself for it.
# REBUILD_MOST=TRIANGLES beside REBUILD rebuilds subtrees.
play_options = $(if $(RECORDS),records=$(RECORDS)) $(if $(BESIDE),beside=$(BESIDE)) \
               $(if $(STRUCTURE),structure=$(STRUCTURE)) $(if $(REBUILD),rebuild=$(REBUILD)) \
               $(if $(REBUILD_MOST),rebuild_most=$(REBUILD_MOST)) \
               $(if $(ARENA),arena=$(ARENA)) $(PARAMETERS)
play_parts := $(if $(filter grid,$(STRUCTURE)),render thesis motion sequence grid frames,\
                $(if $(filter-out never,$(REBUILD)),,render vertices) thesis frames motion \
                $(if $(REBUILD_MOST),subtree) sequence)
ifeq ($(PROGRAM),played)
run play: firmware
	@$(MAKE) --no-print-directory -s BOARD=host PARTS= PROGRAM= CC='$(HOST_CC)' all
	@BUILD='$(BUILD)' FIRMWARE='$(OUT)' FRAMES='$(FRAMES)' MOST='$(MOST)' \
	    sh board/tools/play.sh $(BOARD) '$(SCENE)' '$(or $(SIZE),160x120)' $(play_options)
else
play:
	@$(MAKE) --no-print-directory PROGRAM=played \
	    PARTS='$(strip $(or $(PARTS),$(play_parts)))' play
endif

##try make BOARD=name PROGRAM=wired run [SCENE=x.plt] [FRAMES=25]: frames, as a host gets them
ifeq ($(PROGRAM),played)
profile:
	$(error what is profiled is the other program; leave out PROGRAM=$(PROGRAM))
else ifeq ($(PROGRAM),wired)
run: firmware
	@$(MAKE) --no-print-directory -s BOARD=host PARTS= CC='$(HOST_CC)' all
	@BUILD='$(BUILD)' MAKE='$(MAKE)' MAKEFLAGS= MFLAGS= BOARD='$(BOARD)' SCENE='$(SCENE)' \
	    FRAMES='$(FRAMES)' SIZE='$(SIZE)' PARTS='$(PARTS)' FIRMWARE='$(OUT)' \
	    sh board/tools/demo.sh

profile:
	$(error what is profiled is the other program; leave out PROGRAM=$(PROGRAM))
else
##try make BOARD=name run SCENE=x.plt [SIZE=320x240] [SOURCE=file] [PARAMETERS='k=v ...']: counts
# PANEL=PATH.ppm: what the board's display shows (lm3s6965evb: SIZE=128x64 at most).
run: firmware
	@$(MAKE) --no-print-directory -s BOARD=host PARTS= CC='$(HOST_CC)' all
	@BUILD='$(BUILD)' FIRMWARE='$(OUT)' PANEL='$(PANEL)' \
	    sh board/tools/run_like_host.sh $(BOARD) '$(SCENE)' \
	    '$(or $(SIZE),320x240)' $(PARAMETERS)

##measure make BOARD=name profile SCENE=x.plt: where the instructions go, by function
profile: firmware
	@$(MAKE) --no-print-directory -s BOARD=host PARTS= CC='$(HOST_CC)' all
	@BUILD='$(BUILD)' FIRMWARE='$(OUT)' PROFILE='$(OUT)/profile.txt' \
	    sh board/tools/run_like_host.sh $(BOARD) \
	    '$(SCENE)' '$(or $(SIZE),320x240)' $(PARAMETERS)
	@$(CROSS)nm -n $(OUT)/firmware.elf | awk -f board/tools/profile.awk - $(OUT)/profile.txt | \
	    sort -rn | head -n 25
endif

-include $(FIRMWARE_OBJECTS:.o=.d)
