#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A quarter let go at one speed and many leans, in numpy arrays.

Each call fills a row of the table of paths where it lies, without a copy; all
that follows is numpy's.

    ROLLCOIN_LIBRARY=build/librollcoin.so python3 launches.py
"""
import numpy
import rollcoin as rc

quarter = rc.disc(0.00567, 0.01213, 9.80665)
leans = numpy.linspace(0.1, 1.2, 12)
paths = numpy.zeros((len(leans), 241), rc.State)  # two seconds of 120 frames

for lean, path in zip(leans, paths):
    rc.sample(rc.State(theta=lean, wZ=40), quarter, rc.RK8, 1 / 960, 8, path)

lowest = numpy.abs(paths["theta"]).max(axis=1)
turned = paths["phi"][:, -1] / (2 * numpy.pi)
width = numpy.hypot(numpy.ptp(paths["x"], axis=1),
                    numpy.ptp(paths["z"], axis=1))
print("let go at   leans to   turns by      within")
for row in zip(leans, lowest, turned, width):
    print("{:5.1f} rad  {:5.3f} rad  {:5.2f} turns  {:6.3f} m".format(*row))
