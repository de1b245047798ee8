/* textures - see textures.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/textures.h"

#include <inttypes.h>
#include <stdio.h>

enum { ROOM_MOST = 1 << 30 };

void textures_read(scene *s, args *a, uint8_t shader) {
    static const char *const choices[] = {"bilinear", "nearest", "none", NULL};
    static const uint8_t filters[] = {PLT_TEXTURES_BILINEAR, PLT_TEXTURES_NEAREST,
                                      PLT_TEXTURES_NONE};
    const int is_shown = shader == PLT_SHADE_WHITTED || shader == PLT_SHADE_SMOOTH;
    s->textures = filters[args_choice(a, "--textures", choices, 0)];
    s->texture_bytes = (uint32_t)args_number(a, "--texture-room", 0, PLT_TEXTURE_LEAST, ROOM_MOST);
    if (!is_shown && (args_has(a, "--textures") || args_has(a, "--texture-room"))) {
        args_complain(a,
                      "--textures and --texture-room are for --shader smooth or whitted; add one");
    }
}

void textures_say(const scene *s, const char *path) {
    const plt_info *info = plt_engine_info(s->engine);
    const int is_shown = s->options.surface || s->options.whitted > 0;
    if (is_shown && s->options.residency == PLT_RESIDENCY_STREAMED && info->texture_bytes > 0 &&
        info->texcoord_bytes > 0 && s->textures != PLT_TEXTURES_NONE) {
        fprintf(stderr,
                "%s: without its textures, as it is streamed and their coordinates are in a table; "
                "pack it with --surface pages\n",
                path);
    }
    if (s->options.whitted > 0 && s->options.residency == PLT_RESIDENCY_STREAMED &&
        !s->options.surface && (info->normal_bytes > 0 || info->colour_bytes > 0)) {
        fprintf(stderr,
                "%s: without its normals and colours, as it is streamed and they are in "
                "tables, not in pages\n",
                path);
    }
}

void textures_print(output *o, const scene *s, fail *f) {
    plt_texture_stats sum = {0};
    if (s->options.textures == PLT_TEXTURES_NONE) {
        return;
    }
    for (unsigned i = 0; i < s->crew.count; i++) {
        plt_texture_stats q;
        plt_texture_stats_get(s->crew.worker[i].engine, &q);
        sum.found += q.found;
        sum.fetched += q.fetched;
        sum.bytes_fetched += q.bytes_fetched;
        sum.retries += q.retries;
    }
    output_print(o, f,
                 "  \"texture_tiles_found\": %" PRIu64 ",\n  \"texture_tiles_fetched\": %" PRIu64
                 ",\n  \"texture_bytes_fetched\": %" PRIu64 ",\n  \"texture_retries\": %" PRIu64
                 ",\n",
                 sum.found, sum.fetched, sum.bytes_fetched, sum.retries);
}
