# SPDX-License-Identifier: MIT
"""Draws the maps that a study of docs/luck.md writes: which side ends up, blue
heads and orange tails, the paler the more often the coin turned over.

    maps.py NAME <NAME.map >NAME.svg
"""
import base64
import math
import struct
import sys
import zlib

LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
HEADS = ("#08306b", "#08519c", "#2171b5", "#4f9bcb", "#8cc0de", "#c0d8ec")
TAILS = ("#7f2704", "#a63603", "#d94801", "#f16913", "#fda35c", "#fdd0a2")
INK, GROUND, LINE = "#222222", "white", "#808080"
LEFT, TOP, ACROSS, DOWN = 52, 74, 64, 74              # around a panel

# The key keeps its colours in a dark scheme: they are those of the map.
SCHEME = ("<style>\n@media (prefers-color-scheme:dark){\n"
          f'[fill="{GROUND}"]{{fill:#0d1117}}[fill="{INK}"]{{fill:#c9d1d9}}\n'
          "}\n</style>")

# A title, what is along the axis, and the columns of panels.
FIGURES = {
    "caught": ("A coin caught in the air: Keller's map, by coin_move",
               "height that it rises by, radii", 1),
    "dust": ("Bounces turn the map of a coin toss to dust",
             "height that it is let go at, radii", 2),
    "heights": ("Let go 2 degrees from flat, heads up: which side lands up",
                "height that it is let go at, radii", 1),
}


def shade(turns):
    return min(int(math.log2(turns//2 + 1)), len(HEADS) - 1)


def png(rows):
    """Two cells to a byte, each an index of the colours."""
    colours = [bytes.fromhex(c[1:]) for pair in zip(HEADS, TAILS) for c in pair]
    lines = b""
    for row in rows:
        cells = [2*shade(n) + n % 2 for n in map(LETTERS.index, row)]
        cells += [0]*(len(cells) % 2)
        lines += b"\0" + bytes(16*a + b for a, b in zip(cells[::2],
                                                        cells[1::2]))

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data
                + struct.pack(">I", zlib.crc32(kind + data)))
    size = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 4, 3, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size)
            + chunk(b"PLTE", b"".join(colours))
            + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def text(x, y, anchor, size, words):
    return (f'<text x="{x:g}" y="{y:g}" font-size="{size}" '
            f'text-anchor="{anchor}" fill="{INK}">{words}</text>')


def ticks(low, high):
    step = 10**math.floor(math.log10(high - low))
    step = next(part*step for part in (0.2, 0.5, 1, 2)
                if (high - low)/(part*step) <= 8)
    return [k*step for k in range(math.ceil(low/step), int(high/step + 1e-9) + 1)]


def panel(head, rows, x, y, along):
    title, left, right, bottom, top = head[1], *map(float, head[2:])
    wide, high = len(rows[0]), len(rows)
    image = base64.b64encode(png(rows)).decode()
    yield text(x, y - 8, "start", 13, title)
    yield (f'<image x="{x}" y="{y}" width="{wide}" height="{high}" '
           'style="image-rendering:pixelated" '
           f'href="data:image/png;base64,{image}"/>')
    for at in ticks(left, right):
        across = x + wide*(at - left)/(right - left)
        yield (f'<path stroke="{LINE}" d="M{across:.1f} {y + high}v4"/>')
        yield text(round(across, 1), y + high + 17, "middle", 12, f"{at:g}")
    for at in ticks(bottom, top):
        down = y + high*(top - at)/(top - bottom)
        yield f'<path stroke="{LINE}" d="M{x - 4} {down:.1f}h4"/>'
        yield text(x - 7, round(down + 4, 1), "end", 12, f"{at:g}")
    yield text(x + wide, y + high + 34, "end", 12, along)


def key():
    x = LEFT
    for name, colours in (("heads, as it began", HEADS), ("tails", TAILS)):
        for colour in colours:
            yield f'<rect x="{x}" y="34" width="11" height="14" fill="{colour}"/>'
            x += 11
        yield text(x + 6, 46, "start", 13, name)
        x += 140 if colours is HEADS else 60
    yield text(x, 46, "start", 13, "the paler, the more often it turned over")


def figure(name, maps):
    title, along, columns = FIGURES[name]
    wide = max(len(rows[0]) for _, rows in maps)
    high = max(len(rows) for _, rows in maps)
    width = LEFT + columns*wide + (columns - 1)*ACROSS + 24
    height = TOP + -(-len(maps)//columns)*(high + DOWN) - 32
    yield (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" '
           f'height="{height}" viewBox="0 0 {width} {height}" role="img" '
           'font-family="Helvetica, Arial, sans-serif">')
    yield f"<title>{title}</title>"
    yield SCHEME
    yield f'<rect width="100%" height="100%" fill="{GROUND}"/>'
    yield text(LEFT, 22, "start", 16, title)
    yield from key()
    for k, (head, rows) in enumerate(maps):
        yield from panel(head, rows, LEFT + k % columns*(wide + ACROSS),
                         TOP + k//columns*(high + DOWN), along)
    yield "</svg>"


def read(lines):
    maps = []
    for line in lines:
        if line.startswith("map|"):
            maps.append((line.rstrip("\n").split("|"), []))
        else:
            maps[-1][1].append(line.rstrip("\n"))
    return maps


print(*figure(sys.argv[1], read(sys.stdin)), sep="\n")
