# cpus - the programs of the host for another CPU, which QEMU runs: make ARCH=name, with a file
# NAME.mk here
#
# TRIPLE of Debian's cross compiler; CPU_FLAGS; the EMULATOR; LANES; MORE_LANES, what else the CPU
# has; PACKAGES of Debian; IN_CI, yes or no. Linked statically: nothing of that CPU is installed.
# SPDX-License-Identifier: MIT

CPUS := $(patsubst tests/cpus/%.mk,%,$(filter-out tests/cpus/cpus.mk,\
    $(sort $(wildcard tests/cpus/*.mk))))
ifeq ($(filter $(ARCH),$(CPUS)),)
$(error there is no tests/cpus/$(ARCH).mk; CPUs: $(CPUS))
endif
COMPILER ?= gcc
include tests/cpus/$(ARCH).mk

CC := $(if $(filter gcc,$(COMPILER)),$(TRIPLE)-gcc,$(COMPILER) --target=$(TRIPLE)) $(CPU_FLAGS)
AR := $(TRIPLE)-ar
LDFLAGS += -static
OPTIMISE ?= -O1
