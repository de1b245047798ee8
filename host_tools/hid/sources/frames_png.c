/* frames_png - a PNG picture: a film of one frame
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/hid/sources/frames_kinds.h"
#include "host_tools/picture/png.h"

static int png_next(frames *s, picture *p, fail *f) {
    size_t bytes;
    if (s->state != NULL) { /* it was read */
        return FRAMES_END;
    }
    s->state = s;
    unsigned char *file = frames_read_all(s, &bytes, f);
    const int status = file == NULL ? -1 : png_read(p, file, bytes, s->path, f);
    free(file);
    return status == 0 ? FRAMES_ONE : FRAMES_FAILED;
}

int frames_png(frames *s, fail *f) {
    (void)f;
    s->next = png_next;
    return 0;
}
