#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the public headers declare, read by pycparser.

Shared by the checks of the bindings and of the ABI.  As a program, prints one
list, a line each, sorted:

    header.py INCLUDE constants    COIN_ESTEP -3, as the compiler has them
    header.py INCLUDE layout       coin_state.theta offset 0 size 8, likewise
    header.py INCLUDE functions    int32_t coin_step(coin_state *s, ...)
    header.py INCLUDE macros       #define COIN_VERSION_MAJOR

CC is the compiler, cc if unset.
"""
import dataclasses
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from pycparser import c_ast, c_generator, c_parser

CC = os.environ.get("CC", "cc").split()
OURS = re.compile(r"coinf?_|COINF?_")


@dataclasses.dataclass(frozen=True)
class Type:
    """const NAME * ...[length]: all that the headers are made of."""
    name: str
    pointers: int = 0
    const: bool = False
    length: int = 0


@dataclasses.dataclass
class Header:
    structs: dict    # name -> {member: Type}
    enums: list      # of lists of names
    functions: dict  # name -> (Type of the result, {argument: Type})
    text: dict       # name of a function -> its prototype


def includes(include):
    return "".join(f"#include <{file.name}>\n"
                   for file in sorted(pathlib.Path(include).glob("*.h")))


def preprocess(include, *options):
    return subprocess.run(
        [*CC, "-E", "-DCOIN_API=", "-D__attribute__(x)=", *options,
         f"-I{include}", "-x", "c", "-"],
        input=includes(include), text=True, capture_output=True,
        check=True).stdout


def type_of(node):
    """The Type of a declaration's type; raises on what has none."""
    if isinstance(node, c_ast.ArrayDecl):
        inner = type_of(node.type)
        length = int(eval(c_generator.CGenerator().visit(node.dim), {}))
        return dataclasses.replace(inner, length=length * (inner.length or 1))
    if isinstance(node, c_ast.PtrDecl):
        inner = type_of(node.type)
        return dataclasses.replace(inner, pointers=inner.pointers + 1)
    if isinstance(node, c_ast.TypeDecl) and isinstance(
            node.type, c_ast.IdentifierType):
        return Type(" ".join(node.type.names), const="const" in node.quals)
    raise ValueError(f"{node.coord}: a kind of type that bindings do not know")


def arguments_of(function):
    found = {}
    for argument in function.args.params:
        if not isinstance(argument, c_ast.Typename):  # (void)
            found[argument.name] = type_of(argument.type)
    return found


def read(include):
    header = Header({}, [], {}, {})
    tree = c_parser.CParser().parse(preprocess(include, "-P"))
    for node in tree.ext:
        kind = node.type
        if isinstance(kind, c_ast.Enum):
            header.enums.append([e.name for e in kind.values.enumerators])
        elif not OURS.match(node.name or ""):
            pass
        elif isinstance(kind, c_ast.FuncDecl):
            header.functions[node.name] = (type_of(kind.type),
                                           arguments_of(kind))
            header.text[node.name] = c_generator.CGenerator().visit(node)
        elif isinstance(kind.type, c_ast.Struct):
            header.structs[node.name] = {
                member.name: type_of(member.type)
                for member in kind.type.decls}
    if not (header.structs and header.enums and header.functions):
        raise ValueError(f"{include}: nothing found")
    return header


def compiled(include, prints):
    """What a C program of these statements prints, sorted."""
    with tempfile.TemporaryDirectory() as folder:
        program = f"{folder}/program"
        code = (f"#include <stddef.h>\n#include <stdio.h>\n"
                f"{includes(include)}int main(void)\n{{\n"
                + "\n".join(prints) + "\nreturn 0;\n}\n")
        subprocess.run([*CC, f"-I{include}", "-x", "c", "-", "-o", program],
                       input=code, text=True, check=True)
        output = subprocess.run([program], capture_output=True, text=True,
                                check=True).stdout
    return output.splitlines()


def constants(include):
    """{name: value}, by the compiler."""
    lines = compiled(include, [f'printf("{name} %d\\n", (int){name});'
                               for names in read(include).enums
                               for name in names])
    return {name: int(value) for name, value in map(str.split, lines)}


def layout(include):
    """Lines: every struct's size, every member's offset and size."""
    prints = []
    for struct, members in read(include).structs.items():
        prints.append(f'printf("{struct} size %zu\\n", sizeof({struct}));')
        for member in members:
            prints.append(
                f'printf("{struct}.{member} offset %zu size %zu\\n", '
                f"offsetof({struct}, {member}), "
                f"sizeof((({struct} *)0)->{member}));")
    return compiled(include, prints)


def comments(include):
    """{struct: (what its comment says, {member: what its own says})}; as
    "enums" what those of constants say."""
    found = {}
    for file in sorted(pathlib.Path(include).glob("*.h")):
        for head, body, name in re.findall(
                r"/\*\*((?:(?!\*/).)*)\*/\s*typedef struct \w+ \{(.*?)\n\}"
                r" (\w+);", file.read_text(), re.S):
            found[name] = (plain(head), {
                member: plain(said) for member, said in re.findall(
                    r"(\w+)(?:\[\d+\])?;(?:\s*/\*\*<(.*?)\*/)?", body, re.S)})
        found["enums"] = found.get("enums", {}) | {
            name: plain(said) for name, said in re.findall(
                r"(COIN_\w+) = -?\d+,?\s*/\*\*<(.*?)\*/", file.read_text(),
                re.S)}
    return found


def plain(comment):
    """Its words on one line."""
    return " ".join(re.sub(r"^ *\* ?", "", comment, flags=re.M).split())


def macros(include):
    """Lines: the public macros; of the version, which every release changes,
    only the names."""
    text = preprocess(include, "-dM", "-UCOIN_API")
    found = [line for line in text.splitlines()
             if OURS.match(line.removeprefix("#define "))]
    return [re.sub(r"(_VERSION_\w+) .*", r"\1", line) for line in found]


LISTS = {
    "constants": lambda i: [f"{k} {v}" for k, v in constants(i).items()],
    "layout": layout,
    "functions": lambda i: list(read(i).text.values()),
    "macros": macros,
}

if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[2] not in LISTS:
        sys.exit(__doc__)
    print(*sorted(LISTS[sys.argv[2]](sys.argv[1])), sep="\n")
