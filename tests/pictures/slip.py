# SPDX-License-Identifier: MIT
"""Thrown coins, and the map of launches, against Newton's and Euler's laws
written once more: a disc, M = a = g = 1."""
import bisect
import math
import re

from forms import (DISC, energy, height_of, integrals, lines, near, needed,
                   push, rates, rk4, unlike)
from sweep import HERE, LEANS, PAIRS

STATIC, KINETIC = 0.3, 0.27
IX, IZ, J, K = DISC.IX, DISC.IZ, DISC.J, DISC.K


def accelerations(theta, wX, wY, wZ, pull):
    """wX', wY', wZ', N, for friction of pull[0] N along e_X and pull[1] N along
    e_h = s e_Y + c e_Z: L' = -e_Y x R, (2), and the centre's height is cos
    theta."""
    s, c, T = math.sin(theta), math.cos(theta), math.tan(theta)
    free = -wY*(IZ*wZ + IX*wY*T)/IX
    per_N = (s - pull[1]*c)/IX
    N = (1 - s*free - c*wX*wX)/(1 + s*per_N)
    return (free + per_N*N, wX*(wY*T + IZ/IX*wZ), pull[0]*N/IZ, N)


def slipping(y, soft):
    """The slopes of theta, phi, wX, wY, wZ, vX, vh, x, z, and N; soft rounds the
    corner of Coulomb's law."""
    theta, phi, wX, wY, wZ, vX, vh, _, _ = y
    c = math.cos(theta)
    uX, uh = vX + wZ, vh - wX*c                                  # (77)
    k = -KINETIC/math.sqrt(uX*uX + uh*uh + soft*soft)
    dX, dY, dZ, N = accelerations(theta, wX, wY, wZ, (k*uX, k*uh))
    turn = wY/c
    return (wX, turn, dX, dY, dZ, k*uX*N - turn*vh, k*uh*N + turn*vX,
            vX*math.cos(phi) + vh*math.sin(phi),
            vh*math.cos(phi) - vX*math.sin(phi), N)


def rolling(y):
    """The same of theta, phi, wX, wY, wZ, x, z, where the slip velocity is 0."""
    theta, phi, wX, wY, wZ, _, _ = y
    s, c, T = math.sin(theta), math.cos(theta), math.tan(theta)
    vX, vh = -wZ, wX*c
    return (wX, wY/c, (s - K*wY*wZ - IX*wY*wY*T)/J, wX*(wY*T + IZ/IX*wZ),
            wX*wY/K, vX*math.cos(phi) + vh*math.sin(phi),
            vh*math.cos(phi) - vX*math.sin(phi))


def moved(slopes, y, t, longest):
    n = math.ceil(t/longest) if t > 0 else 0
    for _ in range(n):
        y = rk4(slopes, y, t/n)
    return y


def contact(y):
    """Of the centre, x and z; (13)."""
    s = math.sin(y[0])
    return y[-2] - s*math.sin(y[1]), y[-1] - s*math.cos(y[1])


def speed(y):
    return math.hypot(y[5] + y[4], y[6] - y[2]*math.cos(y[0]))


def shown(row, y, slip):
    """To the digits printed, and 1e-4 for what the steps here leave."""
    x, z = contact(y)
    for got, want in zip(row[2:], (x, z, slip)):
        near("slides, row", got, want, 1.5e-4)


def slides(blocks):
    near("slides, blocks", len(blocks), 10, 0)
    for slips, rolls in zip(blocks[::2], blocks[1::2]):
        angle, t = math.radians(float(slips[0][0])), 0
        y = [0.1, 0, 0, 0, 7, 1.8*math.cos(angle), 1.8*math.sin(angle), 0, 0]
        for row in slips[:-1]:
            y, t = moved(lambda y: slipping(y, 0), y, row[1] - t, 0.02), row[1]
            shown(row, y, speed(y))
        # The slip ends: steps that shrink as it does.
        while speed(y) > 1e-6:
            h = 0.2*speed(y)/KINETIC/(1 + 1/IX)
            y, t = rk4(lambda y: slipping(y, 0), y, h), t + h
        near("slides, rolls from", slips[-1][1], t, 1e-4)
        y = y[:5] + y[7:]
        for row in slips[-1:] + rolls:
            y, t = moved(rolling, y, row[1] - t, 0.02), max(t, row[1])
            shown(row, y, 0)


def drawn_slides(blocks, drawing):
    """The paths in the drawing are these, moved and scaled alike, to its tenths
    of a pixel."""
    paths = [line for line in lines(drawing) if len(line) > 2]
    blocks = [[complex(x, z) for _, _, x, z, _ in block] for block in blocks]
    first = blocks[0]

    def placed(block, line):
        """Where a block lies if the first one lies on a line."""
        scale = (line[-1] - line[0]).imag/(first[-1] - first[0]).imag
        return [line[0] + scale*(point - first[0]) for point in block]
    line = min(paths, key=lambda line: unlike(line, placed(first, line)))
    for block in blocks:
        want = placed(block, line)
        near("slides, drawn", min(unlike(line, want) for line in paths), 0, 0.4)


# --------------------------------------------------------------------- the map
ROWS, COLUMNS, LEAN, SPIN, TIME = 80, 112, 84, 6, 10
MAPS = ((0, 0), (1, -3))                       # wZ, and wY at the lower edge


def cells(drawing):
    """What becomes of each cell of both maps: each is drawn once."""
    paths = re.findall(r'stroke="url\(#p(\d)\)" d="([^"]*)"', drawing)
    near("map, regions", [int(k) for k, _ in paths] == [0, 1, 2]*2, 1, 0)
    for regions in (paths[:3], paths[3:]):
        cell = [[None]*COLUMNS for _ in range(ROWS)]
        for fate, d in regions:
            for run in re.findall(r"M(\d+) (\d+)h(\d+)", d):
                column, row, length = map(int, run)
                for k in range(column, column + length):
                    near("map, cell", cell[ROWS - 1 - row][k] is None, 1, 0)
                    cell[ROWS - 1 - row][k] = int(fate)
        near("map, cells", sum(row.count(None) for row in cell), 0, 0)
        yield cell


def launch(column, row, wZ, low):
    return (math.radians((column + 0.5)*LEAN/COLUMNS),
            low + (row + 0.5)*SPIN/ROWS, wZ)


def slips_at(theta, wY, wZ):
    """When a coin let go first needs more friction than STATIC, or infinity, and
    how close to STATIC the most of a swing comes: from its integrals, as
    sweep.Swing."""
    KYZ = integrals(PAIRS.at(height_of(theta)), wY*math.cos(theta), wZ, DISC)
    E, here = energy(DISC, theta, wY, wZ), bisect.bisect(LEANS, theta)
    falls = push(DISC, theta, wY, wZ) < 0
    way = range(here, len(LEANS)) if falls else range(here - 1, -1, -1)
    most, when, t, last, left = needed(DISC, theta, 0, wY, wZ), math.inf, 0, theta, 0
    for k in way:
        at = rates(DISC, LEANS[k], HERE[k], *KYZ)
        more = E - energy(DISC, LEANS[k], *at)
        if more < 0 or most > 1.1*STATIC:
            break
        t += abs(LEANS[k] - last)*math.sqrt(2*J)/(math.sqrt(left)
                                                  + math.sqrt(more))
        last, left = LEANS[k], more
        most = max(most, needed(DISC, last, 2*more/J, *at))
        if most > STATIC:
            when = min(when, t)
    return (0 if needed(DISC, theta, 0, wY, wZ) > STATIC else when,
            abs(most/STATIC - 1))


def lifts(theta, wY, wZ):
    """Whether it does within TIME, by Coulomb's law with a round corner."""
    y, t, soft = [theta, 0, 0, wY, wZ, -wZ, 0, 0, 0], 0, 2e-3
    while t < TIME:
        *_, N = slipping(y, soft)
        if N <= 0:
            return True
        rate = KINETIC*N*(1 + 1/IX)/math.hypot(speed(y), soft)
        turn = (abs(y[3]) + abs(y[2]))/math.cos(y[0]) + abs(y[4]) + 1
        h = 1/(rate + 10*turn)
        y, t = rk4(lambda y: slipping(y, soft), y, h), t + h
    return False


def uniform(cell, row, column):
    """Nothing else within two cells."""
    return len({cell[r][c] for r in range(max(row - 2, 0), min(row + 3, ROWS))
                for c in range(max(column - 2, 0),
                               min(column + 3, COLUMNS))}) == 1


def slip_map(drawing):
    for cell, (wZ, low) in zip(cells(drawing), MAPS, strict=True):
        for row in range(0, ROWS, 2):
            for column in range(row//2 % 3, COLUMNS, 3):
                when, gap = slips_at(*launch(column, row, wZ, low))
                if gap > 0.02 and abs(when - TIME) > 0.2:
                    near("map, rolls", cell[row][column] == 0, when > TIME, 0)
        for row in range(2, ROWS, 12):
            for column in range(3, COLUMNS, 12):
                fate = cell[row][column]
                if fate != 0 and uniform(cell, row, column):
                    near("map, lifts", lifts(*launch(column, row, wZ, low)),
                         fate == 2, 0)
