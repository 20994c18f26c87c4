# SPDX-License-Identifier: MIT
"""Motion without steps.

t is a time, or an array of times: then there is an array of dtype State, of
the array's shape, and status as in what reads a table."""
from __future__ import annotations

from typing import Any

from ._declarations import Orbit, Params, State
from ._library import lib
from ._tables import Coin, Statuses, coin, give, times

__all__ = ["orbit", "orbit_at", "steady_at"]


def _at(name: str, inputs: Any, t: Any, status: Statuses) -> Any:
    if hasattr(t, "__len__"):
        return times(name, t, *inputs, status=status)
    if status is not None:
        raise TypeError("status is for arrays of times")
    return give(name, State, *inputs, t)


def steady_at(s: Coin, p: Params, t: Any, *, status: Statuses = None) -> Any:
    """The state of a steady motion at any time.  coin_steady_at()"""
    return _at("steady_at", (coin(s, State), p), t, status)


def orbit(s: Coin, p: Params) -> Orbit:
    """A motion solved for all times: its period and the like, and what
    orbit_at() is asked about.  coin_orbit_init()"""
    o = Orbit()
    lib.coin_orbit_init(o, coin(s, State), p)
    return o


def orbit_at(o: Orbit, t: Any, *, status: Statuses = None) -> Any:
    """The state at any time of a motion that orbit() solved.
    coin_orbit_at()"""
    return _at("orbit_at", (o,), t, status)
