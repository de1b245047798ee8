# host - the program build/host/planelet and the test programs
# SPDX-License-Identifier: MIT

ifneq ($(PARTS),)
$(error PARTS is for firmware, as the tools need the whole engine: make BOARD=name PARTS=...)
endif

# Another CPU than this machine's, whose programs an emulator runs: tests/cpus/NAME.mk.
ARCH ?=
ifneq ($(ARCH),)
include tests/cpus/cpus.mk
endif

CC ?= cc
OPTIMISE ?= -O3 -g
HOST_FLAGS := -D_POSIX_C_SOURCE=200809L -D_FILE_OFFSET_BITS=64
# The largest arena of the host program; pages cost nothing until touched.
ARENA_BYTES := 1073741824
# gcc for s390x evaluates floats as doubles, to the letter of the standard, until it is told not to.
STRICT += $(shell echo __FLT_EVAL_METHOD__ | $(CC) -std=c11 -E -P - 2>/dev/null | \
    sed -n 's/^1$$/-fexcess-precision=fast/p')

ifeq ($(origin LANES),undefined)
LANES := $(shell sh platform/lanes.sh usual $(CC) $(CFLAGS))
endif
OUT := $(BUILD)/$(if $(ARCH),cpus/$(ARCH),host)$(if $(filter scalar,$(LANES)),-scalar)$(VARIANT)

PLATFORM := $(sort $(wildcard platform/*.c platform/wire/*.c))
# What both programs of host_tools and the tests share; cli/ is planelet's own part,
# hid/ planelet-hid's (hid.mk), web/ the page's (board/web/web.mk).
TOOLS := $(filter-out host_tools/cli/% host_tools/hid/% host_tools/web/%,\
    $(sort $(wildcard host_tools/*/*.c host_tools/baselines/*/*.c)))
CLI := $(sort $(wildcard host_tools/cli/*.c))
HOST := $(sort $(wildcard board/host/*.c))
# The portable firmware runs on the host too, on the fake board.
FAKE := $(sort $(wildcard board/*.c board/fake/*.c))
TESTS := $(sort $(wildcard tests/*/test_*.c))
REFERENCE := $(sort $(wildcard tests/reference/*.c))

objects = $(patsubst %.c,$(OUT)/%.o,$(1))
ENGINE_OBJECTS := $(call objects,$(ENGINE))
TOOL_OBJECTS := $(call objects,$(PLATFORM) $(TOOLS) $(HOST))
TEST_OBJECTS := $(call objects,$(REFERENCE) $(FAKE))
TEST_PROGRAMS := $(patsubst tests/%.c,$(OUT)/tests/%,$(TESTS))

ENGINE_COMMAND = $(CC) $(STRICT) $(OPTIMISE) $(FREESTANDING) $(lanes_flags) $(CFLAGS)
HOST_COMMAND = $(CC) $(STRICT) $(OPTIMISE) $(HOST_FLAGS) $(lanes_flags) \
               -DPLT_BOARD_ARENA_BYTES=$(ARENA_BYTES)u $(CFLAGS)

# What compiles the engine, for scripts that do it themselves (tests/cpus/hashes.sh).
.PHONY: engine-command
engine-command:
	@:$(info $(EMULATOR))$(info $(strip $(ENGINE_COMMAND) $(LDFLAGS)))

# Without the flags of LANES, but with those of the whole build.
PROBE_COMMAND = $(CC) $(STRICT) $(OPTIMISE) $(HOST_FLAGS) $(CFLAGS)

##build all: the host program build/host/planelet and the engine as build/host/libplanelet.a
all: $(OUT)/planelet $(OUT)/libplanelet.a

$(OUT)/libplanelet.a: $(ENGINE_OBJECTS)
	@rm -f $@
	@echo "$(AR) $@"
	@$(AR) rcs $@ $^

$(OUT)/planelet: $(call objects,$(CLI)) $(TOOL_OBJECTS) $(ENGINE_OBJECTS)
	@echo "$(CC) $@"
	@$(CC) $(LDFLAGS) -o $@ $^ -lm -pthread

$(OUT)/engine/%.o: engine/%.c $(OUT)/flags
	$(call compile,$(ENGINE_COMMAND))

$(OUT)/%.o: %.c $(OUT)/flags
	$(call compile,$(HOST_COMMAND) $(FOLDER_FLAGS) $(PROBE_FLAGS))

# Variants are tested at the same time: each writes to a folder of its own.
$(OUT)/tests/%.o: FOLDER_FLAGS := -DTEST_FOLDER='"$(OUT)/test-tmp/"'

# What tests/engine/test_lanes.c compares: every line of platform/lanes.txt.
LANES_PROBES := $(LANES_NAMES:%=$(OUT)/tests/lanes/probe_%.o)
$(OUT)/tests/engine/test_lanes: $(LANES_PROBES) $(OUT)/tests/lanes/compare.o
$(OUT)/tests/engine/test_lanes.o: PROBE_FLAGS = -DLANES_PROBES='$(patsubst %,X(%),$(LANES_NAMES))'
# Of these alone: a pattern for all would also make their lists of dependencies.
$(LANES_PROBES): $(OUT)/tests/lanes/probe_%.o: tests/lanes/probe.c platform/lanes.txt \
                                               platform/lanes.sh $(OUT)/flags
	$(call probe,$*,$(PROBE_COMMAND))

# One program measures beside another tracer, where that is installed.
EMBREE := $(wildcard /usr/include/embree3/rtcore.h)
$(OUT)/tests/measure/test_refit_peer: LIBRARIES = $(if $(EMBREE),-lembree3)

# The fake of hidapi is for those that have libhid.a, too (hid.mk).
$(OUT)/tests/%: $(OUT)/tests/%.o $(TEST_OBJECTS) $(TOOL_OBJECTS) $(ENGINE_OBJECTS)
	@echo "$(CC) $@"
	@$(CC) $(LDFLAGS) -o $@ $(filter-out %/fake_hidapi.o,$^) -lm -pthread $(LIBRARIES)

$(OUT)/flags: FORCE
	$(call remember,$(ENGINE_COMMAND) $(HOST_COMMAND) $(LANES_TABLE))

include host_tools/hid/hid.mk
include board/web/web.mk

.PHONY: test-programs programs-run engine-run
test-programs: $(TEST_PROGRAMS)

programs-run: test-programs
	@OUT='$(OUT)' EMULATOR='$(EMULATOR)' sh tests/run.sh $(TEST_PROGRAMS)

ENGINE_TESTS := $(filter $(OUT)/tests/engine/%,$(TEST_PROGRAMS))
engine-run: $(ENGINE_TESTS)
	@OUT='$(OUT)' EMULATOR='$(EMULATOR)' sh tests/run.sh $(ENGINE_TESTS)

-include $(shell find $(OUT) -name '*.d' 2>/dev/null)
