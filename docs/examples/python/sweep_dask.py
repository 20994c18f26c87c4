#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The sweep of tiles.py on Dask: on the processors of this machine, or on a
cluster whose scheduler has an address.

    python3 sweep_dask.py FOLDER [--workers N | --scheduler tcp://HOST:8786]

A worker that dies loses the tile that it was at; the scheduler gives it to
another.  Only this process writes to FOLDER.
"""
import os

import tiles
from distributed import Client, LocalCluster, as_completed


def local(workers):
    """A process for each worker: a batch takes one thread."""
    return LocalCluster(n_workers=workers, threads_per_worker=1,
                        dashboard_address=None)


def main():
    found, sweep, store = tiles.arguments(
        (["--workers"], {"type": int, "default": os.cpu_count()}),
        (["--scheduler"], {}))
    missing = store.missing()
    progress = tiles.Progress(sweep, len(missing))
    with Client(found.scheduler or local(found.workers)) as client:
        client.upload_file(tiles.__file__)
        asked = {client.submit(tiles.compute, sweep, number, pure=False):
                 number for number in missing}
        for future, result in as_completed(asked, with_results=True):
            store.put(asked.pop(future), *result)
            future.release()
            progress.tile()
    tiles.report(store)


if __name__ == "__main__":
    main()
