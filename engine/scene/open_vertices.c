/* open_vertices - thesis nodes over triangles whose records are made when they are needed
 *
 * Records are validated as all are, but not kept: where the image is mapped, their id words are
 * read where they lie; else records are fetched some at a time, and their words stay.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/image/fetch.h"
#include "engine/planelet_crc32.h"
#include "engine/scene/open_formats.h"
#include "engine/scene/validate_thesis.h"
#include "engine/tree/validate_records.h"

#if PLT_WITH_VERTICES

/* Records that are fetched at once, at most, and bytes that sections are filled up with. */
enum { WINDOW_MOST = 1024, PADDING_MOST = 64 };

static int check_sum(const plt_opening *o, const plt_section *s, uint32_t crc) {
    return crc == s->crc ? PLT_OK
                         : plt_refused(o->fault, PLT_R13_SECTION_CRC, s->offset,
                                       "a section is damaged (checksum)");
}

/* Some records, from `at` on; with the last come what the section is filled up with. */
static int fetch_some(const plt_opening *o, const plt_header *header, plt_record *window,
                      uint32_t at, uint32_t count, uint32_t *crc) {
    const plt_section *s = plt_header_section(header, PLT_SECTION_TRIANGLES);
    const uint32_t before = at * PLT_RECORD_BYTES;
    const int is_last = at + count == header->info.triangles;
    const uint32_t bytes = is_last ? s->bytes - before : count * PLT_RECORD_BYTES;
    const int status = plt_fetch(o->source, s->offset + before, window, bytes, o->fault);
    if (status != PLT_OK) {
        return status;
    }
    *crc = plt_crc32(*crc, window, bytes);
    return is_last ? check_sum(o, s, *crc) : PLT_OK;
}

/* What is free of the arena is a window: what runs will be cut from it. */
static int fetch_words(const plt_opening *o, const plt_header *header, uint32_t *words) {
    const plt_arena *a = o->arena;
    plt_record *window = (plt_record *)(void *)(a->base + a->used);
    const size_t free_bytes = a->bytes - a->used;
    const size_t room =
        free_bytes > PADDING_MOST ? (free_bytes - PADDING_MOST) / sizeof *window : 0;
    const uint32_t most = room < WINDOW_MOST ? (uint32_t)room : WINDOW_MOST;
    uint32_t crc = 0, count = 0;
    int status = most > 0 ? PLT_OK : plt_opening_arena_error(o);
    for (uint32_t at = 0; at < header->info.triangles && status == PLT_OK; at += count) {
        const uint32_t left = header->info.triangles - at;
        count = left < most ? left : most;
        status = fetch_some(o, header, window, at, count, &crc);
        status = status == PLT_OK ? plt_records_validate_some(header, window, at, count, o->fault)
                                  : status;
        for (uint32_t i = 0; i < count; i++) {
            words[at + i] = window[i].word[9]; /* as it lies */
        }
    }
    return status;
}

static int read_mapped(const plt_opening *o, const plt_header *header) {
    const plt_section *section = plt_header_section(header, PLT_SECTION_TRIANGLES);
    const void *bytes = NULL;
    const int status = plt_opening_mapped(o, section, &bytes);
    const plt_record *records = bytes;
    o->scene->thesis.records = records;
    o->scene->vertices.words = &records->word[9];
    o->scene->vertices.stride = PLT_RECORD_BYTES / 4;
    return status == PLT_OK ? plt_records_validate(header, records, o->fault) : status;
}

static int read_fetched(const plt_opening *o, const plt_header *header) {
    uint32_t *words = plt_arena_cut(o->arena, 4 * (size_t)header->info.triangles);
    if (words == NULL) {
        return plt_opening_arena_error(o);
    }
    o->scene->thesis.words = o->scene->vertices.words = words;
    o->scene->vertices.stride = 1;
    return fetch_words(o, header, words);
}

int plt_open_vertices(const plt_opening *o, const plt_header *header,
                      struct plt_compact_build **build) {
    const void *nodes = NULL;
    plt_tree *tree = &o->scene->thesis;
    (void)build;
    tree->node_slots = header->info.node_slots;
    tree->records_count = header->info.triangles;
    tree->treelet_nodes = header->info.treelet_nodes;
    tree->root = header->root;
    int status = plt_opening_section(o, plt_header_section(header, PLT_SECTION_NODES), &nodes);
    tree->nodes = nodes;
    if (status == PLT_OK) {
        status = o->source->mapped != NULL ? read_mapped(o, header) : read_fetched(o, header);
    }
    return status == PLT_OK ? plt_thesis_validate_image(o, header, tree) : status;
}

#endif
