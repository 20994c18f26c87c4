#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""random.csv: where 100 random coins are after 100 natural units of time.

Rings of any inner radius b, M = a = g = 1, rates up to 2, |theta| <= 1, the
pose 0 at the start; columns with a 0 are the start, in doubles taken exactly.
By the Taylor series of make_reference.py in 30 digits, of which 16 are
printed; for every tenth a series of other order must agree to 1e-18.
amp is that of add_amp.py.

usage: make_random.py [FILE]    (needs python3-mpmath and python3-scipy)
"""
import csv
import pathlib
import random
import subprocess
import sys
import tempfile

from mpmath import nstr

from make_reference import motion_twice, number

HERE = pathlib.Path(__file__).resolve().parent
SCENES, TIME = 100, 100.0
STATE = "theta phi psi x z wX wY wZ".split()


def start(r):
    u = r.uniform
    return (u(0, 1), u(-1, 1), u(-2, 2), u(-2, 2), u(-2, 2))


def amp(b, theta, wX, wY, wZ, last):
    """The last amp of a file as add_amp.py reads and rewrites it."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "scene.csv"
        rows = [[0, theta, 0, 0, 0, 0, wX, wY, wZ],
                [TIME] + [nstr(last[name], 18) for name in STATE]]
        lines = [f"# M=1 a=1 b={b!r} g=1", "#",
                 ",".join(["t"] + STATE)]
        lines += [",".join(map(str, row)) for row in rows]
        file.write_text("\n".join(lines) + "\n")
        subprocess.run([sys.executable, HERE / "add_amp.py", file],
                       check=True, stdout=subprocess.DEVNULL)
        text = [l for l in file.read_text().splitlines() if l[0] != "#"]
        return list(csv.DictReader(text))[-1]["amp"]


def main():
    r = random.Random(100)
    out = sys.argv[1] if len(sys.argv) > 1 else HERE / "random.csv"
    lines = ["# random coins after 100 natural units: see make_random.py",
             ",".join(["b"] + [n + "0" for n in ("theta", "wX", "wY", "wZ")] +
                      STATE + ["amp"])]
    for i in range(SCENES):
        scene = start(r)
        last, = motion_twice(scene, [TIME], STATE, i % 10 == 0)
        cells = [repr(v) for v in scene]
        cells += [number(last[n], 16) for n in STATE]
        lines.append(",".join(cells + [amp(*scene, last)]))
        print(i, lines[-1][-8:], flush=True)
    pathlib.Path(out).write_text("\n".join(lines) + "\n")


main()
