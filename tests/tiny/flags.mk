# flags - every limit of the engine as small as engine/planelet_config.h allows
#
# For `make tiny`: bugs that only show when a limit is reached get a chance.
# Tests choose scenes that fit, or expect PLT_ERR_LIMIT.
# SPDX-License-Identifier: MIT
TINY_FLAGS := -DPLT_PACKET_SIDE_MAX=2 -DPLT_TILE_SIDE=2 -DPLT_DEPTH_MAX=8 \
              -DPLT_GLOBAL_STACK_MAX=16 -DPLT_SAH_BINS=4 -DPLT_TRANSFER_BYTES=64 \
              -DPLT_BLOCK_CACHE_SLOTS=1 -DPLT_CRC32_SLICES=0 -DPLT_GRID_TRIANGLE_BYTES=8
