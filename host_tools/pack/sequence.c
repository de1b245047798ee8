/* sequence - see sequence.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/sequence.h"

#include <math.h>
#include <string.h>

#include "engine/image/header.h"
#include "engine/planelet_crc32.h"
#include "host_tools/base/heap.h"
#include "host_tools/pack/image_size.h"
#include "host_tools/pack/moving.h"

enum { NO_NUMBER = -1 };

static const char *size_remedy(void) {
    return "use fewer frames, or --geometry lattice of fewer bits";
}

static int out_of_memory(const char *name, fail *f) {
    return fail_set(f, name, "out of memory for its frames; pack on a larger machine");
}

/* ---- coordinates ------------------------------------------------------------------ */

static uint32_t lattice_coordinate(const plt_lattice *l, int axis, float x) {
    const double steps = floor(((double)x - (double)l->origin[axis]) / (double)l->step + 0.5);
    const double most = (double)((1u << l->bits) - 1u);
    return (uint32_t)(steps > most ? most : steps > 0 ? steps : 0);
}

void sequence_snap(mesh *m, const plt_lattice *l) {
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        const int axis = (int)(i % 3);
        m->vertex[i] = plt_lattice_float(l, axis, lattice_coordinate(l, axis, m->vertex[i]));
    }
}

/* A coordinate as it is coded: on the lattice, or a float's bits in the order of floats. */
static uint32_t word_of(const plt_lattice *l, int axis, float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return l->bits > 0 ? lattice_coordinate(l, axis, x) : plt_float_order(bits);
}

static void read_words(sequence *s, const mesh *m) {
    for (size_t i = 0; i < s->mesh_vertices; i++) {
        for (int a = 0; a < 3 && s->number[i] != (uint32_t)NO_NUMBER; a++) {
            s->now[s->number[i]].word[a] =
                word_of(&s->options.lattice, a, m->vertex[3 * i + (size_t)a]);
        }
    }
}

/* ---- blocks ----------------------------------------------------------------------- */

typedef struct differences {
    uint32_t least, width;
} differences;

/* Modulo the coordinate's bits; as a signed number for the least. */
static uint32_t difference(const sequence *s, size_t i, unsigned axis, int is_key) {
    const uint32_t was = is_key ? 0 : s->before[i].word[axis];
    return (s->now[i].word[axis] - was) & plt_low_bits(s->word_bits);
}

static int64_t as_signed(uint32_t x, uint32_t bits) {
    const int64_t one = 1;
    return x >> (bits - 1) != 0 ? (int64_t)x - (one << bits) : (int64_t)x;
}

static differences range_of(const sequence *s, size_t first, uint32_t count, unsigned axis,
                            int is_key) {
    int64_t least = INT64_MAX, most = INT64_MIN;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t d = difference(s, first + i, axis, is_key);
        const int64_t x = is_key && s->word_bits < 32 ? (int64_t)d : as_signed(d, s->word_bits);
        least = x < least ? x : least;
        most = x > most ? x : most;
    }
    const differences r = {(uint32_t)least & plt_low_bits(s->word_bits),
                           plt_bits_for((uint32_t)(most - least))};
    return r;
}

/* Vertices first .. first + count - 1 at `to`, which is zero. Returns its bytes. */
static uint32_t write_block(const sequence *s, unsigned char *to, size_t first, uint32_t count) {
    const int is_key = s->frames % s->options.key_every == 0;
    const uint32_t head = 8 * PLT_FRAME_CHECK_BYTES, bases = head + 3 * PLT_FRAME_WIDTH_BITS;
    uint32_t at = plt_frame_head_bits(s->word_bits), widths = 0;
    for (unsigned a = 0; a < 3; a++) {
        const differences r = range_of(s, first, count, a, is_key);
        plt_bits_put(to, head + PLT_FRAME_WIDTH_BITS * a, PLT_FRAME_WIDTH_BITS, r.width);
        plt_bits_put(to, bases + s->word_bits * a, s->word_bits, r.least);
        for (uint32_t i = 0; i < count; i++, at += r.width) {
            plt_bits_put(to, at, r.width, difference(s, first + i, a, is_key) - r.least);
        }
        widths += r.width;
    }
    const uint32_t bytes = plt_frame_bytes_for(count, s->word_bits, widths);
    plt_put_u32(to,
                plt_frame_block_check(to, bytes, s->frames, (uint32_t)(first / PLT_FRAME_BLOCK)));
    return bytes;
}

/* ---- frames ----------------------------------------------------------------------- */

static uint64_t offsets_bytes(const sequence *s) {
    return s->options.stills ? 0 : 4 * ((uint64_t)s->options.frames + 1);
}

/* Which vertices triangles use, numbered in the order of the mesh. */
static void number_vertices(sequence *s, const mesh *m) {
    memset(s->number, 0xFF, m->vertices * sizeof *s->number);
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        s->number[m->triangle[i]] = 0;
    }
    for (size_t i = 0; i < m->vertices; i++) {
        if (s->number[i] == 0) {
            s->number[i] = s->vertices++;
        }
    }
}

int sequence_begin(sequence *s, const mesh *first, const sequence_options *options,
                   const char *name, fail *f) {
    *s = (sequence){.options = *options, .mesh_vertices = first->vertices};
    s->word_bits = options->lattice.bits > 0 ? options->lattice.bits : PLT_FRAME_FLOAT_BITS;
    s->number = heap_get((uint64_t)first->vertices * sizeof *s->number);
    if (s->number == NULL) {
        return out_of_memory(name, f);
    }
    number_vertices(s, first);
    s->moving = (moving_vertices){.lattice = options->lattice, .number = s->number};
    s->before = heap_get_zeroed((uint64_t)s->vertices * sizeof *s->before);
    s->now = heap_get_zeroed((uint64_t)s->vertices * sizeof *s->now);
    s->size = s->room = offsets_bytes(s);
    s->bytes = heap_get_zeroed(s->room + 1);
    return s->before == NULL || s->now == NULL || s->bytes == NULL ? out_of_memory(name, f) : 0;
}

/* For so many bytes more, which are zeros. */
static int make_room(sequence *s, uint64_t more) {
    if (s->size + more > s->room) {
        const uint64_t room = s->room + s->room / 2 + more + 65536;
        unsigned char *bytes = heap_resize(s->bytes, room);
        if (bytes == NULL) {
            return -1;
        }
        s->bytes = bytes;
        s->room = room;
    }
    memset(s->bytes + s->size, 0, (size_t)more);
    return 0;
}

/* Vertices as they are: blocks are made of them at the end. */
static int add_still(sequence *s, const char *name, fail *f) {
    const uint64_t bytes = (uint64_t)s->vertices * sizeof *s->now;
    if (make_room(s, bytes) != 0) {
        return out_of_memory(name, f);
    }
    memcpy(s->bytes + s->size, s->now, (size_t)bytes);
    s->size += bytes;
    s->frames++;
    return 0;
}

int sequence_add(sequence *s, const mesh *frame, const char *name, fail *f) {
    read_words(s, frame);
    if (s->options.stills) {
        return add_still(s, name, f);
    }
    plt_put_u32(s->bytes + 4 * (size_t)s->frames, (uint32_t)s->size);
    for (size_t first = 0; first < s->vertices; first += PLT_FRAME_BLOCK) {
        const size_t left = s->vertices - first;
        const uint32_t count = left < PLT_FRAME_BLOCK ? (uint32_t)left : PLT_FRAME_BLOCK;
        if (make_room(s, PLT_FRAME_BLOCK_MOST + PLT_BITS_BEHIND) != 0) {
            return out_of_memory(name, f);
        }
        s->size += write_block(s, s->bytes + s->size, first, count);
    }
    if (image_size_check(name, frame->triangles, s->size, 1, size_remedy(), f) != 0) {
        return -1;
    }
    plt_frame_vertex *was = s->before;
    s->before = s->now;
    s->now = was;
    s->frames++;
    plt_put_u32(s->bytes + 4 * (size_t)s->frames, (uint32_t)s->size);
    return 0;
}

/* ---- the image -------------------------------------------------------------------- */

/* Of each triangle, or of each vertex of blocks. */
static void write_topology(const sequence *s, const mesh *m, const plt_info *info,
                           unsigned char *to) {
    const uint32_t width = plt_index_bits(s->vertices);
    const int moves = plt_header_moves(info);
    for (uint64_t i = 0; i < plt_header_numbers(info); i++) {
        const uint64_t at = i * width;
        plt_bits_put(to + (at >> 3), (uint32_t)(at & 7), width,
                     moves ? s->moving.of_blocks[i] : s->number[m->triangle[i]]);
    }
}

static void describe(const sequence *s, plt_header *h) {
    h->info.vertices = s->vertices;
    h->info.frames = s->frames;
    h->info.frame_rate = s->options.frame_rate;
    h->info.key_every = s->options.key_every;
    h->info.frame_bytes = (uint32_t)s->size;
    h->info.lattice_bits = (uint8_t)s->options.lattice.bits;
    h->lattice = s->options.lattice;
    if (h->info.nodes_format == PLT_NODES_COMPACT) {
        h->info.geometry_format = s->options.stills ? PLT_GEOMETRY_STILLS : PLT_GEOMETRY_MOVING;
        h->info.block_vertices = s->moving.count;
    }
    if (s->options.stills) {
        h->info.key_every = 1;
        h->info.frame_bytes = 0;
    }
}

/* The header of the image without frames, with its sections' checksums. */
static int read_header(plt_header *h, const packed *image, const char *name, fail *f) {
    plt_fault fault;
    return plt_header_read(h, image->bytes, image->size, &fault) == PLT_OK
               ? 0
               : fail_set(f, name, "%s; please report this", fault.message);
}

/* Positions of blocks are those of the first frame. */
static int put_first(sequence *s, const mesh *m, plt_header *h, unsigned char *bytes,
                     const unsigned char *numbers) {
    const plt_section *ids = plt_header_section(h, PLT_SECTION_PRIMITIVE_IDS);
    plt_lattice_box box;
    read_words(s, m); /* all frames have been written */
    const int status =
        moving_put(h, bytes + plt_header_section(h, PLT_SECTION_BLOCKS)->offset,
                   ids == NULL ? NULL : bytes + ids->offset, 0, s->now, numbers, &box);
    moving_set_box(h, &box);
    return status;
}

/* Checksums, of what is there. */
static void seal(const sequence *s, plt_header *h, unsigned char *bytes) {
    for (unsigned i = 0; i < PLT_SECTIONS_MOST; i++) {
        plt_section *now = &h->section[i];
        const uint64_t used = now->kind == PLT_SECTION_FRAMES ? offsets_bytes(s) : now->bytes;
        now->crc = plt_crc32(0, bytes + now->offset, (size_t)used);
    }
    plt_header_write(bytes, h);
}

static int fill(sequence *s, const packed *image, const mesh *m, plt_header *h,
                unsigned char *bytes, uint64_t size) {
    const uint64_t topology = plt_header_section_bytes(&h->info, PLT_SECTION_TOPOLOGY);
    unsigned char *at = bytes + image->size;
    memcpy(bytes, image->bytes, image->size);
    memset(at, 0, (size_t)(size - image->size));
    write_topology(s, m, &h->info, at);
    memcpy(at + topology, s->bytes, (size_t)s->size);
    plt_header_write(bytes, h); /* where sections are */
    if (plt_header_moves(&h->info) && put_first(s, m, h, bytes, at) != 0) {
        return -1;
    }
    seal(s, h, bytes);
    return 0;
}

/* All blocks once for each frame, refitted by the engine's own code; then the ids, as they are in
 * the first, whose checks the blocks of all frames have. */
static int fill_stills(sequence *s, const packed *image, const mesh *m, plt_header *h,
                       unsigned char *bytes, uint64_t size) {
    const size_t used = (size_t)h->info.node_bytes + h->info.triangle_bytes;
    const size_t ids_bytes = h->info.primitive_id_bytes;
    const uint64_t topology = plt_header_section_bytes(&h->info, PLT_SECTION_TOPOLOGY);
    unsigned char *numbers = heap_get_zeroed(topology);
    int status = numbers == NULL ? -1 : 0;
    memset(bytes, 0, (size_t)size);
    plt_header_write(bytes, h);
    const plt_section *ids = plt_header_section(h, PLT_SECTION_PRIMITIVE_IDS);
    if (status == 0) {
        write_topology(s, m, &h->info, numbers);
    }
    if (ids != NULL) {
        memcpy(bytes + ids->offset, image->bytes + image->size - ids_bytes, ids_bytes);
    }
    for (uint32_t k = 0; k < s->frames && status == 0; k++) {
        const plt_frame_vertex *vertex =
            (const plt_frame_vertex *)(const void *)s->bytes + (size_t)k * s->vertices;
        unsigned char *first_blocks = bytes + h->section[0].offset,
                      *blocks = first_blocks + k * used;
        plt_lattice_box box;
        memcpy(blocks, k == 0 ? image->bytes + PLT_HEADER_BYTES : first_blocks, used);
        status = moving_put(h, blocks, ids == NULL || k > 0 ? NULL : bytes + ids->offset, k, vertex,
                            numbers, &box);
        if (k == 0) {
            moving_set_box(h, &box);
        }
    }
    heap_drop(numbers);
    seal(s, h, bytes);
    return status;
}

int sequence_finish(sequence *s, packed *image, const mesh *first, const char *name, fail *f) {
    plt_header h;
    if (read_header(&h, image, name, f) != 0) {
        return -1;
    }
    describe(s, &h);
    const uint64_t size =
        s->options.stills
            ? PLT_HEADER_BYTES + plt_header_section_bytes(&h.info, PLT_SECTION_STILLS) +
                  h.info.primitive_id_bytes
            : image->size + plt_header_section_bytes(&h.info, PLT_SECTION_TOPOLOGY) +
                  plt_header_section_bytes(&h.info, PLT_SECTION_FRAMES);
    if (image_size_check(name, first->triangles, size, 0, size_remedy(), f) != 0) {
        return -1;
    }
    unsigned char *bytes = heap_get_aligned(size);
    if (bytes == NULL) {
        return out_of_memory(name, f);
    }
    if ((s->options.stills ? fill_stills : fill)(s, image, first, &h, bytes, size) != 0) {
        heap_drop(bytes);
        return out_of_memory(name, f);
    }
    pack_free(image);
    *image = (packed){.bytes = bytes, .size = (uint32_t)size, .info = h.info};
    return 0;
}

void sequence_free(sequence *s) {
    heap_drop(s->number);
    heap_drop(s->before);
    heap_drop(s->now);
    heap_drop(s->bytes);
    heap_drop(s->moving.of_blocks);
    *s = (sequence){.number = NULL};
}
