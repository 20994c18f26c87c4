/* SPDX-License-Identifier: MIT */
/* The slopes of a coin in contact and the force of the table on it, for the two
 * sources that compile them: without and with a thickness and a pull. */
#ifndef ROLLCOIN_CONTACT_H
#define ROLLCOIN_CONTACT_H

#include "law.h"

/* Where the contact is, what the centre does, and the pull, along e_X and e_h.
 * eta is 0 of a plain law. */
struct place {
    double eta, P, Y; /* (118) */
    double vX, vh;    /* (119) */
    coin_priv_direction g;
};

COIN_PRIV_INLINE struct place place_of(const double *y, const coin_priv_law *l,
                                       int plain)
{
    const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C], wX = y[COIN_PRIV_WX];
    const double vX = y[COIN_PRIV_UX] - y[COIN_PRIV_WZ]; /* (77) */
    struct place r = {0, s, c, vX, y[COIN_PRIV_UH] + wX * c, {0, 0}};
    if (!plain) {
        const coin_priv_lever d = coin_priv_lever_of(s, c, l->eta);
        r.eta = l->eta;
        r.P = d.P;
        r.Y = d.Y;
        r.vX = vX - r.eta * y[COIN_PRIV_WY];
        r.vh = y[COIN_PRIV_UH] + wX * r.Y;
        r.g = coin_priv_pull_of(y, l);
    }
    return r;
}

/* How the coin would move without a force of the table on it, or, without a
 * slip, with the force that keeps its contact where it is. */
struct free_motion {
    double f;          /* the slope of the time: cos theta, or 1 */
    double turn, roll; /* the slopes of phi and psi */
    double X, Y, Z;    /* the slopes of wX, wY, wZ */
    double perY, perZ; /* what a friction of 1 along e_X adds to the last two */
};

/* The contact is held: the coin turns about the vertical through its contact,
 * or through its centre if it slips. */
COIN_PRIV_INLINE struct free_motion held_motion(const double *y,
                                                const coin_priv_law *l,
                                                const struct place *at,
                                                int slips)
{
    const double wX = y[COIN_PRIV_WX], s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double turn = c * y[COIN_PRIV_WY] - s * y[COIN_PRIV_WZ];
    const double IX = l->IX, K = l->K[slips], P = at->P;
    const double eta = slips ? 0 : at->eta;
    const double bend = eta * (s * s - c * c - eta * (s * c));
    const double D = IX * (c * c) + K * (s * s) + eta * c * (eta * c - 2 * s);
    const double torque =
        l->spin + l->angular * (IX * (c * c) + l->IZ * (s * s)); /* (72) */
    const double fade =
        -(turn * (torque + 2 * s * c * wX * (K - IX) + 2 * wX * bend) -
          (slips ? 0 : P * at->g.X)) /
        D; /* (72), (85) */
    const double lift = (K - IX) * c * (turn * turn);
    const double more =
        slips ? 0 : turn * turn * bend - eta * c + at->Y * at->g.h;
    const struct free_motion r = {
        1,
        turn,
        0,
        (s * ((slips ? 0 : 1) + lift) - l->angular * IX * wX + more) *
            l->perJ[slips], /* (72) */
        c * fade - s * wX * turn,
        -s * fade - c * wX * turn,
        -P * c / D, /* (85) */
        P * s / D,  /* (85) */
    };
    return r;
}

/* What a thickness and a pull add to the motion of a coin that rolls. */
COIN_PRIV_INLINE void add_thickness(struct free_motion *r, const double *y,
                                    const coin_priv_law *l,
                                    const struct place *at)
{
    const double wX = y[COIN_PRIV_WX], wY = y[COIN_PRIV_WY];
    const double wZ = y[COIN_PRIV_WZ], s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double eta = at->eta, k1 = l->IZ * l->perJ[1];
    r->X +=
        (c * (at->g.h * at->Y - eta * c) - wY * eta * (s * wZ + at->Y * wY)) *
        l->perJ[0];                                                /* (120) */
    r->Z = c * (wX * (wY - eta * k1 * wZ) - at->g.X) * l->perK[0]; /* (120) */
    r->Y += eta * k1 * r->Z;                                       /* (120) */
}

/* Adds the losses of a coin that rolls with a thickness: its contact answers
 * with a friction along e_X. */
COIN_PRIV_INLINE void add_thick_losses(struct free_motion *r, const double *y,
                                       const coin_priv_law *l, double eta)
{
    const double k1 = l->IZ * l->perJ[1];
    const coin_priv_slowing d = coin_priv_slowing_of(l, y, 1);
    const double F = -(d.wZ + eta * d.wY) * l->perK[0]; /* (121), over I_Z */
    r->X += coin_priv_slowing_of(l, y, 0).wX;
    r->Y += d.wY + eta * k1 * F; /* (121) */
    r->Z += d.wZ + F;            /* (121) */
}

COIN_PRIV_INLINE struct free_motion rolling_motion(const double *y,
                                                   const coin_priv_law *l,
                                                   const struct place *at,
                                                   int slips, int plain)
{
    const double wX = y[COIN_PRIV_WX], wY = y[COIN_PRIV_WY];
    const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double cwZ = c * y[COIN_PRIV_WZ], swY = s * wY;
    const double k1 = l->IZ * l->perJ[1], K = l->K[slips];
    const double fall = slips ? 0 : s * c;
    struct free_motion r = {
        c,
        wY,
        cwZ + swY,
        (fall - wY * (K * cwZ + l->IX * swY)) * l->perJ[slips], /* (78) */
        wX * (k1 * cwZ + swY),                                  /* (78) */
        slips ? 0 : c * wX * wY * l->perK[0],
        0,
        l->perK[1],
    };
    if (!plain && slips)
        r.perY = at->eta * l->perJ[1]; /* from (122) */
    if (!plain && !slips)
        add_thickness(&r, y, l, at);
    if (l->lossy && !plain && !slips) {
        add_thick_losses(&r, y, l, at->eta);
    } else if (l->lossy) {
        const coin_priv_slowing d = coin_priv_slowing_of(l, y, slips);
        r.X += d.wX;
        r.Y += d.wY;
        r.Z += d.wZ;
    }
    return r;
}

/* The slopes of a coin under a force, times `by`. */
COIN_PRIV_INLINE void slopes_of(double *d, const double *y,
                                const struct free_motion *o,
                                const struct place *at, const coin_priv_push *F,
                                int slips, double by, int plain)
{
    const double wX = y[COIN_PRIV_WX], s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double sph = y[COIN_PRIV_SPH], cph = y[COIN_PRIV_CPH];
    const double vX = at->vX, vh = at->vh;
    double uX = F->X - o->turn * vh + o->Z;
    double uh = F->h + o->turn * vX + o->f * at->P * (wX * wX) - at->Y * o->X;
    if (!plain) {
        uX += o->f * at->g.X + at->eta * o->Y;
        uh += o->f * at->g.h;
    }
    d[COIN_PRIV_WX] = by * o->X;
    d[COIN_PRIV_WY] = by * o->Y;
    d[COIN_PRIV_WZ] = by * o->Z;
    d[COIN_PRIV_S] = by * (o->f * c * wX);
    d[COIN_PRIV_C] = by * (-o->f * s * wX);
    d[COIN_PRIV_UX] = slips ? by * uX : 0;
    d[COIN_PRIV_UH] = slips ? by * uh : 0;
    d[COIN_PRIV_SPH] = by * (o->turn * cph);
    d[COIN_PRIV_CPH] = by * (-o->turn * sph);
    d[COIN_PRIV_ADDS_PHI] = by * o->turn;
    d[COIN_PRIV_ADDS_PSI] = by * o->roll;
    d[COIN_PRIV_ADDS_X] = by * (o->f * (vX * cph + vh * sph));
    d[COIN_PRIV_ADDS_Z] = by * (o->f * (vh * cph - vX * sph));
    d[COIN_PRIV_ADDS_T] = by * o->f;
    for (int i = COIN_PRIV_SIZE; i < COIN_PRIV_WIDE; ++i)
        d[i] = 0; /* no vector reads what nothing wrote */
}

/* Slopes and force of one mode.  *d is what a step needs, times `by`.  plain:
 * l->plain. */
COIN_PRIV_INLINE coin_priv_push contact(double *d, const double *y,
                                        const coin_priv_law *l, int mode,
                                        coin_priv_direction n, double by,
                                        int plain)
{
    const struct place at = place_of(y, l, plain);
    const double wX = y[COIN_PRIV_WX], P = at.P, Y = at.Y;
    const int slips = (mode & COIN_PRIV_SLIPS) != 0;
    struct free_motion o = mode & COIN_PRIV_HELD
                               ? held_motion(y, l, &at, slips)
                               : rolling_motion(y, l, &at, slips, plain);
    coin_priv_push F;
    if (slips) {
        const double mu = l->mu_kinetic;
        F.N = (o.f * (1 - Y * (wX * wX)) - P * o.X) /
              (1 + P * (P + Y * (mu * n.h)) * l->perJ[1]); /* (80), (122) */
        F.X = -mu * F.N * n.X;
        F.h = -mu * F.N * n.h;
        o.X += (F.N * P - F.h * Y) * l->perJ[1]; /* (81) */
        o.Y += o.perY * F.X;                     /* (81) */
        o.Z += o.perZ * F.X;                     /* (81) */
    } else {
        F.N = o.f * (1 - Y * (wX * wX)) - P * o.X;
        F.X = o.turn * at.vh - o.Z;                           /* (82) */
        F.h = Y * o.X - o.f * P * (wX * wX) - o.turn * at.vX; /* (82) */
        if (!plain) {
            F.X -= o.f * at.g.X + at.eta * o.Y; /* from (120) */
            F.h -= o.f * at.g.h;                /* from (120) */
        }
    }
    if (d)
        slopes_of(d, y, &o, &at, &F, slips, by, plain);
    return F;
}

#endif
