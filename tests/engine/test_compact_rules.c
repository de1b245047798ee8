/* test_compact_rules - each refusal of a compact header, by a header that breaks the rule
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/pack/pack.h"
#include "tests/reference/compact_hostile.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* A header with 14 lattice bits and one field changed, the rule that refuses it (0: none) and
 * the offset. `floats`: for float records, lattice geometry, or both. */
typedef struct change {
    uint32_t at, value, bytes;
    uint8_t floats, rule;
    uint32_t offset;
} change;

enum { LATTICE, FLOATS, BOTH, AT_LO = 72, AT_BOX = 188, ALL = 0xFFFFFFFF };

#define NAN_BITS 0x7FC00000u
#define TWO_40 0x53800000u /* as a float */

static const change changes[] = {
    {48, 63, 4, BOTH, 14, 168},
    {52, 3, 4, BOTH, 14, 168},
    {52, 8, 4, BOTH, 14, 168},
    {97, 2, 1, LATTICE, 7, 28},
    {99, 4, 1, BOTH, 8, 96},
    {168, NAN_BITS, 4, BOTH, 14, 168},
    {176, TWO_40 + 1, 4, BOTH, 14, 168},
    {180, 0, 4, BOTH, 14, 168},
    {180, NAN_BITS, 4, BOTH, 14, 168},
    {180, TWO_40 + 1, 4, BOTH, 14, 168},
    {184, 11, 4, BOTH, 14, 168},
    {184, 22, 4, BOTH, 14, 168},
    {AT_BOX, 1u << 14, 4, BOTH, 14, 168},
    {AT_BOX + 20, 1u << 14, 4, BOTH, 14, 168},
    {AT_BOX + 12, ALL, 4, BOTH, 14, 168},
    {216, 1, 4, BOTH, 14, 168},
    {216, 30, 4, BOTH, 14, 168},
    {216, 256, 4, BOTH, 14, 168}, /* checks of nothing */
    {216, 257, 4, BOTH, 14, 168},
    {216, 286, 4, BOTH, 14, 168},
    {216, 512 + 10, 4, BOTH, 14, 168},
    {216, 10, 4, FLOATS, 14, 168},
    {216, 256 + 10, 4, FLOATS, 14, 168},
    {220, 8u * 0xFFFFFFu + 8, 4, BOTH, 14, 168},
    {224, 8u * 0xFFFFFFu + 8, 4, BOTH, 14, 168},
    {AT_LO, NAN_BITS, 4, BOTH, 14, AT_BOX},
    {AT_LO + 20, TWO_40 + 1, 4, BOTH, 14, AT_BOX},
    {AT_LO + 12, 0xFF800000, 4, LATTICE, 14, AT_BOX}, /* hi below lo */
    {AT_LO + 12, 0xFF800000, 4, FLOATS, 9, AT_LO},
    {228, 1, 1, BOTH, 17, 16},  /* there is no table behind */
    {231, 1, 1, BOTH, 17, 228}, /* the last byte before the shift */
};

static packed image_of(int floats) {
    mesh m = {0};
    packed image;
    fail f = {""};
    lattice_loss loss;
    const compact_options options = {
        .lattice_bits = 14, .numbers = 1, .floats = (uint8_t)floats, .leaf_triangles = 2};
    shape_soup(&m, 20, 0.8f, 1);
    CHECK(pack_compact(&image, &m, &options, "test", &loss, &f) == 0, "%s", f.text);
    mesh_free(&m);
    return image;
}

/* The result of opening the image with a field changed. */
static hostile_result changed(const packed *image, uint32_t at, uint32_t value, uint32_t bytes) {
    unsigned char *copy = room_get(image->size);
    memcpy(copy, image->bytes, image->size);
    for (uint32_t i = 0; i < bytes; i++) {
        copy[at + i] = (unsigned char)(value >> 8 * i);
    }
    compact_seal(copy, image->size, 0);
    const hostile_result r = compact_try(copy, image->size, 0, 2);
    free(copy);
    return r;
}

static void expect(const packed *image, const change *c) {
    const hostile_result r = changed(image, c->at, c->value, c->bytes);
    const int as_due = c->rule == 0 ? r.status == PLT_OK
                                    : r.status == PLT_ERR_IMAGE && r.fault.kind == 'R' &&
                                          r.fault.rule == c->rule && r.fault.offset == c->offset;
    CHECK(as_due, "%08x at %u: status %d, %c%u at %u (%s)", c->value, c->at, r.status,
          r.fault.kind ? r.fault.kind : '-', r.fault.rule, r.fault.offset, r.fault.message);
}

static void every_rule(int floats, const packed *image) {
    for (unsigned i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        if (changes[i].floats == BOTH || changes[i].floats == floats) {
            expect(image, &changes[i]);
        }
    }
}

static uint32_t bits_of(float number) {
    uint32_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

/* The scene's box against the lattice box, one step or one float to either side. */
static void two_boxes(int floats, const packed *image) {
    for (uint32_t side = 0; side < 6; side++) {
        const uint32_t at = AT_LO + 4 * side, lattice_at = AT_BOX + 4 * side;
        const uint32_t number = plt_get_u32(image->bytes + lattice_at);
        const float edge = plt_get_float(image->bytes + at), far = side < 3 ? -1e9f : 1e9f;
        const uint32_t outwards = bits_of(nextafterf(edge, far));
        const uint32_t inwards = bits_of(nextafterf(edge, -far));
        const uint32_t beyond = bits_of(edge + far * 1e-6f);
        const change around[3] = {
            {at, outwards, 4, BOTH, floats ? 0 : 14, AT_BOX},
            {at, beyond, 4, BOTH, 14, AT_BOX},
            {lattice_at, side < 3 ? number + 1 : number - 1, 4, BOTH, 14, AT_BOX}};
        for (int i = 0; i < 3; i++) {
            /* The lattice's origin is the mesh's lowest corner: no coordinate is below it. */
            if (!(floats && i == 0 && side < 3)) {
                expect(image, &around[i]);
            }
        }
        const hostile_result r = changed(image, at, inwards, 4);
        CHECK(r.status == PLT_ERR_IMAGE && r.fault.kind == (floats ? 'I' : 'R') &&
                  r.fault.rule == (floats ? 5 : 14),
              "side %u inwards: status %d, rule %u", side, r.status, r.fault.rule);
    }
    if (floats) { /* a looser lattice around the scene does no harm */
        const uint32_t number = plt_get_u32(image->bytes + AT_BOX + 16);
        const change looser = {AT_BOX + 16, number + 1, 4, BOTH, 0, 0};
        expect(image, &looser);
    }
}

int main(void) {
    for (int floats = LATTICE; floats <= FLOATS; floats++) {
        packed image = image_of(floats);
        test(floats ? "... and one of float records"
                    : "a compact header is refused by the rule it breaks");
        every_rule(floats, &image);
        test(floats ? "float records lie within the lattice box and their own"
                    : "with lattice geometry the scene's box is the lattice box");
        two_boxes(floats, &image);
        pack_free(&image);
    }
    return test_done();
}
