/* probe - every operation of one lanes header, by number
 *
 * Compiled once for each line of platform/lanes.txt, with PROBE, the variable's name, PROBE_NAME,
 * PROBE_HEADER, PROBE_MACRO, and PROBE_OFFERED, whether the compiler has that macro. Operations
 * that give a mask leave its four lanes as words, read by u4_select, and its bits, read by m4_mask.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "tests/lanes/ops.h"

extern const lanes_probe PROBE;

#if PROBE_OFFERED
#define PLT_LANES PROBE_HEADER
#define PLT_ASKS_FLUSHED 1
#include "engine/lanes/lanes.h"

/* Four words at an address aligned to 4 bytes only: the least alignment that load and store
 * must accept. */
typedef union buffer {
    float f[5];
    uint32_t u[5];
    _Alignas(16) unsigned char bytes[20];
} buffer;

/* The compiler must not know where `p` points, or it would forward the stored value and skip
 * the access that is tested. */
static buffer *hidden(buffer *p) {
    __asm__ volatile("" : "+r"(p) : : "memory");
    return p;
}

static f4 f4_of(const uint32_t *words) {
    buffer p;
    memcpy(p.bytes + 4, words, 16);
    return f4_load(hidden(&p)->f + 1);
}

static u4 u4_of(const uint32_t *words) {
    buffer p;
    memcpy(p.bytes + 4, words, 16);
    return u4_load(hidden(&p)->u + 1);
}

static void put_f4(uint32_t *out, f4 a) {
    buffer p;
    f4_store(hidden(&p)->f + 1, a);
    memcpy(out, p.bytes + 4, 16);
}

static void put_u4(uint32_t *out, u4 a) {
    buffer p;
    u4_store(hidden(&p)->u + 1, a);
    memcpy(out, p.bytes + 4, 16);
}

static void put_m4(uint32_t *out, m4 a) {
    put_u4(out, u4_select(a, u4_all(0xFFFFFFFFu), u4_all(0)));
    put_f4(out + 4, f4_select(a, f4_all(1.0f), f4_all(2.0f)));
    out[8] = m4_mask(a);
}

static void put_float(uint32_t *out, float x) {
    memcpy(out, &x, sizeof x);
}

static float float_of(const uint32_t *word) {
    float x;
    memcpy(&x, word, sizeof x);
    return x;
}

static void run_transpose(const lanes_in *in, uint32_t *out) {
    f4 row[4] = {f4_of(in->row[0]), f4_of(in->row[1]), f4_of(in->row[2]), f4_of(in->row[3])};
    f4_transpose(&row[0], &row[1], &row[2], &row[3]);
    for (int i = 0; i < 4; i++) {
        put_f4(out + 4 * i, row[i]);
    }
}

_Static_assert(sizeof(f4) == 16, "four floats, and nothing else");

/* As an f4 lies in memory: some code reads and writes single lanes there. */
static void run_in_memory(const lanes_in *in, uint32_t *out) {
    const f4 a = f4_of(in->row[0]);
    put_f4(out, a);
    memcpy(out + 4, &a, sizeof a);
}

/* From an odd address. */
static void run_bytes(const lanes_in *in, uint32_t *out) {
    buffer p;
    for (int i = 0; i < 4; i++) {
        p.bytes[5 + i] = (unsigned char)in->row[0][i];
    }
    put_f4(out, f4_of_bytes(hidden(&p)->bytes + 5));
}

static void run_load_16(const lanes_in *in, uint32_t *out) {
    buffer p;
    memcpy(p.bytes, in->row[0], 16);
    put_f4(out, f4_load_16(hidden(&p)->f));
}

/* To places of which two may be the same, in two rows of words. */
static void run_store_pairs(const lanes_in *in, uint32_t *out) {
    uint32_t to[8][2];
    uint8_t at[4];
    memset(to, 0x77, sizeof to);
    for (int i = 0; i < 4; i++) {
        at[i] = (uint8_t)(in->row[2][i] & 7u);
    }
    f4_store_pairs(to, at, u4_of(in->row[0]), f4_of(in->row[1]));
    memcpy(out, to, sizeof to);
}

/* Bytes hidden as in run_bytes. */
static void run_halves(const lanes_in *in, uint32_t *out) {
    buffer p;
    for (int i = 0; i < 4; i++) {
        p.bytes[5 + 2 * i] = (unsigned char)in->row[0][i];
        p.bytes[6 + 2 * i] = (unsigned char)(in->row[0][i] >> 8);
    }
    put_f4(out, f4_of_halves(hidden(&p)->bytes + 5));
}

/* At an odd address. */
static void run_load_bytes(const lanes_in *in, uint32_t *out) {
    unsigned char bytes[17];
    memcpy(&bytes[1], in->row[0], 16);
    put_u4(out, u4_load_bytes(&bytes[1]));
}

/* At a multiple of 4 alone, like the pairs of entries on a stack. */
static void run_pair(const lanes_in *in, uint32_t *out) {
    float pair[3];
    memcpy(&pair[1], in->row[0], sizeof(float[2]));
    put_f4(out, f4_load_pair(&pair[1]));
}

/* Of numbers that the operation is for: of others nothing is said. */
static void run_cut_off(const lanes_in *in, uint32_t *out) {
    const f4 most = f4_all(2147483520.0f); /* the greatest below 2^31 */
    put_u4(out, u4_of_f4(f4_min(f4_abs(f4_of(in->row[0])), most)));
}

static void run_swap(const lanes_in *in, uint32_t *out) {
    f4 a = f4_of(in->row[0]), b = f4_of(in->row[1]);
    f4_swap(m4_bits(in->mask[0]), &a, &b);
    put_f4(out, a);
    put_f4(out + 4, b);
}

static void run_words_to_mask(const lanes_in *in, uint32_t *out) {
    uint32_t word[4];
    for (int i = 0; i < 4; i++) {
        word[i] = 0u - (in->mask[0] >> i & 1u);
    }
    put_m4(out, m4_of_u4(u4_of(word)));
}

#define F_F(op)                                                                                    \
    case OP_##op:                                                                                  \
        put_f4(out, op(f4_of(in->row[0])));                                                        \
        break
#define F_FF(op)                                                                                   \
    case OP_##op:                                                                                  \
        put_f4(out, op(f4_of(in->row[0]), f4_of(in->row[1])));                                     \
        break
#define U_UU(op)                                                                                   \
    case OP_##op:                                                                                  \
        put_u4(out, op(u4_of(in->row[0]), u4_of(in->row[1])));                                     \
        break
#define M_FF(op)                                                                                   \
    case OP_##op:                                                                                  \
        put_m4(out, op(f4_of(in->row[0]), f4_of(in->row[1])));                                     \
        break
#define M_UU(op)                                                                                   \
    case OP_##op:                                                                                  \
        put_m4(out, op(u4_of(in->row[0]), u4_of(in->row[1])));                                     \
        break
#define M_MM(op)                                                                                   \
    case OP_##op:                                                                                  \
        put_m4(out, op(m4_bits(in->mask[0]), m4_bits(in->mask[1])));                               \
        break

static void run_op(enum lanes_op op, const lanes_in *in, uint32_t out[16]) {
    switch (op) {
        F_FF(f4_add);
        F_FF(f4_sub);
        F_FF(f4_mul);
        F_FF(f4_div);
        F_FF(f4_min);
        F_FF(f4_max);
        F_F(f4_abs);
        F_F(f4_neg);
        F_F(f4_sqrt);
        U_UU(u4_add);
        U_UU(u4_and);
        U_UU(u4_andnot);
        M_FF(f4_lt);
        M_FF(f4_le);
        M_FF(f4_eq);
        M_UU(u4_lt);
        M_UU(u4_eq);
        M_MM(m4_and);
        M_MM(m4_or);
        M_MM(m4_andnot);
    case OP_f4_load:
        run_in_memory(in, out);
        break;
    case OP_f4_store:
        put_f4(out, f4_of(in->row[0]));
        break;
    case OP_u4_load:
    case OP_u4_store:
        put_u4(out, u4_of(in->row[0]));
        break;
    case OP_u4_ones:
        out[0] = u4_ones(u4_of(in->row[0]));
        break;
    case OP_u4_load_bytes:
        run_load_bytes(in, out);
        break;
    case OP_f4_load_pair:
        run_pair(in, out);
        break;
    case OP_f4_all:
        put_f4(out, f4_all(float_of(in->row[0])));
        break;
    case OP_u4_all:
        put_u4(out, u4_all(in->row[0][0]));
        break;
    case OP_u4_three:
        put_u4(out, u4_three(in->row[0][0], in->row[0][1], in->row[0][2]));
        break;
    case OP_f4_of_u4:
        put_f4(out, f4_of_u4(u4_of(in->row[0])));
        break;
    case OP_u4_of_f4:
        run_cut_off(in, out);
        break;
    case OP_f4_of_bytes:
        run_bytes(in, out);
        break;
    case OP_f4_of_halves:
        run_halves(in, out);
        break;
    case OP_f4_zero:
        put_f4(out, f4_zero());
        break;
    case OP_m4_bits:
        put_m4(out, m4_bits(in->mask[0]));
        break;
    case OP_m4_mask:
        out[0] = m4_mask(m4_bits(in->mask[0]));
        break;
    case OP_f4_select:
        put_f4(out, f4_select(m4_bits(in->mask[0]), f4_of(in->row[0]), f4_of(in->row[1])));
        break;
    case OP_u4_select:
        put_u4(out, u4_select(m4_bits(in->mask[0]), u4_of(in->row[0]), u4_of(in->row[1])));
        break;
    case OP_f4_swap:
        run_swap(in, out);
        break;
    case OP_f4_min_lane:
        put_float(out, f4_min_lane(f4_of(in->row[0])));
        break;
    case OP_f4_transpose:
        run_transpose(in, out);
        break;
        F_F(f4_rotate);
        F_F(f4_turn);
    case OP_f4_lane:
        put_f4(out, f4_lane(f4_of(in->row[0]), 0));
        put_f4(out + 4, f4_lane(f4_of(in->row[0]), 1));
        put_f4(out + 8, f4_lane(f4_of(in->row[0]), 2));
        put_f4(out + 12, f4_lane(f4_of(in->row[0]), 3));
        break;
    case OP_m4_of_u4:
        run_words_to_mask(in, out);
        break;
    case OP_f4_load_16:
        run_load_16(in, out);
        break;
    case OP_f4_store_pairs:
        run_store_pairs(in, out);
        break;
    case OP_plt_prefetch:
        plt_prefetch(in);
        break;
    case OP_mul_add: /* not an operation: two, which must stay two */
        put_f4(out, f4_add(f4_mul(f4_of(in->row[0]), f4_of(in->row[1])), f4_of(in->row[2])));
        break;
    }
}

static int run(enum lanes_op op, const lanes_in *in, uint32_t out[16]) {
    plt_flushed_clear();
    run_op(op, in, out);
    return plt_flushed(out) != 0;
}

const lanes_probe PROBE = {PROBE_NAME, PROBE_HEADER, PROBE_MACRO, PLT_LANES_FLUSH, run};
#else
const lanes_probe PROBE = {PROBE_NAME, PROBE_HEADER, PROBE_MACRO, 0, 0};
#endif
