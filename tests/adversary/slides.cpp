/* SPDX-License-Identifier: MIT */
/* Coins that slip: what is read off a slide, and its way while it slips, by the
 * equations of Newton and Euler in time. */
#include "midpoint.hpp"
#include "row.hpp"
#include "truth.hpp"

namespace
{
/* A scene's velocity of the centre, in parts of sqrt(g a), and its friction. */
struct asked {
    coin_params p;
    coin_slide d;
    coin_friction f;

    explicit asked(const scene &s) : p(params_of<doubles>(s))
    {
        const double v = std::sqrt(s.g * s.a);
        d = {state_of<doubles>(s), s.q[0] * v, s.q[1] * v};
        f = {s.tol * 1.1, s.tol};
    }
};

/* The slip velocity along e_X and e_h, (77). */
template <class R> struct slipping {
    terms<R> X, h;

    slipping(const moment<R> &y, const coin_slide &d)
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

template <class R> double energy(const scene &s, double)
{
    const asked q(s);
    const moment<R> y(q.p, q.d.s);
    const double E = coin_slide_energy(&q.d, &q.p);
    if (E != E)
        return NO_CLAIM;
    terms<R> want;
    const R vy = y.a * y.wX * y.s;
    want.add(y.M * q.d.vx * q.d.vx / 2).add(y.M * q.d.vz * q.d.vz / 2);
    want.add(y.M * vy * vy / 2).add(y.IX * y.wX * y.wX / 2);
    want.add(y.IX * y.wY * y.wY / 2).add(y.IZ * y.wZ * y.wZ / 2);
    want.add(y.Mga * y.c); /* (88) */
    verdict<R> v;
    v.hold(R(E), want.value,
           8 * R(doubles::u) * want.size + 16 * R(doubles::normal));
    return v.worst;
}

template <class R> double velocity(const scene &s, double)
{
    const asked q(s);
    const moment<R> y(q.p, q.d.s);
    double u[2];
    if (coin_slide_velocity(&q.d, &q.p, u) != COIN_OK)
        return NO_CLAIM;
    const slipping<R> of(y, q.d);
    const R allowed = 8 * R(doubles::u) * of.size() + 16 * R(doubles::normal);
    verdict<R> v;
    v.hold(R(u[0]), of.X.value * y.cph + of.h.value * y.sph, allowed);
    v.hold(R(u[1]), of.h.value * y.cph - of.X.value * y.sph, allowed);
    return v.worst;
}

/* ------------------------------------------------------------ while it slips */
/* Natural units: M = a = g = 1. */
template <class R> class slide
{
  public:
    using vector = std::array<R, 10>; /* lean, phi, psi, x, z, wX, wY, wZ, vX,
                                         vh */
    vector y;
    R a, w; /* the radius, and natural units of rate in the coin's own */

    explicit slide(const asked &q)
    {
        const moment<R> m(q.p, q.d.s);
        const slipping<R> u(m, q.d);
        a = m.a;
        w = root(m.g / m.a);
        IX = m.IX / m.m;
        IZ = m.IZ / m.m;
        mu = q.f.mu_kinetic;
        y = {m.theta, m.phi,    m.psi,    m.x / a,
             m.z / a, m.wX / w, m.wY / w, m.wZ / w,
             u.X.value / (a * w) - m.wZ / w,
             u.h.value / (a * w) + m.wX / w * m.c};
    }

    /* Whether it slips all the time, clear of where it would stop to. */
    bool follow(R t)
    {
        R left = t * w;
        for (int steps = 0; left > 0; ++steps) {
            const R h = lesser(left, R(0.25) / rate());
            vector change, sizes;
            sizes.fill(1);
            if (!(rate() < 1e3) || steps > 3000 ||
                !extrapolated<R, 10>(
                    [this](const vector &v, vector &d) { rates(v, d); }, sizes,
                    h, change))
                return false;
            for (int i = 0; i < 10; ++i)
                y[i] += change[i];
            left -= h;
            if (!(speed(y) > R(1e-3) && pressed() > R(1e-3)))
                return false;
        }
        return true;
    }

    /* The largest difference from an output, in natural units. */
    R apart(const coin_slide &d) const
    {
        const R sph = sine(y[1]), cph = cosine(y[1]), v = a * w;
        const R at[] = {d.s.theta,    d.s.phi,      d.s.psi,     d.s.x / a,
                        d.s.z / a,    d.s.wX / w,   d.s.wY / w,  d.s.wZ / w,
                        R(d.vx) / v * cph - R(d.vz) / v * sph,
                        R(d.vx) / v * sph + R(d.vz) / v * cph};
        R worst = 0;
        for (int i = 0; i < 10; ++i)
            worst = larger(worst, magnitude(at[i] - y[i]));
        return worst;
    }
    R apart(const slide &o) const
    {
        R worst = 0;
        for (int i = 0; i < 10; ++i)
            worst = larger(worst, magnitude(o.y[i] - y[i]));
        return worst;
    }

    R speed(const vector &q) const
    {
        const R X = q[8] + q[7], h = q[9] - q[5] * cosine(q[0]);
        return root(X * X + h * h);
    }

  private:
    R IX, IZ, mu;

    R rate() const
    {
        const R c = cosine(y[0]);
        return root((y[5] * y[5] + y[6] * y[6]) / (c * c) + y[7] * y[7] +
                    1 / c) +
               mu * pressed() * (1 + 1 / IX) / speed(y);
    }

    R pressed() const
    {
        vector none = {}, d;
        return rates(none, d);
    }

    /* At y + v; the normal force. */
    R rates(const vector &v, vector &d) const
    {
        vector q;
        for (int i = 0; i < 10; ++i)
            q[i] = y[i] + v[i];
        const R s = sine(q[0]), c = cosine(q[0]), T = s / c;
        const R wX = q[5], wY = q[6], wZ = q[7], u = speed(q);
        const R nX = (q[8] + wZ) / u, nh = (q[9] - wX * c) / u;
        const R gX = -(IZ * wY * wZ + IX * wY * wY * T) / IX; /* (78) */
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
        return N;
    }
};

/* By how much errors on the way grow until t. */
double growth(const asked &q, long double t)
{
    slide<long double> from(q), end(q);
    if (!end.follow(t))
        return 1e30;
    long double worst = 1;
    for (int k = 0; k < 4; ++k) {
        long double sum = 1;
        for (int i : {0, 5, 6, 7, 8, 9}) {
            slide<long double> other = from;
            other.y[size_t(i)] += 1e-7L;
            if (!other.follow(t * (4 - k) / 4))
                return 1e30;
            sum += end.apart(other) / 1e-7L;
        }
        worst = larger(worst, sum);
        if (!from.follow(t / 4))
            return 1e30;
    }
    return double(worst);
}

template <class R> double advance(const scene &s, double enough)
{
    const asked q(s);
    const double tol = s.q[3];
    coin_slide end = q.d;
    slide<R> truth(q);
    if (!(truth.speed(truth.y) > R(1e-2)) ||
        coin_slide_advance(&end, &q.p, &q.f, nullptr, s.t, tol, nullptr) !=
            COIN_SLIPS ||
        !truth.follow(R(s.t)))
        return NO_CLAIM;
    const R natural = R(s.t) * truth.w;
    const R bound = R(tol) * (1 + natural) + R(1e-14) * (1 + natural) +
                    64 * R(doubles::u) * (1 + magnitude(truth.y[3]) +
                                          magnitude(truth.y[4]));
    const double ratio = double(truth.apart(end) / bound);
    const double dear = larger(enough, UNAMPLIFIED);
    return ratio <= dear ? ratio : larger(dear, ratio / growth(q, s.t));
}

/* Any velocity of the centre and friction. */
void thrown(scene *s, const double *g)
{
    s->tol = 1.2 * g[24];
    s->t = std::sqrt(s->a / s->g) * std::pow(10, 3.5 * g[22] - 2.5);
    s->phi = 6 * g[18] - 3;
    s->psi = 6 * g[19] - 3;
    s->x = s->a * (6 * g[20] - 3);
    s->z = s->a * (6 * g[21] - 3);
    s->q[0] = 4 * g[26] - 2;
    s->q[1] = 4 * g[27] - 2;
    s->q[3] = std::pow(10, 9 * g[29] - 12);
}
} // namespace

void add_slides(std::vector<row> *rows)
{
    rows->push_back({"coin_slide_energy", "8 u of the terms", 1, false, nullptr,
                     energy<long double>, energy<quad>});
    rows->push_back({"coin_slide_velocity", "8 u of the terms", 1, false,
                     nullptr, velocity<long double>, velocity<quad>});
    rows->push_back({"coin_slide_advance",
                     "tol (1 + natural time) before amplification; slipping",
                     5, false, thrown, advance<long double>, advance<quad>});
}
