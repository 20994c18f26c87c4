# SPDX-License-Identifier: MIT
"""The compiled library, its functions declared, its errors raised."""
from __future__ import annotations

import ctypes
import pathlib
from ctypes import (byref, c_char_p, c_double, c_float, c_int32, c_size_t,
                    c_void_p)
from typing import Any, Optional, Sequence

from . import _declarations as declared
from ._types import Out

__all__ = ["Error", "lib"]


class Error(ValueError):
    """A negative status of the library.

    status  the status: ESTATE, ESTEP, ...; str() says it in words
    done    how far a call that moves a coin came: the steps of run(), the
            states of sample(), the time of advance(), settle() and
            move(); None of other calls
    index   the first row of a table that failed, or None

    The state is the last good one: that after `done`, or as it was before the
    call.  The rows of a table that did not fail are moved all the same.
    """

    status: int
    done: Optional[float]
    index: Optional[int]

    def __init__(self, status: int, done: Optional[float] = None,
                 index: Optional[int] = None) -> None:
        super().__init__(status, done, index)
        self.status = status
        self.done = done
        self.index = index

    def __str__(self) -> str:
        text: str = lib.coin_status_string(self.status).decode()
        return text if self.index is None else f"row {self.index}: {text}"


def _no_error(status: int, function: Any, arguments: Sequence[Any]) -> int:
    if status < 0:
        raise Error(status)
    return status


def _no_nan(number: float, function: Any, arguments: Sequence[Any]) -> float:
    if number != number:
        raise Error(_why_nan(function.__name__, arguments))
    return number


def _why_nan(name: str, arguments: Sequence[Any]) -> int:
    """The status for a function that has none: that of a table of one row, or
    else of params_check()."""
    if any(argument is None for argument in arguments):
        return declared.EARG
    each = getattr(lib, "each_" + name, None)
    if each is None:
        lib.coin_params_check(arguments[-1])  # which raises
        return declared.ESTATE  # of body_energy()
    result, kinds = declared.PROTOTYPES[name]
    status: int = each(1, byref(c_int32()), byref(result()),
                       kinds["s"].from_param(arguments[0]), *arguments[1:])
    return status


def _declare(library: ctypes.CDLL) -> None:
    for name, (result, arguments) in declared.PROTOTYPES.items():
        function = getattr(library, name)
        function.restype = result
        function.argtypes = list(arguments.values())
        if result is c_int32:
            function.errcheck = _no_error
        elif result in (c_double, c_float):
            function.errcheck = _no_nan
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
"""Every function of coin.h and coinf.h by its own name: errors are raised."""
