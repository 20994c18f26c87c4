/* SPDX-License-Identifier: MIT */
/* What start-up code does on any board, and its way to say something: lines
 * and an exit code go to the debugger or emulator that runs the program, by
 * semihosting.  A board on its own would stop there: let puts() write to its
 * UART instead. */
#ifndef START_H
#define START_H

#include <stdint.h>
#include <stdio.h>

enum { WRITE0 = 0x04, EXIT_EXTENDED = 0x20, APPLICATION_EXIT = 0x20026 };

/* In the board's file; r0 and r1, or a0 and a1, by every ABI. */
void ask_host(uintptr_t what, const void *with);

static inline void leave(int code)
{
    const uintptr_t how[] = {APPLICATION_EXIT, (uintptr_t)code};
    for (;;)
        ask_host(EXIT_EXTENDED, how);
}

/* The C library's would bring buffers and a heap. */
int puts(const char *line)
{
    ask_host(WRITE0, line);
    ask_host(WRITE0, "\n");
    return 0;
}

/* Named by board.ld. */
extern uint32_t board_data[], board_data_end[], board_data_from[];
extern uint32_t board_bss[], board_bss_end[];

int main(void);

static inline void run_main(void)
{
    const uint32_t *from = board_data_from;
    for (uint32_t *to = board_data; to < board_data_end;)
        *to++ = *from++;
    for (uint32_t *to = board_bss; to < board_bss_end;)
        *to++ = 0;
    leave(main());
}

#endif
