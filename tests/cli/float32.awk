# float32 - numbers as little-endian float32, in octal escapes for printf
#
# Rounds to nearest; subnormals become 0; "inf", "-inf" and "nan" are known.
# SPDX-License-Identifier: MIT
function put(byte) {
    printf "\\%03o", byte
}

function put_bits(sign, exponent, fraction) {
    put(fraction % 256)
    put(int(fraction / 256) % 256)
    put(exponent % 2 * 128 + int(fraction / 65536))
    put(sign * 128 + int(exponent / 2))
}

function put_float(x,    sign, exponent) {
    sign = x < 0
    x = sign ? -x : x
    if (x == 0) {
        put_bits(sign, 0, 0)
        return
    }
    for (exponent = 127; x >= 2 && exponent < 255; exponent++) {
        x /= 2
    }
    for (; x < 1 && exponent > 0; exponent--) {
        x *= 2
    }
    x = int((x - 1) * 8388608 + 0.5)
    if (x == 8388608) {
        x = 0
        exponent++
    }
    put_bits(sign, exponent, exponent <= 0 || exponent >= 255 ? 0 : x)
}

{
    for (i = 1; i <= NF; i++) {
        if ($i ~ /inf/) {
            put_bits($i ~ /^-/, 255, 0)
        } else if ($i ~ /nan/) {
            put_bits(0, 255, 4194304)
        } else {
            put_float($i + 0)
        }
    }
}
