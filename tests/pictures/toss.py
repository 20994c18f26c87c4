# SPDX-License-Identifier: MIT
"""The map of the faces that tosses end with: where a coin has not the energy to
stand up it shows the face that it began with; where it is thrown high and fast,
either face as often."""
import math
import re

from forms import near

COLUMNS, ROWS = 168, 120
HEIGHT, SPIN = 20, 8                             # of the first map


def heads(d):
    """The cells of a drawing's path."""
    return {(int(column) + k, ROWS - 1 - int(row))
            for column, row, length in re.findall(r"M(\d+) (\d+)h(\d+)", d)
            for k in range(int(length))}


def toss_map(drawing):
    paths = re.findall(r'stroke="#0072B2" d="([^"]*)"', drawing)
    near("tosses, maps", len(paths), 2, 0)
    found = heads(paths[0])
    far = []
    for column in range(COLUMNS):
        for row in range(ROWS):
            height = (column + 0.5)*HEIGHT/COLUMNS
            spin = (row + 0.5)*SPIN/ROWS
            if height + spin**2/8 < 1:
                near("tosses, low", (column, row) in found, 1, 0)
            if height > 10 and spin > 4:
                far.append((column, row) in found)
    near("tosses, either face", sum(far)/len(far), 0.5, 1.5/math.sqrt(len(far)))


def lean_map(drawing):
    """Launches that differ by 1e-4 rad rest more than a second apart; between
    such jumps the time changes by less than 0.05 s from one to the next."""
    paths = re.findall(r'stroke="#0072B2"[^>]* d="([^"]*)"', drawing)
    near("leans, panels", len(paths), 2, 0)
    times = [(288 - float(y))*12/244
             for y in re.findall(r"M[\d.]+ ([\d.]+)h0", paths[1])]
    near("leans, launches", len(times), 400, 0)
    steps = [abs(b - a) for a, b in zip(times, times[1:])]
    near("leans, jumps", max(steps) > 1, 1, 0)
    near("leans, between them", sum(step < 0.05 for step in steps) > 200, 1, 0)
