"""single - numbers in text to IEEE single precision, rounded once

Python reads a decimal into a double, and a double into a single: two roundings, and the
second one is wrong where the first one fell on the middle between two singles. So whatever
lies on such a middle, and whatever is subnormal, is rounded from the exact fraction instead.

SPDX-License-Identifier: MIT
"""
import math
import struct
from decimal import Decimal
from fractions import Fraction

LEAST_NORMAL = 2.0 ** -126


def bits_of(value):
    """The 32 bits of a double that is rounded to single."""
    try:
        return struct.unpack("<I", struct.pack("<f", value))[0]
    except OverflowError:
        return 0x7F800000 | (0x80000000 if value < 0 else 0)


def round_exactly(fraction):
    """The 32 bits nearest to a fraction, of two the even ones."""
    sign = 0x80000000 if fraction < 0 else 0
    magnitude = abs(fraction)
    if magnitude == 0:
        return 0
    exponent = -126
    while magnitude >= Fraction(2) ** (exponent + 1):
        exponent += 1
    whole = round(magnitude / Fraction(2) ** (exponent - 23))  # Python rounds to even
    if whole >= 1 << 24:
        whole, exponent = whole >> 1, exponent + 1
    if exponent > 127:
        return sign | 0x7F800000
    if whole < 1 << 23:
        return sign | whole
    return sign | (exponent + 127) << 23 | (whole & 0x7FFFFF)


def bits_of_text(text):
    """The 32 bits of a number in text; ValueError where it is none."""
    value = float(text)
    if value == 0 or not math.isfinite(value):
        return bits_of(value)
    low = struct.unpack("<Q", struct.pack("<d", value))[0] & 0x1FFFFFFF
    if low == 0x10000000 or abs(value) < LEAST_NORMAL:
        return round_exactly(Fraction(Decimal(text)))
    return bits_of(value)


def bits_of_integer(value):
    return round_exactly(Fraction(value))


def value_of(bits):
    return struct.unpack("<f", struct.pack("<I", bits))[0]
