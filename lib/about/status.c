/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include <coin.h>

/* Each fits every function that returns it, and so names no other to call.
 * Rows of characters, not pointers: those would need relocation, and with it
 * writable data in the shared library. */
static const char errors[][80] = {
    "done",
    "parameters, losses or table out of range",
    "state or body out of range, or below the table",
    "dt or t out of range, or too long for this motion: shorten it",
    "argument: null, method, branch, tol, mu, radius, speed, time, stop, orbit",
    "no answer: no such steady motion, orbit or losses, or it is not steady",
    "the coin falls flat",
    "this build does not give the pinned bits",
    "unknown error",
    "phi, psi, x, y or z, or a rate, would leave its range: move the origin",
};

static const char warnings[][56] = {
    "unknown status",
    "done, but the coin slips, or a real one would",
    "done, but the coin is off the table, or would lift off",
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
    if (status < COIN_ERANGE || status >= 2 * COIN_DECIDED)
        return warnings[0];
    if (status <= 0)
        return errors[-status];
    if (status & COIN_RESTS)
        return "done: the coin lies flat, or stands, and stays";
    if (status & COIN_MORE)
        return "not all: the steps of a call did not suffice, call again";
    if (status & COIN_DECIDED)
        return "done: it is decided which side of the coin ends up";
    if (status & COIN_ROLLS)
        return "done: the coin has begun to roll";
    if (status & COIN_TOUCHES)
        return "done: the coin has come down on the table";
    return warnings[status];
}
