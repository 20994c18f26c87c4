/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "thrown.h"

/* The most trials of steps of a call.  Where a trial takes longest, in a slip
 * with losses near flat, it takes as long as 14 textbook steps. */
#define TRIES 11000

/* What a call may be ended by. */
#define STOPS                                                                  \
    (COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT | COIN_ROLLS | COIN_TOUCHES)

/* Sets w->b to the body in natural units. */
static void to_natural(coin_priv_thrown *w, const coin_body *b,
                       const coin_priv_body *of)
{
    const double per_a = 1 / of->a, per_w = 1 / sqrt(of->g_a);
    const double per_v = per_a * per_w;
    const coin_params p = {1, 1, 1, of->IX / of->m, of->IZ / of->m, {0, 0, 0}};
    coin_body *const n = &w->b;
    w->of = coin_priv_body_of(&p);
    *n = *b;
    n->s.x *= per_a;
    n->s.z *= per_a;
    n->s.wX *= per_w;
    n->s.wY *= per_w;
    n->s.wZ *= per_w;
    n->y *= per_a;
    n->vx *= per_v;
    n->vy *= per_v;
    n->vz *= per_v;
}

/* Sets *b to the body w->b.  Where it touches, height and velocity are what the
 * mode says of the other members. */
static void from_natural(coin_body *b, const coin_priv_thrown *w,
                         const coin_priv_body *of, int32_t status)
{
    const double a = of->a, w0 = sqrt(of->g_a), v0 = a * w0;
    double u[2];
    const int mode = status > 0 && status & COIN_LIFTS
                         ? COIN_PRIV_AIR
                         : coin_priv_body_mode(&w->b, &w->of, u);
    coin_body to = w->b;
    to.s.x *= a;
    to.s.z *= a;
    to.s.wX *= w0;
    to.s.wY *= w0;
    to.s.wZ *= w0;
    if (!(mode & COIN_PRIV_AIR))
        coin_priv_set_rolling(&to, of);
    else
        to.y *= a;
    if (mode & COIN_PRIV_AIR)
        to.vy *= v0;
    if (mode) {
        to.vx = w->b.vx * v0;
        to.vz = w->b.vz * v0;
    }
    if (mode & COIN_PRIV_RESTS)
        to.s.wZ = to.vx = to.vy = to.vz = 0;
    *b = to;
}

int32_t coin_move(coin_body *b, const coin_params *p, const coin_table *table,
                  double t, double tol, int32_t stop, double *reached)
{
    coin_priv_body of;
    coin_priv_thrown w;
    double u[2];
    if (!b || !p || !table || !coin_priv_tol_suits(tol) || (stop & ~STOPS))
        return COIN_EARG;
    if (coin_priv_check_body(&of, p) != COIN_OK ||
        coin_priv_table_law(&w.g.law, table, &of) != COIN_OK)
        return COIN_EPARAMS;
    int32_t status = coin_priv_check_coin_body(b, p, &of);
    if (status != COIN_OK)
        return status;
    if (w.g.law.damping > 0 &&
        coin_priv_body_mode(b, &of, u) & (COIN_PRIV_SLIPS | COIN_PRIV_AIR))
        return COIN_EPARAMS;
    if (!coin_priv_time_suits(t, sqrt(of.g_a)))
        return COIN_ESTEP;
    to_natural(&w, b, &of);
    w.restitution = table->restitution;
    w.time = t * sqrt(of.g_a);
    w.tol = tol;
    w.moved.sum = w.moved.low = 0;
    w.stop = stop;
    w.event = w.changed = 0;
    w.g.tries = TRIES;
    status = coin_priv_go_on(&w);
    const double moved = (w.moved.sum + w.moved.low) / sqrt(of.g_a);
    if (w.changed)
        from_natural(b, &w, &of, status);
    if (reached)
        *reached = w.moved.sum == w.time || moved > t ? t : moved;
    return status;
}
