# web - the engine and its viewer as WebAssembly, and the page around them
#
# Two programs, of scalar lanes and of SIMD128, by clang and wasm-ld alone: freestanding, without a
# C library. What they are given by the page is in board/web/page.c and host_tools/web. The page is
# one file, without anything outside it: build/web/planelet.html.
# SPDX-License-Identifier: MIT

WEB := $(BUILD)/web
CLANG ?= clang-16
WASM_LD ?= wasm-ld-16
WEB_STACK_BYTES := 16384
WEB_LANES := scalar wasm

# Ways of tracing that no frame of the page goes, and motion by a program: left out.
WEB_LEFT_OUT := $(wave_files) $(batch_files) $(task_files) $(grid_files) $(some_files) \
    $(subtree_files) engine/memory/prefetch.c
WEB_PARTS := $(foreach part,WAVE BATCH TASK GRID MOVE_SOME SUBTREES PREFETCH,-DPLT_WITH_$(part)=0)
WEB_SOURCES := $(filter-out $(WEB_LEFT_OUT),$(ENGINE)) platform/bare/memory.c \
    $(sort $(wildcard platform/wire/*.c board/web/*.c host_tools/web/*.c)) \
    $(addprefix host_tools/app/,aim.c coarse.c daylight.c fitting.c frame.c pose.c sight.c \
        steer.c view.c) \
    $(addprefix host_tools/picture/,fit.c jpeg.c jpeg_block.c jpeg_codes.c picture.c) \
    $(addprefix host_tools/hid/device/,display.c keys.c symbols.c) \
    $(addprefix host_tools/hid/drivers/,deck_keys.c driver_streamdeck.c driver_streamdeck_mini.c \
        driver_streamdeck_original.c key_bmp.c planelet_link.c)

web_flags_scalar :=
web_flags_wasm := $(call lanes_needs,wasm) -DPLT_LANES='"$(call lanes_header,wasm)"'
# Loops of memcpy itself must not become calls of it.
WEB_COMMAND = $(CLANG) --target=wasm32 $(STRICT) -O2 $(FREESTANDING) \
    -mbulk-memory -ffunction-sections -fdata-sections \
    -isystem host_tools/web/headers $(WEB_PARTS) -DWEB_STACK_BYTES=$(WEB_STACK_BYTES)u

# $(call web_lanes,NAME): the rules of one of the programs.
define web_lanes
$(WEB)/$(1)/%.o: %.c $(WEB)/$(1)/flags
	@mkdir -p $$(@D)
	@echo "$(CLANG) $$@"
	@$$(WEB_COMMAND) $$(web_flags_$(1)) $(DEPENDENCIES) -c -o $$@ $$< 2>$$(@:.o=.log) || \
	    { cat $$(@:.o=.log) >&2; exit 1; }
	@cat $$(@:.o=.log) >&2

$(WEB)/$(1)/platform/bare/memory.o: WEB_COMMAND += -fno-builtin

$(WEB)/$(1)/flags: FORCE
	$$(call remember,$$(WEB_COMMAND) $$(web_flags_$(1)))

$(WEB)/$(1).wasm: $(WEB_SOURCES:%.c=$(WEB)/$(1)/%.o)
	@echo "$(WASM_LD) $$@"
	@$(WASM_LD) --no-entry --gc-sections --strip-all --stack-first -z stack-size=$(WEB_STACK_BYTES) \
	    -o $$@ $$^
endef
$(foreach lanes,$(WEB_LANES),$(eval $(call web_lanes,$(lanes))))

##build web: the viewer as one page, build/web/planelet.html; needs clang and lld of LLVM 16
.PHONY: web demo-web
web: $(WEB)/planelet.html
	@wc -c $(WEB_LANES:%=$(WEB)/%.wasm) $(WEB)/marbles.plt $(WEB)/planelet.html | \
	    awk '$$2 != "total" { print $$1 " bytes of " $$2 }'

$(WEB)/planelet.html: $(WEB_LANES:%=$(WEB)/%.wasm) $(WEB)/marbles.plt \
        $(wildcard host_tools/web/page/*)
	@echo "sh $@"
	@sh host_tools/web/page/page.sh $(WEB) $(WEB_LANES) >$@

# README's picture, with a tree of compact blocks: a fifth of the bytes.
$(WEB)/marbles.plt: $(OUT)/planelet
	@mkdir -p $(@D)
	$(PLANELET) make marbles --frame 60 -o $(WEB)/tray.obj
	$(PLANELET) pack $(WEB)/tray.obj -o $@ --materials keep --smooth 40 --nodes compact \
	    --geometry lattice:14 2>$(WEB)/tray.txt # that boards and table are no closed bodies

##try demo-web: opens that page in a browser, or says where it is
demo-web: web
	@page="file://$$(pwd)/$(WEB)/planelet.html"; echo "the page is $$page"; \
	    command -v xdg-open >/dev/null && [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ] && \
	    xdg-open "$$page" || true

# ---- tests: programs beside the page's -----------------------------------------

web_link = @echo "$(WASM_LD) $@"; $(WASM_LD) --no-entry --gc-sections --strip-all -o $@ $^

$(WEB)/panel.wasm: $(patsubst %.c,$(WEB)/scalar/%.o,tests/web/panel.c engine/base/crc32.c \
        platform/bare/memory.c $(sort $(wildcard platform/wire/*.c)))
	$(web_link)

WEB_PROBES := $(WEB)/wasm/tests/lanes/probe_wasm.o $(WEB)/wasm/tests/lanes/probe_scalar.o

$(WEB)/lanes.wasm: $(WEB)/wasm/tests/web/lanes_run.o $(WEB)/wasm/tests/lanes/compare.o \
        $(WEB_PROBES) $(WEB)/wasm/platform/bare/memory.o
	$(web_link)

$(WEB_PROBES): $(WEB)/wasm/tests/lanes/probe_%.o: tests/lanes/probe.c platform/lanes.txt \
                                                 platform/lanes.sh $(WEB)/wasm/flags
	$(call probe,$*,$(WEB_COMMAND))

$(OUT)/tests/web/deck_reports: $(OUT)/tests/web/deck_reports.o $(OUT)/libhid.a $(TEST_OBJECTS) \
        $(TOOL_OBJECTS) $(ENGINE_OBJECTS)
	@echo "$(CC) $@"
	@$(CC) $(LDFLAGS) -o $@ $^ $(OUT)/libhid.a -lm -pthread

.PHONY: web-tests test-web web-compiler
web-compiler:
	@echo $(CLANG)

web-tests: web $(WEB)/panel.wasm $(WEB)/lanes.wasm $(OUT)/tests/web/deck_reports

##test test-web: the page in Chromium without a window, its frames and reports beside the host's
test-web: all
	@$(SCRIPT) $(WEB_TESTS)

-include $(shell find $(WEB) -name '*.d' 2>/dev/null)
