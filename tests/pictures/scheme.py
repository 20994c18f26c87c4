#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes drawings legible in a dark scheme, and gives them titles.

    scheme.py ROOT [--check]     what may be wrong in docs/figures, or put right

A drawing of gnuplot gets the title that the page which shows it gives it as
alternative text; titles of its curves, which are gnuplot's commands, go.  Each
drawing gets a style sheet that replaces its colours where a reader prefers a
dark scheme.  A drawing that brings such a style sheet itself is left alone.  A
second pass changes nothing.
"""
import colorsys
import pathlib
import re
import sys

GROUND, INK = (13, 17, 23), (230, 237, 243)
NAMES = {"black": "#000000", "white": "#FFFFFF", "lightgrey": "#D3D3D3"}
CONTRAST = 4.5      # of a colour with the ground: enough for text (WCAG 1.4.3)
SHEET = re.compile(r'<style id="scheme">.*?</style>\n', re.S)


def channels(colour):
    digits = NAMES.get(colour, colour)[1:]
    wide = digits if len(digits) == 6 else "".join(2*d for d in digits)
    return tuple(int(wide[k:k + 2], 16) for k in (0, 2, 4))


def luminance(rgb):
    linear = [v/12.92 if v <= 0.04045 else ((v + 0.055)/1.055)**2.4
              for v in (part/255 for part in rgb)]
    return sum(w*v for w, v in zip((0.2126, 0.7152, 0.0722), linear))


def contrast(rgb):
    return (luminance(rgb) + 0.05)/(luminance(GROUND) + 0.05)


def dark(colour):
    """The same on a dark ground: greys between ink and ground as they were
    between black and white, pale colours dark, others light enough."""
    rgb = channels(colour)
    hue, light, pure = colorsys.rgb_to_hls(*(part/255 for part in rgb))
    if pure < 0.1:
        rgb = [i + light*(g - i) for i, g in zip(INK, GROUND)]
    elif light > 0.8:
        rgb = [255*v for v in colorsys.hls_to_rgb(hue, 1.1 - light, pure/3)]
    else:
        while contrast(rgb) < CONTRAST:
            light += 0.01
            rgb = [255*v for v in colorsys.hls_to_rgb(hue, light, pure)]
    return "#" + "".join(f"{round(part):02x}" for part in rgb)


def sheet(text):
    used = re.findall(r"\s(fill|stroke|color|flood-color) *= *"
                      rf"""["'](#\w+|{"|".join(NAMES)})["']""", text)
    rules = "".join(f'[{what}="{colour}"]{{{what}:{dark(colour)}}}\n'
                    for what, colour in sorted(set(used)))
    if "Matplotlib" in text:
        used = re.findall(r"(fill|stroke): (#\w+)", text)
        rules += "text{fill:" + dark("black") + "}\n" + "".join(
            f'[style*="{what}: {colour}"]{{{what}:{dark(colour)}!important}}\n'
            for what, colour in sorted(set(used)))
    return ('<style id="scheme">\n@media (prefers-color-scheme:dark){\n'
            f"{rules}}}\n</style>\n")


def titles(root):
    """{drawing: what the first page that shows it calls it, or else the README
    of the studies, which links to it}."""
    link = r"\[([^]]+)\]\([^)]*figures/([^)]+)\)"
    found = {}
    for page in [root/"README.md", *sorted((root/"docs").rglob("*.md"))]:
        for says, name in re.findall("!" + link, page.read_text()):
            found.setdefault(name, " ".join(says.split()))
    studies = (root/"tests/studies/README.md").read_text()
    for says, name in re.findall(link, studies):
        found.setdefault(name, says)
    return found


def finished(text, title):
    text = SHEET.sub("", text)
    if "prefers-color-scheme" in text:
        return text
    if "Produced by GNUPLOT" in text:
        text = re.sub(r"\s*<title>.*?</title>", "", text, flags=re.S)
        title = title[0].upper() + title[1:]
        text = text.replace("<desc>", f"<title>{title}</title>\n<desc>", 1)
    return re.sub(r"(</title>\n)", lambda m: m[1] + sheet(text), text, count=1)


def main(root, check):
    of, wrong = titles(root), []
    for drawing in sorted((root/"docs/figures").glob("*.svg")):
        drawn = drawing.read_text()
        if drawing.name not in of:
            sys.exit(f"{drawing}: no page shows it")
        done = finished(drawn, of[drawing.name])
        if done != drawn:
            wrong.append(drawing.name)
            if not check:
                drawing.write_text(done)
    if check and wrong:
        sys.exit("no title or no dark scheme, see make schemes: "
                 + " ".join(wrong))


main(pathlib.Path(sys.argv[1]), "--check" in sys.argv[2:])
