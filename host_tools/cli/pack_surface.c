/* pack_surface - see pack_surface.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/pack_surface.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/app/note.h"
#include "host_tools/app/phase.h"
#include "host_tools/cli/pack_lines.h"
#include "host_tools/mesh/smooth.h"
#include "host_tools/pack/surface_pages.h"

static int wants_of_file(const mesh_corners *c) {
    return c->wants_normals || c->wants_colours || c->wants_texcoords;
}

int pack_surface_wanted(const pack_surface *s) {
    return s->smooths || wants_of_file(&s->corners);
}

void pack_surface_read(pack_surface *s, args *a) {
    static const char *const choices[] = {"none", "keep", NULL};
    static const char *const texcoords[] = {"none", "keep", "fine", NULL};
    s->corners.wants_normals = (int)args_choice(a, "--normals", choices, 0);
    s->corners.wants_colours = (int)args_choice(a, "--colours", choices, 0);
    s->corners.wants_texcoords = (int)args_choice(a, "--texcoords", texcoords, 0);
    s->corners.has_fine_texcoords = s->corners.wants_texcoords == 2;
    s->smooths = args_doubles(a, "--smooth", &s->degrees, 1);
    if (s->smooths && !(s->degrees >= 0 && s->degrees <= 180)) {
        args_complain(a, "--smooth takes degrees from 0 to 180");
    }
    if (s->smooths && s->corners.wants_normals) {
        args_complain(a, "--smooth and --normals keep are both normals; leave one out");
    }
    static const char *const ways[] = {"tables", "pages", NULL};
    s->paged = (int)args_choice(a, "--surface", ways, 0);
    if (!pack_surface_wanted(s)) {
        return;
    }
    if (args_has(a, "--sequence") || args_has(a, "--instances")) {
        args_complain(a,
                      "--smooth, --normals, --colours and --texcoords are of triangles that stay "
                      "where they are; leave out --sequence or --instances");
    }
    if (strcmp(args_text(a, "--nodes", "thesis"), "compact") == 0 &&
        (strcmp(args_text(a, "--build", "host"), "host") != 0 ||
         strcmp(args_text(a, "--numbers", "keep"), "keep") != 0)) {
        args_complain(a,
                      "--smooth, --normals, --colours and --texcoords take --numbers keep and "
                      "--build host with compact nodes");
    }
    if (args_has(a, "--reduce") && wants_of_file(&s->corners)) {
        args_complain(a, "--reduce leaves other corners than the mesh's; use --smooth for normals");
    }
}

void pack_surface_check(const pack_surface *s, args *a) {
    if (args_has(a, "--surface") && !pack_surface_wanted(s)) {
        args_complain(a,
                      "--surface is of normals, colours and texture coordinates; use --smooth 40, "
                      "--colours or --texcoords");
    }
    if (s->paged && strcmp(args_text(a, "--build", "host"), "device") == 0) {
        args_complain(a, "--surface pages takes --build host, whose triangles keep their order");
    }
}

static int out_of_memory(const char *name, fail *f) {
    return fail_set(f, name, "out of memory for normals or colours; use a larger machine");
}

int pack_surface_prepare(pack_surface *s, const pack_meshes *in, fail *f) {
    const char *name = pack_shown(&in->file[0]);
    if (s->corners.wants_normals && s->corners.normals == 0) {
        return fail_set(f, name, "has no normals to keep; use --smooth 40 to make some");
    }
    if (s->corners.wants_colours && s->corners.colours == 0) {
        return fail_set(f, name, "has no colours of vertices to keep; leave out --colours");
    }
    if (s->corners.wants_texcoords && s->corners.texcoords == 0) {
        return fail_set(f, name, "has no texture coordinates to keep; leave out --texcoords");
    }
    if ((s->corners.wants_texcoords && corners_want_texcoords(&s->corners, in->m.triangles) != 0) ||
        (s->corners.wants_normals && corners_want_normals(&s->corners, in->m.triangles) != 0) ||
        (s->corners.wants_colours && corners_want_colours(&s->corners, in->m.triangles) != 0)) {
        return out_of_memory(name, f); /* of files that have none */
    }
    if (!s->smooths) {
        return 0;
    }
    phase_begin("smoothing", name);
    const int status = mesh_smooth(&in->m, s->degrees, &s->corners);
    phase_end();
    return status == 0 ? 0 : out_of_memory(name, f);
}

int pack_surface_add(pack_surface *s, const pack_meshes *in, packed *image, fail *f) {
    const char *name = pack_shown(&in->file[0]);
    if (!pack_surface_wanted(s)) {
        return 0;
    }
    return s->paged ? surface_pages_add(image, &s->corners, SURFACE_PAGES_USUAL, name, &s->stats, f)
                    : surface_add(image, &s->corners, name, &s->stats, f);
}

static void say_pages(const surface_stats *s, const packed *image, const char *more) {
    note("pages: %" PRIu32 " of %" PRIu32 " triangles, %" PRIu64 " normals, %" PRIu64
         " colours and %" PRIu64 " texture coordinates by position, %" PRIu64 ", %" PRIu64
         " and %" PRIu64 " by triangle, %.2f bytes per triangle%s",
         s->pages_count, s->each, s->normals.positions, s->colours.positions,
         s->texcoords.positions, s->normals.split, s->colours.split, s->texcoords.split,
         (double)s->pages.bytes / (image->info.triangles > 0 ? image->info.triangles : 1), more);
}

static void say_section(const char *what, const surface_section *s, const packed *image,
                        const char *more) {
    if (s->bytes > 0) {
        note("%s: %" PRIu64 " by position, %" PRIu64 " by triangle, %.2f bytes per triangle%s",
             what, s->positions, s->split,
             (double)s->bytes / (image->info.triangles > 0 ? image->info.triangles : 1), more);
    }
}

void pack_surface_say(const pack_surface *s, const packed *image) {
    const surface_stats *st = &s->stats;
    char colours[140] = "", texcoords[80] = "", both[240];
    if (st->colours_distinct > st->colours_kept) {
        snprintf(colours, sizeof colours,
                 ", %" PRIu32 " for %" PRIu32 " that differ, off by at most %" PRIu32
                 " of 255, %.2f on average",
                 st->colours_kept, st->colours_distinct, st->colours_off, st->colours_mean);
    }
    if (st->texcoords.positions + st->texcoords.split > 0) {
        snprintf(texcoords, sizeof texcoords, ", off by at most %.2g of a texture",
                 st->texcoords_off);
    }
    if (s->paged && pack_surface_wanted(s)) {
        snprintf(both, sizeof both, "%s%s", colours, texcoords);
        say_pages(&s->stats, image, both);
        return;
    }
    say_section("normals", &st->normals, image, "");
    say_section("colours", &st->colours, image, colours);
    say_section("texture coordinates", &st->texcoords, image, texcoords);
}

void pack_surface_free(pack_surface *s) {
    corners_free(&s->corners);
}
