# hid - planelet-hid, the only program that links hidapi, once per backend
#
# The tests link the same objects with a fake of hidapi instead
# (tests/reference/fake_hidapi.c). SPDX-License-Identifier: MIT

HID_MAIN := host_tools/hid/main.c
HID_PORT := host_tools/hid/device/port.c
HID := $(filter-out $(HID_MAIN),$(sort $(wildcard host_tools/hid/*.c host_tools/hid/*/*.c)))
# Places are those of the fake's devices.
HID_TEST_OBJECTS := $(call objects,$(filter-out %/place_system.c,$(HID)) \
                      $(sort $(wildcard tests/hid/model*.c)))

# An archive: a test links only what it uses.
$(OUT)/libhid.a: $(HID_TEST_OBJECTS)
	@rm -f $@
	@$(AR) rcs $@ $^

$(OUT)/tests/host_tools/test_hid_%: $(OUT)/tests/host_tools/test_hid_%.o $(OUT)/libhid.a \
        $(TEST_OBJECTS) $(TOOL_OBJECTS) $(ENGINE_OBJECTS)
	@echo "$(CC) $@"
	@$(CC) $(LDFLAGS) -o $@ $^ $(OUT)/libhid.a -lm -pthread

$(OUT)/tests/measure/test_hid_%: $(OUT)/tests/measure/test_hid_%.o $(OUT)/libhid.a \
        $(TEST_OBJECTS) $(TOOL_OBJECTS) $(ENGINE_OBJECTS)
	@echo "$(CC) $@"
	@$(CC) $(LDFLAGS) -o $@ $^ $(OUT)/libhid.a -lm -pthread

# Only port.c includes hidapi.h. For the tests it is compiled with the fake one, for
# each program apart from that.
$(HID_PORT:%.c=$(OUT)/%.o): PROBE_FLAGS := -Itests/reference/fake_hidapi

HID_SHARED := $(call objects,$(HID_MAIN) $(filter-out $(HID_PORT),$(HID))) \
              $(TOOL_OBJECTS) $(ENGINE_OBJECTS)
HID_BACKENDS := hidraw libusb
PKG_CONFIG ?= pkg-config
HID_MISSING = there is no hidapi-$* for pkg-config; install libhidapi-dev and pkg-config \
(Debian, Ubuntu), hidapi-devel (Fedora) or hidapi (Arch), or run: make setup

.PHONY: planelet-hid

##build planelet-hid: pictures to USB displays; needs hidapi: build/host/planelet-hid (-libusb)
planelet-hid: $(OUT)/planelet-hid $(OUT)/planelet-hid-libusb

$(OUT)/planelet-hid: $(OUT)/planelet-hid-hidraw
	@ln -sf planelet-hid-hidraw $@

$(HID_BACKENDS:%=$(OUT)/planelet-hid-%): $(OUT)/planelet-hid-%: $(OUT)/hid-%/device/port.o \
        $(HID_SHARED)
	$(CC) $(LDFLAGS) -o $@ $^ $$($(PKG_CONFIG) --libs hidapi-$*) -lm -pthread

$(HID_BACKENDS:%=$(OUT)/hid-%/device/port.o): $(OUT)/hid-%/device/port.o: $(HID_PORT) $(OUT)/flags
	@$(PKG_CONFIG) --exists hidapi-$* || { echo 'planelet-hid: $(HID_MISSING)' >&2; exit 1; }
	$(call compile,$(HOST_COMMAND) $$($(PKG_CONFIG) --cflags hidapi-$*))

# ---- the bench: real hidapi on Debian's kernel in QEMU ------------------------

HID_WIRE := $(sort $(wildcard platform/wire/*.c))
HID_DEVICE := $(sort $(wildcard tests/hid/device*.c tests/hid/model*.c)) $(HID_WIRE) \
              $(sort $(wildcard host_tools/picture/*.c host_tools/base/*.c))

.PHONY: hid-bench
hid-bench: $(HID_BACKENDS:%=$(OUT)/planelet-hid-%) $(HID_BACKENDS:%=$(OUT)/hid-sanitize/%) \
           $(OUT)/hid-bench/device $(OUT)/hid-bench/make_pattern

# Static: the guest they run in has next to nothing.
$(OUT)/hid-bench/device: $(call objects,$(HID_DEVICE)) $(ENGINE_OBJECTS)
	@mkdir -p $(@D)
	$(CC) -static $(LDFLAGS) -o $@ $^ -lm -pthread

$(OUT)/hid-bench/make_pattern: $(call objects,tests/hid/make_pattern.c tests/hid/model_pattern.c)
	@mkdir -p $(@D)
	$(CC) -static $(LDFLAGS) -o $@ $^

# What handles bytes of devices and files is built once more with sanitizers.
HID_SANITIZED := $(filter-out $(HID_PORT),$(HID)) $(HID_MAIN) $(HID_WIRE)
HID_PLAIN := $(filter-out $(call objects,$(HID_WIRE)),$(TOOL_OBJECTS)) $(ENGINE_OBJECTS)

$(HID_BACKENDS:%=$(OUT)/hid-sanitize/%): $(OUT)/hid-sanitize/%: \
        $(OUT)/hid-sanitize/device/port-%.o $(HID_SANITIZED:%.c=$(OUT)/hid-sanitize/%.o) \
        $(HID_PLAIN)
	$(CC) $(SANITIZERS) $(LDFLAGS) -o $@ $^ $$($(PKG_CONFIG) --libs hidapi-$*) -lm -pthread

$(HID_BACKENDS:%=$(OUT)/hid-sanitize/device/port-%.o): $(OUT)/hid-sanitize/device/port-%.o: \
        $(HID_PORT) $(OUT)/flags
	$(call compile,$(HOST_COMMAND) $(SANITIZERS) $$($(PKG_CONFIG) --cflags hidapi-$*))

$(OUT)/hid-sanitize/%.o: %.c $(OUT)/flags
	$(call compile,$(HOST_COMMAND) $(SANITIZERS))

# ---- the display in a terminal --------------------------------------------------

$(OUT)/hid-emulated/main.o: $(HID_MAIN) $(OUT)/flags
	$(call compile,$(HOST_COMMAND) -Wno-missing-prototypes -Dmain=planelet_hid_main)

$(OUT)/planelet-hid-emulated: $(OUT)/hid-emulated/main.o \
        $(call objects,tests/hid/emulated_main.c tests/reference/fake_hidapi.c) $(OUT)/libhid.a \
        $(TOOL_OBJECTS) $(ENGINE_OBJECTS)
	$(CC) $(LDFLAGS) -o $@ $^ -lm -pthread

# The bench of scripts (tests/hid/script.h): the program itself, and seeds by a clock of their own.
$(OUT)/planelet-hid-scripted: $(OUT)/hid-emulated/main.o \
        $(call objects,tests/hid/scripted_main.c tests/hid/script.c tests/reference/fake_hidapi.c) \
        $(OUT)/libhid.a $(TOOL_OBJECTS) $(ENGINE_OBJECTS)
	$(CC) $(LDFLAGS) -o $@ $^ -lm -pthread

HID_CLOCK := $(call objects,host_tools/base/clock.c)
$(OUT)/tests/host_tools/test_hid_schedules: $(OUT)/tests/host_tools/test_hid_schedules.o \
        $(call objects,tests/hid/script.c) $(OUT)/libhid.a $(TEST_OBJECTS) \
        $(filter-out $(HID_CLOCK),$(TOOL_OBJECTS)) $(ENGINE_OBJECTS)
	@echo "$(CC) $@"
	@$(CC) $(LDFLAGS) -o $@ $^ $(OUT)/libhid.a -lm -pthread

##test soak-hid: SEEDS more schedules of faults for USB displays than make test has
SEEDS ?= 200000
.PHONY: soak-hid
soak-hid: $(OUT)/tests/host_tools/test_hid_schedules
	@$< 10000 $(SEEDS)

##try demo-hid: a scene on a USB display, or, without one, on an emulated panel in the terminal
.PHONY: demo-hid
demo-hid: all $(OUT)/planelet-hid-emulated
	@-$(MAKE) --no-print-directory planelet-hid
	@PLANELET='$(OUT)/planelet' HID='$(OUT)/planelet-hid' DEMO='$(DEMO)' sh tests/hid/demo.sh

##measure streamdeck-peers: reports of Stream Decks beside an npm package's and Debian's library's
.PHONY: streamdeck-peers
streamdeck-peers: all $(OUT)/tests/measure/test_hid_deck_reports
	@BUILD='$(BUILD)' PROGRAM='$(OUT)/tests/measure/test_hid_deck_reports' \
	    sh tests/measure/streamdeck_peers.sh

##measure hid-budgets: reports per frame of every display, and frames per second they leave room for
.PHONY: hid-budgets
hid-budgets: $(OUT)/tests/measure/test_hid_budgets
	@$<

##test test-hid: the USB bench alone; HID_GROUPS=cross,unplugged picks some of its groups
.PHONY: test-hid
test-hid: all
	@HID_GROUPS='$(HID_GROUPS)' $(SCRIPT) $(HID_TESTS)
