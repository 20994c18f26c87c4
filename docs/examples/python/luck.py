#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Which side a tossed coin ends with, by the height at which it is let go and
its spin, at four restitutions: the maps of docs/luck.md, with matplotlib.

    python3 luck.py luck.png [COLUMNS]
"""
import sys

if not 2 <= len(sys.argv) <= 3 or not all(n.isdigit() for n in sys.argv[2:]):
    sys.exit("usage: python3 luck.py FILE [COLUMNS], such as luck.png 300")
columns = int(sys.argv[2]) if len(sys.argv) > 2 else 300
if columns < 3:
    sys.exit("luck.py: a map needs 3 columns or more")

import matplotlib.pyplot as pyplot
import numpy
import rollcoin as rc

disc = rc.disc(1, 1, 1)  # mass, radius and gravity are the units
heights = 20 * (numpy.arange(columns) + 0.5) / columns
spins = 8 * (numpy.arange(columns * 2 // 3) + 0.5) / (columns * 2 // 3)
figure, panels = pyplot.subplots(2, 2, figsize=(9, 6), layout="constrained")
for panel, restitution in zip(panels.flat, (0, 0.3, 0.5, 0.8)):
    table = rc.Table(mu_static=0.33, mu_kinetic=0.3, restitution=restitution)
    table.losses.flat = 1e-3
    coins = numpy.zeros((len(spins), len(heights)), rc.Body)
    coins["s"]["theta"] = numpy.nextafter(-numpy.pi / 2, 0)  # flat, heads up
    coins["s"]["wX"] = spins[:, None]
    coins["y"] = heights
    rc.move(coins, disc, table, numpy.inf, 1e-6, workers=-1)
    heads = coins["s"]["theta"] < 0
    panel.imshow(heads, origin="lower", extent=(0, 20, 0, 8), aspect="auto",
                 cmap="RdYlBu", vmin=-0.3, vmax=1.3,
                 interpolation="nearest")
    panel.set(title=f"restitution {restitution}: {heads.mean():.3f} heads")
figure.supxlabel("height, radii")
figure.supylabel("spin, sqrt(g/a)")
figure.savefig(sys.argv[1])
