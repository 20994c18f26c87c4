/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include <coin.h>

/* Rows of characters, not pointers: those would need relocation, and with it
 * writable data in the shared library. */
static const char errors[][80] = {
    "done",
    "parameters out of range",
    "state out of range",
    "dt or t not valid, or too long: shorten it, or call coin_advance()",
    "bad argument: null, unknown method or branch, tolerance",
    "no such steady motion, not steady, or no orbit",
    "the coin falls flat",
    "this build does not give the pinned bits",
    "unknown error",
    "phi, psi, x or z would leave its range: subtract turns, move the origin",
};

static const char warnings[][56] = {
    "unknown status",
    "done, but the coin slips, or a real one would",
    "done, but the coin lifts off, or a real one would",
    "done, several warnings: COIN_SLIPS + COIN_LIFTS",
    "done, but the step is coarse",
    "done, several warnings: COIN_SLIPS + COIN_COARSE",
    "done, several warnings: COIN_LIFTS + COIN_COARSE",
    "done, several warnings: SLIPS + LIFTS + COARSE",
    "done, but the coin is nearly flat",
    "done, several warnings: COIN_SLIPS + COIN_NEARLY_FLAT",
    "done, several warnings: COIN_LIFTS + COIN_NEARLY_FLAT",
    "done, several warnings: SLIPS + LIFTS + NEARLY_FLAT",
    "done, several warnings: COIN_COARSE + COIN_NEARLY_FLAT",
    "done, several warnings: SLIPS + COARSE + NEARLY_FLAT",
    "done, several warnings: LIFTS + COARSE + NEARLY_FLAT",
    "done, all warnings",
};

const char *coin_status_string(int32_t status)
{
    if (status < COIN_ERANGE || status >= 2 * COIN_TOUCHES)
        return warnings[0];
    if (status <= 0)
        return errors[-status];
    if (status & COIN_RESTS)
        return "done: the coin lies flat, at rest";
    if (status & COIN_ROLLS)
        return "done: the coin has begun to roll";
    if (status & COIN_TOUCHES)
        return "done: the coin has come down on the table";
    return warnings[status];
}
