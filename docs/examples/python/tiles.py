#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A map of launches, cut into tiles.  Of the kind roll: a disc let go at every
lean, to the right, with a spin of 1.2 sqrt(g/a) in every direction of its plane
and axis; how far it leans after 24 natural units, or NaN if it came too near to
the table.  Of the kind toss: a disc let go with heads up, flat, from every
height to 20 radii with every spin to 8 sqrt(g/a) about a diameter; 1 for heads,
0 for tails.

A tile is one call of run_batch() or move().  It depends on nothing but its
number, so that any process, on any machine, may do it, twice too: its hash, of
all bits of all its states, comes out the same.  sweep_dask.py and sweep_mpi.py
share tiles out; this program does them one by one.

    python3 tiles.py FOLDER [--kind roll|toss] [--leans N] [--spins N] [--rows N]

A tile that is done is a file in FOLDER, so that a sweep that was stopped, in
whatever way, goes on where it was.
"""
import argparse
import hashlib
import os
import pathlib
import time
from typing import NamedTuple

import numpy
import rollcoin as rc

DT, STEPS = 0.1, 240


class Sweep(NamedTuple):
    """leans, or heights, times spins launches; a tile is so many rows of one
    lean each."""
    leans: int
    spins: int
    rows: int
    kind: str

    @property
    def tiles(self):
        return -(-self.leans // self.rows)

    def parts(self, number):
        """How far each row of a tile is in the sweep, 0 to 1."""
        first = number * self.rows
        rows = numpy.arange(first, min(first + self.rows, self.leans))
        return ((rows + 0.5) / self.leans)[:, None]

    def launches(self, number):
        """The table of a tile, (rows, spins)."""
        leans = 1.4 * self.parts(number)
        angle = numpy.arange(self.spins) * (2 * numpy.pi / self.spins)
        table = numpy.zeros((len(leans), self.spins), rc.State)
        table["theta"] = leans
        table["wY"] = 1.2 * numpy.sin(angle)
        table["wZ"] = 1.2 * numpy.cos(angle)
        return table

    def tosses(self, number):
        """The same, of bodies."""
        heights = 20 * self.parts(number)
        bodies = numpy.zeros((len(heights), self.spins), rc.Body)
        bodies["y"] = heights
        bodies["s"]["theta"] = numpy.nextafter(-numpy.pi / 2, 0)
        bodies["s"]["wX"] = 8 * (numpy.arange(self.spins) + 0.5) / self.spins
        return bodies


def roll(sweep, number):
    table = sweep.launches(number)
    status = rc.run_batch(table, rc.disc(1, 1, 1), rc.RK8, DT, STEPS)
    return table, status, table["theta"]


def toss(sweep, number):
    bodies = sweep.tosses(number)
    status = numpy.zeros(bodies.shape, numpy.int32)
    table = rc.Table(mu_static=0.33, mu_kinetic=0.3, restitution=0.5)
    table.losses.flat = 1e-3
    rc.move(bodies, rc.disc(1, 1, 1), table, numpy.inf, 1e-6, status=status)
    return bodies, status, bodies["s"]["theta"] < 0


KINDS = {"roll": roll, "toss": toss}


def compute(sweep, number):
    """A tile: its ends, NaN where a launch failed, and the hash of all bits."""
    table, status, ends = KINDS[sweep.kind](sweep, number)
    bits = hashlib.sha256(table.tobytes() + status.tobytes()).hexdigest()
    ends = numpy.where(status < 0, numpy.nan, ends)
    return ends.astype(numpy.float32), bits


# ------------------------------------------------------------------- the folder
class Store:
    """What is done of a sweep, by a version of the library, which the bits
    depend on: a file for each tile, whole or not there."""

    def __init__(self, folder, sweep):
        name = "x".join(map(str, sweep)) + f"-{rc.__version__}"
        self.folder = pathlib.Path(folder) / name
        self.folder.mkdir(parents=True, exist_ok=True)
        self.sweep = sweep

    def path(self, number):
        return self.folder / f"{number:06}.npz"

    def missing(self):
        there = {entry.name for entry in os.scandir(self.folder)}
        return [number for number in range(self.sweep.tiles)
                if self.path(number).name not in there]

    def put(self, number, ends, bits):
        """Under its name when it is complete: a rename is done or not."""
        part = self.path(number).with_suffix(f".{os.getpid()}.part")
        with open(part, "wb") as file:
            numpy.savez(file, ends=ends, bits=bits)
        part.replace(self.path(number))

    def joined(self):
        """The map, and the hash of all hashes."""
        tiles = [numpy.load(self.path(number))
                 for number in range(self.sweep.tiles)]
        bits = "".join(str(tile["bits"]) for tile in tiles)
        return (numpy.concatenate([tile["ends"] for tile in tiles]),
                hashlib.sha256(bits.encode()).hexdigest())


class Progress:
    """A line that says how far a sweep is."""

    def __init__(self, sweep, missing):
        self.sweep, self.begun, self.done = sweep, time.monotonic(), 0
        self.before = sweep.tiles - missing

    def tile(self, done=1):
        self.done += done
        taken = time.monotonic() - self.begun
        left = self.sweep.tiles - self.before - self.done
        print(f"\r{self.before + self.done} of {self.sweep.tiles} tiles, "
              f"{left * taken / max(self.done, 1):.0f} s to go ", end="",
              flush=True)


def arguments(*more):
    """(the parsed arguments, the Sweep, the Store)."""
    parser = argparse.ArgumentParser()
    parser.add_argument("folder")
    parser.add_argument("--kind", choices=KINDS, default="roll")
    parser.add_argument("--leans", type=int, default=4000)
    parser.add_argument("--spins", type=int, default=2500)
    parser.add_argument("--rows", type=int, default=10)
    for names, options in more:
        parser.add_argument(*names, **options)
    found = parser.parse_args()
    if min(found.leans, found.spins, found.rows) < 1:
        parser.error("nothing to sweep: each number is 1 or more")
    sweep = Sweep(found.leans, found.spins, found.rows, found.kind)
    return found, sweep, Store(found.folder, sweep)


def report(store):
    ends, bits = store.joined()
    failed = numpy.isnan(ends)
    says = (f"{failed.mean():.3f} of them near the table"
            if store.sweep.kind == "roll"
            else f"{ends[~failed].mean():.4f} of them heads")
    print(f"\n{ends.size} launches, {says}; hash {bits}")


def main():
    _, sweep, store = arguments()
    missing = store.missing()
    progress = Progress(sweep, len(missing))
    for number in missing:
        store.put(number, *compute(sweep, number))
        progress.tile()
    report(store)


if __name__ == "__main__":
    main()
