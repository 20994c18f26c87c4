# SPDX-License-Identifier: MIT
"""README's toss against the parabolas of its flights.

The map of the faces that tosses end with: where a coin has not the energy to
stand up it does not turn over; where it is thrown high and fast, it shows either
face as often."""
import math
import re

from animation import document
from forms import near

COLUMNS, ROWS = 336, 240
HEIGHT, SPIN = 20, 8                             # of the first map


def cells(d):
    """The cells of a drawing's path."""
    at = row = 0
    for across, down, length in re.findall(r"m(-?\d+) (-?\d+)h(\d+)", d):
        at, row = at + int(across), row + int(down)
        yield from ((at + k, ROWS - 1 - row) for k in range(int(length)))
        at += int(length)


def toss_map(drawing):
    """Heads, from an even number of half turns, and tails have colours by
    turns."""
    paths = re.findall(r'<path transform[^>]* d="([^"]*)"', drawing)
    near("tosses, colours of two maps", len(paths), 16, 0)
    drawn = [set(cells(d)) for d in paths[:8]]
    near("tosses, cells", sum(map(len, drawn)), COLUMNS*ROWS, 0)
    near("tosses, each once", len(set().union(*drawn)), COLUMNS*ROWS, 0)
    heads = set().union(*drawn[::2])
    far = []
    for column in range(COLUMNS):
        for row in range(ROWS):
            height = (column + 0.5)*HEIGHT/COLUMNS
            spin = (row + 0.5)*SPIN/ROWS
            if height + spin**2/8 < 1:
                near("tosses, low", (column, row) in drawn[0], 1, 0)
            if height > 10 and spin > 4:
                far.append((column, row) in heads)
    near("tosses, either face", sum(far)/len(far), 0.5, 1.5/math.sqrt(len(far)))


def lean_map(drawing):
    """Launches that differ by 1e-4 rad rest more than a second apart; between
    such jumps the time changes by less than 0.05 s from one to the next."""
    paths = re.findall(r'stroke="#0072B2"[^>]* d="([^"]*)"', drawing)
    near("leans, panels", len(paths), 2, 0)
    times = [(288 - float(y))*12/244
             for y in re.findall(r"M[\d.]+ ([\d.]+)h0", paths[1])]
    near("leans, launches", len(times), 400, 0)
    steps = [abs(b - a) for a, b in zip(times, times[1:])]
    near("leans, jumps", max(steps) > 1, 1, 0)
    near("leans, between them", sum(step < 0.05 for step in steps) > 200, 1, 0)


# What toss.c says of itself: the flights, in radii and seconds, and two cameras
# that look from the same elevation.
RADIUS, GRAVITY, GHOSTS = 0.01213, 9.80665, 20
START, THROWN = (-0.042, 0.035, 0), (0.23, 0.97, 0.02)
LOOP, WAIT, SLOWER, FLIGHT = 6, 0.4, 3, 0.2
NEAR_BY, FAR_OFF = ((0, 3), 22, (206, 172), 32), ((3.4, 4), 44, (572, 184), 15)


def flying(harder, t, camera):
    """Where a camera sees the centre of a coin that flies."""
    (across, up), distance, at, scale = camera
    x, y, z = ((s + harder*v*t)/RADIUS for s, v in zip(START, THROWN))
    x, y = x - across, y - GRAVITY*t**2/2/RADIUS - up
    depth = distance - 0.55*y - 0.835*z
    f = scale*distance/depth
    return complex(at[0] + f*x, at[1] + f*(0.55*z - 0.835*y))


def flight(animated, harder, camera, bound):
    """Its keys until it comes down.  The middle of its ellipse is about a
    pixel from where the centre is seen, since the camera is near."""
    ways = [re.search(rf' {name}="([^"]*)"', animated)[1].split(";")
            for name in ("values", "keyTimes")]
    keys = 0
    for way, part in zip(*ways, strict=True):
        t = (float(part)*LOOP - WAIT)/SLOWER
        if 0 <= t < FLIGHT:
            keys += 1
            at = complex(*map(float, way.split()))
            near("toss, flight", abs(at - flying(harder, t, camera)), 0, bound)
    near("toss, keys of a flight", keys > 2, 1, 0)


def ghosts(drawing):
    document(drawing)
    near("toss, seconds", set(re.findall(r'dur="(\d+)s"', drawing)) == {"6"},
         1, 0)
    _, _, coin, *ghosts = re.findall(r'<animateTransform [^>]*type="translate" '
                                     r'[^>]*values="\d[^>]*>', drawing)
    flight(coin, 1, NEAR_BY, 1.5)
    for k, ghost in enumerate(ghosts[-GHOSTS:], 1):
        flight(ghost, 1.01**k, FAR_OFF, 1.5)
    ends = re.findall(r'"still" fill="(#\w+)">.*ry="(\d+)"', drawing)
    near("toss, ghosts", len(ends), GHOSTS, 0)
    for _, short in ends:                    # each lies flat, seen from above
        near("toss, flat", int(short), 15*0.55, 2.5)
    for side, colour in (("heads", "#2f8fd0"), ("tails", "#e69f00")):
        said = int(re.search(rf">(\d+) {side}<", drawing)[1])
        near(f"toss, {side}", [end[0] for end in ends].count(colour), said, 0)
        near(f"toss, some {side}", said > GHOSTS/4, 1, 0)
