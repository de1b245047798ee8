/* errands - threads that wait for what is to be done next
 *
 * A frame of a small picture takes a few milliseconds, and to start a thread takes a tenth of one.
 * So threads are started once, and stay until they are ended.
 *
 * SPDX-License-Identifier: MIT */
#ifndef APP_ERRANDS_H
#define APP_ERRANDS_H

/* Bytes of stack of a thread. */
enum { ERRANDS_STACK_BYTES = 1 << 20 };

typedef struct errands errands;

/* Threads for runs of up to `count` (1 and up), the caller one of them. NULL: there is no memory.
 */
errands *errands_start(unsigned count);

/* Calls `routine` for 0 .. count - 1, each on a thread of its own but the first, which is the
 * caller's; those for which the system has no thread the caller does, when it is done with the
 * first: all, if `e` is NULL. One run at a time: no routine begins another. All that was written
 * before is seen by all, and what they write by the caller. */
void errands_run(errands *e, unsigned count, void (*routine)(void *context, unsigned i),
                 void *context);

/* Ends the threads. NULL: nothing. */
void errands_end(errands *e);

#endif
