/* SPDX-License-Identifier: MIT */
/* What slows a coin: the torques of docs/physics.md, each in time and as it
 * stands there, beside the sum of its terms. */
#ifndef ROLLCOIN_ADVERSARY_LOSSES_HPP
#define ROLLCOIN_ADVERSARY_LOSSES_HPP

#include "number.hpp"
#include "scene.hpp"

/* The losses of a scene: which, by the bits of steps, and how large, by q and
 * tol, in parts of the coin's own torques.  Bit 7 is soft; bit 8 angular, as
 * large as spin; bit 9 flat, by method. */
inline coin_losses losses_of(const scene &s)
{
    const double w = std::sqrt(s.g / s.a), torque = s.M * s.g * s.a;
    const double unit[] = {
        1,          torque, torque / w, torque / w / std::sqrt(w),
        torque / w, torque, torque / w, w};
    coin_losses l = {};
    for (int i = 0; i < 8; ++i)
        if (int(s.steps) >> i & 1)
            (i == 7 ? l.soft : (&l.damping)[i]) =
                unit[i] * (i == 7 ? s.tol : std::fabs(s.q[i / 2]));
    if (int(s.steps) >> 8 & 1)
        l.angular = w * std::fabs(s.q[3]);
    if (int(s.steps) >> 9 & 1)
        l.flat = std::fabs(s.method);
    return l;
}

/* A moment's rates by the losses, and the power. */
template <class R> struct slowing {
    terms<R> wX, wY, wZ, power;
};

template <class R> struct losses {
    R damping, dry, viscous, layer, gap, rolling, spin, angular, soft;

    losses() = default;

    /* In units of mass M, length L, time T. */
    template <class S>
    losses(const S &l, double least_soft, R M, R L, R T)
        : damping(l.damping), dry(R(l.dry) / (M * L * L / T / T)),
          viscous(R(l.viscous) / (M * L * L / T)),
          layer(R(l.layer) / (M * L * L / root(T))),
          gap(R(l.gap) / (M * L * L / T)),
          rolling(R(l.rolling) / (M * L * L / T / T)),
          spin(R(l.spin) / (M * L * L / T)), angular(R(l.angular) * T),
          soft((l.soft > least_soft ? R(l.soft) : R(least_soft)) * T)
    {
    }

    /* |Q| over the rate of roll, and the same where that is at most `size`. */
    R grip(R roll, R c) const
    {
        const R rate = magnitude(roll);
        return (dry + rolling * c) / root(roll * roll + soft * soft) + viscous +
               layer * root(rate) + gap / c;
    }

    /* Of a body I_X, I_Z, J, K.  Inline: most callers need no sizes, or no
     * power. */
    __attribute__((always_inline)) slowing<R> at(R IX, R IZ, R J, R K, R s, R c,
                                                 R wX, R wY, R wZ) const
    {
        const R T = s / c, roll = wZ + wY * T;
        const R size = magnitude(wZ) + magnitude(wY * T);
        const R Q = -roll * grip(roll, c);
        const R most = size * (grip(roll, c) + layer * root(size));
        const R fade = damping * magnitude(roll), fades = damping * size;
        const R wy = wY * c - wZ * s;
        const R turns = magnitude(wY * c) + magnitude(wZ * s);
        const R T2 = J * wX * wX + IX * wY * wY + K * wZ * wZ;
        slowing<R> d;
        const R aX = fade + angular * IX / J, aZ = fade + angular * IZ / K;
        const R all = angular * (IX * wX * wX + IX * wY * wY + IZ * wZ * wZ);
        d.wX = {-aX * wX, (fades + angular * IX / J) * magnitude(wX)};
        d.wY = {(Q * T - spin * wy * c) / IX - (fade + angular) * wY,
                (most * magnitude(T) + spin * turns * c) / IX +
                    (fades + angular) * magnitude(wY)};
        d.wZ = {(Q + spin * wy * s) / K - aZ * wZ,
                (most + spin * turns * magnitude(s)) / K +
                    (fades + angular * IZ / K) * magnitude(wZ)};
        d.power = {fade * T2 + spin * wy * wy - Q * roll + all,
                   fades * T2 + spin * turns * turns + most * size + all};
        return d;
    }
};

/* The softening that 0 stands for, or the least. */
inline double softening(const coin_losses &l, const coin_params &p)
{
    const double w = std::sqrt(p.gravity / p.radius);
    return l.soft > 0 ? w * 0x1p-30 : w / 1024;
}

#endif
