/* panel - a display of the board's own, which shows what is rendered
 *
 * Of boards that have one, beside board.h; board.mk says so by -DPLT_BOARD_PANEL=1. Called in the
 * order board_panel_begin { board_panel_tile }, a frame after the other.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_PANEL_H
#define PLT_BOARD_PANEL_H

#include <stdint.h>

#include "engine/planelet.h"

#ifndef PLT_BOARD_PANEL
#define PLT_BOARD_PANEL 0
#endif

/* In pixels; may be called before all others. */
void board_panel_size(uint16_t *width, uint16_t *height);

/* A frame of this size comes, which is not larger than the panel; what was shown goes. */
void board_panel_begin(uint16_t width, uint16_t height);

/* A tile of it, shown when the call returns. */
void board_panel_tile(const plt_tile *tile);

#endif
