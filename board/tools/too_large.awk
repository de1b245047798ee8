# too_large - what the linker says, and of a firmware that does not fit how large both are
#
#   awk -v board=NAME -v arena=BYTES -v stack=BYTES -f too_large.awk firmware.map link.txt
#
# The map has each memory and its length, the linker's words by how much one is too small.
# SPDX-License-Identifier: MIT

function number(hexadecimal,    i, value) {
    value = 0
    for (i = 3; i <= length(hexadecimal); i++) {
        value = 16 * value + index("0123456789abcdef", substr(hexadecimal, i, 1)) - 1
    }
    return value
}

NF >= 3 && $2 ~ /^0x/ && $3 ~ /^0x/ && !($1 in size) && FILENAME == ARGV[1] {
    size[$1] = number($3)
}

FILENAME == ARGV[2] {
    print
}

FILENAME == ARGV[2] && match($0, /region `[A-Z]*' overflowed by [0-9]+ bytes/) {
    split(substr($0, RSTART, RLENGTH), word, /[`' ]+/)
    too_many[word[2]] = word[5]
}

END {
    if ("RAM" in too_many) {
        printf "error: an arena of %d bytes and a stack of %d do not fit on %s: of its %d bytes " \
               "of RAM %d are left for both; ARENA_BYTES and STACK_BYTES are in its board.mk\n",
               arena, stack, board, size["RAM"], arena + stack - too_many["RAM"]
    }
    if ("FLASH" in too_many) {
        printf "error: a firmware of %d bytes does not fit into the %d bytes of flash of %s; " \
               "PARTS leaves out parts of the engine\n",
               size["FLASH"] + too_many["FLASH"], size["FLASH"], board
    }
}
