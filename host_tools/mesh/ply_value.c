/* ply_value - single values of a PLY file, of any type and format
 *
 * Keeps: `data.at` never passes `data.end`; every call that returns 0
 * consumed at least one byte.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/ply_value.h"

#include <math.h>
#include <string.h>

static int fail_short(ply_reader *r) {
    return intake_fail(&r->in, "the file ends inside it; get it again");
}

static double float_of(uint64_t bits) {
    const uint32_t low = (uint32_t)bits;
    float value;
    memcpy(&value, &low, sizeof value);
    return (double)value;
}

static double double_of(uint64_t bits) {
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static double value_of(uint64_t bits, ply_type type) {
    switch (type) {
    case PLY_INT8:
        return (double)(int8_t)bits;
    case PLY_INT16:
        return (double)(int16_t)bits;
    case PLY_INT32:
        return (double)(int32_t)bits;
    case PLY_INT64:
        return (double)(int64_t)bits;
    case PLY_FLOAT32:
        return float_of(bits);
    case PLY_FLOAT64:
        return double_of(bits);
    default:
        return (double)bits;
    }
}

static int binary_bits(ply_reader *r, ply_type type, uint64_t *bits) {
    const size_t size = ply_type_bytes(type);
    if ((size_t)(r->data.end - r->data.at) < size) {
        return fail_short(r);
    }
    const int little = r->header->format == PLY_LITTLE;
    *bits = 0;
    for (size_t i = 0; i < size; i++) {
        *bits = *bits << 8 | r->data.at[little ? size - 1 - i : i];
    }
    r->data.at += size;
    return 0;
}

static int binary_value(ply_reader *r, ply_type type, double *value) {
    uint64_t bits = 0;
    if (binary_bits(r, type, &bits) != 0) {
        return -1;
    }
    *value = value_of(bits, type);
    return 0;
}

/* To the next value of an ASCII file. A value may stand on a later line:
 * a value too many on that line is then what fails. */
static int find_value(ply_reader *r) {
    while (scan_line_done(&r->data)) {
        if (!scan_next_line(&r->data)) {
            return fail_short(r);
        }
        r->in.at.line = r->data.line;
    }
    return 0;
}

static int fail_number(ply_reader *r, const char *kind) {
    const word w = scan_word(&r->data);
    return intake_fail(&r->in, "'%.*s' where a %snumber belongs; correct it", WORD_SHOWN(w), kind);
}

static int is_whole(double value) {
    return value >= -1e15 && value <= 1e15 && (double)(int64_t)value == value;
}

int ply_integer(ply_reader *r, ply_type type, int64_t *value) {
    double number;
    if (r->header->format != PLY_ASCII) {
        if (binary_value(r, type, &number) != 0) {
            return -1;
        }
        *value = is_whole(number) ? (int64_t)number : INTAKE_MISSING;
        return 0;
    }
    real fraction;
    if (find_value(r) != 0) {
        return -1;
    }
    if (scan_integer(&r->data, value) == 0) {
        return 0;
    }
    if (type < PLY_FLOAT32 || scan_real(&r->data, &fraction) != 0) {
        return fail_number(r, type < PLY_FLOAT32 ? "whole " : "");
    }
    *value = is_whole(fraction.wide) ? (int64_t)fraction.wide : INTAKE_MISSING;
    return 0;
}

/* A double beyond the floats becomes infinite, which the intake refuses. */
static float narrow(double value) {
    if (value > 1e38 || value < -1e38) {
        return value > 0 ? INFINITY : -INFINITY;
    }
    return (float)value;
}

/* 64 bits are rounded to single precision at once, not by way of double. */
static float single_of(uint64_t bits, ply_type type) {
    return type == PLY_INT64    ? (float)(int64_t)bits
           : type == PLY_UINT64 ? (float)bits
                                : narrow(value_of(bits, type));
}

int ply_coordinate(ply_reader *r, ply_type type, real *value) {
    uint64_t bits = 0;
    if (r->header->format != PLY_ASCII) {
        if (binary_bits(r, type, &bits) != 0) {
            return -1;
        }
        *value = (real){single_of(bits, type), value_of(bits, type)};
        return 0;
    }
    if (find_value(r) != 0) {
        return -1;
    }
    return scan_real(&r->data, value) == 0 ? 0 : fail_number(r, "");
}

int ply_count(ply_reader *r, const ply_property *p, uint64_t *count) {
    int64_t number;
    if (ply_integer(r, p->count_type, &number) != 0) {
        return -1;
    }
    const size_t there = (size_t)(r->data.end - r->data.at);
    const size_t least = r->header->format == PLY_ASCII ? 1 : ply_type_bytes(p->type);
    if (number < 0 || (uint64_t)number > there / least) {
        return intake_fail(&r->in,
                           "a list of %lld values, but %zu bytes follow; "
                           "the file is damaged: get it again",
                           (long long)number, there);
    }
    *count = (uint64_t)number;
    return 0;
}

static int skip_values(ply_reader *r, ply_type type, uint64_t count) {
    if (r->header->format != PLY_ASCII) {
        const size_t size = ply_type_bytes(type);
        if (count > (size_t)(r->data.end - r->data.at) / size) {
            return fail_short(r);
        }
        r->data.at += count * size;
        return 0;
    }
    for (uint64_t i = 0; i < count; i++) {
        if (find_value(r) != 0) {
            return -1;
        }
        scan_word(&r->data);
    }
    return 0;
}

int ply_skip(ply_reader *r, const ply_property *p) {
    uint64_t count = 1;
    if (p->is_list && ply_count(r, p, &count) != 0) {
        return -1;
    }
    return skip_values(r, p->type, count);
}
