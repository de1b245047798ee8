/* rig - see rig.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/rig.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

rig_config rig_config_of(uint32_t leaf_triangles, uint32_t treelet_nodes, uint8_t build,
                         uint8_t splits) {
    const rig_config config = {
        {splits, build, leaf_triangles, treelet_nodes, NULL, 1, NULL, 0, 0},
        {.packet_side = PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8, .count_touched = 1}};
    return config;
}

plt_source rig_source(const packed *image) {
    const plt_source source = {image->bytes, image->size, NULL, NULL, NULL};
    return source;
}

int rig_open(rig *r, const mesh *m, const rig_config *config) {
    return rig_open_spare(r, m, config, 0);
}

int rig_open_spare(rig *r, const mesh *m, const rig_config *config, size_t spare) {
    fail f = {""};
    memset(r, 0, sizeof *r);
    r->fault.message = "the packer refused";
    if (pack_mesh(&r->image, m, &config->pack, "test", &f) != 0) {
        return PLT_ERR_LIMIT;
    }
    r->arena_bytes =
        plt_arena_need(&r->image.info, 1, &config->run) + spare / PLT_ALIGN * PLT_ALIGN;
    r->arena = aligned_alloc(PLT_ALIGN, r->arena_bytes);
    if (r->arena == NULL) {
        return PLT_ERR_ARENA;
    }
    memset(r->arena, 0xA5, r->arena_bytes);
    const plt_source source = rig_source(&r->image);
    return plt_open(&r->engine, r->arena, r->arena_bytes, &source, &config->run, &r->fault);
}

void rig_close(rig *r) {
    pack_free(&r->image);
    free(r->arena);
    memset(r, 0, sizeof *r);
}

uint32_t rig_triangles(uint32_t wanted, uint32_t leaf_triangles) {
    const uint32_t levels = PLT_DEPTH_MAX - 1 < 20 ? PLT_DEPTH_MAX - 1 : 20;
    const uint32_t most = leaf_triangles << levels;
    return wanted < most ? wanted : most;
}

int rig_is_tiny(void) {
    return PLT_DEPTH_MAX < 64 || PLT_GLOBAL_STACK_MAX < 65536;
}

const char *rig_name(const rig_config *config) {
    static const char *const build[3] = {"host", "device", "none"};
    static char name[96];
    snprintf(name, sizeof name, "K %u N %u %s %s side %u order %u", config->pack.leaf_triangles,
             config->pack.treelet_nodes, build[config->pack.build % 3],
             config->pack.splits == PLT_SPLIT_SAH ? "sah" : "median", config->run.packet_side,
             config->run.order);
    return name;
}
