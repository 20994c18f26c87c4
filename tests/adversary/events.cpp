/* SPDX-License-Identifier: MIT */
/* When a slip begins or ends, a coin lifts off, or it rests. */
#include "motion.hpp"

namespace
{
/* Times that are determined worse than this are no claim. */
constexpr double BLURRED = 1e-3;

/* The slip speed below which a coin rolls.  The truth takes what remains of a
 * slip from there on as a straight line. */
constexpr double ROLLS = 1e-10;

/* How late a call may be at a true time at which a function of the motion is 0,
 * in natural units: what coin_move() may err by until then, times what errors
 * move the function by, over its slope. */
real blurred(real natural, double tol, real least, real moves, real slope)
{
    const real error = (tol + 1e-14L) * (1 + natural) + 64 * doubles::u + least;
    return error * moves / std::fabs(slope);
}

/* What stops a call at a change of mode, and the modes before and after. */
struct change {
    int32_t stop, before, after;
};
constexpr change BEGINS = {COIN_SLIPS | COIN_LIFTS, COIN_OK, COIN_SLIPS};
constexpr change ENDS = {COIN_ROLLS, COIN_SLIPS, COIN_OK};
constexpr change LIFTS = {COIN_LIFTS, COIN_SLIPS, COIN_LIFTS};

/* How far from the time of a change a call ends that is stopped there, in parts
 * of so many bounds, if the modes on both sides are the ones before and after.
 * The change may be unseen for some time.  A coin that begins to slip may lift
 * off at once.  No claim if a call says COIN_MORE: it tells neither. */
constexpr double MISSED = 32;

double late(const trial<doubles> &q, const change &of, real when, real bound,
            real unseen)
{
    const real at[] = {when - bound, when + bound + unseen,
                       when + MISSED * bound};
    int32_t is[3];
    double reached = 0;
    for (int i = 0; i < 3; ++i) {
        coin_body b = q.b;
        is[i] = q.move(&b, std::max(0.0, double(at[i])),
                       i < 2 ? COIN_LIFTS : of.stop, &reached);
        if (is[i] & COIN_MORE)
            return NO_CLAIM;
    }
    return is[0] == of.before && (is[1] == of.after || is[1] == COIN_LIFTS) &&
                   is[2] & of.stop
               ? double(std::fabs(reached - when) / bound)
               : MISSED;
}

/* The same before the motion's own amplification; of a time, a bound and how
 * long it may be unseen in natural units. */
bool holds(trial<doubles> &q, const motion &start, const change &of,
           real natural, real bound, real unseen = 0)
{
    const real w = start.w, when = natural / w;
    const auto ratio = [&](real growth) {
        return late(q, of, when, bound / w * growth, unseen / w);
    };
    if (!(bound < BLURRED))
        return false;
    const double plain = ratio(1);
    return q.is(plain > std::max(q.enough, UNAMPLIFIED)
                    ? ratio(start.growth(0.9L * when, 1e30L))
                    : plain);
}

/* From where it rolls to where nothing is left of the cone. */
bool begins(trial<doubles> &q)
{
    if (!q.roll() || !q.says(COIN_OK, q.b))
        return false;
    const real mu = q.table.mu_static;
    const auto left = [mu](const motion &m) { return m.left(mu); };
    const motion start(q.p, q.y);
    motion truth = start;
    if (!(left(truth) > 1e-3L) || truth.is_long(q.s.t) ||
        truth.until(q.s.t, left, 0.05) != motion::CROSSES)
        return false;
    /* How long a slip from here counts as rolling, at most: by what rolling
     * needs beyond the friction of a slip. */
    const motion::contact needs = truth.stuck();
    const real rounding =
        16 * doubles::u *
        (std::fabs(truth.at(truth.WX)) + std::fabs(truth.at(truth.WZ)));
    const real unseen =
        (ROLLS + rounding) / (needs.F - q.table.mu_kinetic * needs.N);
    const real bound = blurred(truth.took, q.s.tol, 0, truth.moves(left),
                               truth.slope_of(left));
    return bound < BLURRED / truth.fastest() &&
           holds(q, start, BEGINS, truth.took, bound, 2 * unseen);
}

/* Of a slip. */
bool ends(trial<doubles> &q)
{
    const auto speed = [](const motion &m) { return m.speed() - ROLLS; };
    const motion start(q.p, q.b, q.table.mu_kinetic);
    motion truth = start;
    truth.slowest = 0;
    if (!q.says(COIN_SLIPS, q.b) || !(truth.speed() > 1e-2L) ||
        truth.until(q.s.t, speed) != motion::CROSSES)
        return false;
    const motion::contact needs = truth.stuck();
    const real slope = truth.speed_slope();
    if (!(slope < 0 && needs.N > 0 &&
          needs.F < 0.95L * q.table.mu_static * needs.N))
        return false;
    /* u is a sum of two velocities, and one that theta changes. */
    const real natural = truth.took - ROLLS / slope;
    const real bound = blurred(natural, q.s.tol, ROLLS,
                               2 + std::fabs(truth.at(truth.WX)), slope);
    return holds(q, start, ENDS, natural, bound);
}

/* From a slip. */
bool lifts(trial<doubles> &q)
{
    const auto pressed = [](const motion &m) { return m.pressed(); };
    const motion start(q.p, q.b, q.table.mu_kinetic);
    motion truth = start;
    if (!q.says(COIN_SLIPS, q.b) || !(truth.speed() > 1e-2L) ||
        !(truth.pressed() > 1e-3L) ||
        truth.until(q.s.t, pressed) != motion::CROSSES)
        return false;
    /* A contact counts as open from this part of the terms of its force on, so
     * that it is open where the state is rounded. */
    const real c = truth.at(truth.C), spins = std::fabs(truth.at(truth.WY));
    const real terms = 1 + truth.at(truth.WX) * truth.at(truth.WX) +
                       spins * (spins + std::fabs(truth.at(truth.WZ))) / c;
    const real open = (1e-12L + 1e-15L / c) * terms;
    const real slope = truth.slope_of(pressed);
    const real bound =
        blurred(truth.took, q.s.tol, 0, truth.moves(pressed), slope) +
        open / std::fabs(slope);
    return holds(q, start, LIFTS, truth.took, bound);
}

/* No excursion that exceeds mu by 1e-4 of it lies before the moment reached, in
 * motions that amplify errors little. */
bool until(trial<doubles> &q)
{
    const real mu = q.table.mu_static;
    const motion start(q.p, q.y);
    motion truth = start;
    const bool lifts = !(mu > 1e6L && q.s.method < 2);
    double reached = 0;
    if (truth.is_long(q.s.t) || !q.roll() || !q.says(COIN_OK, q.b) ||
        q.move(&q.b, q.s.t, lifts ? COIN_SLIPS | COIN_LIFTS : COIN_SLIPS,
               &reached) < 0)
        return false;
    /* Next to N = 0 F/N changes fast. */
    const double most = mu > 100 ? 1e5 : 1000;
    const real clear = reached - (mu > 100 ? 1e-6L : 2e-12L) / truth.w;
    real worst = lifts ? -1 : 0;
    const auto cone = [&](const motion &m) {
        const motion::contact f = m.stuck();
        worst = std::max(worst, f.N > 0 ? f.F / (mu * f.N) - 1 : real(lifts));
        return m.at(m.C) - 1 / most;
    };
    if (!(clear > 0) || truth.until(clear, cone, 0.1, 0) != motion::GOES ||
        (worst > 0 && start.growth(clear, most + 1) > most))
        return false;
    return q.is(double(std::max(real(0), worst) / 1e-4L));
}

/* What a time of rest errs by, in radians of the fall, where a coin falls
 * steeply through flat; no claim where an earlier swing nearly ended there. */
bool time_to_rest(trial<doubles> &q)
{
    const real flat = q.losses.flat > 0 ? q.losses.flat : 1e-6;
    motion truth(q.p, q.y);
    truth.slow_by(q.losses, q.p);
    const motion start = truth;
    const auto above = [flat](const motion &m) { return m.at(m.C) - flat; };
    if (truth.is_long(q.s.t))
        return false;
    const real when = coin_time_to_rest(&q.y, &q.p, &q.losses, 1e-6);
    if (!(when > 0 && when < 1e300L) || truth.is_long(when) ||
        !(above(truth) > flat))
        return false;
    const motion::fate fate =
        truth.until(1.05L * when, above, 0.1, double(flat));
    const real bound =
        2e-6L * (1 + start.turned(when)) +
        doubles::u * (90 * (1 + when * truth.w) + 16 * truth.largest_of_pose());
    if (fate == motion::UNKNOWN || !(bound < 1e-3L * flat))
        return false;
    const real off = std::fabs(truth.took - when * truth.w);
    return q.is(
        fate == motion::GOES
            ? BROKEN
            : unamplified(double(off * std::fabs(truth.at(truth.WX)) / bound),
                          q.enough, start, 0.999L * when));
}

/* What a coin that nothing leans takes to slow from one roll to another, in
 * natural units: integrals over the logarithm of the roll, by Gauss's rule of
 * five places. */
struct straight {
    real time = 0, path = 0;

    straight(const losses &l, real IX, real IZ, real from, real to)
    {
        constexpr int PARTS = 400;
        const real r = std::sqrt(10 / 7.0L), t = 13 * std::sqrt(70.0L);
        const real x[] = {std::sqrt(5 - 2 * r) / 3, std::sqrt(5 + 2 * r) / 3};
        const real h = std::log(from / to) / (2 * PARTS);
        const auto add = [&](real at, real weight) {
            const real w = to * std::exp(h * at);
            const real slope =
                l.at(IX, IZ, IX + 1, IZ + 1, 0, 1, 0, 0, w).wZ.value;
            time -= h * weight * w / slope;
            path -= h * weight * w * w / slope;
        };
        for (int k = 0; k < PARTS; ++k) {
            const real middle = 2 * k + 1;
            add(middle, 128 / 225.0L);
            for (int side : {-1, 1}) {
                add(middle + side * x[0], (322 + t) / 900);
                add(middle + side * x[1], (322 - t) / 900);
            }
        }
    }
};

/* Where a coin comes to rest that rolls straight on, and when: where the roll
 * is within its error of that at which a coin rests. */
template <bool is_body> bool stands(trial<doubles> &q)
{
    const coin_losses &by = is_body ? q.table.losses : q.losses;
    const real w = 1 / real(unit_of(q.s)), roll = std::fabs(q.s.wZ) / w;
    const moment y(q.p, q.y);
    const real IX = y.IX / y.m, IZ = y.IZ / y.m;
    const losses l(by, q.p, y.M, y.a, 1 / w);
    double reached = 0;
    if (!(roll > 1e-3L) || by.dry + by.rolling + by.viscous + by.layer +
                                   by.gap + by.angular + by.damping ==
                               0)
        return false;
    if (is_body ? !q.roll() ||
                      q.move(&q.b, double(INFINITY), 0, &reached) != COIN_RESTS
                : coin_settle(&q.b.s, &q.p, &by, double(INFINITY), q.s.tol,
                              &reached) != COIN_RESTS)
        return false;
    const coin_state &at = q.b.s;
    const straight all(l, IX, IZ, roll, ROLLS);
    const real error = q.s.tol * (1 + all.time) +
                       q.u * (90 + 90 * all.time + 16 * all.path),
               when = reached * w;
    const real most = ROLLS + error, least = ROLLS - error;
    const real path = q.s.wZ < 0 ? -all.path : all.path;
    const real size =
        q.u * 16 *
        (1 + std::fabs(y.x / y.a) + std::fabs(y.z / y.a) + std::fabs(y.psi));
    q.is(most < roll && when < straight(l, IX, IZ, roll, most).time ? BROKEN
                                                                    : 0);
    q.is(least > 0 && when > straight(l, IX, IZ, roll, least).time ? BROKEN
                                                                   : 0);
    q.is(at.theta == 0 && at.wX == 0 && at.wY == 0 && at.wZ == 0 &&
                 at.phi == q.y.phi
             ? 0
             : BROKEN);
    q.hold(at.psi, y.psi + path, error + size);
    q.hold(at.x / y.a, y.x / y.a - path * y.cph, error + size);
    q.hold(at.z / y.a, y.z / y.a + path * y.sph, error + size);
    return true;
}

/* ------------------------------------------------------------------- edges */

/* Any velocity of the centre and friction, for longer than a slip takes. */
void slides(scene *s, const double *g)
{
    near_pose(s, g);
    s->t = 8 * unit_of(*s);
    s->tol = power_of_ten(g[TOL], -11.95, -2.05);
    s->above = s->which = 0;
    s->mu_static = 1.1 * s->mu_kinetic;
}

/* The friction coefficient; a large one also of coins so slow that they fall,
 * bounce near flat and lift off. */
void until_it_slips(scene *s, const double *g)
{
    horizon(s, g, -2, 1.8);
    s->tol = 1e-12;
    s->which = 0;
    s->mu_static = power_of_ten(g[TABLE], -2, 2);
    s->mu_kinetic = std::min(s->mu_static, 0.1);
    if (g[TABLE] < 0.7)
        return;
    const double w = 1 / unit_of(*s);
    s->mu_static = power_of_ten(g[TABLE], -28, 12);
    s->theta = 2 * g[LEANS + 1] - 1;
    s->wX = w * (2 * g[RATES + 1] - 1);
    s->wY = w * (g[RATES + 2] - 0.5) * (g[RATES + 5] < 0.5);
    s->wZ = w * (g[RATES + 3] - 0.5) * (g[RATES + 6] < 0.5);
}

/* Coins that hardly spin, with losses from 1e-3 on, lying flat from 1e-4 to
 * 1e-2 rad on, so that most rest soon. */
void falls(scene *s, const double *g)
{
    horizon(s, g, -2, 1.5);
    s->which = 512 + std::floor(1 + 127 * g[MORE]);
    for (int i = 0; i < 4; ++i)
        s->loss[i] = power_of_ten(g[LOSS + 1 + i], -3, -0.5);
    s->wY *= power_of_ten(g[MORE + 1], -6, 0);
    s->wZ *= power_of_ten(g[MORE + 2], -6, 0);
}

/* On its edge, rolling straight on; losses from 1e-3 on. */
void upright(scene *s, const double *g)
{
    near_pose(s, g);
    s->theta = s->wX = s->wY = 0;
    s->wZ = (g[MORE + 1] < 0.5 ? 1 : -1) * power_of_ten(g[MORE + 2], -3, 1) /
            unit_of(*s);
    s->tol = power_of_ten(g[TOL], -11.95, -2.05);
    s->which = std::floor(512 * g[MORE]);
    for (int i = 0; i < 4; ++i)
        s->loss[i] = power_of_ten(g[LOSS + 1 + i], -3, -0.5);
    s->mu_static = double(INFINITY);
}

const char *const STANDS = "tol (1 + natural time), of the roll and the path";
const char *const WHEN = "tol (1 + natural time) over the rate; before "
                         "amplification";
} // namespace

const std::vector<row> EVENTS = {
    {"coin_move_begins", WHEN, 10, slides, judged(begins)},
    {"coin_move_ends", WHEN, 100, slides, judged(ends)},
    {"coin_move_lifts", WHEN, 25, slides, judged(lifts)},
    {"coin_move_until", "F/N over mu by 1e-4 of mu", 10, until_it_slips,
     judged(until)},
    {"coin_settle_stands", STANDS, 100, upright, judged(stands<false>)},
    {"coin_move_stands", STANDS, 100, upright, judged(stands<true>)},
    {"coin_time_to_rest", "2 tol a radius of speed, of the fall; tol = 1e-6",
     1000, falls, judged(time_to_rest)},
};
