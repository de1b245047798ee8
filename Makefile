# Planelet: ray tracing in a fixed arena. `make help` lists the targets.
# SPDX-License-Identifier: MIT

BOARD ?= host
LANES ?= sse
CC ?= cc
BUILD := build
OUT := $(BUILD)/host

# One set of flags for every compiler and board: IEEE single precision in
# the order written, or the pictures of two machines differ.
STRICT := -std=c11 -ffp-contract=off -fno-math-errno -Wall -Wextra -Wshadow \
          -Wdouble-promotion -Wstrict-prototypes -Wmissing-prototypes -Wvla -I.
OPTIMISE ?= -O3 -g
DEPENDENCIES = -MMD -MP

ENGINE := $(sort $(wildcard engine/*.c engine/*/*.c))
PLATFORM := $(sort $(wildcard platform/*.c))
TOOLS := $(filter-out host_tools/cli/main.c,$(sort $(wildcard host_tools/*/*.c)))
TESTS := $(sort $(wildcard tests/test_*.c))
REFERENCE := $(sort $(wildcard tests/reference/*.c))

lanes_sse := -DPLT_LANES='"platform/lanes_sse.h"'
lanes_scalar :=
ENGINE_FLAGS = -ffreestanding $(lanes_$(LANES))
HOST_FLAGS = -D_POSIX_C_SOURCE=200809L

objects = $(patsubst %.c,$(OUT)/%.o,$(1))
ENGINE_OBJECTS := $(call objects,$(ENGINE))
TOOL_OBJECTS := $(call objects,$(PLATFORM) $(TOOLS) $(wildcard board/host/*.c))
TEST_PROGRAMS := $(patsubst tests/%.c,$(OUT)/tests/%,$(TESTS))

.PHONY: all help test clean
.DEFAULT_GOAL := all
.SECONDARY:

## all: the host program build/host/planelet
all: $(OUT)/planelet

$(OUT)/planelet: $(OUT)/host_tools/cli/main.o $(TOOL_OBJECTS) $(ENGINE_OBJECTS)
	$(CC) $(LDFLAGS) -o $@ $^ -lm

$(OUT)/engine/%.o: engine/%.c
	@mkdir -p $(@D)
	$(CC) $(STRICT) $(OPTIMISE) $(ENGINE_FLAGS) $(CFLAGS) $(DEPENDENCIES) -c -o $@ $<

$(OUT)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(STRICT) $(OPTIMISE) $(HOST_FLAGS) $(lanes_$(LANES)) $(CFLAGS) $(DEPENDENCIES) -c -o $@ $<

$(OUT)/tests/test_%: $(OUT)/tests/test_%.o $(call objects,$(REFERENCE)) $(TOOL_OBJECTS) $(ENGINE_OBJECTS)
	$(CC) $(LDFLAGS) -o $@ $^ -lm

## test: every test; ends in "N passed, N failed"
test: all $(TEST_PROGRAMS)
	@sh tests/run.sh $(TEST_PROGRAMS)

## clean: removes build/
clean:
	rm -rf $(BUILD)

## help: this list
help:
	@sed -n 's/^## //p' $(MAKEFILE_LIST)

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
