/* pack_json - see pack_json.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/pack_json.h"

#include <inttypes.h>

/* Quotes and what JSON does not hold in a string as escapes; other bytes as they are. */
static int write_string(output *o, const char *text, fail *f) {
    int status = output_print(o, f, "\"");
    for (const char *c = text; *c != '\0' && status == 0; c++) {
        const unsigned char byte = (unsigned char)*c;
        status = byte < 0x20 || byte == 0x7f   ? output_print(o, f, "\\u%04x", byte)
                 : byte == '"' || byte == '\\' ? output_print(o, f, "\\%c", byte)
                                               : output_write(o, c, 1, f);
    }
    return status == 0 ? output_print(o, f, "\"") : -1;
}

static int write_file(output *o, const pack_file *file, fail *f) {
    int status = output_print(o, f, "    {\"file\": ");
    if (status == 0) {
        status = write_string(o, file->path, f);
    }
    if (status == 0) {
        status = output_print(o, f, ",\n     \"vertices\": %zu, \"triangles\": %zu", file->vertices,
                              file->end - file->first);
    }
    for (int i = 0; i < REPORT_ITEMS && status == 0; i++) {
        status = output_print(o, f, ",\n     \"%s\": %" PRIu64, report_key((report_item)i),
                              file->report.count[i]);
    }
    return status != 0 ? -1
                       : output_print(o, f,
                                      ",\n     \"moved_by_single_precision\": %.6g,\n"
                                      "     \"moved_in_edges\": %.6g,\n"
                                      "     \"triangles_that_lose_an_edge\": %" PRIu64
                                      ",\n"
                                      "     \"open_edges\": %" PRIu64
                                      ",\n"
                                      "     \"welded_positions\": %" PRIu64
                                      ",\n"
                                      "     \"welded_triangles_without_area\": %" PRIu64
                                      ",\n"
                                      "     \"triangles_without_area\": %" PRIu64 "}",
                                      file->moved.moved, file->moved.relative, file->moved.vanished,
                                      file->open_edges, file->welded.moved, file->welded.collapsed,
                                      file->without_area);
}

static int write_loss(output *o, const lattice_loss *l, unsigned bits, fail *f) {
    if (l == NULL) {
        return output_print(o, f, "  \"lattice\": null\n}\n");
    }
    return output_print(o, f,
                        "  \"lattice\": {\n    \"bits\": %u,\n    \"largest_move\": %.6g,\n"
                        "    \"lost_their_area\": %" PRIu64 ",\n    \"had_no_area\": %" PRIu64
                        ",\n    \"merged_positions\": %" PRIu64 ",\n    \"t_junctions\": %" PRIu64
                        ",\n    \"mended\": %" PRIu64 "\n  }\n}\n",
                        bits, l->largest_move, l->flat_now, l->flat_before, l->merged,
                        l->t_junctions, l->mended);
}

int pack_json_write(output *o, const pack_meshes *in, const packed *image, const lattice_loss *loss,
                    fail *f) {
    int status =
        output_print(o, f,
                     "{\n  \"triangles\": %" PRIu32 ",\n  \"image_bytes\": %" PRIu32
                     ",\n  \"shift\": [%.17g, %.17g, %.17g],\n  \"files\": [\n",
                     image->info.triangles, image->size, in->shift[0], in->shift[1], in->shift[2]);
    for (int i = 0; i < in->files && status == 0; i++) {
        status = write_file(o, &in->file[i], f);
        if (status == 0) {
            status = output_print(o, f, "%s\n", i + 1 < in->files ? "," : "");
        }
    }
    if (status == 0) {
        status = output_print(o, f, "  ],\n");
    }
    return status == 0 ? write_loss(o, loss, image->info.lattice_bits, f) : -1;
}
