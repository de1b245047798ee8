/* test_picture_fit - pictures fitted to a panel, and what deflate packed unpacked
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/fit.h"
#include "host_tools/picture/inflate.h"
#include "tests/test.h"

static void fits(void) {
    static const struct {
        enum fit_mode mode;
        unsigned w, h;    /* picture; the panel is 8 x 4 */
        const char *rows; /* # picture, . frame */
    } cases[] = {
        {FIT_CONTAIN, 4, 4,
         "..####.."
         "..####.."
         "..####.."
         "..####.."},
        {FIT_CONTAIN, 16, 4,
         "........"
         "########"
         "########"
         "........"},
        {FIT_COVER, 4, 4,
         "########"
         "########"
         "########"
         "########"},
        {FIT_STRETCH, 3, 9,
         "########"
         "########"
         "########"
         "########"},
        {FIT_NONE, 2, 2,
         "........"
         "...##..."
         "...##..."
         "........"},
        {FIT_NONE, 20, 2,
         "........"
         "########"
         "########"
         "........"},
    };
    test("contain, cover, stretch and none put the picture where they say");
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        picture p, panel;
        fail f = {""};
        picture_make(&p, cases[i].w, cases[i].h, &f);
        picture_make(&panel, 8, 4, &f);
        memset(p.rgb, 200, 3 * p.width * p.height);
        fit_picture(&p, &panel, cases[i].mode);
        for (unsigned k = 0; k < 32; k++) {
            CHECK(panel.rgb[3 * k] == (cases[i].rows[k] == '#' ? 200 : 0), "case %zu, pixel %u: %u",
                  i, k, panel.rgb[3 * k]);
        }
        picture_free(&p);
        picture_free(&panel);
    }
}

static void averages(void) {
    picture p, panel;
    fail f = {""};
    test("a panel pixel is the average of what lies under it, rounded to nearest");
    picture_make(&p, 3, 2, &f);
    picture_make(&panel, 2, 1, &f);
    for (unsigned i = 0; i < 6; i++) {
        memset(p.rgb + 3 * i, (int)(10 * i), 3);
    }
    fit_picture(&p, &panel, FIT_STRETCH);
    /* (0 + 30) * 1 + (10 + 40) / 2 over 3; (20 + 50) + 25 over 3 */
    CHECK(panel.rgb[0] == 18 && panel.rgb[3] == 32, "%u %u", panel.rgb[0], panel.rgb[3]);
    picture_free(&p);
    picture_free(&panel);
}

static void inflates(void) {
    static const uint8_t fixed[] = {0x4B, 0x4C, 0x84, 0x01, 0x00}; /* "aaaaaaaaaa" */
    static const uint8_t stored[] = {1, 3, 0, 0xFC, 0xFF, 'x', 'y', 'z'};
    uint8_t to[16] = {0};
    test("deflate's fixed and stored blocks, and streams that end early");
    CHECK(inflate_bytes(fixed, sizeof fixed, to, sizeof to) == 10 &&
              memcmp(to, "aaaaaaaaaa", 10) == 0,
          "%.10s", (const char *)to);
    CHECK(inflate_bytes(fixed, sizeof fixed, to, 4) == 4, "no more than there is room");
    CHECK(inflate_bytes(stored, sizeof stored, to, sizeof to) == 3 && to[2] == 'z', "stored");
    for (size_t bytes = 0; bytes < sizeof stored; bytes++) {
        const size_t out = inflate_bytes(stored, bytes, to, sizeof to);
        CHECK(out == (bytes > 5 ? bytes - 5 : 0), "%zu bytes of %zu", out, bytes);
    }
}

int main(void) {
    fits();
    averages();
    inflates();
    return test_done();
}
