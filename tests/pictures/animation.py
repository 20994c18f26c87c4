# SPDX-License-Identifier: MIT
"""The animation of a rosette against the closed forms of its swing.

The rates of the rosette are found again, from (48) and (55) alone.  They tell
the duration, the leans, the friction, and the path of the contact, which a
camera of our own looks at.
"""
import cmath
import math
import re

from forms import DISC, PI, Leaf, Pairs, height_of, near, needed

# What animation.h says of itself.
LEAN, SWINGS, TURNS, ROLLS = 0.6, 7, 3, 8
SLOWER, SECONDS = 6, math.sqrt(0.01213/9.80665)
ELEVATION, DISTANCE, AHEAD, AT, SCALE = 0.62, 15, 0.2, (258, 190), 63
TOP, BOTTOM, LEANS = 80, 280, 40
KEYS = 140
PAIRS = Pairs(DISC)


def swing(wY, wZ, parts=200):
    """Of half a swing from LEAN: its leaf, both ends and its energy, and what
    turn and roll gain in it."""
    leaf = Leaf.through(DISC, PAIRS, LEAN, wY, wZ)
    y = height_of(LEAN)
    ends = y, leaf.end(y - 1e-9, leaf.potential(y), -1), leaf.potential(y)
    gains = [sum(gain) for gain in zip(*leaf.way(*ends, parts))][1:]
    return leaf, ends, gains


def rates():
    """wY and wZ, with which a swing turns and rolls as much as it should."""
    def miss(wY, wZ):
        turn, roll = swing(wY, wZ)[2]
        return (turn - PI*TURNS/SWINGS, roll - PI*ROLLS/SWINGS)
    wY, wZ, d = 0.72, 0.71, 1e-5
    for _ in range(6):
        f, fY, fZ = miss(wY, wZ), miss(wY + d, wZ), miss(wY, wZ + d)
        a, c = ((v - u)/d for u, v in zip(f, fY))
        b, e = ((v - u)/d for u, v in zip(f, fZ))
        wY -= (e*f[0] - b*f[1])/(a*e - b*c)
        wZ -= (a*f[1] - c*f[0])/(a*e - b*c)
    return wY, wZ


def friction(leaf, y, E):
    p, wZ = leaf.p_wZ(y)
    return needed(DISC, math.asin(math.tanh(y)),
                  max(2*(E - leaf.potential(y))/DISC.J, 0), p*math.cosh(y), wZ)


def seen(z, y=0):
    """A point z + i x at a height y in the picture."""
    level = math.cos(math.asin(ELEVATION))
    depth = DISTANCE - ELEVATION*(y - AHEAD) - level*z.real
    f = SCALE*DISTANCE/depth
    return complex(AT[0] + f*z.imag,
                   AT[1] - f*(level*(y - AHEAD) - ELEVATION*z.real))


def contact_path(leaf, ends, parts=2000):
    """Of half a swing, its rosette's centre in the middle: (21), (22).  The
    rosette's next half is the mirror image in the line of the heading there."""
    path, phi = [0], 0
    for _, dphi, dpsi in leaf.way(*ends, parts):
        path.append(path[-1] - 1j*dpsi*cmath.exp(1j*(phi + dphi/2)))
        phi += dphi
    # The centre lies on both lines across the contact's way, at either end.
    n0, n1 = 1, cmath.exp(1j*phi)
    across = (path[-1].imag*n1.real - path[-1].real*n1.imag)
    centre = n0*across/(n0*n1.conjugate()).imag
    return [point - centre for point in path]


def moves(text, kind):
    """The keys of what moves so, in the order of the drawing."""
    return [[[float(v) for v in key.split()] for key in values.split(";")]
            for values in re.findall(rf'type="{kind}" dur=[^v]*values="([^"]*)"',
                                     text)]


def coins(text, ends, radii):
    """At the ends of the swings, where turn and roll are known, the rim of the
    coin lies on the ellipse that is drawn, and the mark where it has rolled."""
    at, turn, size = (moves(text, kind)[1]
                      for kind in ("translate", "rotate", "scale"))
    face, roll = moves(text, "scale")[2], moves(text, "rotate")[2]
    for j in range(2*SWINGS + 1):
        key, way = j*KEYS//SWINGS//2, cmath.exp(1j*PI*j*TURNS/SWINGS)
        s, c = math.tanh(ends[j % 2]), 1/math.cosh(ends[j % 2])
        centre = (s - radii[j % 2])*way                              # (21)

        def on_ellipse(angle):
            """A point of the rim, undone what moves the coin's circle."""
            z = centre + way*(1j*math.cos(angle) + s*math.sin(angle))
            point = seen(z, c + c*math.sin(angle)) - complex(*at[key])
            point *= cmath.exp(-1j*math.radians(turn[key][0]))/size[key][0]
            return complex(point.real, point.imag/face[key][1])
        for k in range(12):
            near("animation, rim", abs(on_ellipse(PI*k/6)), 1, 0.005)
        # e_Z = c e_h - s e_y shows to the camera, or its back does.
        level = math.cos(math.asin(ELEVATION))
        to_eye = (DISTANCE*level - centre)*way.conjugate()
        front = c*to_eye.real - s*(AHEAD + DISTANCE*ELEVATION - c)
        near("animation, face", front*face[key][1] > 0, 1, 0)
        mark = cmath.phase(on_ellipse(PI*j*ROLLS/SWINGS)
                           / cmath.exp(1j*math.radians(roll[key][0])))
        near("animation, mark", mark, 0, 0.01)


def paths(text):
    """The ends and the middles of the cubics of each path."""
    for d in re.findall(r' d="(M[^"]*c[^"]*)"', text):
        start, *cubics = d.split("c")
        at = [float(v) for v in start[1:].split()]
        points = [tuple(at)]
        for cubic in cubics:
            step = [float(v) for v in cubic.split()]
            points.append(tuple(at[i] + (3*step[i] + 3*step[i + 2]
                                         + step[i + 4])/8 for i in (0, 1)))
            at = [at[0] + step[4], at[1] + step[5]]
            points.append(tuple(at))
        yield points


def document(text):
    near("animation, size", len(text.encode()) <= 60000, 1, 0)
    near("animation, script", "<script" in text, 0, 0)
    for wanted in ("<title>", "prefers-color-scheme:dark",
                   "prefers-reduced-motion:reduce"):
        near(f"animation, {wanted}", text.count(wanted), 1, 0)


def loops(text):
    for kind, values in re.findall(r'(?:type|attributeName)="([\w-]+)" dur='
                                   r'"[^"]*" repeatCount="indefinite" '
                                   r'values="([^"]*)"', text):
        keys = [[float(v) for v in key.split()] for key in values.split(";")]
        if len(keys) == 2:
            continue                                 # the dot's time
        near("animation, keys", len(keys), KEYS + 1, 0)
        whole = {"rotate": 180, "stroke-dashoffset": 1}.get(kind, math.inf)
        for first, last in zip(keys[0], keys[-1]):
            near("animation, loop", math.remainder(last - first, whole), 0,
                 1e-9)


def animation(text):
    document(text)
    loops(text)
    leaf, ends, _ = swing(*rates())
    seconds = 2*SWINGS*sum(dt for dt, *_ in leaf.way(*ends, 400))*SECONDS*SLOWER
    for dur in re.findall(r'dur="([0-9.]+)s"', text):
        near("animation, duration", float(dur), seconds, 0.02)
    heights = [float(v) for v in re.search(r'"cy" dur.*values="([^"]*)"',
                                           text)[1].split(";")]
    for key in range(0, KEYS + 1, KEYS//SWINGS//2):
        y = ends[key//(KEYS//SWINGS//2) % 2]
        lean = math.degrees(math.asin(math.tanh(y)))
        near("animation, lean", heights[key],
             BOTTOM - (BOTTOM - TOP)*lean/LEANS, 0.06)
    most = max(friction(leaf, ends[1] + k*(ends[0] - ends[1])/1000, ends[2])
               for k in range(1001))
    stated = float(re.search(r"friction of ([0-9.]+)\.", text)[1])
    near("animation, friction", most <= stated < most + 0.01, 1, 0)
    drawn, _ = paths(text)
    near("animation, path", len(drawn), 2*KEYS + 1, 0)
    half = contact_path(leaf, ends)
    coins(text, ends, (abs(half[0]), abs(half[-1])))
    want = [seen(z) for z in half]
    for x, y in drawn[:KEYS//SWINGS + 1]:
        near("animation, path", min(abs(complex(x, y) - w) for w in want), 0,
             0.15)
