/* SPDX-License-Identifier: MIT */
/* The true motion of a coin that rolls or slips: the equations of
 * docs/physics.md in angles, rates and time, each step to the last bits of 64.
 * Natural units: M = a = g = 1. */
#ifndef ROLLCOIN_ADVERSARY_MOTION_HPP
#define ROLLCOIN_ADVERSARY_MOTION_HPP

#include "law.hpp"

#include <array>
#include <complex>

class motion
{
  public:
    /* The lean, whose sine and cosine are sharp near flat too; what phi, psi,
     * x, z have changed by; the rates; of a coin that slips the velocity of its
     * centre along e_X and e_h; sines and cosines of lean and heading. */
    enum { LEAN, PHI, PSI, PX, PZ, WX, WY, WZ, VX, VH, S, C, SPH, CPH, SIZE };
    using vector = std::array<real, SIZE>;

    /* What became of it: it goes on, or a function of it has come down to 0; or
     * that is too costly or too close to tell, or the motion has ended. */
    enum fate { GOES, CROSSES, UNKNOWN };

    static constexpr int MOST_TURN = 80; /* radians: what a truth costs */

    real IX, IZ;
    real a, w;        /* the radius, natural units of rate in the coin's own */
    real most_W = 0;  /* the largest W, and the least cos theta, where a step */
    real least_c = 1; /* began */
    real took = 0;    /* what until() followed, in natural units */
    real none = 0x1p-54L; /* a correction that is none, in parts of a size */
    real slowest = 1e-3L; /* of a slip that does not end */

    template <class P, class S_> motion(const P &p, const S_ &s)
    {
        const moment at(p, s);
        IX = at.IX / at.m;
        IZ = at.IZ / at.m;
        a = at.a;
        w = std::sqrt(at.g / a);
        pose0 = {at.phi, at.psi, at.x / a, at.z / a};
        y = {at.theta, 0, 0, 0, 0, at.wX / w, at.wY / w, at.wZ / w};
        y[S] = at.s;
        y[C] = at.c;
        look();
    }

    /* A body that slips, with a coefficient of friction. */
    motion(const coin_params &p, const coin_body &b, double friction)
        : motion(p, b.s)
    {
        slips = true;
        mu = friction;
        along(b, &y[VX], &y[VH]);
    }

    void slow_by(const coin_losses &l, const coin_params &p)
    {
        slow = losses(l, p, p.mass, a, 1 / w);
        lossy = true;
    }

    real at(int i) const
    {
        return y[size_t(i)];
    }
    real lean_apart(const motion &o) const
    {
        return y[S] * o.y[C] - y[C] * o.y[S];
    }

    /* W of (47). */
    real fastest() const
    {
        return std::sqrt((y[WX] * y[WX] + y[WY] * y[WY]) / (y[C] * y[C]) +
                         y[WZ] * y[WZ] + 1 / y[C]);
    }

    /* The radians that the rates and the fall of a disc make in a time. */
    real turned(real t) const
    {
        const real T2 = (1 + IX) * y[WX] * y[WX] + IX * y[WY] * y[WY] +
                        (1 + IZ) * y[WZ] * y[WZ];
        return std::fabs(t) * w * std::sqrt(T2 + 2 * y[C]);
    }

    /* The largest of 1, the angles and the place in radii. */
    real largest_of_pose() const
    {
        real most = 1;
        for (size_t i = 0; i < 4; ++i)
            most = std::max(most, std::fabs(pose0[i] + y[PHI + i]));
        return most;
    }

    /* How far a state is from here: members in radians, radii and parts of a
     * rate. */
    template <class S_> void apart(const S_ &s, real rate, real off[8]) const
    {
        const double *is = &s.theta;
        off[LEAN] = is[LEAN] - y[LEAN];
        for (size_t i = PHI; i <= PZ; ++i)
            off[i] = is[i] / (i < PX ? 1 : a) - pose0[i - PHI] - y[i];
        for (size_t i = WX; i <= WZ; ++i)
            off[i] = (is[i] / w - y[i]) / rate;
    }
    /* The largest of a body; of one that rolls, in pose. */
    real off(const coin_body &b) const
    {
        real each[8], X, h;
        apart(b.s, fastest(), each);
        along(b, &X, &h);
        real worst =
            slips ? std::hypot(X - y[VX], h - y[VH]) / fastest() : real(0);
        for (int i = 0; i < (slips ? 8 : 5); ++i)
            worst = std::max(worst, std::fabs(each[i]));
        return worst;
    }
    real off(const motion &o) const
    {
        real worst = std::fabs(lean_apart(o));
        for (size_t i = PHI; i <= VH; ++i)
            worst = std::max(worst, std::fabs(y[i] - o.y[i]) /
                                        (i < WX ? 1 : fastest()));
        return worst;
    }

    /* ------------------------------------------------------------- its way */
    /* Whether a truth would cost too much. */
    bool is_long(real t, int most = MOST_TURN) const
    {
        return !(std::fabs(t * w) * fastest() <= most);
    }

    /* Follows the motion; false if it does not go on, or takes too long. */
    bool follow(real t, int most = MOST_TURN)
    {
        const auto pressed = [](const motion &m) { return m.pressed(); };
        const auto one = [](const motion &) { return real(1); };
        return slips ? until(t, pressed) == GOES
                     : !is_long(t, most) && until(t, one) == GOES;
    }

    /* Follows it for a time, or to where a function of it comes down to 0, by
     * steps of so many radians of the fastest rate.  It is unknown what a
     * function does that turns round below `close`, and what a slip does that
     * lifts off or all but stops. */
    template <class F>
    fate until(real t, const F &f, double reach = REACH, double close = 0.05)
    {
        real left = t * w, last = f(*this), before = last;
        took = 0;
        for (int steps = 0; left != 0; ++steps) {
            const motion from = *this;
            const bool is_light = slips && pressed() < 0.5L;
            real h = (is_light ? std::min(0.1, reach) : reach) / rate();
            h = std::fabs(left) < h ? left : left < 0 ? -h : h;
            if (steps > (slips ? MOST_SLIPPED : 2 * MOST_TURN / reach) ||
                !stride(&h))
                return UNKNOWN;
            const real now = f(*this);
            if (!(now > 0)) {
                took += cross(from, h, f);
                return CROSSES;
            }
            if ((last < before && last < now && last < close) || ends())
                return UNKNOWN;
            before = last;
            last = now;
            left -= h;
            took += h;
        }
        return GOES;
    }

    /* One of y, off by so much. */
    void nudge(int i, real size)
    {
        const real s = std::sin(size), c = std::cos(size), from = y[S];
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
    real unit(int i) const
    {
        return (slips ? 1 : y[C]) * (i == LEAN ? 1 : fastest());
    }

    /* How much errors change a function of the motion. */
    template <class F> real moves(const F &function) const
    {
        const real size = 1e-7L;
        real sum = 1;
        for (int k = 0; k < drives(); ++k) {
            motion other = *this;
            other.nudge(DRIVES[k], size * (slips ? 1 : unit(DRIVES[k])));
            sum += std::fabs(function(other) - function(*this)) / size;
        }
        return sum;
    }
    /* Its slope in natural time. */
    template <class F> real slope_of(const F &function) const
    {
        real h = 1e-6L;
        motion later = *this;
        return later.stride(&h) ? (function(later) - function(*this)) / h : 0;
    }

    /* By how much the motion itself makes an error grow that is made on its
     * way of a time: from the worst of some moments.  If that is more than
     * enough, something between the two. */
    real growth(real t, real enough) const
    {
        constexpr int MOMENTS = 6;
        std::vector<motion> moments(1, *this);
        moments[0].none = 0x1p-42L; /* of motions a ten millionth apart */
        for (int k = 0; k < MOMENTS; ++k) {
            moments.push_back(moments.back());
            if (!moments.back().follow(t / MOMENTS))
                return 1e30L;
        }
        real worst = 1;
        for (int k = 0; k < MOMENTS && worst < enough; ++k)
            worst = std::max(worst, moments[size_t(k)].grown(
                                        moments.back(),
                                        t * (MOMENTS - k) / MOMENTS, enough));
        return worst;
    }

    /* Puts so many periods before the way since the start.  Each turns the next
     * by its heading. */
    void repeat(const motion &period, real times)
    {
        using place = std::complex<real>;
        const real h = period.y[PHI] / 2, all = times * h;
        const real sum = std::sin(h) == 0 ? times : std::sin(all) / std::sin(h);
        const place way = place(period.y[PX], period.y[PZ]) * sum *
                              std::polar(1.0L, h - all) +
                          place(y[PX], y[PZ]) * std::polar(1.0L, -2 * all);
        y[PX] = way.real();
        y[PZ] = way.imag();
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
    real speed() const
    {
        return std::hypot(y[VX] + y[WZ], y[VH] - y[WX] * y[C]);
    }
    real speed_slope() const
    {
        const vector d = slopes();
        const real X = y[VX] + y[WZ], h = y[VH] - y[WX] * y[C];
        return (X * (d[VX] + d[WZ]) +
                h * (d[VH] - d[WX] * y[C] + y[WX] * y[S] * y[WX])) /
               speed();
    }

    /* The normal force on a coin that slips. */
    real pressed() const
    {
        vector d;
        return rates(vector(), d);
    }

    /* The normal force and the friction of a contact without slip. */
    struct contact {
        real N, F;
    };
    contact stuck() const
    {
        motion rolls = *this;
        rolls.slips = false;
        const vector d = rolls.slopes();
        const real X = y[WX] * y[WY] - d[WZ]; /* (25) */
        const real h = -y[WX] * y[WX] * y[S] + d[WX] * y[C] +
                       y[WY] * y[WZ] / y[C];                    /* (26) */
        const real N = 1 - y[WX] * y[WX] * y[C] - d[WX] * y[S]; /* (27) */
        return {N, std::hypot(X, h)};
    }
    /* What is left of the cone of friction of a coin that rolls: mu N - F, over
     * mu where that is above 2. */
    real left(real of) const
    {
        const contact f = stuck();
        return of > DBL_MAX ? f.N : of > 2 ? f.N - f.F / of : of * f.N - f.F;
    }

  private:
    /* Radians of the fastest rate in a step. */
    static constexpr double REACH = 0.6;
    static constexpr int MOST_SLIPPED = 600;

    /* A correction that is none in the shortest steps, which pass a kink; so
     * many halvings lead there. */
    static constexpr real KINK = 1e-14L;
    static constexpr int HALVINGS = 12;

    vector y;
    std::array<real, 4> pose0; /* phi, psi, x, z at the start */
    bool slips = false, lossy = false;
    real mu = 0;
    losses slow;

    /* The velocity of a body's centre along e_X and e_h here. */
    void along(const coin_body &b, real *X, real *h) const
    {
        const real vx = b.vx / (a * w), vz = b.vz / (a * w);
        *X = vx * y[CPH] - vz * y[SPH];
        *h = vx * y[SPH] + vz * y[CPH];
    }

    /* The sine and cosine of the heading here; those of the lean stay on their
     * circle. */
    void look()
    {
        const real one = std::hypot(y[S], y[C]), phi = pose0[0];
        const real st = std::sin(y[PHI]), ct = std::cos(y[PHI]);
        y[S] /= one;
        y[C] /= one;
        y[SPH] = std::sin(phi) * ct + std::cos(phi) * st;
        y[CPH] = std::cos(phi) * ct - std::sin(phi) * st;
    }

    /* The rate of roll, and whether friction is not smooth where the contact
     * turns round. */
    real rolls() const
    {
        return y[WZ] + y[WY] * y[S] / y[C];
    }
    bool has_kinks() const
    {
        return lossy && (slow.damping != 0 || slow.layer != 0);
    }

    /* The fastest rate of change: W, of a slip also that of its direction, that
     * at which the losses slow the body, and that at which dry friction turns
     * round where the rolling does. */
    real rate() const
    {
        const real W = fastest(), T = y[S] / y[C], c2 = y[C] * y[C];
        if (!slips)
            return W;
        const real turns =
            mu > 0 ? mu * pressed() * (1 + 1 / IX) / speed() : real(0);
        const real slowed =
            lossy ? slow.grip(rolls(), y[C]) * (1 / IZ + T * T / IX) +
                        slow.spin * (c2 / IX + y[S] * y[S] / IZ)
                  : real(0);
        real reverses = 0;
        if (lossy && slow.dry + slow.rolling > 0) {
            const vector d = slopes();
            const real roll = d[WZ] + d[WY] * T + y[WY] * y[WX] / c2;
            reverses = std::fabs(roll) / std::hypot(rolls(), slow.soft);
        }
        return W + turns + slowed + reverses;
    }
    /* Whether a slip lifts off, all but stops, or is too stiff. */
    bool ends() const
    {
        return slips && (!(pressed() > 0) ||
                         !(rate() * std::min(real(1), 100 * speed()) < 1e3L) ||
                         (mu > 0 && speed() < slowest));
    }

    /* To where f comes down to 0 within a step from a motion; how long that is.
     */
    template <class F> real cross(const motion &from, real step, const F &f)
    {
        real low = 0, high = step;
        for (int i = 0; i < 60; ++i) {
            const real middle = (low + high) / 2;
            *this = from;
            (pass(middle) && f(*this) > 0 ? low : high) = middle;
        }
        return high;
    }

    /* A step, or as many halvings of it as it needs; false if it falls flat.  A
     * step sees no kink beyond its last substep, so that only the shortest may
     * pass one. */
    bool stride(real *h)
    {
        const vector before = y;
        const real roll = rolls();
        most_W = std::max(most_W, fastest());
        least_c = std::min(least_c, y[C]);
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

    bool pass(real t)
    {
        for (real h = t; t != 0; t -= h, h = t)
            if (!stride(&h))
                return false;
        return true;
    }

    /* The change in a time by n substeps of the modified midpoint rule. */
    vector by_midpoints(real t, int n) const
    {
        const real h = t / n;
        vector last = {}, now, d;
        rates(last, d);
        for (size_t i = 0; i < SIZE; ++i)
            now[i] = h * d[i];
        for (int k = 1; k < n; ++k) {
            rates(now, d);
            for (size_t i = 0; i < SIZE; ++i) {
                const real next = last[i] + 2 * h * d[i];
                last[i] = now[i];
                now[i] = next;
            }
        }
        return now;
    }

    /* Those, extrapolated (Gragg, Bulirsch, Stoer) until a correction is at
     * most so many parts of the sizes; false if that takes more columns. */
    bool step(real h, real small)
    {
        constexpr int COLUMNS = 11;
        const real W = fastest(), c = y[C];
        const vector sizes = {c, 1, 1, 1, 1, c * W, c * W, W, W, W, 1, c, 1, 1};
        vector table[COLUMNS];
        real error = 1;
        for (int k = 0; k < COLUMNS && (k < 3 || !(error < small)); ++k) {
            table[k] = by_midpoints(h, 2 * k + 2);
            for (int j = k - 1; j >= 0; --j) {
                const real ratio = real(k + 1) / (j + 1);
                error = 0;
                for (size_t i = 0; i < SIZE; ++i) {
                    const real off =
                        (table[j + 1][i] - table[j][i]) / (ratio * ratio - 1);
                    table[j][i] = table[j + 1][i] + off;
                    error = std::max(error, std::fabs(off) / sizes[i]);
                }
            }
            if (!(error < 1) && k > 0) /* also NaN */
                return false;
        }
        for (size_t i = 0; i < SIZE; ++i)
            y[i] += table[0][i];
        return error < small && y[C] > 0;
    }

    /* The slopes at y + v; of a slip, the normal force. */
    real rates(const vector &v, vector &d) const
    {
        const real s = y[S] + v[S], c = y[C] + v[C], T = s / c;
        const real sph = y[SPH] + v[SPH], cph = y[CPH] + v[CPH];
        const real wX = y[WX] + v[WX], wY = y[WY] + v[WY], wZ = y[WZ] + v[WZ];
        const real turn = wY / c, J = IX + !slips, K = IZ + !slips;
        real ahead = -wZ, across = wX * c, N = 0;
        slowing by;
        if (lossy)
            by = slow.at(IX, IZ, J, K, s, c, wX, wY, wZ);
        d[WX] = -(K * wZ + IX * wY * T) * wY / J + by.wX.value; /* (14) */
        d[WY] = wX * (wY * T + IZ / IX * wZ) + by.wY.value;     /* (15) */
        if (slips) {
            ahead = y[VX] + v[VX];
            across = y[VH] + v[VH];
            const real X = ahead + wZ, h = across - wX * c;
            const real u = mu > 0 ? std::hypot(X, h) : real(1);
            N = (1 - wX * wX * c - s * d[WX]) /
                (1 + s * (s + mu * h / u * c) / IX); /* (80) */
            const real FX = -mu * N * X / u, Fh = -mu * N * h / u;
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

    /* How much an error here has grown when the motion comes to `end`: errors
     * of what drives it, as an error of a step is, and, of a coin that rolls,
     * of the heading, which turns the way that is left.  Or so much of it that
     * it is enough.  A small error that has become large grew by more than its
     * size shows: about upright the force of a slip changes within leans of
     * root(I_X). */
    real grown(const motion &end, real t, real enough) const
    {
        const real size = 1e-7L;
        const real far = 0.1L * (slips ? std::min(real(1), std::sqrt(IX)) : 1);
        real sum = 1;
        if (!slips)
            sum += std::hypot(end.y[PX] - y[PX], end.y[PZ] - y[PZ]);
        for (int k = 0; k < drives() && sum < enough; ++k) {
            real most = 0;
            for (int side : {-1, 1}) {
                motion other = *this;
                other.nudge(DRIVES[k], side * size * unit(DRIVES[k]));
                if (!other.follow(t) || end.off(other) > far)
                    return 1e30L;
                most = std::max(most, end.off(other) / size);
            }
            sum += most;
        }
        return sum;
    }
};

/* "Before the motion's own amplification": a ratio without that growth, which
 * is dear, where it matters. */
constexpr double UNAMPLIFIED = 0.3;
inline double unamplified(double ratio, double enough, const motion &start,
                          real t)
{
    if (!(ratio > std::max(enough, UNAMPLIFIED)))
        return ratio;
    return double(ratio / start.growth(t, enough > 0 ? ratio / enough : 1e30));
}

#endif
