# SPDX-License-Identifier: MIT
"""Coins that may slip, one by one."""
from __future__ import annotations

from ctypes import byref, c_double
from typing import Any, Optional

from ._declarations import (Force, Friction, Losses, Params, Slide, State)
from ._library import Error, lib
from ._move import Settled
from ._tables import Coin, coin, give

__all__ = ["slide_advance", "slide_energy", "slide_of", "slide_reaction",
           "slide_velocity"]


def slide_of(s: Coin, p: Params) -> Slide:
    """A coin that may slip, and rolls now.  coin_slide_of()"""
    d = Slide()
    lib.coin_slide_of(d, coin(s, State), p)
    return d


def slide_advance(d: Slide, p: Params, friction: Friction, t: float,
                  tol: float = 1e-9,
                  losses: Optional[Losses] = None) -> Settled:
    """Moves d by any time t >= 0 to an accuracy; the status is OK, it rolls,
    SLIPS or RESTS.  coin_slide_advance()"""
    reached = c_double()
    try:
        status = lib.coin_slide_advance(d, p, friction, losses, t, tol,
                                        byref(reached))
    except Error as error:
        error.done = reached.value
        raise
    return Settled(status, reached.value)


def slide_energy(d: Slide, p: Params) -> float:
    """Kinetic and potential energy.  coin_slide_energy()"""
    energy: float = lib.coin_slide_energy(d, p)
    return energy


def slide_reaction(d: Slide, p: Params, friction: Friction,
                   losses: Optional[Losses] = None) -> Force:
    """The Force of the table, of rolling or of the slip.
    coin_slide_reaction()"""
    force = Force()
    lib.coin_slide_reaction(d, p, friction, losses, force)
    return force


def slide_velocity(d: Slide, p: Params) -> Any:
    """The slip velocity, along x and z.  coin_slide_velocity()"""
    return give("slide_velocity", State, d, p)
