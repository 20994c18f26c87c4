# SPDX-License-Identifier: MIT
"""What physics.md says of a coin with M = a = g = 1, its series summed plainly,
and the one check that uses it."""
import itertools
import math
import sys

PI = math.pi


class Body:
    def __init__(self, inner):
        self.IX = (1 + inner**2)/4
        self.IZ = 2*self.IX
        self.J, self.K = 1 + self.IX, 1 + self.IZ
        self.k1, self.k2 = self.IZ/self.IX, 1/self.K


DISC = Body(0)


def series(u, first, shift, kap):
    """(34), even or odd: Pe, Po (shift -1), We, Wo (shift 1)."""
    term = total = u**first
    for n in itertools.count(first, 2):
        term *= u*u*(n*(n + shift) + kap)/((n + 1)*(n + 2))
        total += term
        if abs(term) < 1e-17*abs(total) or term == 0:
            return total


def pair(b, theta):
    """Pe, Po, We, Wo."""
    u, kap = math.sin(theta), b.k1*b.k2
    return (series(u, 0, -1, kap), series(u, 1, -1, kap),
            series(u, 0, 1, kap), series(u, 1, 1, kap))


def rates(b, theta, of, KY, KZ):
    """wY and wZ, from what pair() gave."""
    Pe, Po, We, Wo = of
    return ((KY*Pe + b.k1*KZ*Po)/math.cos(theta), KZ*We + b.k2*KY*Wo)


def on_leaf(b, theta, KY, KZ):
    """wY and wZ where a motion with these integrals leans by theta."""
    return rates(b, theta, pair(b, theta), KY, KZ)


def potential(b, theta, KY, KZ):
    wY, wZ = on_leaf(b, theta, KY, KZ)
    return (b.IX*wY**2 + b.K*wZ**2)/2 + math.cos(theta)          # (48)


def slope(b, theta, KY, KZ):
    wY, wZ = on_leaf(b, theta, KY, KZ)
    return (b.K*wY*wZ + b.IX*wY**2*math.tan(theta)
            - math.sin(theta))                                   # (39)


def lambda2(b, theta, wY, wZ):
    t = math.tan(theta)
    return (math.cos(theta) - (b.IX*(1 + 3*t*t) + 1)*wY**2
            - (3*b.IZ + 1)*t*wY*wZ - b.k1*b.K*wZ**2)/b.J         # (44)


def slow_circle(b, theta, wZ):
    """wY of the slow circle: (41), theta > 0, wZ > 0."""
    s, t = math.sin(theta), math.tan(theta)
    return 2*s/(b.K*wZ + math.sqrt((b.K*wZ)**2 + 4*b.IX*s*t))


def near(name, got, want, bound):
    near.checks += 1
    if not abs(got - want) <= bound:
        sys.exit(f"{name}: {got} is not {want} within {bound:.1e}")


near.checks = 0
