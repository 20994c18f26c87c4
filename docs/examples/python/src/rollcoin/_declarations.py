# SPDX-License-Identifier: MIT
"""What coin.h and coinf.h declare: by `make bindings-update`."""
from ctypes import (Array, c_char_p, c_double, c_float, c_int32, c_size_t,
                    c_uint32, c_uint64)
from typing import Any, Dict, Tuple

from ._types import INT32, SIZE, UINT32, UINT64, In, Out, Plain

__all__ = ["Params", "State", "Force", "Orbit", "Losses", "Table", "Body",
           "Paramsf", "Statef", "Forcef", "OK", "EPARAMS", "ESTATE", "ESTEP",
           "EARG", "EDOMAIN", "EFLAT", "EBUILD", "ERANGE", "SLIPS", "LIFTS",
           "COARSE", "NEARLY_FLAT", "RESTS", "ROLLS", "TOUCHES", "RK4", "RK8",
           "SYMPLECTIC2", "SYMPLECTIC4"]


class Params(Plain):
    """coin_params."""
    __slots__ = ()
    mass: float
    radius: float
    gravity: float
    inertia_X: float
    inertia_Z: float
    reserved: "Array[c_double]"
    _fields_ = [
        ("mass", c_double),
        ("radius", c_double),
        ("gravity", c_double),
        ("inertia_X", c_double),
        ("inertia_Z", c_double),
        ("reserved", c_double * 3),
    ]


class State(Plain):
    """coin_state."""
    __slots__ = ()
    theta: float
    phi: float
    psi: float
    x: float
    z: float
    wX: float
    wY: float
    wZ: float
    _fields_ = [
        ("theta", c_double),
        ("phi", c_double),
        ("psi", c_double),
        ("x", c_double),
        ("z", c_double),
        ("wX", c_double),
        ("wY", c_double),
        ("wZ", c_double),
    ]


class Force(Plain):
    """coin_force."""
    __slots__ = ()
    R: "Array[c_double]"
    normal: float
    friction: float
    ratio: float
    _fields_ = [
        ("R", c_double * 3),
        ("normal", c_double),
        ("friction", c_double),
        ("ratio", c_double),
    ]


class Orbit(Plain):
    """coin_orbit."""
    __slots__ = ()
    period: float
    heading_per_period: float
    roll_per_period: float
    theta_min: float
    theta_max: float
    center: "Array[c_double]"
    radius_min: float
    radius_max: float
    drift: "Array[c_double]"
    conditioning: float
    reserved: "Array[c_double]"
    private_frame: "Array[c_double]"
    private_edges: "Array[c_double]"
    private_centers: "Array[c_double]"
    private_terms: "Array[c_double]"
    private_spare: "Array[c_double]"
    _fields_ = [
        ("period", c_double),
        ("heading_per_period", c_double),
        ("roll_per_period", c_double),
        ("theta_min", c_double),
        ("theta_max", c_double),
        ("center", c_double * 2),
        ("radius_min", c_double),
        ("radius_max", c_double),
        ("drift", c_double * 2),
        ("conditioning", c_double),
        ("reserved", c_double * 26),
        ("private_frame", c_double * 32),
        ("private_edges", c_double * 48),
        ("private_centers", c_double * 42),
        ("private_terms", c_double * 3780),
        ("private_spare", c_double * 156),
    ]


class Losses(Plain):
    """coin_losses."""
    __slots__ = ()
    damping: float
    dry: float
    viscous: float
    layer: float
    gap: float
    rolling: float
    spin: float
    angular: float
    soft: float
    flat: float
    reserved: "Array[c_double]"
    _fields_ = [
        ("damping", c_double),
        ("dry", c_double),
        ("viscous", c_double),
        ("layer", c_double),
        ("gap", c_double),
        ("rolling", c_double),
        ("spin", c_double),
        ("angular", c_double),
        ("soft", c_double),
        ("flat", c_double),
        ("reserved", c_double * 2),
    ]


class Table(Plain):
    """coin_table."""
    __slots__ = ()
    mu_static: float
    mu_kinetic: float
    restitution: float
    reserved: "Array[c_double]"
    losses: Losses
    _fields_ = [
        ("mu_static", c_double),
        ("mu_kinetic", c_double),
        ("restitution", c_double),
        ("reserved", c_double * 5),
        ("losses", Losses),
    ]


class Body(Plain):
    """coin_body."""
    __slots__ = ()
    s: State
    y: float
    vx: float
    vy: float
    vz: float
    reserved: "Array[c_double]"
    _fields_ = [
        ("s", State),
        ("y", c_double),
        ("vx", c_double),
        ("vy", c_double),
        ("vz", c_double),
        ("reserved", c_double * 4),
    ]


class Paramsf(Plain):
    """coinf_params."""
    __slots__ = ()
    mass: float
    radius: float
    gravity: float
    inertia_X: float
    inertia_Z: float
    reserved: "Array[c_float]"
    _fields_ = [
        ("mass", c_float),
        ("radius", c_float),
        ("gravity", c_float),
        ("inertia_X", c_float),
        ("inertia_Z", c_float),
        ("reserved", c_float * 3),
    ]


class Statef(Plain):
    """coinf_state."""
    __slots__ = ()
    theta: float
    phi: float
    psi: float
    x: float
    z: float
    wX: float
    wY: float
    wZ: float
    low: "Array[c_float]"
    _fields_ = [
        ("theta", c_float),
        ("phi", c_float),
        ("psi", c_float),
        ("x", c_float),
        ("z", c_float),
        ("wX", c_float),
        ("wY", c_float),
        ("wZ", c_float),
        ("low", c_float * 8),
    ]


class Forcef(Plain):
    """coinf_force."""
    __slots__ = ()
    R: "Array[c_float]"
    normal: float
    friction: float
    ratio: float
    _fields_ = [
        ("R", c_float * 3),
        ("normal", c_float),
        ("friction", c_float),
        ("ratio", c_float),
    ]


OK = 0
EPARAMS = -1
ESTATE = -2
ESTEP = -3
EARG = -4
EDOMAIN = -5
EFLAT = -6
EBUILD = -7
ERANGE = -9
SLIPS = 1
LIFTS = 2
COARSE = 4
NEARLY_FLAT = 8
RESTS = 16
ROLLS = 32
TOUCHES = 64
RK4 = 0
RK8 = 1
SYMPLECTIC2 = 2
SYMPLECTIC4 = 3

STRUCTS = {
    "coin_params": Params,
    "coin_state": State,
    "coin_force": Force,
    "coin_orbit": Orbit,
    "coin_losses": Losses,
    "coin_table": Table,
    "coin_body": Body,
    "coinf_params": Paramsf,
    "coinf_state": Statef,
    "coinf_force": Forcef,
}

# Name: (result, {argument: type})
PROTOTYPES: Dict[str, Tuple[Any, Dict[str, Any]]] = {
    "coin_step": (c_int32, {"s": Out(State), "p": In(Params), "dt": c_double}),
    "coin_run": (c_int32, {"s": Out(State), "p": In(Params), "method": INT32,
        "dt": c_double, "steps": UINT64, "done": Out(c_uint64)}),
    "coin_sample": (c_int32, {"start": In(State), "p": In(Params),
        "method": INT32, "dt": c_double, "steps_per_sample": UINT64,
        "count": SIZE, "out": Out(State, 0), "done": Out(c_size_t, 0)}),
    "coin_batch_run": (c_int32, {"s": Out(State, 0), "count": SIZE,
        "p": In(Params), "method": INT32, "dt": c_double, "steps": UINT64,
        "status": Out(c_int32, 0)}),
    "coin_advance": (c_int32, {"s": Out(State), "p": In(Params), "t": c_double,
        "tol": c_double, "reached": Out(c_double)}),
    "coin_method_name": (c_char_p, {"method": INT32}),
    "coin_params_disc": (c_int32, {"p": Out(Params), "mass": c_double,
        "radius": c_double, "gravity": c_double}),
    "coin_params_ring": (c_int32, {"p": Out(Params), "mass": c_double,
        "radius": c_double, "inner_radius": c_double,
        "gravity": c_double}),
    "coin_params_body": (c_int32, {"p": Out(Params), "mass": c_double,
        "radius": c_double, "gravity": c_double, "inertia_X": c_double,
        "inertia_Z": c_double}),
    "coin_params_check": (c_int32, {"p": In(Params)}),
    "coin_state_check": (c_int32, {"s": In(State), "p": In(Params)}),
    "coin_state_from_motion": (c_int32, {"s": Out(State), "p": In(Params),
        "q": In(c_double, 4), "omega": In(c_double, 3), "x": c_double,
        "z": c_double}),
    "coin_angular_velocity": (c_int32, {"s": In(State), "omega": Out(c_double,
        3)}),
    "coin_energy": (c_double, {"s": In(State), "p": In(Params)}),
    "coin_integrals": (c_int32, {"s": In(State), "p": In(Params),
        "K": Out(c_double, 2)}),
    "coin_reaction": (c_int32, {"s": In(State), "p": In(Params),
        "out": Out(Force)}),
    "coin_rates": (c_int32, {"s": In(State), "p": In(Params),
        "out": Out(State)}),
    "coin_center": (c_int32, {"s": In(State), "p": In(Params),
        "r": Out(c_double, 3)}),
    "coin_velocity": (c_int32, {"s": In(State), "p": In(Params),
        "v": Out(c_double, 3)}),
    "coin_contact": (c_int32, {"s": In(State), "p": In(Params),
        "r": Out(c_double, 3), "v": Out(c_double, 3)}),
    "coin_axes": (c_int32, {"s": In(State), "R": Out(c_double, 9)}),
    "coin_quaternion": (c_int32, {"s": In(State), "q": Out(c_double, 4)}),
    "coin_matrix": (c_int32, {"s": In(State), "p": In(Params),
        "m": Out(c_double, 16)}),
    "coin_fastest_rate": (c_double, {"s": In(State), "p": In(Params)}),
    "coin_check": (c_int32, {"s": In(State), "p": In(Params), "method": INT32,
        "dt": c_double, "mu": c_double}),
    "coin_steady_roll": (c_int32, {"s": Out(State), "p": In(Params),
        "wZ": c_double}),
    "coin_steady_spin": (c_int32, {"s": Out(State), "p": In(Params),
        "theta": c_double}),
    "coin_steady_upright_spin": (c_int32, {"s": Out(State), "p": In(Params),
        "wY": c_double}),
    "coin_steady_circle": (c_int32, {"s": Out(State), "p": In(Params),
        "theta": c_double, "wZ": c_double, "branch": INT32}),
    "coin_steady_turn": (c_int32, {"s": Out(State), "p": In(Params),
        "theta": c_double, "radius": c_double}),
    "coin_steady_ride": (c_int32, {"s": Out(State), "p": In(Params),
        "speed": c_double, "radius": c_double}),
    "coin_steady_radii": (c_int32, {"s": In(State), "p": In(Params),
        "center": Out(c_double), "contact": Out(c_double)}),
    "coin_stability": (c_int32, {"s": In(State), "p": In(Params),
        "lambda2": Out(c_double)}),
    "coin_critical_roll": (c_double, {"p": In(Params)}),
    "coin_critical_spin": (c_double, {"p": In(Params)}),
    "coin_steady_at": (c_int32, {"s": In(State), "p": In(Params),
        "t": c_double, "out": Out(State)}),
    "coin_orbit_init": (c_int32, {"o": Out(Orbit), "s": In(State),
        "p": In(Params)}),
    "coin_orbit_at": (c_int32, {"o": In(Orbit), "t": c_double,
        "out": Out(State)}),
    "coin_losses_check": (c_int32, {"l": In(Losses), "p": In(Params)}),
    "coin_losses_power": (c_double, {"s": In(State), "p": In(Params),
        "l": In(Losses)}),
    "coin_losses_rates": (c_int32, {"s": In(State), "p": In(Params),
        "l": In(Losses), "out": Out(State)}),
    "coin_losses_reaction": (c_int32, {"s": In(State), "p": In(Params),
        "l": In(Losses), "out": Out(Force)}),
    "coin_settle": (c_int32, {"s": Out(State), "p": In(Params),
        "l": In(Losses), "t": c_double, "tol": c_double,
        "reached": Out(c_double)}),
    "coin_time_to_rest": (c_double, {"s": In(State), "p": In(Params),
        "l": In(Losses)}),
    "coin_losses_fit": (c_int32, {"l": Out(Losses), "s": In(State),
        "p": In(Params), "time": c_double}),
    "coin_table_check": (c_int32, {"table": In(Table), "p": In(Params)}),
    "coin_body_from_state": (c_int32, {"b": Out(Body), "s": In(State),
        "p": In(Params)}),
    "coin_body_from_motion": (c_int32, {"b": Out(Body), "p": In(Params),
        "q": In(c_double, 4), "omega": In(c_double, 3), "r": In(c_double,
        3), "v": In(c_double, 3)}),
    "coin_move": (c_int32, {"b": Out(Body), "p": In(Params),
        "table": In(Table), "t": c_double, "tol": c_double, "stop": INT32,
        "reached": Out(c_double)}),
    "coin_body_energy": (c_double, {"b": In(Body), "p": In(Params)}),
    "coin_body_reaction": (c_int32, {"b": In(Body), "p": In(Params),
        "table": In(Table), "out": Out(Force)}),
    "coin_body_slip": (c_int32, {"b": In(Body), "p": In(Params),
        "u": Out(c_double, 2)}),
    "coin_body_matrix": (c_int32, {"b": In(Body), "p": In(Params),
        "m": Out(c_double, 16)}),
    "coin_version": (c_uint32, {}),
    "coin_version_string": (c_char_p, {}),
    "coin_status_string": (c_char_p, {"status": INT32}),
    "coin_sizeof": (c_uint32, {"type": c_char_p}),
    "coin_selftest": (c_int32, {}),
    "coinf_params_disc": (c_int32, {"p": Out(Paramsf), "mass": c_float,
        "radius": c_float, "gravity": c_float}),
    "coinf_params_ring": (c_int32, {"p": Out(Paramsf), "mass": c_float,
        "radius": c_float, "inner_radius": c_float, "gravity": c_float}),
    "coinf_params_body": (c_int32, {"p": Out(Paramsf), "mass": c_float,
        "radius": c_float, "gravity": c_float, "inertia_X": c_float,
        "inertia_Z": c_float}),
    "coinf_params_check": (c_int32, {"p": In(Paramsf)}),
    "coinf_state_check": (c_int32, {"s": In(Statef), "p": In(Paramsf)}),
    "coinf_state_from_motion": (c_int32, {"s": Out(Statef), "p": In(Paramsf),
        "q": In(c_float, 4), "omega": In(c_float, 3), "x": c_float,
        "z": c_float}),
    "coinf_angular_velocity": (c_int32, {"s": In(Statef), "omega": Out(c_float,
        3)}),
    "coinf_step": (c_int32, {"s": Out(Statef), "p": In(Paramsf),
        "dt": c_float}),
    "coinf_run": (c_int32, {"s": Out(Statef), "p": In(Paramsf),
        "method": INT32, "dt": c_float, "steps": UINT64,
        "done": Out(c_uint64)}),
    "coinf_energy": (c_float, {"s": In(Statef), "p": In(Paramsf)}),
    "coinf_integrals": (c_int32, {"s": In(Statef), "p": In(Paramsf),
        "K": Out(c_float, 2)}),
    "coinf_reaction": (c_int32, {"s": In(Statef), "p": In(Paramsf),
        "out": Out(Forcef)}),
    "coinf_rates": (c_int32, {"s": In(Statef), "p": In(Paramsf),
        "out": Out(Statef)}),
    "coinf_center": (c_int32, {"s": In(Statef), "p": In(Paramsf),
        "r": Out(c_float, 3)}),
    "coinf_velocity": (c_int32, {"s": In(Statef), "p": In(Paramsf),
        "v": Out(c_float, 3)}),
    "coinf_contact": (c_int32, {"s": In(Statef), "p": In(Paramsf),
        "r": Out(c_float, 3), "v": Out(c_float, 3)}),
    "coinf_axes": (c_int32, {"s": In(Statef), "R": Out(c_float, 9)}),
    "coinf_quaternion": (c_int32, {"s": In(Statef), "q": Out(c_float, 4)}),
    "coinf_matrix": (c_int32, {"s": In(Statef), "p": In(Paramsf),
        "m": Out(c_float, 16)}),
    "coinf_fastest_rate": (c_float, {"s": In(Statef), "p": In(Paramsf)}),
    "coinf_check": (c_int32, {"s": In(Statef), "p": In(Paramsf),
        "method": INT32, "dt": c_float, "mu": c_float}),
    "coinf_selftest": (c_int32, {}),
}
