# rv64_virt - QEMU's "virt" machine with an RV64GC
# SPDX-License-Identifier: MIT

CROSS := riscv64-unknown-elf-
CPU := -march=rv64imafdc -mabi=lp64d -mcmodel=medany -msmall-data-limit=0 \
       -isystem platform/headers -Wno-maybe-uninitialized
LANES := scalar
ARENA_BYTES := 262144
STACK_BYTES := 8192
SHARED := platform/bare platform/riscv board/semihosted board/riscv_cycles
LIBGCC := yes
BOARD_FLAGS := -DPLT_CLOCK_HERTZ=1000000000u
FIRMWARE_FLAGS := -DPLT_PACKET_SIDE_MAX=8
