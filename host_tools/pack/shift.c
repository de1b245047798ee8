/* shift - see shift.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/shift.h"

#include <string.h>

#include "engine/image/header.h"
#include "engine/image/header_at.h"

enum { SHIFT_BYTES = PLT_HEADER_BYTES - PLT_AT_SHIFT };

void shift_write(unsigned char *image, const double shift[3]) {
    for (int i = 0; i < SHIFT_BYTES; i++) {
        uint64_t bits;
        memcpy(&bits, &shift[i / 8], sizeof bits);
        image[PLT_AT_SHIFT + i] = (unsigned char)(bits >> 8 * (i % 8));
    }
    plt_header_seal(image);
}

static int fetch(const plt_source *source, unsigned char bytes[SHIFT_BYTES]) {
    if (source->bytes < PLT_HEADER_BYTES) {
        return -1;
    }
    if (source->mapped != NULL) {
        memcpy(bytes, (const unsigned char *)source->mapped + PLT_AT_SHIFT, SHIFT_BYTES);
        return 0;
    }
    const int started = source->start(source->context, 0, PLT_AT_SHIFT, bytes, SHIFT_BYTES);
    return source->wait(source->context, 1) < 0 || started < 0 ? -1 : 0;
}

int shift_read(const plt_source *source, double shift[3]) {
    unsigned char bytes[SHIFT_BYTES];
    if (fetch(source, bytes) != 0) {
        return -1;
    }
    for (int axis = 0; axis < 3; axis++) {
        uint64_t bits = 0;
        for (int i = 8; i-- > 0;) {
            bits = bits << 8 | bytes[8 * axis + i];
        }
        memcpy(&shift[axis], &bits, sizeof bits);
    }
    return 0;
}
