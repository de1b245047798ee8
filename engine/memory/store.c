/* store - see store.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/memory/store.h"

#include <string.h>

/* One entry of the table per so many bytes: parts are larger on average, and when entries run
 * out, parts are given up as if bytes had. */
enum { BYTES_PER_PART = 256, BEHIND = 8 };

static uint16_t *bucket_of(const plt_store *s, uint32_t key) {
    return &s->bucket[(key * 0x9E3779B1u >> 16) & (s->buckets - 1u)];
}

static uint16_t buckets_for(uint32_t parts) {
    uint32_t buckets = 1;
    while (2 * buckets < parts) {
        buckets *= 2;
    }
    return (uint16_t)buckets;
}

static void set_empty(plt_store *s) {
    for (uint32_t i = 0; i < s->buckets; i++) {
        s->bucket[i] = PLT_STORE_NONE;
    }
    for (uint32_t i = 0; i < s->parts_most; i++) {
        s->part[i].next = (uint16_t)(i + 1 < s->parts_most ? i + 1 : PLT_STORE_NONE);
    }
    s->unused = 0;
    s->oldest = s->newest = PLT_STORE_NONE;
    s->free_at = 0;
    s->given_up = 0;
}

void plt_store_init(plt_store *s, void *memory, uint32_t bytes) {
    const uint32_t parts = bytes / BYTES_PER_PART;
    s->parts_most = (uint16_t)(parts < PLT_STORE_NONE - 1 ? parts : PLT_STORE_NONE - 1);
    s->buckets = buckets_for(s->parts_most);
    s->part = memory;
    s->bucket = (uint16_t *)(void *)(s->part + s->parts_most);
    const uint32_t table = (uint32_t)(s->parts_most * sizeof *s->part) + 2u * s->buckets;
    const uint32_t from = (table + 7) & ~7u;
    s->memory = (unsigned char *)memory + from;
    s->bytes = (bytes - from - BEHIND) & ~7u;
    memset(s->memory + s->bytes, 0, BEHIND);
    set_empty(s);
}

static uint16_t find(const plt_store *s, uint32_t key) {
    uint16_t i = *bucket_of(s, key);
    while (i != PLT_STORE_NONE && s->part[i].key != key) {
        i = s->part[i].chain;
    }
    return i;
}

int plt_store_has(const plt_store *s, uint32_t key) {
    return find(s, key) != PLT_STORE_NONE;
}

uint16_t plt_store_find(plt_store *s, uint32_t key) {
    const uint16_t i = find(s, key);
    if (i != PLT_STORE_NONE) {
        s->part[i].found = 1;
    }
    return i;
}

void plt_store_forget(plt_store *s, uint16_t part) {
    uint16_t *link = bucket_of(s, s->part[part].key);
    while (*link != PLT_STORE_NONE && *link != part) {
        link = &s->part[*link].chain;
    }
    if (*link == part) {
        *link = s->part[part].chain;
    }
    s->part[part].key = PLT_STORE_NO_KEY;
    s->part[part].found = 0;
}

static uint16_t pop_oldest(plt_store *s) {
    const uint16_t i = s->oldest;
    s->oldest = s->part[i].next;
    if (s->oldest == PLT_STORE_NONE) {
        s->newest = PLT_STORE_NONE;
    }
    return i;
}

/* `i` lies at the end of the parts that are there. */
static void push_newest(plt_store *s, uint16_t i) {
    s->part[i].next = PLT_STORE_NONE;
    *(s->newest == PLT_STORE_NONE ? &s->oldest : &s->part[s->newest].next) = i;
    s->newest = i;
    s->free_at = s->part[i].at + s->part[i].bytes;
}

/* The oldest part, which lies in front of what is free: it stays, moves up, or goes. */
static void pass_oldest(plt_store *s) {
    const uint16_t i = pop_oldest(s);
    plt_store_part *p = &s->part[i];
    if (p->held) {
        push_newest(s, i);
        return;
    }
    if (p->found) {
        p->found = 0;
        memmove(s->memory + s->free_at, s->memory + p->at, p->bytes);
        p->at = s->free_at;
        push_newest(s, i);
        return;
    }
    plt_store_forget(s, i);
    p->next = s->unused;
    s->unused = i;
    s->given_up++;
}

/* Where what is free ends: at the next part, or at the end. */
static uint32_t free_end(const plt_store *s) {
    const int is_ahead = s->oldest != PLT_STORE_NONE && s->part[s->oldest].at >= s->free_at;
    return is_ahead ? s->part[s->oldest].at : s->bytes;
}

/* Makes room at free_at. 0: there is none. In the first time around parts lose what they were found
 * for, in the second they go; what is held makes a third necessary. */
static int make_room(plt_store *s, uint32_t bytes) {
    for (unsigned around = 0; around < 4;) {
        const uint32_t end = free_end(s);
        if (s->unused != PLT_STORE_NONE && end - s->free_at >= bytes) {
            return 1;
        }
        if (s->oldest != PLT_STORE_NONE && s->part[s->oldest].at >= s->free_at) {
            pass_oldest(s);
        } else {
            s->free_at = 0;
            around++;
        }
    }
    return 0;
}

uint16_t plt_store_take(plt_store *s, uint32_t key, uint32_t bytes) {
    const uint32_t taken = plt_store_rounded(bytes);
    if (taken > s->bytes || !make_room(s, taken)) {
        return PLT_STORE_NONE;
    }
    const uint16_t i = s->unused;
    plt_store_part *p = &s->part[i];
    uint16_t *bucket = bucket_of(s, key);
    s->unused = p->next;
    *p = (plt_store_part){.key = key, .at = s->free_at, .bytes = taken, .chain = *bucket};
    *bucket = i;
    push_newest(s, i);
    return i;
}
