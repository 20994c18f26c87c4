# SPDX-License-Identifier: MIT
"""Bodies, and the states that motions begin with."""
from __future__ import annotations

from ctypes import Array, c_double, c_float
from typing import Any, Sequence, Type

from ._declarations import Losses, Params, Paramsf, State, Statef
from ._library import lib
from ._tables import (AnyParams, Coin, Coins, Statuses, coin, function, kind_of,
                     read)

__all__ = ["body", "bodyf", "cylinder", "disc", "discf", "losses_check",
           "losses_fit", "params_check", "ring", "ringf", "state_check",
           "state_from_motion", "steady_circle",
           "steady_ride", "steady_roll", "steady_spin", "steady_turn",
           "steady_upright_spin"]


# ------------------------------------------------------------------- parameters
def disc(mass: float, radius: float, gravity: float) -> Params:
    """A uniform thin disc.  coin_params_disc()"""
    p = Params()
    lib.coin_params_disc(p, mass, radius, gravity)
    return p


def ring(mass: float, radius: float, inner_radius: float,
         gravity: float) -> Params:
    """A thin ring; inner_radius from 0, a disc, to radius, a hoop.
    coin_params_ring()"""
    p = Params()
    lib.coin_params_ring(p, mass, radius, inner_radius, gravity)
    return p


def body(mass: float, radius: float, gravity: float, inertia_X: float,
         inertia_Z: float) -> Params:
    """Any thin axisymmetric body.  coin_params_body()"""
    p = Params()
    lib.coin_params_body(p, mass, radius, gravity, inertia_X, inertia_Z)
    return p


def cylinder(mass: float, radius: float, thickness: float,
             gravity: float) -> Params:
    """A uniform cylinder, for move() and what begins with body_: thickness is
    0, or 1e-4 to 4 radii.  Another body gets its rims by p.thickness.
    coin_params_cylinder()"""
    p = Params()
    lib.coin_params_cylinder(p, mass, radius, thickness, gravity)
    return p


def discf(mass: float, radius: float, gravity: float) -> Paramsf:
    """disc() in floats: what is called with it takes a Statef.
    coinf_params_disc()"""
    p = Paramsf()
    lib.coinf_params_disc(p, mass, radius, gravity)
    return p


def ringf(mass: float, radius: float, inner_radius: float,
          gravity: float) -> Paramsf:
    """ring() in floats.  coinf_params_ring()"""
    p = Paramsf()
    lib.coinf_params_ring(p, mass, radius, inner_radius, gravity)
    return p


def bodyf(mass: float, radius: float, gravity: float, inertia_X: float,
          inertia_Z: float) -> Paramsf:
    """body() in floats.  coinf_params_body()"""
    p = Paramsf()
    lib.coinf_params_body(p, mass, radius, gravity, inertia_X, inertia_Z)
    return p


def params_check(p: AnyParams) -> None:
    """Raises unless the parameters can be computed with.
    coin_params_check()"""
    function("params_check", kind_of(p))(p)


def losses_check(losses: Losses, p: Params) -> None:
    """Raises unless the losses can be computed with.  coin_losses_check()"""
    lib.coin_losses_check(losses, p)


# ----------------------------------------------------------------------- states
def state_check(s: Coins, p: AnyParams, *, status: Statuses = None) -> Any:
    """Raises unless the state can be computed with.  Of a table, with status,
    an array of int32, nothing is raised: status says which.
    coin_state_check()"""
    return read("state_check", s, p, status=status)


def vector(name: str, numbers: Sequence[float], length: int,
           real: Type[Any] = c_double) -> "Array[Any]":
    """So many numbers, no more and no fewer, as an array of ctypes."""
    if len(numbers) != length:
        raise ValueError(f"{name}: {len(numbers)} numbers where {length} belong")
    found: Array[Any] = (real * length)(*numbers)
    return found


def state_from_motion(p: AnyParams, q: Sequence[float],
                      omega: Sequence[float], x: float = 0,
                      z: float = 0) -> Any:
    """The State of a coin that an engine holds as a rotation q (w, x, y, z,
    body to table) and an angular velocity omega in the table's frame.
    coin_state_from_motion()"""
    kind = kind_of(p)
    real = c_float if kind is Statef else c_double
    s = kind()
    function("state_from_motion", kind)(
        s, p, vector("q", q, 4, real), vector("omega", omega, 3, real), x, z)
    return s


# --------------------------------------------------------------- steady motions
def steady_roll(p: Params, wZ: float) -> State:
    """Straight rolling, upright.  coin_steady_roll()"""
    s = State()
    lib.coin_steady_roll(s, p, wZ)
    return s


def steady_spin(p: Params, theta: float) -> State:
    """Spinning with the centre at rest, leaning.  coin_steady_spin()"""
    s = State()
    lib.coin_steady_spin(s, p, theta)
    return s


def steady_upright_spin(p: Params, wY: float) -> State:
    """Spinning upright about a diameter.  coin_steady_upright_spin()"""
    s = State()
    lib.coin_steady_upright_spin(s, p, wY)
    return s


def steady_circle(p: Params, theta: float, wZ: float,
                  branch: int = 1) -> State:
    """Rolling along a circle at a constant lean; branch +1 or -1 is the root
    of Eq. (40).  coin_steady_circle()"""
    s = State()
    lib.coin_steady_circle(s, p, theta, wZ, branch)
    return s


def steady_turn(p: Params, theta: float, radius: float) -> State:
    """Rolling at a lean along a circle; radius is that of the centre's circle,
    0 for a spin.  coin_steady_turn()"""
    s = State()
    lib.coin_steady_turn(s, p, theta, radius)
    return s


def steady_ride(p: Params, speed: float, radius: float) -> State:
    """Rolling along a circle at a speed, at the lean that this needs.
    coin_steady_ride()"""
    s = State()
    lib.coin_steady_ride(s, p, speed, radius)
    return s


# ----------------------------------------------------------------------- losses
def losses_fit(losses: Losses, s: Coin, p: Params, time: float) -> Losses:
    """Losses that let the coin rest after a given time: losses times one
    factor, all terms but soft and flat.  The argument stays as it is.
    coin_losses_fit()"""
    fitted = Losses.from_buffer_copy(losses)
    lib.coin_losses_fit(fitted, coin(s, State), p, time)
    return fitted

