#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The numbers behind docs/pictures.md against closed forms.

    check.py FRESH KEPT      folders of CSV files: computed now, and kept

The programs of docs/examples move a coin; nothing is moved here.  The formulas
are those of docs/physics.md, written once more (forms.py).  Tolerances are the
last digit printed, or stand with what is left out.
"""
import cmath
import itertools
import math
import pathlib
import sys

from animation import animation
from forms import (DISC, PI, Body, Leaf, Pairs, apart, height_of, lambda2,
                   lines, near, on_leaf, pair, potential, root, slope,
                   slow_circle, unlike)
from rest import fixed, rest
from rocking import rocking
from slip import drawn_slides, slides, slip_map
from sweep import sweep
from toss import ghosts, lean_map, toss_map


def table(path):
    """Blocks of rows: the first column a name, the others numbers."""
    blocks = path.read_text().split("\n\n\n")
    rows = [[line.split(",") for line in block.split("\n") if line]
            for block in blocks]
    rows[0] = rows[0][1:]                                # the header
    return [[(r[0], *map(float, r[1:])) for r in block]
            for block in rows if block]


# Inner radius, theta, wZ, the wY between which the angle is met, and it.
FLOWERS = ((0, 0.5, 0.8, -0.6, -0.3, 4, 7, 7), (1, 0.2, 0.8, -1, -0.3, 3, 8, 8),
           (0, 0.9, 0.3, 1, 1.5, 9, 8, 8), (0, 0.9, 0.8, -0.3, 0.3, 3, 5, 5),
           (0, 0.2, 0.3, 1, 1.5, 4, 3, 3), (1, 0.9, 0.3, 1, 1.5, 1, 1, 9))


def dropped(b, pairs, theta, wY, wZ):
    """The swing of a coin let go: its leaf, both ends, its energy."""
    leaf, y = Leaf.through(b, pairs, theta, wY, wZ), height_of(theta)
    E = leaf.potential(y)
    side = -1 if slope(b, theta, leaf.KY, leaf.KZ) > 0 else 1
    return leaf, y, leaf.end(y, E, side), E


def half_petal(inner, theta, wZ, low, high, turns, petals):
    """The path of the contact, as z + i x, over half a period whose heading
    turns by half of turns/petals of a circle; right to 1e-5."""
    b = Body(inner)
    pairs = Pairs(b)

    def excess(wY):
        leaf, *swing = dropped(b, pairs, theta, wY, wZ)
        return leaf.turn(*swing) - 2*PI*turns/petals
    below = excess(low)
    low = root(lambda wY: excess(wY)*below <= 0, low, high)
    leaf, *swing = dropped(b, pairs, theta, low, wZ)
    path, phi = [complex(-math.sin(theta), 0)], 0
    for _, dphi, dpsi in leaf.way(*swing, 400):
        path.append(path[-1] - 1j*dpsi*cmath.exp(1j*(phi + dphi/2)))  # (22)
        phi += dphi
    return path


def rosettes(blocks):
    digit = 0.5e-4
    for block, (*start, turns, petals, drawn) in zip(blocks, FLOWERS,
                                                     strict=True):
        path = [complex(z, x) for _, x, z in block]
        n = (len(path) - 1)//drawn
        near("rosette, points", len(path), n*drawn + 1, 0)
        half = half_petal(*start, turns, petals)
        near("rosette, half a petal", abs(path[n//2] - half[-1]), 0, 2*digit)
        for point in path[:n//2 + 1]:
            near("rosette, shape", apart(point, half), 0, 2*digit)
        turn = complex(math.cos(2*PI*turns/petals),
                       math.sin(2*PI*turns/petals))
        step = path[n] - path[0]
        for k in range(len(path) - 2*n):     # each petal is the last, turned
            near("rosette, petal", abs(
                path[k + 2*n] - path[k + n] - turn*(path[k + n] - path[k])),
                0, 6*digit)
        near("rosette, end", abs(path[-1] - path[0]),
             abs(step)*drawn if petals == 1 else 0, 30*digit)


def drawn(blocks, drawing):
    """The rosettes in the drawing are these, each moved and scaled, to its tenths
    of a pixel and those of the points that slim.py leaves out."""
    paths = [line for line in lines(drawing) if len(line) > 100]
    for block, line in zip(blocks, paths, strict=True):
        across, down = zip(*[(point.real, point.imag) for point in line])
        x, z = [point[1] for point in block], [point[2] for point in block]
        scale = (max(across) - min(across))/(max(x) - min(x))
        shape = [complex(min(across) + scale*(a - min(x)),
                         max(down) - scale*(b - min(z))) for a, b in zip(x, z)]
        near("drawing", unlike(line, shape), 0, 0.4)


def potentials(blocks):
    leaves = [(0, 0.3), (0, 0.45), (0, 1/math.sqrt(3)), (0, 0.7), (0.35, 1)]
    for block, leaf in zip(blocks, leaves):
        for _, theta, V in block:
            push = abs(slope(DISC, theta, *leaf))
            near("potential", V, potential(DISC, theta, *leaf),
                 0.5e-6 + 1e-5*push)
        near("potential, extent", block[0][1] > 0.9 > -0.9 > block[-1][1], 1, 0)
    (_, theta, V), = blocks[5]
    near("steady", slope(DISC, theta, 0.35, 1), 0, 1e-11)
    near("steady", V, potential(DISC, theta, 0.35, 1), 1e-11)
    for wX, block in zip((0.2, 0.6, 1), blocks[6:], strict=True):
        E = potential(DISC, 0, 0.35, 1) + DISC.J*wX**2/2
        for _, theta, V in block:
            near("swing", V, E, 1e-11)
            near("swing", potential(DISC, theta, 0.35, 1), E, 1e-10)


def tip_of(b):
    """tan^2 of the lean above which all circles are stable."""
    A = (3*b.IZ + 1)**2 - 12*b.IZ*b.K
    B = -2*b.K*(3*b.IZ + 1 + 2*b.k1)
    return (-B - math.sqrt(B*B - 4*A*b.K**2))/(2*A)


def bifurcation(blocks):
    near("tip of the disc", tip_of(DISC), (18*math.sqrt(5) - 39)/11, 1e-14)
    for inner, (edge, tip) in ((0, blocks[0:2]), (1, blocks[2:4])):
        b = Body(inner)
        for _, wZ, theta, *_ in edge:
            if theta < 2e-3:
                continue
            for off, side in ((-1e-3, 1), (1e-3, -1)):
                at = theta + off
                L = lambda2(b, at, slow_circle(b, at, wZ), wZ)
                near("window", L*side > 0, 1, 0)
        near("window, from", edge[0][1], 0, 1e-5)
        near("window, to", edge[-1][1], 1/math.sqrt(b.k1*b.K), 1e-5)  # (45)
        (_, wZ, theta), = tip
        # The summit is flat: the lean is right to the square of wZ's error.
        near("tip", math.tan(theta)**2, tip_of(b), 2e-9)
        near("tip", lambda2(b, theta, slow_circle(b, theta, wZ), wZ), 0, 1e-7)
    for KY, block in ((0, blocks[4]), (0.05, blocks[5])):
        for _, KZ, theta, L in block:
            wY, wZ = on_leaf(DISC, theta, KY, KZ)
            stiff = max(1, wY**2)*(1 + math.tan(theta)**2)
            near("fork", slope(DISC, theta, KY, KZ), 0, 3e-6*stiff)
            near("fork", L, lambda2(DISC, theta, wY, wZ), 1e-4*stiff)
        upright = [(KZ, L) for _, KZ, theta, L in block if abs(theta) < 1e-9]
        for KZ, L in upright:
            near("fork, upright", (L <= 0) == (KZ**2 >= 1/3), 1, 0)    # (45)
        near("fork, upright", len(upright) > 0, KY == 0, 0)
        leans = {KZ: 0 for _, KZ, *_ in block}
        for _, KZ, *_ in block:
            leans[KZ] += 1
        near("fork, tines", max(leans.values()), 3, 0)
        near("fork, handle", leans[max(leans)], 1, 0)


def steady_lean(KY, KZ):
    """That nearest to upright: where V has no slope."""
    def push(theta):
        return slope(DISC, theta, KY, KZ)
    for k in itertools.count():
        for side in (0.01, -0.01):
            low, high = k*side, (k + 1)*side
            if push(low)*push(high) <= 0:
                return root(lambda theta: push(low)*push(theta) <= 0, low,
                            high)


def small_nods(KY, KZ):
    """2 pi phi'/|lambda| about it."""
    theta = steady_lean(KY, KZ)
    wY, wZ = on_leaf(DISC, theta, KY, KZ)
    return 2*PI*wY/math.cos(theta)/math.sqrt(-lambda2(DISC, theta, wY, wZ))


PE, PO = 2.1406983534237, 1.4690645964526                # Pe(1), Po(1): disc


def precession(blocks):
    near("precession, blocks", len(blocks), 8, 0)
    pairs = Pairs(DISC)
    for small, nods in zip(blocks[::2], blocks[1::2]):
        (_, KY, KZ, _, turn), = small
        near("small nods", abs(turn), abs(small_nods(KY, KZ)), 1e-8)
        leaf, y = Leaf(DISC, pairs, KY, KZ), height_of(steady_lean(KY, KZ))
        for _, _, _, more, nod in nods[::2]:
            E = leaf.potential(y) + more
            near("nods", nod, leaf.turn(leaf.end(y, E, -1),
                                        leaf.end(y, E, 1), E), 1e-6)
        p_up, p_down = KY*PE + 2*KZ*PO, KY*PE - 2*KZ*PO
        passes = math.copysign(1, p_up) + math.copysign(1, p_down)
        limit = passes*PI*math.sqrt(5)
        # What is missing goes as d, and d as 1/sqrt(E); gravity, which adds
        # (1/E) d ln(1/d), is a tenth of it by now.
        last, before = nods[-1], nods[-11]
        near("energies", last[3]/before[3], 10, 1e-3)
        near("near flat", abs(last[4] - limit)/abs(before[4] - limit),
             1/math.sqrt(10), 0.04)


def nearly_flat(blocks):
    for inner, block in zip((0, 0.5, 1), blocks, strict=True):
        b = Body(inner)
        limit = PI*math.sqrt(b.J/b.IX)                           # (51)
        pairs = Pairs(b)
        for name, spin, d, turn in block:
            near("nearly flat", float(name), inner, 0)
            leaf, *swing = dropped(b, pairs, 0.3, spin, spin)
            # The spin has seven digits, and d is as the spin.
            near("distance", 2*math.atan(math.exp(-swing[1])), d, 1e-6*d)
            near("turn", turn, leaf.turn(*swing), 1e-6)
            if d > 1e-3:
                continue
            E = (b.IX + b.K)*spin**2/2 + math.cos(0.3)
            more = math.sqrt(b.J/b.IX)/E*d*math.log(1/d)
            near("nearly flat", turn, limit + more, 6*d)
            # Two-sided: the logarithm is more than what is left.
            near("nearly flat", turn - limit > more/3, 1, 0)


def same(fresh, kept):
    """Numbers as kept, but for the last digits of another C library's sine."""
    a, b = fresh.read_text().split(), kept.read_text().split()
    near(f"{kept}: rows", len(b), len(a), 0)
    for x, y in zip(a, b):
        for v, w in zip(x.split(","), y.split(","), strict=True):
            try:
                near(str(kept), float(v), float(w), 1e-4*abs(float(w)) + 1e-4)
            except ValueError:
                near(f"{kept}: {v}", v == w, 1, 0)


def two_routes():
    pairs = Pairs(DISC)
    for theta in (0.1, 0.7, -1.3, 1.5):
        for got, want in zip(pairs.at(height_of(theta)), pair(DISC, theta)):
            near("pairs", got, want, 1e-10)


two_routes()
fresh, kept = map(pathlib.Path, sys.argv[1:])
petals = table(fresh / "rosettes.csv")
rosettes(petals)
drawn(petals, (kept.parent / "rosettes.svg").read_text())
throws = table(fresh / "slides.csv")
slides(throws)
drawn_slides(throws, (kept.parent / "slides.svg").read_text())
for check in (potentials, bifurcation, precession, nearly_flat,
              rest, rocking):
    name = {"potentials": "potential"}.get(check.__name__, check.__name__)
    check(table(fresh / f"{name}.csv"))
    check(table(kept / f"{name}.csv"))
    same(fresh / f"{name}.csv", kept / f"{name}.csv")
fixed(*([line.split(",") for line in file.read_text().splitlines()[1:]]
        for file in (fresh / "fixed.csv", kept / "settle.csv")))
for check in (animation, ghosts, slip_map, toss_map, lean_map):
    name = f"{check.__name__}.svg"
    drawing = (fresh / name).read_text()
    check(drawing)
    near(f"{name}, as kept", (kept.parent / name).read_text() == drawing, 1, 0)
sweep((fresh / "sweep.ppm").read_bytes())
print(f"{near.checks} numbers behind the pictures hold")
