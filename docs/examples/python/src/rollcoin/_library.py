# SPDX-License-Identifier: MIT
"""The compiled library, its functions declared, its errors raised."""
from __future__ import annotations

import ctypes
import pathlib
import re
from ctypes import (Array, byref, c_char_p, c_double, c_float, c_int32,
                    c_size_t, c_void_p)
from typing import Any, Optional, Sequence

from . import _declarations as declared
from ._types import Out

__all__ = ["Error", "lib"]


class Error(ValueError):
    """A negative status of the library.

    status  the Status: ESTATE, ESTEP, ...; str() says it in words, and what
            was out of range
    done    how far a call that moves a coin came: the steps of run(), the
            states of sample(), the time of advance(), settle() and
            move(); None of other calls
    index   the first row of a table that failed, or None

    The state is the last good one: that after `done`, or as it was before the
    call.  The rows of a table that did not fail are moved all the same.
    """

    status: declared.Status
    done: Optional[float]
    index: Optional[int]

    def __init__(self, status: int, done: Optional[float] = None,
                 index: Optional[int] = None, given: str = "") -> None:
        super().__init__(status, done, index, given)
        self.status = declared.Status(status)
        self.done = done
        self.index = index

    def about(self, name: str, arguments: Sequence[Any]) -> Error:
        """The same, with what was out of range: of a row of a table."""
        return Error(self.status, self.done, self.index, given(
            self.status, dict(zip(declared.PROTOTYPES[name][1], arguments))))

    def __str__(self) -> str:
        row = "" if self.index is None else f"row {self.index}: "
        given = self.args[3] and ": " + self.args[3]
        return f"{row}{text_of(self.status)}{given}"


def text_of(status: int) -> str:
    """What a status means."""
    text: str = lib.coin_status_string(status).decode()
    return text


BITS = [declared.Bits(bits) for bits in range(2 * declared.DECIDED)]

BLAMED = {declared.ESTATE: (declared.State, declared.Statef, declared.Body),
          declared.EPARAMS: (declared.Params, declared.Paramsf,
                             declared.Losses, declared.Table)}


CHECKS = {declared.State: "coin_state_check",
          declared.Statef: "coinf_state_check",
          declared.Losses: "coin_losses_check",
          declared.Table: "coin_table_check",
          declared.Params: "coin_params_check",
          declared.Paramsf: "coinf_params_check"}


# What moves or scales its first argument; the others only write it.
MOVERS = re.compile("coinf?_(step|run|batch_run|advance|settle|move|losses_fit"
                    "|body_strike)")

TIMES = ("dt", "t")


def _in_range(target: Any, p: Any) -> bool:
    if isinstance(target, declared.Body):
        energy: float = raw.coin_body_energy(byref(target), byref(p))
        return energy == energy
    arguments = [target] if type(target) is type(p) else [target, p]
    status: int = getattr(raw, CHECKS[type(target)])(*map(byref, arguments))
    return status >= 0


def _member(whole: Any, part: Any, p: Any) -> str:
    """The member of a part, "s.theta", without whose value the whole, which is
    changed, would be in range; nothing if there is none."""
    for name, _ in part._fields_:
        value = getattr(part, name)
        if isinstance(value, ctypes.Structure):
            inner = _member(whole, value, p)
            if inner:
                return f"{name}.{inner}"
            continue
        kept = type(value)(*value) if isinstance(value, Array) else value
        setattr(part, name, p.radius if name == "y"
                else getattr(type(part)(), name))
        if _in_range(whole, p):
            return str(name)
        setattr(part, name, kept)
    return ""


def _not_above_0(numbers: dict[str, Any]) -> dict[str, Any]:
    """What no body has, of its parameters."""
    return {name: value for name, value in numbers.items()
            if isinstance(value, (int, float)) and not (
                value > 0 or value == 0
                and name in ("inner_radius", "thickness"))}


def _wrong(target: Any, p: Any) -> str:
    """A struct that is out of range, after the member that is, if the others
    are in range; nothing if all are."""
    if _in_range(target, p):
        return ""
    if target is p:
        name = next(iter(_not_above_0(dict(target._members()))), "")
    else:
        trial = type(target).from_buffer_copy(target)
        name = _member(trial, trial, p)
    return f"{name} of {target!r}" if name else repr(target)


def _wrong_motion(name: str, values: dict[str, Any]) -> str:
    """Which argument of an engine's motion is out of range with those before
    it; the last is r, which may be too low for q."""
    kind, p = type(values.pop(next(iter(values)))), values.pop("p")
    real = values["q"]._type_
    harmless = {"q": (real * 4)(1), "omega": (real * 3)(), "v": (real * 3)(),
                "r": (real * 3)(0, 3 * p.radius), "x": real(), "z": real()}
    trial = {argument: harmless[argument] for argument in values}
    for argument in sorted(values, key="r".__eq__):
        value = values[argument]
        trial[argument] = value if isinstance(value, Array) else real(value)
        if getattr(raw, name)(byref(kind()), byref(p), *trial.values()) < 0:
            break
    return argument


def given(status: int, targets: dict[str, Any]) -> str:
    """The struct that a status is about, and its member: p, if it is wrong, as
    nothing is right with it; or a thickness where none belongs.  Or else what
    is null, or the numbers that were given: the times, or the others, if one
    of these is wrong; of the parameters of a body those that are not above
    0."""
    p = next((target for target in targets.values()
              if isinstance(target, (declared.Params, declared.Paramsf))), None)
    kinds = BLAMED.get(declared.Status(status), ())
    shown = [_wrong(target, p) if p else repr(target)
             for target in (p, *targets.values()) if isinstance(target, kinds)]
    if any(shown):
        return next(filter(None, shown))
    if status == declared.EPARAMS and p:
        return f"thickness of {p!r}"
    null = [argument for argument in targets if targets[argument] is None]
    if null:
        return f"{null[0]} = None"
    numbers = {argument: target for argument, target in targets.items()
               if isinstance(target, (int, float, tuple)) and not (
                   status in (declared.ESTEP, declared.EARG)
                   and (argument in TIMES) != (status == declared.ESTEP))}
    if status == declared.EPARAMS:
        numbers = _not_above_0(numbers) or numbers
    return ", ".join(f"{argument} = {target}"
                     for argument, target in numbers.items())


def _given(status: int, name: str, arguments: Sequence[Any]) -> str:
    """given() of the arguments of a function, but what it only writes, and
    may leave out."""
    kinds = declared.PROTOTYPES[name][1]
    values = {argument: getattr(value, "_obj", value)
              for argument, value in zip(kinds, arguments)}
    targets = {argument: tuple(value) if isinstance(value, Array) else value
               for argument, value in values.items()
               if not isinstance(kinds[argument], Out)
               or MOVERS.fullmatch(name) and value is not None}
    if status == declared.ESTATE and "q" in targets:
        wrong = _wrong_motion(name, values)
        targets = {wrong: targets[wrong]}
    return given(status, targets)


def _no_error(status: int, function: Any, arguments: Sequence[Any]) -> int:
    if status < 0:
        name = function.__name__
        raise Error(status, given=_given(status, name, arguments))
    if function.__name__ == "coin_body_face":
        return declared.Face(status)
    return BITS[status]


def _no_nan(number: float, function: Any, arguments: Sequence[Any]) -> float:
    if number != number:
        name = function.__name__
        status = _why_nan(name, arguments)
        raise Error(status, given=_given(status, name, arguments))
    return number


def _why_nan(name: str, arguments: Sequence[Any]) -> int:
    """The status for a function that has none: that of a table of one
    row."""
    if any(argument is None for argument in arguments):
        return declared.EARG
    each = getattr(lib, "each_" + name, None)
    if each is None:
        return declared.EPARAMS  # of critical_roll() and critical_spin()
    result, kinds = declared.PROTOTYPES[name]
    coin = next(iter(kinds.values())).from_param(arguments[0])
    status: int = each(1, byref(c_int32()), byref(result()), coin,
                       *arguments[1:])
    return status


def _named(function: Any, names: Sequence[str]) -> Any:
    """A function whose complaints about an argument give its name."""
    def call(*arguments: Any) -> Any:
        try:
            return function(*arguments)
        except ctypes.ArgumentError as error:
            text = str(error)
        number, kind, why = re.findall(
            r"^argument (\d+): .*?(Type|Value|Overflow)Error\W*? (.*)",
            text)[0]
        why = why.replace("wrong type", "a number belongs there")
        argument = names[int(number) - 1]
        raise (TypeError if kind == "Type" else ValueError)(
            f"{argument}: {why}")
    call.__name__ = function.__name__
    call.argtypes = function.argtypes  # type: ignore[attr-defined]
    return call


def _declare(library: ctypes.CDLL) -> None:
    for name, (result, arguments) in declared.PROTOTYPES.items():
        function = getattr(library, name)
        function.restype = result
        function.argtypes = list(arguments.values())
        if result is c_int32:
            function.errcheck = _no_error
        elif result in (c_double, c_float):
            function.errcheck = _no_nan
        setattr(library, name, _named(function, list(arguments)))
        for prefix in ("each_", "times_"):
            if hasattr(library, prefix + name):
                _declare_table(library, prefix, name)


def _declare_table(library: ctypes.CDLL, prefix: str, name: str) -> None:
    """A function of tables.h: the count, the statuses, the numbers if it
    gives numbers; then its own arguments, with tables for some."""
    result, arguments = declared.PROTOTYPES[name]
    function = getattr(library, prefix + name)
    function.restype = c_int32
    one = "t" if prefix == "times_" else next(iter(arguments))
    takes = {"count": c_size_t, "status": c_void_p}
    if result is not c_int32:
        takes["numbers"] = c_void_p
    for argument, kind in arguments.items():
        takes[argument] = (c_void_p if argument == one
                           or isinstance(kind, Out) else kind)
    function.argtypes = list(takes.values())
    setattr(library, prefix + name, _named(function, list(takes)))


def _load() -> ctypes.CDLL:
    path = pathlib.Path(__file__).with_name("_native.so")
    if not path.exists():
        raise ImportError(f"rollcoin is not built: pip install the folder "
                          f"above {path.parent.parent}")
    library = ctypes.CDLL(str(path))
    _declare(library)
    for name, kind in declared.STRUCTS.items():
        if library.coin_sizeof(name.encode()) != ctypes.sizeof(kind):
            raise ImportError("librollcoin is of another release than "
                              "rollcoin")
    return library


lib = _load()
raw = ctypes.CDLL(lib._name)  # whose functions raise nothing
raw.coin_body_energy.restype = c_double
"""Every function of coin.h and coinf.h by its own name: errors are raised."""
