# SPDX-License-Identifier: MIT
"""What coin.h and coinf.h declare: by `make bindings-update`."""
from ctypes import (Array, c_char_p, c_double, c_float, c_int32, c_size_t,
                    c_uint32, c_uint64)
from enum import IntEnum, IntFlag
from typing import Any, Dict, Tuple

from ._types import INT32, SIZE, UINT32, UINT64, In, Out, Plain

__all__ = ["Params", "State", "Force", "Orbit", "Losses", "Table", "Body",
           "Paramsf", "Statef", "Forcef", "Status", "Bits", "Face", "Method",
           "OK", "EPARAMS", "ESTATE", "ESTEP", "EARG", "EDOMAIN", "EFLAT",
           "EBUILD", "ERANGE", "SLIPS", "LIFTS", "COARSE", "NEARLY_FLAT",
           "RESTS", "ROLLS", "TOUCHES", "MORE", "DECIDED", "HEADS", "TAILS",
           "EDGE", "RK4", "RK8", "SYMPLECTIC2", "SYMPLECTIC4"]


class Params(Plain):
    """An axisymmetric body. disc(), ring() and body() make a thin one,
    cylinder() one with a thickness.

    mass       M [kg]
    radius     a, of the rim that rolls [m]
    gravity    g [m/s^2]
    inertia_X  I_X = I_Y, about a diameter [kg m^2]
    inertia_Z  I_Z, about the axis [kg m^2]
    thickness  between the two rims: 1e-4 to 4 radii; or 0, a thin coin, which
               most functions ask for [m]
    reserved   must be 0

    coin_params, in SI units; any others that are consistent do as well.
    """
    __slots__ = ()
    mass: float
    radius: float
    gravity: float
    inertia_X: float
    inertia_Z: float
    thickness: float
    reserved: "Array[c_double]"
    _fields_ = [
        ("mass", c_double),
        ("radius", c_double),
        ("gravity", c_double),
        ("inertia_X", c_double),
        ("inertia_Z", c_double),
        ("thickness", c_double),
        ("reserved", c_double * 2),
    ]


class State(Plain):
    """Where a coin is and how it turns: its angular velocity along the coin's
    frame. Rolling determines the velocity of the centre, Eq. (20), and its
    height is y = radius cos(theta).

    theta  lean, -pi/2 < theta < pi/2 [rad]
    phi    heading, |phi| <= 2^31 [rad]
    psi    roll, |psi| <= 2^31 [rad]
    x      of the centre [m]
    z      of the centre [m]
    wX     omega_X = d(theta)/dt [rad/s]
    wY     omega_Y [rad/s]
    wZ     omega_Z [rad/s]

    coin_state, in SI units; any others that are consistent do as well.
    """
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
    """The force of the table on the coin.

    R         in the table frame x, y, z [kg m/s^2]
    normal    N = R_y [kg m/s^2]
    friction  F = sqrt(R_x^2 + R_z^2) [kg m/s^2]
    ratio     F/N [1]; +infinity if N <= 0

    coin_force, in SI units; any others that are consistent do as well.
    """
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
    """A motion that orbit() has solved. It has no pointers, so that it may be
    copied, stored and shared; a library of another version, or on a machine of
    another byte order, returns EARG for it.

    period              of theta; 0 if the motion is steady [s]
    heading_per_period  what phi gains in it [rad]
    roll_per_period     what psi gains in it [rad]
    theta_min           the turning points of the lean [rad]
    theta_max           the turning points of the lean [rad]
    center              x, z of the centre of the annulus that the path fills;
                        NaN if it drifts [m]
    radius_min          of the annulus; NaN if it drifts [m]
    radius_max          of the annulus; NaN if it drifts [m]
    drift               x, z of the displacement per period, if
                        heading_per_period is k 2 pi; else 0 [m]
    conditioning        growth of rounding in a period, >= 1 [1]
    reserved            0: for members of later versions

    coin_orbit, in SI units; any others that are consistent do as well.
    """
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
    """What slows a coin and brings it to rest. Each member but soft and flat
    is the coefficient of one law of resistance; they add up, and 0 stands for
    none. Initialise by member names. Eq. (64)-(69), (95).

    damping   a torque damping |d(psi)/dt| times the angular momentum; of a
              coin that rolls [1]
    dry       a torque against the rolling of the contact along the rim,
              independent of its rate [kg m^2/s^2]
    viscous   the same, proportional to that rate [kg m^2/s]
    layer     the same, to its power 3/2: the boundary layer of the air [kg
              m^2/s^(1/2)]
    gap       the same, to the rate over cos(theta): the air in the gap below
              the coin [kg m^2/s]
    rolling   dry times cos(theta): the rolling moment of engines [kg m^2/s^2]
    spin      pivoting friction: a torque proportional to the turn about the
              vertical [kg m^2/s]
    angular   the angular damping of engines: the torque -angular (I_X wX, I_X
              wY, I_Z wZ) [1/s]
    soft      the rate of roll below which dry and rolling fade; 0 stands for
              sqrt(g/a)/1024 [1/s]
    flat      a coin whose cos(theta) comes below this lies flat; 0 stands for
              1e-6 [rad]
    reserved  must be 0

    coin_losses, in SI units; any others that are consistent do as well.
    """
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
    """What the table does to a real coin. Initialise by member names.

    mu_static    of Coulomb's friction, before the contact slips; mu_kinetic to
                 +infinity [1]
    mu_kinetic   while it slips; 0 to the bound of Painleve, Eq. (86) [1]
    restitution  of an impact, 0 to 1 [1]
    pull         acceleration along x and z, of a slope or a tray; of at most
                 100 gravity in size [m/s^2]
    reserved     must be 0
    losses       damping must be 0

    coin_table, in SI units; any others that are consistent do as well.
    """
    __slots__ = ()
    mu_static: float
    mu_kinetic: float
    restitution: float
    pull: "Array[c_double]"
    reserved: "Array[c_double]"
    losses: Losses
    _fields_ = [
        ("mu_static", c_double),
        ("mu_kinetic", c_double),
        ("restitution", c_double),
        ("pull", c_double * 2),
        ("reserved", c_double * 3),
        ("losses", Losses),
    ]


class Body(Plain):
    """A real coin. Whether it touches the table, rolls or slips is read off
    its height and velocities: move().

    s         where it is and how it turns
    y         height of the centre [m]
    vx        velocity of the centre [m/s]
    vy        velocity of the centre [m/s]
    vz        velocity of the centre [m/s]
    reserved  must be 0

    coin_body, in SI units; any others that are consistent do as well.
    """
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
    """A thin axisymmetric body, as Params.

    mass       M [kg]
    radius     a, of the rim that rolls [m]
    gravity    g [m/s^2]
    inertia_X  I_X = I_Y, about a diameter [kg m^2]
    inertia_Z  I_Z, about the axis [kg m^2]
    thickness  must be 0 [m]
    reserved   must be 0

    coinf_params, in SI units; any others that are consistent do as well.
    """
    __slots__ = ()
    mass: float
    radius: float
    gravity: float
    inertia_X: float
    inertia_Z: float
    thickness: float
    reserved: "Array[c_float]"
    _fields_ = [
        ("mass", c_float),
        ("radius", c_float),
        ("gravity", c_float),
        ("inertia_X", c_float),
        ("inertia_Z", c_float),
        ("thickness", c_float),
        ("reserved", c_float * 2),
    ]


class Statef(Plain):
    """Where a coin is and how it turns, as State.

    theta  lean, -pi/2 < theta < pi/2 [rad]
    phi    heading, |phi| <= 4096 [rad]
    psi    roll, |psi| <= 4096 [rad]
    x      of the centre [m]
    z      of the centre [m]
    wX     omega_X = d(theta)/dt [rad/s]
    wY     omega_Y [rad/s]
    wZ     omega_Z [rad/s]
    low    the rounding errors of the members above, in their order: 0 at the
           start. Where you set a member, set its low to 0

    coinf_state, in SI units; any others that are consistent do as well.
    """
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
    """The force of the table on the coin, as Force.

    R         in the table frame x, y, z [kg m/s^2]
    normal    N = R_y [kg m/s^2]
    friction  F = sqrt(R_x^2 + R_z^2) [kg m/s^2]
    ratio     F/N [1]; +infinity if N <= 0

    coinf_force, in SI units; any others that are consistent do as well.
    """
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



class Status(IntEnum):
    """Error.status, and OK.

    OK       done
    EPARAMS  parameters, losses or a table out of range
    ESTATE   a state or a body out of range
    ESTEP    dt or t out of range, or a step beyond its method
    EARG     null pointer, unknown method, branch or bit, tol
    EDOMAIN  no such steady motion, period or losses; or not a steady motion
    EFLAT    the coin falls flat within the time asked
    EBUILD   not the pinned bits: selftest()
    ERANGE   phi, psi, a place or a rate would leave its range, or a step is
             refused within 16 rad or radii of its end
    """
    OK = 0
    EPARAMS = -1
    ESTATE = -2
    ESTEP = -3
    EARG = -4
    EDOMAIN = -5
    EFLAT = -6
    EBUILD = -7
    ERANGE = -9


class Bits(IntFlag):
    """What a call that succeeded says of the coin.

    SLIPS        F > mu N > 0: a real coin slips
    LIFTS        N <= 0; of a body: it is off the table
    COARSE       |dt| fastest_rate() is above 0.35 (RK4), 1 (RK8), 0.08, 0.16
                 (symplectic methods)
    NEARLY_FLAT  cos(theta) < 0.01
    RESTS        the coin lies flat, or stands, and stays
    ROLLS        a slip or a flight has ended, and it rolls
    TOUCHES      the coin comes down on the table
    MORE         the steps of one call did not suffice: it has moved by
                 `reached`
    DECIDED      which side ends up is decided
    """
    SLIPS = 1
    LIFTS = 2
    COARSE = 4
    NEARLY_FLAT = 8
    RESTS = 16
    ROLLS = 32
    TOUCHES = 64
    MORE = 128
    DECIDED = 256


class Face(IntEnum):
    """How a coin lies: body_face().

    HEADS  the +Z side is up: theta < 0
    TAILS  the other side is up
    EDGE   upright, or it would fall back on its edge
    """
    HEADS = 1
    TAILS = 2
    EDGE = 3


class Method(IntEnum):
    """Methods of integration.

    RK4          classical Runge-Kutta, order 4
    RK8          Dormand-Prince, 12 stages, order 8
    SYMPLECTIC2  kick-drift-kick with the exact drift, order 2
    SYMPLECTIC4  Chin 4A with the exact drift, order 4
    """
    RK4 = 0
    RK8 = 1
    SYMPLECTIC2 = 2
    SYMPLECTIC4 = 3


OK = Status.OK
EPARAMS = Status.EPARAMS
ESTATE = Status.ESTATE
ESTEP = Status.ESTEP
EARG = Status.EARG
EDOMAIN = Status.EDOMAIN
EFLAT = Status.EFLAT
EBUILD = Status.EBUILD
ERANGE = Status.ERANGE
SLIPS = Bits.SLIPS
LIFTS = Bits.LIFTS
COARSE = Bits.COARSE
NEARLY_FLAT = Bits.NEARLY_FLAT
RESTS = Bits.RESTS
ROLLS = Bits.ROLLS
TOUCHES = Bits.TOUCHES
MORE = Bits.MORE
DECIDED = Bits.DECIDED
HEADS = Face.HEADS
TAILS = Face.TAILS
EDGE = Face.EDGE
RK4 = Method.RK4
RK8 = Method.RK8
SYMPLECTIC2 = Method.SYMPLECTIC2
SYMPLECTIC4 = Method.SYMPLECTIC4

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
    "coin_params_cylinder": (c_int32, {"p": Out(Params), "mass": c_double,
        "radius": c_double, "thickness": c_double, "gravity": c_double}),
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
    "coin_losses_check": (c_int32, {"losses": In(Losses), "p": In(Params)}),
    "coin_losses_power": (c_double, {"s": In(State), "p": In(Params),
        "losses": In(Losses)}),
    "coin_losses_rates": (c_int32, {"s": In(State), "p": In(Params),
        "losses": In(Losses), "out": Out(State)}),
    "coin_losses_reaction": (c_int32, {"s": In(State), "p": In(Params),
        "losses": In(Losses), "out": Out(Force)}),
    "coin_settle": (c_int32, {"s": Out(State), "p": In(Params),
        "losses": In(Losses), "t": c_double, "tol": c_double,
        "reached": Out(c_double)}),
    "coin_time_to_rest": (c_double, {"s": In(State), "p": In(Params),
        "losses": In(Losses), "tol": c_double}),
    "coin_losses_fit": (c_int32, {"losses": Out(Losses), "s": In(State),
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
    "coin_body_contact": (c_int32, {"b": In(Body), "p": In(Params),
        "v": Out(c_double, 3)}),
    "coin_body_strike": (c_int32, {"b": Out(Body), "p": In(Params),
        "J": In(c_double, 3), "r": In(c_double, 3)}),
    "coin_body_face": (c_int32, {"b": In(Body), "p": In(Params)}),
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
