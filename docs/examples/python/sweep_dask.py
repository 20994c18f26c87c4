#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The sweep of tiles.py on Dask: on the processors of this machine, or on a
cluster whose scheduler has an address.

    python3 sweep_dask.py FOLDER [--workers N | --scheduler tcp://HOST:8786]

A worker that dies loses the tile that it was at; the scheduler gives it to
another, until it has lost three or four.  Only this process writes to FOLDER.
"""
import os
import sys

import tiles
from distributed import Client, KilledWorker, LocalCluster, as_completed


def local(workers):
    """A process for each worker: a batch takes one thread."""
    return LocalCluster(n_workers=workers, threads_per_worker=1,
                        dashboard_address=None)


def main():
    try:
        sweep()
    except KilledWorker as lost:
        sys.exit(f"\nsweep_dask.py: the workers that took a tile died, the last "
                 f"{lost.last_worker.address}: is their memory too small?  The "
                 "same command goes on with the tiles that are missing.")


def sweep():
    found, launches, store = tiles.arguments(
        (["--workers"], {"type": int, "default": os.cpu_count()}),
        (["--scheduler"], {}))
    missing = store.missing()
    progress = tiles.Progress(launches, len(missing))
    with Client(found.scheduler or local(found.workers)) as client:
        client.upload_file(tiles.__file__)
        asked = {client.submit(tiles.compute, launches, number, pure=False):
                 number for number in missing}
        for future, result in as_completed(asked, with_results=True):
            store.put(asked.pop(future), *result)
            future.release()
            progress.tile()
    tiles.report(store)


if __name__ == "__main__":
    main()
