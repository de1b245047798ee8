/* destination - see destination.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/destination.h"

#include <string.h>
#include <sys/stat.h>

#include "host_tools/app/frame_range.h"
#include "host_tools/app/note.h"

static int is_standard(const char *path) {
    return path != NULL && strcmp(path, "-") == 0;
}

static int may_be_shared(const char *path) {
    struct stat about;
    return !is_standard(path) && stat(path, &about) == 0 && !S_ISREG(about.st_mode) &&
           !S_ISDIR(about.st_mode) && !S_ISSOCK(about.st_mode);
}

void destination_differ(args *a, const char *what, const char *one, const char *other) {
    if (one != NULL && other != NULL && strcmp(one, other) == 0 && !may_be_shared(one)) {
        args_complain(a, "%s need two different files, not '%s' twice", what, one);
    }
}

/* Several PPM in a row are one stream of pictures, for who says that this will do. */
static void choose_format(destination *d, args *a, unsigned frames, int is_stream) {
    fail f = {""};
    if (is_standard(d->out)) {
        d->format = frames > 1 ? PICTURE_Y4M : PICTURE_PPM;
    } else if (picture_format_of(d->out, &d->format, &f) != 0) {
        args_complain(a, "%s", f.text);
    } else if (!is_stream && (frames > 1 || args_has(a, "--frames")) &&
               !picture_is_film(d->format) && frame_range_is_pattern(d->out)) {
        d->is_numbered = 1;
    } else if (frames > 1 && !picture_is_film(d->format) &&
               !(is_stream && d->format == PICTURE_PPM)) {
        args_complain(a,
                      "%s makes a film: give -o a name that ends in .y4m, or NAME_{}.png for a "
                      "picture per frame",
                      args_has(a, "--frames") ? "--frames" : "--orbit");
    }
}

static void choose_chroma(destination *d, args *a) {
    static const char *const chroma[] = {"420", "444", NULL};
    const unsigned choice = args_choice(a, "--chroma", chroma, 0);
    if (picture_is_film(d->format)) {
        d->format = choice == 1 ? PICTURE_Y4M_444 : PICTURE_Y4M;
    } else if (args_has(a, "--chroma")) {
        args_complain(a, "--chroma is for films: give -o a name that ends in .y4m");
    }
}

void destination_read(destination *d, args *a, unsigned frames, int is_stream, int is_enough) {
    *d = (destination){.out = args_text(a, "-o", NULL),
                       .json = args_text(a, "--json", NULL),
                       .show = args_has(a, "--show")};
    if (d->out != NULL) {
        choose_format(d, a, frames, is_stream);
        choose_chroma(d, a);
    } else if (d->json == NULL && !d->show && !is_enough) {
        args_complain(a, "-o OUT says where the picture goes, --show draws it here");
    }
    destination_differ(a, "-o and --json", d->out, d->json);
    if (is_standard(d->out) && d->show) {
        args_complain(a, "-o - and --show would mix on standard output");
    }
}

void destination_note(const destination *d, unsigned width, unsigned height) {
    if (d->out != NULL && d->format == PICTURE_Y4M && (width % 2 != 0 || height % 2 != 0)) {
        note(
            "%s: H.264 wants an even width and height; choose another --size for ffmpeg, or "
            "--chroma 444",
            is_standard(d->out) ? "standard output" : d->out);
    }
}
