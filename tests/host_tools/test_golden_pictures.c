/* test_golden_pictures - README's pictures are the frames whose hashes are written beside them
 *
 * tests/golden/pictures.txt has a line for each: NAME WIDTH HEIGHT HASH, the hash as of frames,
 * FNV-1a of 64 bits over the rows top down. A picture whose mesh is not ours cannot be made anew in
 * a test: its hash is that which a board's firmware printed (`make demo-bunny`).
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/base/input.h"
#include "host_tools/picture/png.h"
#include "tests/test.h"

static uint64_t hash_of(const picture *p) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < (size_t)3 * p->width * p->height; i++) {
        hash = (hash ^ p->rgb[i]) * 0x100000001b3u;
    }
    return hash;
}

static void compare(const char *name, unsigned width, unsigned height, uint64_t due) {
    char path[64];
    input in = {0};
    picture p = {0};
    fail f = {""};
    snprintf(path, sizeof path, "tests/golden/%s", name);
    const int good =
        input_read(&in, path, &f) == 0 && png_read(&p, in.bytes, in.size, path, &f) == 0;
    CHECK(good, "%s: %s", path, f.text);
    if (good) {
        const uint64_t is = hash_of(&p);
        CHECK(p.width == width && p.height == height, "%s: %u x %u", name, p.width, p.height);
        CHECK(is == due, "%s: %016" PRIx64 " not %016" PRIx64, name, is, due);
        p.rgb[width] ^= 1;
        CHECK(hash_of(&p) != due, "one bit changes the hash");
    }
    picture_free(&p);
    input_free(&in);
}

int main(void) {
    char line[128], name[32];
    unsigned width, height, count = 0;
    uint64_t due;
    FILE *table = fopen("tests/golden/pictures.txt", "r");
    test("each picture of tests/golden has the pixels of the frame with the hash beside it");
    CHECK(table != NULL, "tests/golden/pictures.txt: run from the top folder");
    while (table != NULL && fgets(line, sizeof line, table) != NULL) {
        if (line[0] != '#' &&
            sscanf(line, "%31s %u %u %" SCNx64, name, &width, &height, &due) == 4) {
            compare(name, width, height, due);
            count++;
        }
    }
    CHECK(count == 2, "%u pictures", count);
    if (table != NULL) {
        fclose(table);
    }
    return test_done();
}
