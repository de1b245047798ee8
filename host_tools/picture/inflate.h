/* inflate - unpacks what deflate has packed
 *
 * SPDX-License-Identifier: MIT */
#ifndef INFLATE_H
#define INFLATE_H

#include <stddef.h>
#include <stdint.h>

/* Unpacks a raw deflate stream of `bytes` bytes, any at all, into at most
 * `room`. Returns how many came out until the stream ended, was wrong, ran
 * out, or `to` was full. */
size_t inflate_bytes(const uint8_t *from, size_t bytes, uint8_t *to, size_t room);

#endif
