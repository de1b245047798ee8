/* ply_attributes - see ply_attributes.h
 *
 * PLY names no attributes; these are the names that programs write.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/ply_attributes.h"

static const struct {
    const char *name;
    report_item item;
} PROPERTIES[] = {
    {"nx", REPORT_NORMALS},
    {"normal_x", REPORT_NORMALS},
    {"red", REPORT_COLOURS},
    {"r", REPORT_COLOURS},
    {"diffuse_red", REPORT_COLOURS},
    {"s", REPORT_TEXTURES},
    {"u", REPORT_TEXTURES},
    {"texture_u", REPORT_TEXTURES},
    {"s0", REPORT_TEXTURES},
    {"texcoord", REPORT_TEXTURES},
    {"texture_s", REPORT_TEXTURES},
    {"texture_uv", REPORT_TEXTURES},
    {"material_index", REPORT_MATERIALS},
    {"rgb", REPORT_COLOURS},
    {"rgba", REPORT_COLOURS},
    {"color", REPORT_COLOURS},
    {"intensity_red", REPORT_COLOURS},
};

/* One kind is counted once, however many properties it takes. */
static void count_properties(const ply_element *e, uint64_t count[REPORT_ITEMS]) {
    int has[REPORT_ITEMS] = {0};
    for (size_t i = 0; i < e->properties; i++) {
        for (size_t k = 0; k < sizeof PROPERTIES / sizeof PROPERTIES[0]; k++) {
            if (word_is_in_any_case(e->property[i].name, PROPERTIES[k].name)) {
                has[PROPERTIES[k].item] = 1;
            }
        }
    }
    for (int i = 0; i < REPORT_ITEMS; i++) {
        count[i] += has[i] ? e->count : 0;
    }
}

void ply_count_attributes(const ply_element *e, uint64_t count[REPORT_ITEMS]) {
    if (word_is(e->name, "vertex") || word_is(e->name, "face") || word_is(e->name, "tristrips")) {
        count_properties(e, count);
    } else if (word_is(e->name, "edge") || word_is(e->name, "line")) {
        count[REPORT_LINES] += e->count;
    } else if (word_is(e->name, "material")) {
        count[REPORT_MATERIALS] += e->count;
    } else {
        count[REPORT_ELEMENTS] += e->count;
    }
}
