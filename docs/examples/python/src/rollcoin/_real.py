# SPDX-License-Identifier: MIT
"""Real coins: they fly, bounce, slip, roll and come to rest."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence, Union

from ._declarations import Body, Params, State, Table
from ._library import lib
from ._make import vector
from ._move import Settled, moved
from ._tables import Coin, Statuses, coin, read

if TYPE_CHECKING:
    import numpy

Bodies = Union[Body, "numpy.void", "numpy.ndarray[Any, Any]"]
"""A body, a row of an array of dtype Body, or such an array."""

__all__ = ["body_energy", "body_from_motion", "body_from_state", "body_matrix",
           "body_reaction", "body_slip", "move", "table_check"]


def table_check(table: Table, p: Params) -> None:
    """Raises unless the table can be computed with.  coin_table_check()"""
    lib.coin_table_check(table, p)


def body_from_state(s: Coin, p: Params) -> Body:
    """A body that rolls.  coin_body_from_state()"""
    b = Body()
    lib.coin_body_from_state(b, coin(s, State), p)
    return b


def body_from_motion(p: Params, q: Sequence[float], omega: Sequence[float],
                     r: Sequence[float], v: Sequence[float]) -> Body:
    """A body of an engine, in the air or on the table: q is w, x, y, z.
    coin_body_from_motion()"""
    b = Body()
    lib.coin_body_from_motion(
        b, p, vector("q", q, 4), vector("omega", omega, 3), vector("r", r, 3),
        vector("v", v, 3))
    return b


def move(b: Bodies, p: Params, table: Table, t: float, tol: float = 1e-9,
         stop: int = 0, *, status: Statuses = None) -> Settled:
    """Moves b, a Body, a row or an array of numpy of dtype Body, by a time t >= 0, or
    until one of the bits of stop begins to hold; the status is its mode: OK, it
    rolls, SLIPS, LIFTS or RESTS, and the bits of stop that hold.
    coin_move()"""
    return Settled(*moved("move", b, (p, table, t, tol, stop), status, Body))


def body_energy(b: Bodies, p: Params, *, status: Statuses = None) -> Any:
    """Kinetic and potential energy.  coin_body_energy()"""
    return read("body_energy", b, p, status=status, kind=Body)


def body_reaction(b: Bodies, p: Params, table: Table, *,
                  status: Statuses = None) -> Any:
    """The Force of the table, of rolling or of the slip.
    coin_body_reaction()"""
    return read("body_reaction", b, p, table, status=status, kind=Body)


def body_slip(b: Bodies, p: Params, *, status: Statuses = None) -> Any:
    """The slip velocity, along x and z.  coin_body_slip()"""
    return read("body_slip", b, p, status=status, kind=Body)


def body_matrix(b: Bodies, p: Params, *, status: Statuses = None) -> Any:
    """matrix() with the body's own height.  coin_body_matrix()"""
    return read("body_matrix", b, p, status=status, kind=Body)
