#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Takes out of gnuplot's drawings what a reader does not see: empty groups,
groups that repeat the one before, attributes that are the default or the
group's, symbols and filters that nothing shows, and digits of a pixel after the first.  Points of lines and polygons
are written relative to the point before, which packs better.

    slim.py DRAWING.svg...

Of matplotlib's drawings it takes those digits alone.  A second pass changes
nothing.  Drawings of other programs stay as they are.
"""
import pathlib
import re
import sys

DEFAULTS = ' stroke-linecap="butt" stroke-linejoin="miter"'


def hexadecimal(colour):
    return "#" + "".join(f"{int(part):02X}" for part in colour.groups())


def relative(pieces):
    """Points "x,y x,y ..." of one piece after another as differences."""
    at = [0, 0]
    for piece in pieces:
        steps = []
        for point in piece.split():
            tenths = [round(10 * float(v)) for v in point.split(",")]
            steps.append(",".join(f"{(new - old) / 10:g}"
                                  for new, old in zip(tenths, at)))
            at = tenths
        yield " ".join(steps)


def lines(path):
    parts = re.split(r"([ML])", path[2])
    parts[2::2] = relative(parts[2::2])
    return path[1] + "".join(parts).strip().lower() + path[3]


def closed(polygon):
    points, = relative([polygon[2]])
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
        drawing.write_text(re.sub(r"(\d\.\d)\d+", r"\1", drawn))
