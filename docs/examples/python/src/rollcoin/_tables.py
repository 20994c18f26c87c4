# SPDX-License-Identifier: MIT
"""Coins one by one, and in tables: what a caller may pass, and what comes
back."""
from __future__ import annotations

import ctypes
import math
import mmap
import sys
from ctypes import Array, c_double, c_float, c_int32, sizeof
from typing import (TYPE_CHECKING, Any, NamedTuple, Optional, Tuple,
                    Type, Union)

from ._declarations import (EARG, EPARAMS, PROTOTYPES, Body, Params, Paramsf,
                            State, Statef)
from ._library import Error, lib
from ._types import Out, Plain
from ._workers import share_out

__all__ = ["states", "zeros"]

if TYPE_CHECKING:
    import array

    import numpy

REAL = {State: c_double, Statef: c_float, Body: c_double}
FORMAT = {State: ("d", "<d", "=d"), Statef: ("f", "<f", "=f"),
          Body: ("d", "<d", "=d")}
RAW = (bytearray, mmap.mmap)  # bytes that have no type of their own

AnyParams = Union[Params, Paramsf]
Coin = Union[State, Statef, "numpy.void"]
"""One coin: a State, a Statef, or a row of an array of these."""
Coins = Union[Coin, "numpy.ndarray[Any, Any]", "array.array[float]",
              "Array[Any]", bytearray, memoryview, mmap.mmap]
"""A coin, or a table of them: table() says which."""
Statuses = Optional["numpy.ndarray[Any, Any]"]
"""Where the status of each row belongs: an array of int32."""


class Table(NamedTuple):
    """Coins side by side in memory that somebody else owns."""
    kind: Type[Any]
    shape: Tuple[int, ...]
    address: int
    owner: Any  # kept, so that the memory stays

    @property
    def rows(self) -> int:
        count = 1
        for length in self.shape:
            count *= length
        return count

    def part(self, start: int, count: int) -> Any:
        """So many coins as an array of ctypes."""
        return (self.kind * count).from_address(
            self.address + start * sizeof(self.kind))


def is_numpy(value: Any, kind: str = "ndarray") -> bool:
    """Without importing numpy, which is not needed for single coins."""
    numpy = sys.modules.get("numpy")
    return numpy is not None and isinstance(value, getattr(numpy, kind))


def one(value: Any, kind: Optional[Type[Any]] = None,
        write: bool = False) -> Optional[Any]:
    """The State, Statef or Body that value is, or whose memory it is; None if
    it is no single coin."""
    if isinstance(value, tuple(REAL)):
        found: Any = value
    elif is_numpy(value, "void"):
        found = _record(value, write)
    else:
        return None
    if kind is not None and not isinstance(found, kind):
        hint = {(State, Body): ": body_from_state() makes one",
                (Body, State): ": its .s is one"}
        raise TypeError(f"a {type(found).__name__} where a {kind.__name__} "
                        f"belongs{hint.get((type(found), kind), '')}")
    return found


def coin(value: Any, kind: Type[Any], write: bool = False) -> Any:
    """one(), where a table is of no use."""
    found = one(value, kind, write)
    if found is None:
        raise TypeError(f"{type(value).__name__} where a {kind.__name__} "
                        "belongs: run_batch(), advance(), settle() and move() "
                        "take tables")
    return found


def _record(value: Any, write: bool) -> Any:
    numpy = sys.modules["numpy"]
    for kind in REAL:
        if value.dtype == numpy.dtype(kind):
            if not write:
                return kind.from_buffer_copy(value)
            return _in_place(value, kind)
    raise TypeError(f"a row of dtype {value.dtype}, not State")


def _in_place(row: Any, kind: Type[Any]) -> Any:
    """The memory of a row, which is that of the array it was taken from."""
    if not (row.flags.writeable and row.flags.aligned):
        raise ValueError("a row to be moved must be writable and aligned")
    address = row.__array_interface__["data"][0]
    memory: Any = ctypes.cast(address, ctypes.POINTER(kind))
    memory._row = row  # which keeps the array
    return memory.contents  # which keeps memory


def table(value: Any, kind: Optional[Type[Any]] = None,
          write: bool = False) -> Table:
    """Coins in a buffer: of numpy of dtype State, or float64 whose last axis
    is 8 long, or flat; of array.array("d"), of ctypes, a bytearray, a mapped
    file.  Statef and float32, 16 long, likewise.  In place, without a copy,
    unless it is only read: then a list of coins or of rows of 8 numbers will
    do, and other numbers that float64 holds."""
    if isinstance(value, (list, tuple)):
        value = _listed(value, write)
    found = _ndarray(value, kind, write) if is_numpy(value) else _buffer(
        value, kind or State, write)
    if kind is not None and found.kind is not kind:
        raise TypeError(f"a table of {found.kind.__name__} where one of "
                        f"{kind.__name__} belongs")
    return found


def _listed(value: Any, write: bool) -> Any:
    import numpy
    if write:
        raise TypeError("a list is not moved in place: numpy.stack() makes a "
                        "table of it, of dtype State or Body")
    return numpy.stack(value)


def _ndarray(array: Any, wanted: Optional[Type[Any]], write: bool) -> Table:
    numpy = sys.modules["numpy"]
    if isinstance(array, numpy.ma.MaskedArray):
        raise TypeError("a masked array: its mask would be lost")
    if wanted is None:
        floats = array.dtype == numpy.float32 and array.shape[-1:] != (8,)
        wanted = Statef if floats else State
    for kind, real in REAL.items():
        if array.dtype == numpy.dtype(kind):
            shape = array.shape
        elif array.dtype == numpy.dtype(real) and wanted is kind:
            shape = _rows(array.shape, sizeof(kind) // sizeof(real))
        else:
            continue
        straight = array.flags.c_contiguous and array.flags.aligned
        if write and not (straight and array.flags.writeable):
            raise ValueError("an array to be moved must be writable and lie "
                             "in one piece")
        if not straight:
            array = numpy.require(array, requirements=["C", "A"])
        return Table(kind, shape, array.ctypes.data, array)
    if wanted in (State, Body) and numpy.can_cast(array.dtype, numpy.float64):
        if not write:
            return _ndarray(array.astype(numpy.float64), wanted, write)
        raise TypeError(f"an array of {array.dtype} is not moved in place: "
                        "move array.astype(numpy.float64)")
    raise TypeError(f"an array of dtype {array.dtype}: neither "
                    f"{wanted.__name__} nor float64")


def _rows(shape: Tuple[int, ...], columns: int) -> Tuple[int, ...]:
    """The shape of a table of coins, of that of its numbers."""
    if len(shape) == 1 and shape[0] % columns == 0:
        return (shape[0] // columns,)
    if len(shape) > 1 and shape[-1] == columns:
        return shape[:-1]
    raise ValueError(f"numbers of shape {shape} are not rows of {columns}")


def _buffer(value: Any, kind: Type[Any], write: bool) -> Table:
    if isinstance(value, Array) and value._type_ in REAL:
        return Table(value._type_, (len(value),), ctypes.addressof(value),
                     value)
    view = memoryview(value)
    if not view.c_contiguous:
        raise ValueError("a buffer that does not lie in one piece")
    if isinstance(value, RAW):
        shape = _rows((view.nbytes,), sizeof(kind))
    elif view.format in FORMAT[kind]:
        columns = sizeof(kind) // sizeof(REAL[kind])
        shape = _rows(tuple(view.shape or ()), columns)
    else:
        raise TypeError(f"a buffer of format {view.format!r}: neither State "
                        "nor float64")
    if view.readonly and write:
        raise TypeError("a buffer that cannot be written")
    bytes_of = ctypes.c_char * view.nbytes
    memory = (bytes_of.from_buffer_copy(view) if view.readonly
              else bytes_of.from_buffer(view))
    return Table(kind, shape, ctypes.addressof(memory), memory)


def states(buffer: Any) -> Any:
    """The memory of a writable table as an array of State of ctypes, without
    a copy; of floats as one of Statef."""
    found = table(buffer, write=True)
    array = found.part(0, found.rows)
    array._owner = found.owner  # which keeps the memory
    return array


def zeros(shape: Union[int, Tuple[int, ...]],
          kind: Type[Any] = State) -> "numpy.ndarray[Any, Any]":
    """An array of numpy of dtype kind, State, Statef or Body, with all
    members 0, in which array[k] = coin sets a row.  In an array that numpy
    made, only array[k, ...] = coin does."""
    import numpy

    from ._rows import Rows
    return numpy.zeros(shape, kind).view(Rows)


# ------------------------------------------------------------------------ calls
def _prefix(kind: Type[Any]) -> str:
    return "coinf_" if kind is Statef else "coin_"


def kind_of(p: Any) -> Type[Any]:
    """The kind of coin that parameters are for."""
    if isinstance(p, Params):
        return State
    if isinstance(p, Paramsf):
        return Statef
    raise TypeError(f"p: {type(p).__name__} where Params belong")


def function(name: str, kind: Type[Any]) -> Any:
    """coin_NAME, or coinf_NAME for floats; TypeError if there is none."""
    full = _prefix(kind) + name
    if full not in PROTOTYPES:
        raise TypeError(f"floats have no {name}()")
    return getattr(lib, full)


def _outs(full: str) -> list[Out]:
    """What a function writes, but what it moves."""
    kinds = list(PROTOTYPES[full][1].values())
    return [kind for kind in kinds[1:] if isinstance(kind, Out)]


def _value(out: Any) -> Any:
    if isinstance(out, Array):
        return tuple(out)
    return out if isinstance(out, Plain) else out.value


def give(name: str, kind: Type[Any], *inputs: Any) -> Any:
    """What a function writes after its inputs; without such, its result."""
    call = function(name, kind)
    outs = [out.kind() if out.length == 1 else (out.kind * out.length)()
            for out in _outs(_prefix(kind) + name)]
    result = call(*inputs, *(ctypes.byref(out) for out in outs))
    values = tuple(map(_value, outs))
    return values[0] if len(values) == 1 else values or result


def read(name: str, s: Any, *inputs: Any, status: Any = None,
         write: bool = False, kind: Optional[Type[Any]] = None,
         workers: int = 1) -> Any:
    """coin_NAME(s, inputs...) of a coin, or of each in a table; the kind is
    that of the parameters, unless it is given."""
    kind = kind or (kind_of(inputs[0]) if inputs else None)
    coin = one(s, kind, write)
    if coin is not None:
        if status is not None:
            raise TypeError("status is for tables")
        return give(name, type(coin), coin, *inputs)
    coins = table(s, kind, write)
    function(name, coins.kind)
    full = _prefix(coins.kind) + name
    size = sizeof(coins.kind)
    try:
        return _rows_of(full, "each_", coins.shape, status, lambda first: (
            coins.address + first * size, *inputs), 0 if write else math.nan,
            workers)
    except Error as error:
        row = coins.part(error.index or 0, 1)[0]
        raise error.about(full, (row, *inputs)) from None


def times(name: str, t: Any, *inputs: Any, status: Any = None) -> Any:
    """coin_NAME(inputs..., t) at each of an array of times; the last of
    inputs comes before t."""
    import numpy
    array = numpy.asarray(t, dtype=numpy.float64, order="C")
    address = array.ctypes.data
    return _rows_of("coin_" + name, "times_", array.shape, status,
                    lambda first: (*inputs, address + 8 * first))


def _rows_of(full: str, prefix: str, shape: Tuple[int, ...], status: Any,
             arguments: Any, unwritten: float = math.nan,
             workers: int = 1) -> Any:
    """Calls a function of tables.h, part by part, with the arguments from a
    row on; returns what it wrote, or else the statuses.  An error leaves what
    it does not write: that is `unwritten`."""
    call = getattr(lib, prefix + full)
    result = PROTOTYPES[full][0]
    statuses = _statuses(status, shape)
    outs = [_filled(shape, out.kind, out.length, unwritten)
            for out in _outs(full)]
    if result is not c_int32:
        outs = [_filled(shape, result, 1, unwritten)]
    count = statuses.size

    def some(first: int, length: int) -> None:
        places = [out.ctypes.data + first * (out.nbytes // count)
                  for out in outs]
        before = () if result is c_int32 else (places.pop(),)
        call(length, statuses.ctypes.data + 4 * first, *before,
             *arguments(first), *places)

    share_out(count, workers, some)
    if status is None and (statuses < 0).any():
        _raise_first(statuses.reshape(-1))
    return outs[0] if len(outs) == 1 else tuple(outs) or statuses


def _raise_first(statuses: Any) -> None:
    """Raises for the first row that failed."""
    index = int((statuses < 0).argmax())
    whole = statuses[index] in (EARG, EPARAMS)  # of no row in particular
    raise Error(int(statuses[index]), index=None if whole else index)


def _statuses(status: Any, shape: Tuple[int, ...]) -> Any:
    import numpy
    if status is None:
        return numpy.empty(shape, numpy.int32)
    if not (isinstance(status, numpy.ndarray) and status.shape == shape
            and status.dtype == numpy.int32 and status.flags.c_contiguous
            and status.flags.writeable):
        raise TypeError(f"status must be an array of int32 of shape {shape}")
    return status


def _filled(shape: Tuple[int, ...], kind: Any, length: int,
            value: float) -> Any:
    """An array of numbers, or of structs of numbers, all of one value."""
    import numpy
    array = numpy.empty((*shape, length) if length > 1 else shape,
                        numpy.dtype(kind))
    real = numpy.float32 if _single(array.dtype) else numpy.float64
    array.reshape(-1).view(real)[:] = value
    return array


def _single(dtype: Any) -> bool:
    """Whether an array holds floats, alone or in structs."""
    while dtype.fields:
        dtype = dtype[0]
    return bool(dtype.base.itemsize == 4)
