#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""wobbles.csv: coins nudged off steady motions, at far times.

Each steady motion obeys Eq. (39) to a rounding of wY.  A state at a far time is
found as in make_orbits.py, but no quadrature checks the period: it would lose
the digits of a swing so small.  After the period the lean must be that of the
start to 1e-40.  The last motion is that slow circle whose swing has the period
of its heading.

usage: make_wobbles.py [FILE]    (needs python3-mpmath)
"""
import pathlib
import sys

from mpmath import mp, mpf, mpc

import make_orbits

FAR = (100, 1000, 7000)
# inner radius, lean, wZ, which root of (39), nudges of theta, wX, wY, wZ
MOTIONS = (
    (0, 0, 1, 0, 1e-3, 0, 1e-3, 1e-3),
    (0, 0.4, 1, 1, 7e-4, -5e-4, 6e-4, 4e-4),
    (1, 1.2, 2, 1, -1e-4, 1e-4, 1e-4, 1e-4),
    (0, 0.4, None, 1, 2e-4, -1e-4, 1e-4, 1e-4),
)


def circle(b, theta, wZ, root):
    """wY of (39) and lambda^2 of (44), M = a = g = 1; root 1 is the slow one
    and 0 a roll."""
    IX = (1 + mpf(b) ** 2) / 4
    IZ, s, c = 2 * IX, mp.sin(theta), mp.cos(theta)
    T = s / c
    q = (-(IZ + 1) * wZ - mp.sqrt(((IZ + 1) * wZ) ** 2 + 4 * IX * T * s)) / 2
    wY = mpf(0) if root == 0 else -s / q if root > 0 else q / (IX * T)
    L = (c - (IX * (1 + 3 * T * T) + 1) * wY ** 2
         - (3 * IZ + 1) * T * wY * wZ - IZ / IX * (IZ + 1) * wZ ** 2)
    return wY, L / (IX + 1)


def in_resonance(theta):
    def beside(wZ):
        wY, L = circle(0, theta, wZ, 1)
        return L + (wY / mp.cos(theta)) ** 2
    return mp.findroot(beside, (0.5, 0.6))


def main():
    mp.dps = make_orbits.DIGITS
    path = sys.argv[1] if len(sys.argv) > 1 else (
        pathlib.Path(__file__).resolve().parent / "wobbles.csv")
    with open(path, "w") as f:
        f.write("# nudged steady motions, M = a = g = 1, pose 0 at t = 0: "
                "see make_wobbles.py\n")
        f.write("inner,theta0,wY0,wZ0,theta1,wX1,wY1,wZ1,"
                "t,theta,phi,psi,x,z,wX,wY,wZ\n")
        for b, theta, wZ, root, *nudge in MOTIONS:
            wZ = float(in_resonance(theta) if wZ is None else wZ)
            wY = float(circle(b, mpf(theta), mpf(wZ), root)[0])
            start = [theta + nudge[0], nudge[1], wY + nudge[2], wZ + nudge[3]]
            scene = ["", 1.0, 1.0, float(b), 1.0, *map(float, start), [], ""]
            T, end, low, high = make_orbits.period_of("", scene, False)
            turn = mp.expjpi(end[4] / mp.pi)
            fixed = mpc(end[7], end[6]) / (1 - turn)
            for t in FAR:
                n = mp.floor(t / T)
                th, wX, wY1, wZ1, phi, psi, x, z = make_orbits.integrate(
                    scene, [t - n * T])[0]
                at = fixed + mp.expjpi(n * end[4] / mp.pi) * (mpc(z, x) - fixed)
                row = [mpf(b), mpf(theta), mpf(wY), mpf(wZ)] + [
                    mpf(v) for v in scene[5:9]] + [
                    mpf(t), th, phi + n * end[4], psi + n * end[5], at.imag,
                    at.real, wX, wY1, wZ1]
                f.write(",".join(make_orbits.out(v) for v in row) + "\n")
                f.flush()


if __name__ == "__main__":
    main()
