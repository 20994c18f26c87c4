/* SPDX-License-Identifier: MIT */
/* The equations of docs/physics.md in their textbook form, in numbers of 64
 * bits, each sum beside that of its terms' sizes.  No code of lib/. */
#ifndef ROLLCOIN_ADVERSARY_TRUTH_HPP
#define ROLLCOIN_ADVERSARY_TRUTH_HPP

#include <coin.h>

#include <algorithm>
#include <cmath>
#include <valarray>
#include <vector>

using real = long double;

constexpr real HALF_PI = 1.57079632679489661923132169163975144L;

/* A sum beside the sum of its terms' absolute values, which is what "8 u of
 * the terms" counts in. */
struct terms {
    real value = 0, size = 0;

    terms() = default;
    terms(real only) : value(only), size(std::fabs(only))
    {
    }
    terms(real whole, real of) : value(whole), size(of)
    {
    }
    terms &add(real term)
    {
        value += term;
        size += std::fabs(term);
        return *this;
    }
    terms &add(const terms &t, real factor)
    {
        value += factor * t.value;
        size += std::fabs(factor) * t.size;
        return *this;
    }
};
using list = std::vector<terms>;

inline terms over(const terms &a, const terms &b)
{
    const real value = a.value / b.value;
    return {value, (a.size + std::fabs(value) * b.size) / std::fabs(b.value)};
}
inline terms length(const terms &a, const terms &b)
{
    return {std::hypot(a.value, b.value), std::hypot(a.size, b.size)};
}

/* A coin at a moment: members as they are, and what every equation reads. */
struct moment {
    real M, a, g, IX, IZ, m, J, K, k1, k2, Mga;
    real theta, phi, psi, x, z, wX, wY, wZ;
    real s, c, T, sph, cph;

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
        s = std::sin(theta);
        c = std::cos(theta);
        T = s / c;
        sph = std::sin(phi);
        cph = std::cos(phi);
    }
};

/* The coin's frame, (7). */
struct frame {
    std::valarray<real> X, Y, Z;

    explicit frame(const moment &y)
    {
        X = {y.cph, 0, -y.sph};
        Y = {y.s * y.sph, y.c, y.s * y.cph};
        Z = {y.c * y.sph, -y.s, y.c * y.cph};
    }
};

inline terms dwX_of(const moment &y)
{
    return terms()
        .add(-y.K * y.wY * y.wZ / y.J)
        .add(-y.IX * y.wY * y.wY * y.T / y.J)
        .add(y.Mga * y.s / y.J); /* (14) */
}

/* In the order of the members of a state. */
inline list rates_of(const moment &y)
{
    return {
        y.wX,                                                     /* (17) */
        y.wY / y.c,                                               /* (18) */
        terms(y.wZ).add(y.wY * y.T),                              /* (19) */
        terms(-y.a * y.wZ * y.cph).add(y.a * y.wX * y.c * y.sph), /* (20) */
        terms(y.a * y.wZ * y.sph).add(y.a * y.wX * y.c * y.cph),  /* (20) */
        dwX_of(y),
        terms(y.wX * y.wY * y.T).add(y.k1 * y.wX * y.wZ), /* (15) */
        y.k2 * y.wX * y.wY,                               /* (16) */
    };
}

/* The square of lambda, (44). */
inline terms lambda2_of(const moment &y)
{
    return terms(y.Mga * y.c / y.J)
        .add(-(y.IX * (1 + 3 * y.T * y.T) + y.m) * y.wY * y.wY / y.J)
        .add(-(3 * y.IZ + y.m) * y.T * y.wY * y.wZ / y.J)
        .add(-y.k1 * y.K * y.wZ * y.wZ / y.J);
}

/* W of the law of a step: the fastest rate. */
inline real fastest(const moment &y)
{
    return std::sqrt((y.wX * y.wX + y.wY * y.wY) / (y.c * y.c) + y.wZ * y.wZ +
                     y.g / (y.a * y.c)); /* (47) */
}

/* ------------------------------------------------------------ what slows it */

/* What losses add to the rates, and their power. */
struct slowing {
    terms wX, wY, wZ, power;
};

struct losses {
    real damping, dry, viscous, layer, gap, rolling, spin, angular, soft;

    losses() = default;

    /* In units of mass M, length L, time T. */
    losses(const coin_losses &l, const coin_params &p, real M, real L, real T)
        : damping(l.damping), dry(l.dry / (M * L * L / T / T)),
          viscous(l.viscous / (M * L * L / T)),
          layer(l.layer / (M * L * L / std::sqrt(T))),
          gap(l.gap / (M * L * L / T)),
          rolling(l.rolling / (M * L * L / T / T)),
          spin(l.spin / (M * L * L / T)), angular(l.angular * T)
    {
        /* The softening that 0 stands for, or the least. */
        const real w = std::sqrt(real(p.gravity) / p.radius);
        const real least = l.soft > 0 ? w * 0x1p-30L : w / 1024;
        soft = std::max(real(l.soft), least) * T;
    }

    /* The torque of the contact over the rate of roll. */
    real grip(real roll, real c) const
    {
        const real rate = std::fabs(roll);
        return (dry + rolling * c) / std::sqrt(roll * roll + soft * soft) +
               viscous + layer * std::sqrt(rate) + gap / c;
    }

    /* Of a body I_X, I_Z, J, K. */
    slowing at(real IX, real IZ, real J, real K, real s, real c, real wX,
               real wY, real wZ) const
    {
        const real T = s / c, roll = wZ + wY * T;
        const real size = std::fabs(wZ) + std::fabs(wY * T);
        const terms Q(-roll * grip(roll, c),
                      size * (grip(roll, c) + layer * std::sqrt(size)));
        const terms fade(damping * std::fabs(roll), damping * size);
        const terms turn = terms(wY * c).add(-wZ * s);
        const real T2 = J * wX * wX + IX * wY * wY + K * wZ * wZ;
        const real w2 = IX * wX * wX + IX * wY * wY + IZ * wZ * wZ;
        slowing d;
        d.wX.add(fade, -wX).add(-angular * IX / J * wX);
        d.wY.add(Q, T / IX).add(turn, -spin * c / IX).add(fade, -wY);
        d.wY.add(-angular * wY);
        d.wZ.add(Q, 1 / K).add(turn, spin * s / K).add(fade, -wZ);
        d.wZ.add(-angular * IZ / K * wZ);
        d.power.add(fade, T2)
            .add(angular * w2)
            .add({spin * turn.value * turn.value - Q.value * roll,
                  spin * turn.size * turn.size + Q.size * size},
                 1);
        return d;
    }
};

/* The force of the table on a coin that rolls: R, N, F, of a body that losses
 * slow. */
struct table_force {
    terms R[3], normal, friction;

    table_force(const moment &y, const slowing &by = {})
    {
        const real Ma = y.M * y.a;
        const terms dwX = dwX_of(y).add(by.wX, 1);
        const terms e =
            terms(Ma * y.wX * y.wY * y.IZ / y.K).add(by.wZ, -Ma); /* (25) */
        const terms h = terms(-Ma * y.wX * y.wX * y.s)
                            .add(dwX, Ma * y.c)
                            .add(Ma * y.wY * y.wZ / y.c); /* (26) */
        normal = terms(y.M * y.g)
                     .add(-Ma * y.wX * y.wX * y.c)
                     .add(dwX, -Ma * y.s); /* (27) */
        friction = length(e, h);
        R[0].add(e, y.cph).add(h, y.sph); /* (28) */
        R[1] = normal;
        R[2].add(e, -y.sph).add(h, y.cph); /* (28) */
    }
};

#endif
