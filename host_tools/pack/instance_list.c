/* instance_list - see instance_list.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/instance_list.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "engine/image/items.h"
#include "host_tools/base/heap.h"
#include "host_tools/mesh/scan.h"

enum { BODIES, INSTANCES, SETTINGS, FRAMES_MOST = 1000000 };

/* Names with their numbers, looked up by what they are: open addressing. */
typedef struct name_table {
    uint32_t *slot; /* number and 1; 0: free */
    uint32_t slots; /* a power of two, at least twice the names */
} name_table;

typedef struct reader {
    instance_list *l;
    scan text;
    name_table bodies, instances;
    int64_t frame; /* of the last line; -1: none */
    fail *f;
} reader;

#define FAIL_LINE(r, ...) fail_line(r, (r)->text.line, __VA_ARGS__)

static int fail_line(reader *r, size_t line, const char *format, word w) {
    char text[400];
    snprintf(text, sizeof text, format, WORD_SHOWN(w));
    return fail_set(r->f, r->l->in.path, "line %zu: %s", line, text);
}

static int out_of_memory(reader *r) {
    return fail_set(r->f, r->l->in.path, "out of memory; close other programs");
}

/* ---- names ------------------------------------------------------------------------ */

static uint32_t hash_of(word w) {
    uint32_t hash = 2166136261u; /* FNV-1a */
    for (size_t i = 0; i < w.length; i++) {
        hash = (hash ^ (unsigned char)w.text[i]) * 16777619u;
    }
    return hash;
}

/* The slot of a name, or the free one where it would be. */
static uint32_t *slot_of(const name_table *t, const instance_name *names, word w) {
    uint32_t at = hash_of(w) & (t->slots - 1);
    for (;; at = (at + 1) & (t->slots - 1)) {
        const instance_name *n = &names[t->slot[at] > 0 ? t->slot[at] - 1 : 0];
        if (t->slot[at] == 0 || (n->length == w.length && memcmp(n->text, w.text, w.length) == 0)) {
            return &t->slot[at];
        }
    }
}

/* -1: there is none. */
static int64_t find(const name_table *t, const instance_name *names, word w) {
    return t->slots > 0 ? (int64_t)*slot_of(t, names, w) - 1 : -1;
}

/* Makes room for one name more. */
static int grow_table(name_table *t, const instance_name *names, uint32_t count) {
    if (2 * (count + 1) <= t->slots) {
        return 0;
    }
    const name_table larger = {heap_get_zeroed(4 * (uint64_t)(t->slots > 0 ? 2 * t->slots : 64)),
                               t->slots > 0 ? 2 * t->slots : 64};
    if (larger.slot == NULL) {
        return -1;
    }
    for (uint32_t i = 0; i < count; i++) {
        const word w = {names[i].text, names[i].length};
        *slot_of(&larger, names, w) = i + 1;
    }
    heap_drop(t->slot);
    *t = larger;
    return 0;
}

/* Room for an array that has `room` items and no place for one more. */
static size_t more_room(size_t room) {
    return room + room / 2 + 16;
}

static int make_room_for_body(instance_list *l) {
    if (l->bodies < l->room[BODIES]) {
        return 0;
    }
    const size_t room = more_room(l->room[BODIES]);
    instance_name *body = heap_resize(l->body, (uint64_t)room * sizeof *body);
    l->body = body != NULL ? body : l->body;
    instance_name *mesh = heap_resize(l->mesh, (uint64_t)room * sizeof *mesh);
    l->mesh = mesh != NULL ? mesh : l->mesh;
    l->room[BODIES] = body != NULL && mesh != NULL ? room : l->room[BODIES];
    return l->bodies < l->room[BODIES] ? 0 : -1;
}

static int make_room_for_instance(instance_list *l) {
    if (l->instances < l->room[INSTANCES]) {
        return 0;
    }
    const size_t room = more_room(l->room[INSTANCES]);
    instance_name *instance = heap_resize(l->instance, (uint64_t)room * sizeof *instance);
    l->instance = instance != NULL ? instance : l->instance;
    uint32_t *body_of = heap_resize(l->body_of, (uint64_t)room * sizeof *body_of);
    l->body_of = body_of != NULL ? body_of : l->body_of;
    l->room[INSTANCES] = instance != NULL && body_of != NULL ? room : l->room[INSTANCES];
    return l->instances < l->room[INSTANCES] ? 0 : -1;
}

static int make_room_for_setting(instance_list *l) {
    if (l->settings < l->room[SETTINGS]) {
        return 0;
    }
    const size_t room = more_room(l->room[SETTINGS]);
    instance_setting *setting = heap_resize(l->setting, (uint64_t)room * sizeof *setting);
    if (setting == NULL) {
        return -1;
    }
    l->setting = setting;
    l->room[SETTINGS] = room;
    return 0;
}

/* ---- lines ------------------------------------------------------------------------ */

static const word NO_WORD = {"", 0};

static word next_word(reader *r) {
    return scan_line_done(&r->text) || *r->text.at == '#' ? NO_WORD : scan_word(&r->text);
}

static instance_name name_at(const reader *r, word w) {
    return (instance_name){w.text, w.length, r->text.line};
}

static int line_ends(reader *r) {
    const word more = next_word(r);
    return more.length == 0 ? 0
                            : FAIL_LINE(r, "'%.*s' is too much on this line; leave it out", more);
}

static int read_body(reader *r) {
    instance_list *l = r->l;
    const word name = next_word(r), mesh = next_word(r);
    if (mesh.length == 0) {
        return FAIL_LINE(r, "a body has a name and a mesh; write body NAME MESH", NO_WORD);
    }
    if (find(&r->bodies, l->body, name) >= 0) {
        return FAIL_LINE(r, "there is a body '%.*s' already; choose another name", name);
    }
    if (l->bodies == PLT_INSTANCES_MOST) {
        return FAIL_LINE(r, "more than 65536 bodies; make them fewer", NO_WORD);
    }
    if (make_room_for_body(l) != 0 || grow_table(&r->bodies, l->body, l->bodies) != 0) {
        return out_of_memory(r);
    }
    l->body[l->bodies] = name_at(r, name);
    l->mesh[l->bodies] = name_at(r, mesh);
    *slot_of(&r->bodies, l->body, name) = l->bodies + 1;
    l->bodies++;
    return line_ends(r);
}

static int read_instance(reader *r) {
    instance_list *l = r->l;
    const word name = next_word(r), body = next_word(r);
    if (body.length == 0) {
        return FAIL_LINE(r, "an instance has a name and a body; write instance NAME BODY", NO_WORD);
    }
    const int64_t of = find(&r->bodies, l->body, body);
    if (of < 0) {
        return FAIL_LINE(r, "there is no body '%.*s' above; write body NAME MESH first", body);
    }
    if (find(&r->instances, l->instance, name) >= 0) {
        return FAIL_LINE(r, "there is an instance '%.*s' already; choose another name", name);
    }
    if (l->instances == PLT_INSTANCES_MOST) {
        return FAIL_LINE(r, "more than 65536 instances; make them fewer", NO_WORD);
    }
    if (make_room_for_instance(l) != 0 ||
        grow_table(&r->instances, l->instance, l->instances) != 0) {
        return out_of_memory(r);
    }
    l->instance[l->instances] = name_at(r, name);
    l->body_of[l->instances] = (uint32_t)of;
    *slot_of(&r->instances, l->instance, name) = l->instances + 1;
    l->instances++;
    return line_ends(r);
}

static int read_number(reader *r) {
    const word w = next_word(r);
    int64_t frame;
    if (word_integer(w, &frame) != 0 || frame < 0 || frame >= FRAMES_MOST) {
        return FAIL_LINE(r, "'%.*s' is no frame; write a whole number, 0 to 999999", w);
    }
    if (frame != r->frame && frame != r->frame + 1) {
        return FAIL_LINE(r, "frame %.*s does not follow the one before; count from 0 without gaps",
                         w);
    }
    r->frame = frame;
    r->l->frames = (uint32_t)frame + 1;
    return 0;
}

static int read_matrix(reader *r, word name, instance_setting *s) {
    for (int i = 0; i < PLT_MATRIX_FLOATS; i++) {
        const int more = !scan_line_done(&r->text) && *r->text.at != '#';
        if (!more || scan_float(&r->text, &s->matrix[i]) != 0 || !isfinite(s->matrix[i])) {
            return FAIL_LINE(r, "the matrix of '%.*s' is not 12 numbers; write three rows of four",
                             name);
        }
    }
    return line_ends(r);
}

static int read_frame(reader *r) {
    instance_list *l = r->l;
    if (read_number(r) != 0) {
        return -1;
    }
    const word name = next_word(r);
    if (name.length == 0) {
        return 0;
    }
    const int64_t of = find(&r->instances, l->instance, name);
    if (of < 0) {
        return FAIL_LINE(r, "there is no instance '%.*s' above; write instance NAME BODY first",
                         name);
    }
    if (make_room_for_setting(l) != 0) {
        return out_of_memory(r);
    }
    instance_setting *s = &l->setting[l->settings++];
    *s = (instance_setting){(uint32_t)r->frame, (uint32_t)of, r->text.line, {0}};
    return read_matrix(r, name, s);
}

static int read_line(reader *r) {
    const word w = next_word(r);
    if (w.length == 0) {
        return 0;
    }
    if (word_is(w, "body")) {
        return read_body(r);
    }
    if (word_is(w, "instance")) {
        return read_instance(r);
    }
    return word_is(w, "frame")
               ? read_frame(r)
               : FAIL_LINE(r, "'%.*s' begins no line; write body, instance or frame", w);
}

int instance_list_read(instance_list *l, const char *path, fail *f) {
    *l = (instance_list){.frames = 1};
    if (input_read(&l->in, path, f) != 0) {
        return -1;
    }
    reader r = {.l = l, .text = scan_begin(l->in.bytes, l->in.size), .frame = -1, .f = f};
    int status;
    do {
        status = read_line(&r);
    } while (status == 0 && scan_next_line(&r.text));
    if (status == 0 && l->instances == 0) {
        status = fail_set(f, path, "places nothing; write body NAME MESH and instance NAME BODY");
    }
    heap_drop(r.bodies.slot);
    heap_drop(r.instances.slot);
    return status;
}

char *instance_list_mesh(const instance_list *l, uint32_t body) {
    const instance_name *n = &l->mesh[body];
    const char *slash = strrchr(l->in.path, '/');
    const size_t folder = n->text[0] != '/' && slash ? (size_t)(slash - l->in.path) + 1 : 0;
    char *path = heap_get(folder + n->length + 1);
    if (path != NULL) {
        memcpy(path, l->in.path, folder);
        memcpy(path + folder, n->text, n->length);
        path[folder + n->length] = '\0';
    }
    return path;
}

void instance_list_free(instance_list *l) {
    heap_drop(l->body);
    heap_drop(l->mesh);
    heap_drop(l->instance);
    heap_drop(l->body_of);
    heap_drop(l->setting);
    if (l->in.bytes != NULL) {
        input_free(&l->in);
    }
    *l = (instance_list){.frames = 0};
}
