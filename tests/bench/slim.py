#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Takes out of gnuplot's drawings what a reader does not see: empty groups,
attributes that are the default or the group's, digits of a pixel after the
first, and points of a line within a tenth of a pixel of their neighbours'
chord.  Points of lines and polygons are written relative to the point before,
which packs better.

    slim.py DRAWING.svg...

A second pass changes nothing.  Drawings of other programs stay as they are.
"""
import math
import pathlib
import re
import sys

DEFAULTS = ' stroke-linecap="butt" stroke-linejoin="miter"'


def hexadecimal(colour):
    return "#" + "".join(f"{int(part):02X}" for part in colour.groups())


def in_tenths(text):
    """The points of "x,y x,y ...", in tenths of a pixel."""
    return [tuple(round(10 * float(v)) for v in point.split(","))
            for point in text.split()]


def thinned(points):
    """A line without the points that lie within a tenth of a pixel of it: the
    algorithm of Douglas and Peucker."""
    (x0, y0), (x1, y1) = points[0], points[-1]
    chord = math.hypot(x1 - x0, y1 - y0)

    def distance(i):
        x, y = points[i][0] - x0, points[i][1] - y0
        return (abs(x * (y1 - y0) - y * (x1 - x0)) / chord if chord
                else math.hypot(x, y))

    far = max(range(1, len(points) - 1), key=distance, default=0)
    if not far or distance(far) <= 1:
        return [points[0], points[-1]]
    return thinned(points[:far + 1])[:-1] + thinned(points[far:])


def relative(points, at):
    """Each point as its difference from the one before, the first from `at`."""
    for x, y in points:
        yield f"{(x - at[0]) / 10:g},{(y - at[1]) / 10:g}"
        at = x, y


def lines(path):
    """A path of pieces "M x,y L x,y L x,y ..."."""
    written, at = [], (0, 0)
    for piece in path[2].split("M")[1:]:
        points = in_tenths(piece.replace("L", " "))
        if len(points) > 2:
            points = thinned(points)
        first, *rest = relative(points, at)
        written += ["m" + first] + ["l" + point for point in rest]
        at = points[-1]
    return path[1] + "".join(written) + path[3]


def closed(polygon):
    points = " ".join(relative(in_tenths(polygon[2]), (0, 0)))
    return f"<path{polygon[1]}d = 'm{points}z'"


def slim(text):
    text = text.replace(DEFAULTS, "")
    text = re.sub(r'<tspan font-family="sans" +', "<tspan ", text)
    text = re.sub(r"rgb\( *(\d+), *(\d+), *(\d+)\)", hexadecimal, text)
    text = re.sub(r"""\b(?:d|points|transform) *= *(['"]).*?\1""",
                  lambda m: re.sub(r"(\d+\.\d)\d+(?=[\s,)'\"])", r"\1", m[0]),
                  text, flags=re.S)
    text = re.sub(r"(\bd *= *')(M[ML\d.,\s-]*)(')", lines, text)
    text = re.sub(r"<polygon([^>]*)points = '(.*?)'", closed, text, flags=re.S)
    count = 1
    while count:
        text, count = re.subn(r"<g [^>]*>\s*</g>\n?", "", text)
    return re.sub(r" +'/>", "'/>", text)


for drawing in map(pathlib.Path, sys.argv[1:]):
    drawn = drawing.read_text()
    if "Produced by GNUPLOT" in drawn:
        drawing.write_text(slim(drawn))
