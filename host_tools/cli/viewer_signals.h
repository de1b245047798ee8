/* viewer_signals - a window of another size, Ctrl-Z and its end, noticed between two pictures
 *
 * SPDX-License-Identifier: MIT */
#ifndef VIEWER_SIGNALS_H
#define VIEWER_SIGNALS_H

/* From now on these signals are caught; one that is ignored stays so. */
void viewer_signals_catch(void);

/* Ctrl-Z was typed. */
void viewer_signals_stop(void);

/* Whether viewer_signals_take has something to do: a picture that is being rendered is old. */
int viewer_signals_wait(void);

/* Does what signals ask for: puts the terminal back and stops the program, with those that it was
 * started with; when it goes on, or went on after it was stopped by others, the terminal has its
 * modes again. 1: the terminal is to be measured and drawn anew; 0: it is not; -1: it takes no
 * other mode. */
int viewer_signals_take(void);

#endif
