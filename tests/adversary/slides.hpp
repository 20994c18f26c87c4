/* SPDX-License-Identifier: MIT */
/* Coins that slip, by the equations of docs/physics.md in time. */
#ifndef ROLLCOIN_ADVERSARY_SLIDES_HPP
#define ROLLCOIN_ADVERSARY_SLIDES_HPP

#include "course.hpp"
#include "midpoint.hpp"
#include "scene.hpp"
#include "truth.hpp"

/* The height and the normal velocity of a body that touches the table. */
inline void set_on_table(coin_body *b, const coin_params &p)
{
    b->y = p.radius * std::cos(b->s.theta);
    b->vy = -p.radius * std::sin(b->s.theta) * b->s.wX;
}

/* Whether that is so of a returned body, to the rounding of two cosines; and of
 * two sines and four products. */
inline bool is_on_table(const coin_body &b, const coin_params &p)
{
    coin_body on = b;
    set_on_table(&on, p);
    return std::fabs(on.y - b.y) <= 0x1p-52 * p.radius &&
           std::fabs(on.vy - b.vy) <= 0x1p-50 * std::fabs(on.vy);
}

/* A scene's velocity of the centre, in parts of sqrt(g a), and its friction;
 * its losses, all of the size q[2] in parts of the coin's own torques, where
 * the bits of steps ask for them. */
struct asked {
    coin_params p;
    coin_body d;
    coin_table f;
    bool lossy;

    explicit asked(const scene &s, bool slowed = false)
        : p(params_of<doubles>(s)), d(), f(), lossy(slowed)
    {
        const double v = std::sqrt(s.g * s.a);
        d.s = state_of<doubles>(s);
        d.vx = s.q[0] * v;
        d.vz = s.q[1] * v;
        set_on_table(&d, p);
        f.mu_static = s.tol * 1.1;
        f.mu_kinetic = s.tol;
        if (slowed) {
            scene of = s;
            /* No damping; angular. */
            of.steps = 2 * (int(s.steps) % 64) + 256 * (int(s.steps) / 64 % 2);
            of.q[0] = of.q[1] = of.q[3] = s.q[2];
            f.losses = losses_of(of);
        }
    }
    int32_t advance(coin_body *at, double t, double tol,
                    int32_t stop = COIN_LIFTS, double *reached = nullptr) const
    {
        return coin_move(at, &p, &f, t, tol, stop, reached);
    }
};

/* The slip velocity along e_X and e_h, (77). */
template <class R> struct slipping {
    terms<R> X, h;

    slipping(const moment<R> &y, const coin_body &d)
    {
        X.add(R(d.vx) * y.cph).add(-R(d.vz) * y.sph).add(y.a * y.wZ);
        h.add(R(d.vx) * y.sph).add(R(d.vz) * y.cph).add(-y.a * y.wX * y.c);
    }
    R speed() const
    {
        return root(X.value * X.value + h.value * h.value);
    }
    R size() const
    {
        return X.size + h.size;
    }
};

/* The force on a contact without slip, where M = a = g = 1. */
template <class R> struct held {
    R N, X, h;

    held(R IX, R IZ, R s, R c, const R w[3])
    {
        const R wX = w[0], wY = w[1], wZ = w[2];
        const R dwX = (-(1 + IZ) * wY * wZ - IX * wY * wY * s / c + s) /
                      (1 + IX);                   /* (14) */
        N = 1 - wX * wX * c - dwX * s;            /* (27) */
        X = wX * wY * IZ / (1 + IZ);              /* (25) */
        h = -wX * wX * s + dwX * c + wY * wZ / c; /* (26) */
    }
    R friction() const
    {
        return root(X * X + h * h);
    }
};

/* Natural units: M = a = g = 1. */
template <class R> class slide
{
  public:
    using vector = std::array<R, 10>; /* lean, phi, psi, x, z, wX, wY, wZ, vX,
                                         vh */
    vector y;
    R a, w; /* the radius, and natural units of rate in the coin's own */

    explicit slide(const asked &q)
        : a(R(q.p.radius)), w(root(R(q.p.gravity) / a)),
          of(q.f.losses, softening(q.f.losses, q.p), q.p.mass, q.p.radius,
             1 / w),
          lossy(q.lossy)
    {
        const moment<R> m(q.p, q.d.s);
        const slipping<R> u(m, q.d);
        IX = m.IX / m.m;
        IZ = m.IZ / m.m;
        mu = q.f.mu_kinetic;
        y = {m.theta,
             m.phi,
             m.psi,
             m.x / a,
             m.z / a,
             m.wX / w,
             m.wY / w,
             m.wZ / w,
             u.X.value / (a * w) - m.wZ / w,
             u.h.value / (a * w) + m.wX / w * m.c};
    }

    /* What became of it: it slips on, it has all but stopped to slip, it lifts
     * off, or that is too costly to tell. */
    enum fate { SLIPS, STOPS, LIFTS, UNKNOWN };

    /* Follows the slip for a time, or until friction has slowed it to `least`,
     * or it lifts off; the time is then in `took`, in natural units.  Steps are
     * short where the normal force is small.  Where it has a minimum near 0, it
     * is unknown whether the coin lifts off. */
    fate follow(R t, R least = R(1e-3))
    {
        R left = t * w;
        /* N where the last step began, and where the one before it did: at
         * first by the slope. */
        R last = pressed(), before = last - lightening();
        took = 0;
        for (int steps = 0; left > 0; ++steps) {
            const vector from = y;
            const R fast = rate();
            R h = lesser(left, R(0.25) / fast);
            if (!(fast * lesser(R(1), 100 * speed(y)) < 1e3) ||
                steps > MOST_STEPS || !foresee(fast, left, &h))
                return UNKNOWN;
            if (last < R(0.5))
                h = lesser(h, R(0.1) / fast);
            for (int halvings = 0; !move(from, h); ++halvings, h /= 2)
                if (halvings > 8)
                    return UNKNOWN;
            const R now = pressed();
            const bool lifts = !(now > 0);
            if (last < before && last < now && last < R(0.05))
                return UNKNOWN;
            if (lifts)
                h = until_lifted(from, h);
            before = last;
            last = now;
            left -= h;
            took += h;
            if (lifts)
                return LIFTS;
            if (mu > 0 && speed(y) < least)
                return STOPS;
        }
        return SLIPS;
    }
    R took = 0;

    /* Sharp enough to compare motions a ten millionth apart. */
    void be_quick()
    {
        ahead.ends = 0x1p-42;
    }

    /* Errors grow in proportion only while they are small beside this: about
     * upright the force changes within leans of root(IX). */
    R linear() const
    {
        return R(0.1L) * lesser(R(1), root(IX));
    }

    /* The slope of the slip speed. */
    R speed_slope() const
    {
        vector none = {}, d;
        rates(none, d);
        const R s = sine(y[0]), c = cosine(y[0]);
        const R X = y[8] + y[7], h = y[9] - y[5] * c;
        return (X * (d[8] + d[7]) + h * (d[9] - d[5] * c + y[5] * s * y[5])) /
               speed(y);
    }

    R pressed() const
    {
        vector none = {}, d;
        return rates(none, d);
    }

    /* The slope of the normal force, and how much errors change it. */
    R lightening() const
    {
        slide later = *this;
        return later.step(R(1e-6)) ? (later.pressed() - pressed()) / R(1e-6)
                                   : R(0);
    }
    R pull() const
    {
        R sum = 1;
        for (size_t i : {0, 5, 6, 7, 8, 9}) {
            slide other = *this;
            other.y[i] += R(1e-7);
            sum += magnitude(other.pressed() - pressed()) / R(1e-7);
        }
        return sum;
    }

    /* The friction of a contact without slip over its normal force; negative
     * if that is not above 0. */
    R sticking() const
    {
        const held<R> f(IX, IZ, sine(y[0]), cosine(y[0]), &y[5]);
        return f.N > 0 ? f.friction() / f.N : R(-1);
    }

    /* Changes one of y, by a size in its unit. */
    void nudge(size_t i, R size)
    {
        y[i] += size * unit(i);
    }

    /* The largest difference from an output, each in its unit. */
    R apart(const coin_body &d) const
    {
        const R sph = sine(y[1]), cph = cosine(y[1]), v = a * w;
        const R at[] = {d.s.theta,
                        d.s.phi,
                        d.s.psi,
                        d.s.x / a,
                        d.s.z / a,
                        d.s.wX / w,
                        d.s.wY / w,
                        d.s.wZ / w,
                        R(d.vx) / v * cph - R(d.vz) / v * sph,
                        R(d.vx) / v * sph + R(d.vz) / v * cph};
        return apart(at);
    }
    R apart(const slide &o) const
    {
        return apart(o.y.data());
    }

    R speed(const vector &q) const
    {
        const R X = q[8] + q[7], h = q[9] - q[5] * cosine(q[0]);
        return root(X * X + h * h);
    }

  private:
    static constexpr bool IS_QUICK = std::is_same_v<R, long double>;
    struct nothing {
    };

    static constexpr int MOST_STEPS = IS_QUICK ? 600 : 3000;
    R IX, IZ, mu;
    std::conditional_t<IS_QUICK, course<10>, nothing> ahead;
    losses<R> of;
    bool lossy;

    R apart(const R *o) const
    {
        R worst = 0;
        for (size_t i = 0; i < 10; ++i)
            worst = larger(worst, magnitude(o[i] - y[i]) / unit(i));
        return worst;
    }

    /* Of differences: radians, radii, and W of the rates, but at least 1. */
    R unit(size_t i) const
    {
        return i < 5 ? R(1) : larger(R(1), turning(cosine(y[0])));
    }

    /* W of (47). */
    R turning(R c) const
    {
        return root((y[5] * y[5] + y[6] * y[6]) / (c * c) + y[7] * y[7] +
                    1 / c);
    }

    R rate() const
    {
        const R s = sine(y[0]), c = cosine(y[0]);
        const R by_friction =
            mu > 0 ? mu * pressed() * (1 + 1 / IX) / speed(y) : R(0);
        return turning(c) + by_friction + (lossy ? slowed(s, c) : R(0));
    }

    /* The fastest rate at which the losses slow the body. */
    R slowed(R s, R c) const
    {
        const R T = s / c, roll = y[7] + y[6] * T;
        return of.grip(roll, c) * (1 / IZ + T * T / IX) +
               of.spin * (c * c / IX + s * s / IZ);
    }

    bool step(R h)
    {
        vector change, sizes;
        sizes.fill(1);
        if (!extrapolated<R, 10>(
                [this](const vector &v, vector &d) { rates(v, d); }, sizes, h,
                change))
            return false;
        for (int i = 0; i < 10; ++i)
            y[i] += change[i];
        return true;
    }

    /* The series from here, and as far as they go or is left; by midpoints
     * there are none. */
    bool foresee(R fast, R left, R *h)
    {
        if constexpr (IS_QUICK) {
            const R s = sine(y[0]), c = cosine(y[0]);
            const outset here = {IX, IZ, s, c, y[5], y[6], y[7], y[8], y[9]};
            if (!ahead.begin(here, turning(c), 1 / fast,
                             slipping_series(here, mu, lossy ? &of : nullptr)))
                return false;
            *h = lesser(left, ahead.far);
        }
        return true;
    }

    /* To h from where the series began, or by midpoints. */
    bool move(const vector &from, R h)
    {
        y = from;
        if constexpr (IS_QUICK) {
            vector d;
            ahead.at(h, d);
            for (int i = 0; i < 10; ++i)
                y[i] += d[i];
            const R sph = sine(y[1]), cph = cosine(y[1]);
            y[3] = from[3] + d[3] * cph + d[4] * sph;
            y[4] = from[4] - d[3] * sph + d[4] * cph;
            return cosine(y[0]) > 0;
        } else {
            return step(h);
        }
    }

    /* To the end of the part of a step h that ends where N = 0; how long. */
    R until_lifted(const vector &from, R h)
    {
        R low = 0, high = h;
        for (int i = 0; i < 60; ++i) {
            const R middle = (low + high) / 2;
            if (!move(from, middle))
                return high;
            (pressed() > 0 ? low : high) = middle;
        }
        return high;
    }

    /* At y + v; the normal force. */
    R rates(const vector &v, vector &d) const
    {
        vector q;
        for (int i = 0; i < 10; ++i)
            q[i] = y[i] + v[i];
        const R s = sine(q[0]), c = cosine(q[0]), T = s / c;
        const R wX = q[5], wY = q[6], wZ = q[7], u = speed(q);
        const R nX = mu > 0 ? (q[8] + wZ) / u : R(0);
        const R nh = mu > 0 ? (q[9] - wX * c) / u : R(0);
        slowing<R> by;
        if (lossy)
            by = of.at(IX, IZ, IX, IZ, s, c, wX, wY, wZ);
        const R gX = -(IZ * wY * wZ + IX * wY * wY * T) / IX + by.wX.value;
        const R N = (1 - wX * wX * c - s * gX) /
                    (1 + s * (s + mu * nh * c) / IX); /* (80) */
        const R FX = -mu * N * nX, Fh = -mu * N * nh, turn = wY / c;
        const R sph = sine(q[1]), cph = cosine(q[1]);
        d = {wX,
             turn,
             wZ + wY * T,
             q[8] * cph + q[9] * sph,
             q[9] * cph - q[8] * sph,
             gX + (N * s - Fh * c) / IX,
             wX * (wY * T + IZ / IX * wZ),
             FX / IZ,
             FX - turn * q[9],
             Fh + turn * q[8]};
        if (lossy) {
            d[6] += by.wY.value;
            d[7] += by.wZ.value;
        }
        return N;
    }
};

/* Any velocity of the centre and friction. */
inline void thrown(scene *s, const double *g)
{
    s->tol = 1.2 * g[24];
    s->t = std::sqrt(s->a / s->g) * std::pow(10, 3.5 * g[22] - 2.5);
    s->phi = 6 * g[18] - 3;
    s->psi = 6 * g[19] - 3;
    s->x = s->a * (6 * g[20] - 3);
    s->z = s->a * (6 * g[21] - 3);
    s->q[0] = 4 * g[26] - 2;
    s->q[1] = 4 * g[27] - 2;
    s->q[3] = std::pow(10, 9.9 * g[29] - 11.95);
}

#endif
