/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_TESTS_COSTS_H
#define ROLLCOIN_TESTS_COSTS_H

/* What one answer of each model costs, as a ratio to a textbook RK4 step of
 * the same run, as CSV: the shortest of many samples, taken in turns. */
int study_costs(void);

#endif
