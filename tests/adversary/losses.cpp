/* SPDX-License-Identifier: MIT */
/* Coins with losses: what is read off a state, and the way to rest. */
#include "motion.hpp"

namespace
{
/* --------------------------------------------------------- read off a state */

/* Holds an output within so many u of its terms, and of the normal numbers. */
template <class T, class R>
void holds(trial<T, R> &q, double output, const terms<R> &truth, int units = 16)
{
    q.hold(R(output), truth.value, units * (q.u * truth.size + 16 * q.normal));
}

template <class T, class R>
slowing<R> slowed(const trial<T, R> &q, const coin_losses &l)
{
    const moment<R> &y = q.at;
    const losses<R> of(l, softening(l, q.p), 1, 1, 1);
    return of.at(y.IX, y.IZ, y.J, y.K, y.s, y.c, y.wX, y.wY, y.wZ);
}

template <class T, class R> bool power(trial<T, R> &q)
{
    const coin_losses l = losses_of(q.s);
    const double P = coin_losses_power(&q.y, &q.p, &l);
    holds(q, P, slowed(q, l).power, 24);
    return P == P;
}

template <class T, class R> bool rates(trial<T, R> &q)
{
    const coin_losses l = losses_of(q.s);
    coin_state d;
    if (coin_losses_rates(&q.y, &q.p, &l, &d) != COIN_OK)
        return false;
    const slowing<R> by = slowed(q, l);
    terms<R> want[8];
    rates_of(q.at, want);
    holds(q, d.wX, want[5].add(by.wX, R(1)));
    holds(q, d.wY, want[6].add(by.wY, R(1)));
    holds(q, d.wZ, want[7].add(by.wZ, R(1)));
    return true;
}

template <class T, class R> bool reaction(trial<T, R> &q)
{
    const coin_losses l = losses_of(q.s);
    coin_force f;
    if (coin_losses_reaction(&q.y, &q.p, &l, &f) != COIN_OK)
        return false;
    const slowing<R> by = slowed(q, l);
    const moment<R> &y = q.at;
    const R Ma = y.M * y.a;
    table_force<R> F = force_of(y);
    /* M a (-dwZ e_X + dwX e_Z) */
    F.Rx.add(by.wZ, -Ma * y.cph).add(by.wX, Ma * y.c * y.sph);
    F.normal.add(by.wX, -Ma * y.s);
    F.Rz.add(by.wZ, Ma * y.sph).add(by.wX, Ma * y.c * y.cph);
    holds(q, f.R[0], F.Rx);
    holds(q, f.normal, F.normal);
    holds(q, f.R[2], F.Rz);
    return true;
}

/* Any state, and losses from 1e-8 to 0.1; soft, where it is not the usual, from
 * 1e-9 to 1. */
void some_losses(scene *s, const double *g, int)
{
    s->steps = std::floor(512 * g[23]);
    for (int i = 0; i < 4; ++i)
        s->q[i] = std::pow(10, 7 * g[26 + i] - 8);
    s->tol = std::pow(10, 9 * g[24] - 9);
}

/* -------------------------------------------------------- the way to rest */

/* What coin_settle() may err by. */
template <class R> R allowed(const motion<R> &start, R t, R tol)
{
    return 2 * tol * (1 + start.turned(t)) +
           R(doubles::u) *
               (90 * (1 + t * start.w) + 16 * start.largest_of_pose());
}

/* Followed by the textbook's equations and torques for up to 80 rad. */
template <class T, class R> bool settle(trial<T, R> &q)
{
    const coin_losses l = losses_of(q.s);
    const R t = q.s.t;
    coin_state end = q.y;
    motion<R> truth(q.p, q.y);
    motion<long double> start(q.p, q.y);
    const R bound = allowed(truth, t, 10 * R(q.s.tol));
    truth.slow_by(l, q.p);
    start.slow_by(l, q.p);
    if (truth.is_long(t) ||
        coin_settle(&end, &q.p, &l, q.s.t, q.s.tol, nullptr) != COIN_OK ||
        !truth.follow(t) || bound >= 1)
        return false;
    return q.is(unamplified(ratio_of(truth.off(end), bound), q.enough, start,
                            q.s.t / 16, 16));
}

/* Follows a path for a time, or until cos theta comes below `flat`; how long.
 * *least: the smallest cos theta of a swing before; negative if that takes too
 * long. */
template <class R> R until_flat(motion<R> *at, R t, R flat, R *least)
{
    const auto above = [flat](const motion<R> &m) {
        return !(m.at(m.C) < flat);
    };
    R gone = 0, before = 1, last = 1;
    *least = 1;
    for (int i = 0; gone < t; ++i) {
        const motion<R> from = *at;
        const R h = lesser(t - gone, R(0.1) / (at->fastest() * at->w));
        if (i > 4000)
            return -1;
        if (!at->follow(h) || !above(*at))
            return gone + at->cross(from, h * at->w, above) / at->w;
        const R now = at->at(at->C);
        if (last <= before && last <= now)
            *least = lesser(*least, last);
        before = last;
        last = now;
        gone += h;
    }
    return gone;
}

/* What a time of rest errs by, in radians of the fall, where a coin falls
 * steeply through `flat`; no claim where an earlier swing nearly ended there.
 */
template <class T, class R> bool time_to_rest(trial<T, R> &q)
{
    const coin_losses l = losses_of(q.s);
    motion<R> truth(q.p, q.y);
    if (truth.is_long(R(q.s.t)))
        return false;
    const double when = coin_time_to_rest(&q.y, &q.p, &l);
    const R flat = l.flat > 0 ? l.flat : 1e-6;
    const R bound = allowed(truth, R(when), R(1e-6)), late = R(1.05) * R(when);
    if (!(when > 0 && when < 1e300) || truth.is_long(R(when)) ||
        truth.at(truth.C) < 2 * flat)
        return false;
    motion<long double> start(q.p, q.y);
    truth.slow_by(l, q.p);
    start.slow_by(l, q.p);
    R least;
    const R took = until_flat(&truth, late, flat, &least);
    const R fall = magnitude(truth.at(truth.WX));
    if (took < 0 || !(bound < R(1e-3) * flat) || least < 2 * flat)
        return false;
    const R off = magnitude(took - R(when)) * truth.w;
    return q.is(took < late ? unamplified(double(off * fall / bound), q.enough,
                                          start, 0.999 * when / 16, 16)
                            : BROKEN);
}

/* Forward, 0.01 to 30 natural units; losses up to 0.03.  Half roll slowly at
 * first, so that the contact soon turns round.  A fifth hardly spin. */
void launches(scene *s, const double *g, int)
{
    if (g[25] < 0.5)
        s->wZ = 0.2 * s->wZ - s->wY * std::tan(s->theta);
    if (g[25] > 0.8) {
        const double part = std::pow(10, -50 * (g[25] - 0.8));
        s->wY *= part;
        s->wZ *= part;
    }
    const int which = int(1024 * g[23]); /* with flat, also angular */
    s->steps = which % 128 + which / 128 % 4 * 256;
    s->method = std::pow(10, 2 * g[6] - 4);
    for (int i = 0; i < 4; ++i)
        s->q[i] = std::pow(10, 5 * g[26 + i] - 6.5);
    s->tol = std::pow(10, 9 * g[24] - 12);
    s->t = std::sqrt(s->a / s->g) * std::pow(10, 3.5 * g[22] - 2);
    near_pose(s, g);
}

/* As many, that lie flat from 1e-4 to 1e-2 rad on, and often fall; with losses
 * from 1e-4 on, so that most rest soon. */
void falls(scene *s, const double *g, int)
{
    launches(s, g, 0);
    s->steps = int(s->steps) % 512 + 512;
    for (int i = 0; i < 4; ++i)
        s->q[i] = std::pow(10, 3 * g[26 + i] - 4);
    if (g[14] < 0.5) {
        s->wY *= 0.01 * g[17];
        s->wZ *= 0.01 * g[17];
    }
}

#define LOSSES(name, bound, share, edge, law)                                  \
    LAW(doubles, "coin_" name, bound, share, edge, 0, law)
} // namespace

std::vector<row> losses_of_energy()
{
    return {
        LOSSES("losses_power", "24 u of the terms", 1, some_losses, power),
        LOSSES("losses_rates", "16 u of the terms", 1, some_losses, rates),
        LOSSES("losses_reaction", "16 u of the terms", 1, some_losses,
               reaction),
        LOSSES("settle", "20 tol a radius of speed + rounding", 25, launches,
               settle),
        LOSSES("time_to_rest",
               "2 tol a radius of speed, of the fall; tol = 1e-6", 1000, falls,
               time_to_rest),
    };
}
