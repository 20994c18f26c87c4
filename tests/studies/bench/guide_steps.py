#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the tables on steps in guide.md and design.md.

usage:  python3 tests/studies/bench/guide_steps.py build/librollcoin.so [SEED]
        (after `make`; standard Python only; about a minute)

A row of the first tables holds one |dt| W, with W of Eq. (47) at its largest
along the motion.  Each of 1000 random coins moves for 4 natural units of time
by the method, and by coin_advance() at 1e-13.  The error is the largest
difference of theta, phi, psi, x/a, z/a at the end, per natural unit.
"""
import ctypes
import math
import random
import sys
import time
from ctypes import POINTER, byref, c_double, c_int32, c_uint64

MEMBERS = "theta phi psi x z wX wY wZ".split()
METHODS = "rk4", "rk8", "symplectic2", "symplectic4"
SPAN = 4.0
COINS = 1000
PARTS = 64  # of the span, where W is looked at


class Params(ctypes.Structure):
    _fields_ = [(n, c_double) for n in
                "mass radius gravity inertia_X inertia_Z".split()
                ] + [("reserved", c_double*3)]


class State(ctypes.Structure):
    _fields_ = [(n, c_double) for n in MEMBERS]


def load(path):
    lib = ctypes.CDLL(path)
    s, p = POINTER(State), POINTER(Params)
    lib.coin_params_ring.argtypes = [p] + [c_double]*4
    lib.coin_run.argtypes = [s, p, c_int32, c_double, c_uint64,
                             POINTER(c_uint64)]
    lib.coin_advance.argtypes = [s, p, c_double, c_double, POINTER(c_double)]
    lib.coin_energy.argtypes = [s, p]
    lib.coin_energy.restype = c_double
    lib.coin_integrals.argtypes = [s, p, POINTER(c_double)]
    return lib


def disc(lib):
    """M = a = g = 1."""
    p = Params()
    lib.coin_params_ring(byref(p), 1, 1, 0, 1)
    return p


def copy(s):
    return State(*(getattr(s, n) for n in MEMBERS))


def rate(s, p):
    """W of Eq. (47)."""
    c = math.cos(s.theta)
    return math.sqrt((s.wX**2 + s.wY**2)/c**2 + s.wZ**2
                     + p.gravity/(p.radius*c))


def fastest(lib, start, p, span):
    """The largest W over the span: looked for in ever finer parts of it."""
    part, begin = span/PARTS, copy(start)
    for _ in range(6):
        seen, s = [(rate(begin, p), copy(begin))], copy(begin)
        for _ in range(PARTS):
            assert lib.coin_advance(byref(s), byref(p), part, 1e-10, None) == 0
            seen.append((rate(s, p), copy(s)))
        top = max(range(PARTS + 1), key=lambda i: seen[i][0])
        begin = seen[max(top - 1, 0)][1]
        part *= min(top + 1, PARTS, 2)/PARTS
    return seen[top][0]


def error(lib, start, p, method, dt, steps):
    """Error after so many steps, infinity if they were refused."""
    s, true = copy(start), copy(start)
    if lib.coin_run(byref(s), byref(p), method, dt, steps, None) < 0:
        return math.inf
    assert lib.coin_advance(byref(true), byref(p), dt*steps, 1e-13, None) == 0
    return max(abs(getattr(s, n) - getattr(true, n))/scale
               for n, scale in zip(MEMBERS, (1, 1, 1, p.radius, p.radius)))


def random_coins(lib, seed):
    """(start, parameters, largest W) of rings in every state of motion."""
    rng = random.Random(seed)
    for _ in range(COINS):
        p, s = Params(), State()
        lib.coin_params_ring(byref(p), 1, 1, rng.random(), 1)
        s.theta = rng.uniform(-1.2, 1.2)
        s.wX, s.wY, s.wZ = (rng.uniform(-w, w) for w in (1, 1.5, 2))
        yield s, p, fastest(lib, s, p, SPAN)


def short(x):
    return "refused" if math.isinf(x) else "%.0e" % x


def table(lib, coins, method, rows):
    print("\n%s: |dt| W | median | 9 of 10 | 99 of 100 | worst" %
          METHODS[method])
    for dtW in rows:
        errors = []
        for start, p, W in coins:
            steps = math.ceil(SPAN*W/dtW)
            errors.append(error(lib, start, p, method, SPAN/steps, steps)/SPAN)
        errors.sort()
        cells = (short(errors[int(COINS*q)]) for q in (.5, .9, .99))
        print(" | ".join(["%g" % dtW, *cells, short(errors[-1])]))


def apart(s, t, p):
    """The largest difference of two states, in natural units."""
    T = math.sqrt(p.radius/p.gravity)
    return max(abs(getattr(s, n) - getattr(t, n))*scale
               for n, scale in zip(MEMBERS, [1]*3 + [1/p.radius]*2 + [T]*3))


def returns(lib, coins, name, rows, go):
    """go() forward and back over the span: the distance from the start."""
    print("\n%s, forward and back: median | 9 of 10 | 99 of 100" % name)
    for setting in rows:
        errors = []
        for start, p, W in coins:
            s = copy(start)
            done = (go(s, p, W, setting, SPAN) >= 0
                    and go(s, p, W, setting, -SPAN) >= 0)
            errors.append(apart(s, start, p)/SPAN if done else math.inf)
        errors.sort()
        print(" | ".join(["%g" % setting] + [
            short(errors[int(COINS*q)]) for q in (.5, .9, .99)]))


def round_trips(lib, coins):
    for m, rows in enumerate(((0.1, 0.2, 0.35), (0.2, 0.35, 0.7), (0.08,),
                              (0.16,))):
        def run(s, p, W, dtW, t):
            steps = math.ceil(SPAN*W/dtW)
            return lib.coin_run(byref(s), byref(p), m, t/steps, steps, None)
        returns(lib, coins, METHODS[m], rows, run)

    def advance(s, p, _, tol, t):
        return lib.coin_advance(byref(s), byref(p), t, tol, None)
    returns(lib, coins, "coin_advance", (1e-6, 1e-9, 1e-12), advance)


def quarter(lib):
    """A US quarter for one second, by steps per second."""
    p, s = Params(), State(theta=0.3, wY=5, wZ=40)
    lib.coin_params_ring(byref(p), 0.00567, 0.01213, 0, 9.80665)
    W = fastest(lib, s, p, 1)
    print("\nquarter, W = %.1f/s: steps per second | |dt| W | %s" %
          (W, " | ".join(METHODS)))
    for steps in (60, 120, 240, 500, 1000, 2000):
        print(" | ".join(["%d" % steps, "%.2f" % (W/steps)] + [
            short(error(lib, s, p, m, 1/steps, steps)) for m in range(4)]))


def least(run):
    """The shortest of many runs, in ns: the others were disturbed."""
    best = math.inf
    for _ in range(3000):
        begin = time.perf_counter_ns()
        run()
        best = min(best, time.perf_counter_ns() - begin)
    return best


def times(lib):
    """ns per step, and per unit of time by coin_advance(): scene generic."""
    p, start = disc(lib), State(theta=0.5, wX=0.1, wY=0.8, wZ=1.2)
    print("\nns per step, in runs of 500")
    for m in range(4):
        s = copy(start)
        print("%s %.0f" % (METHODS[m], least(lambda: lib.coin_run(
            byref(s), byref(p), m, 0.01, 500, None))/500))
    print("\ncoin_advance: tol | ns per natural unit of time")
    for tol in (1e-3, 1e-6, 1e-9, 1e-12):
        s = copy(start)
        print("%.0e | %.0f" % (tol, least(lambda: lib.coin_advance(
            byref(s), byref(p), 20, tol, None))/20))


def drops(lib):
    """Through a nearly flat pass and up again, ever closer to the table."""
    p, span = disc(lib), 5.4
    print("\ncoin_advance at 1e-9: eps | us | energy error | phi/(pi sqrt 5) "
          "| steps of rk8 before none is refused")
    for eps in (1e-2, 1e-3, 1e-4, 1e-8, 1e-14):
        start = State(theta=0.3, wY=eps, wZ=eps)
        E = lib.coin_energy(byref(start), byref(p))
        s = copy(start)
        lib.coin_advance(byref(s), byref(p), span, 1e-9, None)
        turn = s.phi/(math.pi*math.sqrt(5))
        lost = lib.coin_energy(byref(s), byref(p))/E - 1
        ns = least(lambda: lib.coin_advance(
            byref(copy(start)), byref(p), span, 1e-9, None))
        steps = 2**8 if eps >= 1e-4 else 0
        while steps and error(lib, start, p, 1, span/steps, steps) == math.inf:
            steps = int(steps*1.1)
        print("%.0e | %.0f | %.0e | %.9f | %d" % (
            eps, ns/1e3, lost, turn, steps))


def long_runs(lib):
    """A million steps of 0.05: what becomes of the constants."""
    p, K, K0 = disc(lib), (c_double*2)(), (c_double*2)()
    print("\n1e6 steps of 0.05: largest energy error, in the first 1000 | "
          "in all | K_Y | K_Z at the end")
    for m in range(4):
        s = State(theta=0.5, wX=0.1, wY=0.8, wZ=1.2)
        E, worst = lib.coin_energy(byref(s), byref(p)), []
        lib.coin_integrals(byref(s), byref(p), K0)
        for part in [1]*1000 + [999]*1000:
            lib.coin_run(byref(s), byref(p), m, 0.05, part, None)
            worst.append(abs(lib.coin_energy(byref(s), byref(p))/E - 1))
        lib.coin_integrals(byref(s), byref(p), K)
        print("%s %.0e | %.0e | %.0e | %.0e" % (
            METHODS[m], max(worst[:1000]), max(worst),
            abs(K[0]/K0[0] - 1), abs(K[1]/K0[1] - 1)))


def main(path, seed=1):
    lib = load(path)
    coins = list(random_coins(lib, int(seed)))
    table(lib, coins, 0, (0.05, 0.1, 0.2, 0.35, 0.7, 1.2))
    table(lib, coins, 1, (0.1, 0.2, 0.35, 0.7, 1, 1.2))
    table(lib, coins, 2, (0.01, 0.03, 0.08, 0.16))
    table(lib, coins, 3, (0.05, 0.1, 0.16, 0.3))
    round_trips(lib, coins)
    quarter(lib)
    times(lib)
    drops(lib)
    long_runs(lib)


main(*sys.argv[1:])
