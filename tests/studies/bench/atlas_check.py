#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Whether the ends that the atlas compares with are right: every EVERY-th of
them, and each family's last, again by the Taylor series of tests/reference, 30
digits.

    bench_accuracy atlas references | atlas_check.py [EVERY]

Needs python3-mpmath; python3-gmpy2 makes it faster.
"""
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).parents[2] / "reference"))
import make_reference

DIGITS, ORDER = 30, 36
# An error of the reference is to be lost in 0.1, where right ends.
MOST = 1e-4
every = int(sys.argv[1]) if len(sys.argv) > 1 else 8

rows = [line.strip().split(",") for line in sys.stdin]
starts = [n for n, r in enumerate(rows) if float(r[5]) == 0]
lasts = [n for n in starts
         if n + 3 == len(rows) or rows[n + 3][0] != rows[n][0]]
chosen = sorted({*starts[::every], *lasts})
worst = {}
for n in chosen:
    a, g, hoop, _, *y0 = map(float, rows[n][2:])
    times = [float(r[5]) for r in rows[n + 1:n + 3]]
    ends = make_reference.integrate(
        ("", 1.0, a, a * hoop, g, *y0[:4], times, ""), DIGITS, ORDER)
    for row, end in zip(rows[n + 1:n + 3], ends):
        found = list(map(float, row[6:]))
        truth = [float(v) for v in end]
        error = max(abs(found[i] - truth[i]) / (a if i > 5 else 1)
                    for i in (0, 4, 5, 6, 7))
        worst[row[0]] = max(worst.get(row[0], (0, 0)), (error, float(row[1])))
for family, (error, x) in worst.items():
    print(f"{family}: off by {error:.1e} at most, x = {x:g}")
print(f"{len(chosen)} scenes of {len(starts)}")
sys.exit(not worst or any(not error <= MOST for error, _ in worst.values()))
