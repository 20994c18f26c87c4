# SPDX-License-Identifier: MIT
"""What moves a coin, or many.

Python looks for Ctrl-C between two calls of the library only.  Calls that may
take long are therefore made in parts, and SLICE says how many steps a part
has: it never depends on the speed of the machine, nor do the bits."""
from __future__ import annotations

import math
import operator
from ctypes import byref, c_double, c_int32, c_size_t, c_uint64
from numbers import Integral
from typing import Any, Callable, NamedTuple, Tuple, Type

from ._declarations import (EARG, EPARAMS, MORE, Bits, Losses, Params,
                            State)
from ._library import BITS, Error, lib
from ._tables import (AnyParams, Coin, Coins, Statuses, Table, coin, function,
                     is_numpy, kind_of, one, read, table)
from ._workers import share_out, threads_of

__all__ = ["SLICE", "Settled", "advance", "run", "run_batch", "sample",
           "settle", "step"]

SLICE = 1 << 18
"""How many steps run(), run_batch() and sample() do in one call of the library.

A run of no more has the bits of one coin_run().
"""

CALLS = 100
"""How many calls of the library settle() and move() do for an infinite time."""


def _whole(number: Any) -> int:
    value = operator.index(number)
    if not 0 <= value < 1 << 64:
        raise ValueError(f"{value} steps")
    return value


def step(s: Coin, p: AnyParams, dt: float) -> Bits:
    """Moves s by one step of classical Runge-Kutta; returns COARSE or 0.
    coin_step()"""
    status: Bits = function("step", kind_of(p))(coin(s, kind_of(p), True), p,
                                               dt)
    return status


def run(s: Coin, p: AnyParams, method: int, dt: float, steps: int) -> Bits:
    """Moves s, a State or a row of a table, by steps of dt; returns COARSE or
    0.

    More than SLICE steps are several calls of the library, each of SLICE,
    between which Ctrl-C stops the run: s is then where the last of them ended.
    Each cut changes the result by at most 8 u/cos(theta), u = 1.1e-16, and is
    the same on every machine.  lib.coin_run() is one call, however long, and
    cannot be stopped.  coin_run()"""
    kind = kind_of(p)
    call = function("run", kind)
    target = coin(s, kind, True)
    bits = 0  # the | of a Flag is slow
    done = 0
    left = _whole(steps)
    while True:
        part = c_uint64()
        try:
            bits |= int(call(target, p, method, dt, min(left, SLICE),
                             byref(part)))
        except Error as error:
            error.done = done + part.value
            raise
        done += part.value
        left -= part.value
        if not left:
            return BITS[bits]


def sample(start: Coin, p: Params, method: int, dt: float,
           steps_per_sample: int, out: Any) -> Any:
    """Fills out, a number of states or a table, with states steps_per_sample
    steps apart, the start first; returns it, of a number as an array of numpy
    of dtype State, or of ctypes where numpy is not installed.  Not more than
    SLICE steps lie on one uninterrupted run.  coin_sample()"""
    path = _states(_whole(out)) if isinstance(out, Integral) else out
    coins = table(path, State, write=True)
    apart = _whole(steps_per_sample)
    first = coin(start, State)
    if apart > SLICE:
        _sample_far(first, p, method, dt, apart, coins)
    else:
        _sample_near(first, p, method, dt, apart, coins)
    return path


def _states(count: int) -> Any:
    try:
        import numpy
    except ImportError:
        return (State * count)()
    return numpy.zeros(count, State)


def _sample_near(start: State, p: Params, method: int, dt: float, apart: int,
                 coins: Table) -> None:
    """Each call begins with the last state of the one before."""
    some = max(1, SLICE // max(apart, 1)) + 1
    at = 0
    while True:
        part = coins.part(at, min(some, coins.rows - at))
        done = c_size_t()
        try:
            lib.coin_sample(start if at == 0 else part[0], p, method, dt,
                            apart, len(part), part, byref(done))
        except Error as error:
            error.done = at + done.value
            raise
        at += len(part)
        if at >= coins.rows:
            return
        at -= 1  # which the next call begins with


def _sample_far(start: State, p: Params, method: int, dt: float, apart: int,
                coins: Table) -> None:
    s = State.from_buffer_copy(start)
    path = coins.part(0, coins.rows)
    for k in range(coins.rows):
        try:
            run(s, p, method, dt, apart if k else 0)
        except Error as error:
            error.done = k
            raise
        path[k] = s


def run_batch(coins: Coins, p: AnyParams, method: int, dt: float,
              steps: int) -> Any:
    """Moves all of coins, a table, where they are, by steps of dt, each with
    the bits of run(); returns what run() would say of each: an array of int32
    of the table's shape, or of ctypes if coins is not of numpy.  Raises only
    if it touched none: a coin that failed is where its last good step left
    it.  After Ctrl-C some are moved, and some are not.  coin_batch_run()"""
    where = table(coins, kind_of(p), write=True)
    count = where.rows
    statuses = (c_int32 * count)()
    left = _whole(steps)
    _batch(where, p, method, dt, left, statuses)
    if not is_numpy(coins):
        return statuses
    import numpy
    return numpy.ctypeslib.as_array(statuses).reshape(where.shape)


def _batch(coins: Table, p: AnyParams, method: int, dt: float, steps: int,
           statuses: Any) -> None:
    """Parts of the table of SLICE steps in all, but of eight coins at least,
    which a vector may hold."""
    wide = max(8, SLICE // max(1, min(steps, SLICE)))
    for first in range(0, max(1, coins.rows), wide):
        some = coins.part(first, min(wide, coins.rows - first))
        into = (c_int32 * len(some)).from_buffer(statuses, 4 * first)
        _batch_part(some, p, method, dt, steps, into)


def _batch_part(some: Any, p: AnyParams, method: int, dt: float, steps: int,
                into: Any) -> None:
    call = function("batch_run", kind_of(p))
    if steps <= SLICE:
        _no_argument(call, some, len(some), p, method, dt, steps, into)
        return
    for k, moved in enumerate(some):
        try:
            into[k] = run(moved, p, method, dt, steps)
        except Error as error:
            if error.status in (EARG, EPARAMS):
                raise
            into[k] = error.status


def _no_argument(call: Any, *arguments: Any) -> None:
    try:
        call(*arguments)
    except Error as error:
        if error.status in (EARG, EPARAMS):
            raise


# ------------------------------------------------------------ any time, to rest
def advance(s: Coins, p: Params, t: float, tol: float = 1e-9, *,
            status: Statuses = None, workers: int = 1) -> Any:
    """Moves s, a State, a row or a table, by any time t to an accuracy;
    returns the time moved, of a table an array.  With status= that of a coin
    that falls flat is the time of its fall.  workers as in move().
    coin_advance()"""
    return moved("advance", s, lambda left: (p, left, tol), t, status,
                 kind_of(p), workers)[1]


class Settled(NamedTuple):
    """What settle() and move() return: (status, reached), the Bits and the time
    moved by in this call."""
    status: Statuses
    """The Bits, RESTS at rest; MORE if an infinite time needs more than 100
    calls of the library, which have moved the coin by `reached`.  Of a table an
    array."""
    reached: Any
    """The time moved by in this call; of a table an array."""


def settle(s: Coins, p: Params, losses: Losses, t: float, tol: float = 1e-9, *,
           status: Statuses = None, workers: int = 1) -> Settled:
    """Moves s, a State, a row or a table, with losses, by any time t >= 0 or
    until it rests.  workers as in move().  coin_settle()"""
    return Settled(*moved("settle", s, lambda left: (p, losses, left, tol), t,
                          status, kind_of(p), workers))


Inputs = Callable[[float], Tuple[Any, ...]]
"""What a call is given for the time that is left."""


def moved(name: str, s: Any, inputs: Inputs, t: float, status: Statuses,
          kind: Type[Any], workers: int) -> Tuple[Any, Any]:
    """What coin_NAME(s, inputs(t)..., &reached) returns, and the time: by as
    many calls as that takes."""
    threads_of(workers)
    target = one(s, kind, write=True)
    if target is None:
        return _moved_table(name, s, inputs, t, status, kind, workers)
    if status is not None:
        raise TypeError("status is for tables")
    return _go_on(function(name, kind), target, inputs, t, 0, CALLS)


def _go_on(call: Any, target: Any, inputs: Inputs, t: float, done: float,
           calls: int) -> Tuple[Bits, float]:
    """At most so many calls if t is infinite."""
    left = t
    while True:
        part = c_double()
        try:
            said = call(target, *inputs(left), byref(part))
        except Error as error:
            error.done = done + part.value
            raise
        done += part.value
        calls -= 1
        if not said & MORE or (t == math.inf and calls < 1):
            return said, done
        left = t - done


def _moved_table(name: str, s: Any, inputs: Inputs, t: float,
                 status: Statuses, kind: Type[Any],
                 workers: int) -> Tuple[Any, Any]:
    import numpy
    where = table(s, kind, write=True)
    said = (numpy.empty(where.shape, numpy.int32) if status is None
            else status)
    reached = read(name, s, *inputs(t), status=said, write=True, kind=kind,
                   workers=workers)
    more = numpy.flatnonzero((said > 0) & (said & MORE > 0))

    def go_on(first: int, length: int) -> None:
        for index in more[first:first + length].tolist():
            try:
                said.flat[index], reached.flat[index] = _go_on(
                    function(name, kind), where.part(index, 1)[0], inputs,
                    t, reached.flat[index], CALLS - 1)
            except Error as error:
                said.flat[index], reached.flat[index] = (error.status,
                                                         error.done)

    share_out(len(more), workers, go_on)
    bad = said.reshape(-1) < 0
    if status is None and bad.any():
        index = int(numpy.argmax(bad))
        worst = int(said.flat[index])
        whole = worst in (EARG, EPARAMS)  # of no row in particular
        raise Error(worst, reached.flat[index], None if whole else index).about(
            "coin_" + name, (where.part(index, 1)[0], *inputs(t)))
    return said, reached
