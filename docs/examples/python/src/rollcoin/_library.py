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

    def about(self, coin: Any, inputs: Sequence[Any]) -> Error:
        """The same, with what was out of range: of a row of a table."""
        structs = [each for each in (coin, *inputs)
                   if isinstance(each, ctypes.Structure)]
        return Error(self.status, self.done, self.index,
                     given(self.status, dict(enumerate(structs))))

    def __str__(self) -> str:
        row = "" if self.index is None else f"row {self.index}: "
        given = self.args[3] and ": " + self.args[3]
        return f"{row}{text_of(self.status)}{given}"


def text_of(status: int) -> str:
    """What a status means, with the names of Python."""
    text: str = lib.coin_status_string(status).decode()
    return re.sub(r"\bcoin_(?=\w+\()", "", text)


BITS = [declared.Bits(bits) for bits in range(128)]

BLAMED = {declared.ESTATE: (declared.State, declared.Statef, declared.Body),
          declared.EPARAMS: (declared.Params, declared.Paramsf,
                             declared.Losses, declared.Table)}


CHECKS = {declared.State: "coin_state_check",
          declared.Statef: "coinf_state_check",
          declared.Losses: "coin_losses_check",
          declared.Table: "coin_table_check",
          declared.Params: "coin_params_check",
          declared.Paramsf: "coinf_params_check"}


def _in_range(target: Any, p: Any) -> bool:
    if isinstance(target, declared.Body):
        energy: float = raw.coin_body_energy(byref(target), byref(p))
        return energy == energy
    arguments = [target] if type(target) is type(p) else [target, p]
    status: int = getattr(raw, CHECKS[type(target)])(*map(byref, arguments))
    return status >= 0


def _wrong(target: Any, p: Any) -> str:
    """A struct that is out of range, after the member that is, if the others
    are in range; nothing if all are."""
    if _in_range(target, p):
        return ""
    for name, value in target._members():
        trial = type(target).from_buffer_copy(target)
        setattr(trial, name, getattr(type(target)(), name))
        if (not value > 0 if target is p and name != "reserved"
                else _in_range(trial, p)):
            return f"{name} of {target!r}"
    return repr(target)


def given(status: int, targets: dict[Any, Any]) -> str:
    """The struct that a status is about, and its member; or else the numbers
    that were given."""
    p = next((target for target in targets.values()
              if isinstance(target, (declared.Params, declared.Paramsf))), None)
    kinds = BLAMED.get(declared.Status(status), ())
    shown = [_wrong(target, p) if p else repr(target)
             for target in targets.values() if isinstance(target, kinds)]
    return next(filter(None, shown), "") or ", ".join(
        f"{argument} = {target}" for argument, target in targets.items()
        if isinstance(target, (int, float, tuple)))


def _given(status: int, name: str, arguments: Sequence[Any]) -> str:
    """given() of the arguments of a function, but what it only writes."""
    targets = {}
    for (argument, kind), value in zip(declared.PROTOTYPES[name][1].items(),
                                       arguments):
        target = getattr(value, "_obj", value)
        if not isinstance(kind, Out):
            targets[argument] = (tuple(target) if isinstance(target, Array)
                                 else target)
        elif status != declared.EPARAMS:
            targets[argument] = target
    return given(status, targets)


def _no_error(status: int, function: Any, arguments: Sequence[Any]) -> int:
    if status < 0:
        name = function.__name__
        raise Error(status, given=_given(status, name, arguments))
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
        setattr(library, name, _named(function, [
            {"l": "losses"}.get(argument, argument)
            for argument in arguments]))
        for prefix in ("each_", "times_"):
            if hasattr(library, prefix + name):
                _declare_table(library, prefix, name)


def _declare_table(library: ctypes.CDLL, prefix: str, name: str) -> None:
    """A function of tables.h: the count, the statuses, the numbers if it
    gives numbers; then its own arguments, with tables for some."""
    result, arguments = declared.PROTOTYPES[name]
    function = getattr(library, prefix + name)
    function.restype = c_int32
    function.argtypes = [c_size_t, c_void_p]
    if result is not c_int32:
        function.argtypes += [c_void_p]
    one = "t" if prefix == "times_" else next(iter(arguments))
    function.argtypes += [
        c_void_p if argument == one or isinstance(kind, Out) else kind
        for argument, kind in arguments.items()]


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
