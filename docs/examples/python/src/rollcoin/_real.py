# SPDX-License-Identifier: MIT
"""Real coins: they fly, bounce, slip, roll and come to rest."""
from __future__ import annotations

from ctypes import byref, c_double
from typing import TYPE_CHECKING, Any, Sequence, Union

from ._declarations import Body, Force, Params, State, Table
from ._library import Error, lib
from ._make import vector
from ._move import Settled
from ._tables import Coin, Statuses, coin, give, move_bodies, one

if TYPE_CHECKING:
    import numpy

OneBody = Union[Body, "numpy.void"]
Bodies = Union[OneBody, "numpy.ndarray[Any, Any]"]

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
    lib.coin_body_from_motion(b, p, vector("q", q, 4), vector("omega", omega, 3),
                              vector("r", r, 3), vector("v", v, 3))
    return b


def move(b: Bodies, p: Params, table: Table, t: float, tol: float = 1e-9,
         stop: int = 0, *, status: Statuses = None) -> Settled:
    """Moves b, a Body, a row or an array of numpy of dtype Body, by a time t >= 0, or
    until one of the bits of stop begins to hold; the status is its mode: OK, it
    rolls, SLIPS, LIFTS or RESTS, and the bits of stop that hold.
    coin_move()"""
    body = one(b, Body, write=True)
    if body is None:
        return Settled(*move_bodies(b, (p, table, t, tol, stop), status))
    if status is not None:
        raise TypeError("status is for tables")
    reached = c_double()
    try:
        said = lib.coin_move(body, p, table, t, tol, stop, byref(reached))
    except Error as error:
        error.done = reached.value
        raise
    return Settled(said, reached.value)


def body_energy(b: OneBody, p: Params) -> float:
    """Kinetic and potential energy.  coin_body_energy()"""
    energy: float = lib.coin_body_energy(coin(b, Body), p)
    return energy


def body_reaction(b: OneBody, p: Params, table: Table) -> Force:
    """The Force of the table, of rolling or of the slip.
    coin_body_reaction()"""
    force = Force()
    lib.coin_body_reaction(coin(b, Body), p, table, force)
    return force


def body_slip(b: OneBody, p: Params) -> Any:
    """The slip velocity, along x and z.  coin_body_slip()"""
    return give("body_slip", State, coin(b, Body), p)


def body_matrix(b: OneBody, p: Params) -> Any:
    """matrix() with the body's own height.  coin_body_matrix()"""
    return give("body_matrix", State, coin(b, Body), p)
