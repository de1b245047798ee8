/* open - from an image to an engine in an arena
 *
 * SPDX-License-Identifier: MIT */
#include "engine/base/fault.h"
#include "engine/budget.h"
#include "engine/image/fetch.h"
#include "engine/opening.h"
#include "engine/planelet_crc32.h"

static const plt_fault no_fault = {0, 0, 0, 0, "no fault"};

static int valid_source(const plt_source *s) {
    return s->mapped != NULL ? (uintptr_t)s->mapped % PLT_ALIGN == 0
                             : s->start != NULL && s->wait != NULL;
}

static int read_header(const plt_source *source, plt_header *header, plt_fault *fault) {
    unsigned char bytes[PLT_HEADER_BYTES];
    if (source->bytes < PLT_HEADER_BYTES) {
        return plt_refused(fault, 1, source->bytes, "the image is shorter than its header");
    }
    const int status = plt_fetch(source, 0, bytes, PLT_HEADER_BYTES, fault);
    return status == PLT_OK ? plt_header_read(header, bytes, source->bytes, fault) : status;
}

int plt_image_info(const plt_source *source, plt_info *info, plt_fault *fault) {
    plt_header header;
    *fault = no_fault;
    if (!valid_source(source)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "the source is not aligned or not whole");
    }
    const int status = read_header(source, &header, fault);
    if (status == PLT_OK) {
        *info = header.info;
    }
    return status;
}

int plt_opening_short(const plt_opening *o) {
    const plt_engine *e = o->e;
    return plt_arena_short(o->fault,
                           plt_arena_need(&e->header.info, e->source.mapped != NULL, &e->options));
}

/* A section where it lies, or fetched into the arena; its checksum is right. */
int plt_opening_section(const plt_opening *o, uint32_t kind, int copy, const void **bytes) {
    plt_engine *e = o->e;
    const plt_section *s = plt_header_section(&e->header, kind);
    if (e->source.mapped != NULL && !copy) {
        *bytes = (const unsigned char *)e->source.mapped + s->offset;
    } else {
        void *to = plt_arena_cut(&e->arena, s->bytes);
        if (to == NULL) {
            return plt_opening_short(o);
        }
        const int status = plt_fetch(&e->source, s->offset, to, s->bytes, o->fault);
        if (status != PLT_OK) {
            return status;
        }
        *bytes = to;
    }
    if (plt_crc32(0, *bytes, s->bytes) != s->crc) {
        return plt_refused(o->fault, 13, s->offset, "a section is damaged (checksum)");
    }
    return PLT_OK;
}

/* Everything that depends on neither the scene nor its building comes last,
 * where scratch was. */
static int cut_rest(const plt_opening *o) {
    plt_engine *e = o->e;
    plt_walker *w = &e->walker;
    const plt_info *info = &e->header.info;
    const size_t entry = plt_budget_entry(info);
    if (info->global_stack_entries > PLT_GLOBAL_STACK_MAX) {
        return plt_limit(o->fault, "the scene needs more than PLT_GLOBAL_STACK_MAX entries");
    }
    e->touched_words = plt_budget_touched_words(info);
    w->touched = plt_arena_cut(&e->arena, 4 * (size_t)e->touched_words);
    w->packet.group = plt_arena_cut(&e->arena, plt_budget_groups(&e->options));
    e->film = plt_arena_cut(&e->arena, 3 * PLT_TILE_SIDE * PLT_TILE_SIDE);
    void *stack = plt_arena_cut(&e->arena, plt_budget_main_stack(info, &e->options) * entry);
    w->local = plt_arena_cut(&e->arena, plt_budget_local_stack(info, &e->options) * entry);
    w->blocks.open = plt_arena_cut(&e->arena, plt_budget_open_blocks(info));
    if (w->touched == NULL || w->packet.group == NULL || e->film == NULL || stack == NULL ||
        w->local == NULL || w->blocks.open == NULL) {
        return plt_opening_short(o);
    }
    if (w->compact) {
        w->blocks.stack = stack;
        plt_block_cache_clear(w->blocks.open);
    } else {
        w->stack = stack;
    }
    return PLT_OK;
}

static int lay_out(const plt_opening *o) {
    plt_engine *e = o->e;
    e->walker.compact = e->header.info.nodes_format == PLT_NODES_COMPACT;
    const int status = e->walker.compact ? plt_opening_compact(o) : plt_opening_thesis(o);
    return status == PLT_OK ? cut_rest(o) : status;
}

/* What plt_open does, up to the building of blocks. */
int plt_open_begin(plt_engine **engine, void *arena, size_t arena_bytes, const plt_source *source,
                   const plt_options *options, plt_fault *fault) {
    plt_header header;
    *engine = NULL;
    *fault = no_fault;
    if (!plt_options_valid(options) || !valid_source(source) || (uintptr_t)arena % PLT_ALIGN != 0) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0,
                             "an option is out of range, or source or arena are not aligned");
    }
    int status = read_header(source, &header, fault);
    if (status != PLT_OK) {
        return status;
    }
    if (!plt_budget_walk_valid(&header.info, options)) {
        return plt_fault_set(fault, PLT_ERR_ARGUMENT, 0, "compact blocks are walked depth first");
    }
    plt_arena a = {arena, arena_bytes, 0, 0};
    plt_engine *e = plt_arena_cut(&a, sizeof *e);
    if (e == NULL) {
        return plt_arena_short(fault,
                               plt_arena_need(&header.info, source->mapped != NULL, options));
    }
    memset(e, 0, sizeof *e);
    e->arena = a;
    e->source = *source;
    e->options = *options;
    e->header = header;
    e->rendering.done = 1;
    const plt_opening o = {e, fault};
    status = lay_out(&o);
    if (status == PLT_OK) {
        plt_stats_reset(e);
    }
    if (status >= PLT_OK) {
        *engine = e;
    }
    return status;
}

int plt_open_step(plt_engine *e, uint32_t splits, plt_fault *fault) {
    const plt_opening o = {e, fault};
    *fault = no_fault;
    if (e->failed != PLT_OK) {
        return plt_fault_set(fault, e->failed, 0, "the opening has failed before");
    }
    if (!e->building) {
        return PLT_OK;
    }
    int status = plt_opening_step(&o, splits > 0 ? splits : 1);
    if (status == PLT_OK) {
        status = cut_rest(&o);
    }
    if (status == PLT_OK) {
        e->building = 0;
        plt_stats_reset(e);
    }
    e->failed = (int8_t)(status < 0 ? status : PLT_OK);
    return status;
}

int plt_open(plt_engine **engine, void *arena, size_t arena_bytes, const plt_source *source,
             const plt_options *options, plt_fault *fault) {
    int status = plt_open_begin(engine, arena, arena_bytes, source, options, fault);
    while (status == PLT_MORE) {
        status = plt_open_step(*engine, 0xFFFFFFFFu, fault);
    }
    if (status != PLT_OK) {
        *engine = NULL;
    }
    return status;
}
