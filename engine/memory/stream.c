/* stream - see stream.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/memory/stream.h"

#include "engine/base/fault.h"
#include "engine/memory/prefetch.h"
#include "engine/tree/compact/turns.h"
#include "engine/tree/compact/validate_block.h"

/* A part that is needed: of which block, which of its parts, and where that lies in the image. */
typedef struct part_of {
    plt_stream *stream;
    plt_stream_block *block;
    uint32_t link, offset, count;
    enum plt_stream_part kind;
    uint32_t against; /* serial of the part that it is validated against; 0: none */
} part_of;

void plt_stream_init(plt_stream *s, void *memory, uint32_t bytes) {
    plt_fetcher_init(&s->fetcher, memory, bytes);
    s->current = NULL;
    for (unsigned i = 0; i < PLT_BLOCK_CACHE_SLOTS; i++) {
        s->cache[i].opened.link = PLT_LINK_NONE;
    }
}

static uint32_t end_bytes(const plt_stream *s, float end) {
    return end < 16777216.0f ? 8 * (uint32_t)end : s->tree.used;
}

float plt_stream_edge_end(const plt_stream_block *block, uint32_t link) {
    const plt_block *b = &block->opened.block;
    const uint32_t from = plt_block_address(link);
    float end = block->end;
    for (uint32_t i = 0; i < b->edges; i++) {
        const uint32_t address = plt_block_address(plt_block_edge(b, i));
        if (address > from && plt_stream_end(address) < end) {
            end = plt_stream_end(address);
        }
    }
    return end;
}

static int refuse(plt_stream *s, int rule, uint32_t offset) {
    return plt_broken(&s->fetcher.fault, (uint8_t)rule, offset, plt_block_rule_message(rule));
}

int plt_stream_refuse(plt_stream *s, uint8_t rule) {
    const uint32_t address = plt_block_address(s->current->opened.link);
    s->current = NULL;
    return refuse(s, rule, s->image.blocks_at + address);
}

/* ---- parts ------------------------------------------------------------- */

/* The byte of the ids section that holds the first of the block's ids. */
static uint32_t first_id_byte(const plt_stream *s, const plt_geometry *g) {
    return (uint32_t)((uint64_t)g->first_triangle * s->tree.ids.bits >> 3);
}

static part_of nodes_of(plt_stream *s, plt_stream_block *b, uint32_t link) {
    const part_of a = {.stream = s,
                       .block = b,
                       .link = link,
                       .offset = s->image.blocks_at + plt_block_address(link),
                       .count = plt_block_node_bytes(link),
                       .kind = PLT_STREAM_NODES};
    return a;
}

static part_of geometry_of(plt_stream *s, plt_stream_block *b) {
    const plt_opened_block *o = &b->opened;
    const part_of a = {.stream = s,
                       .block = b,
                       .link = o->link,
                       .offset =
                           s->image.blocks_at + plt_block_address(o->link) + o->block.node_bytes,
                       .count = o->block.geometry_bytes,
                       .kind = PLT_STREAM_GEOMETRY,
                       .against = b->found[PLT_STREAM_NODES].serial};
    return a;
}

static part_of ids_of(plt_stream *s, plt_stream_block *b, const plt_geometry *g) {
    const uint32_t from = first_id_byte(s, g);
    const uint64_t bits = ((uint64_t)g->first_triangle + g->triangles) * s->tree.ids.bits;
    const part_of a = {.stream = s,
                       .block = b,
                       .link = b->opened.link,
                       .offset = s->image.ids_at + from,
                       .count = (uint32_t)((bits + 7) >> 3) - from,
                       .kind = PLT_STREAM_IDS,
                       .against = b->found[PLT_STREAM_GEOMETRY].serial};
    return a;
}

/* ---- what is valid ---------------------------------------------------- */

static int links_differ(const plt_block *b) {
    int differ = 1;
    for (uint32_t i = 0; i < b->edges; i++) {
        for (uint32_t k = 0; k < i; k++) {
            const uint32_t one = plt_block_edge(b, i), other = plt_block_edge(b, k);
            differ &= plt_block_address(one) != plt_block_address(other);
        }
    }
    return differ;
}

/* Behind the block, and in front of where its subtree ends. */
static int links_are_below(const plt_block *b, uint32_t address, uint32_t end) {
    const uint32_t from = address + plt_block_bytes(b);
    int below = 1;
    for (uint32_t i = 0; i < b->edges; i++) {
        const uint32_t to = plt_block_address(plt_block_edge(b, i));
        below &= to >= from && to < end;
    }
    return below;
}

static int nodes_rule(plt_stream *s, const part_of *a, uint16_t part) {
    plt_block b;
    uint16_t depth[PLT_BLOCK_NODES_MOST];
    const uint32_t address = plt_block_address(a->link), end = end_bytes(s, a->block->end);
    const int rule = plt_block_validate_nodes(&b, plt_store_bytes(&s->fetcher.store, part),
                                              a->count, end - address, &s->tree);
    if (rule != PLT_BLOCK_VALID) {
        return rule;
    }
    s->fetcher.store.part[part].depth = (uint8_t)plt_block_depths(&b, depth);
    return links_differ(&b) ? PLT_BLOCK_VALID : PLT_I17_LINKS;
}

/* Its triangles are some of the scene's. */
static int counts_are_inside(const plt_stream *s, const plt_geometry *g) {
    const uint32_t left = s->image.triangles - g->triangles;
    return g->triangles <= s->image.triangles && g->first_triangle <= left;
}

static int geometry_rule(const plt_stream *s, const part_of *a, uint16_t part) {
    plt_block b = a->block->opened.block;
    b.geometry = plt_store_bytes(&s->fetcher.store, part);
    const int rule = plt_block_validate_geometry(&b, &s->tree);
    if (rule != PLT_BLOCK_VALID) {
        return rule;
    }
    plt_geometry g;
    plt_geometry_open_counts(&g, &b, s->tree.leaf_triangles);
    return counts_are_inside(s, &g) ? PLT_BLOCK_VALID : PLT_I18_COUNTS;
}

/* The check is the geometry part's, which is there and held. */
static int ids_are_right(const part_of *a, const unsigned char *ids) {
    const plt_block *b = &a->block->opened.block;
    const uint32_t last = plt_get_u32(b->geometry + b->geometry_bytes - 4);
    return plt_block_ids_check(ids, a->count) == last >> 16;
}

static int ids_rule(const plt_stream *s, const part_of *a, uint16_t part) {
    const plt_geometry *g = &a->block->opened.geometry;
    const plt_primitive_ids ids = {plt_store_bytes(&s->fetcher.store, part), s->tree.ids.bits,
                                   first_id_byte(s, g)};
    int valid = 1;
    if (s->tree.ids_check_bytes > 0 && !ids_are_right(a, ids.bytes)) {
        return PLT_I13_CHECK;
    }
    for (uint32_t i = 0; i < g->triangles; i++) {
        const uint32_t word = plt_primitive_word_find(&ids, g->first_triangle + i);
        valid &= plt_primitive_id(word) < s->image.source_triangles;
        valid &= plt_primitive_rotation(word) <= 2;
    }
#if PLT_WITH_STILLS
    if (valid && s->tree.moves) { /* they turn with the frame */
        plt_block_turn(&a->block->opened.block, g, plt_store_bytes(&s->fetcher.store, part),
                       s->tree.ids.bits);
    }
#endif
    return valid ? PLT_BLOCK_VALID : PLT_I19_IDS;
}

static int rule_of(const part_of *a, uint16_t part) {
    switch (a->kind) {
    case PLT_STREAM_NODES:
        return nodes_rule(a->stream, a, part);
    case PLT_STREAM_GEOMETRY:
        return geometry_rule(a->stream, a, part);
    default:
        return ids_rule(a->stream, a, part);
    }
}

static int check_part(const void *context, uint16_t part);

/* Parts have their names by where their blocks lie, which are multiples of 8. */
static uint32_t key_of(uint32_t link, uint32_t kind) {
    return plt_block_address(link) + kind;
}

static plt_wanted wanted(const part_of *a) {
    const plt_wanted w = {.key = key_of(a->link, a->kind),
                          .offset = a->offset,
                          .count = a->count,
                          .against = a->against,
                          .bit = plt_block_address(a->link) / 8 + a->kind,
                          .is_treelet = a->kind == PLT_STREAM_NODES,
                          .check = check_part,
                          .context = a};
    return w;
}

#if PLT_WITH_PREFETCH
static void ask_for(const part_of *a) {
    const plt_wanted w = wanted(a);
    plt_prefetch_ask(&a->stream->fetcher, &w);
}

/* Ids come while the triangles that they belong to are validated: where they lie is known, if
 * nobody lies. The triangles must not move meanwhile. */
static void expect_ids(const part_of *triangles, uint16_t part) {
    plt_stream *s = triangles->stream;
    plt_block b = triangles->block->opened.block;
    plt_geometry g;
    if (s->fetcher.ahead == 0 || s->tree.ids.bits == 0 || b.leaves == 0 ||
        b.geometry_bytes < PLT_GEOMETRY_HEADER_BYTES) {
        return;
    }
    b.geometry = plt_store_bytes(&s->fetcher.store, part);
    plt_geometry_open_counts(&g, &b, s->tree.leaf_triangles);
    if (counts_are_inside(s, &g)) {
        const part_of a = ids_of(s, triangles->block, &g);
        s->fetcher.store.part[part].held = 1;
        ask_for(&a);
        s->fetcher.store.part[part].held = 0;
    }
}

/* Triangles that are not valid may have said wrongly where their ids lie: what has come of it has
 * the name of the right ones, and is forgotten. Ids that were used before stay. */
static void forget_ids(const part_of *triangles) {
    plt_fetcher *f = &triangles->stream->fetcher;
    const uint16_t ids = plt_store_find(&f->store, key_of(triangles->link, PLT_STREAM_IDS));
    if (ids != PLT_STORE_NONE && f->store.part[ids].fresh && plt_prefetch_arrive(f, ids)) {
        plt_store_forget(&f->store, ids);
    }
}
#else
static void expect_ids(const part_of *triangles, uint16_t part) {
    (void)triangles;
    (void)part;
}

static void forget_ids(const part_of *triangles) {
    (void)triangles;
}
#endif

static int check_part(const void *context, uint16_t part) {
    const part_of *a = context;
    if (a->kind == PLT_STREAM_GEOMETRY) {
        expect_ids(a, part);
    }
    const int rule = rule_of(a, part);
    if (rule == PLT_BLOCK_VALID) {
        return PLT_OK;
    }
    if (a->kind == PLT_STREAM_GEOMETRY) {
        forget_ids(a);
    }
    return refuse(a->stream, rule, a->offset);
}

static int need_part(const part_of *a) {
    const plt_wanted w = wanted(a);
    return plt_fetcher_need(&a->stream->fetcher, &w, &a->block->found[a->kind]);
}

static int is_there(plt_stream *s, const plt_stream_block *b, enum plt_stream_part kind) {
    return plt_fetcher_has(&s->fetcher, key_of(b->opened.link, kind), &b->found[kind]);
}

static const unsigned char *bytes_of(const plt_stream *s, const plt_stream_block *b,
                                     enum plt_stream_part kind) {
    return plt_fetcher_bytes(&s->fetcher, &b->found[kind]);
}

/* ---- blocks ------------------------------------------------------------ */

/* May be fetched: it lies within its subtree. */
static int is_within(const plt_stream *s, uint32_t link, float end) {
    const uint32_t address = plt_block_address(link), last = end_bytes(s, end);
    return address < last && plt_block_node_bytes(link) <= last - address;
}

static int open_nodes(plt_stream *s, plt_stream_block *b, uint32_t link, float end) {
    b->opened.link = PLT_LINK_NONE;
    b->end = end;
    if (!is_within(s, link, end)) {
        return refuse(s, PLT_I17_LINKS, s->image.blocks_at); /* before anything is fetched */
    }
    const part_of a = nodes_of(s, b, link);
    const int status = need_part(&a);
    if (status != PLT_OK) {
        return status;
    }
    plt_opened_block_set(&b->opened, bytes_of(s, b, PLT_STREAM_NODES), &s->tree, link);
    const plt_block *block = &b->opened.block;
    if (block->node_bytes != a.count ||
        !links_are_below(block, plt_block_address(link), end_bytes(s, end))) {
        b->opened.link = PLT_LINK_NONE;
        return refuse(s, PLT_I17_LINKS, a.offset);
    }
    b->found[PLT_STREAM_GEOMETRY].part = b->found[PLT_STREAM_IDS].part = PLT_STORE_NONE;
    return PLT_OK;
}

#if PLT_WITH_PREFETCH
void plt_stream_expect(plt_stream *s, uint32_t link, float end) {
    if (is_within(s, link, end)) {
        const part_of a = nodes_of(s, NULL, link);
        ask_for(&a);
    }
}

void plt_stream_expect_geometry(plt_stream *s) {
    plt_store_part *nodes = plt_fetcher_part(&s->fetcher, &s->current->found[PLT_STREAM_NODES]);
    const part_of a = geometry_of(s, s->current);
    s->expects = 1;
    if (a.count > 0) {
        nodes->held = 1;
        ask_for(&a);
        nodes->held = 0;
    }
}
#endif

/* Of the leaf of that index: is it a pair, and how many pairs are before it? */
static int is_leaf(const plt_block *b, uint32_t leaf, uint32_t pairs, uint32_t pair) {
    for (uint32_t w = 0; 32 * w < 2 * b->nodes; w++) {
        uint32_t leaves = ~(b->mask[PLT_SLOT_INNER][w] | b->mask[PLT_SLOT_EDGE][w]) &
                          plt_low_bits(2 * b->nodes - 32 * w);
        const uint32_t count = plt_count_bits(leaves);
        if (leaf < count) {
            for (; leaf > 0; leaf--) {
                leaves &= leaves - 1;
            }
            const uint32_t bit = leaves & (0u - leaves);
            const uint32_t before = plt_count_bits(b->pair[w] & (bit - 1));
            return b->pairs_before[w] + before == pairs && ((b->pair[w] & bit) != 0) == pair;
        }
        leaf -= count;
    }
    return 0;
}

int plt_stream_has_node(const plt_stream *s, uint32_t node) {
    return node < s->current->opened.block.nodes;
}

int plt_stream_has_leaf(const plt_stream *s, uint32_t leaf, uint32_t pairs, uint32_t pair) {
    return is_leaf(&s->current->opened.block, leaf, pairs, pair);
}

int plt_stream_has(const plt_stream *s, uint32_t link) {
    return plt_store_has(&s->fetcher.store, plt_block_address(link));
}

int plt_stream_has_geometry(const plt_stream *s) {
    return plt_store_has(&s->fetcher.store, key_of(s->current->opened.link, PLT_STREAM_GEOMETRY));
}

int plt_stream_open(plt_stream *s, uint32_t link, float end) {
    plt_stream_block *b = &s->cache[plt_block_cache_slot(link)];
    if (b->opened.link != link || b->end != end || !is_there(s, b, PLT_STREAM_NODES)) {
        s->current = NULL;
        const int status = open_nodes(s, b, link, end);
        if (status != PLT_OK) {
            return status;
        }
    }
    s->current = b;
#if PLT_WITH_PREFETCH
    s->expects = 0;
#endif
    return PLT_OK;
}

static int open_geometry(plt_stream *s, plt_stream_block *b) {
    plt_opened_block *o = &b->opened;
    const part_of a = geometry_of(s, b);
    b->found[PLT_STREAM_IDS].part = PLT_STORE_NONE; /* are checked against it again */
    const int status = a.count > 0 ? need_part(&a) : refuse(s, PLT_I14_GEOMETRY, a.offset);
    if (status == PLT_OK) {
        o->block.geometry = bytes_of(s, b, PLT_STREAM_GEOMETRY);
        plt_opened_block_geometry(o, &s->tree);
    }
    return status;
}

/* Parts that are open already are not fetched again. Those of the same block are held meanwhile,
 * as they must not move. */
static int open_both(plt_stream *s, plt_stream_block *b) {
    int status = is_there(s, b, PLT_STREAM_GEOMETRY) ? PLT_OK : open_geometry(s, b);
    if (status == PLT_OK && s->tree.ids.bits > 0 && !is_there(s, b, PLT_STREAM_IDS)) {
        plt_store_part *geometry = plt_fetcher_part(&s->fetcher, &b->found[PLT_STREAM_GEOMETRY]);
        geometry->held = 1;
        const part_of ids = ids_of(s, b, &b->opened.geometry);
        status = need_part(&ids);
        geometry->held = 0;
    }
    return status;
}

int plt_stream_open_geometry(plt_stream *s) {
    plt_stream_block *b = s->current;
    plt_store_part *nodes = plt_fetcher_part(&s->fetcher, &b->found[PLT_STREAM_NODES]);
    nodes->held = 1;
    const int status = open_both(s, b);
    nodes->held = 0;
    s->current = status == PLT_OK ? b : NULL;
    if (status == PLT_OK && s->tree.ids.bits > 0) {
        s->tree.ids.bytes = bytes_of(s, b, PLT_STREAM_IDS);
        s->tree.ids.first = first_id_byte(s, &b->opened.geometry);
    }
    return status;
}
