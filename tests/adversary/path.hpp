/* SPDX-License-Identifier: MIT */
/* The true motion: the textbook's equations (14)-(20) in angles and rates, by
 * extrapolation of the modified midpoint rule (Gragg, Bulirsch, Stoer), each
 * step to the precision of R.  Natural units: M = a = g = 1. */
#ifndef ROLLCOIN_ADVERSARY_PATH_HPP
#define ROLLCOIN_ADVERSARY_PATH_HPP

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

    R a, w; /* the radius, and natural units of rate in the coin's own */
    R most_W = 0; /* the largest W where a step began */
    const losses<R> *slow = nullptr; /* what slows the coin, or null */

    /* Follows the motion; false if it falls flat or takes too long. */
    bool follow(R t)
    {
        R left = t * w;
        if (is_long(t))
            return false;
        for (int steps = 0; left != 0; ++steps) {
            const R W = fastest();
            R h = R(REACH) / W;
            most_W = larger(most_W, W);
            h = magnitude(left) < h ? left : left < 0 ? -h : h;
            int halvings = 0;
            while (!step(h)) {
                h /= 2;
                if (++halvings > 12)
                    return false;
            }
            left -= h;
            if (steps > MOST_STEPS)
                return false;
            if (magnitude(y[0]) > R(0.8))
                rebase(base * half_pi<R>() + y[0]);
        }
        return true;
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
    /* Radians of the fastest rate in a step. */
    static constexpr double REACH = std::is_same_v<R, long double> ? 0.6 : 0.3;
    static constexpr int MOST_STEPS = int(2 * MOST_TURN / REACH);

    R IX, IZ;
    vector y;
    std::array<R, 4> pose0; /* phi, psi, x, z at the start; y has their changes
                             */
    R sphi0, cphi0, sph0, cph0; /* of the heading: there, and where a step
                                   begins */
    int base = 0; /* y[0] is the lean from base pi/2: sharp near flat too */

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

    bool step(R H)
    {
        vector change;
        const R W = fastest();
        sph0 = sphi0 * cosine(y[1]) + cphi0 * sine(y[1]);
        cph0 = cphi0 * cosine(y[1]) - sphi0 * sine(y[1]);
        const vector sizes = {1, 1, 1, 1, 1, W, W, W};
        if (!extrapolated<R, 8>(
                [this](const vector &v, vector &d) { rates(v, d); }, sizes, H,
                change))
            return false;
        for (int i = 0; i < 8; ++i)
            y[i] += change[i];
        return cth(y[0]) > 0;
    }
};

#endif
