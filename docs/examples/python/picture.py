#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A US quarter for 0.6 s: its path, its lean, and the friction that it
needs, with matplotlib.

    python3 picture.py python.svg
"""
import sys

if len(sys.argv) != 2:
    sys.exit("usage: python3 picture.py FILE, such as python.svg or python.png")

import matplotlib
import matplotlib.pyplot as pyplot
import numpy
import rollcoin as rc

matplotlib.rcParams["svg.fonttype"] = "none"  # text stays text
matplotlib.rcParams["svg.hashsalt"] = "rollcoin"  # equal bytes

quarter = rc.disc(0.00567, 0.01213, 9.80665)  # kg, m, m/s^2
start = rc.State(theta=0.5, wZ=30)  # rad, rad/s
path = rc.sample(start, quarter, rc.RK8, 1e-3, 5, 121)

seconds = numpy.arange(len(path)) * 5e-3
contact = 1e3 * rc.contact(path, quarter)[0]  # mm
ratio = rc.reaction(path, quarter)["ratio"]

figure, axes = pyplot.subplot_mosaic(
    [["path", "lean"], ["path", "ratio"]], figsize=(8, 4),
    layout="constrained")
figure.suptitle("A US quarter in its first 0.6 s, at 30 rad/s and a lean of "
                "0.5 rad")
axes["path"].plot(contact[:, 0], contact[:, 2])
axes["path"].set(xlabel="x, mm", ylabel="z, mm", title="point of contact",
                 aspect="equal")
axes["path"].invert_yaxis()  # as seen from above
axes["lean"].plot(seconds, numpy.degrees(path["theta"]))
axes["lean"].set(ylabel="lean, degrees")
axes["ratio"].plot(seconds, ratio)
axes["ratio"].set(xlabel="s", ylabel="F/N")
figure.savefig(sys.argv[1], metadata={
    "Date": None, "Title": "Path, lean and friction of a quarter"})
