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


def played(*arguments, frames=None, **environment):
    """What the program writes to a terminal, and how it ends: interrupted, if
    so many frames are given, in the last of them."""
    ours, theirs = pty.openpty()
    known = {**os.environ, "TERM": "xterm", "NO_COLOR": "", **environment}
    with subprocess.Popen([PROGRAM, "--live", *arguments], stdout=theirs,
                          stdin=theirs, start_new_session=True,
                          env=known) as program:
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


def plain(text):
    """Without what moves the cursor or colours."""
    text = re.sub(r"\033\[[?\d;]*[A-Za-z]", "", text)
    return "\n".join(line.rstrip("\r").split("\r")[-1]
                     for line in text.split("\n"))


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
    """The points of the last frame, in dots: of the coin, of the newest part of
    the trail, of what may be lit besides, and of the table."""
    way = [coin(TIME*k/STEPS) for k in range(STEPS + 1)]
    x, z = [at[0] for at, *_ in way], [at[2] for at, *_ in way]
    left, right = min(x) - 1.5, max(x) + 1.5
    far, near = min(z) - 1.5, max(z) + 1.5
    top = min(min(down(at) for at, *_ in way) - 1, 0.6*far)
    scale = min(ACROSS/(right - left), DOWN/(0.6*near - top))
    middle = (left + right)/2, (0.6*near + top)/2
    at, _, phi, psi = way[-1]
    heads = 0.6*math.cos(LEAN)*math.cos(phi) - 0.8*math.sin(LEAN) > 0
    body = [rim_point(at, phi, math.radians(k), 1) for k in range(360)]
    body += [rim_point(at, phi, psi, k/60) for k in range(60)]
    if heads:
        body += [rim_point(at, phi, math.radians(k), 0.55) for k in range(360)]
    shadow = [rim_point(at, phi, math.radians(k), a/30) for k in range(360)
              for a in range(1, 31)]
    shadow = [(r[0], 0, r[2]) for r in shadow]
    trail = [contact for _, contact, *_ in way]
    table = [(left + (right - left)*k/400, 0, edge)
             for k in range(401) for edge in (far, near)]
    table += [(edge, 0, far + (near - far)*k/400)
              for k in range(401) for edge in (left, right)]

    def placed(points):
        return [(ACROSS/2 + scale*(r[0] - middle[0]),
                 DOWN/2 + scale*(down(r) - middle[1])) for r in points]
    part = (STEPS + 1)//6 + 1
    return (placed(body), placed(trail[1 - part:]),
            placed(trail[-3*part - 1:] + shadow + table), placed(table))


def sure(points):
    """Dots of points that rounding cannot move to another."""
    return {(int(x), int(y)) for x, y in points
            if 1e-6 < x % 1 < 1 - 1e-6 and 1e-6 < y % 1 < 1 - 1e-6}


def near(points):
    """Those that rounding may move them to."""
    return {(int(x + e), int(y + f)) for x, y in points
            for e in (-1e-6, 1e-6) for f in (-1e-6, 1e-6)}


def last_frame():
    said, status = played("--scene", "circle", "--duration", str(TIME))
    assert status == 0, status
    assert said.count("\033[2J") == 1, "each frame is written over the last"
    assert said.index(HIDDEN) < said.rindex(SHOWN) > said.rindex(HIDDEN)
    frame = plain(said.split(HIDDEN)[-1])
    rows = [row for row in frame.split("\n") if row.strip()]
    row = rows[3].split()
    want = math.degrees(LEAN), math.degrees(coin(TIME)[2])
    assert float(row[0]) == TIME and row[-1] == "rolls", row
    assert abs(float(row[1]) - want[0]) < 0.006, row
    assert abs(float(row[2]) - want[1]) < 0.06, row
    assert rows[-1] == "it rolls on after 8.00 sqrt(a/g)", rows[-1]
    lit, (body, new, others, table) = dots(frame), drawn()
    assert sure(body) <= lit <= near(body) | near(others) | near(new), \
        (sorted(sure(body) - lit), sorted(lit - near(body) - near(others)))
    hidden = near(body) | {(x, y) for x, y in lit if (x, y) not in near(others)}
    assert len(sure(new) & lit) > 0.6*len(sure(new)), "the new trail"
    assert {p for p in sure(table) - hidden if sum(p) % 2 == 0} <= lit, "the table"


def colours():
    said, _ = played("--scene", "circle", "--duration", "8")
    assert "\033[36m" in said, "a trail in colour"
    said, _ = played("--scene", "circle", "--duration", "8", NO_COLOR="1")
    assert not re.search(r"\033\[[\d;]*m", said), "NO_COLOR"
    said, status = played("--scene", "toss", TERM="dumb")
    assert status == 0 and "\033" not in said, "a dumb terminal"
    assert re.search(r"^(heads|tails|on its edge) after [\d.]+ s\r?$", said, re.M)


def tossed():
    said, _ = played("--scene", "toss", "--duration", "2")
    last = plain(said).strip().split("\n")[-1]
    assert re.fullmatch(r"(heads|tails) after [\d.]+ s", last), last


def on_edge_and_slope():
    for scene in "edge", "slope":
        said, status = played("--scene", scene, "--duration", "0.3")
        assert status == 0 and dots(plain(said.split(HIDDEN)[-1])), scene
        last = plain(said).strip().split("\n")[-1]
        assert last == "it rolls on after 0.30 s", last


def interrupted():
    said, status = played("--scene", "circle", frames=3)
    assert status in (130, -signal.SIGINT), status
    assert said.rstrip().endswith(SHOWN), said[-40:]


def no_terminal():
    run = subprocess.run([PROGRAM, "--live"], capture_output=True, text=True)
    assert run.returncode == 1 and not run.stdout, run
    assert "not a terminal" in run.stderr, run


last_frame()
colours()
tossed()
on_edge_and_slope()
interrupted()
no_terminal()
