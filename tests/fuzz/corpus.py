#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The kept inputs of the fuzz targets, in one text file.

    corpus.py unpack FILE FOLDER    FOLDER/TARGET/NUMBER, one for each input
    corpus.py pack FILE FOLDER      the reverse

FILE holds the name of each target on a line of its own and below it its inputs,
one per line in hexadecimal digits, indented.
"""
import pathlib
import shutil
import sys

HEAD = ("# Inputs of the fuzz targets: written by `make fuzz-corpus`, read by"
        " corpus.py.\n")


def unpack(file, folder):
    shutil.rmtree(folder, ignore_errors=True)
    target, number = None, 0
    for line in file.read_text().splitlines():
        if line.startswith("#"):
            continue
        if not line.startswith(" "):
            target, number = folder / line, 0
            target.mkdir(parents=True)
        else:
            number += 1
            (target / f"{number:04}").write_bytes(bytes.fromhex(line))


def pack(file, folder):
    targets = sorted(d for d in folder.iterdir() if d.is_dir())
    inputs = {d.name: sorted(f.read_bytes() for f in d.iterdir())
              for d in targets}
    if not all(inputs.values()):
        sys.exit(f"{folder}: a target has no input")
    file.write_text(HEAD + "".join(
        f"{name}\n" + "".join(f"  {data.hex()}\n" for data in kept)
        for name, kept in inputs.items()))


{"pack": pack, "unpack": unpack}[sys.argv[1]](*map(pathlib.Path, sys.argv[2:]))
