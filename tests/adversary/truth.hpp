/* SPDX-License-Identifier: MIT */
/* The observables of docs/physics.md in their textbook form, each beside the
 * sum of its terms.  R is long double or __float128; no code of lib/. */
#ifndef ROLLCOIN_ADVERSARY_TRUTH_HPP
#define ROLLCOIN_ADVERSARY_TRUTH_HPP

#include "number.hpp"

/* A coin at a moment: members as they are, and what every equation reads. */
template <class R> struct moment {
    R M, a, g, IX, IZ, m, J, K, k1, k2, Mga;
    R theta, phi, psi, x, z, wX, wY, wZ;
    R s, c, T, sph, cph;

    template <class P, class S>
    moment(const P &p, const S &y)
        : M(p.mass), a(p.radius), g(p.gravity), IX(p.inertia_X),
          IZ(p.inertia_Z), theta(y.theta), phi(y.phi), psi(y.psi), x(y.x),
          z(y.z), wX(y.wX), wY(y.wY), wZ(y.wZ)
    {
        m = M * a * a;
        J = IX + m;
        K = IZ + m;
        k1 = IZ / IX;
        k2 = m / K;
        Mga = M * g * a;
        s = sine(theta);
        c = cosine(theta);
        T = s / c;
        sph = sine(phi);
        cph = cosine(phi);
    }
};

template <class R> terms<R> energy_of(const moment<R> &y)
{
    return terms<R>()
        .add(y.J * y.wX * y.wX / 2)
        .add(y.IX * y.wY * y.wY / 2)
        .add(y.K * y.wZ * y.wZ / 2)
        .add(y.Mga * y.c); /* (23) */
}

template <class R> terms<R> dwX_of(const moment<R> &y)
{
    return terms<R>()
        .add(-y.K * y.wY * y.wZ / y.J)
        .add(-y.IX * y.wY * y.wY * y.T / y.J)
        .add(y.Mga * y.s / y.J); /* (14) */
}

/* In the order of the members of a state. */
template <class R> void rates_of(const moment<R> &y, terms<R> d[8])
{
    d[0].add(y.wX);                                              /* (17) */
    d[1].add(y.wY / y.c);                                        /* (18) */
    d[2].add(y.wZ).add(y.wY * y.T);                              /* (19) */
    d[3].add(-y.a * y.wZ * y.cph).add(y.a * y.wX * y.c * y.sph); /* (20) */
    d[4].add(y.a * y.wZ * y.sph).add(y.a * y.wX * y.c * y.cph);  /* (20) */
    d[5] = dwX_of(y);
    d[6].add(y.wX * y.wY * y.T).add(y.k1 * y.wX * y.wZ); /* (15) */
    d[7].add(y.k2 * y.wX * y.wY);                        /* (16) */
}

template <class R> struct table_force {
    terms<R> Rx, normal, Rz;
    R along, across, friction, friction_size;
};

template <class R> table_force<R> force_of(const moment<R> &y)
{
    const R Ma = y.M * y.a;
    const terms<R> dwX = dwX_of(y);
    terms<R> e, h, N;
    e.add(Ma * y.wX * y.wY * y.IZ / y.K); /* (25) */
    h.add(-Ma * y.wX * y.wX * y.s)
        .add(dwX, Ma * y.c)
        .add(Ma * y.wY * y.wZ / y.c); /* (26) */
    N.add(y.M * y.g)
        .add(-Ma * y.wX * y.wX * y.c)
        .add(dwX, -Ma * y.s); /* (27) */
    table_force<R> f;
    f.Rx.add(e, y.cph).add(h, y.sph);  /* (28) */
    f.Rz.add(e, -y.sph).add(h, y.cph); /* (28) */
    f.normal = N;
    f.friction = root(e.value * e.value + h.value * h.value);
    f.friction_size = root(e.size * e.size + h.size * h.size);
    return f;
}

/* The square of lambda, (44). */
template <class R> terms<R> lambda2_of(const moment<R> &y)
{
    return terms<R>()
        .add(y.Mga * y.c / y.J)
        .add(-(y.IX * (1 + 3 * y.T * y.T) + y.m) * y.wY * y.wY / y.J)
        .add(-(3 * y.IZ + y.m) * y.T * y.wY * y.wZ / y.J)
        .add(-y.k1 * y.K * y.wZ * y.wZ / y.J);
}

/* W of the law of a step: the fastest rate. */
template <class R> R fastest(const moment<R> &y)
{
    return root((y.wX * y.wX + y.wY * y.wY) / (y.c * y.c) + y.wZ * y.wZ +
                y.g / (y.a * y.c)); /* (47) */
}

/* ---------------------------------------------------------- the integrals */

/* The four power series about upright, to the last term that counts. */
template <class R> struct upright_series {
    R Pe = 0, Po = 0, We = 0, Wo = 0;

    upright_series(R u, R kap)
    {
        R pe = 1, po = u, we = 1, wo = u;
        for (int n = 0; n < 100000; n += 2) {
            Pe += pe;
            Po += po;
            We += we;
            Wo += wo;
            if (magnitude(we) + magnitude(wo) < precision<R> / 16)
                break;
            pe *= u * u * (R(n) * (n - 1) + kap) / ((R(n) + 1) * (n + 2));
            po *= u * u * (R(n + 1) * n + kap) / ((R(n) + 2) * (n + 3));
            we *= u * u * (R(n) * (n + 1) + kap) / ((R(n) + 1) * (n + 2));
            wo *= u * u * (R(n + 1) * (n + 2) + kap) / ((R(n) + 2) * (n + 3));
        }
    }
};

/* The regular and the logarithmic solution about flat and their P, (36), (37).
 */
template <class R> struct flat_series {
    R R0, S0, PR, PS;

    flat_series(R v, R kap)
    {
        const R ln = logarithm(v);
        R r = 1, s = 0, power = 1;
        R sum_r = 0, sum_s = 0, slope_r = 0, slope_s = 0;
        for (int n = 0; n < 1000; ++n) {
            sum_r += r * power;
            sum_s += s * power;
            if (n > 0 && magnitude(n * (magnitude(r) + magnitude(s)) * power) <
                             precision<R> / 16)
                break;
            const R d = R(n + 1) * (n + 1);
            const R rho = (R(n) * (n + 1) + kap) / d;
            s = rho * s + r * ((2 * R(n) + 1) / d - 2 * rho / (n + 1));
            r *= rho;
            slope_r += (n + 1) * r * power;
            slope_s += (n + 1) * s * power;
            power *= v;
        }
        R0 = sum_r;
        S0 = sum_r * ln + sum_s;
        PR = -2 * v * (1 - v) * slope_r;
        PS = -2 * (1 - v) * (sum_r + v * slope_r * ln + v * slope_s);
    }
};

template <class R>
void integrals_upright(const moment<R> &y, terms<R> *KY, terms<R> *KZ)
{
    const upright_series<R> f(y.s, y.k1 * y.k2);
    const R p = y.wY * y.c;
    KY->add(f.We * p).add(-y.k1 * f.Po * y.wZ); /* (35) */
    KZ->add(f.Pe * y.wZ).add(-y.k2 * f.Wo * p); /* (35) */
}

template <class R>
void integrals_flat(const moment<R> &y, terms<R> *KY, terms<R> *KZ)
{
    const R sign = y.theta < 0 ? -1 : 1, wZ = sign * y.wZ, p = y.wY * y.c;
    const R half = sine((half_pi<R> - sign * y.theta) / 2);
    const R kap = y.k1 * y.k2;
    const flat_series<R> at(half * half, kap), up(R(0.5), kap);
    terms<R> al, be;
    al.add(y.k2 * p * at.S0 / 2).add(-wZ * at.PS / 2); /* (38) */
    be.add(wZ * at.PR / 2).add(-y.k2 * p * at.R0 / 2); /* (38) */
    KY->add(al, up.PR / y.k2).add(be, up.PS / y.k2);   /* (38) */
    KZ->add(al, sign * up.R0).add(be, sign * up.S0);   /* (38) */
}

/* K_Y, K_Z: the terms are those of (35) up to sin theta = 0.7 and those of
 * (38) beyond, as physics.md says. */
template <class R>
void integrals_of(const moment<R> &y, terms<R> *KY, terms<R> *KZ)
{
    if (magnitude(y.s) <= R(0.7))
        integrals_upright(y, KY, KZ);
    else
        integrals_flat(y, KY, KZ);
}

#endif
