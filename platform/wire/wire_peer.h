/* wire_peer - a party of the wire: reports in, reports out, and what is between
 *
 * Both peers run this same code; the only difference is who speaks first
 * (WIRE_HOST). A peer has services (frames out, frames in, scene, blocks), each
 * opened on it by its own header's call; services it lacks cost nothing.
 *
 * Nothing here blocks, and nothing is kept of a report after the call that
 * brought it. Transports may lose, repeat, reorder, cut and damage reports,
 * and either peer may vanish and come back: WIRE.md says what holds then.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_PEER_H
#define PLT_WIRE_PEER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { WIRE_VERSION = 1 };

enum {
    WIRE_REPORT_BYTES_MIN = 8,
    WIRE_REPORT_BYTES_MAX = 1024,
    WIRE_HEADER_BYTES = 6, /* of a report of at most 128 bytes, else 7: WIRE.md, section 2 */
    WIRE_CREDITS_MAX = 32  /* credits: reports on the way without an acknowledgement */
};

/* Milliseconds. */
enum {
    WIRE_PING_MS = 40,   /* waiting for an acknowledgement before asking */
    WIRE_IDLE_MS = 250,  /* host: nothing heard before asking; repeats of what may be lost */
    WIRE_HELLO_MS = 100, /* between hellos while nobody answers */
    WIRE_DEAD_MS = 800   /* nothing valid heard: the other peer is silent */
};

enum wire_role { WIRE_DEVICE = 0, WIRE_HOST = 1 };

enum wire_status {
    WIRE_OK = 0,
    WIRE_BUSY = 1,       /* not now: call again after the next report has left */
    WIRE_ERR_SETUP = -1, /* a value outside its stated range; nothing was done */
    WIRE_ERR_DOWN = -2   /* no session */
};

/* What a peer can do and has; the hello says it to the other peer. */
enum wire_feature {
    WIRE_SHOWS = 1,       /* shows frames: `width`, `height`, `format` are its panel */
    WIRE_SENDS = 2,       /* sends frames to a peer that shows */
    WIRE_RENDERS = 4,     /* receives a scene image and views, and renders them */
    WIRE_SCENES = 8,      /* sends a scene image, and blocks of it on request */
    WIRE_BRIGHTNESS = 16, /* obeys WIRE_SET_BRIGHTNESS */
    WIRE_READS = 32,      /* its panel can be read: tiles may say only what differs */
    WIRE_STREAMS = 64,    /* renders scenes larger than its memory, of which it asks for blocks */
    WIRE_KEYS = 128       /* device: has keys; host: wants to know of them (wire_keys.h) */
};

typedef struct wire_caps {
    uint32_t arena_bytes;   /* WIRE_RENDERS: room for scene and engine */
    uint32_t session;       /* random; the peer's own half of the session number */
    uint16_t width, height; /* WIRE_SHOWS: pixels, 1 .. 65535; else 0 */
    uint16_t formats;       /* bit f: can show enum wire_format f (information) */
    uint16_t in_bytes;      /* size of the reports it receives ... */
    uint16_t out_bytes;     /* ... and of those it sends */
    uint8_t format;         /* the one that frames must come in */
    uint8_t features;       /* bits of enum wire_feature */
    uint8_t credits;        /* reports its transport can queue: 2 .. WIRE_CREDITS_MAX */
    uint8_t version;        /* WIRE_VERSION */
} wire_caps;

typedef struct wire_setup {
    uint8_t role; /* enum wire_role */
    /* Of this peer. `version` is filled in. `session`: a number that this peer has
     * not used before, if possible (a clock, a counter in flash, noise
     * of an ADC); sessions after a cut count on from it. */
    wire_caps caps;
} wire_setup;

typedef struct wire_stats {
    uint32_t reports_out, reports_in; /* valid ones in */
    uint32_t reports_lost;            /* numbers that were skipped on the way in */
    uint32_t reports_late;            /* came again, or after their successors: dropped */
    uint32_t reports_bad;             /* wrong size, checksum or session: dropped */
    uint32_t sessions;                /* begun since open */
    uint32_t pings_out;
    uint32_t frames_out, frames_in; /* acknowledged whole */
    uint32_t frames_bad;            /* sent or received with something missing */
    uint32_t tiles_out, tiles_in;
    uint32_t payload_out, payload_in; /* bytes of data messages */
} wire_stats;

/* Errors that one peer reports to the other: wire_error_send, wire_error_read. */
enum wire_code {
    WIRE_FINE = 0,
    WIRE_E_VERSION = 1, /* `detail`: the version this peer speaks */
    WIRE_E_PANEL = 2,   /* the panel has more tiles than the sender can keep */
    WIRE_E_SCENE = 3,   /* the image was refused: rule << 24 | offset & 0xFFFFFF */
    WIRE_E_ARENA = 4,   /* `detail`: bytes it would need */
    WIRE_E_SOURCE = 5,  /* a block did not come: its offset */
    WIRE_E_VIEW = 6,    /* the camera has no direction, or the shader is none */
    WIRE_E_BLOCK = 7,   /* a request outside the image: its offset */
    WIRE_E_SAMPLES = 8  /* the engine does not take so many samples of this scene, or shader */
};

enum wire_setting { WIRE_SET_BRIGHTNESS = 1 /* 0 .. 100 */ };

struct wire_frames_out;
struct wire_frames_in;
struct wire_scene_out;
struct wire_scene_in;
struct wire_blocks_out;
struct wire_blocks_in;
struct wire_view_out;
struct wire_view_in;
struct wire_keys_out;
struct wire_keys_in;

struct wire_queue;

enum { WIRE_CONTROL_BYTES = 48 }; /* longest control message with its head */

/* Messages of one channel as they come (WIRE.md, section 3). */
typedef struct wire_stream {
    uint16_t left;   /* bytes of the body still to come */
    uint8_t stage;   /* enum in peer_in.c */
    uint8_t is_lost; /* something was missed: wait for a report that says where a message begins */
    uint8_t type, low, used;
} wire_stream;

/* Looked at only through the functions below. */
typedef struct wire_peer {
    struct wire_frames_out *frames_out;
    struct wire_frames_in *frames_in;
    struct wire_scene_out *scene_out;
    struct wire_scene_in *scene_in;
    struct wire_view_out *view_out;
    struct wire_view_in *view_in;
    struct wire_blocks_out *blocks_out;
    struct wire_blocks_in *blocks_in;
    struct wire_keys_out *keys_out;
    struct wire_keys_in *keys_in;
    struct wire_queue *queue; /* of data messages, shared by the parts that send */

    wire_caps own, other, next_other;
    wire_stats stats;
    uint32_t key;        /* of the session: in every checksum */
    uint32_t next_key;   /* device: of the session offered, not yet begun */
    uint32_t host_half;  /* the host's half of the session's number */
    uint32_t out_number; /* of the next report */
    uint32_t out_acked;  /* the other peer has seen, or missed, all below */
    uint32_t out_asks;   /* reports below want an acknowledgement */
    uint32_t in_number;  /* the report expected next */
    uint32_t heard_ms, asked_ms, set_ms, now_ms;
    uint32_t error_detail, error_place, other_detail, other_place;
    uint32_t pending; /* control messages to send: bits of base.h */
    uint8_t role, state, has_next, error, error_kind, other_error, other_kind;
    uint8_t is_silent; /* the session is up, but nothing was heard for WIRE_DEAD_MS */
    uint8_t setting[2], other_setting[2], settings_to_go;
    uint8_t unacked_in, hello_number, hello_in, hello_used;
    uint8_t control_used, control_gone; /* of a control message being sent */
    wire_stream control, data;
    uint8_t control_out[WIRE_CONTROL_BYTES], control_in[WIRE_CONTROL_BYTES];
    uint8_t data_head[12];
} wire_peer;

/* Opens a peer without services; a host begins to say hello. Errors:
 * WIRE_ERR_SETUP for sizes, credits or role out of range. */
int wire_peer_open(wire_peer *peer, const wire_setup *setup, uint32_t now_ms);

/* The transport came up (cable in, file opened) or went down: the session is
 * over, everything on the way is forgotten, what the panel shows stays. */
void wire_on_link(wire_peer *peer, int up, uint32_t now_ms);

/* A report came, of `bytes` bytes. Anything at all may be in it; an empty one
 * is nothing. Cost: the checksum (7 instructions per byte on a
 * Cortex-M), and decoding straight into the panel. Returns 1 when it was
 * valid and new, else 0. */
int wire_on_report(wire_peer *peer, const uint8_t *report, size_t bytes, uint32_t now_ms);

/* Time passed: call it 20 times per second at least. `now_ms` may wrap. */
void wire_poll(wire_peer *peer, uint32_t now_ms);

/* Writes the next report to `report` (own.out_bytes of room) and returns its
 * size, or 0 when there is nothing to send or no credit to send it. Once
 * returned, the report counts as sent. */
size_t wire_next_report(wire_peer *peer, uint8_t *report, uint32_t now_ms);

/* Whether a session is up and the other peer is heard; what it said it is (while up). A session
 * outlives silence: when the other peer is heard again, it goes on where it was. */
int wire_is_up(const wire_peer *peer);
const wire_caps *wire_other(const wire_peer *peer);

/* Reports on the way that the other peer has not acknowledged. */
uint32_t wire_unacked(const wire_peer *peer);

/* Reports an error to the other peer; the latest counts. */
void wire_error_send(wire_peer *peer, unsigned code, uint32_t detail);

/* The same for an image that was refused or did not come: rule (0: none is broken), byte, and
 * whether the rule is a refusal, 'R', or an invariant, 'I' (plt_fault). */
void wire_fault_send(wire_peer *peer, unsigned code, unsigned rule, uint32_t place, char kind);

/* Sends the last error again, as one may be lost. */
void wire_error_repeat(wire_peer *peer);

/* The latest error that the other peer reported; read once. WIRE_FINE: none. */
unsigned wire_error_read(wire_peer *peer, uint32_t *detail);

/* Of that error: the byte of the image, and the kind of the rule. */
uint32_t wire_error_place(const wire_peer *peer, char *kind);

/* Sends a setting; the latest counts. At the other peer wire_setting_read
 * returns its key once, 0 when there is none. */
void wire_setting_send(wire_peer *peer, unsigned key, unsigned value);
unsigned wire_setting_read(wire_peer *peer, unsigned *value);

#ifdef __cplusplus
}
#endif
#endif
