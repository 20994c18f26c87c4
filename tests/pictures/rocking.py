# SPDX-License-Identifier: MIT
"""A nickel that rocks to rest on its edge, against the pendulum that a coin on
one rim is, (118), and Housner's ratio, (128)."""
import bisect
import math

from forms import near

UNIT = math.sqrt(0.010605/9.80665)
H = 1.95/2/10.605
IX = 1/4 + H*H/3
J, R, ALPHA = IX + 1 + H*H, math.hypot(1, H), math.atan(H)
RATIO = (IX + 1 - H*H)/(IX + 1 + H*H)
STANDS = H/100


def fall(least, x, parts=200):
    """The time from rest at `least` short of balance to x: J x'' = R sin x.  By
    Simpson's rule in the root of x - least."""
    end = math.sqrt(x - least)

    def slowness(u):
        if u == 0:
            return 2*math.sqrt(J/(2*R*math.sin(least)))
        above = 2*math.sin(least + u*u/2)*math.sin(u*u/2)
        return 2*u*math.sqrt(J/(2*R*above))
    f = [slowness(end*k/parts) for k in range(parts + 1)]
    return end/parts/3*(f[0] + f[-1] + 4*sum(f[1:-1:2]) + 2*sum(f[2:-1:2]))


def least_of(rate):
    """How near to balance a coin comes that leaves upright at a rate."""
    return math.acos((1 + J*rate**2/2)/R)


def passes(rows):
    """Those that the theory has: time, and how near to balance the coin was."""
    least = ALPHA - math.radians(5)
    t, rate = fall(least, ALPHA), math.sqrt(2*(R*math.cos(least) - 1)/J)
    known = [(-t, least)]
    for name, when, value in rows[:-1]:
        near("rocking, pass", name == "pass", 1, 0)
        near("rocking, time", when/UNIT, t, 1e-6)
        near("rocking, rate", value*UNIT/rate, 1, 2e-6)
        rate *= RATIO
        least = least_of(rate)
        known.append((t, least))
        t += 2*fall(least, ALPHA)
    near("rocking, stands", rate < STANDS <= rate/RATIO, 1, 0)
    near("rocking, rest", rows[-1] == ("rest", rows[-2][1], 0), 1, 0)
    return known


def leans(rows, known):
    """A lean has five digits: where the coin hardly moves no time is read."""
    read = 0
    for n, (_, t, degrees) in enumerate(rows):
        t /= UNIT
        k = bisect.bisect(known, (t, 9)) - 1
        start, least = known[k]
        x = ALPHA - math.radians(abs(degrees))
        near("rocking, side", degrees*(-1)**k > 0, 1, 0)
        rate = math.sqrt(2*R*max(math.cos(least) - math.cos(x), 0)/J)
        if rate < 0.1*H:
            continue
        half = fall(least, ALPHA)
        near(f"rocking, lean {n}", abs(t - start - half), fall(least, x),
             math.radians(1e-5)/rate + 1e-6)
        read += 1
    near("rocking, leans", read > len(rows)/2, 1, 0)


def rocking(blocks):
    lean, rows = blocks
    leans(lean, passes(rows))
