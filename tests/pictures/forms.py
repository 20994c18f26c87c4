# SPDX-License-Identifier: MIT
"""What physics.md says of a coin with M = a = g = 1, its series summed plainly,
and the one check that uses it."""
import itertools
import math
import re
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
    """wY and wZ, from what pair() or Pairs gave there."""
    Pe, Po, We, Wo = of
    return ((KY*Pe + b.k1*KZ*Po)/math.cos(theta), KZ*We + b.k2*KY*Wo)


def on_leaf(b, theta, KY, KZ):
    """wY and wZ where a motion with these integrals leans by theta."""
    return rates(b, theta, pair(b, theta), KY, KZ)


def energy(b, theta, wY, wZ):
    """Of a coin whose lean does not change."""
    return (b.IX*wY**2 + b.K*wZ**2)/2 + math.cos(theta)          # (48)


def push(b, theta, wY, wZ):
    """-J wX'."""
    return (b.K*wY*wZ + b.IX*wY**2*math.tan(theta)
            - math.sin(theta))                                   # (39)


def potential(b, theta, KY, KZ):
    return energy(b, theta, *on_leaf(b, theta, KY, KZ))


def slope(b, theta, KY, KZ):
    return push(b, theta, *on_leaf(b, theta, KY, KZ))


def needed(b, theta, wX2, wY, wZ):
    """F over N of a coin that rolls; infinite if N is not above 0."""
    s, c = math.sin(theta), math.cos(theta)
    dwX = -push(b, theta, wY, wZ)/b.J
    N = 1 - wX2*c - dwX*s                                        # (27)
    if N <= 0:
        return math.inf
    return math.hypot(math.sqrt(wX2)*wY*b.IZ/b.K,
                      wX2*s - dwX*c - wY*wZ/c)/N                 # (25), (26)


def root(rises, low, high):
    """Where something between begins to hold that does not hold at `low`."""
    for _ in range(60):
        middle = (low + high)/2
        low, high = (low, middle) if rises(middle) else (middle, high)
    return low


def rk4(slopes, y, h):
    """A step; slopes gives those of y, and may give more."""
    def at(k, part):
        return slopes([a + part*h*b for a, b in zip(y, k)])
    k1 = slopes(y)
    k2 = at(k1, 0.5)
    k3 = at(k2, 0.5)
    k4 = at(k3, 1)
    return [a + h/6*(p + 2*q + 2*r + v)
            for a, p, q, r, v in zip(y, k1, k2, k3, k4)]


def lambda2(b, theta, wY, wZ):
    t = math.tan(theta)
    return (math.cos(theta) - (b.IX*(1 + 3*t*t) + 1)*wY**2
            - (3*b.IZ + 1)*t*wY*wZ - b.k1*b.K*wZ**2)/b.J         # (44)


def slow_circle(b, theta, wZ):
    """wY of the slow circle: (41), theta > 0, wZ > 0."""
    s, t = math.sin(theta), math.tan(theta)
    return 2*s/(b.K*wZ + math.sqrt((b.K*wZ)**2 + 4*b.IX*s*t))


def lines(drawing):
    """The points of each line of a drawing of gnuplot, as slim.py writes it."""
    for d in re.findall(r"<path [^>]*d='m([^']*l[^']*)'", drawing):
        end = 0
        for piece in d.split("m"):
            first, *steps = [complex(float(x), float(y)) for x, y in
                             re.findall(r"(-?[.\d]+) ?(-?[.\d]+)", piece)]
            points = list(itertools.accumulate([end + first, *steps]))
            end = points[-1]
            yield points


def apart(point, path):
    """How far a point is from a path of straight pieces."""
    def from_piece(a, b):
        along = ((point - a)/(b - a)).real if a != b else 0
        return abs(point - a - min(max(along, 0), 1)*(b - a))
    return min(map(from_piece, path, path[1:]))


def unlike(line, path, near_by=0.3):
    """How far a path is from a line that is drawn of it without some of its
    points."""
    off, k = abs(line[0] - path[0]), 0
    for piece in zip(line, line[1:]):
        at = (j for j in range(k + 1, len(path))
              if abs(path[j] - piece[1]) < near_by)
        j = next(at, None)
        if j is None:
            return math.inf
        off = max([off, *(apart(point, piece) for point in path[k:j + 1])])
        k = j
    return max(off, abs(path[-1] - path[k]))


def height_of(theta):
    """The y of a lean."""
    return math.atanh(math.sin(theta))


class Pairs:
    """Pe, Po, We, Wo by their derivatives instead, (33), near the table too: in
    y with tanh y = sin theta, where all is smooth, by RK4."""

    H = 0.005                                            # leaves 1e-11

    def __init__(self, b):
        self.kap = b.k1*b.k2
        self.nodes = [(1, 0, 1, 0)]
        for k in range(3200):
            self.nodes.append(self.step(k*self.H, self.H, self.nodes[k]))

    def slope(self, y, of):
        Pe, Po, We, Wo = of
        c2 = 1/math.cosh(y)**2
        return self.kap*Wo*c2, We*c2, self.kap*Po, Pe

    def step(self, y, h, of):
        return rk4(lambda y: (1, *self.slope(y[0], y[1:])), [y, *of], h)[1:]

    def at(self, y):
        k = int(abs(y)/self.H)
        Pe, Po, We, Wo = self.step(k*self.H, abs(y) - k*self.H, self.nodes[k])
        return (Pe, Po, We, Wo) if y >= 0 else (Pe, -Po, We, -Wo)


def integrals(of, p, wZ, b):
    Pe, Po, We, Wo = of
    return We*p - b.k1*Po*wZ, Pe*wZ - b.k2*Wo*p                  # (35)


class Leaf:
    """The motions of a body that share K_Y and K_Z."""

    def __init__(self, b, pairs, KY, KZ):
        self.b, self.pairs, self.KY, self.KZ = b, pairs, KY, KZ

    @classmethod
    def through(cls, b, pairs, theta, wY, wZ):
        of = pairs.at(height_of(theta))
        return cls(b, pairs, *integrals(of, wY*math.cos(theta), wZ, b))

    def p_wZ(self, y):
        Pe, Po, We, Wo = self.pairs.at(y)
        return (self.KY*Pe + self.b.k1*self.KZ*Po,
                self.KZ*We + self.b.k2*self.KY*Wo)

    def potential(self, y):
        p, wZ = self.p_wZ(y)
        c = 1/math.cosh(y)
        return self.b.IX*(p/c)**2/2 + self.b.K*wZ**2/2 + c       # (48)

    def end(self, y, E, side):
        """Where a swing of this energy ends, on that side of y."""
        step = 0.05*side
        while self.potential(y + step) <= E:
            y += step
        return root(lambda y: self.potential(y) > E, y, y + step)

    def way(self, start, end, E, n):
        """dt, dphi and dpsi of (55) from one end of a swing to the other, in n
        parts, the same angles of Chebyshev's."""
        for k in range(n):
            x = math.cos(PI*(k + 0.5)/n)
            y = (start + end + x*(start - end))/2
            p, wZ = self.p_wZ(y)
            wX = math.sqrt(2*(E - self.potential(y))/self.b.J)
            part = PI/n*math.sqrt(1 - x*x)*abs(start - end)/2/wX
            yield (part/math.cosh(y), part*p*math.cosh(y),
                   part*(wZ/math.cosh(y) + p*math.sinh(y)))

    def turn(self, start, end, E):
        """Of the heading, there and back; to 1e-7."""
        n, last = 50, math.inf
        while True:
            turn = 2*sum(dphi for _, dphi, _ in self.way(start, end, E, n))
            if abs(turn - last) < 1e-7:
                return turn
            n, last = 2*n, turn


def near(name, got, want, bound):
    near.checks += 1
    if not abs(got - want) <= bound:
        sys.exit(f"{name}: {got} is not {want} within {bound:.1e}")


near.checks = 0
