#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What rolling_quarter --live shows last, and what an interrupt leaves.

    live.py PROGRAM

The coin of the scene "circle" leans steadily, so that (18)-(22) say where it is
in closed form.  Each dot of the last frame is computed from that.
"""
import math
import os
import pty
import re
import signal
import subprocess
import sys

PROGRAM = sys.argv[1]
ACROSS, DOWN = 2*78 - 1, 4*19 - 1
STEPS, TIME = 400, 8.0                     # of 0.02 each
LEAN, WY, WZ = 0.4, 0.2550291587475191, 1.0
SHOWN, HIDDEN = "\033[?25h", "\033[?25l"
BITS = {1: (0, 0), 8: (1, 0), 2: (0, 1), 16: (1, 1),
        4: (0, 2), 32: (1, 2), 64: (0, 3), 128: (1, 3)}


def played(*arguments, frames=None):
    """What the program writes to a terminal, and how it ends: interrupted, if
    so many frames are given, in the last of them."""
    ours, theirs = pty.openpty()
    with subprocess.Popen([PROGRAM, "--live", *arguments], stdout=theirs,
                          stdin=theirs, start_new_session=True) as program:
        os.close(theirs)
        said = b""
        while True:
            try:
                part = os.read(ours, 65536)
            except OSError:                # Linux's end of a terminal
                break
            if not part:
                break
            said += part
            if frames and said.count(HIDDEN.encode()) >= frames:
                program.send_signal(signal.SIGINT)
                frames = None
        os.close(ours)
        return said.decode(errors="replace"), program.wait()


def dots(frame):
    """The dots that are lit, as (column, row)."""
    lit = set()
    rows = [row for row in frame.split("\n") if "\u2800" <= row[:1] <= "\u28ff"]
    for j, row in enumerate(rows):
        for i, cell in enumerate(row.strip("\r")):
            lit |= {(2*i + x, 4*j + y) for bit, (x, y) in BITS.items()
                    if ord(cell) - 0x2800 & bit}
    return lit


def coin(t):
    """The centre and the contact at a time, heading and roll."""
    turn, roll = WY/math.cos(LEAN), WZ + WY*math.tan(LEAN)
    phi, psi = turn*t, roll*t
    start = (-math.sin(LEAN)*math.sin(0), -math.sin(LEAN)*math.cos(0))
    xc = start[0] - roll/turn*math.sin(phi)
    zc = start[1] - roll/turn*(math.cos(phi) - 1)
    at = (xc + math.sin(LEAN)*math.sin(phi), math.cos(LEAN),
          zc + math.sin(LEAN)*math.cos(phi))
    return at, (xc, 0, zc), phi, psi


def rim_point(at, phi, angle, a):
    """(7): from the centre by a, at an angle in the coin's plane."""
    X = (math.cos(phi), 0, -math.sin(phi))
    s, c = math.sin(LEAN), math.cos(LEAN)
    Y = (s*math.sin(phi), c, s*math.cos(phi))
    return [r + a*(math.cos(angle)*u + math.sin(angle)*v)
            for r, u, v in zip(at, X, Y)]


def down(r):
    return 0.6*r[2] - 0.8*r[1]


def drawn():
    """The points that the last frame shows, in dots."""
    way = [coin(TIME*k/STEPS) for k in range(STEPS + 1)]
    x, y = [at[0] for at, *_ in way], [down(at) for at, *_ in way]
    spread = max(x) - min(x) + 2, max(y) - min(y) + 2
    scale = min(ACROSS/spread[0], DOWN/spread[1])
    middle = (max(x) + min(x))/2, (max(y) + min(y))/2
    at, _, phi, psi = way[-1]
    points = [contact for _, contact, *_ in way]
    points += [rim_point(at, phi, math.radians(k), 1) for k in range(360)]
    points += [rim_point(at, phi, psi, k/60) for k in range(60)]
    return [(ACROSS/2 + scale*(r[0] - middle[0]),
             DOWN/2 + scale*(down(r) - middle[1])) for r in points]


def last_frame():
    said, status = played("--scene", "circle", "--duration", str(TIME))
    assert status == 0, status
    assert said.index(HIDDEN) < said.rindex(SHOWN) > said.rindex(HIDDEN)
    frame = re.sub(r"\033\[[?\d;]*[A-Za-z]", "", said.split(HIDDEN)[-1])
    row = frame.split("\n")[3].split()
    want = math.degrees(LEAN), math.degrees(coin(TIME)[2])
    assert float(row[0]) == TIME and row[-1] == "rolls", row
    assert abs(float(row[1]) - want[0]) < 0.006, row
    assert abs(float(row[2]) - want[1]) < 0.06, row
    lit, points = dots(frame), drawn()
    # A point on the edge of a dot may be rounded to either side.
    sure = {(int(x), int(y)) for x, y in points
            if 1e-6 < x % 1 < 1 - 1e-6 and 1e-6 < y % 1 < 1 - 1e-6}
    near = {(int(x + e), int(y + f)) for x, y in points
            for e in (-1e-6, 1e-6) for f in (-1e-6, 1e-6)}
    assert sure <= lit <= near, (sorted(sure - lit), sorted(lit - near))


def interrupted():
    said, status = played("--scene", "circle", frames=3)
    assert status in (130, -signal.SIGINT), status
    assert said.rstrip().endswith(SHOWN), said[-40:]


def no_terminal():
    run = subprocess.run([PROGRAM, "--live"], capture_output=True, text=True)
    assert run.returncode == 1 and not run.stdout, run
    assert "not a terminal" in run.stderr, run


last_frame()
interrupted()
no_terminal()
