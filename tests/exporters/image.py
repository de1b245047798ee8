"""image - the triangles of a scene image that was packed with `--build none`

SPEC.md 2, 3 and 4.4: a section of kind 2 holds records of 40 bytes, nine floats and the word
of the primitive id. Corner j of the mesh's triangle is corner (rotation + j) mod 3 here.

SPDX-License-Identifier: MIT
"""
import struct

RECORDS = 2


def records_at(image):
    for i in range(struct.unpack_from("<I", image, 100)[0]):
        kind, offset = struct.unpack_from("<II", image, 104 + 16 * i)
        if kind == RECORDS:
            return offset
    raise ValueError("no section of triangle records")


def triangles(image):
    """By primitive id, each as three positions, each as three words of 32 bits."""
    if image[:8] != b"PLANELET" or image[97] != 2:
        raise ValueError("no image of build none")
    count = struct.unpack_from("<I", image, 24)[0]
    first = records_at(image)
    found = [None] * count
    for i in range(count):
        *words, identity = struct.unpack_from("<10I", image, first + 40 * i)
        canonical = [tuple(words[k: k + 3]) for k in (0, 3, 6)]
        rotation = identity >> 29 & 3
        found[identity & 0x7FFFFFF] = [canonical[(rotation + j) % 3] for j in range(3)]
    if None in found:
        raise ValueError("primitive ids are no permutation")
    return found
