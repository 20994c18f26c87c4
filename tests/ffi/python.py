#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the Python package takes from the headers.

    python.py declarations INCLUDE   _declarations.py
    python.py tables INCLUDE         tables.h: the functions over tables
    python.py layout PACKAGE         sizes and offsets as ctypes has them, in
                                     the form of header.py's
"""
import ctypes
import importlib
import pathlib
import re
import sys
import textwrap
import types

import header

SIMPLE = {"double": "c_double", "float": "c_float", "int32_t": "c_int32",
          "uint32_t": "c_uint32", "uint64_t": "c_uint64", "size_t": "c_size_t"}
WHOLE = {"int32_t": "INT32", "uint32_t": "UINT32", "uint64_t": "UINT64",
         "size_t": "SIZE"}
PREFIX = re.compile(r"coin(f?)_")

# By the first constant of an enum: the class, its kind and what it is.
ENUMS = {"COIN_OK": ("Status", "IntEnum", "Error.status, and OK."),
         "COIN_SLIPS": ("Bits", "IntFlag",
                        "What a call that succeeded says of the coin."),
         "COIN_HEADS": ("Face", "IntEnum", "How a coin lies: body_face()."),
         "COIN_RK4": ("Method", "IntEnum", "Methods of integration.")}

# Functions that are not called as in C without the prefix.
RENAMED = {"params_disc": "disc", "params_ring": "ring", "params_body": "body",
           "params_cylinder": "cylinder", "batch_run": "run_batch", "orbit_init": "orbit"}

HEAD = '''\
# SPDX-License-Identifier: MIT
"""What coin.h and coinf.h declare: by `make bindings-update`."""
from ctypes import (Array, c_char_p, c_double, c_float, c_int32, c_size_t,
                    c_uint32, c_uint64)
from enum import IntEnum, IntFlag
from typing import Any, Dict, Tuple

from ._types import INT32, SIZE, UINT32, UINT64, In, Out, Plain

'''


def python_name(struct):
    """State of coin_state, Statef of coinf_state."""
    prefix = PREFIX.match(struct)
    words = struct[prefix.end():].title().replace("_", "")
    return words + prefix.group(1)


def member(kind):
    base = SIMPLE.get(kind.name) or python_name(kind.name)
    return f"{base} * {kind.length}" if kind.length else base


def annotation(kind):
    if kind.name not in SIMPLE:
        return python_name(kind.name)
    return f'"Array[{SIMPLE[kind.name]}]"' if kind.length else "float"


def argument(kind, counted):
    """`counted` if another argument says how many there are."""
    if kind.name == "char":
        return "c_char_p"
    if kind.pointers or kind.length:
        base = SIMPLE.get(kind.name) or python_name(kind.name)
        length = f", {kind.length}" if kind.length else (
            ", 0" if counted and not kind.const else "")
        return f"{'In' if kind.const else 'Out'}({base}{length})"
    return WHOLE.get(kind.name) or SIMPLE[kind.name]


def result(kind):
    return "c_char_p" if kind.pointers else SIMPLE[kind.name]


def wrapped(text, indent, columns=79):
    """Lines of at most so many columns, cut after commas."""
    lines = [""]
    for part in re.split(r"(?<=,) ", text):
        if lines[-1] and len(lines[-1]) + len(part) + 1 > columns:
            lines.append(" " * indent + part)
        else:
            lines[-1] += (" " if lines[-1] else "") + part
    return lines


def in_python(text):
    """A comment of coin.h with the names of Python."""
    text = re.sub(r"\bcoin_(\w+)\(\)",
                  lambda f: RENAMED.get(f[1], f[1]) + "()", text)
    text = re.sub(r"\bcoinf?_[a-z]+\b", lambda f: python_name(f[0]), text)
    return re.sub(r"\bCOIN_| _(?=[a-z]+\(\))",
                  lambda f: f[0].strip("COIN_"), text)


SI = {"M": "kg", "L": "m", "T": "s"}


def in_si(member, text):
    """A comment with its dimensions [L/T] as units [m/s]."""
    def units(found):
        if member[0] == "w" and found[0] == "[1/T]":
            return "[rad/s]"
        return re.sub("[MLT]", lambda f: SI[f[0]], found[0])
    return re.sub(r"\[[MLT1/^()0-9 ]+\]", units, text)


def docstring(head, said, tail):
    """Of a class: what it is, and what each member is.  A member without a
    comment has that of the one before."""
    def filled(text, first="    ", later="    "):
        return textwrap.fill(in_python(text), 79, initial_indent=first,
                             subsequent_indent=later)
    wide = max(map(len, said)) + 2
    yield filled(head, '    """')
    yield ""
    last = ""
    for member, text in said.items():
        last = in_si(member, text) or last
        yield filled(last, f"    {member:{wide}}", " " * (4 + wide))
    if tail:
        yield f"\n    {tail}"
    yield '    """'


def enums(include, found):
    said = header.comments(include)["enums"]
    values = header.constants(include)
    for names in found.enums:
        kind, base, head = ENUMS[names[0]]
        yield f"\nclass {kind}({base}):"
        yield from docstring(head, {name.removeprefix("COIN_"): said[name]
                                    for name in names}, "")
        yield from (f"    {name.removeprefix('COIN_')} = {values[name]}"
                    for name in names)
        yield ""
    yield ""
    for names in found.enums:
        for name in names:
            short = name.removeprefix("COIN_")
            yield f"{short} = {ENUMS[names[0]][0]}.{short}"


def declarations(include):
    found = header.read(include)
    said = header.comments(include)
    names = [*map(python_name, found.structs),
             *(kind for kind, _, _ in ENUMS.values()),
             *(name.removeprefix("COIN_") for some in found.enums
               for name in some)]
    listed = ", ".join(f'"{name}"' for name in names)
    yield from wrapped(f"__all__ = [{listed}]", 11, 79)
    yield ""
    for name, members in found.structs.items():
        yield f"\nclass {python_name(name)}(Plain):"
        head, of_members = said[name]
        shown = {m: text for m, text in of_members.items()
                 if not m.startswith("private_")}
        yield from docstring(
            head, shown, f"{name}, in SI units; any others that are "
            "consistent do as well.")
        yield "    __slots__ = ()"
        yield from (f"    {m}: {annotation(kind)}"
                    for m, kind in members.items())
        yield "    _fields_ = ["
        yield from (f'        ("{m}", {member(kind)}),'
                    for m, kind in members.items())
        yield "    ]\n"
    yield ""
    yield from enums(include, found)
    yield "\nSTRUCTS = {"
    yield from (f'    "{name}": {python_name(name)},'
                for name in found.structs)
    yield "}"
    yield "\n# Name: (result, {argument: type})"
    yield "PROTOTYPES: Dict[str, Tuple[Any, Dict[str, Any]]] = {"
    for name, (kind, arguments) in found.functions.items():
        counted = any(k.name == "size_t" and not k.pointers
                      for k in arguments.values())
        listed = ", ".join(
            f'"{"losses" if a == "l" else a}": {argument(k, counted)}'
            for a, k in arguments.items())
        line = f'    "{name}": ({result(kind)}, {{{listed}}}),'
        yield from wrapped(line.strip(), 8, 75)
    yield "}"


def indented(lines):
    return [f"    {line}" if line.startswith('"') else line for line in lines]


# ---------------------------------------------------------------------- tables
def first(arguments):
    return next(iter(arguments.items()), (None, None))


def over_coins(arguments):
    """Of a function that reads a coin or a body, or moves it by a time."""
    name, kind = first(arguments)
    if kind is None or kind.pointers != 1:
        return False
    return "reached" in arguments or (
        name in ("s", "b") and kind.const
        and not any(k.name == "size_t" for k in arguments.values()))


def over_times(arguments):
    """Of a function that gives a state at any time."""
    last = list(arguments)[-1:]
    return "t" in arguments and last == ["out"]


def declared(name, kind, table):
    const = "const " if kind.const or (table and name == "t") else ""
    star = "*" if kind.pointers or kind.length or (table and name == "t") \
        else ""
    return f"{const}{kind.name} {star}{name}"


def passed(name, kind, table):
    if not table:
        return name
    if not (kind.pointers or kind.length):
        return f"{name}[i]"
    return f"{name} + {kind.length} * i" if kind.length else f"{name} + i"


def row(prefix, function, arguments, tables, number=""):
    """EACH(name, (its arguments), the call), or EACH_NUMBER."""
    takes = ", ".join(declared(a, k, a in tables)
                      for a, k in arguments.items())
    gives = ", ".join(passed(a, k, a in tables) for a, k in arguments.items())
    if number:
        line = f"EACH_NUMBER({function}, {number}, ({takes}), ({gives}))"
    else:
        line = f"EACH({prefix}{function}, ({takes}), {function}({gives}))"
    yield from wrapped(line, 5, 80)


def outputs(arguments):
    return {a for a, k in arguments.items()
            if (k.pointers or k.length) and not k.const}


def tables(include):
    yield "/* SPDX-License-Identifier: MIT */"
    yield "/* The functions of coin.h and coinf.h that read or move a coin," \
        " for each of a"
    yield " * table; and those that give a state at a time, for a table of" \
        " times: by"
    yield " * `make bindings-update`. */"
    for function, (kind, arguments) in header.read(include).functions.items():
        taken = outputs(arguments)
        if over_coins(arguments):
            yield from row("each_", function, arguments,
                           taken | {first(arguments)[0]},
                           "" if kind.name == "int32_t" else kind.name)
        if over_times(arguments):
            yield from row("times_", function, arguments,
                           taken | {"t"})


# ---------------------------------------------------------------------- layout
def layout(package):
    """Without the package's __init__, which needs the library."""
    rollcoin = types.ModuleType("rollcoin")
    rollcoin.__path__ = [package]
    sys.modules["rollcoin"] = rollcoin
    declared_there = importlib.import_module("rollcoin._declarations")
    for name, kind in declared_there.STRUCTS.items():
        yield f"{name} size {ctypes.sizeof(kind)}"
        for field, _ in kind._fields_:
            place = getattr(kind, field)
            yield f"{name}.{field} offset {place.offset} size {place.size}"


def main(what, where):
    if what == "declarations":
        print(HEAD + "\n".join(indented(declarations(where))))
    elif what == "tables":
        print(*tables(where), sep="\n")
    elif what == "layout":
        print(*sorted(layout(str(pathlib.Path(where)))), sep="\n")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(*(sys.argv[1:] if len(sys.argv) == 3 else ("", "")))
