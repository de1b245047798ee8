/* formats - what picture_file.c knows of each file format's writer
 *
 * All return -1 with `f` set; `o` stays open and is the caller's to abandon.
 *
 * SPDX-License-Identifier: MIT */
#ifndef FORMATS_H
#define FORMATS_H
#include "host_tools/base/output.h"
#include "host_tools/picture/bits.h"
#include "host_tools/picture/picture.h"

int png_frame(output *o, const picture *p, fail *f);
/* The same file in memory: appended to `file`, which is aligned. */
int png_pack(bits *file, const picture *p, fail *f);
int ppm_frame(output *o, const picture *p, fail *f);

typedef enum y4m_chroma { Y4M_420, Y4M_444 } y4m_chroma;
int y4m_begin(output *o, y4m_chroma chroma, unsigned width, unsigned height,
              unsigned frames_per_second, fail *f);
int y4m_frame(output *o, y4m_chroma chroma, const picture *p, fail *f);

#endif
