#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The declarations of docs/examples/python/rollcoin.py, from the header.

    python.py write INCLUDE MODULE     prints the module with them renewed
    python.py layout MODULE            prints sizes and offsets as ctypes has
                                       them, in the form of header.py's

Only coin.h: the single precision of coinf.h is for firmware.
"""
import ctypes
import importlib.util
import pathlib
import re
import sys

import header

SIMPLE = {"double": "c_double", "float": "c_float", "int32_t": "c_int32",
          "uint32_t": "c_uint32", "uint64_t": "c_uint64", "size_t": "c_size_t"}
BEGIN = re.compile(r"^# ---- declarations.*\n", re.M)
END = re.compile(r"^# ---- end of declarations", re.M)
PREFIX = "coin_"


def python_name(struct):
    return struct.removeprefix(PREFIX).title().replace("_", "")


def python_type(kind, argument):
    """A member's type, or an argument's, where an array is a pointer."""
    if kind.name == "char" and kind.pointers == 1:
        return "c_char_p"
    base = SIMPLE.get(kind.name) or python_name(kind.name)
    if kind.length and not argument:
        return f"{base} * {kind.length}"
    return f"POINTER({base})" if kind.pointers or kind.length else base


def declarations(include):
    found = header.read(include)
    for name, members in found.structs.items():
        if not name.startswith(PREFIX):
            continue
        yield f"class {python_name(name)}(Plain):"
        yield f'    """{name}."""'
        yield "    _fields_ = ["
        yield from (f'        ("{member}", {python_type(kind, False)}),'
                    for member, kind in members.items())
        yield "    ]\n\n"
    for name, value in header.constants(include).items():
        if name.startswith(PREFIX.upper()):
            yield f"{name.removeprefix(PREFIX.upper())} = {value}"
    yield "\n# Name: (result, arguments...)"
    yield "PROTOTYPES = {"
    for name, (result, arguments) in found.functions.items():
        if name.startswith(PREFIX):
            types = [python_type(result, False)]
            types += [python_type(kind, True) for kind in arguments.values()]
            yield from wrapped(name, types)
    yield "}\n\n"


def wrapped(name, types):
    lines = [f'    "{name}": (']
    for kind in types:
        if len(lines[-1]) + len(kind) > 76:
            lines.append(" " * 8)
        lines[-1] += kind + ", "
    lines = [line.rstrip() for line in lines]
    lines[-1] = (lines[-1] if len(types) == 1 else lines[-1][:-1]) + "),"
    return lines


def write(include, module):
    text = pathlib.Path(module).read_text()
    begin, end = BEGIN.search(text), END.search(text)
    return (text[:begin.end()] + "\n".join(declarations(include)) + "\n"
            + text[end.start():])


def layout(module):
    spec = importlib.util.spec_from_file_location("rollcoin", module)
    rollcoin = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(rollcoin)
    for kind in rollcoin.Plain.__subclasses__():
        name = kind.__doc__.rstrip(".")
        yield f"{name} size {ctypes.sizeof(kind)}"
        for member, _ in kind._fields_:
            place = getattr(kind, member)
            yield f"{name}.{member} offset {place.offset} size {place.size}"


if __name__ == "__main__":
    if sys.argv[1:2] == ["write"] and len(sys.argv) == 4:
        sys.stdout.write(write(sys.argv[2], sys.argv[3]))
    elif sys.argv[1:2] == ["layout"] and len(sys.argv) == 3:
        print(*sorted(layout(sys.argv[2])), sep="\n")
    else:
        sys.exit(__doc__)
