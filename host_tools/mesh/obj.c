/* obj - reads vertices and faces of Wavefront OBJ
 *
 * `v` and `f` are read, and `fo`, which was `f` before version 3.0; `vn`, `vt`, and the colours
 * that some programs write behind a vertex, `mtllib` and `usemtl`, if someone wants them. All other
 * keywords are passed over; what they would draw is counted, and so are lines of no known keyword,
 * and of `call` and `csh`, which would run other files and commands. A face may use a vertex that
 * only comes later. Vertices are counted from 1; a negative number counts back from the last vertex
 * so far.
 *
 * Source: Wavefront Technologies, Advanced Visualizer Manual, appendix B1,
 * Object Files, 1995.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/intake.h"
#include "host_tools/mesh/mtl.h"
#include "host_tools/mesh/readers.h"
#include "host_tools/mesh/scan.h"

typedef struct reader {
    intake in;
    scan text;
    size_t known_lines;
} reader;

/* Keywords, and what is counted as left out when a line begins with one. */
static const struct {
    const char *name;
    report_item item; /* REPORT_ITEMS: nothing that anyone would miss */
} KNOWN[] = {
    {"v", REPORT_ITEMS},           {"f", REPORT_ITEMS},          {"g", REPORT_ITEMS},
    {"o", REPORT_ITEMS},           {"s", REPORT_ITEMS},          {"mg", REPORT_ITEMS},
    {"mtllib", REPORT_ITEMS},      {"maplib", REPORT_ITEMS},     {"cstype", REPORT_ITEMS},
    {"deg", REPORT_ITEMS},         {"bmat", REPORT_ITEMS},       {"step", REPORT_ITEMS},
    {"parm", REPORT_ITEMS},        {"trim", REPORT_ITEMS},       {"hole", REPORT_ITEMS},
    {"scrv", REPORT_ITEMS},        {"sp", REPORT_ITEMS},         {"end", REPORT_ITEMS},
    {"con", REPORT_ITEMS},         {"vp", REPORT_ITEMS},         {"lod", REPORT_ITEMS},
    {"fo", REPORT_ITEMS},          {"vn", REPORT_NORMALS},       {"vt", REPORT_TEXTURES},
    {"bevel", REPORT_ITEMS},       {"c_interp", REPORT_ITEMS},   {"d_interp", REPORT_ITEMS},
    {"shadow_obj", REPORT_ITEMS},  {"trace_obj", REPORT_ITEMS},  {"ctech", REPORT_ITEMS},
    {"stech", REPORT_ITEMS},       {"res", REPORT_ITEMS},        {"bzp", REPORT_CURVES},
    {"bsp", REPORT_CURVES},        {"cdc", REPORT_CURVES},       {"cdp", REPORT_CURVES},
    {"call", REPORT_UNREAD_LINES}, {"csh", REPORT_UNREAD_LINES}, {"p", REPORT_POINTS},
    {"l", REPORT_LINES},           {"curv", REPORT_CURVES},      {"curv2", REPORT_CURVES},
    {"surf", REPORT_CURVES},       {"usemtl", REPORT_MATERIALS}, {"usemap", REPORT_MATERIALS},
};

/* Its number in KNOWN, or -1. */
static int find_known(word w) {
    for (size_t i = 0; i < sizeof KNOWN / sizeof KNOWN[0]; i++) {
        if (word_is(w, KNOWN[i].name)) {
            return (int)i;
        }
    }
    return -1;
}

static int is_text(word w) {
    for (size_t i = 0; i < w.length; i++) {
        if ((unsigned char)w.text[i] < 0x20) {
            return 0;
        }
    }
    return 1;
}

/* Up to the end of the line, which may be that of another that it is joined to. */
static void pass_over(reader *r) {
    while (!scan_line_done(&r->text) && *r->text.at != '#') {
        scan_word(&r->text);
    }
}

static int fail_coordinate(reader *r) {
    const word w = scan_word(&r->text);
    if (w.length == 0) {
        return intake_fail(&r->in, "a coordinate is missing; correct the line");
    }
    return intake_fail(&r->in, "'%.*s' where a coordinate belongs; correct the line",
                       WORD_SHOWN(w));
}

/* Numbers that follow z are not used: a weight, or three of a colour, or both. */
static int read_colour(reader *r, double colour[3]) {
    float number;
    double all[4];
    int count = 0;
    while (count < 4 && !scan_line_done(&r->text) && scan_float(&r->text, &number) == 0) {
        all[count++] = (double)number;
    }
    for (int i = 0; i < 3 && count >= 3; i++) {
        colour[i] = all[count - 3 + i]; /* behind the weight, if there is one */
    }
    return count >= 3;
}

static int read_vertex(reader *r) {
    real position[3];
    for (int axis = 0; axis < 3; axis++) {
        if (scan_real(&r->text, &position[axis]) != 0) {
            return fail_coordinate(r);
        }
    }
    double colour[3];
    const int has_colour = read_colour(r, colour), kept = intake_wants_colours(&r->in);
    r->in.count[REPORT_COLOURS] += has_colour && !kept;
    return intake_vertex(&r->in, position) != 0 ? -1
           : has_colour && kept                 ? intake_colour(&r->in, colour, 1)
                                                : 0;
}

static int read_normal(reader *r) {
    double normal[3];
    for (int axis = 0; axis < 3; axis++) {
        real number;
        if (scan_real(&r->text, &number) != 0) {
            return fail_coordinate(r);
        }
        normal[axis] = number.wide;
    }
    r->in.corners.is_numbered[NAMED_NORMAL] = 1;
    return intake_normal(&r->in, normal);
}

/* u, v and w, of which the last two are optional, and w is not used. */
static int read_texcoord(reader *r) {
    double texcoord[2] = {0, 0};
    for (int axis = 0; axis < 2; axis++) {
        real number;
        if (axis > 0 && (scan_line_done(&r->text) || *r->text.at == '#')) {
            break;
        }
        if (scan_real(&r->text, &number) != 0) {
            return fail_coordinate(r);
        }
        texcoord[axis] = number.wide;
    }
    pass_over(r);
    r->in.corners.is_numbered[NAMED_TEXCOORD] = 1;
    return intake_texcoord(&r->in, texcoord);
}

/* The number behind so many slashes; of length 0 if there is none. */
static word number_behind(word whole, size_t slashes) {
    size_t at = 0, end;
    while (at < whole.length && slashes > 0) {
        slashes -= whole.text[at++] == '/';
    }
    for (end = at; end < whole.length && whole.text[end] != '/'; end++) {
    }
    return (word){whole.text + at, slashes > 0 ? 0 : end - at};
}

/* What a corner names behind its vertex, if someone wants that. */
static int read_corner_name(reader *r, word whole, int kind, int is_wanted) {
    const word number = number_behind(whole, kind == NAMED_NORMAL ? 2 : 1);
    int64_t written;
    r->in.named[kind] = CORNER_UNNAMED;
    if (number.length == 0 || !is_wanted) {
        return 0;
    }
    if (word_integer(number, &written) != 0) {
        return intake_fail(&r->in, "'%.*s' where %s number belongs; correct the line",
                           WORD_SHOWN(whole),
                           kind == NAMED_NORMAL ? "a normal's" : "a texture coordinate's");
    }
    return intake_name_written(&r->in, kind, written);
}

/* "7", "7/1", "7/1/3" or "7//3": a vertex, texture coordinates and a normal. */
static int read_corner_number(reader *r, int64_t *written) {
    const word whole = scan_word(&r->text);
    if (read_corner_name(r, whole, NAMED_TEXCOORD, intake_wants_texcoords(&r->in)) != 0 ||
        read_corner_name(r, whole, NAMED_NORMAL, intake_wants_normals(&r->in)) != 0) {
        return -1;
    }
    if (word_integer(number_behind(whole, 0), written) != 0) {
        return intake_fail(&r->in, "'%.*s' where a vertex number belongs; correct the line",
                           WORD_SHOWN(whole));
    }
    return 0;
}

static int read_corner(reader *r, chain *c) {
    int64_t written;
    if (read_corner_number(r, &written) != 0) {
        return -1;
    }
    const int64_t here = (int64_t)intake_vertices(&r->in);
    int64_t vertex = written > 0 ? written - 1 : INTAKE_MISSING;
    if (written < 0 && written >= -here) {
        vertex = here + written;
    }
    return intake_corner(&r->in, c, vertex, written);
}

static int read_face(reader *r) {
    chain c = intake_chain(&r->in, 0);
    while (!scan_line_done(&r->text) && *r->text.at != '#') {
        if (read_corner(r, &c) != 0) {
            return -1;
        }
    }
    return intake_polygon_end(&r->in, &c);
}

static void count_line(reader *r, int known, int is_kept) {
    const report_item item = known >= 0 ? KNOWN[known].item : REPORT_UNREAD_LINES;
    r->known_lines += known >= 0;
    if (item != REPORT_ITEMS && !is_kept) {
        r->in.count[item]++;
    }
}

/* What follows is a name, or the keyword is none of OBJ. */
static int may_be_path(word w, int known) {
    static const char *const NAMED[] = {"g",      "o",    "mtllib", "maplib",     "usemtl",
                                        "usemap", "call", "csh",    "shadow_obj", "trace_obj"};
    for (size_t i = 0; i < sizeof NAMED / sizeof NAMED[0]; i++) {
        if (word_is(w, NAMED[i])) {
            return 1;
        }
    }
    return known < 0;
}

static int fail_materials(reader *r) {
    return intake_fail(&r->in, "out of memory, or more than 65534 materials; split the mesh");
}

/* The rest of the line: a name, in which there may be blanks. */
static word rest_of_line(reader *r) {
    word w = {NULL, 0};
    while (!scan_line_done(&r->text)) {
        const word next = scan_word(&r->text);
        w.text = w.length == 0 ? next.text : w.text;
        w.length = (size_t)(next.text + next.length - w.text);
    }
    return w;
}

/* What the faces that follow are made of, or where materials are defined. */
static int read_material(reader *r, int is_library) {
    mesh_materials *m = r->in.m->materials;
    const word name = rest_of_line(r);
    if (is_library) {
        return mtl_read_beside(m, r->in.path, name.text, name.length) == 0 ? 0 : fail_materials(r);
    }
    const int number = name.length == 0 ? 0 : materials_find(m, name.text, name.length);
    return number >= 0 && materials_use(m, r->in.m->triangles, number) == 0 ? 0 : fail_materials(r);
}

/* A comment or a name may end in a backslash (a path): it joins no lines. */
static int read_line(reader *r) {
    r->in.at = (location){.line = r->text.line};
    r->text.continued = 0;
    if (scan_line_done(&r->text) || *r->text.at == '#') {
        return 0;
    }
    const word w = scan_word(&r->text);
    const int is_vertex = word_is(w, "v"), is_face = word_is(w, "f") || word_is(w, "fo");
    const int is_normal = word_is(w, "vn") && intake_wants_normals(&r->in); /* else passed over */
    const int is_texcoord = word_is(w, "vt") && intake_wants_texcoords(&r->in);
    if (!is_text(w)) {
        return intake_fail(&r->in, "'%.*s' is no text; check that this is an OBJ file",
                           WORD_SHOWN(w));
    }
    const int known = find_known(w);
    r->text.continued = is_vertex || is_face || !may_be_path(w, known);
    const int is_library = word_is(w, "mtllib");
    const int is_material =
        r->in.m->materials != NULL && (is_library || word_is(w, "usemtl")); /* else passed over */
    count_line(r, known, is_normal || is_texcoord || is_material);
    if (is_normal || is_texcoord) {
        return is_normal ? read_normal(r) : read_texcoord(r);
    }
    if (is_material) {
        return read_material(r, is_library);
    }
    if (!is_vertex && !is_face) {
        pass_over(r);
        return 0;
    }
    return is_vertex ? read_vertex(r) : read_face(r);
}

static int read_lines(reader *r) {
    do {
        if (read_line(r) != 0) {
            return -1;
        }
    } while (scan_next_line(&r->text));
    if (r->known_lines == 0) {
        return intake_fail(&r->in, "no line up to here is one of OBJ; check the file's format");
    }
    return 0;
}

int obj_is(const input *in) {
    scan s = scan_begin_filled(in->bytes, in->size);
    while ((scan_line_done(&s) || *s.at == '#') && scan_next_line(&s)) {
    }
    return find_known(scan_word(&s)) >= 0;
}

int obj_read(mesh *m, const input *in, mesh_report *report, fail *f) {
    reader r = {
        .in = intake_begin(m, in->path, report, f),
        .text = scan_begin_filled(in->bytes, in->size),
    };
    mesh_materials *materials = m->materials;
    int result = materials == NULL || materials_begin(materials, m->triangles) == 0
                     ? read_lines(&r)
                     : fail_materials(&r);
    if (result == 0 && materials != NULL && materials_end(materials, in->path, m->triangles) != 0) {
        result = fail_materials(&r);
    }
    if (result == 0) {
        result = intake_finish(&r.in);
    } else {
        intake_undo(&r.in);
    }
    return result;
}
