/* SPDX-License-Identifier: MIT */
/* What follows a coin that rolls: one call, many short calls, orbits.  What a
 * call returns has to mean to the next what its status says. */
#include "body.hpp"
#include "motion.hpp"

namespace
{
/* What a mover may err by: 2 tol a radius of speed, and rounding in parts of a
 * natural time. */
template <class R> R allowed(const motion<R> &from, R t, R tol, R rounding)
{
    return 2 * tol * (1 + from.turned(t)) +
           rounding * (1 + magnitude(t) * from.w) +
           16 * R(doubles::u) * from.largest_of_pose();
}

/* ----------------------------------------------------------------- one call */

template <class T, class R> bool advance(trial<T, R> &q)
{
    const scene &s = q.s;
    coin_state end = q.y;
    motion<R> truth(q.p, q.y);
    const R t = s.t;
    if (truth.is_long(t) ||
        coin_advance(&end, &q.p, s.t, s.tol, nullptr) != COIN_OK)
        return false;
    const R turned = truth.turned(t), natural = magnitude(t) * truth.w;
    if (!truth.follow(t))
        return false;
    const R bound = 2 * R(s.tol) * (1 + turned) + R(1e-15) * natural +
                    16 * q.u * truth.largest_of_pose();
    q.is(unamplified(ratio_of(truth.off(end), bound), q.enough, {q.p, q.y},
                     s.t / 16, 16));
    return bound < 1;
}

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

/* --------------------------------------------------------- many short calls */

enum mover { ADVANCE, SETTLE, MOVE };

struct calls : given {
    int count;
    double dt;
    coin_losses l;

    calls(const scene &s, int kind)
        : given(s, s.tol), count(int(s.steps)), dt(s.t)
    {
        scene of = s;
        of.steps = kind == ADVANCE ? 0 : s.q[3];
        std::fill(of.q, of.q + 4, s.q[2]);
        l = table.losses = losses_of(of);
        table.mu_static = s.q[1];
        table.mu_kinetic = s.q[0];
    }
    int32_t call(int kind)
    {
        return kind == ADVANCE  ? coin_advance(&b.s, &p, dt, tol, nullptr)
               : kind == SETTLE ? coin_settle(&b.s, &p, &l, dt, tol, nullptr)
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
    const bool may_slip = q.kind == MOVE;
    const R dt = c.dt, t = c.count * dt, mu = c.table.mu_static;
    motion<R> truth(c.p, c.b.s);
    motion<long double> start(c.p, c.b.s);
    const R natural = t * truth.w, turned = truth.turned(t);
    if (q.kind != ADVANCE) {
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
    const R bound = 2 * R(q.s.tol) * (1 + turned) +
                    q.u * (90 * (1 + natural) + 16 * truth.largest_of_pose() +
                           8 * c.count / least);
    const double sixteenth = double(t) / 16;
    if (bound >= 1)
        return false;
    for (int i = 0; i < c.count; ++i) {
        const int32_t status = c.call(q.kind);
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

/* ------------------------------------------------------------------ orbits */

/* As follow(), for a time of up to so many times what follow() takes. */
template <class R> bool follow_in_pieces(motion<R> *now, R t)
{
    constexpr int MOST_PIECES = 4;
    const R turn = magnitude(t * now->w) * now->fastest();
    const R pieces = 1 + 2 * turn / motion<R>::MOST_TURN;
    if (!(pieces < MOST_PIECES))
        return false;
    for (int k = 0, n = int(pieces); k < n; ++k)
        if (!now->follow(t / n))
            return false;
    return true;
}

/* From `guess` on to the time at which lean and rates are again those of begin,
 * by Newton's rule along the motion; 0 if that is not found. */
template <class R>
R period_of(const motion<R> &begin, R guess, motion<R> *whole)
{
    const R W = begin.fastest(), X = begin.at(begin.WX) / W,
            P = begin.slopes()[begin.WX] / (W * W);
    R period = 0, step = guess, before;
    *whole = begin;
    do {
        before = magnitude(step);
        if (!follow_in_pieces(whole, step))
            return 0;
        period += step;
        const R speed = (whole->at(begin.WX) - begin.at(begin.WX)) / W;
        step = -(whole->lean_apart(begin) * X + speed * P) /
               ((X * X + P * P) * W * begin.w);
    } while (magnitude(step) < before / 2);
    R off = magnitude(whole->lean_apart(begin)) / begin.at(begin.C);
    for (int i = begin.WX; i <= begin.WZ; ++i)
        off = larger(off, magnitude(whole->at(i) - begin.at(i)) / W);
    return off < 1024 * precision<R> &&
                   magnitude(period - guess) < magnitude(guess) / 2
               ? period
               : R(0);
}

/* As follow(), for any time: lean and rates of a swing return after a period,
 * and each period turns and moves the coin as the one before.  The guess is of
 * a period. */
template <class R> bool follow_far(motion<R> *now, R t, R guess)
{
    if (!now->is_long(t))
        return now->follow(t);
    motion<R> whole = *now;
    const R period = period_of(*now, t < 0 ? -guess : guess, &whole);
    const R times = period == 0 ? R(0) : whole_part(t / period);
    if (times == 0 || !follow_in_pieces(now, t - times * period))
        return false;
    now->repeat(whole, times);
    return true;
}

/* What the residue of a steady motion, up to 8 u of its terms, does to the
 * lean, and to the heading in a natural time. */
template <class R> R residue_of(const moment<R> &y, R W, R time)
{
    const R L = magnitude(lambda2_of(y).value);
    const R lean = 16 * R(doubles::u) * larger(dwX_of(y).size, L) / L;
    return lean * (1 + 4 * W * time / y.c);
}

/* What is added to the error of the place for each period that an orbit repeats
 * with nearly the heading of the last, in radii: `sum` is the error of angles.
 */
double drift_of(const coin_orbit &o, double sum, double turn)
{
    const double b =
        std::fabs(std::remainder(o.heading_per_period, 6.283185307179586));
    const double swing = (o.theta_max - o.theta_min) * turn;
    return o.period > 0 ? std::fmin(sum / b, swing) : 0;
}

/* A state that an orbit tells of a time t, over the law of coin_orbit_at(): an
 * error e in the angles is one of e (1 + radius_max/a) radii in the place and
 * of e W in the rates.  `far` is that radius, or less than 0 to leave out the
 * place. */
template <class T, class R>
bool told(trial<T, R> &q, const coin_orbit &o, double t, const coin_state &out,
          R far)
{
    motion<R> truth(q.p, q.y);
    const bool is_far = truth.is_long(R(t));
    if (!follow_far(&truth, R(t), R(o.period)))
        return false;
    const double periods = o.period > 0 ? std::fabs(t) / o.period : 0;
    const double time = (std::fabs(t) + o.period) * double(truth.w);
    R W = truth.most_W;
    const R residue = o.period > 0 ? R(0) : residue_of(q.at, W, R(time));
    double amplified = 0;
    const auto ratio = [&] {
        const double bound = 1e-14 + 1e-15 * o.conditioning * periods +
                             4 * doubles::u * double(W) * time +
                             double(residue) + amplified;
        const double turn = double(W) * std::fabs(t) * double(truth.w);
        const R wide = 1 + far + R(drift_of(o, bound, turn) / bound);
        R off[8], worst = 0;
        truth.apart(out, W, off);
        for (int i = 0; i < 8; ++i)
            if (i < 3 || i > 4)
                worst = larger(worst, magnitude(off[i]));
            else if (far >= 0)
                worst = larger(worst, magnitude(off[i]) / wide);
        return bound < 1 ? ratio_of(worst, R(bound)) : NO_CLAIM;
    };
    if (ratio() > UNAMPLIFIED) {
        motion<R> ahead = truth;
        ahead.follow(R(o.period));
        W = ahead.most_W;
    }
    if (ratio() > larger(q.enough, UNAMPLIFIED))
        amplified = 4 * doubles::u * (is_far ? 1 + periods : 1) *
                    growth({q.p, q.y}, (is_far ? o.period : t) / 16, 16, 1e30);
    return q.is(ratio());
}

/* The orbit of a scene; its period is 0 where there is none. */
template <class T, class R>
const coin_orbit &orbit_of(const trial<T, R> &q, bool is_far)
{
    static coin_orbit o;
    if (motion<long double>(q.p, q.y).is_long(q.s.t) != is_far ||
        coin_orbit_init(&o, &q.y, &q.p) != COIN_OK)
        o = coin_orbit();
    return o;
}

enum { NEAR, FAR };

/* At times that are followed, or farther. */
template <class T, class R> bool orbit(trial<T, R> &q)
{
    const coin_orbit &o = orbit_of(q, q.kind == FAR);
    coin_state out;
    if ((q.kind == FAR && !(o.period > 0)) ||
        coin_orbit_at(&o, q.s.t, &out) != COIN_OK)
        return false;
    const R far = o.radius_max > 0 ? R(o.radius_max) / q.s.a : R(0);
    return told(q, o, q.s.t, out, far);
}

/* After a period lean and rates are those of the start, and heading and roll
 * have gained what the orbit states. */
template <class T, class R> bool orbit_init(trial<T, R> &q)
{
    const coin_orbit &o = orbit_of(q, false);
    coin_state out = q.y;
    out.phi += o.heading_per_period;
    out.psi += o.roll_per_period;
    return o.period > 0 && told(q, o, o.period, out, R(-1));
}

/* ------------------------------------------------------------------- edges */

/* The pose of order one, and a horizon of 0.01 to 60 natural units. */
void horizon(scene *s, const double *g, int)
{
    const double unit = std::sqrt(s->a / s->g);
    const double part = g[22] < 0.5 ? 2 * g[22] : 2 * g[22] - 1;
    s->t = unit * (g[22] < 0.5 ? 1 : -1) * std::pow(10, 3.8 * part - 2);
    near_pose(s, g);
}

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

/* A horizon, and most beside a steady circle: the leans and rolls between which
 * some are unstable.  Far: times of up to 1e6 natural units. */
void about_circles(scene *s, const double *g, int kind)
{
    horizon(s, g, 0);
    s->tol = std::pow(10, 6 * g[24] - 7);
    const double m = s->M * s->a * s->a, K = s->IZ + m,
                 Mga = s->M * s->g * s->a;
    const double w = std::sqrt(s->g / s->a);
    if (g[28] <= 0.7) {
        s->t = (g[22] < 0.5 ? 70 : -70) * g[23] / w;
        s->theta = 0.01 + 0.4 * g[8];
        s->wX = w * (g[29] < 0.5 ? 0 : std::pow(10, -16 * g[30]));
        s->wZ = w * 0.7 * g[9];
        const double sth = std::sin(s->theta), T = std::tan(s->theta);
        const double b = K * s->wZ;
        s->wY =
            2 * Mga * sth / (b + std::sqrt(b * b + 4 * s->IX * Mga * sth * T));
        if (g[31] > 0.5)
            s->wY *= 1 + std::pow(10, -17 * g[27]);
    }
    if (kind == FAR)
        s->t = (g[22] < 0.5 ? 1 : -1) * std::pow(10, 7 * g[23] - 1) *
               std::sqrt(s->a / s->g);
}

#define ROLLING(name, bound, share, edge, kind, law)                           \
    LAW(doubles, "coin_" name, bound, share, edge, kind, law)
} // namespace

std::vector<row> rolling_motions()
{
    const char *moved = "2 tol a radius of speed + rounding";
    return {
        ROLLING("advance", moved, 10, horizon, 0, advance),
        ROLLING("move_until", "F/N over mu by 1e-4 of mu", 10, until_it_slips,
                0, until),
        ROLLING("orbit_at",
                "1e-14 + 1e-15 conditioning a period + 4 u W (abs(t) + "
                "period) + 4 u amplified",
                20, about_circles, NEAR, orbit),
        ROLLING("orbit_at_far", "the same; up to 1e6 units", 20, about_circles,
                FAR, orbit),
        ROLLING("orbit_init",
                "lean; rates; heading and roll after a period as coin_orbit_at",
                20, about_circles, NEAR, orbit_init),
        ROLLING("advance_calls", moved, 50, short_calls, ADVANCE, rolls),
        ROLLING("settle_calls", moved, 50, short_calls, SETTLE, rolls),
        ROLLING("move_calls",
                "2 tol a radius of speed + rounding; rolls where the truth "
                "does",
                50, short_calls, MOVE, rolls),
    };
}
