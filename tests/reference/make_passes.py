#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Coins that nearly fall flat, and coins that do: passes.csv and falls.csv.

passes.csv: a ring of inner radius b, M = a = g = 1, starts at rest at theta =
0.3 with wY = wZ = s, passes the table at the distance d = pi/2 - theta, and is
back at theta = 0.3 and at rest after the time t: the state then.  By the
Taylor series of make_reference.py, and t and phi again by quadrature over the
energy, which must agree to 1e-20.

falls.csv: without momentum, wY = wZ = 0, nothing keeps it from the table,
which it reaches after t at theta = side pi/2.  A quadrature; the coin starts
with wX.

usage: make_passes.py [FOLDER]    (needs python3-mpmath)
"""
import pathlib
import sys

from mpmath import mp, mpf

import make_reference
from make_reference import number

HERE = pathlib.Path(__file__).resolve().parent
THETA = 0.3
STATE = "theta phi psi x z wX wY wZ".split()
DIGITS, ORDER = 45, 52


def body(b):
    """I_X, J, k1, k2 of physics.md, M = a = 1."""
    IX = (1 + mpf(b) ** 2) / 4
    IZ = 2 * IX
    return IX, IX + 1, mpf(2), 1 / (IZ + 1)


def motion(b, s, time):
    """The state after a time, and the turning points on the way."""
    turns = []
    state, = make_reference.motion((b, THETA, 0.0, s, s), [time], DIGITS, ORDER,
                                   turns)
    return state, turns


def by_quadrature(b, s, d):
    """t and phi of the pass: twice the way from THETA to pi/2 - d, where the
    energy leaves nothing for wX.  From both ends by squares, which take the
    root out, and from d on exponentially, as the integrand does."""
    IX, J, k1, k2 = body(b)
    K = J + IX
    start = mpf(THETA)
    Pe, Po, We, Wo = make_reference.phi_matrix(k1 * k2, mp.sin(start))
    p0 = s * mp.cos(start)
    KY, KZ = We * p0 - k1 * Po * s, Pe * s - k2 * Wo * p0

    def rates(delta):
        """wX, phi' at a distance from flat."""
        Pe, Po, We, Wo = make_reference.phi_matrix(k1 * k2, mp.cos(delta))
        p, wZ = KY * Pe + k1 * KZ * Po, KZ * We + k2 * KY * Wo
        c = mp.sin(delta)
        V = IX * p * p / (2 * c * c) + K * wZ * wZ / 2 + c
        return V, p / (c * c)

    E = rates(mp.pi / 2 - start)[0]
    top = mp.pi / 2 - start

    def along(u):
        """delta = d (top/d)^(sin^2 u): roots at both ends, and a factor per
        length of u."""
        ratio = mp.log(top / d)
        delta = d * mp.exp(ratio * mp.sin(u) ** 2)
        V, dphi = rates(delta)
        dt = ratio * delta * mp.sin(2 * u) / mp.sqrt(2 * (E - V) / J)
        return dt, dt * dphi

    both = mp.quad(lambda u: 2 * mp.mpc(*along(u)),
                   mp.linspace(0, mp.pi / 2, 5), method="gauss-legendre")
    return both.real, both.imag


def write(folder, name, head, rows):
    text = "\n".join([head] + [",".join(row) for row in rows]) + "\n"
    (folder / name).write_text(text)


def passes():
    for b in (0.0, 0.5, 1.0):
        for s in [2e-2] + [10.0 ** -k for k in range(2, 14)]:
            _, turns = motion(b, s, 6.0)
            d = mp.pi / 2 - turns[0][1]
            t = turns[1][0]
            # The state at the double next to t, as a test can ask for it.
            time = float(t)
            end, _ = motion(b, s, time)
            yield b, s, d, time, t, turns[1], end
            print(b, s, number(d), flush=True)


def fall(b, theta, wX):
    """Whether it falls to the side of wX or turns first is up to the caller:
    wX is never against gravity, or enough to cross the top."""
    IX, J, _, _ = body(b)
    theta, wX = mpf(theta), mpf(wX)
    side = 1 if (wX or theta) > 0 else -1
    flat = side * mp.pi / 2

    def speed(gone):
        """|wX| after a way; cos theta - cos x without cancellation."""
        drop = 2 * mp.sin(theta + gone / 2) * mp.sin(gone / 2)
        return mp.sqrt(wX ** 2 + 2 / J * drop)

    # The way as v^2: takes a root at the start out.
    way = flat - theta
    t = mp.quad(lambda v: 2 * v * abs(way) / speed(way * v * v),
                mp.linspace(0, 1, 9))
    return side, t


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    mp.dps = 40
    starts = [(0.0, 0.3, 0.0), (1.0, 0.3, 0.0), (0.5, 0.3, 0.0),
              (0.0, -0.3, 0.0), (0.0, 0.3, 0.25), (0.0, 0.3, -0.5),
              (0.7, -1.2, 1.5), (0.0, 1e-3, 0.0), (0.0, 1.5, 0.0),
              (0.0, 1.57, 2.0), (0.0, 0.0, 1e-9)]
    rows = []
    for start in starts:
        side, t = fall(*start)
        rows.append([repr(v) for v in start] + [str(side), number(t)])
    write(folder, "falls.csv", "# see make_passes.py\nb,theta,wX,side,t", rows)

    rows = []
    for b, s, d, time, t, turn, end in passes():
        mp.dps = DIGITS
        t2, phi2 = by_quadrature(b, mpf(s), d)
        print("   ", mp.nstr(t2 - t, 3), mp.nstr(phi2 - turn[2], 3))
        assert abs(t2 - t) < 1e-20 and abs(phi2 - turn[2]) < 1e-20
        rows.append([repr(b), repr(s), repr(time), number(d)] +
                    [number(end[n]) for n in STATE])
    write(folder, "passes.csv", "# see make_passes.py\n"
          "b,s,t,d,theta,phi,psi,x,z,wX,wY,wZ", rows)


main()
