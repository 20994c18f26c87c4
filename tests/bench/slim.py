#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Takes out of gnuplot's drawings what a reader does not see: empty groups,
attributes that are the default or the group's, and digits of a pixel after the
first.  Points of a path are written by their way from the last.

    slim.py DRAWING.svg...

A second pass changes nothing.  Drawings of other programs stay as they are.
"""
import pathlib
import re
import sys

DEFAULTS = ' stroke-linecap="butt" stroke-linejoin="miter"'


def hexadecimal(colour):
    return "#" + "".join(f"{int(part):02X}" for part in colour.groups())


def short(tenths):
    whole, part = divmod(abs(tenths), 10)
    digits = f"{whole or ''}.{part}" if part else str(whole)
    return f"-{digits}" if tenths < 0 else digits


def relative(path):
    """d='M1.0,2.0 L3.0,2.5' as d='M1,2l2 .5'."""
    written, last = "", (0, 0)
    for letter, *point in re.findall(r"([ML]) *([-\d.]+),([-\d.]+)", path[2]):
        point = [round(10*float(v)) for v in point]
        if letter == "M":
            written += "M" + ",".join(map(short, point))
        else:
            way = [short(v - w) for v, w in zip(point, last)]
            written += "l" + " ".join(way).replace(" -", "-")
        last = point
    return path[1] + written + path[3]


def slim(text):
    text = text.replace(DEFAULTS, "")
    text = re.sub(r'<tspan font-family="sans" +', "<tspan ", text)
    text = re.sub(r"rgb\( *(\d+), *(\d+), *(\d+)\)", hexadecimal, text)
    text = re.sub(r"""\b(?:d|points|transform) *= *(['"]).*?\1""",
                  lambda m: re.sub(r"(\d+\.\d)\d+(?=[\s,)'\"])", r"\1", m[0]),
                  text, flags=re.S)
    text = re.sub(r"(\bd=')((?:\s*[ML] *-?[\d.]+,-?[\d.]+)+)\s*(')", relative,
                  text)
    count = 1
    while count:
        text, count = re.subn(r"<g [^>]*>\s*</g>\n?", "", text)
    return re.sub(r" +'/>", "'/>", text)


for drawing in map(pathlib.Path, sys.argv[1:]):
    drawn = drawing.read_text()
    if "Produced by GNUPLOT" in drawn:
        drawing.write_text(slim(drawn))
