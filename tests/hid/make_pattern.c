/* make_pattern - make_pattern WxH COUNT [FIRST]: pictures of pattern.h as a stream of PPM
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>

#include "tests/hid/pattern.h"

int main(int argc, char **argv) {
    unsigned width = 0, height = 0;
    if (argc < 3 || sscanf(argv[1], "%ux%u", &width, &height) != 2 || width - 1 > 4095 ||
        height - 1 > 4095) {
        fprintf(stderr, "make_pattern: use it as: make_pattern WxH COUNT [FIRST]\n");
        return 2;
    }
    const unsigned count = (unsigned)atoi(argv[2]), first = argc > 3 ? (unsigned)atoi(argv[3]) : 0;
    uint8_t *rgb = malloc((size_t)3 * width * height);
    for (unsigned n = 0; rgb != NULL && n < count; n++) {
        pattern_fill(first + n, width, height, rgb);
        printf("P6 %u %u 255\n", width, height);
        fwrite(rgb, 3, (size_t)width * height, stdout);
    }
    free(rgb);
    return fflush(stdout) == 0 && rgb != NULL ? 0 : 1;
}
