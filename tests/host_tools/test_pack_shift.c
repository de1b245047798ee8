/* test_pack_shift - an image remembers what was subtracted from its meshes
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>

#include "host_tools/pack/pack.h"
#include "host_tools/pack/shift.h"
#include "tests/test.h"

static packed make_image(void) {
    mesh m = {0};
    packed image;
    fail f = {""};
    const pack_options options = {.leaf_triangles = 2, .treelet_nodes = 64};
    for (int i = 0; i < 3; i++) {
        mesh_add_vertex(&m, (float)i, (float)(i * i), 0, &f);
    }
    mesh_add_triangle(&m, 0, 1, 2, &f);
    CHECK(pack_mesh(&image, &m, &options, "mesh", &f) == 0, "%s", f.text);
    mesh_free(&m);
    return image;
}

/* A source that is not mapped: of its bytes, or one that fails. */
static int start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    (void)tag;
    if (context == NULL) {
        return -1;
    }
    memcpy(to, (unsigned char *)context + offset, count);
    return 0;
}

static int finish(void *context, uint32_t tags) {
    (void)context;
    (void)tags;
    return 0;
}

static void reads_back(void) {
    test("A shift is read back bit for bit, mapped and fetched, and the image stays valid");
    static const double SHIFTS[][3] = {
        {0, 0, 0}, {500000.6, -4500000.5, 1e-300}, {-0.0, 0x1p40, 0x1.fffffffffffffp-1}};
    for (int i = 0; i < 3; i++) {
        packed image = make_image();
        const plt_source mapped = {.mapped = image.bytes, .bytes = image.size};
        const plt_source fetched = {
            .bytes = image.size, .context = image.bytes, .start = start, .wait = finish};
        double back[3] = {7, 7, 7};
        plt_info info;
        plt_fault fault;
        CHECK(shift_read(&mapped, back) == 0 && back[0] == 0 && back[2] == 0, "not 0 at first");
        shift_write(image.bytes, SHIFTS[i]);
        CHECK(shift_read(&mapped, back) == 0, "not read");
        CHECK(memcmp(back, SHIFTS[i], sizeof back) == 0, "%g %g %g", back[0], back[1], back[2]);
        back[0] = 7;
        CHECK(shift_read(&fetched, back) == 0 && memcmp(back, SHIFTS[i], sizeof back) == 0,
              "fetched %g", back[0]);
        CHECK(plt_image_info(&mapped, &info, &fault) == PLT_OK, "%s", fault.message);
        pack_free(&image);
    }
}

static void little_endian(void) {
    test("It lies at byte 232 as the specification says");
    packed image = make_image();
    const double shift[3] = {1, -2, 0};
    static const unsigned char EXPECTED[24] = {0, 0, 0, 0, 0, 0, 0xf0, 0x3f,
                                               0, 0, 0, 0, 0, 0, 0,    0xc0};
    shift_write(image.bytes, shift);
    CHECK(memcmp(image.bytes + 232, EXPECTED, 24) == 0, "other bytes");
    pack_free(&image);
}

static void fails(void) {
    test("A source that is too short or fails is an error");
    double shift[3];
    static const unsigned char short_image[255];
    const plt_source shorter = {.mapped = short_image, .bytes = 255};
    const plt_source failing = {.bytes = 256, .start = start, .wait = finish};
    CHECK(shift_read(&shorter, shift) == -1, "read beyond the end");
    CHECK(shift_read(&failing, shift) == -1, "no failure");
}

int main(void) {
    reads_back();
    little_endian();
    fails();
    return test_done();
}
