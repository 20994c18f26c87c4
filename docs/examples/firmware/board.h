/* SPDX-License-Identifier: MIT */
/* What the programs here ask of a board: start-up code that calls main(), a
 * timer, and puts() for a line of text. */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

/* Starts the timer.  Clears what it counted before. */
void board_tick(uint32_t per_second);

/* Sleeps until the next tick; returns how many there were since the last call,
 * or since the start: 1, unless the caller took too long. */
uint32_t board_wait(void);

#endif
