# SPDX-License-Identifier: MIT
"""What can be read off a coin.

Each takes a State, or a row of a table, and returns numbers; or a table, and
returns arrays, with the table's shape first.  If a row of a table fails, Error
is raised with the first in .index.  With status, an array of int32 of the
table's shape, nothing is raised: status has the status of each row, and what
failed is NaN."""
from __future__ import annotations

from typing import Any

from ._declarations import Losses, Params
from ._library import lib
from ._tables import AnyParams, Coins, Statuses, read

__all__ = ["angular_velocity", "axes", "center", "check", "contact",
           "critical_roll", "critical_spin", "energy", "fastest_rate",
           "integrals", "losses_power", "losses_rates", "losses_reaction", "matrix",
           "quaternion", "rates", "reaction",
           "stability", "steady_radii", "time_to_rest", "velocity"]


def energy(s: Coins, p: AnyParams, *, status: Statuses = None) -> Any:
    """The energy, constant along every motion.  coin_energy()"""
    return read("energy", s, p, status=status)


def fastest_rate(s: Coins, p: AnyParams, *, status: Statuses = None) -> Any:
    """How fast the coin turns and falls now, W.  coin_fastest_rate()"""
    return read("fastest_rate", s, p, status=status)


def integrals(s: Coins, p: AnyParams, *, status: Statuses = None) -> Any:
    """K_Y and K_Z, constant along every motion.  coin_integrals()"""
    return read("integrals", s, p, status=status)


def reaction(s: Coins, p: AnyParams, *, status: Statuses = None) -> Any:
    """The Force of the table on the coin.  coin_reaction()"""
    return read("reaction", s, p, status=status)


def rates(s: Coins, p: AnyParams, *, status: Statuses = None) -> Any:
    """The rates of change of every member, in the members of a State.
    coin_rates()"""
    return read("rates", s, p, status=status)


def center(s: Coins, p: AnyParams, *, status: Statuses = None) -> Any:
    """x, y, z of the centre of mass.  coin_center()"""
    return read("center", s, p, status=status)


def velocity(s: Coins, p: AnyParams, *, status: Statuses = None) -> Any:
    """The velocity of the centre of mass.  coin_velocity()"""
    return read("velocity", s, p, status=status)


def contact(s: Coins, p: AnyParams, *, status: Statuses = None) -> Any:
    """The point of contact, and its velocity along the table: a pair.
    coin_contact()"""
    return read("contact", s, p, status=status)


def axes(s: Coins, *, status: Statuses = None) -> Any:
    """The coin's frame: e_X, e_Y, e_Z, three numbers each.  coin_axes()"""
    return read("axes", s, status=status)


def quaternion(s: Coins, *, status: Statuses = None) -> Any:
    """The rotation w, x, y, z of the body.  coin_quaternion()"""
    return read("quaternion", s, status=status)


def matrix(s: Coins, p: AnyParams, *, status: Statuses = None) -> Any:
    """The pose as a renderer loads it: 16 numbers, by columns, of the 4x4
    matrix body to table.  coin_matrix()"""
    return read("matrix", s, p, status=status)


def angular_velocity(s: Coins, *, status: Statuses = None) -> Any:
    """The angular velocity in the table's frame.  coin_angular_velocity()"""
    return read("angular_velocity", s, status=status)


def check(s: Coins, p: AnyParams, method: int, dt: float, mu: float, *,
          status: Statuses = None) -> Any:
    """Whether the rolling model and a step hold: 0, or the bits SLIPS, LIFTS,
    COARSE, NEARLY_FLAT.  coin_check()"""
    return read("check", s, p, method, dt, mu, status=status)


# ------------------------------------------------------------------- of a steady
def steady_radii(s: Coins, p: Params, *, status: Statuses = None) -> Any:
    """The radii of the circles that the centre and the contact of a steady
    motion follow.  coin_steady_radii()"""
    return read("steady_radii", s, p, status=status)


def stability(s: Coins, p: Params, *, status: Statuses = None) -> Any:
    """lambda^2 of a steady motion: > 0, a small lean away from it grows as
    exp(sqrt(lambda^2) t); < 0, it oscillates.  coin_stability()"""
    return read("stability", s, p, status=status)


def critical_roll(p: Params) -> float:
    """The rate |wZ| above which straight rolling is stable.
    coin_critical_roll()"""
    rate: float = lib.coin_critical_roll(p)
    return rate


def critical_spin(p: Params) -> float:
    """The rate |wY| above which upright spinning is stable.
    coin_critical_spin()"""
    rate: float = lib.coin_critical_spin(p)
    return rate


# ------------------------------------------------------------------- with losses
def losses_power(s: Coins, p: Params, losses: Losses, *,
                 status: Statuses = None) -> Any:
    """The power that the losses take.  coin_losses_power()"""
    return read("losses_power", s, p, losses, status=status)


def losses_rates(s: Coins, p: Params, losses: Losses, *,
                 status: Statuses = None) -> Any:
    """rates() with losses.  coin_losses_rates()"""
    return read("losses_rates", s, p, losses, status=status)


def losses_reaction(s: Coins, p: Params, losses: Losses, *,
                    status: Statuses = None) -> Any:
    """reaction() with losses.  coin_losses_reaction()"""
    return read("losses_reaction", s, p, losses, status=status)


def time_to_rest(s: Coins, p: Params, losses: Losses, tol: float = 1e-6, *,
                 status: Statuses = None) -> Any:
    """The time until a coin rests; infinity if nothing stops it.
    coin_time_to_rest()"""
    return read("time_to_rest", s, p, losses, tol, status=status)
