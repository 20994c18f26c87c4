/* SPDX-License-Identifier: MIT */
/* The true motion: the textbook's equations (14)-(20) in angles and rates, each
 * step to the precision of R.  The quick truth sums power series in time.  The
 * exact one extrapolates the modified midpoint rule (Gragg, Bulirsch, Stoer):
 * what a search finds is confirmed by another method.  Natural units: M = a =
 * g = 1. */
#ifndef ROLLCOIN_ADVERSARY_PATH_HPP
#define ROLLCOIN_ADVERSARY_PATH_HPP

#include "course.hpp"
#include "losses.hpp"
#include "midpoint.hpp"

#include <cstdint>

template <class R> class path
{
  public:
    using vector = std::array<R, 8>; /* lean, phi, psi, x, z, wX, wY, wZ */

    template <class P, class S> path(const P &p, const S &s)
    {
        const R m = R(p.mass) * p.radius * p.radius;
        IX = p.inertia_X / m;
        IZ = p.inertia_Z / m;
        a = p.radius;
        w = root(R(p.gravity) / a);
        pose0 = {R(s.phi), R(s.psi), R(s.x) / a, R(s.z) / a};
        y = {R(s.theta), 0, 0, 0, 0, R(s.wX) / w, R(s.wY) / w, R(s.wZ) / w};
        sphi0 = sine(pose0[0]);
        cphi0 = cosine(pose0[0]);
        rebase(s.theta);
    }

    R a, w;       /* the radius, and natural units of rate in the coin's own */
    R most_W = 0; /* the largest W where a step began */
    const losses<R> *slow = nullptr; /* what slows the coin, or null */

    /* Follows the motion; false if it falls flat or takes too long. */
    bool follow(R t)
    {
        if (is_long(t))
            return false;
        R left = t * w;
        if constexpr (IS_QUICK)
            return by_series(left);
        else
            return by_midpoints(&left, false);
    }

    /* Whether a truth would cost too much. */
    bool is_long(R t) const
    {
        return !(magnitude(t * w) * fastest() <= R(MOST_TURN));
    }

    /* W of (47). */
    R fastest() const
    {
        const R c = cth(y[0]);
        return root((y[5] * y[5] + y[6] * y[6]) / (c * c) + y[7] * y[7] +
                    1 / c);
    }
    R lean() const
    {
        return base * half_pi<R>() + y[0];
    }
    R cos_theta() const
    {
        return cth(y[0]);
    }

    /* The acceleration of the lean. */
    R pull() const
    {
        const R T = sth(y[0]) / cth(y[0]);
        return (sth(y[0]) - ((1 + IZ) * y[7] + IX * y[6] * T) * y[6]) /
               (1 + IX);
    }

    /* Energy over M a^2 g/a. */
    R energy() const
    {
        return ((1 + IX) * y[5] * y[5] + IX * y[6] * y[6] +
                (1 + IZ) * y[7] * y[7]) /
                   2 +
               cth(y[0]);
    }

    /* How far a state is from here: members in radians, radii and parts of a
     * rate w1. */
    template <class S> void apart(const S &s, R w1, R off[8]) const
    {
        const double at[] = {s.phi, s.psi, s.x, s.z, s.wX, s.wY, s.wZ};
        off[0] = base == 0 ? R(s.theta) - y[0] : from_flat(R(s.theta)) - y[0];
        for (int i = 0; i < 4; ++i)
            off[1 + i] = R(at[i]) / (i < 2 ? R(1) : a) - pose0[i] - y[1 + i];
        for (int i = 4; i < 7; ++i)
            off[1 + i] = (R(at[i]) / w - y[1 + i]) / w1;
    }

    /* One of the four that drive, off by this much of what W makes of it. */
    void nudge(int which, R size)
    {
        const R c = cth(y[0]);
        y[which == 0 ? 0 : 4 + which] +=
            size * c * (which == 0 ? 1 : fastest());
        if constexpr (IS_QUICK)
            ahead.known = false;
    }

    /* Puts so many periods before the way since the start.  Each turns the next
     * by its heading. */
    void repeat(const path &period, R times)
    {
        const R h = period.y[1] / 2, all = times * h, lag = all - h;
        const R sum = sine(h) == 0 ? times : sine(all) / sine(h);
        const R before[] = {turned_x(period, lag), turned_z(period, lag)};
        const R after[] = {turned_x(*this, 2 * all), turned_z(*this, 2 * all)};
        y[1] += times * period.y[1];
        y[2] += times * period.y[2];
        y[3] = sum * before[0] + after[0];
        y[4] = sum * before[1] + after[1];
        if constexpr (IS_QUICK)
            ahead.known = false;
    }

    /* Sharp enough to compare motions a ten millionth apart. */
    void be_quick()
    {
        ahead.way.ends = 0x1p-42;
    }

    const vector &at() const
    {
        return y;
    }
    /* The largest of 1, the angles and the place in radii. */
    R largest_of_pose() const
    {
        R most = 1;
        for (int i = 0; i < 4; ++i)
            most = larger(most, magnitude(pose0[i] + y[1 + i]));
        return most;
    }
    R lean_apart(const path &o) const
    {
        return (y[0] - o.y[0]) + (base - o.base) * half_pi<R>();
    }

    static constexpr int MOST_TURN = 80; /* radians: what a truth costs */

  private:
    static constexpr bool IS_QUICK = std::is_same_v<R, long double>;

    /* Radians of the fastest rate in a step; by series, in a unit of time. */
    static constexpr double REACH = 0.3;
    static constexpr int MOST_STEPS = int(2 * MOST_TURN / REACH);

    /* A correction that is none in the shortest steps, which pass a kink. */
    static constexpr double KINK = 1e-14;

    R IX, IZ;
    vector y;
    std::array<R, 4> pose0; /* phi, psi, x, z at the start; y has their changes
                             */
    R sphi0, cphi0, sph0, cph0; /* of the heading: there, and where a step
                                   begins */
    int base = 0; /* y[0] is the lean from base pi/2: sharp near flat too */

    /* The series that y lies on, and where. */
    struct stretch {
        bool known = false;
        R at; /* the time since it began */
        vector from;
        R roll; /* the rate of roll where it began */
        course<8> way;
    };
    struct nothing {
    };
    std::conditional_t<IS_QUICK, stretch, nothing> ahead;

    /* The place of o, had its heading begun larger by so much. */
    static R turned_x(const path &o, R angle)
    {
        return o.y[3] * cosine(angle) + o.y[4] * sine(angle);
    }
    static R turned_z(const path &o, R angle)
    {
        return o.y[4] * cosine(angle) - o.y[3] * sine(angle);
    }

    R from_flat(R theta) const
    {
        const R rest = cosine(half_pi<R>()); /* of pi/2, beyond R */
        return (theta - base * half_pi<R>()) - base * rest;
    }

    void rebase(R theta)
    {
        if (base == 0 && magnitude(theta) > R(0.8)) {
            base = theta < 0 ? -1 : 1;
            y[0] = from_flat(theta);
        } else if (base != 0 && magnitude(theta) < R(0.75)) {
            y[0] = theta;
            base = 0;
        }
    }

    R sth(R e) const
    {
        return base == 0 ? sine(e) : base * cosine(e);
    }
    R cth(R e) const
    {
        return base == 0 ? cosine(e) : -base * sine(e);
    }

    /* At y + v. */
    void rates(const vector &v, vector &d) const
    {
        const R e = y[0] + v[0], s = sth(e), c = cth(e), T = s / c;
        const R st = sine(v[1]), ct = cosine(v[1]);
        const R sph = sph0 * ct + cph0 * st, cph = cph0 * ct - sph0 * st;
        const R wX = y[5] + v[5], wY = y[6] + v[6], wZ = y[7] + v[7];
        d[0] = wX;                       /* (17) */
        d[1] = wY / c;                   /* (18) */
        d[2] = wZ + wY * T;              /* (19) */
        d[3] = -wZ * cph + wX * c * sph; /* (20) */
        d[4] = wZ * sph + wX * c * cph;  /* (20) */
        d[5] = (-(1 + IZ) * wY * wZ - IX * wY * wY * T + s) / (1 + IX);
        d[6] = wX * wY * T + IZ / IX * wX * wZ; /* (15) */
        d[7] = wX * wY / (1 + IZ);              /* (16) */
        if (slow)
            slow->add(IX, IZ, s, c, wX, wY, wZ, &d[5]);
    }

    /* Takes from *left what it follows: all, or until the contact has turned
     * round. */
    bool by_midpoints(R *left, bool until_turned)
    {
        const R roll = rolls();
        for (int steps = 0; *left != 0; ++steps) {
            const R W = fastest();
            R h = R(REACH) / W;
            most_W = larger(most_W, W);
            h = magnitude(*left) < h ? *left : *left < 0 ? -h : h;
            const vector before = y;
            const R rolled = rolls();
            int halvings = 0;
            while (!step(h, halvings < 12 || !has_kinks() ? NONE<R> : KINK) ||
                   (halvings < 12 && passes_kink(rolled))) {
                y = before;
                h /= 2;
                if (++halvings > 12)
                    return false;
            }
            *left -= h;
            if (steps > MOST_STEPS)
                return false;
            if (magnitude(y[0]) > R(0.8))
                rebase(base * half_pi<R>() + y[0]);
            if (until_turned && !(rolls() * roll > 0))
                return true;
        }
        return true;
    }

    /* Follows series for a natural time, each as far as it reaches; past a kink
     * by midpoints. */
    bool by_series(R left)
    {
        R turned = 0;
        while (left != 0) {
            if (!ahead.known && !foresee(&turned))
                return false;
            const R far = ahead.way.far, to = ahead.at + left;
            const bool within = magnitude(to) <= far;
            const R at = within ? to : left < 0 ? -far : far;
            const R way = within ? left : at - ahead.at;
            const vector before = y;
            ahead.at = at;
            ahead.known = within;
            move();
            if (passes_kink(ahead.roll)) {
                y = before;
                ahead.known = false;
                if (!by_midpoints(&left, true))
                    return false;
                continue;
            }
            left -= way;
            if (!(cth(y[0]) > 0))
                return false;
        }
        return true;
    }

    /* The series from here; false if there are none, or the coin has turned too
     * far.  A series counts for as much as one reaches as a rule. */
    bool foresee(R *turned)
    {
        if (magnitude(y[0]) > R(0.8))
            rebase(base * half_pi<R>() + y[0]);
        const R W = fastest();
        most_W = larger(most_W, W);
        const outset here = {IX,   IZ,   sth(y[0]), cth(y[0]), y[5],
                             y[6], y[7], 0,         0};
        if (!ahead.way.begin(here, W, R(REACH) / W, rolling_series(here, slow)))
            return false;
        *turned += larger(W * ahead.way.far, R(0.2));
        ahead.known = true;
        ahead.at = 0;
        ahead.from = y;
        ahead.roll = rolls();
        return *turned <= 2 * MOST_TURN;
    }

    /* The rate of roll. */
    R rolls() const
    {
        return y[7] + y[6] * sth(y[0]) / cth(y[0]);
    }

    /* Whether friction is not smooth where the contact turns round. */
    bool has_kinks() const
    {
        return slow && (slow->damping != 0 || slow->layer != 0);
    }

    /* Whether the contact has turned round, where that is so, since it rolled
     * at this rate.  A step sees no kink beyond its last substep, so that only
     * the shortest may pass one. */
    bool passes_kink(R rolled) const
    {
        return has_kinks() && !(rolls() * rolled > 0);
    }

    /* To where `ahead` is at. */
    void move()
    {
        vector change;
        ahead.way.at(ahead.at, change);
        for (int i = 0; i < 8; ++i)
            y[i] = ahead.from[i] + change[i];
        turn_axes();
        y[3] = ahead.from[3] + change[3] * cph0 + change[4] * sph0;
        y[4] = ahead.from[4] - change[3] * sph0 + change[4] * cph0;
    }

    /* The sine and the cosine of the heading here. */
    void turn_axes()
    {
        const R st = sine(y[1]), ct = cosine(y[1]);
        sph0 = sphi0 * ct + cphi0 * st;
        cph0 = cphi0 * ct - sphi0 * st;
    }

    bool step(R H, double none)
    {
        vector change;
        const R W = fastest();
        turn_axes();
        const vector sizes = {1, 1, 1, 1, 1, W, W, W};
        if (!extrapolated<R, 8>(
                [this](const vector &v, vector &d) { rates(v, d); }, sizes, H,
                change, none))
            return false;
        for (int i = 0; i < 8; ++i)
            y[i] += change[i];
        return cth(y[0]) > 0;
    }
};

#endif
