#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""flats.csv: coins that pass the table closely, at times in and after a pass.

A ring of inner radius b, M = a = g = 1, pose 0, starts with wY such that its
momentum about the vertical nearly vanishes where it would lie flat: it passes
the table at the distance pi/2 - |theta| = d, drawn from 1e-2 to 1e-6.  Each
start has four times within its first pass, of which one is the middle, and two
long after, one of them before the start.  W is the fastest rate of Eq. (47) on
the way: that in the middle of the pass.  By the Taylor series of
make_reference.py in 30 digits; for every fourth start a series of other order
and digits must agree to 1e-18.

usage: make_flats.py [FILE]    (needs python3-mpmath)
"""
import pathlib
import random
import sys
from decimal import Decimal

from mpmath import mp, mpf, nstr

import make_reference

HERE = pathlib.Path(__file__).resolve().parent
STARTS = 24
STATE = "theta phi psi x z wX wY wZ".split()


def spin(b, theta, wX, wZ, far):
    """wY for a pass at a distance of about far, on the side of wX."""
    side = 1 if wX > 0 else -1
    IX = (1 + mpf(b) ** 2) / 4
    J, k1, k2 = IX + 1, mpf(2), 1 / (2 * IX + 1)
    Pe, Po, We, Wo = make_reference.phi_matrix(k1 * k2, mp.sin(theta))
    Pe1, Po1, _, _ = make_reference.phi_matrix(k1 * k2, 1 - mpf(10) ** -20)

    def at_flat(p):
        KY, KZ = We * p - k1 * Po * wZ, Pe * wZ - k2 * Wo * p
        return KY * Pe1 + side * k1 * KZ * Po1

    # p of the start is linear in p there.
    none, slope = at_flat(mpf(0)), at_flat(mpf(1)) - at_flat(mpf(0))
    wanted = far * abs(wX) * mp.sqrt(J / IX)
    return float((wanted - none) / slope / mp.cos(theta))


def first_pass(start):
    """When it passes the table, how far from it, and how fast."""
    turns = []
    make_reference.motion(start, [8.0], turns=turns)
    turn = next(t for t in turns if mp.pi / 2 - abs(t[1]) < 0.02)
    time = float(turn[0])
    y = make_reference.motion(start, [time])[0]
    d = mp.pi / 2 - abs(y["theta"])
    W = mp.sqrt((y["wX"] ** 2 + y["wY"] ** 2) / mp.sin(d) ** 2)
    return time, d, W


def rounded(v, W):
    """To 1e-17 W: the orbits' bound is above 4e-16 W."""
    places = int(mp.ceil(17 - mp.log10(W)))
    number = Decimal(int(mp.nint(v * 10 ** places))).scaleb(-places)
    return f"{number.normalize():f}"


def rows(r, i):
    far = 10 ** -(2 + 4 * i / (STARTS - 1))
    b, theta = r.uniform(0, 1), r.uniform(-1, 1)
    wX = r.choice((-1, 1)) * r.uniform(0.6, 2)
    wZ = r.uniform(-0.6, 0.6)
    start = (b, theta, wX, spin(b, theta, wX, wZ, far), wZ)
    middle, d, W = first_pass(start)
    near = [float(middle + k / W) for k in (-1, 0, 2, 100)]
    back = (b, theta, -wX, start[3], wZ)
    ahead = make_reference.motion_twice(start, near + [20.0], STATE[:5],
                                        i % 4 == 0)
    mirror = make_reference.motion(back, [15.0])[0]
    for name in ("wX", "phi", "psi", "x"):
        mirror[name] = -mirror[name]
    print(i, nstr(d, 3), nstr(W, 3), middle, flush=True)
    for t, y in zip(near + [20.0, -15.0], ahead + [mirror]):
        yield ([repr(v) for v in start] + [nstr(d, 6), nstr(W, 6), repr(t)] +
               [rounded(y[n], W) for n in STATE])


def main():
    mp.dps = 40
    r = random.Random(2024)
    out = sys.argv[1] if len(sys.argv) > 1 else HERE / "flats.csv"
    lines = ["# coins that pass the table closely: see make_flats.py",
             ",".join(["b", "theta0", "wX0", "wY0", "wZ0", "d", "W", "t"] +
                      STATE)]
    for i in range(STARTS):
        lines += [",".join(row) for row in rows(r, i)]
    pathlib.Path(out).write_text("\n".join(lines) + "\n")


main()
