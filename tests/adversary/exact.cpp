/* SPDX-License-Identifier: MIT */
/* Motion without steps: steady motions, what is in closed form about them, and
 * orbits. */
#include "motion.hpp"

namespace
{
/* wY of a circle, (40): the root that nothing cancels in, and the product of
 * the two. */
template <class R> void roots_of(const moment<R> &y, R *large, R *slow)
{
    const R b = y.K * y.wZ, c = y.IX * y.T, d = y.Mga * y.s;
    const R root2 = root(b * b + 4 * c * d);
    const R q = -(b + (b < 0 ? -root2 : root2)) / 2;
    *large = q / c;
    *slow = -d / q;
}

template <class T, class R> bool spin(trial<T, R> &q)
{
    coin_state made;
    if (coin_steady_spin(&made, &q.p, q.s.theta) != COIN_OK)
        return false;
    const moment<R> &y = q.made(made).at;
    q.near(made.wY, root(y.Mga * y.c / y.IX), 8); /* (42) */
    q.equal(made.theta == q.s.theta && made.wX == 0 && made.wZ == 0);
    return true;
}

template <class T, class R> bool circle(trial<T, R> &q)
{
    coin_state made;
    R large, slow;
    const scene &s = q.s;
    const int branch = s.method < 2 ? -1 : 1;
    if (coin_steady_circle(&made, &q.p, s.theta, s.wZ, branch) != COIN_OK)
        return false;
    roots_of(q.made(made).at, &large, &slow);
    q.near(made.wY, (branch < 0) == (s.wZ >= 0) ? large : slow, 8);
    q.equal(made.theta == s.theta && made.wX == 0 && made.wZ == s.wZ);
    return true;
}

/* (93), of a circle of any size. */
template <class T, class R> bool turn(trial<T, R> &q)
{
    const double radius = q.s.a * std::fabs(q.s.q[0] / q.s.q[1]);
    coin_state made;
    if (coin_steady_turn(&made, &q.p, q.s.theta, radius) != COIN_OK)
        return false;
    const moment<R> &y = q.made(made).at;
    const R sth = magnitude(y.s), r = R(radius) / y.a;
    const R wY = root(y.Mga * sth * y.c / (y.K * r + y.IX * sth));
    q.near(made.wY, wY, 8);
    q.near(std::fabs(made.wZ), wY / y.c * r, 8);
    q.equal(made.theta == q.s.theta && made.wX == 0 &&
            made.wZ * made.theta >= 0);
    return true;
}

/* Speed, radius, and (39). */
template <class T, class R> bool ride(trial<T, R> &q)
{
    const scene &s = q.s;
    const double radius = s.a * std::fabs(s.q[0] / s.q[1]);
    const double speed = std::sqrt(s.g * s.a) * std::fabs(s.q[2] / s.q[3]);
    coin_state made;
    if (coin_steady_ride(&made, &q.p, speed, radius) != COIN_OK)
        return false;
    const moment<R> &y = q.made(made).at;
    const R u = q.u, G = y.a * y.wZ * y.c / y.wY;
    const R roll = y.K * y.wZ * y.wY, tilt = y.IX * y.wY * y.wY * y.T;
    q.hold(y.a * y.wZ, R(speed), (16 * u + u / y.c) * R(speed));
    q.hold(G, R(radius), 16 * u * R(radius));
    q.hold(roll + tilt, y.Mga * y.s, 24 * u * y.Mga * y.s);
    q.equal(made.wX == 0 && made.wY > 0 && made.theta > 0);
    return true;
}

/* A steady state to rounding, or off by up to 1e-9. */
void steady_edge(scene *s, const double *g, int)
{
    double large, slow;
    near_pose(s, g);
    s->wX = 0;
    if (g[28] < 0.15) {
        s->theta = 0;
        *(g[28] < 0.07 ? &s->wY : &s->wZ) = 0;
    } else if (g[28] < 0.3) {
        s->wZ = 0;
        s->wY = std::sqrt(s->M * s->g * s->a * std::cos(s->theta) / s->IX);
    } else {
        circles_of(*s, &large, &slow);
        s->wY = g[28] < 0.7 ? slow : large;
    }
    if (g[29] < 0.5)
        s->wY *= 1 + 1e-9 * s->q[0];
    s->t = std::sqrt(s->a / s->g) * (g[22] < 0.5 ? 1 : -1) *
           std::pow(10, 8 * g[23] - 2);
}

template <class T, class R> bool radii(trial<T, R> &q)
{
    const moment<R> &y = q.at;
    double center, contact;
    if (coin_steady_radii(&q.y, &q.p, &center, &contact) != COIN_OK ||
        q.y.wY == 0)
        return false;
    const R G = y.a * magnitude(y.wZ * y.c / y.wY);       /* (43) */
    const R C = y.a * magnitude(y.wZ * y.c / y.wY + y.s); /* (43) */
    if (G < R(DBL_MAX)) {
        q.hold(R(center), G, 8 * (q.u * G + q.least));
        q.hold(R(contact), C, 8 * (q.u * (G + y.a * magnitude(y.s)) + q.least));
    }
    return true;
}

template <class T, class R> bool stability(trial<T, R> &q)
{
    double lambda2;
    if (coin_stability(&q.y, &q.p, &lambda2) != COIN_OK)
        return false;
    q.hold(lambda2, lambda2_of(q.at), 16);
    return true;
}

template <class T, class R> bool critical(trial<T, R> &q)
{
    const moment<R> &y = q.at;
    if (coin_params_check(&q.p) != COIN_OK)
        return false;
    q.near(coin_critical_roll(&q.p), root(y.Mga * y.IX / y.IZ / y.K),
           8);                                              /* (45) */
    q.near(coin_critical_spin(&q.p), root(y.Mga / y.J), 8); /* (46) */
    return true;
}

/* (56) */
template <class T, class R> bool steady_at(trial<T, R> &q)
{
    const moment<R> &y = q.at;
    coin_state out;
    if (coin_steady_at(&q.y, &q.p, q.s.t, &out) != COIN_OK)
        return false;
    const R t = q.s.t, turn = y.wY / y.c * t, h = turn / 2;
    const R chord = -y.a * y.wZ * t * (h == 0 ? R(1) : sine(h) / h);
    const R rolled = (magnitude(y.wZ) + magnitude(y.wY * y.T)) * magnitude(t);
    const R path = y.a * magnitude(y.wZ * t);
    /* 6 u of what changes, and half a unit of what comes out */
    const auto holds = [&](double is, R want, R change) {
        q.hold(R(is), want, q.u * (6 * change + magnitude(want)));
    };
    holds(out.phi, y.phi + turn, magnitude(turn));
    holds(out.psi, y.psi + (y.wZ + y.wY * y.T) * t, rolled);
    holds(out.x, y.x + chord * cosine(y.phi + h), path);
    holds(out.z, y.z - chord * sine(y.phi + h), path);
    q.equal(out.theta == q.y.theta && out.wX == 0);
    return true;
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

/* A horizon, and most beside a steady circle: the leans and rolls between which
 * some are unstable.  Far: times of up to 1e6 natural units. */
void about_circles(scene *s, const double *g, int kind)
{
    horizon(s, g, 0);
    s->tol = std::pow(10, 6 * g[24] - 7);
    const double w = std::sqrt(s->g / s->a);
    double large, slow;
    if (g[28] <= 0.7) {
        s->t = (g[22] < 0.5 ? 70 : -70) * g[23] / w;
        s->theta = 0.01 + 0.4 * g[8];
        s->wX = w * (g[29] < 0.5 ? 0 : std::pow(10, -16 * g[30]));
        s->wZ = w * 0.7 * g[9];
        circles_of(*s, &large, &slow);
        s->wY = slow;
        if (g[31] > 0.5)
            s->wY *= 1 + std::pow(10, -17 * g[27]);
    }
    if (kind == FAR)
        s->t = (g[22] < 0.5 ? 1 : -1) * std::pow(10, 7 * g[23] - 1) *
               std::sqrt(s->a / s->g);
}

} // namespace

std::vector<row> exact_motions()
{
    return {
        ROW("steady_spin", "8 u", 1, nullptr, 0, spin),
        ROW("steady_circle", "8 u", 1, nullptr, 0, circle),
        ROW("steady_turn", "8 u", 1, nullptr, 0, turn),
        ROW("steady_ride",
            "16 u + u/cos theta of the speed; 16 u of the radius", 1, nullptr,
            0, ride),
        ROW("steady_radii", "8 u of the terms", 1, steady_edge, 0, radii),
        ROW("stability", "16 u of the terms", 1, steady_edge, 0, stability),
        ROW("critical_roll_and_spin", "8 u", 1, nullptr, 0, critical),
        ROW("orbit_at",
            "1e-14 + 1e-15 conditioning a period + 4 u W (abs(t) + "
            "period) + 4 u amplified",
            20, about_circles, NEAR, orbit),
        ROW("orbit_at_far", "the same; up to 1e6 units", 20, about_circles, FAR,
            orbit),
        ROW("orbit_init",
            "lean; rates; heading and roll after a period as coin_orbit_at", 20,
            about_circles, NEAR, orbit_init),
        ROW("steady_at", "6 u of the angles and path", 1, steady_edge, 0,
            steady_at),
    };
}
