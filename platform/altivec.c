/* altivec - a program that starts with Altivec's Java mode, in which vectors keep subnormals
 *
 * Linux begins every program with VSCR[NJ] set: vectors of floats flush subnormals, and compilers
 * make such vectors of plain loops, too. Threads inherit what main's has. Empty on other CPUs.
 *
 * Source: AltiVec Technology Programming Interface Manual, Freescale, 1999, section 2.3.1.
 *
 * SPDX-License-Identifier: MIT */
#ifdef __ALTIVEC__
#include <altivec.h>

__attribute__((constructor)) static void keep_subnormals(void) {
    const vector unsigned int all_clear = {0, 0, 0, 0};
    vec_mtvscr(all_clear);
}
#else
typedef int altivec_is_not_there;
#endif
