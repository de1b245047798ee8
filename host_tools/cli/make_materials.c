/* make_materials - see make_materials.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/make_materials.h"

#include <stdio.h>
#include <string.h>

#include "host_tools/base/output.h"
#include "host_tools/scenes/still.h"

enum { PATH_ROOM = 4096, ENDING = 4 };

/* What a paint is of, in the order of enum still_paint; browns are made. */
typedef struct look {
    const char *name, *text;
} look;

static const look looks[STILL_PAINTS] = {
    [STILL_TABLE] = {"table", "Kd 0.23 0.28 0.31\nillum 1\n"},
    [STILL_GAP] = {"gap", "Kd 0.07 0.035 0.018\nillum 1\n"},
    [STILL_CLEAR] = {"clear",
                     "Kd 0 0 0\nKs 0.8 0.8 0.8\nNs 600\nNi 1.5\nd 0\n"
                     "Tf 0.96 0.98 0.97\nillum 7\n"},
    [STILL_GREEN] = {"green",
                     "Kd 0 0 0\nKs 0.8 0.8 0.8\nNs 600\nNi 1.5\nd 0\n"
                     "Tf 0.36 0.9 0.48\nillum 7\n"},
    [STILL_BLUE] = {"blue",
                    "Kd 0 0 0\nKs 0.8 0.8 0.8\nNs 600\nNi 1.5\nd 0\n"
                    "Tf 0.22 0.56 0.97\nillum 7\n"},
    [STILL_AMBER] = {"amber",
                     "Kd 0 0 0\nKs 0.8 0.8 0.8\nNs 600\nNi 1.5\nd 0\n"
                     "Tf 0.97 0.66 0.14\nillum 7\n"},
    [STILL_VIOLET] = {"violet",
                      "Kd 0 0 0\nKs 0.8 0.8 0.8\nNs 600\nNi 1.5\nd 0\n"
                      "Tf 0.78 0.34 0.78\nillum 7\n"},
    [STILL_SILVER] = {"silver", "Kd 0 0 0\nKs 0.92 0.93 0.95\nNs 800\nillum 3\n"},
    [STILL_GOLD] = {"gold", "Kd 0.05 0.03 0\nKs 0.98 0.74 0.32\nNs 500\nillum 3\n"},
    [STILL_RED] = {"red", "Kd 0.62 0.035 0.03\nKs 0.6 0.6 0.6\nNs 300\nillum 2\n"},
    [STILL_YELLOW] = {"yellow", "Kd 0.85 0.52 0.03\nKs 0.6 0.6 0.6\nNs 300\nillum 2\n"},
    [STILL_WHITE] = {"white", "Kd 0.8 0.78 0.73\nKs 0.6 0.6 0.6\nNs 300\nillum 2\n"},
    [STILL_TURQUOISE] = {"turquoise", "Kd 0.02 0.42 0.42\nKs 0.6 0.6 0.6\nNs 300\nillum 2\n"},
    [STILL_BLACK] = {"black", "Kd 0.015 0.015 0.02\nKs 0.7 0.7 0.7\nNs 300\nillum 2\n"},
    [STILL_VANE] = {"vane_red", "Kd 0.85 0.08 0.05\nillum 1\n"},
    [STILL_VANE + 1] = {"vane_yellow", "Kd 0.95 0.68 0.05\nillum 1\n"},
    [STILL_VANE + 2] = {"vane_blue", "Kd 0.06 0.2 0.8\nillum 1\n"},
    [STILL_VANE + 3] = {"vane_white", "Kd 0.9 0.9 0.88\nillum 1\n"},
};

static void name_of(unsigned paint, char to[16]) {
    if (paint >= STILL_BROWN && paint < STILL_RIM) {
        snprintf(to, 16, "board%u", (paint - STILL_BROWN) % 100);
    } else if (paint >= STILL_RIM && paint < STILL_CLEAR) {
        snprintf(to, 16, "rim%u", (paint - STILL_RIM) % 100);
    } else {
        snprintf(to, 16, "%s", looks[paint].name);
    }
}

int make_materials_has_name(const char *out) {
    const size_t length = strlen(out);
    return length > ENDING && strcmp(out + length - ENDING, ".obj") == 0 &&
           out[length - ENDING - 1] != '/';
}

static int write_faces(const painted *p, output *o, fail *f) {
    int status = 0;
    for (size_t i = 0; i < p->m.triangles && status == 0; i++) {
        const uint32_t *t = p->m.triangle + 3 * i;
        if (i == 0 || p->paint[i] != p->paint[i - 1]) {
            char name[16];
            name_of(p->paint[i], name);
            status = output_print(o, f, "usemtl %s\n", name);
        }
        if (status == 0) {
            status = output_print(o, f, "f %u %u %u\n", (unsigned)t[0] + 1, (unsigned)t[1] + 1,
                                  (unsigned)t[2] + 1);
        }
    }
    return status;
}

static int write_all(const painted *p, const char *stem, int length, output *o, fail *f) {
    int status = output_print(o, f, "mtllib %.*s.mtl\n", length, stem);
    for (size_t i = 0; i < p->m.vertices && status == 0; i++) {
        const float *v = p->m.vertex + 3 * i;
        status = output_print(o, f, "v %.9g %.9g %.9g\n", (double)v[0], (double)v[1], (double)v[2]);
    }
    return status == 0 ? write_faces(p, o, f) : status;
}

/* Browns from dark to light, of boards and, redder, of the rim; with a little varnish. */
static int write_brown(unsigned paint, output *o, fail *f) {
    const int rim = paint >= STILL_RIM;
    const double light = rim ? (double)(paint - STILL_RIM) / (STILL_RIMS - 1)
                             : (double)(paint - STILL_BROWN) / (STILL_BROWNS - 1);
    const double scale = rim ? 0.20 + 0.12 * light : 0.24 + 0.28 * light;
    return output_print(o, f, "Kd %.4f %.4f %.4f\nKs 0.06 0.06 0.06\nNs 30\nillum 2\n", scale,
                        scale * (rim ? 0.42 + 0.04 * light : 0.53 + 0.09 * light),
                        scale * (rim ? 0.19 + 0.03 * light : 0.20 + 0.10 * light));
}

static int write_looks(output *o, fail *f) {
    int status = output_print(o, f, "# a table, wood, glass, metal, varnished paint\n");
    for (unsigned i = 0; i < STILL_PAINTS && status == 0; i++) {
        char name[16];
        name_of(i, name);
        status = output_print(o, f, "newmtl %s\n", name);
        if (status == 0) {
            status = looks[i].text != NULL ? output_print(o, f, "%s", looks[i].text)
                                           : write_brown(i, o, f);
        }
    }
    return status;
}

static int write_library(const char *out, fail *f) {
    char path[PATH_ROOM];
    const int n = snprintf(path, sizeof path, "%.*s.mtl", (int)strlen(out) - ENDING, out);
    if (n < 0 || n >= PATH_ROOM) {
        return fail_set(f, out, "the name is too long; choose a shorter one");
    }
    output *o = output_open_text(path, f);
    if (o == NULL) {
        return -1;
    }
    if (write_looks(o, f) != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

int make_materials(const painted *p, const char *out, fail *f) {
    const char *slash = strrchr(out, '/'), *name = slash != NULL ? slash + 1 : out;
    output *o = output_open_text(out, f);
    if (o == NULL) {
        return -1;
    }
    if (write_all(p, name, (int)strlen(name) - ENDING, o, f) != 0 || write_library(out, f) != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}
