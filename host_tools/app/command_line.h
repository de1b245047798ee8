/* command_line - the words of a command again, as one would type them
 *
 * SPDX-License-Identifier: MIT */
#ifndef COMMAND_LINE_H
#define COMMAND_LINE_H

#include "host_tools/app/args.h"

/* "planelet pack a.ply 'b c.ply' -o x.h --leaf 4": files first, then flags in the order of
 * the help, quoted for a shell where needed. Of many files the first few are named. From
 * malloc; NULL when memory is out. */
char *command_line(const args *a);

#endif
