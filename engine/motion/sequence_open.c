/* sequence_open - what of a sequence is read when its image is opened
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/crc32_long.h"
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/fetch.h"
#include "engine/motion/sequence.h"

/* With what a bit reader may look at behind them. */
static uint32_t topology_bytes(const plt_info *info) {
    return (uint32_t)plt_header_section_bytes(info, PLT_SECTION_TOPOLOGY);
}

/* One offset per frame, and where the last one ends. */
static uint32_t offsets_bytes(const plt_info *info) {
    return 4 * (info->frames + 1);
}

uint64_t plt_sequence_topology_bytes(const plt_info *info) {
    return topology_bytes(info);
}

uint64_t plt_sequence_offsets_bytes(const plt_info *info) {
    return offsets_bytes(info);
}

uint64_t plt_sequence_vertices_bytes(const plt_info *info) {
    return (uint64_t)info->vertices * sizeof(plt_frame_vertex) + 4; /* four lanes of the last one */
}

/* `count` bytes from the begin of a section, where they lie mapped or in `room`, with its sum. */
static int read_part(const plt_source *source, const plt_section *section, unsigned char *room,
                     uint32_t count, plt_frame_vertex *scratch, size_t scratch_words,
                     const unsigned char **bytes, plt_fault *fault) {
    int status = PLT_OK;
    if (room == NULL) {
        *bytes = (const unsigned char *)source->mapped + section->offset;
    } else {
        *bytes = room;
        status = plt_fetch(source, section->offset, room, count, fault);
    }
    if (status == PLT_OK &&
        plt_crc32_long(*bytes, count, scratch->word, scratch_words) != section->crc) {
        return plt_refused(fault, PLT_R13_SECTION_CRC, section->offset,
                           "a section is damaged (checksum)");
    }
    return status;
}

static int check_offsets(const plt_sequence *s, const plt_info *info, plt_fault *fault) {
    uint32_t before = offsets_bytes(info);
    int good = plt_get_u32(s->offsets) == before;
    for (uint32_t i = 0; i <= info->frames && good; i++) {
        const uint32_t at = plt_get_u32(s->offsets + 4 * (size_t)i);
        good = at >= before && at <= info->frame_bytes && at % 4 == 0 &&
               (i < info->frames || at == info->frame_bytes);
        before = at;
        if (!good) {
            return plt_broken(fault, PLT_I23_OFFSETS, s->section + 4 * i,
                              "a frame does not lie behind the one before it");
        }
    }
    return good ? PLT_OK
                : plt_broken(fault, PLT_I23_OFFSETS, s->section,
                             "the first frame is not where it must be");
}

static int check_topology(const plt_sequence *s, const plt_section *section, const plt_info *info,
                          plt_fault *fault) {
    const uint32_t bits = s->vertices.index_bits;
    const uint32_t numbers = (uint32_t)plt_header_numbers(info);
    for (uint32_t i = 0; i < numbers; i++) {
        const uint64_t at = (uint64_t)i * bits;
        if (plt_bits_get(s->vertices.topology + (size_t)(at >> 3), (uint32_t)(at & 7), bits) >=
            info->vertices) {
            const uint64_t first = plt_header_moves(info) ? i : i - i % 3;
            return plt_broken(fault, PLT_I24_TOPOLOGY,
                              section->offset + (uint32_t)(first * bits >> 3),
                              "a triangle of the sequence has a vertex that is not there");
        }
    }
    return PLT_OK;
}

static void describe(plt_sequence *s, const plt_header *header, const plt_source *source,
                     const plt_sequence_room *room) {
    const plt_info *info = &header->info;
    *s = (plt_sequence){.vertex = room->vertex,
                        .reader = {.source = source, .window = room->window},
                        .count = info->vertices,
                        .frames = info->frames,
                        .key_every = info->key_every,
                        .section = plt_header_section(header, PLT_SECTION_FRAMES)->offset,
                        .at = PLT_FRAME_NONE};
    s->vertices = (plt_vertices){.vertex = room->vertex,
                                 .index_bits = plt_index_bits(info->vertices),
                                 .lattice = header->lattice};
#if PLT_WITH_VERTICES
    s->base = room->vertex;
#endif
    s->word_bits = header->lattice.bits > 0 ? header->lattice.bits : PLT_FRAME_FLOAT_BITS;
}

int plt_sequence_open(plt_sequence *s, const plt_header *header, const plt_source *source,
                      const plt_sequence_room *room, plt_fault *fault) {
    const plt_info *info = &header->info;
    const plt_section *topology = plt_header_section(header, PLT_SECTION_TOPOLOGY);
    const size_t words = 3 * (size_t)info->vertices;
    describe(s, header, source, room);
    int status = read_part(source, topology, room->topology, topology->bytes, room->vertex, words,
                           &s->vertices.topology, fault);
    if (status == PLT_OK) {
        status = read_part(source, plt_header_section(header, PLT_SECTION_FRAMES), room->offsets,
                           offsets_bytes(info), room->vertex, words, &s->offsets, fault);
    }
    if (status == PLT_OK) {
        status = check_offsets(s, info, fault);
    }
    return status == PLT_OK ? check_topology(s, topology, info, fault) : status;
}
