/* json_string - a text as a string of JSON
 *
 * Source: RFC 8259, "The JavaScript Object Notation (JSON) Data Interchange Format", 2017.
 *
 * SPDX-License-Identifier: MIT */
#ifndef JSON_STRING_H
#define JSON_STRING_H

#include "host_tools/base/output.h"

/* Writes it in quotes: quotes and what JSON does not hold in a string as escapes; a byte that is
 * no UTF-8, which names of files may hold and JSON may not, as U+FFFD. */
int json_write_string(output *o, const char *text, fail *f);

#endif
