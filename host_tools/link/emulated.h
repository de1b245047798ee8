/* emulated - a device that renders, as a process of this computer
 *
 * SPDX-License-Identifier: MIT */
#ifndef EMULATED_H
#define EMULATED_H
#include <stddef.h>

#include "host_tools/link/link.h"

/* Runs the engine as a device with this much memory over the transport, until
 * the link is down; -1 when it cannot be set up. */
int emulated_device(const transport *t, unsigned report_bytes, size_t memory_bytes);

/* The same in a process of its own, as the peer of `l`. */
int emulated_start(stream_link *l, unsigned report_bytes, size_t memory_bytes, fail *f);

#endif
