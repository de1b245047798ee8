/* target - the file that a name leads to, through symbolic links
 *
 * SPDX-License-Identifier: MIT */
#ifndef TARGET_H
#define TARGET_H

/* Follows the links in the last part of `name`, also to a file that does not exist. Returns a
 * path from malloc, or NULL with errno set. */
char *target_of(const char *name);

#endif
