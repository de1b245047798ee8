/* coarse - how fine the next picture of a camera that moves, or has come to rest, is to be
 *
 * While the camera moves, pictures are as coarse as it takes to have one in time; at rest each is
 * finer than the one before, until four pixels are the mean of each that is shown.
 *
 * SPDX-License-Identifier: MIT */
#ifndef COARSE_H
#define COARSE_H

/* Finest: twice as many pixels across as are shown. Then as many, half, a quarter, an eighth. */
enum { COARSE_FINEST = 0, COARSE_PLAIN = 1, COARSE_MOST = 4 };

typedef struct coarse {
    unsigned level; /* of the next picture */
    unsigned first; /* of the first after a move */
    int is_due;     /* there is something to render */
} coarse;

#define COARSE_BEGUN                                                                               \
    { COARSE_PLAIN, COARSE_PLAIN, 1 }

/* The camera, or what it looks at, has moved. */
void coarse_moved(coarse *c);

/* The next picture is being rendered. Pixels along a side that has `side` on the screen: 1 at
 * least. */
unsigned coarse_side(const coarse *c, unsigned side);

/* The camera has moved while a picture of this level was being rendered, for so long: 1: it is to
 * be given up for the next. One that a moving camera is shown by, which is in time, is not: there
 * would be none. The next one is coarser if it is late. */
int coarse_give_up(coarse *c, unsigned level, double seconds);

/* It is complete, and took so long: the next finer one is due, if there is one. */
void coarse_complete(coarse *c, double seconds);

#endif
