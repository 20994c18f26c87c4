/* SPDX-License-Identifier: MIT */
/* Every way to move a coin by fixed steps, under one roof. */
#ifndef MOVERS_H
#define MOVERS_H

#include <coin.h>
#include <run.h>

enum mover_kind {
    MOVER_TEXTBOOK,
    MOVER_RK4,
    MOVER_RK8,
    MOVER_SUNDMAN, /* what coin_advance() steps with: fixed steps in tau */
    MOVER_SYMPLECTIC2,
    MOVER_SYMPLECTIC4,
    MOVERS
};

typedef struct mover {
    enum mover_kind kind;
    coin_params p;
    coin_state s;      /* where the coin is */
    double h;          /* the step, in t, or in tau of MOVER_SUNDMAN */
    long double t;     /* since the start */
    coin_priv_run run; /* of MOVER_SUNDMAN */
} mover;

const char *mover_name(enum mover_kind kind);

mover mover_at(enum mover_kind kind, const coin_state *s, const coin_params *p,
               double h);

/* n steps.  0, or a step failed. */
int mover_go(mover *m, unsigned long n);

#endif
