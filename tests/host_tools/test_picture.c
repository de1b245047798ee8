/* test_picture - PNG files say pixel for pixel what was put in
 *
 * The decoder below shares no line with the encoder: chunks, CRC and
 * Adler-32 bit by bit, inflate after the counting method of RFC 1951
 * section 3.2.2, filters undone from their definitions.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "host_tools/picture/deflate.h"
#include "host_tools/picture/huffman.h"
#include "host_tools/picture/picture_file.h"
#include "tests/test.h"

typedef struct stream {
    const uint8_t *in;
    size_t size, at; /* at: in bits */
    uint8_t *out;
    size_t room, made;
    int wrong;
    unsigned kinds[3]; /* blocks seen: stored, fixed, dynamic */
} stream;

typedef struct decoder {
    unsigned count[16], symbol[288];
} decoder;

static unsigned read_bits(stream *s, unsigned count) {
    unsigned value = 0;
    for (unsigned i = 0; i < count; i++, s->at++) {
        if (s->at >= 8 * s->size) {
            s->wrong = 1;
            return 0;
        }
        value |= (s->in[s->at / 8] >> s->at % 8 & 1u) << i;
    }
    return value;
}

static void make_decoder(decoder *d, const uint8_t *length, unsigned symbols) {
    unsigned n = 0;
    memset(d, 0, sizeof *d);
    for (unsigned l = 1; l < 16; l++) {
        for (unsigned s = 0; s < symbols; s++) {
            if (length[s] == l) {
                d->count[l]++;
                d->symbol[n++] = s;
            }
        }
    }
}

static unsigned decode(stream *s, const decoder *d) {
    unsigned code = 0, first = 0, index = 0;
    for (unsigned l = 1; l < 16; l++) {
        code |= read_bits(s, 1);
        if (code - first < d->count[l]) {
            return d->symbol[index + code - first];
        }
        index += d->count[l];
        first = (first + d->count[l]) << 1;
        code <<= 1;
    }
    s->wrong = 1;
    return 256;
}

static void put(stream *s, uint8_t byte) {
    if (s->made == s->room) {
        s->wrong = 1;
        return;
    }
    s->out[s->made++] = byte;
}

static void stored(stream *s) {
    s->at = (s->at + 7) / 8 * 8;
    const unsigned length = read_bits(s, 16), check = read_bits(s, 16);
    s->wrong |= length != (check ^ 65535u);
    for (unsigned i = 0; i < length && !s->wrong; i++) {
        put(s, (uint8_t)read_bits(s, 8));
    }
}

static void copy(stream *s, unsigned symbol, const decoder *distances) {
    static const unsigned length_base[29] = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                             15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                             67, 83, 99, 115, 131, 163, 195, 227, 258};
    static const unsigned length_bits[29] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                             2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
    static const unsigned distance_base[30] = {
        1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
        193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
    if (symbol > 285) {
        s->wrong = 1;
        return;
    }
    const unsigned k = symbol - 257, length = length_base[k] + read_bits(s, length_bits[k]);
    const unsigned d = decode(s, distances);
    if (s->wrong || d > 29) {
        s->wrong = 1;
        return;
    }
    const unsigned distance = distance_base[d] + read_bits(s, d < 2 ? 0 : d / 2 - 1);
    if (distance > s->made) {
        s->wrong = 1;
        return;
    }
    for (unsigned i = 0; i < length; i++) {
        put(s, s->out[s->made - distance]);
    }
}

static void coded(stream *s, const decoder *literals, const decoder *distances) {
    for (;;) {
        const unsigned symbol = decode(s, literals);
        if (s->wrong || symbol == 256) {
            return;
        }
        if (symbol < 256) {
            put(s, (uint8_t)symbol);
        } else {
            copy(s, symbol, distances);
        }
    }
}

static void fixed(stream *s) {
    uint8_t length[288];
    decoder literals, distances;
    for (unsigned i = 0; i < 288; i++) {
        length[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    }
    make_decoder(&literals, length, 288);
    memset(length, 5, 30);
    make_decoder(&distances, length, 30);
    coded(s, &literals, &distances);
}

static void dynamic(stream *s) {
    static const unsigned order[19] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                       11, 4,  12, 3, 13, 2, 14, 1, 15};
    uint8_t length[320] = {0};
    decoder lengths, literals, distances;
    const unsigned l = read_bits(s, 5) + 257, d = read_bits(s, 5) + 1, c = read_bits(s, 4) + 4;
    for (unsigned i = 0; i < c; i++) {
        length[order[i]] = (uint8_t)read_bits(s, 3);
    }
    make_decoder(&lengths, length, 19);
    for (unsigned n = 0; n < l + d && !s->wrong;) {
        const unsigned symbol = decode(s, &lengths);
        const uint8_t value = symbol < 16 ? (uint8_t)symbol : symbol == 16 && n ? length[n - 1] : 0;
        unsigned times = symbol < 16    ? 1
                         : symbol == 16 ? 3 + read_bits(s, 2)
                         : symbol == 17 ? 3 + read_bits(s, 3)
                                        : 11 + read_bits(s, 7);
        s->wrong |= n + times > l + d;
        for (; times && !s->wrong; times--) {
            length[n++] = value;
        }
    }
    make_decoder(&literals, length, l);
    make_decoder(&distances, length + l, d);
    coded(s, &literals, &distances);
}

/* A whole zlib stream; wrong unless every byte of it is accounted for. */
static void inflate(stream *s) {
    unsigned last = 0;
    const unsigned head = read_bits(s, 8) << 8 | read_bits(s, 8);
    s->wrong |= head % 31 != 0 || (head >> 8 & 15) != 8;
    while (!last && !s->wrong) {
        last = read_bits(s, 1);
        const unsigned kind = read_bits(s, 2);
        s->wrong |= kind == 3;
        s->kinds[kind % 3]++;
        kind == 0 ? stored(s) : kind == 1 ? fixed(s) : dynamic(s);
    }
    uint32_t a = 1, b = 0, check = 0;
    for (size_t i = 0; i < s->made; i++) {
        a = (a + s->out[i]) % 65521;
        b = (b + a) % 65521;
    }
    s->at = (s->at + 7) / 8 * 8;
    for (unsigned i = 0; i < 4; i++) {
        check = check << 8 | read_bits(s, 8);
    }
    s->wrong |= check != (b << 16 | a) || s->at != 8 * s->size;
}

static uint32_t crc(const uint8_t *bytes, size_t count) {
    uint32_t r = 0xFFFFFFFFu;
    for (size_t i = 0; i < count; i++) {
        r ^= bytes[i];
        for (unsigned bit = 0; bit < 8; bit++) {
            r = r >> 1 ^ (r & 1 ? 0xEDB88320u : 0);
        }
    }
    return ~r;
}

static uint32_t big(const uint8_t *p) {
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

static uint8_t *whole_file(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    uint8_t *bytes = malloc(1 << 23);
    *size = file ? fread(bytes, 1, 1 << 23, file) : 0;
    if (file) {
        fclose(file);
    }
    return bytes;
}

/* Checks every chunk and joins the data of IDAT in place. */
static size_t join(uint8_t *png, size_t size, unsigned *width, unsigned *height) {
    size_t joined = 0, at = 8;
    int ended = 0;
    CHECK(size > 57 && memcmp(png, "\x89PNG\r\n\x1a\n", 8) == 0, "no PNG signature");
    while (at + 12 <= size && !ended) {
        const size_t length = big(png + at);
        const uint8_t *name = png + at + 4, *data = png + at + 8;
        if (length > size - at - 12) {
            break;
        }
        CHECK(crc(name, length + 4) == big(data + length), "CRC of %.4s", (const char *)name);
        if (memcmp(name, "IHDR", 4) == 0) {
            *width = big(data);
            *height = big(data + 4);
            CHECK(length == 13 && memcmp(data + 8, "\x08\x02\0\0\0", 5) == 0, "not 8-bit RGB");
        }
        ended = memcmp(name, "IEND", 4) == 0;
        at += 12 + length;
        if (memcmp(name, "IDAT", 4) == 0) {
            memmove(png + joined, data, length);
            joined += length;
        }
    }
    CHECK(ended && at == size, "IEND at %zu of %zu", at, size);
    return joined;
}

static int predict(unsigned filter, int left, int up, int corner) {
    const int p = left + up - corner, dl = abs(p - left), du = abs(p - up), dc = abs(p - corner);
    const int paeth = dl <= du && dl <= dc ? left : du <= dc ? up : corner;
    const int all[5] = {0, left, up, (left + up) / 2, paeth};
    return filter < 5 ? all[filter] : 0;
}

static void unfilter(uint8_t *rows, unsigned width, unsigned height, uint8_t *rgb) {
    const size_t bytes = 3 * (size_t)width;
    for (size_t y = 0; y < height; y++) {
        const uint8_t *row = rows + y * (bytes + 1);
        CHECK(row[0] < 5, "filter %u", row[0]);
        for (size_t i = 0; i < bytes; i++) {
            const int left = i < 3 ? 0 : rgb[y * bytes + i - 3];
            const int up = y ? rgb[(y - 1) * bytes + i] : 0;
            const int corner = y && i >= 3 ? rgb[(y - 1) * bytes + i - 3] : 0;
            rgb[y * bytes + i] = (uint8_t)(row[1 + i] + predict(row[0], left, up, corner));
        }
    }
}

/* Writes `p` as PNG, reads it back, compares. Returns the file's size. */
static size_t there_and_back(const picture *p, const char *name) {
    char path[100];
    fail f = {""};
    size_t size;
    unsigned width = 0, height = 0;
    snprintf(path, sizeof path, TEST_FOLDER "%s.png", name);
    output *o = output_open(path, &f);
    CHECK(o && !picture_begin(o, PICTURE_PNG, p->width, p->height, 0, &f) &&
              !picture_frame(o, PICTURE_PNG, p, &f) && !output_commit(o, &f),
          "%s", f.text);
    uint8_t *png = whole_file(path, &size);
    const size_t bytes = 3 * (size_t)p->width * p->height;
    uint8_t *rgb = calloc(1, bytes), *rows = calloc(1, bytes + p->height);
    stream s = {.in = png, .out = rows, .room = bytes + p->height};
    s.size = join(png, size, &width, &height);
    CHECK(width == p->width && height == p->height, "%u x %u", width, height);
    inflate(&s);
    CHECK(!s.wrong && s.made == s.room, "%s: %zu of %zu bytes inflated", name, s.made, s.room);
    unfilter(rows, p->width, p->height, rgb);
    CHECK(memcmp(rgb, p->rgb, bytes) == 0, "%s: pixels differ", name);
    free(png);
    free(rgb);
    free(rows);
    return size;
}

static uint32_t next_random(uint32_t *state) {
    *state ^= *state << 13;
    *state ^= *state >> 17;
    return *state ^= *state << 5;
}

enum pattern { FLAT, GRADIENT, NOISE, DISC };

static uint8_t sample(enum pattern kind, unsigned x, unsigned y, unsigned c, uint32_t *state) {
    const long dx = (long)x - 160, dy = (long)y - 120, from = dx * dx + dy * dy;
    switch (kind) {
    case FLAT:
        return (uint8_t)(40 + 60 * c);
    case GRADIENT:
        return (uint8_t)((x * (c + 1) + 2 * y) / 4);
    case NOISE:
        return (uint8_t)(next_random(state) >> 9);
    default: /* a shaded ball before a plain ground */
        return (uint8_t)(from < 10000 ? 250 - from / 50 - 20 * c : 30);
    }
}

static size_t pattern_size(enum pattern kind, unsigned width, unsigned height, const char *name) {
    picture p;
    fail f = {""};
    uint32_t state = 2463534242u;
    CHECK(!picture_make(&p, width, height, &f), "%s", f.text);
    for (unsigned y = 0; y < height; y++) {
        for (unsigned x = 0; x < width; x++) {
            for (unsigned c = 0; c < 3; c++) {
                p.rgb[3 * ((size_t)y * width + x) + c] = sample(kind, x, y, c, &state);
            }
        }
    }
    const size_t size = there_and_back(&p, name);
    picture_free(&p);
    return size;
}

static void test_pictures(void) {
    size_t size;
    test("PNG: a flat frame comes back and needs less than 1/250 of its pixels");
    size = pattern_size(FLAT, 320, 240, "flat");
    CHECK(size < 320 * 240 * 3 / 250, "%zu bytes", size);
    test("PNG: a gradient comes back and needs less than 1/20 of its pixels");
    size = pattern_size(GRADIENT, 320, 240, "gradient");
    CHECK(size < 320 * 240 * 3 / 20, "%zu bytes", size);
    test("PNG: a shaded ball comes back and needs less than 1/8 of its pixels");
    size = pattern_size(DISC, 320, 240, "disc");
    CHECK(size < 320 * 240 * 3 / 8, "%zu bytes", size);
    test("PNG: noise comes back and grows by less than 1 % and 100 bytes");
    size = pattern_size(NOISE, 320, 240, "noise");
    CHECK(size < 320 * 240 * 3 / 100 * 101 + 100, "%zu bytes", size);
    test("PNG: every size from 1 x 1 to 9 x 9, and long thin ones, come back");
    for (unsigned side = 0; side < 81; side++) {
        pattern_size(side % 2 ? NOISE : GRADIENT, side % 9 + 1, side / 9 + 1, "tiny");
    }
    pattern_size(NOISE, 1, 4099, "tall");
    pattern_size(GRADIENT, 4099, 1, "wide");
    pattern_size(DISC, 333, 257, "odd");
}

/* `size` bytes through deflate and back; the kinds of block seen add up. */
static void squeeze(const uint8_t *data, size_t size, unsigned *kinds) {
    bits packed = {0};
    uint8_t *back = malloc(size + 1);
    CHECK(deflate_zlib(&packed, data, size) == 0, "out of memory");
    stream s = {.in = packed.bytes, .size = packed.size, .out = back, .room = size};
    inflate(&s);
    CHECK(!s.wrong && s.made == size && (size == 0 || memcmp(back, data, size) == 0),
          "%zu of %zu bytes came back", s.made, size);
    for (unsigned k = 0; k < 3; k++) {
        kinds[k] += s.kinds[k];
    }
    free(back);
    bits_free(&packed);
}

static void test_deflate(void) {
    enum { SIZE = 300000 };
    static uint8_t data[SIZE];
    unsigned kinds[3] = {0};
    uint32_t state = 1;
    test("deflate: texts of every alphabet and length class come back, in all three block kinds");
    for (unsigned letters = 1; letters <= 256; letters *= 2) {
        for (size_t i = 0; i < SIZE; i++) {
            data[i] = (uint8_t)(next_random(&state) % letters);
        }
        for (size_t size = 0; size <= SIZE; size = 2 * size + 1) {
            squeeze(data, size, kinds);
        }
    }
    CHECK(kinds[0] && kinds[1] && kinds[2], "%u %u %u", kinds[0], kinds[1], kinds[2]);

    test("deflate: repeats from every distance up to the window's edge and beyond come back");
    for (size_t distance = 1; distance < 70000; distance += distance / 7 + 1) {
        for (size_t i = 0; i < 140000; i++) {
            data[i] = i < distance ? (uint8_t)(next_random(&state) >> 8) : data[i - distance];
        }
        squeeze(data, 140000, kinds);
    }
    squeeze(data, 32768 + 300, kinds);
}

static void test_huffman(void) {
    test("Huffman: even Fibonacci counts give a complete code of at most 15 bits");
    uint32_t count[40] = {1, 1};
    uint8_t length[40];
    for (unsigned symbols = 2; symbols <= 40; symbols++) {
        unsigned spent = 0;
        if (symbols > 2) {
            count[symbols - 1] = count[symbols - 2] + count[symbols - 3];
        }
        huffman_lengths(count, symbols, 15, length);
        for (unsigned s = 0; s < symbols; s++) {
            CHECK(length[s] >= 1 && length[s] <= 15, "length %u", length[s]);
            CHECK(s == 0 || length[s] <= length[s - 1], "rarer and shorter");
            spent += 32768u >> length[s];
        }
        CHECK(spent == 32768, "%u symbols fill %u of 32768", symbols, spent);
    }
}

int main(void) {
    mkdir(TEST_FOLDER, 0777);
    test_pictures();
    test_deflate();
    test_huffman();
    return test_done();
}
