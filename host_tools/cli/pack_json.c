/* pack_json - see pack_json.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/pack_json.h"

#include <inttypes.h>

#include "host_tools/app/json_string.h"
#include "host_tools/base/heap.h"

/* Whether a line names --centre. */
static int centre_would_help(const pack_file *file) {
    return file->centre_helps || file->report.moved > REPORT_MOVED_MOST;
}

static int write_moved(output *o, const pack_file *file, fail *f) {
    return output_print(o, f,
                        ",\n     \"moved_by_single_precision\": %.6g,\n"
                        "     \"moved_in_edges\": %.6g,\n"
                        "     \"triangles_that_lose_an_edge\": %" PRIu64
                        ",\n     \"moved_in_edges_before_placing\": %.6g,\n"
                        "     \"triangles_that_lost_an_edge_before_placing\": %" PRIu64
                        ",\n     \"centre_would_help\": %s",
                        file->moved.moved, file->moved.relative, file->moved.vanished,
                        file->report.moved, file->report.vanished,
                        centre_would_help(file) ? "true" : "false");
}

static int write_edges(output *o, const pack_file *file, fail *f) {
    const uint64_t closed = file->open_distance > 0 ? file->open_edges - file->open_left : 0;
    if (file->edges_unknown) {
        return output_print(
            o, f,
            ",\n     \"open_edges\": null,\n     \"weld_that_closes_edges\": null,\n"
            "     \"open_edges_it_closes\": null");
    }
    return output_print(o, f,
                        ",\n     \"open_edges\": %" PRIu64
                        ",\n     \"weld_that_closes_edges\": %.0e,\n"
                        "     \"open_edges_it_closes\": %" PRIu64,
                        file->open_edges, file->open_distance, closed);
}

static int write_file(output *o, const pack_file *file, fail *f) {
    int status = output_print(o, f, "    {\"file\": ");
    if (status == 0) {
        status = json_write_string(o, file->path, f);
    }
    if (status == 0) {
        status = output_print(o, f, ",\n     \"vertices\": %zu, \"triangles\": %zu", file->vertices,
                              file->end - file->first);
    }
    for (int i = 0; i < REPORT_ITEMS && status == 0; i++) {
        status = output_print(o, f, ",\n     \"%s\": %" PRIu64, report_key((report_item)i),
                              file->report.count[i]);
    }
    if (status == 0) {
        status = write_moved(o, file, f);
    }
    if (status == 0) {
        status = write_edges(o, file, f);
    }
    return status != 0
               ? -1
               : output_print(o, f,
                              ",\n     \"welded_positions\": %" PRIu64
                              ",\n     \"welded_triangles_without_area\": %" PRIu64
                              ",\n     \"triangles_without_area\": %" PRIu64 "}",
                              file->welded.moved, file->welded.collapsed, file->without_area);
}

static int write_loss(output *o, const lattice_loss *l, fail *f) {
    if (l == NULL) {
        return output_print(o, f, "  \"lattice\": null\n}\n");
    }
    return output_print(o, f,
                        "  \"lattice\": {\n    \"bits\": %u,\n    \"largest_move\": %.6g,\n"
                        "    \"lost_their_area\": %" PRIu64 ",\n    \"had_no_area\": %" PRIu64
                        ",\n    \"merged_positions\": %" PRIu64 ",\n    \"t_junctions\": %" PRIu64
                        ",\n    \"mended\": %" PRIu64
                        ",\n    \"step\": %.9g,\n"
                        "    \"vertices\": %" PRIu64 ",\n    \"unmoved_vertices\": %" PRIu64
                        "\n  }\n}\n",
                        (unsigned)l->bits, l->largest_move, l->flat_now, l->flat_before, l->merged,
                        l->t_junctions, l->mended, (double)l->step, l->vertices, l->unmoved);
}

/* Seconds are the one number that is not the same in every run, and what time made of it. */
static int write_quality(output *o, const quality_stats *q, fail *f) {
    if (q->passes == 0) {
        return output_print(o, f, "  \"quality\": null,\n");
    }
    return output_print(o, f,
                        "  \"quality\": {\n    \"frames\": %" PRIu32 ",\n    \"passes\": %" PRIu32
                        ",\n    \"moves\": %" PRIu32
                        ",\n    \"boxes_per_line_before\": %.6g,\n"
                        "    \"boxes_per_line\": %.6g,\n    \"seconds\": %.3f,\n"
                        "    \"out_of_time\": %s\n  },\n",
                        q->frames, q->passes, q->moves, q->before, q->after, q->seconds,
                        q->out_of_time ? "true" : "false");
}

/* Of those that are formed here: all sizes that were tried, the one taken among them. */
static int write_treelets(output *o, const pack_treelets_stats *t, fail *f) {
    if (t->tried == 0) {
        return output_print(o, f, "  \"treelets\": null,\n");
    }
    int status =
        output_print(o, f, "  \"treelets\": {\n    \"size\": %" PRIu32 ",\n    \"tried\": [\n",
                     t->of[t->best].size);
    for (uint32_t i = 0; i < t->tried && status == 0; i++) {
        const pack_treelet_score *s = &t->of[i];
        status = output_print(o, f,
                              "      {\"size\": %" PRIu32 ", \"complete\": %" PRIu32
                              ", \"incomplete\": %" PRIu32 ", \"free_slots\": %" PRIu64
                              ",\n       \"entered_per_line\": %.6g, \"cost\": %.6g}%s\n",
                              s->size, s->complete, s->treelets - s->complete, s->free_slots,
                              s->entered, s->cost, i + 1 < t->tried ? "," : "");
    }
    return status != 0 ? -1 : output_print(o, f, "    ]\n  },\n");
}

/* How far the image's colours and texture coordinates are from the mesh's. */
static int write_surface(output *o, const surface_stats *s, fail *f) {
    int status = 0;
    if (s->colours.bytes > 0) {
        status =
            output_print(o, f,
                         "  \"colours_kept\": %" PRIu32 ",\n  \"colours_distinct\": %" PRIu32
                         ",\n  \"colours_off\": %" PRIu32 ",\n  \"colours_off_mean\": %.3f,\n",
                         s->colours_kept, s->colours_distinct, s->colours_off, s->colours_mean);
    }
    return status == 0 && s->texcoords.positions + s->texcoords.split > 0
               ? output_print(o, f, "  \"texture_coordinates_off\": %.3g,\n", s->texcoords_off)
               : status;
}

int pack_json_write(output *o, const pack_meshes *in, const packed *image, const lattice_loss *loss,
                    const quality_stats *quality, const surface_stats *surface,
                    const pack_memory *memory, fail *f) {
    int status =
        output_print(o, f,
                     "{\n  \"triangles\": %" PRIu32 ",\n  \"frames\": %" PRIu32
                     ",\n  \"triangles_after_reduce\": %zu"
                     ",\n  \"image_bytes\": %" PRIu32 ",\n  \"memory_bytes_needed\": %" PRIu64
                     ",\n  \"memory_peak_bytes\": %" PRIu64
                     ",\n  \"shift\": [%.17g, %.17g, %.17g],\n  \"files\": [\n",
                     image->info.triangles, image->info.frames, in->triangles, image->size,
                     memory->needed, heap_peak(), in->shift[0], in->shift[1], in->shift[2]);
    for (int i = 0; i < in->files && status == 0; i++) {
        status = write_file(o, &in->file[i], f);
        if (status == 0) {
            status = output_print(o, f, "%s\n", i + 1 < in->files ? "," : "");
        }
    }
    if (status == 0) {
        status = output_print(o, f, "  ],\n");
    }
    if (status == 0) {
        status = write_quality(o, quality, f);
    }
    if (status == 0) {
        status = write_treelets(o, &image->treelets, f);
    }
    if (status == 0) {
        status = write_surface(o, surface, f);
    }
    return status == 0 ? write_loss(o, loss, f) : -1;
}
