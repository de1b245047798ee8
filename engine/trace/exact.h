/* exact - on which side of a directed edge does a ray pass?
 *
 * For the cases of the ray/triangle test that single precision cannot decide. Arithmetic
 * is in pairs of floats (about 46 bits), error-free where it matters; what is smaller than
 * its error bound counts as 0, "on the edge". So a side is never wrong, and a ray that
 * meets a triangle is never turned away.
 *
 * Sources: Dekker, "A floating-point technique for extending the available
 * precision", 1971; Knuth, TAOCP volume 2, section 4.2.2 (exact sums).
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_EXACT_H
#define PLT_TRACE_EXACT_H

/* Sign of dir . ((p - org) x (q - org)): 1, -1, or 0 when the ray passes the
 * line through p and q closer than about 2^-42 of its distance. */
int plt_edge_side(const float p[3], const float q[3], const float org[3], const float dir[3]);

#endif
