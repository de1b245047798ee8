/* test_image_fuzz - the target fuzz_image with deterministic mutations, for a few seconds
 *
 * PLANELET_SOAK=1 runs a hundred times as many.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/fuzz_image.c"

#include "tests/reference/random.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

#define SEEDS 9          /* of thesis images */
#define COMPACT_SEEDS 12 /* and of compact ones */
#define MUTATIONS 5000

typedef struct input {
    unsigned char *bytes; /* the byte that selects options, then the image */
    size_t size;
} input;

static input input_of(packed *image, mesh *m) {
    const input in = {malloc(image->size + 1), image->size + 1};
    memcpy(in.bytes + 1, image->bytes, image->size);
    pack_free(image);
    mesh_free(m);
    return in;
}

/* All bits, list lengths, formats and builds; two of them almost empty. */
static input compact_input(int seed) {
    static const uint8_t bits[3] = {12, 14, 21};
    mesh m = {0};
    packed image;
    lattice_loss loss;
    fail f = {""};
    const compact_options options = {.splits = (uint8_t)(seed & 1),
                                     .build = seed % 4 == 3 ? PLT_BUILD_DEVICE : PLT_BUILD_HOST,
                                     .lattice_bits = bits[seed % 3],
                                     .numbers = seed % 5 != 0,
                                     .checks = seed % 3 != 0,
                                     .floats = seed % 6 == 2,
                                     .leaf_triangles = 1u << seed / 4 % 3};
    shape_soup(&m, seed < 2 ? (uint32_t)seed : rig_triangles(17 * (uint32_t)seed, 1), 0.7f,
               (uint64_t)seed);
    CHECK(pack_compact(&image, &m, &options, "test", &loss, &f) == 0, "%s", f.text);
    return input_of(&image, &m);
}

static input seed_input(int seed) {
    mesh m = {0};
    packed image;
    fail f = {""};
    const pack_options options = {(uint8_t)(seed & 1),
                                  (uint8_t)(seed % 3),
                                  1u + (uint32_t)seed % 2,
                                  1u + (uint32_t)seed,
                                  NULL,
                                  seed < 6,
                                  NULL};
    shape_soup(&m, seed == 8 ? 0 : 3u + 5u * (uint32_t)seed, 0.7f, (uint64_t)seed);
    CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0, "%s", f.text);
    return input_of(&image, &m);
}

static const uint32_t words[] = {0,          1,          2,          3,          31,
                                 33,         0x7FC00000, 0x7F800000, 0xFF800000, 0x80000000,
                                 0x7FFFFFFF, 0xFFFFFFFF, 0x53800000, 0x00000001, 0x07FFFFFF};

static void mutate(input *in, random_state *r) {
    const uint32_t image = (uint32_t)in->size - 1, header = in->bytes[1 + 98] == 1 ? 228 : 144;
    for (uint32_t times = 1 + random_below(r, 4); times > 0 && image >= 4; times--) {
        const uint32_t at = random_below(r, 2) ? random_below(r, image)
                                               : random_below(r, image < header ? image : header);
        unsigned char *word = in->bytes + 1 + (at & ~3u) % (image - 3);
        switch (random_below(r, 5)) {
        case 0:
            in->bytes[1 + at] ^= (unsigned char)(1u << random_below(r, 8));
            break;
        case 1:
            in->bytes[1 + at] = (unsigned char)random_bits(r);
            break;
        case 2:
            plt_put_u32(word, words[random_below(r, sizeof words / sizeof words[0])]);
            break;
        case 3:
            plt_put_u32(word, plt_get_u32(word) + 32 * (random_below(r, 7) - 3));
            break;
        default:
            memcpy(word, in->bytes + 1 + (random_below(r, image) & ~3u) % (image - 3), 4);
        }
    }
}

static void fuzz(int seed, uint32_t mutations) {
    random_state r = {(uint64_t)seed};
    const input in = seed < SEEDS ? seed_input(seed) : compact_input(seed - SEEDS);
    for (uint32_t i = 0; i < mutations; i++) {
        input one = {malloc(in.size), in.size};
        memcpy(one.bytes, in.bytes, in.size);
        one.bytes[0] = (unsigned char)(random_bits(&r) | 16);
        mutate(&one, &r);
        if (random_below(&r, 50) == 0) {
            one.size = random_below(&r, (uint32_t)in.size);
        }
        CHECK(LLVMFuzzerTestOneInput(one.bytes, one.size) == 0, "seed %d, mutation %u", seed, i);
        free(one.bytes);
    }
    free(in.bytes);
}

int main(void) {
    const char *soak = getenv("PLANELET_SOAK");
    const uint32_t more = soak != NULL && soak[0] == '1' ? 100 : 1;
    test("mutated images are refused with a reason or traced without harm");
    for (int seed = 0; seed < SEEDS; seed++) {
        fuzz(seed, MUTATIONS * more);
    }
    test("the same for mutated compact images whose block checks are made right");
    const unsigned long before = images_opened;
    for (int seed = SEEDS; seed < SEEDS + COMPACT_SEEDS; seed++) {
        fuzz(seed, MUTATIONS * more);
    }
    test("of the mutated images some open and most do not");
    const unsigned long all = SEEDS * MUTATIONS * (unsigned long)more;
    const unsigned long compact = COMPACT_SEEDS * MUTATIONS * (unsigned long)more;
    const unsigned long opened = images_opened - before;
    CHECK(before > all / 50 && before < all / 2, "%lu of %lu", before, all);
    CHECK(opened > compact / 50 && opened < compact / 2, "compact: %lu of %lu", opened, compact);
    printf("    %lu of %lu thesis images opened, %lu of %lu compact ones\n", before, all, opened,
           compact);
    return test_done();
}
