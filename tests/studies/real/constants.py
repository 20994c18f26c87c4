#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What random motions cost and err where a tuned number of lib/ is another.

    constants.py LIST LIB FOLDER N TABLES [NAME...]

For each number of LIST, or those named, FOLDER gets a copy of LIB with another
one, and of it the program tuning: $COMPILE makes an object, and $LINK and
$LIBRARIES the program.  The result becomes the table <!-- constants --> of
TABLES; of some names it is printed.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

COMPILE, LINK, LIBRARIES = (
    os.environ[name] for name in ("COMPILE", "LINK", "LIBRARIES"))
SHORT = {"SLIDES": "slips light onset", "LIVES": "settle rest"}
COSTS = ("within", "slopes", "margins", "looks")
ROW = re.compile(r"(\w+) +(\S+) +\d+  other (\d+)  .*99 % ([^,]+), most (\S+)"
                 r"(.*)")
HEAD = ("number", "is", "becomes", "cost", "99 % of errors", "largest",
        "otherwise")


def numbers(text):
    """(file, what, pattern, changes, kinds) of each number of the list."""
    for line in text.splitlines():
        if line.startswith("    "):
            what, change, kinds = (c.strip() for c in line.split("|"))
            at = re.search(r"\(([\d.e-]+)\)", what)
            pattern = (re.escape(what[:at.start()]) + r"([\d.e-]+)" +
                       re.escape(what[at.end():]) if at else
                       rf"#define {what} (.+)")
            for short, full in SHORT.items():
                kinds = kinds.replace(short, full)
            yield file, what, pattern, change.split(), kinds.split()
        elif line and line[0] != "#":
            file = line


class Copy:
    """A copy of lib/, of which the program is made."""

    def __init__(self, lib, folder):
        self.lib, self.folder = folder / "lib", folder
        shutil.rmtree(self.lib, ignore_errors=True)
        shutil.copytree(lib, self.lib)

    def build(self, file, numbers):
        """Makes it with numbers {pattern: what it becomes} of a file."""
        path = self.lib / file
        whole = text = path.read_text()
        for pattern, new in numbers.items():
            (found,) = re.finditer(pattern, text)
            text = text[:found.start(1)] + new + text[found.end(1):]
        path.write_text(text)
        sources = [path] if path.suffix == ".c" else [
            *self.lib.glob("real/*.c"), *self.lib.glob("air/*.c")]
        objects = [str(c.with_suffix(".o")) for c in sources]
        for c, o in zip(sources, objects):
            shell(f"{COMPILE} -c -o {o} {c}")
        shell(f"{LINK} -o {self.folder}/changed {' '.join(objects)} {LIBRARIES}")
        path.write_text(whole)


def shell(command):
    subprocess.run(command, shell=True, check=True)


def run(folder, n, kinds):
    """{(kind, tol): (cost, 99 % of the errors, largest, ended otherwise)}."""
    rows = {}
    for kind in kinds:
        out = subprocess.run(
            [folder / "changed", str(n), kind, folder / f"{kind}.{n}"],
            check=True, capture_output=True, text=True).stdout
        for _, tol, other, most99, most, counts in ROW.findall(out):
            count = dict(re.findall(r"(\w+) (\d+)", counts))
            cost = sum(int(count.get(c, 0)) for c in COSTS)
            rows[kind, tol] = (cost or int(count["steps"]), float(most99),
                               float(most), int(other))
    return rows


def grown(base, now, column):
    """The error that has grown most, and where."""
    kind, tol = max(base, key=lambda r: max(now[r][column], 1e-2) /
                    max(base[r][column], 1e-2))
    was, is_ = base[kind, tol][column], now[kind, tol][column]
    return "=" if was == is_ else f"{was:.2g} to {is_:.2g} ({kind} {tol})"


def cells(base, now):
    cost = sum(now[r][0] / base[r][0] for r in base) / len(base)
    others = [sum(r[3] for r in rows.values()) for rows in (base, now)]
    return [f"{cost:.3g}", grown(base, now, 1), grown(base, now, 2),
            "=" if others[0] == others[1] else "{} to {}".format(*others)]


def main(listing, lib, folder, n, tables, *names):
    folder = pathlib.Path(folder)
    copy = Copy(lib, folder)
    wanted = [r for r in numbers(pathlib.Path(listing).read_text())
              if not names or any(n in r[1] for n in names)]
    kinds = sorted({k for r in wanted for k in r[4]})
    for kind in kinds:
        (folder / f"{kind}.{n}").unlink(missing_ok=True)
    copy.build("real/flat_slide.c", {})
    base = run(folder, n, kinds)
    lines = [HEAD, ["---"] * len(HEAD)]
    for file, name, pattern, change, kinds in wanted:
        value = re.search(pattern, (copy.lib / file).read_text())[1]
        by = [f"{value} / {change[0]}", f"{value} * {change[0]}"]
        of = {r: v for r, v in base.items() if r[0] in kinds}
        for new in by if len(change) == 1 else change:
            copy.build(file, {pattern: f"({new})"})
            lines.append([f"`{name}` of {file}", value, new,
                          *cells(of, run(folder, n, kinds))])
            print(*lines[-1], sep=" | ", flush=True)
    table = "".join("| " + " | ".join(l) + " |\n" for l in lines)
    if not names:
        path = pathlib.Path(tables)
        path.write_text(re.sub(
            r"(<!-- constants -->\n).*?(<!-- end -->)",
            lambda m: m[1] + table + m[2], path.read_text(), flags=re.S))


main(*sys.argv[1:])
