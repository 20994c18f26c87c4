# SPDX-License-Identifier: MIT
"""Where the labels of curves go: beside its own curve, on no other, on no other
label and within the panel.

A panel is a bitmap of its pixels, one number for each row.
"""
import math

LETTER, LINE = 0.57, 1.1  # width and height of text, in sizes of its font
MARK = 5                  # half the size of a mark [pixels]
AROUND = [(math.cos(k*math.pi/6), math.sin(k*math.pi/6)) for k in range(12)]


class Panel:
    """So many pixels, from (x0, y0) to (x1, y1), logarithmic."""

    def __init__(self, width, height, x, y, font=11):
        self.width, self.height, self.font = width, height, font
        self.x, self.y = ([math.log10(v) for v in ends] for ends in (x, y))
        self.taken = [0]*height

    def pixel(self, x, y):
        (x0, x1), (y0, y1) = self.x, self.y
        return ((math.log10(x) - x0)/(x1 - x0)*self.width,
                (math.log10(y) - y0)/(y1 - y0)*self.height)

    def value(self, across, up):
        (x0, x1), (y0, y1) = self.x, self.y
        return (10**(x0 + across/self.width*(x1 - x0)),
                10**(y0 + up/self.height*(y1 - y0)))

    def drawn(self, points):
        """The bitmap of a line, or of a mark; and places along it."""
        rows, places = [0]*self.height, []
        pixels = [self.pixel(*p) for p in points]
        if len(pixels) == 1:
            (across, up), = pixels
            for k in range(max(int(up) - MARK, 0),
                           min(int(up) + MARK + 1, self.height)):
                rows[k] |= (1 << 2*MARK + 1) - 1 << max(int(across) - MARK, 0)
            return rows, pixels
        for (a, b), (c, d) in zip(pixels, pixels[1:]):
            n = int(2*math.hypot(c - a, d - b)) + 1
            for k in range(n + 1):
                across, up = a + (c - a)*k/n, b + (d - b)*k/n
                if 0 <= across < self.width and 0 <= up < self.height:
                    rows[int(up)] |= 1 << int(across)
                    places.append((across, up))
        return rows, places[::16] + places[-1:]

    def box(self, text):
        return LETTER*self.font*len(text), LINE*self.font

    def free(self, rows, at, size, gap):
        """Whether a box around a place, and so much more, is free."""
        left, low = (round(v - s/2 - gap) for v, s in zip(at, size))
        right, high = (round(v + s/2 + gap) for v, s in zip(at, size))
        if left + gap < 0 or low + gap < 0 or right - gap >= self.width or \
                high - gap >= self.height:
            return False
        left, low, high = max(left, 0), max(low, 0), min(high, self.height)
        mask = (1 << max(right - left, 1)) - 1 << left
        return not any(row & mask for row in rows[low:high])

    def reserve(self, at, size):
        left, low = (round(v - s/2) for v, s in zip(at, size))
        mask = (1 << round(size[0])) - 1 << max(left, 0)
        for k in range(max(low, 0), min(round(low + size[1]), self.height)):
            self.taken[k] |= mask


def clear(rows, start, end):
    """Whether a leader from its curve to its label meets no other curve."""
    n = int(math.dist(start, end))
    return not any(rows[int(start[1] + (end[1] - start[1])*k/n)] >>
                   int(start[0] + (end[0] - start[0])*k/n) & 1
                   for k in range(4, n))


def candidates(panel, text, mine, all_rows, others, crossing=False):
    """(distance, place, where its leader begins, or None) of a label, nearest
    first.  One that is far, or near to another curve too, has a leader, which
    meets no other curve unless `crossing`."""
    size, found = panel.box(text.partition("\t")[0]), []
    is_mark = len(mine[1]) == 1
    nearest = MARK + 2 if is_mark else 4
    for start in mine[1]:
        for gap in (nearest, nearest + 4, 14, 22, 32, 44, 58, 76):
            for c, s in AROUND:
                edge = start[0] + c*gap, start[1] + s*gap
                at = (edge[0] + c*size[0]/2, edge[1] + s*size[1]/2)
                if not panel.free(all_rows, at, size, 2):
                    continue
                if gap < 14 and (is_mark or panel.free(others, at, size, gap)):
                    found.append((gap, at, None))
                elif gap >= 14 and not is_mark and \
                        (crossing or clear(others, start, edge)):
                    found.append((3*gap, at, (*start, *edge)))
    return sorted(found, key=lambda f: f[0])


def place(panel, curves, end):
    """{text: (x, y, leader)} of the labels' middles for {text: points}, left
    of x = end; a leader is None or (x, y, x, y).  What follows a tab is not
    shown."""
    edge = panel.pixel(end, 1)[0]
    if edge < panel.width:
        panel.reserve(((edge + panel.width)/2, panel.height/2),
                      (panel.width - edge, panel.height))
    drawn = {text: panel.drawn(points) for text, points in curves.items()
             if points}

    def union(but=None):
        rows = list(panel.taken)
        for text, (mine, _) in drawn.items():
            if text != but:
                rows = [a | b for a, b in zip(rows, mine)]
        return rows
    places = {}
    for crossing in (False, True):
        left = {text: mine for text, mine in drawn.items()
                if text not in places}
        while left:
            everything = union()
            options = {text: candidates(panel, text, mine, everything,
                                        union(text), crossing)
                       for text, mine in left.items()}
            text = min(options, key=lambda t: len(options[t]))
            del left[text]
            if options[text]:
                _, at, leader = options[text][0]
                places[text] = (*panel.value(*at), leader and (
                    *panel.value(*leader[:2]), *panel.value(*leader[2:])))
                panel.reserve(at, panel.box(text.partition("\t")[0]))
    return places
