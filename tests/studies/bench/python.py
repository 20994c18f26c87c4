#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A second of a US quarter from Python: scipy's DOP853 on the textbook's
equations, and the binding, one call per frame, each at 1e-9.  As CSV: error,
and the least time of some runs [ns].

    PYTHONPATH=docs/examples/python/src python.py QUARTER.csv
"""
import csv
import math
import sys
import time

import numpy
import rollcoin as rc
from scipy.integrate import solve_ivp

TOL, FRAMES, RUNS = 1e-9, 60, 20
P = rc.disc(0.00567, 0.01213, 9.80665)
START = {"theta": 0.3, "wY": 5, "wZ": 40}
MEMBERS = "theta", "phi", "psi", "x", "z"


def rates(_, y):
    """(14)-(20) of a disc."""
    theta, phi, _, _, _, wX, wY, wZ = y
    a, g = P.radius, P.gravity
    s, c, sph, cph = (math.sin(theta), math.cos(theta), math.sin(phi),
                      math.cos(phi))
    t = s / c
    return (wX, wY / c, wZ + wY * t, a * (-wZ * cph + wX * c * sph),
            a * (wZ * sph + wX * c * cph),
            (-1.5 * wY * wZ - 0.25 * wY * wY * t + g / a * s) / 1.25,
            wX * wY * t + 2 * wZ * wX, 2 / 3 * wX * wY)


def by_scipy():
    end = solve_ivp(rates, (0, 1), [0.3, 0, 0, 0, 0, 0, 5, 40],
                    method="DOP853", rtol=TOL, atol=TOL).y[:5, -1]
    return end


def by_binding():
    s = rc.State(**START)
    for _ in range(FRAMES):
        rc.advance(s, P, 1 / FRAMES, TOL)
    return numpy.array([getattr(s, name) for name in MEMBERS])


def truth(path):
    """After a second: the row of that time."""
    with open(path, encoding="ascii") as lines:
        rows = list(csv.DictReader(l for l in lines if l[0] != "#"))
    row = next(r for r in rows if abs(float(r["t"]) - 1) < 1e-12)
    return numpy.array([float(row[name]) for name in MEMBERS])


def main(path):
    exact = truth(path)
    size = numpy.array([1, 1, 1, P.radius, P.radius])
    print("method,error,ns")
    for name, go in (("scipy's DOP853", by_scipy),
                     ("coin_advance from Python", by_binding)):
        least = math.inf
        for _ in range(RUNS):
            begin = time.perf_counter_ns()
            end = go()
            least = min(least, time.perf_counter_ns() - begin)
        error = abs((end - exact) / size).max()
        print(f"{name},{error:.2g},{least}")


main(*sys.argv[1:])
