/* treelet_stream - see treelet_stream.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/memory/treelet_stream.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/memory/prefetch.h"
#include "engine/tree/record_ranges.h"
#include "engine/tree/thesis/checks.h"

/* Of a part in the store that has nodes, `depth` is that of the treelet, with this bit if edges
 * leave it, or 0 if it has more nodes than came; `more` is the number of its nodes, less 1. */
enum { HAS_EDGES = 0x80 };

/* A part that is needed: so many nodes from a slot on, or a page and its records. */
typedef struct part_of {
    plt_treelet_stream *stream;
    uint32_t first, offset, count;
} part_of;

/* Keys of parts are eights, and of a treelet alone, which comes in several lengths, which one. */
enum { KEY_STEP = 8, KEY_PAGE = 7 };

void plt_treelet_stream_init(plt_treelet_stream *s, void *memory, uint32_t bytes) {
    plt_fetcher_init(&s->fetcher, memory, bytes);
    s->first = PLT_MISS;
    s->starts.block = s->start;
    s->starts_known = 0;
}

static const char *message(int rule) {
    switch (rule) {
    case PLT_I1_LINKS:
        return "a link leads to no node, or not to the treelet that it says";
    case PLT_I3_LIST_ENDS:
        return "a list of triangles runs past the last one";
    case PLT_I5_CORNERS:
        return "a corner lies outside the scene's box";
    case PLT_I6_PLANES:
        return "a plane lies outside the scene's box";
    case PLT_I7_ID_WORDS:
        return "a triangle's id word is out of range";
    case PLT_I22_CHECKS:
        return "nodes or triangles are damaged (check)";
    case PLT_I8_COUNTS:
        return "the header's counts are not the tree's";
    default:
        return "the treelets form no tree, or are not in the order that streaming needs";
    }
}

static int refuse(plt_treelet_stream *s, int rule, uint32_t offset) {
    return plt_broken(&s->fetcher.fault, (uint8_t)rule, offset, message(rule));
}

static uint32_t node_at(const plt_treelet_stream *s, uint32_t slot) {
    return s->image.nodes_at + slot * PLT_NODE_BYTES;
}

int plt_treelet_stream_refuse(plt_treelet_stream *s, uint8_t rule) {
    const uint32_t first = s->first;
    s->first = PLT_MISS;
    return refuse(s, rule, node_at(s, first));
}

/* ---- what is valid ---------------------------------------------------- */

/* Of all nodes that have come, whose checks lie behind them. */
static int nodes_are_right(const plt_node *nodes, uint32_t count) {
    const uint8_t *check = (const void *)(nodes + count);
    int right = 1;
    for (uint32_t i = 0; i < count; i++) {
        right &= plt_node_check(&nodes[i]) == check[i];
    }
    return right;
}

static int nodes_rule(plt_treelet_stream *s, const part_of *of, uint16_t part) {
    plt_treelet_facts facts;
    const plt_node *nodes = (const void *)plt_store_bytes(&s->fetcher.store, part);
    if (s->image.checks_at > 0 && !nodes_are_right(nodes, of->count)) {
        return PLT_I22_CHECKS;
    }
    plt_store_part *p = &s->fetcher.store.part[part];
    const int rule = plt_treelet_validate(&s->scene, nodes, of->first, of->count, &facts);
    p->depth = 0;
    p->more = 0;
    if (rule != PLT_TREELET_VALID) {
        return rule == PLT_TREELET_GOES_ON ? PLT_TREELET_VALID : rule;
    }
    p->more = (uint8_t)(facts.nodes - 1);
    p->depth = (uint8_t)facts.depth;
    if (facts.edges == 0) {
        return PLT_TREELET_VALID;
    }
    p->depth |= HAS_EDGES;
    return plt_treelet_starts_find(&s->scene, nodes, of->first / of->count, &s->starts)
               ? PLT_TREELET_VALID
               : PLT_I2_TREE;
}

/* Of a page that has come; without checks, of any. */
static int page_is_right(const plt_treelet_stream *s, const plt_record *page) {
    uint16_t held;
    return s->image.checks_at == 0 || plt_page_check(page, &held) == held;
}

static int check_records(const void *context, uint16_t part) {
    const part_of *of = context;
    plt_treelet_stream *s = of->stream;
    const plt_record *r = (const void *)plt_store_bytes(&s->fetcher.store, part);
    if (!page_is_right(s, r)) {
        return refuse(s, PLT_I22_CHECKS, of->offset);
    }
    for (const plt_record *end = r + of->count; r < end; r++) {
        if (plt_record_outside(s->scene.box, r) != NULL) {
            return refuse(s, PLT_I5_CORNERS, of->offset);
        }
        if (!plt_is_id_word(plt_get_u32(&r->word[9]), s->scene.triangles, s->image.checks_at > 0)) {
            return refuse(s, PLT_I7_ID_WORDS, of->offset);
        }
    }
    return PLT_OK;
}

/* ---- nodes ------------------------------------------------------------- */

/* A treelet alone does not say how many nodes it has before they are there. Most have few; one that
 * turns out to go on comes again, longer, up to LENGTHS. (Its bit of `touched` is then that of its
 * next node, which is no other's.) Of other treelets there is one length, 0. */
enum { LENGTHS = 3 };

static int check_nodes(const void *context, uint16_t part);

/* So many of a treelet alone, whose length is i + 1. */
static inline uint32_t nodes_of(const plt_treelet_stream *s, uint32_t first, uint32_t i) {
    static const uint16_t nodes[LENGTHS] = {PLT_ALONE_NODES, 4 * PLT_ALONE_NODES, UINT16_MAX};
    const uint32_t rest = s->scene.treelet_nodes - first % s->scene.treelet_nodes;
    return nodes[i] < rest ? nodes[i] : rest;
}

static inline void want_nodes(plt_wanted *w, const part_of *of, uint32_t length) {
    const uint32_t checks_at = of->stream->image.checks_at;
    *w = (plt_wanted){.key = KEY_STEP * of->first + length,
                      .offset = of->offset,
                      .count = of->count * PLT_NODE_BYTES,
                      .beside_at = checks_at + of->first,
                      .beside = checks_at > 0 ? of->count : 0,
                      .bit = of->first + (length > 0 ? length - 1 : 0),
                      .is_treelet = length <= 1,
                      .check = check_nodes,
                      .context = of};
}

#if PLT_WITH_PREFETCH
static void ask_for_nodes(plt_treelet_stream *s, uint32_t first, uint32_t length) {
    const uint32_t count = length > 0 ? nodes_of(s, first, length - 1) : s->scene.treelet_nodes;
    const part_of of = {s, first, node_at(s, first), count};
    plt_wanted w;
    want_nodes(&w, &of, length);
    plt_prefetch_ask(&s->fetcher, &w);
}

/* Has the treelet more nodes than those, if what they say is true? */
static int goes_on(const plt_node *nodes, uint32_t count) {
    uint32_t next = 1, i = 0;
    for (; i < count && i < next; i++) {
        next += (uint32_t)plt_link_is_inner(plt_node_link(&nodes[i], 0));
        next += (uint32_t)plt_link_is_inner(plt_node_link(&nodes[i], 1));
    }
    return next > i;
}

/* What a treelet alone has more comes while its first nodes are validated: that there is more they
 * say, if they do not lie. They must not move meanwhile. */
static void expect_longer(const part_of *of, uint16_t part) {
    plt_treelet_stream *s = of->stream;
    plt_store_part *p = &s->fetcher.store.part[part];
    const uint32_t length = p->key % KEY_STEP;
    if (s->fetcher.ahead > 0 && length > 0 && length < LENGTHS &&
        goes_on((const void *)plt_store_bytes(&s->fetcher.store, part), of->count)) {
        p->held = 1;
        ask_for_nodes(s, of->first, length + 1);
        p->held = 0;
    }
}
#else
static void expect_longer(const part_of *of, uint16_t part) {
    (void)of;
    (void)part;
}
#endif

static int check_nodes(const void *context, uint16_t part) {
    const part_of *of = context;
    expect_longer(of, part);
    const int rule = nodes_rule(of->stream, of, part);
    return rule == PLT_TREELET_VALID ? PLT_OK : refuse(of->stream, rule, of->offset);
}

static int need_nodes(plt_treelet_stream *s, uint32_t first, uint32_t count, uint32_t length) {
    const part_of of = {s, first, node_at(s, first), count};
    plt_wanted w;
    want_nodes(&w, &of, length);
    return plt_fetcher_need(&s->fetcher, &w, &s->found);
}

static int need_alone(plt_treelet_stream *s, uint32_t first) {
    int status = PLT_OK;
    for (uint32_t i = 0; i < LENGTHS; i++) {
        status = need_nodes(s, first, nodes_of(s, first, i), i + 1);
        if (status != PLT_OK || plt_fetcher_part(&s->fetcher, &s->found)->depth != 0) {
            break;
        }
    }
    return status;
}

static int open_treelet(plt_treelet_stream *s, uint32_t first, uint32_t scope) {
    const int is_alone = (scope & PLT_TREELET_ALONE) != 0;
    s->first = PLT_MISS;
    s->starts_known = 0;
    const int status =
        is_alone ? need_alone(s, first) : need_nodes(s, first, s->scene.treelet_nodes, 0);
    if (status != PLT_OK) {
        return status;
    }
    const plt_store_part *part = plt_fetcher_part(&s->fetcher, &s->found);
    s->first = first;
    s->count = part->more + 1u;
    s->scope = scope;
    s->nodes = (const void *)plt_fetcher_bytes(&s->fetcher, &s->found);
    return is_alone && (part->depth & HAS_EDGES) != 0 ? plt_treelet_stream_refuse(s, PLT_I2_TREE)
                                                      : PLT_OK;
}

/* A place that has waited may find that its treelet has come anew, and is another. */
int plt_treelet_stream_has(const plt_treelet_stream *s, uint32_t slot) {
    uint32_t length = 0;
    while (length < LENGTHS && !plt_store_has(&s->fetcher.store, KEY_STEP * slot + length)) {
        length++;
    }
    return length < LENGTHS;
}

static uint32_t first_of(const plt_treelet_stream *s, uint32_t slot, uint32_t scope) {
    return (scope & PLT_TREELET_ALONE) != 0 ? scope & ~PLT_TREELET_ALONE
                                            : slot - slot % s->scene.treelet_nodes;
}

#if PLT_WITH_PREFETCH
/* Of a treelet alone the length that will be needed, as far as it is known. */
static uint32_t length_ahead(plt_treelet_stream *s, uint32_t first) {
    for (uint32_t length = 1; length < LENGTHS; length++) {
        const uint16_t i = plt_store_find(&s->fetcher.store, KEY_STEP * first + length);
        if (i == PLT_STORE_NONE || s->fetcher.store.part[i].fresh ||
            s->fetcher.store.part[i].depth != 0) {
            return length;
        }
    }
    return LENGTHS;
}

void plt_treelet_stream_expect(plt_treelet_stream *s, uint32_t slot, uint32_t scope) {
    const uint32_t first = first_of(s, slot, scope);
    s->first = PLT_MISS; /* it may move */
    ask_for_nodes(s, first, (scope & PLT_TREELET_ALONE) != 0 ? length_ahead(s, first) : 0);
}
#endif

int plt_treelet_stream_open(plt_treelet_stream *s, uint32_t slot, uint32_t scope) {
    const uint32_t first = first_of(s, slot, scope);
    if (first != s->first || scope != s->scope) {
        const int status = open_treelet(s, first, scope);
        if (status != PLT_OK) {
            return status;
        }
    }
    return slot - first < s->count ? PLT_OK : plt_treelet_stream_refuse(s, PLT_I1_LINKS);
}

uint32_t plt_treelet_stream_edge(plt_treelet_stream *s, uint32_t slot) {
    const uint32_t slots = s->scene.treelet_nodes, block = slot / slots, own = s->first / slots;
    uint32_t end = s->scope;
    if (block * slots != slot || block <= own || block >= end) {
        return PLT_TREELET_ALONE | slot;
    }
    if (!s->starts_known) {
        plt_treelet_starts_find(&s->scene, s->nodes, own, &s->starts);
        s->starts_known = 1;
    }
    for (uint32_t i = 0; i < s->starts.count; i++) {
        const uint32_t other = s->starts.block[i];
        end = other > block && other < end ? other : end;
    }
    return end;
}

/* ---- records ------------------------------------------------------------ */

static uint32_t record_at(const plt_treelet_stream *s, uint32_t record) {
    return s->image.records_at + record * PLT_RECORD_BYTES;
}

/* The page that begins with record `first`. */
static part_of page_of(plt_treelet_stream *s, uint32_t first) {
    const uint32_t left = s->scene.triangles - first;
    const part_of of = {s, first, record_at(s, first),
                        left < PLT_PAGE_RECORDS ? left : PLT_PAGE_RECORDS};
    return of;
}

/* Of pages with checks the last one is whole, too. */
static inline void want_page(plt_wanted *w, const part_of *of) {
    const uint32_t page = of->first / PLT_PAGE_RECORDS;
    const uint32_t records = of->stream->image.checks_at > 0 ? PLT_PAGE_RECORDS : of->count;
    *w = (plt_wanted){.key = KEY_STEP * page + KEY_PAGE,
                      .offset = of->offset,
                      .count = records * PLT_RECORD_BYTES,
                      .bit = of->stream->scene.node_slots + page,
                      .check = check_records,
                      .context = of};
}

/* The current treelet, if there is one, must not move until it is let go. */
static inline plt_store_part *hold_current(plt_treelet_stream *s) {
    plt_store_part *nodes = s->first != PLT_MISS ? plt_fetcher_part(&s->fetcher, &s->found) : NULL;
    if (nodes != NULL) {
        nodes->held = 1;
    }
    return nodes;
}

static inline void let_go(plt_store_part *nodes) {
    if (nodes != NULL) {
        nodes->held = 0;
    }
}

#if PLT_WITH_PREFETCH
void plt_treelet_stream_expect_records(plt_treelet_stream *s, uint32_t record) {
    if (record < s->scene.triangles) {
        const part_of of = page_of(s, record - record % PLT_PAGE_RECORDS);
        plt_wanted w;
        want_page(&w, &of);
        plt_store_part *nodes = hold_current(s);
        plt_prefetch_ask(&s->fetcher, &w);
        let_go(nodes);
    }
}

/* A list goes on in the next page, which comes while the records of this one, which stay where they
 * are, are tested. */
static void expect_next_page(plt_treelet_stream *s, const plt_lists_left *left,
                             const plt_found *found) {
    if (left->lists > 0) {
        plt_store_part *page = plt_fetcher_part(&s->fetcher, found);
        page->held = 1;
        plt_treelet_stream_expect_records(s, left->record);
        page->held = 0;
    }
}
#else
static void expect_next_page(plt_treelet_stream *s, const plt_lists_left *left,
                             const plt_found *found) {
    (void)s;
    (void)left;
    (void)found;
}
#endif

static int need_page(plt_treelet_stream *s, uint32_t first, plt_found *found) {
    const part_of of = page_of(s, first);
    plt_wanted w;
    want_page(&w, &of);
    plt_store_part *nodes = hold_current(s);
    const int status = plt_fetcher_need(&s->fetcher, &w, found);
    let_go(nodes);
    return status;
}

/* Records of the lists among `most`. 0: a list is longer than the header says. */
static int find_ends(const plt_treelet_stream *s, plt_lists_left *left, uint32_t most) {
    left->count = 0;
    while (left->lists > 0 && left->count < most) {
        if (++left->length > s->longest_list) {
            return 0;
        }
        if (plt_record_is_last(&left->at[left->count++])) {
            left->lists--;
            left->length = 0;
        }
    }
    left->record += left->count;
    return 1;
}

int plt_treelet_stream_read(plt_treelet_stream *s, plt_lists_left *left) {
    const uint32_t record = left->record, first = record - record % PLT_PAGE_RECORDS;
    plt_found found;
    if (record >= s->scene.triangles) {
        return refuse(s, PLT_I3_LIST_ENDS, s->image.records_at);
    }
    const int status = need_page(s, first, &found);
    if (status != PLT_OK) {
        return status;
    }
    const uint32_t rest = s->scene.triangles - record, to_end = first + PLT_PAGE_RECORDS - record;
    left->at =
        (const plt_record *)(const void *)plt_fetcher_bytes(&s->fetcher, &found) + (record - first);
    if (!find_ends(s, left, rest < to_end ? rest : to_end)) {
        return refuse(s, PLT_I8_COUNTS, record_at(s, first));
    }
    expect_next_page(s, left, &found);
    return PLT_OK;
}
