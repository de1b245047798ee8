/* report - see report.h
 *
 * SPDX-License-Identifier: MIT */
#include "board/report.h"

#include "board/board.h"
#include "board/line.h"

int report_fault(const plt_fault *fault, int status, size_t arena_bytes) {
    line l;
    line_start(&l);
    line_text(&l, "error: ");
    line_text(&l, fault->message ? fault->message : "no reason given");
    if (status == PLT_ERR_ARENA) {
        line_item(&l, "need_bytes", fault->need_bytes);
        line_item(&l, "arena_bytes", arena_bytes);
    } else if (fault->rule) {
        line_text(&l, " rule=");
        line_some(&l, &fault->kind, 1);
        line_u64(&l, fault->rule);
        line_item(&l, "offset", fault->offset);
    } else if (status == PLT_ERR_SOURCE) {
        line_item(&l, "offset", fault->offset);
    }
    line_print(&l);
    return FIRMWARE_FAILED;
}

void report_name(void) {
    line l;
    line_start(&l);
    line_text(&l, "planelet");
    line_item(&l, "version", PLT_VERSION_MAJOR);
    line_text(&l, ".");
    line_u64(&l, PLT_VERSION_MINOR);
    line_text(&l, " board=");
    line_text(&l, board_name());
    line_print(&l);
}

void report_scene(const plt_info *info) {
    line l;
    line_start(&l);
    line_text(&l, "scene");
    line_item(&l, "triangles", info->triangles);
    line_item(&l, "nodes", info->nodes);
    line_item(&l, "treelets", info->treelets);
    line_item(&l, "image_bytes", info->image_bytes);
    line_print(&l);
}

void report_memory(const plt_engine *engine, size_t arena_bytes) {
    uint32_t used, size;
    line l;
    line_start(&l);
    line_text(&l, "arena");
    line_item(&l, "used", plt_arena_used(engine));
    line_item(&l, "peak", plt_arena_peak(engine));
    line_item(&l, "bytes", arena_bytes);
    line_print(&l);
    board_stack(&used, &size);
    line_text(&l, "stack");
    line_item(&l, "painted", used);
    line_item(&l, "bytes", size);
    line_print(&l);
}
