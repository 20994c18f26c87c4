/* SPDX-License-Identifier: MIT */
/* What follows a coin that rolls: one call, and many short
 * ones; the time to rest.  What a
 * call returns has to mean to the next what its status says. */
#include "body.hpp"
#include "motion.hpp"

namespace
{
/* No excursion that exceeds mu by 1e-4 of it lies before the moment reached;
 * looked for at 48 moments, of motions that amplify errors little.  A lift-off
 * may be brief: where mu is large, there are 500. */
template <class T, class R> bool until(trial<T, R> &q)
{
    const scene &s = q.s;
    given body(s, 1e-12);
    const double t = std::fabs(s.t), mu = s.tol;
    body.table.mu_static = mu;
    body.table.mu_kinetic = lesser(mu, 0.1);
    motion<R> truth(q.p, q.y);
    const bool lifts = !(mu > 1e6 && int(s.steps) % 2 > 0);
    const int32_t bits = lifts ? COIN_SLIPS | COIN_LIFTS : COIN_SLIPS;
    double reached = 0;
    if (truth.is_long(R(t)) || !body.roll() ||
        body.move(&body.b, t, bits, &reached) < 0)
        return false;
    /* Next to N = 0 F/N changes fast. */
    const bool is_large = mu > 100;
    const int looks = is_large ? 500 : 48;
    const double late = is_large ? 1e-6 : 2e-12, most = is_large ? 1e5 : 1000;
    const R clear = R(reached) - late / truth.w;
    R worst = 0, N, F;
    for (int k = 0; k < looks && clear > 0; ++k) {
        if (!truth.follow(clear / looks) || truth.at(truth.C) < 1 / R(most))
            return false;
        truth.stuck(&N, &F);
        worst = larger(worst, N > 0 ? F / (mu * N) - 1 : R(lifts ? 1 : -1));
    }
    if (worst > 0 && growth({q.p, q.y}, reached / 16, 16, most + 1) > most)
        return false;
    return q.is(double(worst / R(1e-4)));
}

/* --------------------------------------------- one call, or many short ones */

enum mover { ADVANCE, ADVANCE_CALLS, SETTLE, SETTLE_CALLS, MOVE_CALLS };

/* What it may err by: so many tol a radius of speed; and u, so many in a
 * natural time, at once, and in each of many calls over cos theta. */
constexpr struct claim {
    double tol, in_time, at_once, each;
} CLAIMS[] = {{2, 9, 0, 0},
              {2, 90, 90, 8},
              {20, 90, 90, 0},
              {2, 90, 90, 8},
              {2, 90, 90, 8}};

struct calls : given {
    int kind, count;
    double dt;
    coin_losses l = {};

    calls(const scene &s, int mover)
        : given(s, s.tol), kind(mover),
          count(CLAIMS[mover].each > 0 ? int(s.steps) : 1), dt(s.t)
    {
        scene of = s;
        if (kind > SETTLE) {
            of.steps = s.q[3];
            std::fill(of.q, of.q + 4, s.q[2]);
        }
        if (kind >= SETTLE)
            l = table.losses = losses_of(of);
        table.mu_static = s.q[1];
        table.mu_kinetic = s.q[0];
    }
    int32_t call()
    {
        return kind < SETTLE       ? coin_advance(&b.s, &p, dt, tol, nullptr)
               : kind < MOVE_CALLS ? coin_settle(&b.s, &p, &l, dt, tol, nullptr)
                                   : move(&b, dt);
    }
    /* The slip of a body that rolls, in parts of what rounding may leave. */
    double slip_left() const
    {
        double u[2];
        if (!says(COIN_OK, b) || !is_on_table(b, p) ||
            coin_body_slip(&b, &p, u) != COIN_OK)
            return BROKEN;
        const double size = std::fabs(b.vx) + std::fabs(b.vz) +
                            p.radius * (std::fabs(b.s.wX) + std::fabs(b.s.wZ));
        return std::hypot(u[0], u[1]) / (8 * doubles::u * size + DBL_MIN);
    }
};

/* Follows a call, and looks at the cone of friction each 0.1 rad of the fastest
 * rate: where least is left of it, the motion is *tightest.  False if that
 * takes more than *looks. */
template <class R>
bool follow_in_cone(motion<R> *at, R t, R mu, motion<R> *tightest, int *looks)
{
    while (t > 0) {
        const R step = lesser(t, R(0.1) / (at->fastest() * at->w));
        if (--*looks < 0 || !at->follow(step))
            return false;
        t = step < t ? t - step : R(0);
        if (at->left(mu) < tightest->left(mu))
            *tightest = *at;
    }
    return true;
}

/* By a mover that keeps the coin rolling, and by coin_move() where friction
 * does. */
template <class T, class R> bool rolls(trial<T, R> &q)
{
    calls c(q.s, q.kind);
    const claim &may = CLAIMS[q.kind];
    const bool may_slip = q.kind == MOVE_CALLS;
    const R dt = c.dt, t = c.count * dt, mu = c.table.mu_static;
    motion<R> truth(c.p, c.b.s);
    motion<long double> start(c.p, c.b.s);
    const R natural = magnitude(t) * truth.w, turned = truth.turned(t);
    if (q.kind >= SETTLE) {
        truth.slow_by(c.l, c.p);
        start.slow_by(c.l, c.p);
    }
    if (truth.is_long(t) || (may_slip && !c.roll()))
        return false;
    motion<R> tightest = truth;
    R least = truth.at(truth.C);
    for (int i = 0, looks = 2000; i < c.count; ++i) {
        if (!(may_slip ? follow_in_cone(&truth, dt, mu, &tightest, &looks)
                       : truth.follow(dt)) ||
            (may_slip && !(tightest.left(mu) > R(1e-3))))
            return false;
        least = lesser(least, truth.at(truth.C));
    }
    const R bound =
        may.tol * R(q.s.tol) * (1 + turned) +
        q.u * (may.at_once + may.in_time * natural +
               16 * truth.largest_of_pose() + may.each * c.count / least);
    const double sixteenth = double(t) / 16;
    if (bound >= 1)
        return false;
    for (int i = 0; i < c.count; ++i) {
        const int32_t status = c.call();
        if (may_slip && (status == COIN_SLIPS || status == COIN_LIFTS)) {
            const auto left = [mu](const motion<R> &m) { return m.left(mu); };
            const double near =
                double(left(tightest) / tightest.moves(left) / bound);
            return near > 1 && growth(start, sixteenth, 16, near) < near &&
                   q.is(BROKEN);
        }
        if (status != COIN_OK)
            return false;
        if (may_slip)
            q.is(c.slip_left());
    }
    return q.is(unamplified(ratio_of(truth.off(c.b.s), bound), q.enough, start,
                            sixteenth, 16));
}

/* Up to 64 calls of what is 1/1000 to 1/30 s to a quarter; mu_static from
 * mu_kinetic to infinity; half with losses, damping where
 * mu_static is infinite. */
void short_calls(scene *s, const double *g, int)
{
    s->t = std::sqrt(s->a / s->g) * std::pow(10, 1.6 * g[22] - 1.6);
    s->steps = 1 + std::floor(64 * g[23]);
    s->tol = std::pow(10, 7 * g[24] - 9);
    s->q[0] = 0.9 * g[26];
    s->q[1] = g[27] > 0.8 ? double(INFINITY) : s->q[0] / (1 - g[27]);
    s->q[2] = std::pow(10, 5 * g[28] - 6.5);
    const int which = int(512 * g[29] - 256); /* angular, damping too */
    s->q[3] = which < 0 ? 0 : which % 128 / 2 * 2 + which / 128 * 256;
    if (which > 0 && s->q[1] > DBL_MAX)
        s->q[3] += which % 2;
    near_pose(s, g);
}

/* ---------------------------------------------------------- the time to rest
 */

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
    const R late = R(1.05) * R(when);
    const R bound =
        2e-6 * (1 + truth.turned(R(when))) +
        q.u * (90 * (1 + R(when) * truth.w) + 16 * truth.largest_of_pose());
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

/* ------------------------------------------------------------------- edges */

/* The friction coefficient; a large one also of coins so slow that they fall,
 * bounce near flat and lift off. */
void until_it_slips(scene *s, const double *g, int)
{
    horizon(s, g, 0);
    s->tol = std::pow(10, 4 * g[24] - 2);
    if (g[24] < 0.7)
        return;
    const double w = std::sqrt(s->g / s->a);
    s->tol = std::pow(10, 40 * g[24] - 28);
    s->theta = 2 * g[8] - 1;
    s->wX = w * (2 * g[11] - 1);
    s->wY = w * (g[12] - 0.5) * (g[15] < 0.5);
    s->wZ = w * (g[13] - 0.5) * (g[16] < 0.5);
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

} // namespace

std::vector<row> rolling_motions()
{
    const char *moved = "2 tol a radius of speed + rounding";
    return {
        ROW("advance", moved, 10, horizon, ADVANCE, rolls),
        ROW("settle", "20 tol a radius of speed + rounding", 25, launches,
            SETTLE, rolls),
        ROW("move_until", "F/N over mu by 1e-4 of mu", 10, until_it_slips, 0,
            until),
        ROW("time_to_rest", "2 tol a radius of speed, of the fall; tol = 1e-6",
            1000, falls, 0, time_to_rest),
        ROW("advance_calls", moved, 50, short_calls, ADVANCE_CALLS, rolls),
        ROW("settle_calls", moved, 50, short_calls, SETTLE_CALLS, rolls),
        ROW("move_calls",
            "2 tol a radius of speed + rounding; rolls where the truth "
            "does",
            50, short_calls, MOVE_CALLS, rolls),
    };
}
