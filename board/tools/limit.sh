# limit.sh - no emulated run is without end: sourced by all that start one
#
# QEMU_SECONDS (600) is the limit. SPDX-License-Identifier: MIT

# limited COMMAND...: its exit status, or 124 after so many seconds.
limited() {
    timeout -k 5 "${QEMU_SECONDS:-600}" "$@"
}

# limit_self: for a shell that becomes the emulator and has to keep its process id; so many seconds
# of CPU time, which a firmware that waits for its wire uses up, too.
limit_self() {
    ulimit -t "${QEMU_SECONDS:-600}"
}
