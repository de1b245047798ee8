/* services - what a peer calls of its services
 *
 * Not for users. A service has, as it needs them: begin (a session is up), poll,
 * fill (put data messages into the queue), receive (a control message came),
 * write (the body of a control message; returns its bytes), and head / bytes /
 * end / cut for the data messages it receives. None of them calls the peer back.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_SERVICES_H
#define PLT_WIRE_SERVICES_H

#include "platform/wire/base.h"

void wire_frames_out_begin(wire_frames_out *out);
void wire_frames_out_poll(wire_frames_out *out);
/* 1: what is queued should leave even if it does not fill a report. */
int wire_frames_out_fill(wire_frames_out *out);
void wire_frames_out_left(wire_frames_out *out, uint32_t number);
void wire_frames_out_receive(wire_frames_out *out, unsigned type, const uint8_t *body);

void wire_frames_in_begin(wire_frames_in *in);
uint32_t wire_frames_in_write(wire_frames_in *in, unsigned type, uint8_t *body);
void wire_frames_in_tile(wire_frames_in *in, unsigned type, unsigned low, uint32_t bytes);
void wire_frames_in_bytes(wire_frames_in *in, const uint8_t *bytes, uint32_t count);
void wire_frames_in_cut(wire_frames_in *in);
void wire_frames_in_end(wire_frames_in *in, const uint8_t *body);

void wire_scene_out_begin(wire_scene_out *out);
void wire_scene_out_poll(wire_scene_out *out);
int wire_scene_out_fill(wire_scene_out *out);
uint32_t wire_scene_out_write(wire_scene_out *out, uint8_t *body);
void wire_scene_out_receive(wire_scene_out *out, const uint8_t *body);

void wire_scene_in_poll(wire_scene_in *in);
uint32_t wire_scene_in_write(wire_scene_in *in, uint8_t *body);
void wire_scene_in_receive(wire_scene_in *in, const uint8_t *body);
void wire_scene_in_head(wire_scene_in *in, uint32_t offset);
void wire_scene_in_bytes(wire_scene_in *in, const uint8_t *bytes, uint32_t count);

void wire_view_out_begin(wire_view_out *out);
void wire_view_out_poll(wire_view_out *out);
uint32_t wire_view_out_write(wire_view_out *out, uint8_t *body);
void wire_view_out_receive(wire_view_out *out, const uint8_t *body, uint32_t bytes);

uint32_t wire_view_in_write(const wire_view_in *in, uint8_t *body);
void wire_view_in_receive(wire_view_in *in, const uint8_t *body, uint32_t bytes);

void wire_keys_out_begin(wire_keys_out *out);
void wire_keys_out_poll(wire_keys_out *out);
uint32_t wire_keys_out_write(const wire_keys_out *out, uint8_t *body);
void wire_keys_out_receive(wire_keys_out *out, const uint8_t *body);

void wire_keys_in_begin(wire_keys_in *in);
uint32_t wire_keys_in_write(const wire_keys_in *in, uint8_t *body);
void wire_keys_in_receive(wire_keys_in *in, const uint8_t *body, uint32_t bytes);

int wire_blocks_out_fill(wire_blocks_out *out);
uint32_t wire_blocks_out_write(wire_blocks_out *out, uint8_t *body);
void wire_blocks_out_receive(wire_blocks_out *out, const uint8_t *body, uint32_t body_bytes);

void wire_blocks_in_begin(wire_blocks_in *in);
void wire_blocks_in_poll(wire_blocks_in *in);
uint32_t wire_blocks_in_write(wire_blocks_in *in, uint8_t *body);
void wire_blocks_in_receive(wire_blocks_in *in, const uint8_t *body);
void wire_blocks_in_head(wire_blocks_in *in, unsigned tag, uint32_t offset);
void wire_blocks_in_bytes(wire_blocks_in *in, const uint8_t *bytes, uint32_t count);

#endif
