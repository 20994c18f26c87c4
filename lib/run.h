/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_RUN_H
#define ROLLCOIN_RUN_H

#include "stepper.h"

/* A run under way. */
typedef struct coin_priv_run {
    coin_state start;
    coin_priv_body b;
    coin_priv_carry c;
    coin_priv_limits limits;
    coin_priv_stepper *step;
    double dt;
} coin_priv_run;

/* Checks everything, then computes what the steps share.  Who calls it sets the
 * stepper. */
int32_t coin_priv_run_open(coin_priv_run *r, const coin_state *s,
                           const coin_params *p, int32_t method, double dt);

/* Up to n steps; returns how many were done. */
uint64_t coin_priv_run_on(coin_priv_run *r, uint64_t n);

/* Where it has come to. */
coin_state coin_priv_run_state(const coin_priv_run *r);

/* The same to *s, and to *done, if that is not null, how many of the steps it
 * was to do it did; the status of the whole. */
int32_t coin_priv_run_close(const coin_priv_run *r, uint64_t steps,
                            coin_state *s, uint64_t *done);

#endif
