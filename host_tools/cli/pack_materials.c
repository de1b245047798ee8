/* pack_materials - see pack_materials.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/pack_materials.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/app/note.h"
#include "host_tools/base/heap.h"
#include "host_tools/cli/pack_lines.h"

void pack_materials_read(pack_materials *p, args *a, mesh_corners *corners) {
    static const char *const choices[] = {"none", "keep", NULL};
    p->wanted = (int)args_choice(a, "--materials", choices, 0);
    p->strict = args_has(a, "--strict");
    pack_textures_read(&p->textures, a, p->wanted, corners);
    if (p->strict && !p->wanted) {
        args_complain(a, "--strict is about materials; add --materials keep");
    }
    if (p->wanted && args_has(a, "--instances")) {
        args_complain(a, "--materials are not of instances; leave out one of them");
    }
    if (p->wanted && strcmp(args_text(a, "--nodes", "thesis"), "compact") == 0 &&
        (strcmp(args_text(a, "--build", "host"), "host") != 0 ||
         strcmp(args_text(a, "--numbers", "keep"), "keep") != 0)) {
        args_complain(a,
                      "--materials are of the file's triangles; with compact nodes they take "
                      "--numbers keep and --build host");
    }
    if (p->wanted && args_has(a, "--reduce")) {
        args_complain(a, "--reduce leaves other triangles than the mesh's; leave out --materials");
    }
}

int pack_materials_check(pack_materials *p, const pack_meshes *in, fail *f) {
    mesh_materials *m = &p->materials;
    const char *name = pack_shown(&in->file[0]);
    if (!p->wanted) {
        return 0;
    }
    if (!m->has_names && m->troubles == 0) {
        return fail_set(f, name, "has no materials (usemtl of OBJ); leave out --materials");
    }
    if (m->troubles > 0 && p->strict) {
        f->text[0] = '\0';
        snprintf(f->text, sizeof f->text, "%s; correct it, or leave out --strict",
                 m->trouble[0].text);
        return -1;
    }
    for (size_t i = 0; i < m->troubles && i < MATERIALS_TROUBLES_KEPT; i++) {
        fprintf(stderr, "%s; the default is used\n", m->trouble[i].text);
    }
    if (m->troubles > MATERIALS_TROUBLES_KEPT) {
        fprintf(stderr, "%s: and %zu more of these\n", name, m->troubles - MATERIALS_TROUBLES_KEPT);
    }
    return pack_textures_open(&p->textures, m, p->strict, f);
}

int pack_materials_add(pack_materials *p, const pack_meshes *in, packed *image, fail *f) {
    const char *name = pack_shown(&in->file[0]);
    if (!p->wanted) {
        return 0;
    }
    if (materials_use(&p->materials, image->info.source_triangles, 0) != 0) {
        return fail_set(f, name, "out of memory; use a larger machine");
    }
    uint16_t *number = heap_get(p->materials.count * sizeof *number);
    if (number == NULL) {
        return fail_set(f, name, "out of memory; use a larger machine");
    }
    int status = material_section_add(image, &p->materials, number, name, &p->stats, f);
    if (status == 0) {
        status = pack_textures_add(&p->textures, &p->materials, number, image, name, f);
    }
    heap_drop(number);
    return status;
}

void pack_materials_say(const pack_materials *p, const pack_meshes *in, const packed *image) {
    const uint32_t triangles = image->info.triangles > 0 ? image->info.triangles : 1;
    if (p->stats.bytes > 0) {
        note("materials: %" PRIu32 ", %" PRIu32 " bytes, %.2f per triangle", p->stats.materials,
             p->stats.bytes, (double)p->stats.bytes / triangles);
        pack_textures_say(&p->textures, &p->materials, pack_shown(&in->file[0]));
    }
}

void pack_materials_free(pack_materials *p) {
    pack_textures_free(&p->textures);
    materials_free(&p->materials);
}
