#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A quarter let go at one speed and many leans, in one numpy table.

A row of the table is a frame, with all coins side by side.  One call moves
them all where they lie, without a copy; the rest is numpy's.

    python3 launches.py
"""
import numpy
import rollcoin as rc

quarter = rc.disc(0.00567, 0.01213, 9.80665)
leans = numpy.linspace(0.1, 1.2, 12)
frames = numpy.zeros((241, len(leans)), rc.State)  # two seconds of 120 frames
frames[0]["theta"] = leans
frames[0]["wZ"] = 40

for before, now in zip(frames, frames[1:]):
    now[:] = before
    statuses = rc.run_batch(now, quarter, rc.RK8, 1 / 960, 8)
    assert max(map(abs, statuses)) == 0

lowest = numpy.abs(frames["theta"]).max(axis=0)
turned = frames["phi"][-1] / (2 * numpy.pi)
width = numpy.hypot(numpy.ptp(frames["x"], axis=0),
                    numpy.ptp(frames["z"], axis=0))
print("let go at   leans to   turns by      within")
for row in zip(leans, lowest, turned, width):
    print("{:5.1f} rad  {:5.3f} rad  {:5.2f} turns  {:6.3f} m".format(*row))
