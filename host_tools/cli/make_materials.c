/* make_materials - see make_materials.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/make_materials.h"

#include <stdio.h>
#include <string.h>

#include "host_tools/base/output.h"
#include "host_tools/scenes/scenes.h"

enum { PATH_ROOM = 4096, ENDING = 4, BODY = 80 }; /* BODY: triangles of the tray, and of a ball */

static const char library[] =
    "# wood, glass that is clear, green and blue, silver, gold, and varnished paint\n"
    "newmtl wood\nKd 0.46 0.27 0.13\nKs 0.08 0.08 0.08\nNs 20\nillum 2\n"
    "newmtl clear\nKd 0 0 0\nKs 0.7 0.7 0.7\nNs 500\nNi 1.5\nd 0\nillum 7\n"
    "newmtl green\nKd 0 0 0\nKs 0.7 0.7 0.7\nNs 500\nNi 1.5\nd 0\nTf 0.5 0.9 0.6\nillum 7\n"
    "newmtl blue\nKd 0 0 0\nKs 0.7 0.7 0.7\nNs 500\nNi 1.5\nd 0\nTf 0.45 0.65 0.95\nillum 7\n"
    "newmtl silver\nKd 0 0 0\nKs 0.9 0.9 0.92\nNs 600\nillum 3\n"
    "newmtl gold\nKd 0.05 0.03 0\nKs 0.95 0.7 0.3\nNs 400\nillum 3\n"
    "newmtl red\nKd 0.6 0.05 0.04\nKs 0.4 0.4 0.4\nNs 150\nillum 2\n"
    "newmtl yellow\nKd 0.75 0.5 0.06\nKs 0.4 0.4 0.4\nNs 150\nillum 2\n"
    "newmtl white\nKd 0.75 0.73 0.7\nKs 0.4 0.4 0.4\nNs 150\nillum 2\n";

/* Of the balls, in turns that lead nowhere: they are laid out along spirals. */
static const char *const turn[] = {"clear", "red",   "silver", "green", "yellow", "clear", "blue",
                                   "gold",  "white", "clear",  "red",   "green",  "silver"};

int make_materials_has_name(const char *out) {
    const size_t length = strlen(out);
    return length > ENDING && strcmp(out + length - ENDING, ".obj") == 0 &&
           out[length - ENDING - 1] != '/';
}

static int write_faces(const mesh *m, output *o, fail *f) {
    int status = 0;
    for (size_t i = 0; i < m->triangles && status == 0; i++) {
        const uint32_t *t = m->triangle + 3 * i;
        if (i % BODY == 0) {
            const size_t ball = i / BODY;
            status = output_print(
                o, f, "usemtl %s\n",
                ball == 0 ? "wood"
                          : turn[(ball * ball + ball / 5) % (sizeof turn / sizeof turn[0])]);
        }
        if (status == 0) {
            status = output_print(o, f, "f %u %u %u\n", (unsigned)t[0] + 1, (unsigned)t[1] + 1,
                                  (unsigned)t[2] + 1);
        }
    }
    return status;
}

static int write_all(const mesh *m, const char *stem, int length, output *o, fail *f) {
    int status = output_print(o, f, "mtllib %.*s.mtl\n", length, stem);
    for (size_t i = 0; i < m->vertices && status == 0; i++) {
        const float *v = m->vertex + 3 * i;
        status = output_print(o, f, "v %.9g %.9g %.9g\n", (double)v[0], (double)v[1], (double)v[2]);
    }
    return status == 0 ? write_faces(m, o, f) : status;
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
    if (output_print(o, f, "%s", library) != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

int make_materials(const mesh *m, const char *out, fail *f) {
    const char *slash = strrchr(out, '/'), *name = slash != NULL ? slash + 1 : out;
    output *o = output_open_text(out, f);
    if (o == NULL) {
        return -1;
    }
    if (write_all(m, name, (int)strlen(name) - ENDING, o, f) != 0 || write_library(out, f) != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}
