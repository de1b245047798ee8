# engine_files - what `PARTS` has of the engine, for scripts: its files, then its flags
# SPDX-License-Identifier: MIT
BOARD := none
include engine/engine.mk
$(info $(ENGINE))
$(info $(strip $(PARTS_FLAGS)))
.PHONY: none
none:
