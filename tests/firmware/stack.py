# SPDX-License-Identifier: MIT
"""The deepest stack below a function, from the graph of calls.

The frames and calls of what gcc compiled here are its own word
(-fcallgraph-info=su); those of libgcc and libm, which come compiled, are read
off their instructions in a program that holds them, where they are Thumb or
RISC-V without an operating system.
"""
import re
import subprocess

NODE = re.compile(r'node: { title: "([^"]*)" label: "[^"]*?'
                  r'(?:\\n(\d+) bytes \(([\w,]+)\))?"')
EDGE = re.compile(r'edge: { sourcename: "([^"]*)" targetname: "([^"]*)"'
                  r'(?: label: "[^"]*?([^/"]*\.[ch]):)?')

# What a call through a pointer may reach, by the file that it stands in; of
# coin_priv_root(), by the file that calls it.
POINTERS = {"dop853.c": ("coin_priv_rates", "coin_priv_slow_rates",
                         "flat_slide.c:slide_slopes", "line.c:line_slopes",
                         "line.c:roll_slopes"),
            "move.c": ("coin_priv_rates", "coin_priv_slow_rates"),
            "line.c": ("line.c:line_slopes", "line.c:roll_slopes"),
            "contact.c": ("coin_priv_plain_contact",
                          "coin_priv_thick_contact"),
            "root.c, events.c": ("events.c:value",),
            "root.c, contact.c": ("contact.c:turn_away",),
            "events.c": ("events.c:above_flat", "events.c:this_side",
                         "events.c:this_rim", "events.c:undecided",
                         "events.c:above_rest", "events.c:within_cone",
                         "events.c:can_hold", "events.c:stays_slow")}

ROOT = "coin_priv_root"

LABEL = re.compile(r"^([0-9a-f]+) <(.*)>:$")
CODE = re.compile(r"^ *([0-9a-f]+):\t(\S+)(?:\t(.*?))?(?:\s[@;#]\s.*)?$")
TARGET = re.compile(r"\b([0-9a-f]+) <")
ENDS = re.compile(r"^(b|b\.n|b\.w|bx|j|ret|jr|pc)$")


def registers(text):
    """How many registers a list such as {r4-r7, lr} or {d8, d9} holds."""
    count = 0
    for part in text.strip("{} ").split(","):
        ends = [int(n) for n in re.findall(r"[a-z]+(\d+)", part)]
        count += ends[1] - ends[0] + 1 if len(ends) == 2 else 1
    return count


def pushed(name, args):
    """Bytes by which an instruction of Thumb or RISC-V lowers the stack."""
    if name.startswith(("push", "vpush", "stmdb")) and (
            name[0] != "s" or args.startswith("sp!")):
        wide = 8 if "{d" in args else 4
        return wide * registers(args[args.index("{"):])
    at = re.match(r"sp, (?:sp, )?#(\d+)", args)
    if name.startswith("sub") and at:
        return int(at[1])
    at = re.search(r"\[sp, #-(\d+)\]!", args)
    if at:
        return int(at[1])
    at = re.match(r"sp,sp,-(\d+)", args)
    return int(at[1]) if name.startswith(("add", "c.add")) and at else 0


def lines(*command):
    return subprocess.run(command, check=True, text=True,
                          capture_output=True).stdout.splitlines()


def addresses(prefix, elf):
    """{function: where it begins}."""
    symbols = (line.split() for line in
               lines(prefix + "nm", "--defined-only", elf))
    return {s[-1]: int(s[0], 16) & ~1 for s in symbols if s[1] in "TtWw"}


class Part:
    """The library's functions in a program.  Of the C library they may call
    these alone, and glibc's memcpy takes most where it is plain C: riscv64."""

    OUTSIDE = {"memcpy": 48, "memset": 48}

    def __init__(self, prefix, elf):
        self.address = addresses(prefix, elf)

    def depth(self, name):
        if name not in self.OUTSIDE:
            raise SystemExit(f"stack: what does {name} take?")
        return self.OUTSIDE[name]


class Program:
    """The functions of a linked program: frame and calls of each."""

    def __init__(self, prefix, elf):
        self.address = addresses(prefix, elf)
        self.frame, self.calls, self.start = {}, {}, []
        self.pointers = set()
        here = last = None
        for line in lines(prefix + "objdump", "-d", "--no-show-raw-insn", elf):
            label, code = LABEL.match(line), CODE.match(line)
            if label and not label[2].startswith((".", "$")):
                at = int(label[1], 16)
                if last and not ENDS.match(last):
                    self.calls[here].add(at)  # falls through
                here, last = at, None
                self.frame[at], self.calls[at] = 0, set()
                self.start.append(at)
            elif code and here is not None and code[2] != "nop":
                args = (code[3] or "").strip()
                self.read(here, code[2], args)
                last = "pc" if "pc}" in args else code[2]

    def read(self, here, name, args):
        if name in ("blx", "jalr") and "lr" not in args:
            self.pointers.add(here)
        self.frame[here] += pushed(name, args)
        target = TARGET.search(args)
        if target:
            self.calls[here].add(int(target[1], 16))

    def within(self, at):
        return max(s for s in self.start if s <= at)

    def depth(self, name, path=()):
        """Of a function of a compiled library."""
        here = self.within(self.address[name] if isinstance(name, str)
                           else name)
        if here in path or here in self.pointers:
            raise SystemExit(f"stack: {here:x} calls itself or any other")
        below = {self.within(c) for c in self.calls[here]} - {here}
        names = {a: n for n, a in self.address.items()}
        saves = [c for c in below if "riscv_save" in names.get(c, "")]
        rest = [self.depth(c, path + (here,)) for c in below - set(saves)
                if "riscv_restore" not in names.get(c, "")]
        return (self.frame[here] + sum(self.frame[c] for c in saves)
                + max(rest, default=0))


def graph(files):
    """{function: (bytes, calls)} of gcc's .ci files."""
    found = {}
    for file in files:
        text = file.read_text()
        for title, size, kind in NODE.findall(text):
            if size:
                if kind == "dynamic":  # without a bound
                    raise SystemExit(f"stack: {title} takes no fixed room")
                found[title] = (int(size), set())
        for source, target, within in EDGE.findall(text):
            found[source][1].add(
                within if target == "__indirect_call" else
                f"{file.stem}.c:{ROOT}" if target == ROOT else target)
    for file in {name.split(", ")[1] for name in POINTERS if ", " in name}:
        found[f"{file}:{ROOT}"] = (found[ROOT][0], {f"root.c, {file}"})
    return {title: (size, set().union(*(reached(c, found) for c in calls)))
            for title, (size, calls) in found.items()}


def reached(call, functions):
    """The functions that a call may reach: several, through a pointer."""
    if not call.endswith(".c"):
        return {call}
    if call not in POINTERS:
        return {"a pointer in " + call}
    ends = tuple("/" + name if ":" in name else name for name in POINTERS[call])
    names = {f for f in functions if f.endswith(ends)}
    if len(names) != len(ends):
        raise SystemExit(f"stack: of {ends} there are {sorted(names)}")
    return names


def deepest(functions, program, name, path=()):
    """(bytes, the way down) from a function, its own frame included."""
    if name in path:
        raise SystemExit(f"stack: {name} calls itself")
    if name not in functions:
        return program.depth(name), (name,)
    if name.rsplit(":")[-1] not in program.address:
        return 0, ()  # of another program: the linker has left it out
    size, calls = functions[name]
    if any(c.startswith("a pointer in ") for c in calls):
        raise SystemExit(f"stack: {name} calls through {', '.join(calls)}")
    below = [deepest(functions, program, c, path + (name,)) for c in calls]
    most, way = max(below, default=(0, ()))
    return size + most, (name.rsplit(":")[-1],) + way
