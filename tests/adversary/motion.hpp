/* SPDX-License-Identifier: MIT */
/* The true motion of a coin that rolls or slips: the equations of
 * docs/physics.md in angles, rates and time, each step to the precision of R.
 * Natural units: M = a = g = 1. */
#ifndef ROLLCOIN_ADVERSARY_MOTION_HPP
#define ROLLCOIN_ADVERSARY_MOTION_HPP

#include "losses.hpp"
#include "midpoint.hpp"
#include "row.hpp"

#include <cstdint>
#include <utility>

template <class R> class motion
{
  public:
    /* The lean, whose sine and cosine are sharp near flat too; what phi, psi,
     * x, z have changed by; the rates; of a coin that slips the velocity of its
     * centre along e_X and e_h; sines and cosines of lean and heading. */
    enum { LEAN, PHI, PSI, PX, PZ, WX, WY, WZ, VX, VH, S, C, SPH, CPH, SIZE };
    using vector = std::array<R, SIZE>;

    /* What became of it: it goes on, it has all but stopped to slip, it lifts
     * off, or that is too costly to tell, or it falls flat. */
    enum fate { GOES, STOPS, LIFTS, UNKNOWN };

    static constexpr int MOST_TURN = 80; /* radians: what a truth costs */

    R IX, IZ;
    R a, w;       /* the radius, natural units of rate in the coin's own */
    R most_W = 0; /* the largest W where a step began */
    R took = 0;   /* what go() followed, in natural units */
    double none = NONE<R>;

    template <class P, class S_> motion(const P &p, const S_ &s)
    {
        const R m = R(p.mass) * p.radius * p.radius;
        IX = p.inertia_X / m;
        IZ = p.inertia_Z / m;
        a = p.radius;
        w = root(R(p.gravity) / a);
        pose0 = {R(s.phi), R(s.psi), R(s.x) / a, R(s.z) / a};
        y = {R(s.theta), 0, 0, 0, 0, R(s.wX) / w, R(s.wY) / w, R(s.wZ) / w};
        y[S] = sine(R(s.theta));
        y[C] = cosine(R(s.theta));
        look();
    }

    /* A body that slips, with a coefficient of friction. */
    motion(const coin_params &p, const coin_body &b, double friction)
        : motion(p, b.s)
    {
        const R vx = R(b.vx) / (a * w), vz = R(b.vz) / (a * w);
        slips = true;
        mu = friction;
        y[VX] = vx * y[CPH] - vz * y[SPH];
        y[VH] = vx * y[SPH] + vz * y[CPH];
    }

    void slow_by(const coin_losses &l, const coin_params &p)
    {
        slow = losses<R>(l, softening(l, p), p.mass, p.radius, 1 / w);
        lossy = true;
    }

    R at(int i) const
    {
        return y[size_t(i)];
    }
    R lean_apart(const motion &o) const
    {
        return y[S] * o.y[C] - y[C] * o.y[S];
    }

    /* W of (47). */
    R fastest() const
    {
        return root((y[WX] * y[WX] + y[WY] * y[WY]) / (y[C] * y[C]) +
                    y[WZ] * y[WZ] + 1 / y[C]);
    }

    /* Energy of rolling over M a^2 g/a. */
    R energy() const
    {
        return ((1 + IX) * y[WX] * y[WX] + IX * y[WY] * y[WY] +
                (1 + IZ) * y[WZ] * y[WZ]) /
                   2 +
               y[C];
    }
    /* The radians that a disc's rates and fall may make in a time. */
    R turned(R t) const
    {
        return magnitude(t) * w * root(2 * energy());
    }

    /* The largest of 1, the angles and the place in radii. */
    R largest_of_pose() const
    {
        R most = 1;
        for (size_t i = 0; i < 4; ++i)
            most = larger(most, magnitude(pose0[i] + y[PHI + i]));
        return most;
    }

    /* How far a state is from here: members in radians, radii and parts of a
     * rate w1. */
    template <class S_> void apart(const S_ &s, R w1, R off[8]) const
    {
        const double is[] = {s.phi, s.psi, s.x, s.z, s.wX, s.wY, s.wZ};
        off[0] = R(s.theta) - y[LEAN];
        for (size_t i = 0; i < 4; ++i)
            off[1 + i] = R(is[i]) / (i < 2 ? R(1) : a) - pose0[i] - y[PHI + i];
        for (size_t i = 4; i < 7; ++i)
            off[1 + i] = (R(is[i]) / w - y[PHI + i]) / w1;
    }
    /* The largest of the first of them. */
    template <class S_> R off(const S_ &s, int members = 5) const
    {
        R each[8], worst = 0;
        apart(s, fastest(), each);
        for (int i = 0; i < members; ++i)
            worst = larger(worst, magnitude(each[i]));
        return worst;
    }
    R off(const coin_body &b) const
    {
        const R vx = R(b.vx) / (a * w), vz = R(b.vz) / (a * w);
        return larger(off(b.s, 8),
                      larger(magnitude(vx * y[CPH] - vz * y[SPH] - y[VX]),
                             magnitude(vx * y[SPH] + vz * y[CPH] - y[VH])) /
                          fastest());
    }
    R off(const motion &o) const
    {
        R worst = magnitude(lean_apart(o));
        for (size_t i = PHI; i <= VH; ++i)
            worst = larger(worst, magnitude(y[i] - o.y[i]) /
                                      (i < WX ? R(1) : fastest()));
        return worst;
    }

    /* ------------------------------------------------------------- its way */
    /* Whether a truth would cost too much. */
    bool is_long(R t) const
    {
        return !(magnitude(t * w) * fastest() <= R(MOST_TURN));
    }

    /* Follows the motion; false if it does not go on, or takes too long. */
    bool follow(R t)
    {
        return (slips || !is_long(t)) && go(t) == GOES;
    }

    /* Follows it for a time, or until friction has slowed a slip to `least`, or
     * it lifts off.  Steps of a slip are short where the normal force is small;
     * where that has a minimum near 0, it is unknown whether the coin lifts
     * off. */
    fate go(R t, R least = R(1e-3))
    {
        R left = t * w, last = 1, before = 1;
        if (slips) {
            last = pressed();
            before = last - lightening();
        }
        took = 0;
        for (int steps = 0; left != 0; ++steps) {
            const motion from = *this;
            const R fast = rate();
            R h = R(slips && last < R(0.5) ? 0.1 : REACH) / fast;
            h = magnitude(left) < h ? left : left < 0 ? -h : h;
            if (steps > (slips ? MOST_SLIPPED : int(2 * MOST_TURN / REACH)) ||
                (slips && !(fast * lesser(R(1), 100 * speed()) < 1e3)) ||
                !stride(&h))
                return UNKNOWN;
            if (slips) {
                const R now = pressed();
                if (last < before && last < now && last < R(0.05))
                    return UNKNOWN;
                if (!(now > 0)) {
                    took += cross(from, h, [](const motion &m) {
                        return m.pressed() > 0;
                    });
                    return LIFTS;
                }
                before = last;
                last = now;
            }
            left -= h;
            took += h;
            if (slips && mu > 0 && speed() < least)
                return STOPS;
        }
        return GOES;
    }

    /* To where `holds` ends within a step from a motion; how long that is. */
    template <class F> R cross(const motion &from, R step, const F &holds)
    {
        R low = 0, high = step;
        for (int i = 0; i < 60; ++i) {
            const R middle = (low + high) / 2;
            *this = from;
            (pass(middle) && holds(*this) ? low : high) = middle;
        }
        return high;
    }

    /* One of y, off by so much. */
    void nudge(int i, R size)
    {
        const R s = sine(size), c = cosine(size), from = y[S];
        y[size_t(i)] += size;
        if (i == LEAN) {
            y[S] = from * c + y[C] * s;
            y[C] = y[C] * c - from * s;
        }
        look();
    }
    /* What drives it, and how large errors of it count: where it rolls, as
     * those of cos theta. */
    static constexpr int DRIVES[] = {LEAN, WX, WY, WZ, VX, VH};
    int drives() const
    {
        return slips ? 6 : 4;
    }
    R unit(int i) const
    {
        return (slips ? R(1) : y[C]) * (i == LEAN ? R(1) : fastest());
    }

    /* How much errors change a function of the motion. */
    template <class F> R moves(const F &function) const
    {
        const R size = R(1e-7);
        R sum = 1;
        for (int k = 0; k < drives(); ++k) {
            motion other = *this;
            other.nudge(DRIVES[k], size * (slips ? R(1) : unit(DRIVES[k])));
            sum += magnitude(function(other) - function(*this)) / size;
        }
        return sum;
    }
    /* Its slope in natural time. */
    template <class F> R slope_of(const F &function) const
    {
        R h = R(1e-6);
        motion later = *this;
        return later.stride(&h) ? (function(later) - function(*this)) / h
                                : R(0);
    }

    /* Puts so many periods before the way since the start.  Each turns the next
     * by its heading. */
    void repeat(const motion &period, R times)
    {
        const R h = period.y[PHI] / 2, all = times * h, lag = all - h;
        const R sum = sine(h) == 0 ? times : sine(all) / sine(h);
        const R c1 = cosine(lag) * sum, s1 = sine(lag) * sum;
        const R c2 = cosine(2 * all), s2 = sine(2 * all);
        const R x = y[PX], z = y[PZ], px = period.y[PX], pz = period.y[PZ];
        y[PX] = px * c1 + pz * s1 + x * c2 + z * s2;
        y[PZ] = pz * c1 - px * s1 + z * c2 - x * s2;
        y[PHI] += times * period.y[PHI];
        y[PSI] += times * period.y[PSI];
        look();
    }

    /* -------------------------------------------------------------- forces */
    vector slopes() const
    {
        vector d;
        rates(vector(), d);
        return d;
    }

    /* The slip's speed, and its slope. */
    R speed() const
    {
        const R X = y[VX] + y[WZ], h = y[VH] - y[WX] * y[C];
        return root(X * X + h * h);
    }
    R speed_slope() const
    {
        const vector d = slopes();
        const R X = y[VX] + y[WZ], h = y[VH] - y[WX] * y[C];
        return (X * (d[VX] + d[WZ]) +
                h * (d[VH] - d[WX] * y[C] + y[WX] * y[S] * y[WX])) /
               speed();
    }

    /* The normal force on a coin that slips, and its slope. */
    R pressed() const
    {
        vector d;
        return rates(vector(), d);
    }
    R lightening() const
    {
        return slope_of([](const motion &m) { return m.pressed(); });
    }

    /* The normal force and the friction of a contact without slip. */
    void stuck(R *N, R *F) const
    {
        motion rolls = *this;
        rolls.slips = false;
        const vector d = rolls.slopes();
        const R X = y[WX] * y[WY] - d[WZ]; /* (25) */
        const R h = -y[WX] * y[WX] * y[S] + d[WX] * y[C] +
                    y[WY] * y[WZ] / y[C];             /* (26) */
        *N = 1 - y[WX] * y[WX] * y[C] - d[WX] * y[S]; /* (27) */
        *F = root(X * X + h * h);
    }
    /* What is left of the cone of friction of a coin that rolls: mu N - F, over
     * mu where that is above 2. */
    R left(R of) const
    {
        R N, F;
        stuck(&N, &F);
        return of > R(DBL_MAX) ? N : of > 2 ? N - F / of : of * N - F;
    }

  private:
    /* Radians of the fastest rate in a step. */
    static constexpr double REACH = 0.6;
    static constexpr int MOST_SLIPPED = 3000;

    /* A correction that is none in the shortest steps, which pass a kink; so
     * many halvings lead there. */
    static constexpr double KINK = 1e-14;
    static constexpr int HALVINGS = 12;

    vector y;
    std::array<R, 4> pose0; /* phi, psi, x, z at the start */
    bool slips = false, lossy = false;
    R mu = 0;
    losses<R> slow;

    /* The sine and cosine of the heading here; those of the lean stay on their
     * circle. */
    void look()
    {
        const R one = root(y[S] * y[S] + y[C] * y[C]), phi = pose0[0];
        const R st = sine(y[PHI]), ct = cosine(y[PHI]);
        y[S] /= one;
        y[C] /= one;
        y[SPH] = sine(phi) * ct + cosine(phi) * st;
        y[CPH] = cosine(phi) * ct - sine(phi) * st;
    }

    /* The fastest rate of change: W, of a slip also that of its direction and
     * that at which the losses slow the body. */
    R rate() const
    {
        const R W = fastest(), T = y[S] / y[C], roll = rolls();
        if (!slips)
            return W;
        const R turns = mu > 0 ? mu * pressed() * (1 + 1 / IX) / speed() : R(0);
        const R slowed =
            lossy ? slow.grip(roll, y[C]) * (1 / IZ + T * T / IX) +
                        slow.spin * (y[C] * y[C] / IX + y[S] * y[S] / IZ)
                  : R(0);
        return W + turns + slowed;
    }

    /* The rate of roll, and whether friction is not smooth where the contact
     * turns round. */
    R rolls() const
    {
        return y[WZ] + y[WY] * y[S] / y[C];
    }
    bool has_kinks() const
    {
        return lossy && (slow.damping != 0 || slow.layer != 0);
    }

    /* A step, or as many halvings of it as it needs; false if it falls flat.  A
     * step sees no kink beyond its last substep, so that only the shortest may
     * pass one. */
    bool stride(R *h)
    {
        const vector before = y;
        const R roll = rolls();
        most_W = larger(most_W, fastest());
        for (int halvings = 0; halvings <= HALVINGS; ++halvings, *h /= 2) {
            const bool shortest = has_kinks() && halvings == HALVINGS;
            if (step(*h, shortest ? KINK : none) &&
                (shortest || !has_kinks() || rolls() * roll > 0)) {
                look();
                return true;
            }
            y = before;
        }
        return false;
    }

    bool pass(R t)
    {
        for (R h = t; t != 0; t -= h, h = t)
            if (!stride(&h))
                return false;
        return true;
    }

    bool step(R h, double small)
    {
        const R W = fastest(), c = y[C];
        const vector sizes = {c, 1, 1, 1, 1, c * W, c * W, W, W, W, 1, c, 1, 1};
        vector change;
        if (!extrapolated<R, SIZE>(
                [this](const vector &v, vector &d) { rates(v, d); }, sizes, h,
                change, small))
            return false;
        for (size_t i = 0; i < SIZE; ++i)
            y[i] += change[i];
        return y[C] > 0;
    }

    /* The slopes at y + v; of a slip, the normal force. */
    R rates(const vector &v, vector &d) const
    {
        const R s = y[S] + v[S], c = y[C] + v[C], T = s / c;
        const R sph = y[SPH] + v[SPH], cph = y[CPH] + v[CPH];
        const R wX = y[WX] + v[WX], wY = y[WY] + v[WY], wZ = y[WZ] + v[WZ];
        const R turn = wY / c, J = IX + !slips, K = IZ + !slips;
        R ahead = -wZ, across = wX * c, N = 0;
        slowing<R> by;
        if (lossy)
            by = slow.at(IX, IZ, J, K, s, c, wX, wY, wZ);
        d[WX] = -(K * wZ + IX * wY * T) * wY / J + by.wX.value; /* (14) */
        d[WY] = wX * (wY * T + IZ / IX * wZ) + by.wY.value;     /* (15) */
        if (slips) {
            ahead = y[VX] + v[VX];
            across = y[VH] + v[VH];
            const R X = ahead + wZ, h = across - wX * c;
            const R u = mu > 0 ? root(X * X + h * h) : R(1);
            N = (1 - wX * wX * c - s * d[WX]) /
                (1 + s * (s + mu * h / u * c) / IX); /* (80) */
            const R FX = -mu * N * X / u, Fh = -mu * N * h / u;
            d[WX] += (N * s - Fh * c) / IX;
            d[WZ] = FX / IZ + by.wZ.value;
            d[VX] = FX - turn * across;
            d[VH] = Fh + turn * ahead;
        } else {
            d[WX] += s / J;                    /* (14) */
            d[WZ] = wX * wY / K + by.wZ.value; /* (16) */
            d[VX] = d[VH] = 0;
        }
        d[LEAN] = wX;                       /* (17) */
        d[PHI] = turn;                      /* (18) */
        d[PSI] = wZ + wY * T;               /* (19) */
        d[PX] = ahead * cph + across * sph; /* (20) */
        d[PZ] = across * cph - ahead * sph; /* (20) */
        d[S] = wX * c;
        d[C] = -wX * s;
        d[SPH] = turn * cph;
        d[CPH] = -turn * sph;
        return N;
    }

  public:
    /* How much an error here has grown when the motion comes to `end`: errors
     * of what drives it, as an error of a step is, and, of a coin that rolls,
     * of the heading, which turns the way that is left.  Or so much of it that
     * it is enough.  A small error that has become large grew by more than its
     * size shows: about upright the force of a slip changes within leans of
     * root(I_X). */
    double grown(const motion &end, R t, R enough) const
    {
        const R size = R(1e-7), dx = end.y[PX] - y[PX], dz = end.y[PZ] - y[PZ];
        const R far = R(0.1) * (slips ? lesser(R(1), root(IX)) : R(1));
        R sum = 1 + (slips ? R(0) : root(dx * dx + dz * dz));
        for (int k = 0; k < drives() && sum < enough; ++k) {
            R most = 0;
            for (int side = -1; side <= !slips; side += 2) {
                motion other = *this;
                other.nudge(DRIVES[k], -side * size * unit(DRIVES[k]));
                if (!other.follow(t) || end.off(other) > far)
                    return 1e30;
                most = larger(most, end.off(other) / size);
            }
            sum += most;
        }
        return double(sum);
    }
};

/* By how much the motion itself makes an error grow that is made on its way:
 * from the worst of some moments of so many times dt, and that where W is
 * largest.  If that is more than enough, something between the two. */
double growth(motion<long double> now, long double dt, uint64_t times,
              double enough);

/* "Before the motion's own amplification": a ratio without that growth, which
 * is dear, where it matters. */
constexpr double UNAMPLIFIED = 0.3;
double unamplified(double ratio, double enough,
                   const motion<long double> &start, long double dt,
                   uint64_t times);

template <class R> double ratio_of(R error, R bound)
{
    return error <= R(1e30) ? double(error / bound) : BROKEN;
}

#endif
