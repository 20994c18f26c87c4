#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What C# and JavaScript take from coin.h.

    declare.py csharp INCLUDE       rollcoin.cs, the whole of it
    declare.py typescript INCLUDE   rollcoin.d.ts, the types of rollcoin.mjs
    declare.py javascript INCLUDE   rollcoin.mjs, which it reads, with its lists
"""
import sys

import header

# By the first constant of an enum.
ENUMS = {"COIN_OK": "Status", "COIN_SLIPS": "Bits", "COIN_HEADS": "Face",
         "COIN_RK4": "Method"}
# What is a number in C.
NUMBERS = {"method": "Method", "stop": "Bits"}
# Words of C# and JavaScript that are names of arguments in coin.h.
WORDS = {"out": "result"}

CSHARP = '''\
// SPDX-License-Identifier: MIT
// librollcoin in C#, for .NET, Mono and Unity: by `make bindings-update`.
//
//     using Rollcoin;
//     Coin.ParamsDisc(out Params p, 0.00567, 0.01213, 9.80665);
//
// coin.h is the reference: coin_body_face() is Coin.BodyFace().  A negative
// status is thrown, as a CoinException.  What C takes by a pointer is a ref, an
// out or an array, whose length need not be told.
using System;
using System.Runtime.InteropServices;

namespace Rollcoin
{
    public class CoinException : Exception
    {
        public readonly Status Status;
        public CoinException(int status) : base(Coin.StatusString(status))
        {
            Status = (Status)status;
        }
    }

'''
COIN = '''\
    public static class Coin
    {
        // What the system looks for: librollcoin.so, rollcoin.dll,
        // librollcoin.dylib.
        const string Library = "rollcoin";

        // The structs here must be those of the library.
        static Coin()
        {
%s
        }

        static void Agrees(string type, Type here)
        {
            if (coin_sizeof(type) != Marshal.SizeOf(here))
                throw new TypeLoadException("rollcoin.cs is not of librollcoin "
                    + VersionString() + ": " + type);
        }

        static int Checked(int status)
        {
            if (status < 0)
                throw new CoinException(status);
            return status;
        }

        static void Holds(Array array, int length, string name)
        {
            if (array == null)
                throw new ArgumentNullException(name);
            if (array.Length < length)
                throw new ArgumentException(name + " has " + array.Length
                    + " elements, where " + length + " belong");
        }
'''


def title(name):
    return "".join(word.title() for word in name.split("_")[1:])


def doubles_only(found):
    """Without the functions and structs of coinf.h."""
    found.structs = {k: v for k, v in found.structs.items()
                     if k.startswith("coin_")}
    found.functions = {k: v for k, v in found.functions.items()
                       if k.startswith("coin_")}
    return found


# -------------------------------------------------------------------------- C#
PLAIN = {"double": "double", "int32_t": "int", "uint32_t": "uint",
         "uint64_t": "ulong", "size_t": "UIntPtr"}


def is_spare(member):
    return member == "reserved" or member.startswith("private_")


def fields(kind, member):
    base = PLAIN.get(kind.name) or title(kind.name)
    names = [f"{member}_{i}" for i in range(kind.length)] or [member]
    return f"{base} {', '.join(names)};"


def members(found, said, sizes):
    """A struct's last members are left to its size if no caller reads them: a
    struct has no arrays here, which would be copied at each call."""
    for name, struct in found.structs.items():
        last = max(i for i, m in enumerate(struct) if not is_spare(m)) + 1
        yield f"    [StructLayout(LayoutKind.Sequential, Size = {sizes[name]})]"
        yield f"    public struct {title(name)}"
        yield "    {"
        for member, kind in list(struct.items())[:last]:
            if is_spare(member):
                yield f"        readonly {fields(kind, member)}"
                continue
            text = said[name][1].get(member)
            yield from [f"        /// {text}"] if text else []
            yield f"        public {fields(kind, member)}"
        yield "    }\n"


class Argument:
    def __init__(self, name, kind, counted):
        self.name = WORDS.get(name, name)
        base = NUMBERS.get(name) or PLAIN.get(kind.name) or title(kind.name)
        # An output of whatever length another argument gives.
        self.many = (counted and kind.pointers == 1 and not kind.const
                     and kind.name != "size_t")
        self.length = kind.length
        out = name == "out" or kind.name in PLAIN
        if kind.name == "char":
            self.type, self.passed = "string", self.name
        elif self.many or kind.length:
            direction = "" if kind.const else "[In, Out] "
            self.type, self.passed = f"{direction}{base}[]", self.name
        elif kind.pointers:
            way = "ref" if kind.const or not out else "out"
            self.type, self.passed = f"{way} {base}", f"{way} {self.name}"
        else:
            self.type, self.passed = base, self.name
        self.declared = f"{self.type} {self.name}"
        self.public = self.declared.replace("[In, Out] ", "")
        if kind.name == "size_t" and not kind.pointers:
            self.public = ""  # the length of an array


def makes(function, arguments):
    """Functions that fill the struct that is their first argument."""
    first = next(iter(arguments.values()), None)
    return (first is not None and first.pointers and not first.const and
            any(word in function for word in
                ("params_", "_from_", "orbit_init", "steady_")))


def call(function, kind, arguments):
    counted = any(k.name == "size_t" and not k.pointers
                  for k in arguments.values())
    all_of = [Argument(a, k, counted) for a, k in arguments.items()]
    if makes(function, arguments):
        first = all_of[0]
        for field in ("declared", "public", "passed"):
            setattr(first, field, getattr(first, field).replace("ref", "out", 1))
    text = kind.pointers
    result = "IntPtr" if text else PLAIN[kind.name]
    given = "string" if text else result
    if kind.name == "int32_t":
        given = "Face" if function.endswith("_face") else "Bits"
    lines = ["", "        [DllImport(Library)]",
             f"        static extern {result} {function}("
             f"{', '.join(a.declared for a in all_of)});",
             f"        public static {given} {title(function)}("
             f"{', '.join(a.public for a in all_of if a.public)})",
             "        {"]
    many = [a for a in all_of if a.many]
    for a in all_of:
        if a.length:
            lines.append(f"            Holds({a.name}, {a.length}, "
                         f'"{a.name}");')
    for a in many[:1]:
        lines.append(f'            Holds({a.name}, 0, "{a.name}");')
    for a in many[1:]:  # which may be null
        lines += [f"            if ({a.name} != null)",
                  f"                Holds({a.name}, {many[0].name}.Length, "
                  f'"{a.name}");']
    passed = ", ".join(a.passed if a.public else
                       f"(UIntPtr){many[0].name}.Length" for a in all_of)
    value = f"{function}({passed})"
    if text:
        value = f"Marshal.PtrToStringAnsi({value})"
    elif kind.name == "int32_t":
        value = f"({given})Checked({value})"
    return [*lines, f"            return {value};", "        }"]


def csharp(include):
    found, said = doubles_only(header.read(include)), header.comments(include)
    values = header.constants(include)
    yield CSHARP.rstrip("\n") + "\n"
    for names in found.enums:
        kind = ENUMS[names[0]]
        yield from ["    [Flags]"] if kind == "Bits" else []
        yield f"    public enum {kind}"
        yield "    {"
        for name in names:
            yield f"        /// {said['enums'][name]}"
            yield f"        {name.removeprefix('COIN_')} = {values[name]},"
        yield "    }\n"
    sizes = dict(line.split(" size ") for line in header.layout(include)
                 if "." not in line)
    yield from members(found, said, sizes)
    yield (COIN % "\n".join(f'            Agrees("{name}", typeof('
                            f"{title(name)}));" for name in found.structs)
           ).rstrip("\n")
    for function, (kind, arguments) in found.functions.items():
        yield from call(function, kind, arguments)
    yield "    }\n}"


# ------------------------------------------------------- TypeScript, JavaScript
TYPESCRIPT = '''\
// SPDX-License-Identifier: MIT
// The types of rollcoin.mjs: by `make bindings-update`.

/** What the library is given by a pointer: from struct(), doubles(), ... */
export type Doubles = Float64Array;
/** From ints(). */
export type Ints = Int32Array;
/** From longs(). */
export type Longs = BigUint64Array;
export type StructName = keyof Structs;
'''
LOADED = '''\

/** Of the bytes of rollcoin.wasm; by itself of that which is beside this file. */
export function load(bytes?: BufferSource): Promise<Coin>;

export interface Coin {
  /** So many zeros. */
  doubles(count: number): Doubles;
  /** The same, for an int32_t or size_t. */
  ints(count: number): Ints;
  /** The same, for a uint64_t. */
  longs(count: number): Longs;
  /** The zeros of a struct of coin.h. */
  struct<Name extends StructName>(name: Name): Structs[Name];
  /** An array of C's, which is passed by the first. */
  structs<Name extends StructName>(name: Name, count: number): Structs[Name][];
  /** A coin_losses of these, or the losses of a coin_table. */
  losses(named: Losses): coin_losses;
  losses<Into extends coin_losses | coin_table>(named: Losses, into: Into): Into;'''
# The memory of WebAssembly has less than 2^31 bytes.
ARRAYS = {"double": "Doubles", "int32_t": "Ints", "size_t": "Ints",
          "uint64_t": "Longs"}


def script_type(name, kind):
    if kind.name == "char":
        return "string"
    if kind.pointers or kind.length:
        return ARRAYS["double" if kind.name.startswith("coin_")
                      else kind.name] + " | null"
    return "bigint" if kind.name == "uint64_t" else "number"


def script_member(member, kind):
    if kind.name == "double" and not kind.length:
        return f"{member}: number;"
    return f"readonly {member}: {ARRAYS.get(kind.name, kind.name)};"


def typescript(include):
    found, said = doubles_only(header.read(include)), header.comments(include)
    yield TYPESCRIPT.rstrip("\n")
    losses = [m for m in found.structs["coin_losses"] if not is_spare(m)]
    yield f"export type Losses = {{ {'; '.join(m + '?: number' for m in losses)} }};"
    yield f"export type Structs = {{ {'; '.join(f'{s}: {s}' for s in found.structs)} }};"
    yield "\n// The structs of coin.h: members by name, or by place."
    for name, struct in found.structs.items():
        yield f"export interface {name} extends Doubles {{"
        for member, kind in struct.items():
            if not is_spare(member):
                text = said[name][1].get(member)
                comment = f"/** {text} */ " if text else ""
                yield f"  {comment}{script_member(member, kind)}"
        yield "}"
    yield LOADED
    for name in sum(found.enums, []):
        yield f"  /** {said['enums'][name]} */ readonly {name}: number;"
    for function, (kind, arguments) in found.functions.items():
        if function != "coin_sizeof":
            given = ", ".join(f"{WORDS.get(a, a)}: {script_type(a, k)}"
                              for a, k in arguments.items())
            result = script_type("", kind) if not kind.pointers else "string"
            if function == "coin_method_name":
                result += " | null"
            yield f"  {function}({given}): {result};"
    yield "}"


# Between these lines rollcoin.mjs has what coin.h says.
FROM = "// From coin.h, by `make bindings-update`; members by their places, in doubles:\n"
UNTIL = "// Until here.\n"


def script_place(kind, offset, size):
    """A number, or where an array or a struct begins and ends."""
    place = [offset // 8, (offset + size) // 8]
    if kind.name != "double":
        return f'[{place[0]}, {place[1]}, "{kind.name}"]'
    return place if kind.length else place[0]


def javascript(include):
    found, values = doubles_only(header.read(include)), header.constants(include)
    at = {member: (int(offset), int(size)) for member, _, offset, _, size in
          (line.split() for line in header.layout(include) if "." in line)}
    before, rest = sys.stdin.read().split(FROM)
    yield before + FROM + "const CONSTANTS = {"
    for names in found.enums:
        yield "  " + " ".join(f"{name}: {values[name]}," for name in names)
    yield "};\nconst STRUCTS = {"
    for name, struct in found.structs.items():
        places = ", ".join(
            f"{member}: {script_place(kind, *at[f'{name}.{member}'])}"
            for member, kind in struct.items() if not is_spare(member))
        yield f"  {name}: {{ {places} }},"
    texts = ", ".join(f'"{function}"' for function, (kind, _)
                      in found.functions.items() if kind.pointers)
    yield f"}};\nconst TEXTS = [{texts}];"
    yield UNTIL + rest.split(UNTIL)[1].rstrip("\n")


if __name__ == "__main__":
    kinds = {"csharp": csharp, "typescript": typescript,
             "javascript": javascript}
    if len(sys.argv) != 3 or sys.argv[1] not in kinds:
        sys.exit(__doc__)
    print(*kinds[sys.argv[1]](sys.argv[2]), sep="\n")
