/* frames_out - which tiles go out, and what is known of the other end's panel
 *
 * Of a tile the sender knows the hash of what it last sent (0: nothing it
 * could rely on) and which frame carried it, until that frame is answered.
 * Invariant: hash != 0 and way 0: the panel shows those pixels, whole. With
 * way != 0 it shows them or what it showed before, row by row.
 *
 * A hash that is equal by chance, 2^-32 for each tile that changes, leaves it
 * stale until the refresh, one tile a frame, comes round.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/crc.h"
#include "platform/wire/parts.h"

_Static_assert(WIRE_TILES_MAX % 32 == 0 && WIRE_TILES_MAX <= 1024, "ten bits on the wire");
_Static_assert(sizeof(wire_frames_out) <= 4096, "the sender's state");

/* Numbers go round in NUMBERS, a multiple of SLOTS: frames on the way have
 * ways of their own. */
enum { SLOTS = 3, NUMBERS = 6, ANSWER_MS = 60 };

void wire_frames_out_open(wire_frames_out *out, wire_end *end) {
    memset(out, 0, sizeof *out);
    out->end = end;
    end->frames_out = out;
    end->queue = &out->queue;
    if (end->scene_out != NULL) {
        end->scene_out->queue = end->queue;
    }
    if (end->blocks_out != NULL) {
        end->blocks_out->queue = end->queue;
    }
    if (wire_is_up(end)) {
        wire_frames_out_begin(out);
    }
}

void wire_frames_reference(wire_frames_out *out, uint8_t *reference, uint32_t bytes) {
    out->reference = reference;
    out->reference_bytes = bytes;
    wire_frames_forget(out);
}

void wire_frames_near(wire_frames_out *out, unsigned near) {
    out->near = (uint8_t)(near < WIRE_NEAR_MOST ? near : WIRE_NEAR_MOST);
}

/* ---- what is known of a tile ---------------------------------------------------------- */

static unsigned way_of(const wire_frames_out *out, unsigned tile) {
    return out->way[tile / 4] >> (2 * (tile & 3)) & 3;
}

static void set_way(wire_frames_out *out, unsigned tile, unsigned way) {
    uint8_t *at = &out->way[tile / 4];
    *at = (uint8_t)((*at & ~(3u << (2 * (tile & 3)))) | way << (2 * (tile & 3)));
}

static int is_coarse(const wire_frames_out *out, unsigned tile) {
    return out->coarse[tile / 8] >> (tile & 7) & 1;
}

static void set_coarse(wire_frames_out *out, unsigned tile, unsigned is) {
    uint8_t *at = &out->coarse[tile / 8];
    *at = (uint8_t)((*at & ~(1u << (tile & 7))) | is << (tile & 7));
}

/* The way of the frame `back` frames before the one that goes out. */
static unsigned way_back(const wire_frames_out *out, unsigned back) {
    return (out->number + NUMBERS - back) % SLOTS + 1;
}

void wire_frames_forget(wire_frames_out *out) {
    memset(out->hash, 0, sizeof out->hash);
    memset(out->way, 0, sizeof out->way);
    memset(out->coarse, 0, sizeof out->coarse);
}

void wire_frames_out_begin(wire_frames_out *out) {
    const wire_caps *peer = &out->end->peer;
    const uint32_t columns = (peer->width + 15u) / 16, rows = (peer->height + 15u) / 16;
    const uint32_t tiles = peer->features & WIRE_SHOWS ? columns * rows : 0;
    if (tiles > WIRE_TILES_MAX) {
        wire_tell(out->end, WIRE_E_PANEL, WIRE_TILES_MAX);
    }
    const int is_same = out->width == peer->width && out->height == peer->height;
    out->rgb = is_same ? out->rgb : NULL; /* it may be too small now */
    out->width = peer->width;
    out->height = peer->height;
    out->format = peer->format;
    out->columns = (uint16_t)columns;
    out->tiles = (uint16_t)(tiles <= WIRE_TILES_MAX ? tiles : 0);
    out->next = out->sent = out->refresh = 0;
    out->scanned = out->rgb != NULL ? 0 : out->tiles;
    out->number = out->unanswered = 0;
    out->in_frame = out->is_cut = out->is_exact_pass = out->is_waiting = 0;
    out->is_fresh = out->rgb != NULL;
    wire_frames_forget(out);
}

/* ---- answers ------------------------------------------------------------------------------- */

/* Tiles from .. to - 1 of the frame with this way: on the panel when their
 * bit is set in `got`, else to be sent again. */
static void settle(wire_frames_out *out, unsigned way, unsigned from, unsigned to,
                   const uint8_t *got) {
    for (unsigned t = from; t < to && t < out->tiles; t++) {
        if (way_of(out, t) == way) {
            const int is_there = got != NULL && got[(t - from) / 8] >> (t & 7) & 1;
            set_way(out, t, 0);
            out->hash[t] = is_there ? out->hash[t] : 0;
        }
    }
}

static void settle_good(wire_frames_out *out, unsigned way) {
    for (unsigned t = 0; t < out->tiles; t++) {
        if (way_of(out, t) == way) {
            set_way(out, t, 0);
        }
    }
}

static void drop_oldest(wire_frames_out *out) {
    settle(out, way_back(out, out->unanswered), 0, out->tiles, NULL);
    out->unanswered--;
    out->end->stats.frames_bad++;
}

/* Frame `number` came whole, and so did the `more` before it. */
static void take_good(wire_frames_out *out, unsigned number, unsigned more) {
    unsigned back = (out->number + NUMBERS - number) % NUMBERS + (more < SLOTS ? more : 0);
    back = back < out->unanswered ? back : out->unanswered;
    while (out->unanswered > back) {
        drop_oldest(out);
    }
    const unsigned after = (out->number + NUMBERS - number) % NUMBERS - 1;
    while (out->unanswered > after) {
        settle_good(out, way_back(out, out->unanswered));
        out->unanswered--;
        out->end->stats.frames_out++;
    }
}

/* Which tiles of 256 came; the last part settles the frame. */
static void take_bad(wire_frames_out *out, const uint8_t *body) {
    const unsigned from = 256u * (body[1] & 3u);
    while (out->unanswered > (out->number + NUMBERS - body[0]) % NUMBERS) {
        drop_oldest(out);
    }
    settle(out, way_back(out, out->unanswered), from, from + 256, body + 2);
    if (from + 256 >= out->tiles) {
        drop_oldest(out);
    }
}

void wire_frames_out_take(wire_frames_out *out, unsigned type, const uint8_t *body) {
    const unsigned back = (out->number + NUMBERS - body[0]) % NUMBERS;

    if (body[0] >= NUMBERS || back < 1 || back > out->unanswered) {
        return; /* not of ours */
    }
    if (type == WIRE_FRAME_GOOD) {
        take_good(out, body[0], body[1]);
    } else {
        take_bad(out, body);
    }
    out->is_waiting = 0;
}

void wire_frames_out_left(wire_frames_out *out, uint32_t number) {
    out->end_number = number;
}

/* 0: no room for the message. */
static int put_end(wire_frames_out *out, unsigned number) {
    if (wire_queue_room(&out->queue) < WIRE_END_BYTES) {
        return 0;
    }
    uint8_t *to = out->queue.bytes + out->queue.used;
    to += wire_head_put(to, WIRE_FRAME_END, WIRE_END_BODY);
    to[0] = (uint8_t)number;
    to[1] = out->is_whole;
    wire_put16(to + 2, out->sent);
    wire_put32(to + 4, out->crc);
    to[8] = out->mark;
    out->queue.used = (uint16_t)(out->queue.used + WIRE_END_BYTES);
    return 1;
}

/* No answer although its report was acknowledged: the end was lost, or the
 * answer. Only after some answer may numbers go round. */
void wire_frames_out_poll(wire_frames_out *out) {
    const wire_end *end = out->end;
    if (out->unanswered == 0 || out->in_frame || (int32_t)(end->out_acked - out->end_number) <= 0 ||
        wire_queue_bytes(&out->queue) > 0) {
        out->is_waiting = 0;
    } else if (!out->is_waiting) {
        out->is_waiting = 1;
        out->waiting_ms = end->now_ms;
    } else if (end->now_ms - out->waiting_ms >= ANSWER_MS) {
        out->is_waiting = 0;
        put_end(out, (out->number + NUMBERS - 1u) % NUMBERS);
    }
}

/* ---- one tile ----------------------------------------------------------------------------------
 */

typedef struct piece {
    unsigned index, x, y;
    wire_tile_shape shape;
    uint32_t row_bytes;
} piece;

static piece piece_of(const wire_frames_out *out, unsigned index) {
    piece p = {index, index % out->columns * 16, index / out->columns * 16, {0, 0, 0}, 0};
    p.shape.format = out->format;
    p.shape.width = (uint8_t)(out->width - p.x < 16 ? out->width - p.x : 16);
    p.shape.height = (uint8_t)(out->height - p.y < 16 ? out->height - p.y : 16);
    p.row_bytes = wire_row_bytes(out->format, p.shape.width);
    return p;
}

/* FNV-1a over words would do; the CRC is there already and finds every burst. */
static uint32_t hash_of(const wire_frames_out *out, const piece *p) {
    const uint32_t hash = wire_crc(0, out->pixels, p->row_bytes * p->shape.height);
    return hash == 0 ? 1 : hash;
}

static int has_reference(const wire_frames_out *out) {
    return out->reference != NULL && out->end->peer.features & WIRE_READS &&
           out->reference_bytes >= wire_row_bytes(out->format, out->width) * out->height;
}

/* Copies between `pixels`-like memory without gaps and the reference. */
static void move_reference(wire_frames_out *out, const piece *p, uint8_t *tile, int into) {
    const uint32_t stride = wire_row_bytes(out->format, out->width);
    for (unsigned y = 0; y < p->shape.height; y++) {
        uint8_t *at = out->reference + (p->y + y) * stride + wire_row_bytes(out->format, p->x);
        memcpy(into ? at : tile, into ? tile : at, p->row_bytes);
        tile += p->row_bytes;
    }
}

/* Whether what the panel shows is within the bound of `pixels`. */
static int is_near_enough(const wire_frames_out *out, const piece *p, const uint8_t *old,
                          unsigned near) {
    for (unsigned y = 0; y < p->shape.height; y++) {
        for (unsigned x = 0; x < p->shape.width; x++) {
            const wire_sample a = wire_sample_get(out->format, old + y * p->row_bytes, x);
            const wire_sample b = wire_sample_get(out->format, out->pixels + y * p->row_bytes, x);
            for (unsigned i = 0; i < 3; i++) {
                if (a.v[i] > b.v[i] + near || b.v[i] > a.v[i] + near) {
                    return 0;
                }
            }
        }
    }
    return 1;
}

/* Appends the tile in `pixels`; 0: no room. `old` may be NULL. */
static int append(wire_frames_out *out, const piece *p, const uint8_t *old, unsigned near) {
    const uint32_t room = wire_queue_room(&out->queue);
    uint8_t *to = out->queue.bytes + out->queue.used;
    const uint32_t raw = p->row_bytes * p->shape.height;
    unsigned coder;
    if (room < raw + 4 + WIRE_END_BYTES) {
        return 0;
    }
    const uint32_t bytes = wire_tile_encode(p->shape, out->pixels, old, near, to + 4, raw, &coder);
    const unsigned type = WIRE_TILE | coder << 5 | (unsigned)out->number << 2 | p->index >> 8;
    uint32_t head = 0;
    to[head++] = (uint8_t)type;
    to[head] = (uint8_t)p->index;
    head += wire_head_put(to + head, p->index & 255, bytes);
    memmove(to + head, to + 4, bytes);
    out->queue.used = (uint16_t)(out->queue.used + head + bytes);
    return 1;
}

/* The checksum of a frame: of each tile's number and pixels, in order. */
static void add_to_checksum(wire_frames_out *out, const piece *p) {
    uint8_t index[2];
    wire_put16(index, p->index);
    out->crc = wire_crc(out->crc, index, 2);
    out->crc = wire_crc(out->crc, out->pixels, p->row_bytes * p->shape.height);
}

/* The tile in `pixels`, when it has to go: 1 done with it, 0 no room. */
static int offer(wire_frames_out *out, const piece *p) {
    uint8_t old[WIRE_TILE_BYTES_MAX];
    const uint32_t hash = hash_of(out, p);
    const int is_known = out->hash[p->index] == hash;
    const int refines = out->is_exact_pass && is_coarse(out, p->index);
    /* What is known goes out again only to be exact. */
    const int is_exact = is_known || out->is_exact_pass || out->format >= WIRE_GREY4;
    const unsigned near = is_exact ? 0 : out->near;
    if (is_known && !refines && p->index != out->refresh) {
        return 1;
    }
    const int delta = has_reference(out) && out->hash[p->index] != 0 && way_of(out, p->index) == 0;
    if (delta) {
        move_reference(out, p, old, 0);
        if (near > 0 && is_near_enough(out, p, old, near)) {
            set_coarse(out, p->index, 1);
            out->hash[p->index] = hash;
            return 1;
        }
    }
    const int refreshes = is_known && !refines;
    if (!append(out, p, delta && !refreshes ? old : NULL, near)) {
        return 0;
    }
    add_to_checksum(out, p);
    if (has_reference(out)) {
        move_reference(out, p, out->pixels, 1);
    }
    set_way(out, p->index, way_back(out, 0));
    set_coarse(out, p->index, near > 0);
    out->hash[p->index] = hash;
    out->sent++;
    out->end->stats.tiles_out++;
    return 1;
}

static void convert(wire_frames_out *out, const piece *p, const uint8_t *rgb, uint32_t stride) {
    for (unsigned y = 0; y < p->shape.height; y++) {
        wire_row_from_rgb(out->pixels + y * p->row_bytes, out->format, rgb + y * stride,
                          p->shape.width, p->x, p->y + y);
    }
}

/* ---- frames
 * ------------------------------------------------------------------------------------------ */

static void start_frame(wire_frames_out *out) {
    out->in_frame = 1;
    out->is_cut = 0;
    out->sent = 0;
    out->crc = 0;
    out->refresh = (uint16_t)(out->refresh + 1 < out->tiles ? out->refresh + 1 : 0);
}

/* 0: no room for the message. */
static int end_frame(wire_frames_out *out, int is_whole) {
    out->is_whole = (uint8_t)is_whole;
    if (!put_end(out, out->number)) {
        return 0;
    }
    out->in_frame = 0;
    out->number = (uint8_t)((out->number + 1) % NUMBERS);
    out->unanswered++;
    out->is_waiting = 0;
    return 1;
}

/* Whether some tile of the caller's frame is not on the panel, or not exact. */
static int is_missing(const wire_frames_out *out, int *coarse) {
    int missing = 0;
    *coarse = 0;
    for (unsigned t = 0; t < out->tiles; t++) {
        missing |= out->hash[t] == 0;
        *coarse |= is_coarse(out, t) && way_of(out, t) == 0;
    }
    return missing;
}

/* Whether a pass over the frame should begin. */
static int wants_pass(wire_frames_out *out) {
    int coarse;
    if (out->is_fresh) {
        out->is_exact_pass = out->near == 0;
        out->is_fresh = 0;
        return 1;
    }
    const int missing = is_missing(out, &coarse);
    out->is_exact_pass = !missing || out->near == 0;
    return missing || (coarse && out->unanswered == 0);
}

/* Tiles of the caller's frame, until the queue is full. */
static void scan(wire_frames_out *out) {
    while (out->scanned < out->tiles && !out->is_cut) {
        const piece p = piece_of(out, out->next);
        convert(out, &p, out->rgb + p.y * (size_t)out->stride + 3 * (size_t)p.x, out->stride);
        if (!offer(out, &p)) {
            return;
        }
        out->next = (uint16_t)(out->next + 1 < out->tiles ? out->next + 1 : 0);
        out->scanned++;
    }
    if (end_frame(out, out->scanned == out->tiles)) {
        out->scanned = out->tiles;
    }
}

int wire_frames_out_fill(wire_frames_out *out) {
    if (out->rgb == NULL) {
        return !out->in_frame || out->is_cut; /* tile by tile: when full or ended */
    }
    /* A delta needs the answer to what was sent before: worth a round trip. */
    const unsigned most = has_reference(out) ? 1 : SLOTS;
    if (!out->in_frame && out->unanswered < most && wants_pass(out)) {
        out->scanned = 0;
        start_frame(out);
    }
    if (out->in_frame) {
        scan(out);
    }
    return 1;
}

static int is_ready(const wire_frames_out *out) {
    return wire_is_up(out->end) && out->tiles > 0;
}

int wire_frames_show(wire_frames_out *out, const uint8_t *rgb, uint32_t stride) {
    if (rgb == NULL) {
        out->is_cut = out->in_frame;
        out->is_fresh = 0;
        if (out->in_frame && out->rgb != NULL && !end_frame(out, 0)) {
            wire_frames_forget(out); /* its end never comes: nothing is known of it */
            out->in_frame = 0;
        }
        out->rgb = NULL;
        return WIRE_OK;
    }
    if (!is_ready(out)) {
        return WIRE_ERR_DOWN;
    }
    out->is_cut = out->in_frame;
    out->rgb = rgb;
    out->stride = stride;
    out->is_fresh = 1;
    return WIRE_OK;
}

int wire_frame_begin(wire_frames_out *out, unsigned mark) {
    if (!is_ready(out)) {
        return WIRE_ERR_DOWN;
    }
    if (out->in_frame || out->unanswered > 0) {
        return WIRE_BUSY;
    }
    out->rgb = NULL;
    out->is_exact_pass = 1;
    out->mark = (uint8_t)mark;
    start_frame(out);
    return WIRE_OK;
}

int wire_frame_tile(wire_frames_out *out, unsigned x, unsigned y, const uint8_t *rgb,
                    uint32_t stride) {
    if (!is_ready(out) || !out->in_frame) {
        return WIRE_ERR_DOWN;
    }
    if (x >= out->width || y >= out->height || x % 16 != 0 || y % 16 != 0) {
        return WIRE_ERR_SETUP;
    }
    const piece p = piece_of(out, y / 16 * out->columns + x / 16);
    convert(out, &p, rgb, stride);
    out->is_cut = (uint8_t)!offer(out, &p);
    return out->is_cut ? WIRE_BUSY : WIRE_OK;
}

int wire_frame_end(wire_frames_out *out) {
    if (!is_ready(out) || !out->in_frame) {
        return WIRE_ERR_DOWN;
    }
    out->is_cut = (uint8_t)!end_frame(out, 1);
    return out->is_cut ? WIRE_BUSY : WIRE_OK;
}

int wire_frames_out_idle(const wire_frames_out *out) {
    return is_ready(out) && !out->is_fresh &&
           (!out->in_frame || (out->near > 0 && out->is_exact_pass)) && out->unanswered < SLOTS;
}

int wire_frames_out_done(const wire_frames_out *out) {
    int coarse;
    if (!is_ready(out) || out->is_fresh || out->in_frame || out->unanswered > 0) {
        return 0;
    }
    return !is_missing(out, &coarse) && !coarse;
}
