/* frames_in - tiles straight into the panel, and an answer for each frame
 *
 * Invariant: the panel is written only inside, and only with rows of a tile whose
 * bytes all came in order, without a gap, under right checksums.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/planelet_crc32.h"
#include "platform/wire/services.h"

/* Where pointers have 8 bytes, six of them and their alignment need 32 more. */
_Static_assert(sizeof(wire_frames_in) <= (sizeof(void *) > 4 ? 544 : 512), "the receiver's state");

int wire_frames_in_open(wire_frames_in *in, wire_peer *peer, const wire_panel *panel) {
    const wire_caps *own = &peer->own;
    const uint32_t columns = (own->width + 15u) / 16, rows = (own->height + 15u) / 16;
    if (!(own->features & WIRE_SHOWS) || columns * rows > WIRE_TILES_MAX ||
        (panel->pixels == NULL && (panel->row == NULL || own->features & WIRE_READS))) {
        return WIRE_ERR_SETUP;
    }
    memset(in, 0, sizeof *in);
    in->peer = peer;
    in->panel = *panel;
    in->columns = (uint16_t)columns;
    in->tiles = (uint16_t)(columns * rows);
    peer->frames_in = in;
    return WIRE_OK;
}

void wire_frames_in_begin(wire_frames_in *in) {
    in->is_any = in->in_frame = in->in_tile = in->answer = 0;
}

uint32_t wire_frames_shown(const wire_frames_in *in) {
    return in->shown;
}

unsigned wire_frames_mark(const wire_frames_in *in) {
    return in->mark;
}

/* ---- frames ------------------------------------------------------------------------------ */

enum { ANSWER_NONE, ANSWER_GOOD, ANSWER_BAD };

static void answer(wire_frames_in *in, unsigned what) {
    const int goes_on = in->answer == ANSWER_GOOD && what == ANSWER_GOOD && in->in_frame;
    in->answer_more =
        (uint8_t)(goes_on ? in->answer_more + 1 : 0); /* also good, not yet reported */
    in->in_frame = 0;
    in->answer = (uint8_t)what;
    in->answer_number = in->number;
    in->answer_part = 0;
    wire_queue_control(in->peer, what == ANSWER_GOOD ? WIRE_FRAME_GOOD : WIRE_FRAME_BAD);
}

/* Makes the frame that a tile or a FRAME_END belongs to the current one. One that is
 * still open had no FRAME_END, so something of it is missing. */
static void enter_frame(wire_frames_in *in, unsigned number) {
    if (in->in_frame && in->number == number) {
        return;
    }
    if (in->in_frame) {
        in->peer->stats.frames_bad++;
        answer(in, ANSWER_BAD);
    }
    in->in_frame = in->is_any = 1;
    in->number = (uint8_t)number;
    in->crc = 0;
    in->came = 0;
    in->is_torn = 0;
    memset(in->got, 0, sizeof in->got);
}

uint32_t wire_frames_in_write(wire_frames_in *in, unsigned type, uint8_t *body) {
    body[0] = in->answer_number;
    if (type == WIRE_FRAME_GOOD || in->answer != ANSWER_BAD) {
        const int is_due = type == WIRE_FRAME_GOOD && in->answer == ANSWER_GOOD;
        body[1] = in->answer_more;
        in->answer = is_due ? ANSWER_NONE : in->answer;
        return is_due ? 2 : 0;
    }
    const unsigned part = in->answer_part++;
    body[1] = (uint8_t)part;
    memset(body + 2, 0, 32);
    for (unsigned i = 0; i < 32 && 32 * part + i < sizeof in->got; i++) {
        body[2 + i] = in->got[32 * part + i];
    }
    if (256u * in->answer_part < in->tiles) {
        wire_queue_control(in->peer, WIRE_FRAME_BAD);
    } else {
        in->answer = ANSWER_NONE;
    }
    return 34;
}

/* The same FRAME_END again: its answer was lost. */
static int is_again(const wire_frames_in *in, unsigned number) {
    return in->is_any && !in->in_frame && in->number == number;
}

void wire_frames_in_end(wire_frames_in *in, const uint8_t *body) {
    const unsigned number = body[0];
    if (number >= WIRE_NUMBERS) {
        return; /* no sender uses that number: nobody waits for an answer */
    }
    if (!is_again(in, number)) {
        enter_frame(in, number);
        in->is_good =
            !in->is_torn && in->came == wire_get16(body + 2) && in->crc == wire_get32(body + 4);
        in->shown += in->is_good;
        in->mark = in->is_good ? body[8] : in->mark;
        in->peer->stats.frames_in += in->is_good;
        in->peer->stats.frames_bad += !in->is_good;
    }
    answer(in, in->is_good ? ANSWER_GOOD : ANSWER_BAD);
    wire_queue_control(in->peer, WIRE_ACK);
}

/* ---- tiles ---------------------------------------------------------------------------------- */

static wire_tile_shape shape_at(const wire_frames_in *in, unsigned x, unsigned y) {
    const wire_caps *own = &in->peer->own;
    const wire_tile_shape shape = {own->format,
                                   (uint8_t)(own->width - x < 16 ? own->width - x : 16),
                                   (uint8_t)(own->height - y < 16 ? own->height - y : 16)};
    return shape;
}

static uint8_t *panel_at(const wire_frames_in *in, unsigned x, unsigned y) {
    return in->panel.pixels == NULL ? NULL
                                    : in->panel.pixels + (size_t)y * in->panel.stride +
                                          wire_row_bytes(in->peer->own.format, x);
}

void wire_frames_in_tile(wire_frames_in *in, unsigned type, unsigned low, uint32_t bytes) {
    const unsigned index = (type & 3) << 8 | low, frame = type >> 2 & 7;
    in->in_tile = 0;
    if (frame >= WIRE_NUMBERS) {
        return;
    }
    enter_frame(in, frame);
    in->is_torn = 1; /* until it is complete */
    if (index >= in->tiles) {
        return;
    }
    const unsigned x = index % in->columns * 16, y = index / in->columns * 16;
    uint8_t number[2];
    wire_put16(number, index);
    in->tile = (uint16_t)index;
    in->crc = plt_crc32(in->crc, number, 2);
    in->got[index / 8] &= (uint8_t) ~(1u << (index & 7));
    in->in_tile = wire_tile_begin(&in->reader, shape_at(in, x, y), type >> 5 & 3, bytes,
                                  panel_at(in, x, y), in->panel.stride) == 0;
}

static void put_row(wire_frames_in *in) {
    uint8_t row[WIRE_ROW_BYTES_MAX];
    const wire_tile_reader *r = &in->reader;
    const unsigned x = in->tile % in->columns * 16, y = in->tile / in->columns * 16 + r->y - 1u;
    const uint32_t bytes = wire_row_bytes(r->shape.format, r->shape.width);
    wire_tile_row(r, row);
    in->crc = plt_crc32(in->crc, row, bytes);
    if (in->panel.pixels != NULL) {
        memcpy(panel_at(in, x, y), row, bytes);
    } else {
        in->panel.row(in->panel.context, x, y, r->shape.width, row);
    }
}

void wire_frames_in_bytes(wire_frames_in *in, const uint8_t *bytes, uint32_t count) {
    const uint8_t *at = bytes, *const end = bytes + count;
    while (in->in_tile) {
        switch (wire_tile_read(&in->reader, &at, end)) {
        case WIRE_TILE_ROW:
            put_row(in);
            break;
        case WIRE_TILE_DONE:
            in->in_tile = 0;
            in->is_torn = 0;
            in->came++;
            in->peer->stats.tiles_in++;
            in->got[in->tile / 8] |= (uint8_t)(1u << (in->tile & 7));
            break;
        case WIRE_TILE_WRONG:
            in->in_tile = 0;
            break;
        default:
            return;
        }
    }
}

/* Something was missed: the tile that was coming keeps the rows that came, and the
 * frame will be answered with what is missing. */
void wire_frames_in_cut(wire_frames_in *in) {
    in->is_torn = (uint8_t)(in->is_torn || in->in_tile);
    in->in_tile = 0;
}
