/* pack_textures - see pack_textures.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/pack_textures.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "engine/texture/directory.h"
#include "host_tools/app/note.h"
#include "host_tools/base/files.h"
#include "host_tools/base/heap.h"
#include "host_tools/base/input.h"
#include "host_tools/picture/picture_read.h"

void pack_textures_read(pack_textures *t, args *a, int materials, mesh_corners *c) {
    static const char *const choices[] = {"rgb565", "blocks", "none", NULL};
    const unsigned choice = (unsigned)args_choice(a, "--textures", choices, 0);
    const int moves = args_has(a, "--sequence");
    t->wanted =
        materials && choice < 2 && !moves && (!args_has(a, "--texcoords") || c->wants_texcoords);
    t->wants_texcoords = t->wanted && !c->wants_texcoords;
    c->wants_texcoords |= t->wants_texcoords;
    if (args_has(a, "--textures") && moves) {
        args_complain(a,
                      "--textures are of triangles that stay where they are; leave out "
                      "--sequence");
    }
    t->format = choice == 1 ? PLT_TEXTURE_BLOCKS : PLT_TEXTURE_RGB565;
    if (args_has(a, "--textures") && !materials) {
        args_complain(a, "--textures are of materials; add --materials keep");
    }
}

static int read_file(picture *p, const char *path, fail *f) {
    input in = {0};
    if (files_is_directory(path)) {
        return fail_set(f, path, "is a directory and no picture; correct the name in the MTL");
    }
    if (!files_is_file(path)) {
        return fail_set(f, path, "there is no such picture; correct the name in the MTL");
    }
    int status = input_read(&in, path, f);
    if (status == 0) {
        status = picture_read(p, in.bytes, in.size, path, f);
    }
    input_free(&in);
    if (status == 0 && (p->width > PLT_TEXTURE_SIDE_MOST || p->height > PLT_TEXTURE_SIDE_MOST)) {
        return fail_set(f, path, "a texture of %u x %u pixels is too large; make it %d at most",
                        p->width, p->height, PLT_TEXTURE_SIDE_MOST);
    }
    return status;
}

static int are_alike(const picture *a, const picture *b) {
    return a->width == b->width && a->height == b->height &&
           memcmp(a->rgb, b->rgb, 3 * (size_t)a->width * a->height) == 0;
}

/* The number of a picture that is the same, or its own, if it is new: then it is kept. */
static unsigned keep(pack_textures *t, picture *p) {
    unsigned i = 0;
    while (i < t->pictures && !are_alike(&t->picture[i], p)) {
        i++;
    }
    if (i < t->pictures) {
        picture_free(p);
    } else {
        t->picture[t->pictures++] = *p;
    }
    return i;
}

static int open_picture(pack_textures *t, const char *path, int strict, fail *f) {
    picture p = {NULL, 0, 0};
    fail why = {""};
    unsigned number = PACK_NO_PICTURE;
    int status = read_file(&p, path, &why);
    if (status == 0 && t->pictures == PLT_TEXTURES_MOST) {
        status =
            fail_set(&why, path, "there are more than %d textures; merge some", PLT_TEXTURES_MOST);
    }
    if (status == 0) {
        number = keep(t, &p);
    } else {
        picture_free(&p);
        if (strict) {
            return fail_set(f, NULL, "%s, or leave out --strict", why.text);
        }
        fprintf(stderr, "%s; its material is used without it\n", why.text);
    }
    t->file[t->files++] = (pack_picture){path, number};
    return 0;
}

static unsigned find(const pack_textures *t, const char *path) {
    for (size_t i = 0; i < t->files; i++) {
        if (strcmp(t->file[i].path, path) == 0) {
            return (unsigned)i;
        }
    }
    return (unsigned)t->files;
}

/* Materials that some triangle has: a byte each. NULL: memory is out. */
static unsigned char *used_by(const mesh_materials *m) {
    unsigned char *used = heap_get_zeroed(m->count);
    for (size_t i = 0; i < m->filled && used != NULL; i++) {
        used[m->of[i]] = 1;
    }
    return used;
}

int pack_textures_open(pack_textures *t, const mesh_materials *m, int strict, fail *f) {
    unsigned char *used = t->wanted ? used_by(m) : NULL;
    int status = 0;
    if (!t->wanted) {
        return 0;
    }
    t->file = heap_get(m->count * sizeof *t->file);
    t->picture = heap_get(PLT_TEXTURES_MOST * sizeof *t->picture);
    if (used == NULL || t->file == NULL || t->picture == NULL) {
        status = fail_set(f, NULL, "out of memory; use a larger machine");
    }
    for (size_t i = 0; i < m->count && status == 0; i++) {
        const char *path = m->material[i].map.path;
        if (path != NULL && used[i] && find(t, path) == t->files) {
            status = open_picture(t, path, strict, f);
        }
    }
    heap_drop(used);
    return status;
}

void pack_textures_settle(pack_textures *t, mesh_corners *c, const char *name) {
    if (!t->wanted) {
        return;
    }
    if (t->pictures > 0 && c->texcoords == 0) {
        fprintf(stderr, "%s: left out its pictures, as it has no texture coordinates\n", name);
        pack_textures_free(t);
    }
    if (t->pictures == 0 && t->wants_texcoords) {
        if (c->texcoords > 0) {
            fprintf(stderr, "%s: left out its texture coordinates, as it has no picture\n", name);
        }
        c->wants_texcoords = 0;
        for (int k = 0; k < 2; k++) {
            heap_drop(c->texcoord[k]);
            c->texcoord[k] = NULL;
        }
        c->texcoords = 0;
    }
}

static float limited(float x) {
    return x > -PLT_PAINT_MOST ? (x < PLT_PAINT_MOST ? x : PLT_PAINT_MOST) : -PLT_PAINT_MOST;
}

static texture_paint paint_of(const pack_textures *t, const material_map *map) {
    texture_paint p = {.texture = 0, .scale = {1, 1}};
    const unsigned file = map->path != NULL ? find(t, map->path) : (unsigned)t->files;
    if (file < t->files && t->file[file].number != PACK_NO_PICTURE) {
        p.texture = 1 + t->file[file].number;
        p.clamp = map->clamp;
        for (int i = 0; i < 2; i++) {
            p.scale[i] = limited(map->scale[i]);
            p.offset[i] = limited(map->offset[i]);
        }
    }
    return p;
}

int pack_textures_add(pack_textures *t, const mesh_materials *m, const uint16_t *number,
                      packed *image, const char *name, fail *f) {
    texture_paint paint[PLT_PAINTS_MOST];
    texture_set set = {
        .picture = t->picture, .pictures = t->pictures, .paint = paint, .format = t->format};
    if (t->pictures == 0) {
        return 0;
    }
    for (size_t i = 0; i < m->count; i++) {
        if (number[i] != MATERIAL_UNUSED) {
            paint[number[i]] = paint_of(t, &m->material[i].map);
            set.paints += 1;
        }
    }
    return texture_section_add(image, &set, name, &t->stats, f);
}

static void say_left(const mesh_materials *m, const char *name) {
    char list[256] = "";
    size_t length = 0;
    for (unsigned bit = 0; materials_map_left(bit) != NULL; bit++) {
        if ((m->maps_left >> bit & 1u) != 0) {
            length += (size_t)snprintf(list + length, sizeof list - length, "%s%s",
                                       length > 0 ? ", " : "", materials_map_left(bit));
        }
    }
    if (length > 0) {
        fprintf(stderr, "%s: of its materials' pictures and their options these are left out: %s\n",
                name, list);
    }
}

void pack_textures_say(const pack_textures *t, const mesh_materials *m, const char *name) {
    say_left(m, name);
    if (t->stats.bytes > 0) {
        note("textures: %" PRIu32 ", %" PRIu32 " bytes, %.2f per texel, %.1f dB", t->stats.textures,
             t->stats.bytes, (double)t->stats.bytes / (double)t->stats.texels, t->stats.psnr);
    }
}

void pack_textures_free(pack_textures *t) {
    for (unsigned i = 0; i < t->pictures; i++) {
        picture_free(&t->picture[i]);
    }
    heap_drop(t->picture);
    heap_drop(t->file);
    *t = (pack_textures){.wants_texcoords = t->wants_texcoords};
}
