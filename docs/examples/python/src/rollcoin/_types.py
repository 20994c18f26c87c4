# SPDX-License-Identifier: MIT
"""Structs and arguments as ctypes has them, but without silent acceptance:
an unknown member, a number out of range and an array of another type raise."""
from __future__ import annotations

import operator
from ctypes import (Array, Structure, byref, c_int32, c_size_t, c_uint32,
                    c_uint64, sizeof)
from typing import Any, Iterator, Type


class Plain(Structure):
    """A struct of C: its members are the attributes, and there are no others.

    Two are equal if they are of one type and all members are; copy.copy()
    copies.  numpy takes the class for a dtype."""

    __slots__ = ()

    def __init__(self, *values: Any, **members: Any) -> None:
        unknown = members.keys() - {name for name, _ in self._fields_}
        if unknown:
            raise TypeError(f"{type(self).__name__} has no {min(unknown)!r}")
        super().__init__(*values, **members)

    def _members(self) -> Iterator[tuple[str, Any]]:
        for name, _ in self._fields_:
            value = getattr(self, name)
            yield name, tuple(value) if isinstance(value, Array) else value

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return NotImplemented
        return list(self._members()) == list(type(self)._members(other))

    __hash__ = None  # type: ignore[assignment]

    def __float__(self) -> float:
        """What numpy asks for where an array is given a coin for array[k]."""
        raise TypeError(f"a {type(self).__name__} is no number: array[k, ...] "
                        "= coin sets a row, as array[k] = coin does in an "
                        "array of rollcoin.zeros()")

    def __reduce__(self) -> Any:
        """For copy and pickle: a worker elsewhere gets the same bytes."""
        return _restored, (type(self), bytes(self))

    def __repr__(self) -> str:
        """The members that are not 0, the library's own left out."""
        shown = (f"{name}={value!r}" for name, value in self._members()
                 if not name.startswith("private_")
                 and (any(value) if isinstance(value, tuple) else value))
        return f"{type(self).__name__}({', '.join(shown)})"


def _restored(kind: Type[Plain], data: bytes) -> Plain:
    return kind.from_buffer_copy(data)


class Whole:
    """A whole number of C as an argument; out of its range is ValueError."""

    def __init__(self, kind: Any) -> None:
        bits = 8 * sizeof(kind)
        signed = kind(-1).value < 0
        self.kind = kind
        self.low = -1 << bits - 1 if signed else 0
        self.high = (1 << bits - signed) - 1

    def from_param(self, value: Any) -> Any:
        number = operator.index(getattr(value, "value", value))
        if not self.low <= number <= self.high:
            raise ValueError(f"{number} is not in {self.low} to {self.high}")
        return self.kind(number)


INT32 = Whole(c_int32)
UINT32 = Whole(c_uint32)
UINT64 = Whole(c_uint64)
SIZE = Whole(c_size_t)


class In:
    """A pointer to what a function reads: so many of a type, at least, or as
    many as another argument says, which is 0 here."""

    def __init__(self, kind: Type[Any], length: int = 1) -> None:
        self.kind = kind
        self.length = length

    def from_param(self, value: Any) -> Any:
        """Of an object, of byref() of one, or of an array of ctypes; None is
        the null pointer."""
        if value is None:
            return None
        target = getattr(value, "_obj", value)  # of byref()
        if isinstance(target, self.kind) and self.length <= 1:
            return byref(target)
        if (isinstance(target, Array) and target._type_ is self.kind
                and len(target) >= self.length):
            return target
        count = self.length if self.length > 1 else "a"
        raise TypeError(f"{type(target).__name__} where {count} "
                        f"{self.kind.__name__} belongs")


class Out(In):
    """A pointer to what a function writes, or moves."""
