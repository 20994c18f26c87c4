#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""spins.csv: discs and hoops that spin nearly upright, after 1 and 8 units.

M = a = g = 1, inner radius b, the pose 0 at the start; columns with a 0 are
the start, in doubles taken exactly.  wY0 is above the critical spin, so that
the lean swings and stays small; wX0 and wZ0 are theta0 wY0 times -1, 0 or 1.
By the Taylor series of make_reference.py in 30 digits, of which 17 are
printed; for every sixth a series of other order must agree to 1e-18.

usage: make_spins.py [FILE]    (needs python3-mpmath)
"""
import pathlib
import sys

from make_reference import motion_twice, number

HERE = pathlib.Path(__file__).resolve().parent
LEANS = (1e-9, 1e-7, 1e-5, 1e-3, 0.02, 0.2)
SPINS = (1.5, 5.0, 22.0)
TIMES = [1.0, 8.0]
STATE = "theta phi psi x z".split()


def main():
    out = sys.argv[1] if len(sys.argv) > 1 else HERE / "spins.csv"
    lines = ["# coins that spin nearly upright: see make_spins.py",
             ",".join(["b"] + [n + "0" for n in ("theta", "wX", "wY", "wZ")] +
                      ["t"] + STATE)]
    starts = [(b, lean, wY) for b in (0.0, 1.0) for lean in LEANS
              for wY in SPINS]
    for i, (b, lean, wY) in enumerate(starts):
        nudge = lean * wY
        scene = (b, lean, nudge * (i % 3 - 1), wY, nudge * (i // 3 % 3 - 1))
        rows = motion_twice(scene, TIMES, STATE, i % 6 == 0)
        for t, row in zip(TIMES, rows):
            lines.append(",".join(
                [repr(v) for v in scene] + [repr(t)] +
                [number(row[n]) for n in STATE]))
    pathlib.Path(out).write_text("\n".join(lines) + "\n")


main()
