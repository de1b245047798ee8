/* treelet_stream - see treelet_stream.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/memory/treelet_stream.h"

#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/tree/record_ranges.h"

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

static int nodes_rule(plt_treelet_stream *s, const part_of *of, uint16_t part) {
    plt_treelet_facts facts;
    const plt_node *nodes = (const void *)plt_store_bytes(&s->fetcher.store, part);
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

static int check_nodes(const void *context, uint16_t part) {
    const part_of *of = context;
    const int rule = nodes_rule(of->stream, of, part);
    return rule == PLT_TREELET_VALID ? PLT_OK : refuse(of->stream, rule, of->offset);
}

static int check_records(const void *context, uint16_t part) {
    const part_of *of = context;
    plt_treelet_stream *s = of->stream;
    const plt_record *r = (const void *)plt_store_bytes(&s->fetcher.store, part);
    for (const plt_record *end = r + of->count; r < end; r++) {
        if (plt_record_outside(s->scene.box, r) != NULL) {
            return refuse(s, PLT_I5_CORNERS, of->offset);
        }
        if (!plt_is_id_word(plt_get_u32(&r->word[9]), s->scene.triangles)) {
            return refuse(s, PLT_I7_ID_WORDS, of->offset);
        }
    }
    return PLT_OK;
}

/* ---- nodes ------------------------------------------------------------- */

static int need_nodes(plt_treelet_stream *s, uint32_t first, uint32_t count, uint32_t length) {
    const part_of of = {s, first, node_at(s, first), count};
    const plt_wanted wanted = {.key = KEY_STEP * first + length,
                               .offset = of.offset,
                               .count = count * PLT_NODE_BYTES,
                               .bit = first + (length > 0 ? length - 1 : 0),
                               .is_treelet = length <= 1,
                               .check = check_nodes,
                               .context = &of};
    return plt_fetcher_need(&s->fetcher, &wanted, &s->found);
}

/* A treelet alone does not say how many nodes it has before they are there. Most have few; one that
 * turns out to go on comes again, longer. (Its bit of `touched` is then that of its next node,
 * which is no other's.) */
static int need_alone(plt_treelet_stream *s, uint32_t first) {
    static const uint16_t nodes[] = {PLT_ALONE_NODES, 4 * PLT_ALONE_NODES, UINT16_MAX};
    const uint32_t rest = s->scene.treelet_nodes - first % s->scene.treelet_nodes;
    int status = PLT_OK;
    for (uint32_t i = 0; i < 3; i++) {
        status = need_nodes(s, first, nodes[i] < rest ? nodes[i] : rest, i + 1);
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
    while (length < 3 && !plt_store_has(&s->fetcher.store, KEY_STEP * slot + length)) {
        length++;
    }
    return length < 3;
}

int plt_treelet_stream_open(plt_treelet_stream *s, uint32_t slot, uint32_t scope) {
    const uint32_t first = (scope & PLT_TREELET_ALONE) != 0 ? scope & ~PLT_TREELET_ALONE
                                                            : slot - slot % s->scene.treelet_nodes;
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
static int need_page(plt_treelet_stream *s, uint32_t first, plt_found *found) {
    const uint32_t page = first / PLT_PAGE_RECORDS, left = s->scene.triangles - first;
    const part_of of = {s, first, record_at(s, first),
                        left < PLT_PAGE_RECORDS ? left : PLT_PAGE_RECORDS};
    const plt_wanted wanted = {.key = KEY_STEP * page + KEY_PAGE,
                               .offset = of.offset,
                               .count = of.count * PLT_RECORD_BYTES,
                               .bit = s->scene.node_slots + page,
                               .check = check_records,
                               .context = &of};
    plt_store_part *nodes = s->first != PLT_MISS ? plt_fetcher_part(&s->fetcher, &s->found) : NULL;
    if (nodes != NULL) { /* it must not move */
        nodes->held = 1;
    }
    const int status = plt_fetcher_need(&s->fetcher, &wanted, found);
    if (nodes != NULL) {
        nodes->held = 0;
    }
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
    return find_ends(s, left, rest < to_end ? rest : to_end)
               ? PLT_OK
               : refuse(s, PLT_I8_COUNTS, record_at(s, first));
}
