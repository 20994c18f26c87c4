#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Does what docs/first-hour.md says, in a copy of the sources.

Its blocks are taken in order: C is saved under the name in its first line, a
shell's commands are run, and a block of text is what those before it print.

    first_hour.py SRC FOLDER
"""
import pathlib
import re
import shutil
import subprocess
import sys


def main(src, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in "Makefile", "CHANGELOG.md", "README.md", "LICENSE", "include", \
            "lib", "pkgconfig", "docs", "tests/studies":
        subprocess.run(["cp", "-r", "--parents", name, folder], cwd=src,
                       check=True)
    printed, done = "", 0
    page = (src / "docs/first-hour.md").read_text()
    for kind, block in re.findall(r"```(\w+)\n(.*?)```", page, re.S):
        if kind == "c":
            name = re.match(r"/\* (\w+\.c) \*/", block)[1]
            (folder / name).write_text(block)
        elif kind == "sh":
            printed = subprocess.run(
                ["sh", "-ec", block], cwd=folder, check=True, text=True,
                stdout=subprocess.PIPE).stdout
            done += 1
        elif not printed.endswith(block):
            sys.exit(f"first-hour.md shows\n{block}and this is\n{printed}")
    for drawing in "path.svg", "lean.svg":
        if "<path" not in (folder / drawing).read_text():
            sys.exit(f"{drawing} shows nothing")
    print(f"{done} blocks of commands of first-hour.md do what it says")


main(*map(pathlib.Path, sys.argv[1:]))
