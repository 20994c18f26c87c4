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

__all__ = ["body_contact", "body_energy", "body_face", "body_from_motion",
           "body_from_state", "body_matrix", "body_reaction", "body_strike",
           "move", "table_check"]


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
         stop: int = 0, *, status: Statuses = None,
         workers: int = 1) -> Settled:
    """Moves b, a Body, a row or an array of numpy of dtype Body, by a time
    t >= 0, or until it rests, or to the first of the moments that stop names:
    SLIPS, LIFTS, NEARLY_FLAT, ROLLS, TOUCHES, and without a pull DECIDED.  The
    status is the mode, OK, it rolls, SLIPS, LIFTS or RESTS, with the bits of
    the moment.  Gives (status, reached), the time moved by in this call.

    workers: how many threads share the rows of an array, -1 for one in each
    processor; they move them where they are, with the same bits.  Long work
    with more than one tells on a terminal how far it is.  coin_move()"""
    return Settled(*moved("move", b, lambda left: (p, table, left, tol, stop),
                          t, status, Body, workers))


def body_energy(b: Bodies, p: Params, *, status: Statuses = None) -> Any:
    """Kinetic and potential energy.  coin_body_energy()"""
    return read("body_energy", b, p, status=status, kind=Body)


def body_reaction(b: Bodies, p: Params, table: Table, *,
                  status: Statuses = None) -> Any:
    """The Force of the table, of rolling or of the slip.
    coin_body_reaction()"""
    return read("body_reaction", b, p, table, status=status, kind=Body)


def body_contact(b: Bodies, p: Params, *, status: Statuses = None) -> Any:
    """The velocity of the lowest point: along x and z the slip; along y less
    than 0 where it touches, by the speed of the impact.  coin_body_contact()"""
    return read("body_contact", b, p, status=status, kind=Body)


def body_strike(b: Union[Body, "numpy.void"], p: Params, J: Sequence[float],
                r: Sequence[float]) -> None:
    """A blow: gives b, a Body or a row, the impulse J at the place r from its
    centre, three numbers each.  coin_body_strike()"""
    lib.coin_body_strike(coin(b, Body, True), p, vector("J", J, 3),
                         vector("r", r, 3))


def body_face(b: Bodies, p: Params, *, status: Statuses = None) -> Any:
    """Which side is up: HEADS, TAILS or EDGE, a Face; of an array one of
    int32.  After DECIDED it is how the coin ends.  coin_body_face()"""
    return read("body_face", b, p, status=status, kind=Body)


def body_matrix(b: Bodies, p: Params, *, status: Statuses = None) -> Any:
    """matrix() with the body's own height.  coin_body_matrix()"""
    return read("body_matrix", b, p, status=status, kind=Body)
