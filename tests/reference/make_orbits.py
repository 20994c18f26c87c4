#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""orbits.csv: periods of named scenes, and where they are at far times.

The period is the way from one turning point to the next but one, found by the
Taylor series of make_reference.py.  A quadrature over the lean, Eq. (55), with
hypergeometric functions for the linear pair must give the same period, heading
and roll to 1e-25.  A state at a far time t = n period + r is that at r, turned
and moved n times as the first period turned and moved it: heading and roll
plus n times the period's, and the path turned about its fixed point.  By 60
digits; t is an exact binary64 number, in the scene's units, at or next to
1000 and 1e6 natural units.

usage: make_orbits.py [FILE]    (needs python3-mpmath)
"""
import pathlib
import sys

from mpmath import mp, mpf, mpc

import make_reference
from make_reference import number

HERE = pathlib.Path(__file__).resolve().parent
DIGITS, ORDER = 60, 72
SCENES = "generic wobble ring quarter negative si_washer ring_b05 nearflat".split()
FAR = (1e3, 1e6, -1e6)


def quadrature(scene, low, high):
    """Period, heading and roll from theta = low to high and back."""
    _, M, a, b, g, th0, wX0, wY0, wZ0 = [mpf(v) if v != "" else v
                                         for v in scene[:9]]
    IX = M * (a * a + b * b) / 4
    IZ, m = 2 * IX, M * a * a
    J, K, k1, k2 = IX + m, IZ + m, IZ / IX, m / (IZ + m)

    def basis(theta):
        return make_reference.phi_matrix(k1 * k2, mp.sin(theta))

    Pe, Po, We, Wo = basis(th0)
    p0 = wY0 * mp.cos(th0)
    KY, KZ = We * p0 - k1 * Po * wZ0, Pe * wZ0 - k2 * Wo * p0

    def pair(theta):
        Pe, Po, We, Wo = basis(theta)
        return KY * Pe + k1 * KZ * Po, KZ * We + k2 * KY * Wo

    def V(theta):
        p, wZ = pair(theta)
        c = mp.cos(theta)
        return IX * p * p / (2 * c * c) + K * wZ * wZ / 2 + M * g * a * c

    E = V(th0) + J * wX0 ** 2 / 2
    mid, half = (high + low) / 2, (high - low) / 2
    last = None
    n = 64
    while True:
        sums = [mpf(0)] * 3
        for i in range(n):
            alpha = mp.pi * (i + mpf(1) / 2) / n
            theta = mid - half * mp.cos(alpha)
            p, wZ = pair(theta)
            s, c = mp.sin(theta), mp.cos(theta)
            weight = half * mp.sin(alpha) / mp.sqrt(2 * (E - V(theta)) / J)
            for k, rate in enumerate((1, p / c ** 2, wZ + p * s / c ** 2)):
                sums[k] += weight * rate
        now = [2 * mp.pi / n * v for v in sums]
        if last and max(abs(x - y) for x, y in zip(now, last)) < mpf(10) ** -25:
            return now
        last, n = now, 2 * n


def integrate(scene, times, turns=None):
    N = make_reference.Num(DIGITS)
    ys = make_reference.integrate(scene, DIGITS, ORDER, times, turns=turns)
    return [[N.out(v) for v in y] for y in ys]


def period_of(name, scene, compare=True):
    """Period, state after one, lowest and highest lean; compare with the
    quadrature."""
    turns = []
    unit = mp.sqrt(mpf(scene[2]) / mpf(scene[4]))
    integrate(scene, [15 * unit], turns)
    T = turns[2][0] - turns[0][0]
    low, high = sorted(t[1] for t in turns[:2])
    end = integrate(scene, [T])[0]
    assert abs(end[0] - mpf(scene[5])) < mpf(10) ** -40, name
    if compare:
        mp.dps = 32
        want = quadrature(scene, low, high)
        mp.dps = DIGITS
        for got, by in zip((T, end[4], end[5]), want):
            assert abs(got - by) < mpf(10) ** -24 * abs(by), (name, got, by)
    return T, end, low, high


def main():
    mp.dps = DIGITS
    scenes = make_reference.scenes()
    path = sys.argv[1] if len(sys.argv) > 1 else HERE / "orbits.csv"
    with open(path, "w") as f:
        f.write("# the orbits of named scenes: see make_orbits.py; scene is a"
                " number, in this order:\n# " + " ".join(SCENES) + "\n")
        f.write("scene,period,heading,roll,theta_min,theta_max,"
                "t,theta,phi,psi,x,z,wX,wY,wZ\n")
        for which, name in enumerate(SCENES):
            scene = scenes[name]
            # In nearflat the rule would need 1e4 points.
            T, end, low, high = period_of(name, scene, name != "nearflat")
            unit = mp.sqrt(mpf(scene[2]) / mpf(scene[4]))
            turn = mp.expjpi(end[4] / mp.pi)
            shift = mpc(end[7], end[6])  # z + i x after a period
            fixed = shift / (1 - turn)
            for far in FAR:
                t = mpf(float(far * unit))
                n = mp.floor(t / T)
                th, wX, wY, wZ, phi, psi, x, z = integrate(
                    scene, [t - n * T])[0]
                at = fixed + mp.expjpi(n * end[4] / mp.pi) * (mpc(z, x) - fixed)
                row = [T, end[4], end[5], low, high, t, th, phi + n * end[4],
                       psi + n * end[5], at.imag, at.real, wX, wY, wZ]
                f.write(",".join([str(which)] + [number(v) for v in row]) + "\n")
                f.flush()


if __name__ == "__main__":
    main()
