# structures.awk - sizes of structures, the largest first, from what a compiler wrote for debuggers
#
#   objdump --dwarf=info FILE.o ... | awk -v least=BYTES -f structures.awk
#
# Prints "NAME BYTES" of every structure of at least so many bytes, by its typedef or its tag, each
# name once; of two sizes (there are none in this tree) the larger.
# SPDX-License-Identifier: MIT
/DW_TAG_/ {
    if (match($0, /<[0-9a-f]+>: Abbrev/)) {
        at = substr($0, RSTART + 1, RLENGTH - 10)
    }
    tag = $0 ~ /DW_TAG_structure_type/ ? "s" : $0 ~ /DW_TAG_typedef/ ? "t" : ""
    name = ""
    if (tag == "s") {
        named = 0
    }
}
# A number of objdump's ends where its file does: entries of two files may have one address.
/file format/ { file++ }
tag != "" && /DW_AT_name/ {
    name = $NF
    if (tag == "s") {
        tag_name[file, at] = name
    }
}
tag == "s" && /DW_AT_byte_size/ { bytes[file, at] = $NF }
tag == "t" && /DW_AT_type/ {
    to = $NF
    gsub(/[<>]|0x/, "", to)
    type_name[file, to] = name
    tag = ""
}
END {
    for (key in bytes) {
        name = (key in type_name) ? type_name[key] : tag_name[key]
        if (name != "" && bytes[key] + 0 > size[name] + 0) {
            size[name] = bytes[key] + 0
        }
    }
    for (name in size) {
        if (size[name] >= least + 0) {
            print name, size[name] | "sort -k2,2rn -k1,1"
        }
    }
}
