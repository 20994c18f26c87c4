#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The sweep of tiles.py by MPI: each rank does every so-many-th of the tiles
that are missing, and puts them into FOLDER, which all ranks see.

    mpirun -n 64 python3 sweep_mpi.py FOLDER

MPI ends the whole job if a rank dies.  The same command then goes on: what is
lost is the tile that each rank was at.
"""
import tiles
from mpi4py import MPI


def main():
    world = MPI.COMM_WORLD
    _, sweep, store = tiles.arguments()
    missing = world.bcast(store.missing() if world.rank == 0 else None)
    progress = tiles.Progress(sweep, len(missing))
    for number in missing[world.rank::world.size]:
        store.put(number, *tiles.compute(sweep, number))
        if world.rank == 0:  # the others are as far, but for a tile
            progress.tile(world.size)
    world.Barrier()
    if world.rank == 0:
        tiles.report(store)


if __name__ == "__main__":
    main()
