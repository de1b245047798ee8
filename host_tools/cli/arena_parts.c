/* arena_parts - see arena_parts.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/arena_parts.h"

#include <inttypes.h>
#include <stdio.h>

static const struct {
    const char *word, *sentence;
} lifetimes[PLT_LIFETIMES] = {
    [PLT_LIFETIME_STAYS] = {"stays", ""},
    [PLT_LIFETIME_VALIDATES] = {"validates", ", scratch of validation, given back"},
    [PLT_LIFETIME_BUILDS] = {"builds", ", scratch of the build, given back"},
    [PLT_LIFETIME_RUNS] = {"runs", ", where the scratch was"},
};

void arena_parts_print(const plt_info *info, int mapped, const plt_options *options) {
    plt_arena_part p;
    for (unsigned i = 0; plt_arena_part_get(info, mapped, options, i, &p) == PLT_OK; i++) {
        if (p.bytes > 0) {
            printf("  %-30s %8" PRIu64 " bytes%s\n", p.name, p.bytes,
                   lifetimes[p.lifetime].sentence);
        }
    }
}

void arena_parts_print_json(const plt_info *info, int mapped, const plt_options *options) {
    plt_arena_part p;
    const char *before = "";
    putchar('[');
    for (unsigned i = 0; plt_arena_part_get(info, mapped, options, i, &p) == PLT_OK; i++) {
        if (p.bytes > 0) {
            printf("%s\n    {\"name\": \"%s\", \"bytes\": %" PRIu64 ", \"lifetime\": \"%s\"}",
                   before, p.name, p.bytes, lifetimes[p.lifetime].word);
            before = ",";
        }
    }
    printf("\n  ]");
}
