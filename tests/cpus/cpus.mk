# cpus - the programs of the host for another CPU, which QEMU runs: make ARCH=name, with a file
# NAME.mk here
#
# TRIPLE of Debian's cross compiler; CPU_FLAGS; the EMULATOR; LANES, if not the usual ones; HASHED
# and HASHED_BY, lanes and compilers of hashes.sh; PACKAGES of Debian; IN_CI, yes or no. Programs
# are linked statically.
# SPDX-License-Identifier: MIT

CPUS := $(shell sh tests/cpus/archs.sh)
ifeq ($(filter $(ARCH),$(CPUS)),)
$(error there is no tests/cpus/$(ARCH).mk; CPUs: $(CPUS))
endif
COMPILER ?= gcc
include tests/cpus/$(ARCH).mk

CC := $(if $(filter gcc,$(COMPILER)),$(TRIPLE)-gcc,$(COMPILER) --target=$(TRIPLE)) $(CPU_FLAGS)
AR := $(TRIPLE)-ar
LDFLAGS += -static
OPTIMISE ?= -O1
