#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Takes out of gnuplot's drawings what a reader does not see: empty groups,
groups that repeat the one before, attributes that are the default or the
group's, symbols and filters that nothing shows, digits of a pixel after the
first, and points that lie on a line without them.  Points of lines and polygons
are written relative to the point before, which packs better.

    slim.py DRAWING.svg...

Of matplotlib's drawings it takes those digits alone.  A second pass changes
nothing.  Drawings of other programs stay as they are.
"""
import math
import pathlib
import re
import sys

DEFAULTS = ' stroke-linecap="butt" stroke-linejoin="miter"'


def hexadecimal(colour):
    return "#" + "".join(f"{int(part):02X}" for part in colour.groups())


def tenths(text):
    """The points of a text of numbers, in tenths of a pixel."""
    numbers = [round(10 * float(v)) for v in re.findall(r"-?[\d.]+", text)]
    return list(zip(numbers[::2], numbers[1::2]))


def relative(points, at):
    steps = [(here - before) / 10
             for before, point in zip([at] + points, points)
             for before, here in zip(before, point)]
    return " ".join(f"{step:g}" for step in steps).replace(" -", "-")


def thinned(points):
    """A line without the points that are within 0.15 of a pixel of it (Ramer,
    Douglas, Peucker)."""
    (x0, y0), (x1, y1) = points[0], points[-1]
    dx, dy = x1 - x0, y1 - y0
    far, k = -1, 0
    for i, (x, y) in enumerate(points[1:-1], 1):
        along = (x - x0) * dx + (y - y0) * dy
        part = min(max(along / ((dx * dx + dy * dy) or 1), 0), 1)
        off = math.hypot(x - x0 - part * dx, y - y0 - part * dy)
        far, k = max((far, k), (off, i))
    if far <= 1.5:
        return points[:1] + points[1:][-1:]
    return thinned(points[:k + 1])[:-1] + thinned(points[k:])


def lines(path):
    """Lines in capitals are in places, others in steps from the point before."""
    each, x, y = [], 0, 0
    for letter, points in re.findall(r"([ML])([^ML]*)", path[2], re.I):
        for dx, dy in tenths(points):
            x, y = (dx, dy) if letter.isupper() else (x + dx, y + dy)
            if letter in "mM":
                each.append([])
                letter = "l" if letter == "m" else "L"
            each[-1].append((x, y))
    at, text = (0, 0), ""
    for line in map(thinned, each):
        text += "m" + relative(line[:1], at)
        text += "l" * (len(line) > 1) + relative(line[1:], line[0])
        at = line[-1]
    return path[1] + text + path[3]


def closed(polygon):
    points = relative(tenths(polygon[2]), (0, 0))
    return f"<path{polygon[1]}d = 'm{points}z'"


def slim(text):
    text = text.replace(DEFAULTS, "")
    text = re.sub(r'<tspan font-family="sans" +', "<tspan ", text)
    text = re.sub(r"rgb\( *(\d+), *(\d+), *(\d+)\)", hexadecimal, text)
    text = re.sub(r"""\b(?:d|points|transform) *= *(['"]).*?\1""",
                  lambda m: re.sub(r"(\d+\.\d)\d+(?=[\s,)'\"])", r"\1", m[0]),
                  text, flags=re.S)
    text = re.sub(r"(\bd *= *')(m[ml\d.,\s-]*)(')", lines, text,
                  flags=re.I)
    text = re.sub(r"<polygon([^>]*)points = '(.*?)'", closed, text, flags=re.S)
    count = 1
    while count:
        text, count = re.subn(r"<g [^>]*>\s*(<text></text>\s*)?</g>\n?", "", text)
    while joined(text) != text:
        text = joined(text)
    while shown(text) != text:
        text = shown(text)
    return re.sub(r" +'/>", "'/>", text)


def joined(text):
    """Two groups of areas with the same attributes, one after the other, as
    one group."""
    return re.sub(r"((<g [^>]*>\s*<g [^>]*crispEdges'>\n)(?:\t\t<path[^\n]*\n)+)"
                  r"\t</g>\n</g>\n\2", r"\1", text)


def shown(text):
    """Without the definitions that nothing refers to."""
    return re.sub(r"\t<(\w+)\b[^>]*\bid='(\w+)'[^>]*(?:/>|>.*?</\1>)\n",
                  lambda m: m[0] if f"#{m[2]}'" in text or f"#{m[2]})" in text
                  else "", text, flags=re.S)


for drawing in map(pathlib.Path, sys.argv[1:]):
    drawn = drawing.read_text()
    if "Produced by GNUPLOT" in drawn:
        drawing.write_text(slim(drawn))
    elif "Matplotlib" in drawn:
        # Of places, not of what a text says.
        drawing.write_text(re.sub(r"(\d\.\d)\d+(?![\d<])", r"\1", drawn))
