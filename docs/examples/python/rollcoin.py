# SPDX-License-Identifier: MIT
"""librollcoin in Python, by ctypes alone: coins that roll without slipping.

    import rollcoin as rc

    quarter = rc.disc(0.00567, 0.01213, 9.80665)    # kg, m, m/s^2
    s = rc.State(theta=0.3, wY=5, wZ=40)            # rad, rad/s
    rc.run(s, quarter, rc.RK8, 1e-2, 100)           # a second
    print(s.theta, rc.center(s, quarter))

coin.h is the reference.  Its structs are classes here (State, Params, ...),
its constants lose their COIN_, and all its functions can be called by their own
names on `lib`, which turns errors into exceptions: lib.coin_step(s, p, 1e-3).
The functions of this module are those that most programs want; they return what
C writes through pointers.

The library is librollcoin.so.0.1 of the system, or the file that the environment
variable ROLLCOIN_LIBRARY names.
"""
import ctypes
import os
from ctypes import (POINTER, Structure, byref, c_char_p, c_double, c_int32,
                    c_size_t, c_uint32, c_uint64, sizeof)


class Plain(Structure):
    """A struct of coin.h; also a dtype for numpy."""

    def __repr__(self):
        members = ((name, getattr(self, name)) for name, _ in self._fields_)
        shown = (f"{name}={value if isinstance(value, float) else list(value)}"
                 for name, value in members)
        return f"{type(self).__name__}({', '.join(shown)})"


# ---- declarations: `make bindings-update` writes them from coin.h ------------
class Params(Plain):
    """coin_params."""
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
    _fields_ = [
        ("R", c_double * 3),
        ("normal", c_double),
        ("friction", c_double),
        ("ratio", c_double),
    ]


class Losses(Plain):
    """coin_losses."""
    _fields_ = [
        ("damping", c_double),
        ("dry", c_double),
        ("viscous", c_double),
        ("layer", c_double),
        ("gap", c_double),
        ("rolling", c_double),
        ("spin", c_double),
        ("soft", c_double),
    ]


class Orbit(Plain):
    """coin_orbit."""
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


OK = 0
EPARAMS = -1
ESTATE = -2
ESTEP = -3
EARG = -4
EDOMAIN = -5
EFLAT = -6
EBUILD = -7
SLIPS = 1
LIFTS = 2
COARSE = 4
NEARLY_FLAT = 8
RESTS = 16
RK4 = 0
RK8 = 1
SYMPLECTIC2 = 2
SYMPLECTIC4 = 3
MODEL_STEADY = 0
MODEL_WOBBLE = 1
MODEL_ORBIT = 2
MODEL_STEPS = 3

# Name: (result, arguments...)
PROTOTYPES = {
    "coin_params_disc": (c_int32, POINTER(Params), c_double, c_double,
        c_double),
    "coin_params_ring": (c_int32, POINTER(Params), c_double, c_double,
        c_double, c_double),
    "coin_params_body": (c_int32, POINTER(Params), c_double, c_double,
        c_double, c_double, c_double),
    "coin_params_check": (c_int32, POINTER(Params)),
    "coin_state_check": (c_int32, POINTER(State), POINTER(Params)),
    "coin_state_from_motion": (c_int32, POINTER(State), POINTER(Params),
        POINTER(c_double), POINTER(c_double), c_double, c_double),
    "coin_angular_velocity": (c_int32, POINTER(State), POINTER(c_double)),
    "coin_step": (c_int32, POINTER(State), POINTER(Params), c_double),
    "coin_run": (c_int32, POINTER(State), POINTER(Params), c_int32, c_double,
        c_uint64, POINTER(c_uint64)),
    "coin_sample": (c_int32, POINTER(State), POINTER(Params), c_int32,
        c_double, c_uint64, c_size_t, POINTER(State), POINTER(c_size_t)),
    "coin_batch_run": (c_int32, POINTER(State), c_size_t, POINTER(Params),
        c_int32, c_double, c_uint64, POINTER(c_int32)),
    "coin_advance": (c_int32, POINTER(State), POINTER(Params), c_double,
        c_double, POINTER(c_double)),
    "coin_max_dt": (c_double, POINTER(State), POINTER(Params), c_int32,
        c_double),
    "coin_method_name": (c_char_p, c_int32),
    "coin_method_order": (c_int32, c_int32),
    "coin_energy": (c_double, POINTER(State), POINTER(Params)),
    "coin_integrals": (c_int32, POINTER(State), POINTER(Params),
        POINTER(c_double)),
    "coin_reaction": (c_int32, POINTER(State), POINTER(Params),
        POINTER(Force)),
    "coin_rates": (c_int32, POINTER(State), POINTER(Params), POINTER(State)),
    "coin_center": (c_int32, POINTER(State), POINTER(Params),
        POINTER(c_double)),
    "coin_velocity": (c_int32, POINTER(State), POINTER(Params),
        POINTER(c_double)),
    "coin_contact": (c_int32, POINTER(State), POINTER(Params),
        POINTER(c_double), POINTER(c_double)),
    "coin_axes": (c_int32, POINTER(State), POINTER(c_double)),
    "coin_quaternion": (c_int32, POINTER(State), POINTER(c_double)),
    "coin_check": (c_int32, POINTER(State), POINTER(Params), c_int32,
        c_double, c_double),
    "coin_matrix": (c_int32, POINTER(State), POINTER(Params),
        POINTER(c_double)),
    "coin_advance_until": (c_int32, POINTER(State), POINTER(Params),
        c_double, c_double, c_double, c_int32, POINTER(c_double)),
    "coin_state_from_landing": (c_int32, POINTER(State), POINTER(Params),
        POINTER(c_double), POINTER(c_double), POINTER(c_double), c_double,
        c_double),
    "coin_steady_roll": (c_int32, POINTER(State), POINTER(Params), c_double),
    "coin_steady_spin": (c_int32, POINTER(State), POINTER(Params), c_double),
    "coin_steady_upright_spin": (c_int32, POINTER(State), POINTER(Params),
        c_double),
    "coin_steady_circle": (c_int32, POINTER(State), POINTER(Params),
        c_double, c_double, c_int32),
    "coin_steady_near": (c_int32, POINTER(State), POINTER(Params),
        POINTER(State)),
    "coin_steady_radii": (c_int32, POINTER(State), POINTER(Params),
        POINTER(c_double), POINTER(c_double)),
    "coin_stability": (c_int32, POINTER(State), POINTER(Params),
        POINTER(c_double)),
    "coin_critical_roll": (c_double, POINTER(Params)),
    "coin_critical_spin": (c_double, POINTER(Params)),
    "coin_steady_at": (c_int32, POINTER(State), POINTER(Params), c_double,
        POINTER(State)),
    "coin_wobble_at": (c_int32, POINTER(State), POINTER(Params),
        POINTER(State), c_double, POINTER(State)),
    "coin_orbit_init": (c_int32, POINTER(Orbit), POINTER(State),
        POINTER(Params)),
    "coin_orbit_at": (c_int32, POINTER(Orbit), c_double, POINTER(State)),
    "coin_model_needed": (c_int32, POINTER(State), POINTER(Params), c_double,
        c_double),
    "coin_losses_check": (c_int32, POINTER(Losses), POINTER(Params)),
    "coin_losses_power": (c_double, POINTER(State), POINTER(Params),
        POINTER(Losses)),
    "coin_losses_rates": (c_int32, POINTER(State), POINTER(Params),
        POINTER(Losses), POINTER(State)),
    "coin_losses_reaction": (c_int32, POINTER(State), POINTER(Params),
        POINTER(Losses), POINTER(Force)),
    "coin_settle": (c_int32, POINTER(State), POINTER(Params),
        POINTER(Losses), c_double, c_double, POINTER(c_double)),
    "coin_time_to_rest": (c_double, POINTER(State), POINTER(Params),
        POINTER(Losses)),
    "coin_quasisteady_at": (c_int32, POINTER(State), POINTER(Params),
        POINTER(Losses), c_double, POINTER(State)),
    "coin_losses_fit": (c_int32, POINTER(Losses), POINTER(State),
        POINTER(Params), c_double),
    "coin_version": (c_uint32,),
    "coin_version_string": (c_char_p,),
    "coin_status_string": (c_char_p, c_int32),
    "coin_sizeof_params": (c_uint32,),
    "coin_sizeof_state": (c_uint32,),
    "coin_sizeof_force": (c_uint32,),
    "coin_sizeof_losses": (c_uint32,),
    "coin_sizeof_orbit": (c_uint32,),
    "coin_selftest": (c_int32,),
}


# ---- end of declarations -----------------------------------------------------

class Error(Exception):
    """A negative status, in .status.

    The state is then as before the call; after run() and the like it is the
    last good one, and .done says how far they came, where that is known.
    """

    def __init__(self, status):
        super().__init__(lib.coin_status_string(status).decode())
        self.status = status
        self.done = None


def _no_error(status, function, arguments):
    if status < 0:
        raise Error(status)
    return status


def _no_nan(number, function, arguments):
    if number != number:
        raise ValueError(f"{function.__name__}: out of range")
    return number


def _load():
    """The library, every prototype declared, its structs as ours."""
    library = ctypes.CDLL(os.environ.get("ROLLCOIN_LIBRARY",
                                         "librollcoin.so.0.1"))
    for name, (result, *arguments) in PROTOTYPES.items():
        function = getattr(library, name)
        function.restype = result
        function.argtypes = arguments
        if result is c_int32:
            function.errcheck = _no_error
        elif result is c_double:
            function.errcheck = _no_nan
    if (library.coin_sizeof_state(), library.coin_sizeof_params()) != (
            sizeof(State), sizeof(Params)):
        raise ImportError("librollcoin and rollcoin.py are of two releases")
    return library


lib = _load()


def _vector(function, length, *arguments):
    out = (c_double * length)()
    function(*arguments, out)
    return tuple(out)


def _progress(kind, function, *arguments):
    """The status, and what the last output says: how far it came."""
    done = kind()
    try:
        return function(*arguments, byref(done)), done.value
    except Error as error:
        error.done = done.value
        raise


# ------------------------------------------------------------------ parameters
def disc(mass, radius, gravity):
    """A uniform thin disc."""
    p = Params()
    lib.coin_params_disc(p, mass, radius, gravity)
    return p


def ring(mass, radius, inner_radius, gravity):
    """A thin ring; inner_radius from 0, a disc, to radius, a hoop."""
    p = Params()
    lib.coin_params_ring(p, mass, radius, inner_radius, gravity)
    return p


def body(mass, radius, gravity, inertia_X, inertia_Z):
    """Any thin axisymmetric body."""
    p = Params()
    lib.coin_params_body(p, mass, radius, gravity, inertia_X, inertia_Z)
    return p


# -------------------------------------------------------------------- stepping
def run(s, p, method, dt, steps):
    """Moves s by steps of dt; returns COARSE or 0."""
    return _progress(c_uint64, lib.coin_run, s, p, method, dt, steps)[0]


def advance(s, p, t, tol=1e-9):
    """Moves s by any time t to an accuracy; returns the time moved."""
    return _progress(c_double, lib.coin_advance, s, p, t, tol)[1]


def sample(start, p, method, dt, steps_per_sample, out):
    """Fills out, a number of states or a buffer as states() takes it, with
    states steps_per_sample steps apart, the start first; returns it as an
    array of State."""
    path = (State * out)() if isinstance(out, int) else states(out)
    _progress(c_size_t, lib.coin_sample, start, p, method, dt,
              steps_per_sample, len(path), path)
    return path


def run_batch(coins, p, method, dt, steps):
    """Moves all of coins, a buffer as states() takes it, by steps of dt;
    returns what run() would say of each, an array of c_int32.  Raises only if
    it touched none: a coin that failed is where its last good step left it."""
    coins = states(coins)
    status = (c_int32 * len(coins))()
    try:
        lib.coin_batch_run(coins, len(coins), p, method, dt, steps, status)
    except Error as error:
        if error.status in (EARG, EPARAMS):
            raise
    return status


def states(buffer):
    """The memory of a writable buffer as an array of State, without a copy:
    of a numpy array of dtype State, or of float64 with 8 columns, of an
    array.array("d"), a bytearray, a mapped file."""
    count, rest = divmod(memoryview(buffer).nbytes, sizeof(State))
    if rest:
        raise ValueError("not a whole number of states")
    return (State * count).from_buffer(buffer)


# ----------------------------------------------------------------- observables
def energy(s, p):
    """The energy, constant along every motion."""
    return lib.coin_energy(s, p)


def integrals(s, p):
    """K_Y and K_Z, constant along every motion."""
    return _vector(lib.coin_integrals, 2, s, p)


def center(s, p):
    """x, y, z of the centre of mass."""
    return _vector(lib.coin_center, 3, s, p)


def velocity(s, p):
    """The velocity of the centre of mass."""
    return _vector(lib.coin_velocity, 3, s, p)


def quaternion(s):
    """The rotation w, x, y, z of the body."""
    return _vector(lib.coin_quaternion, 4, s)


def reaction(s, p):
    """The Force of the table on the coin."""
    force = Force()
    lib.coin_reaction(s, p, force)
    return force


def check(s, p, method, dt, mu):
    """Whether the rolling model and a step hold: 0, or the bits SLIPS, LIFTS,
    COARSE, NEARLY_FLAT."""
    return lib.coin_check(s, p, method, dt, mu)
