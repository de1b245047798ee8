/* printed - see printed.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/printed.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const printed_scene printed_scenes[PRINTED_SCENES] = {
    {"ground", 12},      {"shuttle", 616},   {"wooddoll", 5378}, {"marbles", 8800},
    {"toasters", 11141}, {"hand", 15855},    {"bunny", 69451},   {"ben", 78029},
    {"fairy", 174117},   {"dragon", 871414}, {"buddha", 1087716}};

const printed_animation printed_animations[PRINTED_ANIMATIONS] = {
    {"wood-doll(29)", 29, PRINTED_WOODDOLL},
    {"marbles(500)", 500, PRINTED_MARBLES},
    {"toasters(245)", 245, PRINTED_TOASTERS},
    {"hand(44)", 44, PRINTED_HAND},
    {"ben(30)", 30, PRINTED_BEN},
    {"fairy(21)", 21, PRINTED_FAIRY}};

const unsigned printed_treelet_sizes[PRINTED_TREELET_SIZES] = {2, 3, 7, 8, 16, 64, 256, 512, 10000};

/* clang-format off: as the pages have them */
static const char *const none[] = {NULL};

static const char *const column_51[] = {"Triangles", "BVH", "wBVH", "BKD", "BPH", "BPH2"};
static const char *const group_51[] = {"", "", "", "", "", ""};
static const char *const cell_51[] = {
    "12",      "0.5K",    "0.3K",    "0.3K",    "0.2K",      "0.1K",    "616",     "31K",
    "19K",     "20K",     "12K",     "0.8K",    "5,378",     "274K",    "181K",    "172K",
    "105K",    "66K",     "8,800",   "466K",    "336K",      "282K",    "178K",    "110K",
    "11,141",  "580K",    "356K",    "356K",    "221K",      "141K",    "15,855",  "815K",
    "525K",    "507K",    "310K",    "198K",    "69,451",    "3,373K",  "2,399K",  "2,222K",
    "1,285K",  "755K",    "78,029",  "3,962K",  "2,409K",    "2,497K",  "1,509K",  "955K",
    "174,117", "8,785K",  "5,331K",  "5,572K",  "3,347K",    "2,126K",  "871,414", "45,504K",
    "30,614K", "27,885K", "17,335K", "10,975K", "1,087,716", "56,762K", "37,977K", "34,807K",
    "21,624K", "13,720K"};
static const char *const remark_51[] = {
    "0.8K of BPH2 in the shuttle's row is taken for a misprint of 8K: ten times less than the "
    "other rows' 11 to 13 bytes per triangle.",
    "Section 2.2 says 16 and 12 bytes per triangle of BPH and BPH2. The table has 18.5 to 20.2 and "
    "10.9 to 12.7, beside the ground's few digits.",
    "Section 2.2 says 64 bytes per triangle of a BVH. The table has 49 to 53, likewise.", NULL};

static const char *const column_52[] = {"% of total leafs", "bytes saved", "% of total size"};
static const char *const group_52[] = {"", "", ""};
static const char *const cell_52[] = {
    "71", "140",       "42", "63", "6,636",      "35", "65", "59,108",    "36",
    "59", "90,944",    "34", "61", "118,720",    "35", "63", "172,312",   "36",
    "73", "820,428",   "39", "66", "864,276",    "36", "67", "1,946,980", "37",
    "61", "9,231,712", "35", "61", "11,535,216", "35", "64", "-",         "36"};
static const char *const remark_52[] = {
    "All bytes saved are multiples of 28, and only 28 per intermediate node gives the node counts "
    "of Table 5.1. The caption says 32, with which 37 to 45 % would be saved.",
    NULL};

static const char *const column_53[] = {"4x4", "8x8", "16x16", "4x4", "8x8", "16x16"};
static const char *const group_53[] = {"wBVH", "wBVH", "wBVH", "BPH", "BPH", "BPH"};
static const char *const cell_53[] = {
    "60", "84", "90", "21", "24", "29", "51", "72", "77", "15", "16", "17", "36", "47", "44",
    "11", "11", "11", "26", "35", "32", "7",  "7",  "6",  "25", "35", "33", "5",  "5",  "5",
    "22", "31", "28", "7",  "7",  "6",  "17", "21", "17", "6",  "5",  "4",  "22", "26", "22",
    "7",  "6",  "4",  "7",  "11", "9",  "2",  "2",  "2",  "9",  "8",  "6",  "3",  "2",  "1",
    "8",  "7",  "5",  "3",  "2",  "1",  "37", "45", "43", "10", "10", "9",  "20", "31", "30",
    "5",  "5",  "5",  "23", "31", "30", "5",  "5",  "5",  "21", "29", "27", "6",  "6",  "6",
    "18", "24", "19", "4",  "5",  "5",  "6",  "9",  "8",  "2",  "2",  "1"};

static const char *const column_54[] = {"4x4",   "8x8", "16x16", "4x4",  "8x8",
                                        "16x16", "4x4", "8x8",   "16x16"};
static const char *const group_54[] = {
    "#node-isecs/packet", "#node-isecs/packet", "#node-isecs/packet",
    "#tri-isecs/packet",  "#tri-isecs/packet",  "#tri-isecs/packet",
    "%rays masked out",   "%rays masked out",   "%rays masked out"};
static const char *const cell_54[] = {
    "3",  "3",  "4",   "3",  "3",  "4",   "1",  "3",  "6",   "6",  "6",  "2",   "1",  "1",  "3",
    "10", "32", "57",  "8",  "10", "7",   "1",  "3",  "9",   "31", "66", "86",  "14", "17", "12",
    "2",  "4",  "16",  "35", "69", "88",  "22", "25", "13",  "4",  "7",  "18",  "20", "50", "76",
    "13", "17", "15",  "3",  "6",  "12",  "33", "67", "87",  "16", "23", "35",  "4",  "11", "82",
    "48", "81", "94",  "12", "18", "30",  "3",  "9",  "53",  "48", "81", "94",  "50", "66", "89",
    "17", "32", "130", "25", "62", "86",  "26", "59", "162", "11", "42", "473", "69", "92", "98",
    "30", "76", "207", "13", "51", "471", "70", "92", "98"};
static const char *const remark_54[] = {
    "The shuttle's 2 nodes and 3 triangles at 16x16, fewer nodes than at 8x8, are taken for a "
    "misprint: columns that have changed places.",
    NULL};

static const char *const column_55[] = {"TL2",  "TL3",   "TL7",   "TL8",  "TL16",
                                        "TL64", "TL256", "TL512", "TL10K"};
static const char *const group_55[] = {"", "", "", "", "", "", "", "", ""};
static const char *const cell_55[] = {
    "0(0)",  "0(0)",  "32(1)",  "64(1)",  "320(1)", "2K(1)",  "8K(1)",  "16K(1)",  "320K(1)",
    "0(0)",  "0(0)",  "0(0)",   "192(2)", "192(1)", "192(1)", "4K(1)",  "4K(1)",   "308K(1)",
    "0(0)",  "32(1)", "96(1)",  "192(1)", "448(1)", "2K(1)",  "2K(1)",  "10K(1)",  "215K(1)",
    "32(1)", "64(1)", "0(0)",   "32(1)",  "32(1)",  "544(1)", "3K(1)",  "3K(1)",   "142K(1)",
    "0(0)",  "0(0)",  "64(1)",  "128(1)", "384(1)", "384(2)", "384(1)", "9K(1)",   "99K(1)",
    "0(0)",  "64(1)", "64(1)",  "128(2)", "384(1)", "896(1)", "9K(13)", "1K(1)",   "9K(1)",
    "32(1)", "0(0)",  "96(1)",  "96(1)",  "352(1)", "1K(1)",  "1K(1)",  "10K(32)", "315K(1)",
    "32(1)", "64(1)", "160(2)", "224(2)", "224(1)", "224(1)", "6K(1)",  "15K(1)",  "91K(1)",
    "32(1)", "64(2)", "192(2)", "96(1)",  "352(1)", "2K(1)",  "4K(1)",  "12K(1)",  "173K(1)",
    "32(1)", "32(1)", "0(0)",   "96(1)",  "96(1)",  "2K(1)",  "8K(1)",  "16K(1)",  "265K(1)",
    "32(1)", "32(1)", "64(1)",  "32(1)",  "32(1)",  "1K(1)",  "3K(1)",  "3K(1)",   "136K(1)",
    "0.55",  "0.73",  "0.91",   "1.27",   "1",      "1.09",   "2.09",   "3.82",    "1",
    "18",    "32",    "70",     "116",    "256",    "1K",     "4K",     "9K",      "191K"};
static const char *const remark_55[] = {
    "All cells are 32 bytes times the nodes that are missing from a whole number of treelets, but "
    "for the hand's 9K(13) at 256, which has a block of 256 more than that.",
    NULL};

static const char *const column_56[] = {"BPH",  "TL2",  "TL3",   "TL7",   "TL8",
                                        "TL16", "TL64", "TL256", "TL512", "TL10K"};
static const char *const group_56[] = {"", "", "", "", "", "", "", "", "", ""};
static const char *const cell_56[] = {
    "3",  "3",  "3",  "3",  "3",  "3",  "3",  "3",  "3",  "3",  "6",  "6",  "6",  "6",  "6",
    "6",  "7",  "7",  "7",  "7",  "8",  "9",  "9",  "9",  "9",  "9",  "9",  "9",  "9",  "9",
    "14", "14", "15", "15", "15", "15", "15", "15", "15", "16", "22", "23", "24", "23", "23",
    "23", "25", "25", "25", "28", "13", "16", "16", "14", "14", "15", "16", "17", "18", "22",
    "16", "18", "19", "19", "19", "20", "20", "21", "22", "25", "12", "14", "15", "14", "14",
    "15", "14", "14", "14", "16", "50", "60", "56", "59", "61", "58", "61", "63", "63", "64",
    "26", "31", "33", "43", "35", "30", "34", "33", "33", "38", "30", "44", "43", "56", "53",
    "39", "41", "39", "41", "43", "18", "22", "22", "24", "23", "21", "22", "22", "23", "25"};
static const char *const remark_56[] = {
    "The text says 20 to 35 % more for larger scenes. The table has up to 87 % (buddha, TL7).",
    NULL};

static const printed_table tables[PRINTED_TABLES] = {
    {"5.1", "Overall size of the acceleration structures, in bytes, without triangles", 6, 11,
     group_51, column_51, cell_51, remark_51},
    {"5.2", "Savings due to the usage of intermediate nodes", 3, 12, group_52, column_52, cell_52,
     remark_52},
    {"5.3", "Performance comparison with the highly optimized BVH, in frames per second", 6, 17,
     group_53, column_53, cell_53, none},
    {"5.4", "Traversal statistics of the BPH", 9, 11, group_54, column_54, cell_54, remark_54},
    {"5.5", "Memory overhead introduced by usage of treelets, in bytes (incomplete treelets)", 9,
     13, group_55, column_55, cell_55, remark_55},
    {"5.6", "Traversal overhead introduced by usage of treelets: packet-node intersections, 4x4",
     10, 12, group_56, column_56, cell_56, remark_56}};
/* clang-format on */

const printed_table *printed_of(unsigned table) {
    return &tables[table - 1];
}

const char *printed_cell(unsigned table, unsigned row, unsigned column) {
    const printed_table *t = printed_of(table);
    return t->cell[row * t->columns + column];
}

/* Digits alone, without commas; what follows them is where `end` points. */
static double number(const char *cell, const char **end, unsigned *decimals) {
    double value = 0.0, unit = 1.0;
    unsigned digits = 0, is_fraction = 0;
    for (; (*cell >= '0' && *cell <= '9') || *cell == ',' || *cell == '.'; cell++) {
        if (*cell == '.') {
            is_fraction = 1;
        } else if (*cell != ',') {
            value = 10.0 * value + (*cell - '0');
            unit *= is_fraction ? 10.0 : 1.0;
            *decimals += is_fraction;
            digits++;
        }
    }
    *end = cell;
    return digits > 0 ? value / unit : (double)NAN;
}

double printed_value(const char *cell) {
    const char *end;
    unsigned decimals = 0;
    const double value = number(cell, &end, &decimals);
    return *end == 'K' ? 1000.0 * value : value;
}

double printed_step(const char *cell) {
    const char *end;
    unsigned decimals = 0;
    const double value = number(cell, &end, &decimals);
    const double step = (*end == 'K' ? 1000.0 : 1.0) / (decimals == 0 ? 1.0 : pow(10.0, decimals));
    return isnan(value) ? value : step;
}

double printed_in_brackets(const char *cell) {
    const char *open = strchr(cell, '('), *end;
    unsigned decimals = 0;
    return open != NULL ? number(open + 1, &end, &decimals) : (double)NAN;
}

double printed_bytes(unsigned scene, unsigned column) {
    const double value = printed_value(printed_cell(1, scene, column));
    return scene == PRINTED_SHUTTLE && column == 5 ? 10.0 * value : value;
}

unsigned printed_intermediates(unsigned scene) {
    return (unsigned)printed_value(printed_cell(2, scene, 1)) / PRINTED_INTERMEDIATE_BYTES;
}

unsigned printed_nodes(unsigned scene) {
    return printed_scenes[scene].triangles - 1 - printed_intermediates(scene);
}
