# SPDX-License-Identifier: MIT
"""Every pixel of the sweep against what its coin's integrals let it do.

A coin let go with wX = 0 is at one end of its swing.  From there V(theta) and
the energy tell the other end, the fastest rate (47) in between, and when that
is reached: so who falls, when, and how far the others nod.
"""
import bisect
import math

from forms import (DISC, PI, Pairs, energy, height_of, integrals, near, push,
                   rates)

# What sweep.c says of itself: the spin, the rate beyond which a step is coarse
# and a coin counts as fallen, the calls and their time, the two scales.
SPIN, FALLEN, CALLS, CALL, STEP = 1.2, 7, 40, 0.6, 0.05
BLUE = (10, 20, 70), (0, 114, 178), (86, 180, 233), (245, 240, 170)
RED = (60, 10, 0), (150, 50, 0), (213, 94, 0), (255, 210, 170)

# Leans that grow as ln tan: near the table by 0.5 % of the height each.  What
# comes nearer than the last, 2.3 degrees, has fallen.
HEIGHTS = [k*0.005 for k in range(-780, 781)]
LEANS = [math.asin(math.tanh(y)) for y in HEIGHTS]
PAIRS = Pairs(DISC)
HERE = [PAIRS.at(y) for y in HEIGHTS]


def colour(scale, part):
    at = 3*min(max(part, 0), 0.9999)
    k = int(at)
    return tuple(int(a + (at - k)*(b - a))
                 for a, b in zip(scale[k], scale[k + 1]))


def meanings():
    """{colour: (call in which it fell or 0, the least nod, the most)}."""
    means = {}
    for k in range(20000):
        rgb, nod = colour(BLUE, k/20000), PI*k/20000
        means[rgb] = (0, means.get(rgb, (0, nod))[1], nod)
    return means | {colour(RED, math.sqrt(k/CALLS)): (k, 0, 0)
                    for k in range(1, CALLS + 1)}


class Swing:
    """From a lean to the other end: fastest, the largest W on the way; fell,
    when it was FALLEN; end and until, the last lean and when; pull, the wX' of
    it.  The time of a piece is as if V were straight in it, as at the ends."""

    def __init__(self, theta, wY, wZ, of):
        K = integrals(of, wY*math.cos(theta), wZ, DISC)
        self.height = energy(DISC, theta, wY, wZ)
        self.fastest, self.fell, self.until = 0, math.inf, 0
        self.end, self.left = theta, 0
        self.look(theta, 0, wY, wZ)
        here = bisect.bisect(LEANS, theta)
        for k in (range(here - 1, -1, -1) if push(DISC, theta, wY, wZ) > 0
                  else range(here, len(LEANS))):
            if not self.go(LEANS[k], *rates(DISC, LEANS[k], HERE[k], *K)):
                return
        self.fell = min(self.fell, self.until)

    def look(self, theta, wX2, wY, wZ):
        c = math.cos(theta)
        W2 = (wX2 + wY**2)/c**2 + wZ**2 + 1/c                         # (47)
        self.fastest = max(self.fastest, math.sqrt(W2))
        if W2 > FALLEN**2:
            self.fell = min(self.fell, self.until)
        self.pull = abs(push(DISC, theta, wY, wZ))/DISC.J

    def go(self, theta, wY, wZ):
        """To the next lean; false if the swing ends before."""
        more = self.height - energy(DISC, theta, wY, wZ)
        on = theta - self.end
        if more < 0:
            on *= self.left/(self.left - more)
        left = max(more, 0)
        self.until += (2*abs(on)*math.sqrt(DISC.J/2)
                       / (math.sqrt(self.left) + math.sqrt(left) or math.inf))
        self.end, self.left = self.end + on, left
        self.look(theta, 2*left/DISC.J, wY, wZ)
        return more > 0


def sweep(picture):
    side = math.isqrt(len(picture)//3)
    pixels = picture[-3*side*side:]
    says, unsure = meanings(), 0
    for column in range(side):
        theta = PI*((column + 0.5)/side - 0.5)
        of = PAIRS.at(height_of(theta))
        for row in range(side):
            turn = 2*PI*(0.5 - (row + 0.5)/side)
            at = 3*(row*side + column)
            rgb = tuple(pixels[at:at + 3])
            near("sweep, colour", rgb in says, 1, 0)
            fell, least, most = says[rgb]
            s = Swing(theta, SPIN*math.sin(turn), SPIN*math.cos(turn), of)
            # W is looked at after each step: half a step from its peak, at a
            # rate of 7, it is a hundredth less.
            if FALLEN < s.fastest < 1.02*FALLEN:
                unsure += 1
                continue
            near("sweep, who falls", fell > 0, s.fell < CALLS*CALL, 0)
            if fell:
                # In the call in which a step ends after s.fell, which is of
                # a lean of LEANS, so that it may be late itself.
                near("sweep, when", fell - s.fell/CALL,
                     0.5, 0.5 + STEP/CALL)
            elif s.until < CALLS*CALL:
                # Looked at each CALL, half of that from the end of a swing.
                swing = abs(s.end - theta)
                missed = s.pull*(CALL/2)**2/2
                near("sweep, nod", most > swing - missed, 1, 0)
                near("sweep, nod", least < swing + 1e-3, 1, 0)
    near("sweep, unsure", unsure, 0, side*side/50)
