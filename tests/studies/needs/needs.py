#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tables of docs/choosing.md: of each line that needs.c printed, with the
instructions that callgrind counted for it, and of its errors of fixed steps.

    needs.py FOLDER PAGE
"""
import math
import pathlib
import re
import sys

STEP = 1496 # instructions of a textbook step, by which all pages count


def instructions(folder, k):
    """Of the k-th work, from 1."""
    return int(re.search(r"^totals: (\d+)", (folder / f"counts.{k}").read_text(),
                         re.M)[1])


def short(error):
    return "" if error == "nan" else re.sub(r"e([+-])0", r"e\1", error)


def needs(folder):
    yield "| need | call | textbook steps | error |"
    yield "|---|---|---|---|"
    before = ""
    for k, line in enumerate((folder / "rows").read_text().splitlines(), 1):
        need, call, parts, error = line.split(" | ")
        steps = instructions(folder, k) / float(parts) / STEP
        digits = max(0, 1 - math.floor(math.log10(steps)))
        yield (f"| {need if need != before else ''} | {call} | "
               f"{steps:,.{digits}f} | {short(error)} |")
        before = need


def fixed_steps(folder):
    yield ("| abs(dt) W | RK4 | worst | RK8 | worst | symplectic, order 2 | "
           "worst | order 4 | worst |")
    yield "|---|---|---|---|---|---|---|---|---|"
    yield from map(short, (folder / "steps").read_text().splitlines())


def main(folder, page):
    folder, page = pathlib.Path(folder), pathlib.Path(page)
    text = page.read_text()
    for mark, rows in ("needs", needs), ("fixed steps", fixed_steps):
        table = "\n".join(rows(folder))
        text, found = re.subn(rf"(<!-- {mark} -->\n).*?(<!-- end -->)",
                              lambda m: m[1] + table + "\n" + m[2], text,
                              flags=re.S)
        if found != 1:
            sys.exit(f"{page} has no place for the table {mark}")
    page.write_text(text)


main(*sys.argv[1:])
