#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""turns.csv: circles by their lean and radius, or by their speed and radius.

Rows with a lean are what coin_steady_turn() is asked, those with lean 0 what
coin_steady_ride() is asked.  The answer is in the last columns: the rates, and
the lean; wY_lean and wZ_lean are their slopes along the lean at that radius,
over the rates.

The coin is a body of vectors (make_observables.py): Newton's and Euler's laws
and no slip, solved for the accelerations.  Of a coin that leans, turns about
the vertical at a rate n and whose centre moves at the speed v, the lean must not
accelerate.  That is one equation, solved in 40 digits: for n, with v = n times
the radius, or for the lean, with n = v over the radius.

usage: make_turns.py [FILE]    (needs python3-mpmath)
"""
import pathlib
import random
import sys

from mpmath import mp, mpf

from make_observables import BODIES, PARAMS, UP, Coin, dot, write

mp.dps = 40
COLUMNS = PARAMS + "lean speed circle theta wY wZ wY_lean wZ_lean".split()


class Still(Coin):
    """Without the accelerations."""

    def solve(self):
        pass


def riding(params, theta, n, v):
    """The rates of the coin at that lean and rate of turning, its centre at
    that speed, to the side that makes wY wZ theta positive."""
    still = Still(params, [theta] + [0] * 7)
    rolls = Still(params, [theta] + [0] * 6 + [1])
    wZ = v / mp.sqrt(dot(rolls.v, rolls.v)) * (1 if theta > 0 else -1)
    return n * dot(UP, still.e[1]), wZ


def fall(params, theta, n, v):
    """The acceleration of the lean away from upright."""
    rates = riding(params, theta, n, v)
    coin = Coin(params, [theta, 0, 0, 0, 0, 0, *rates])
    return coin.spin_rates()[0] * (1 if theta > 0 else -1)


def root(f, low, high):
    """Of an increasing function between two positive numbers: by their
    geometric mean until they are close, then by secants."""
    while high > 1.1 * low:
        middle = mp.sqrt(low * high)
        low, high = (middle, high) if f(middle) < 0 else (low, middle)
    at = mp.findroot(f, (low, high), solver="anderson", tol=1e-70, verify=False)
    assert low <= at <= high
    return at


def turn(params, theta, radius):
    """The rates: a faster turn lifts the coin."""
    unit = mp.sqrt(mpf(params[2]) / params[1])
    n = unit * root(
        lambda n: -fall(params, theta, n * unit, n * unit * radius) / unit**2,
        mpf(10) ** -20, mpf(10) ** 20)
    return riding(params, theta, n, n * radius)


def ride(params, speed, radius):
    """The lean: a greater one lets the coin fall."""
    speed, radius = mpf(speed), mpf(radius)
    return root(lambda theta: fall(params, theta, speed / radius, speed) *
                params[1] / params[2], mpf(10) ** -20,
                mp.pi / 2 * (1 - mpf(10) ** -20))


def slopes(params, theta, radius, wY, wZ):
    """d(ln wY)/dtheta and d(ln wZ)/dtheta at one radius."""
    h = mpf(10) ** -15 * min(theta, mp.pi / 2 - theta)
    up, down = turn(params, theta + h, radius), turn(params, theta - h, radius)
    return [(a - b) / (2 * h) / w for a, b, w in zip(up, down, (wY, wZ))]


def questions(params, rng):
    """(lean, speed, radius): ordinary, next to upright, next to flat, small
    and large circles; a spin that hardly leans, B = 1 in (94)."""
    a, g, IX = params[1], params[2], params[3]
    unit = (g * a) ** 0.5
    for k in range(5):
        size = 10 ** rng.uniform(-2, 2)
        yield rng.choice((-1, 1)) * rng.uniform(0.05, 1.5), 0, a * size
        yield 0, unit * 10 ** rng.uniform(-1, 1), a * size
    for lean in (1e-9, -1e-4, -1.57, 1.5707963):
        yield lean, 0, a * 10 ** rng.uniform(-3, 3)
    yield 0, unit * 1e-3, a * 1e3
    yield 0, unit * 1e3, a * 1e2
    critical = (params[0] * g * a / IX) ** 0.5
    for part in (0.9, 1, 1 + 1e-6):
        yield 0, 1e-6 * a * critical * part, 1e-6 * a


def main():
    out = sys.argv[1] if len(sys.argv) > 1 else (
        pathlib.Path(__file__).resolve().parent / "turns.csv")
    rng, rows = random.Random(93), []
    for params in BODIES:
        for lean, speed, radius in questions(params, rng):
            theta = mpf(lean) if lean else ride(params, speed, radius)
            wY, wZ = turn(params, theta, mpf(radius))
            if not lean:
                assert abs(abs(wZ) * params[1] / mpf(speed) - 1) < 1e-30
            rows.append(list(params) + [lean, speed, radius, theta, wY, wZ] +
                        slopes(params, theta, mpf(radius), wY, wZ))
    write(out, "inputs are exact binary64 numbers; see make_turns.py",
          COLUMNS, rows)


main()
