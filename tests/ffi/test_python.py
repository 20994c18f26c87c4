#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Errors become exceptions, outputs results, tables are used in place, and
nothing wrong is accepted in silence.  The package is installed."""
import array
import contextlib
import copy
import ctypes
import inspect
import io
import math
import mmap
import os
import pathlib
import pty
import pickle
import re
import runpy
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy
import rollcoin as rc

PYTHON = pathlib.Path(__file__).parents[2] / "docs" / "examples" / "python"
INF = math.inf


def quarter():
    return (rc.disc(0.00567, 0.01213, 9.80665),
            rc.State(theta=0.3, wY=5, wZ=40))


def quarterf():
    return (rc.discf(0.00567, 0.01213, 9.80665),
            rc.Statef(theta=0.3, wY=5, wZ=40))


def chip():
    """As thick as half its width; and a table."""
    p = rc.cylinder(0.005, 0.01, 0.01, 9.80665)
    table = rc.Table(mu_static=0.4, mu_kinetic=0.3, restitution=0.2)
    table.losses.dry = 1e-2 * p.mass * p.gravity * p.radius
    table.losses.spin = table.losses.dry
    return p, table


def toss(theta, wX=0):
    return rc.Body(rc.State(theta, wX=wX), 0.03, 0.1, 0.5)


def random_table(count, kind=rc.State):
    """States that a step of 1e-3 moves."""
    random = numpy.random.default_rng(1)
    table = numpy.zeros(count, kind)
    for member in rc.State._fields_:
        table[member[0]] = random.uniform(-1, 1, count)
    table["wZ"] *= 40
    return table


def same(one, other):
    """To the bit; NaN is NaN."""
    return numpy.asarray(one).tobytes() == numpy.asarray(other).tobytes()


class Package(unittest.TestCase):
    # Names that are not those of C without their prefix.
    NAMES = {"params_disc": "disc", "params_ring": "ring",
             "params_body": "body", "params_cylinder": "cylinder",
             "batch_run": "run_batch",
             "orbit_init": "orbit", "version_string": "version"}

    def test_every_function_has_one_of_python_that_names_it(self):
        for full in rc._declarations.PROTOTYPES:
            prefix, name = full.split("_", 1)
            self.assertIsNotNone(getattr(rc.lib, full).argtypes)
            if name in ("version", "sizeof"):
                continue  # for bindings
            name = self.NAMES.get(name, name)
            single = prefix == "coinf" and hasattr(rc, name + "f")
            function = getattr(rc, name + "f" * single)
            cited = full if single else "coin_" + full.split("_", 1)[1]
            self.assertIn(cited + "()", function.__doc__)

    def test_all_that_is_public_is_documented_and_annotated(self):
        for name in rc.__all__:
            thing = getattr(rc, name)
            if inspect.isfunction(thing):
                self.assertTrue(thing.__doc__, name)
                hints = inspect.signature(thing)
                for part in (*hints.parameters.values(),):
                    self.assertIsNot(part.annotation, part.empty, name)
                self.assertIsNot(hints.return_annotation, hints.empty, name)
            elif inspect.isclass(thing):
                self.assertTrue(thing.__doc__, name)
        folder = pathlib.Path(rc.__file__).parent
        self.assertTrue((folder / "py.typed").exists())

    def test_the_version_is_the_librarys(self):
        number = rc.lib.coin_version()
        self.assertEqual(rc.__version__, f"{number >> 16}."
                         f"{number >> 8 & 255}.{number & 255}")

    def test_the_library_in_it_computes_the_pinned_bits(self):
        rc.selftest()
        rc.selftestf()

    def test_names_and_texts(self):
        self.assertEqual(rc.method_name(rc.RK8), "rk8")
        self.assertRaises(ValueError, rc.method_name, 99)
        self.assertEqual(rc.status_string(rc.EFLAT), "the coin falls flat")

    def test_the_readmes_show_programs(self):
        for readme, lines in ((PYTHON / "README.md", 3),
                              (PYTHON / "../../../README.md", 1)):
            programs = re.findall(r"```python\n(.*?)```", readme.read_text(),
                                  re.S)
            with contextlib.redirect_stdout(io.StringIO()) as printed:
                for program in programs:
                    exec(program, {})
            self.assertEqual(len(printed.getvalue().splitlines()), lines)

    def test_the_answer_that_fits_losses_prints_what_it_shows(self):
        page = (PYTHON / "../../answers.md").read_text()
        program, shown = re.search(r"```python\n(.*?)```\n\n```\n(.*?)```",
                                   page, re.S).groups()
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(program, {})
        self.assertEqual(printed.getvalue(), shown)


class Structs(unittest.TestCase):
    def test_an_unknown_member_is_refused(self):
        s = rc.State()
        with self.assertRaises(TypeError):
            rc.State(thetta=1)
        with self.assertRaises(AttributeError):
            s.wz = 40
        with self.assertRaises(TypeError):
            rc.State(*range(9))
        with self.assertRaises(TypeError):
            rc.State(theta="0.3")
        for kind in (rc.Params, rc.Force, rc.Losses, rc.Orbit, rc.Statef):
            with self.assertRaises(AttributeError):
                kind().nothing = 1

    def test_equal_is_what_has_equal_members(self):
        p, s = quarter()
        self.assertEqual(s, rc.State(0.3, wY=5, wZ=40))
        self.assertNotEqual(s, rc.State(0.3, wY=5))
        self.assertNotEqual(s, rc.Statef(0.3, wY=5, wZ=40))
        self.assertNotEqual(s, 3)
        self.assertNotEqual(rc.State(theta=math.nan),
                            rc.State(theta=math.nan))
        self.assertEqual(rc.reaction(s, p), rc.reaction(s, p))
        self.assertRaises(TypeError, hash, s)

    def test_the_repr_is_short_and_makes_the_same(self):
        p, s = quarter()
        self.assertEqual(repr(s), "State(theta=0.3, wY=5.0, wZ=40.0)")
        for thing in (s, p, rc.reaction(s, p), rc.Losses(dry=1),
                      rc.Statef(theta=0.5, low=(0.25,) * 8), rc.State()):
            self.assertEqual(eval(repr(thing), vars(rc)), thing)
        self.assertLess(len(repr(rc.orbit(s, p))), 500)

    def test_a_copy_is_another(self):
        s = rc.State(theta=0.5)
        for other in (copy.copy(s), copy.deepcopy(s),
                      pickle.loads(pickle.dumps(s))):
            self.assertEqual(other, s)
            other.theta = 0.25
            self.assertEqual(s.theta, 0.5)


    def test_each_member_is_explained_with_its_unit(self):
        for kind in rc._declarations.STRUCTS.values():
            lines = re.split(r"\n(?= {4}\w)", kind.__doc__)
            for name, _ in kind._fields_:
                if name.startswith("private_"):
                    continue
                line = next(x for x in lines if x.startswith(f"    {name} "))
                if name not in ("s", "losses", "reserved", "low"):
                    self.assertRegex(line, r"\[[^]]+\]")
        for name, unit in (("theta", "rad"), ("x", "m"), ("wX", "rad/s")):
            self.assertRegex(rc.State.__doc__, rf"\b{name} .*\[{unit}\]")
        for kind in (rc.Status, rc.Bits, rc.Face, rc.Method):
            for member in kind:
                self.assertIn(f"    {member.name} ", kind.__doc__)

    def test_numbers_with_a_name_show_it(self):
        p, s = quarter()
        self.assertIs(rc.RK8, rc.Method(1))
        bits = rc.check(s, p, rc.RK4, 1, 0.1)
        self.assertEqual(bits, rc.SLIPS | rc.COARSE)
        self.assertIn("SLIPS", repr(bits))
        self.assertIsInstance(rc.run(s, p, rc.RK4, 1e-3, 1), rc.Bits)
        moved = rc.move(rc.body_from_state(s, p), p, rc.Table(), 1e-3)
        self.assertIn("Bits", repr(moved.status))
        with self.assertRaises(rc.Error) as caught:
            rc.step(s, p, 9)
        self.assertIs(caught.exception.status, rc.Status.ESTEP)


class Errors(unittest.TestCase):
    def test_a_message_names_what_was_wrong_as_python_does(self):
        p, s = quarter()
        b = rc.body_from_state(s, p)
        nan = math.nan
        for words, function, *arguments in (
                ("theta of State.*nan", rc.energy, rc.State(theta=nan), p),
                ("theta of State.*20", rc.step, rc.State(theta=20), p, 1e-3),
                ("wZ of State.*nan", rc.orbit, rc.State(wZ=nan), p),
                ("radius of P.*nan", rc.energy, s, rc.Params(1, nan, 1, 1, 1)),
                ("mass of Params", rc.energy, s, rc.Params(0, 1, 1, 1, 1)),
                (": dry of Losses.*-1", rc.settle, s, p,
                 rc.Losses(dry=-1, rolling=1e-6), 1),
                ("mu_kinetic of Table", rc.move, b, p, rc.Table(0.3, 0.4), 1),
                (": mass of Params", rc.losses_check, rc.Losses(dry=1),
                 rc.Params()),
                (": mass of Params", rc.table_check, rc.Table(), rc.Params()),
                (": mass of Params", rc.losses_fit, rc.Losses(dry=1), s,
                 rc.Params(), 1),
                (": dry of Losses", rc.losses_check, rc.Losses(dry=-1),
                 chip()[0]),
                (": p = None$", rc.body_from_motion, None, [1, 0, 0, 0],
                 *3 * [[0, 0, 0]]),
                (": losses = None$", rc.losses_power, s, p, None),
                ("vy of Body", rc.body_energy, rc.Body(s, 1, vy=nan), p),
                ("range: Params.*1e.20", rc.energy, s,
                 rc.Params(1e20, 1, 1, 1, 1)),
                (": mass = -1$", rc.disc, -1, 1, 1),
                (": radius = 0, gravity = nan$", rc.ring, 1, 0, 0, nan),
                (": mass = 1, .*inner_radius = 2,", rc.ring, 1, 1, 2, 1),
                (": tol = 5$", rc.time_to_rest, s, p, rc.Losses(dry=1), 5),
                (": t = nan$", rc.advance, s, p, nan),
                (": tol = 5$", rc.advance, s, p, 1, 5),
                ("shorten it: dt = 9$", rc.run, s, p, rc.RK4, 9, 1),
                (": s.theta of Body.*20", rc.body_energy,
                 rc.Body(rc.State(20), 1), p),
                (": y of Body", rc.move, rc.Body(), p, rc.Table(), 1),
                (": losses.dry of Table", rc.move, b, p,
                 rc.Table(losses=rc.Losses(dry=-1)), 1),
                (": theta of State", rc.body_from_state, rc.State(20), p),
                (": dry of Losses", rc.losses_fit, rc.Losses(dry=-1), s, p,
                 1),
                (": mass = 1, .*thickness = 5,", rc.cylinder, 1, 1, 5, 1),
                (": thickness of Params", rc.settle, s, chip()[0],
                 rc.Losses(dry=1e-7), 1),
                (": mu_kinetic of Table", rc.move, b, chip()[0],
                 rc.Table(0.3, 0.4), 1),
                (": pull of Table", rc.move, b, p, rc.Table(pull=(nan, 0)), 1),
                (r": J = \(1e\+30, .*, r = \(0.0, 0.0, 0.0\)$",
                 rc.body_strike, b, p, [1e30, 0, 0], [0, 0, 0]),
                (": s.theta of Body.*20", rc.body_strike,
                 rc.Body(rc.State(20), 1), p, [0, 0, 0], [0, 0, 0])):
            with self.assertRaisesRegex(rc.Error, words):
                function(*arguments)
        for words, function, *arguments in (
                ("^mass: a number", rc.disc, "1", 1, 1),
                ("^method: ", rc.run, s, p, "rk8", 1e-3, 1),
                ("^losses: int where a Losses", rc.settle, s, p, 1, 1),
                ("body_from_state", rc.move, s, p, rc.Table(), 1),
                ("its .s is one", rc.energy, b, p),
                ("run_batch", rc.run, numpy.zeros(2, rc.State), p, 0, 0, 1),
                ("^p: State where Params", rc.energy, p, s),
                ("^ndarray where a Body", rc.body_strike,
                 numpy.zeros(2, rc.Body), p, [0, 0, 0], [0, 0, 0])):
            with self.assertRaisesRegex(TypeError, words):
                function(*arguments)

    def test_of_an_engines_motion_the_wrong_argument_is_named(self):
        """And no other; what is too low for its rotation is r."""
        p, pf, nan = quarter()[0], quarterf()[0], math.nan
        good = {"q": (1, 0, 0, 0), "omega": (0, 0, 0), "r": (0, 1, 0),
                "v": (0, 0, 0), "x": 0, "z": 0}
        for function, names in (
                (rc.state_from_motion, ("q", "omega", "x", "z")),
                (rc.body_from_motion, ("q", "omega", "r", "v"))):
            for name in names:
                bad = nan if name in "xz" else (nan,) * len(good[name])
                given = {**{each: good[each] for each in names}, name: bad}
                for kind in (p, pf)[:1 + ("x" in names)]:
                    with self.assertRaisesRegex(
                            rc.Error, f"table: {name} = [(nan, ]*[)]?$"):
                        function(kind, **given)
        with self.assertRaisesRegex(rc.Error, r": r = \(0.0, 0.005, 0.0\)$"):
            rc.body_from_motion(p, (1, 0, 0, 0), (0, 0, 0), (0, 0.005, 0),
                                (0, 0, 0))
        # A thick coin that leans is higher than its radius.
        with self.assertRaisesRegex(rc.Error, "table: omega = "):
            rc.body_from_motion(chip()[0], (0.97, 0.24, 0, 0), (nan,) * 3,
                                (0, 1, 0), (0, 0, 0))
        # Each component is in range, but not that along e_X.
        with self.assertRaisesRegex(rc.Error, "table: omega = "):
            rc.state_from_motion(rc.disc(1, 1, 1), (1, 1, 2, 3),
                                 (9e5, 9e5, 0))

    def test_of_many_bodies_row_and_member_are_named(self):
        p, _ = quarter()
        bodies = numpy.zeros(4, rc.Body)
        bodies["y"] = 1
        with self.assertRaisesRegex(rc.Error, "^argument: .*: .*stop = 4$"):
            rc.move(bodies, p, rc.Table(), 1, stop=rc.COARSE)
        bodies["s"]["theta"][3] = 20
        for function, *arguments in ((rc.move, rc.Table(), 1),
                                     (rc.body_contact,)):
            with self.assertRaisesRegex(rc.Error,
                                        "^row 3: .*: s.theta of Body.*20"):
                function(bodies.copy(), p, *arguments)
        with self.assertRaisesRegex(rc.Error, "^param.*: losses.damping of T"):
            rc.move(bodies, p, rc.Table(math.inf, losses=rc.Losses(1)), 1)

    def test_a_row_that_numpy_cannot_set_says_what_can(self):
        p, s = quarter()
        for coin in (s, rc.body_from_state(s, p)):
            coins = numpy.zeros(3, type(coin))
            with self.assertRaisesRegex(TypeError, r"array\[k, ...\] = coin"):
                coins[1] = coin
            coins[1, ...] = coin
            self.assertEqual(coins[1].tobytes(), bytes(coin))

    def test_a_row_is_set_as_an_item_of_a_list_is(self):
        p, s = quarter()
        body = rc.body_from_state(s, p)
        coins, bodies = rc.zeros((2, 3)), rc.zeros(3, rc.Body)
        for array, one in ((coins[1], s), (bodies, body)):
            array[1] = one
            self.assertEqual(array[1].tobytes(), bytes(one))
            self.assertIs(type(array[1]), numpy.void)
            array[2] = array[1]
            array[0] = array[1].item()
            self.assertEqual(array.tobytes(), 3 * bytes(one))
            array[1:] = type(one)()
            self.assertEqual(array[1:].tobytes(), bytes(2 * len(bytes(one))))
        bodies["s"][2] = coins[1, 0]
        bodies["y"][1:] = bodies["y"][0]
        self.assertEqual(rc.State.from_buffer_copy(bodies["s"][2]), s)
        self.assertEqual(bodies["y"][2], body.y)
        with self.assertRaises(TypeError):
            coins[1, 0] = body
        again = pickle.loads(pickle.dumps(bodies))
        again[1] = body
        rc.move(again[:2], p, rc.Table(INF), 0.1)
        self.assertEqual(again[0], again[1])
        self.assertNotEqual(again[0], bodies[0])

    def test_arguments_are_in_the_order_of_c(self):
        """Those that Python has; what C only writes is a result."""
        python = {"coins": "s"}
        for full, (_, kinds) in rc._declarations.PROTOTYPES.items():
            name = full.split("_", 1)[1]
            function = getattr(rc, Package.NAMES.get(name, name), None)
            if function is None or full.startswith("coinf_"):
                continue
            had = [python.get(argument, argument) for argument, parameter in
                   inspect.signature(function).parameters.items()
                   if parameter.kind is parameter.POSITIONAL_OR_KEYWORD]
            self.assertEqual(had, [argument for argument in kinds
                                   if argument in had], full)

    def status(self, function, *arguments):
        with self.assertRaises(rc.Error) as caught:
            function(*arguments)
        self.assertIn(rc.status_string(caught.exception.status),
                      str(caught.exception))
        return caught.exception.status

    def test_a_negative_status_is_raised_and_touches_nothing(self):
        p, s = quarter()
        before = bytes(s)
        self.assertEqual(self.status(rc.disc, -1, 1, 1), rc.EPARAMS)
        self.assertEqual(self.status(rc.ring, 1, 1, 2, 1), rc.EPARAMS)
        self.assertEqual(self.status(rc.run, s, p, 99, 1e-3, 1), rc.EARG)
        self.assertEqual(self.status(rc.run, s, p, rc.RK4, 1, 1), rc.ESTEP)
        self.assertEqual(bytes(s), before)

    def test_an_error_says_how_far_a_run_came(self):
        p = rc.body(1, 1, 1, 0.25, 0.5)
        s = rc.State(theta=0.3)
        with self.assertRaises(rc.Error) as caught:
            rc.run(s, p, rc.RK8, 0.05, 1000)
        self.assertEqual(caught.exception.status, rc.ESTEP)
        again = rc.State(theta=0.3)
        self.assertGreater(caught.exception.done, 10)
        rc.run(again, p, rc.RK8, 0.05, caught.exception.done)
        self.assertEqual(bytes(again), bytes(s))
        with self.assertRaises(rc.Error) as caught:
            rc.advance(rc.State(theta=0.3), p, 100)
        self.assertEqual(caught.exception.status, rc.EFLAT)
        self.assertLess(1, caught.exception.done)

    def test_an_error_reaches_another_process(self):
        error = rc.Error(rc.ESTEP, 7, 3)
        other = pickle.loads(pickle.dumps(error))
        self.assertEqual((other.status, other.done, other.index, str(other)),
                         (rc.ESTEP, 7, 3, str(error)))

    def test_a_number_that_is_none_says_why(self):
        p, s = quarter()
        bad, none = rc.State(theta=2), rc.Losses()
        self.assertEqual(self.status(rc.energy, bad, p), rc.ESTATE)
        self.assertEqual(self.status(rc.energy, s, rc.Params()), rc.EPARAMS)
        self.assertEqual(self.status(rc.energy, rc.Statef(theta=2),
                                     quarterf()[0]), rc.ESTATE)
        self.assertEqual(self.status(rc.critical_roll, rc.Params()),
                         rc.EPARAMS)
        self.assertEqual(rc.losses_power(s, p, none), 0)
        self.assertRaises(ValueError, rc.energy, bad, p)
        for refer in (ctypes.byref, lambda thing: (type(thing) * 1)(thing)):
            self.assertEqual(self.status(rc.lib.coin_energy, refer(bad),
                                         refer(p)), rc.ESTATE)
            self.assertEqual(self.status(rc.lib.coin_critical_roll,
                                         refer(rc.Params())), rc.EPARAMS)

    def test_of_several_errors_that_of_coin_h_is_raised(self):
        """In its order, and the same of a coin, of a row and of a table."""
        p, _ = quarter()
        bad, wrong = rc.State(theta=2), rc.Losses(dry=-1)
        for expected, function, *arguments in (
                (rc.EPARAMS, rc.losses_power, bad, p, wrong),
                (rc.ESTATE, rc.losses_power, bad, p, rc.Losses()),
                (rc.EPARAMS, rc.time_to_rest, bad, p, wrong),
                (rc.ESTATE, rc.time_to_rest, bad, p, rc.Losses())):
            table = numpy.frombuffer(arguments[0], rc.State)
            for coin in (arguments[0], table[0], table):
                self.assertEqual(self.status(function, coin, *arguments[1:]),
                                 expected)

    def test_arguments_out_of_range_or_of_another_type_are_refused(self):
        p, s = quarter()
        before = bytes(s)
        for steps in (-1, 1 << 64):
            self.assertRaises(ValueError, rc.run, s, p, rc.RK4, 1e-3, steps)
            self.assertRaises(ValueError, rc.lib.coin_run, s, p, rc.RK4, 1e-3,
                              steps, None)
        self.assertRaises(ValueError, rc.body_from_motion, p, [1, 0, 0],
                          *3 * [[0, 0, 0]])
        for bad in (1.5, "1", None):
            self.assertRaises(TypeError, rc.run, s, p, rc.RK4, 1e-3, bad)
        for method in (1 << 32, -(1 << 32), 0.0):
            self.assertRaises((TypeError, ValueError), rc.run, s, p, method,
                              1e-3, 1)
        self.assertRaises(TypeError, rc.step, s, p, "1e-3")
        self.assertRaises(TypeError, rc.step, p, s, 1e-3)
        self.assertRaises(TypeError, rc.step, s, quarterf()[0], 1e-3)
        self.assertRaises(TypeError, rc.energy, quarterf()[1], p)
        self.assertRaises(TypeError, rc.step, [s], p, 1e-3)
        self.assertRaises(TypeError, rc.energy, None, p)
        self.assertRaises(TypeError, rc.rates, s, None)
        self.assertRaises(TypeError, rc.steady_roll, 3, 1)
        self.assertRaises(ValueError, rc.sample, s, p, rc.RK4, 1e-3, -1, 3)
        self.assertRaises(ValueError, rc.sample, s, p, rc.RK4, 1e-3, 1, -3)
        self.assertRaises(ValueError, rc.state_from_motion, p, [1, 0, 0],
                          [0, 0, 0])
        self.assertRaises(TypeError, rc.energy, s, p, status=numpy.zeros(1))
        self.assertRaises(TypeError, rc.lib.coin_center, s, p,
                          (ctypes.c_double * 2)())
        self.assertRaises(TypeError, rc.lib.coin_center, s, p,
                          (ctypes.c_float * 3)())
        self.assertEqual(self.status(rc.lib.coin_energy, None, p), rc.EARG)
        self.assertEqual(self.status(rc.lib.coin_center, s, p, None), rc.EARG)
        self.assertEqual(bytes(s), before)


class Results(unittest.TestCase):
    def test_they_are_those_of_the_pointers(self):
        p, s = quarter()
        self.assertEqual(rc.center(s, p)[0], s.x)
        self.assertEqual(rc.center(s, p)[1], p.radius * math.cos(s.theta))
        self.assertEqual(len(rc.velocity(s, p)), 3)
        self.assertEqual(len(rc.integrals(s, p)), 2)
        self.assertEqual(len(rc.axes(s)), 9)
        self.assertEqual([len(v) for v in rc.contact(s, p)], [3, 3])
        self.assertAlmostEqual(sum(q * q for q in rc.quaternion(s)), 1, 15)
        self.assertEqual(rc.check(s, p, rc.RK4, 1e-3, 0.01), rc.SLIPS)
        self.assertEqual(rc.check(s, p, rc.RK4, 1e-3, INF), 0)
        self.assertEqual(rc.run(s, p, rc.RK4, 1e-2, 1), rc.COARSE)
        self.assertEqual(rc.step(s, p, 1e-2), rc.COARSE)
        self.assertEqual(rc.advance(s, p, 0.01), 0.01)

    def test_an_engines_motion_comes_back(self):
        p, s = quarter()
        back = rc.state_from_motion(p, rc.quaternion(s),
                                    rc.angular_velocity(s), s.x, s.z)
        for member, _ in rc.State._fields_:
            self.assertAlmostEqual(getattr(back, member), getattr(s, member),
                                   12)

    def test_games_get_a_matrix_and_the_first_slip(self):
        p, s = quarter()
        m = numpy.reshape(rc.matrix(s, p), (4, 4)).T
        self.assertTrue(same(m[:3, 3], rc.center(s, p)))
        self.assertAlmostEqual(numpy.linalg.det(m), 1, 14)
        self.assertEqual(rc.matrix(random_table(5), p).shape, (5, 16))
        self.assertEqual(len(rc.matrix(*quarterf()[::-1])), 16)
        most = rc.reaction(s, p).ratio
        rc.advance(s, p, 0.05)  # half a period of the lean
        mu = (most + rc.reaction(s, p).ratio) / 2
        b = rc.body_from_state(s, p)
        table = rc.Table(mu_static=mu)
        found = rc.move(b, p, table, 1, stop=rc.SLIPS)
        self.assertEqual(found.status, rc.SLIPS)
        self.assertAlmostEqual(rc.reaction(b.s, p).ratio, mu, 6)
        self.assertLess(found.reached, 0.06)
        with self.assertRaises(rc.Error):
            rc.move(b, p, table, 1, stop=rc.COARSE)

    def test_steady_motions_are_steady(self):
        p = quarter()[0]
        circle = rc.steady_circle(p, 0.4, 30)
        self.assertEqual(len(rc.steady_radii(circle, p)), 2)
        self.assertLess(rc.stability(circle, p), 0)
        self.assertEqual(rc.steady_roll(p, 30).wZ, 30)
        self.assertEqual(rc.steady_upright_spin(p, 9).wY, 9)
        self.assertGreater(rc.steady_spin(p, 0.5).wY, 0)
        turn = rc.steady_turn(p, 0.4, 0.04)
        self.assertAlmostEqual(rc.steady_radii(turn, p)[0], 0.04, 15)
        ride = rc.steady_ride(p, turn.wZ * p.radius, 0.04)
        self.assertAlmostEqual(ride.theta, 0.4, 12)
        self.assertAlmostEqual(rc.critical_roll(p) ** 2,
                               p.gravity / (3 * p.radius), 9)
        self.assertAlmostEqual(rc.critical_spin(p) ** 2,
                               0.8 * p.gravity / p.radius, 9)
        self.assertAlmostEqual(rc.steady_at(circle, p, 0.1).theta, 0.4, 12)

    def test_an_orbit_is_asked_for_one_time_or_many(self):
        p, s = quarter()
        o = rc.orbit(s, p)
        self.assertLess(o.theta_min, o.theta_max)
        moved = copy.copy(s)
        rc.advance(moved, p, 0.5, 1e-13)
        self.assertAlmostEqual(rc.orbit_at(o, 0.5).x, moved.x, 10)
        times = numpy.linspace(-1, 1, 12).reshape(3, 4)
        many = rc.orbit_at(o, times)
        self.assertEqual(many.shape, (3, 4))
        for at, state in zip(times.flat, many.flat):
            self.assertEqual(state.tobytes(), bytes(rc.orbit_at(o, at)))
        status = numpy.zeros(2, numpy.int32)
        some = rc.orbit_at(o, [0, math.nan], status=status)
        self.assertEqual(list(status), [0, rc.ESTEP])
        self.assertTrue(math.isnan(some["theta"][1]))
        self.assertRaises(rc.Error, rc.orbit_at, o, [0, math.nan])
        one = rc.orbit_at(o, numpy.array(0.5))
        self.assertEqual(one.shape, ())
        self.assertEqual(one.tobytes(), bytes(rc.orbit_at(o, 0.5)))

    def test_losses_bring_a_coin_to_rest(self):
        p = quarter()[0]
        s = rc.steady_spin(p, 1.0)
        law = rc.Losses(viscous=1e-9)
        losses = rc.losses_fit(law, s, p, 8.0)
        self.assertEqual(law, rc.Losses(viscous=1e-9))
        rc.losses_check(losses, p)
        self.assertAlmostEqual(rc.time_to_rest(s, p, losses), 8, 0)
        self.assertEqual(rc.time_to_rest(s, p, rc.Losses()), INF)
        self.assertGreater(rc.losses_power(s, p, losses), 0)
        self.assertNotEqual(rc.losses_rates(s, p, losses), rc.rates(s, p))
        self.assertNotEqual(rc.losses_reaction(s, p, losses),
                            rc.reaction(s, p))
        self.assertEqual(rc.settle(s, p, losses, 1, 1e-6).status, 0)
        status, reached = rc.settle(s, p, losses, 60, 1e-6)
        self.assertEqual(status, rc.RESTS)
        self.assertAlmostEqual(reached, 7, 1)

    def test_a_body_slips_and_rolls_again(self):
        p, s = quarter()
        table = rc.Table(mu_static=0.5, mu_kinetic=0.5)
        rc.table_check(table, p)
        b = rc.body_from_state(s, p)
        self.assertAlmostEqual(rc.body_contact(b, p)[0], 0, 12)
        self.assertAlmostEqual(rc.body_energy(b, p), rc.energy(s, p), 12)
        self.assertEqual(rc.body_matrix(b, p)[13], b.y)
        self.assertEqual(eval(repr(b), vars(rc)), b)
        b.vx += 0.1
        self.assertAlmostEqual(rc.body_reaction(b, p, table).ratio, 0.5, 9)
        self.assertEqual(rc.move(b, p, table, 1e-3).status, rc.SLIPS)
        self.assertEqual(rc.move(b, p, table, 1), (0, 1))
        air = rc.body_from_motion(p, [1, 0, 0, 0], [0, 0, 5], [0, 1, 0],
                                  [0, 0, 0])
        falls = copy.copy(air)
        self.assertEqual(rc.move(falls, p, table, 1, stop=rc.TOUCHES).status,
                         rc.LIFTS | rc.TOUCHES)
        self.assertAlmostEqual(rc.body_contact(falls, p)[1],
                               -(2 * 9.80665 * (1 - 0.01213))**0.5, 9)
        self.assertEqual(rc.move(air, p, table, 0.1), (rc.LIFTS, 0.1))
        self.assertEqual(rc.move(air, p, table, 1), (0, 1))
        b.s.theta = 2
        with self.assertRaises(rc.Error) as caught:
            rc.body_energy(b, p)
        self.assertEqual(caught.exception.status, rc.ESTATE)

    def test_a_cylinder_is_tossed_to_heads_to_tails_and_to_its_edge(self):
        p, table = chip()
        self.assertEqual(p.thickness, 0.01)
        self.assertAlmostEqual(p.inertia_X, 5e-7 / 3, 20)
        ends = [(rc.HEADS, 0.005), (rc.TAILS, 0.005), (rc.EDGE, 0.01)]
        coins = [toss(-1), toss(1), toss(-1, 10)]
        for b, (face, y) in zip(coins, ends):
            said = rc.move(b, p, table, INF, 1e-6, rc.DECIDED)
            self.assertIn(rc.DECIDED, said.status)
            self.assertNotIn(rc.RESTS, said.status)
            self.assertIs(rc.body_face(b, p), face)
            self.assertIn(rc.RESTS, rc.move(b, p, table, INF, 1e-6).status)
            self.assertIs(rc.body_face(b, p), face)
            self.assertAlmostEqual(b.y, y, 12)
        many = numpy.stack(coins)
        self.assertEqual(list(rc.body_face(many, p)), [1, 2, 3])
        many["s"]["theta"][1] = 2
        with self.assertRaises(rc.Error) as caught:
            rc.body_face(many, p)
        self.assertEqual(caught.exception.index, 1)
        status = numpy.zeros(3, numpy.int32)
        rc.body_face(many, p, status=status)
        self.assertEqual(list(status), [rc.HEADS, rc.ESTATE, rc.EDGE])

    def test_a_slope_holds_a_coin_or_lets_it_slide(self):
        p, table = chip()
        b = toss(1)
        rc.move(b, p, table, INF, 1e-6)
        table.pull[0] = 0.3 * p.gravity
        self.assertEqual(rc.move(b, p, table, 0.1), (rc.RESTS, 0))
        table.pull[0] = 0.5 * p.gravity
        self.assertEqual(rc.move(b, p, table, 0.1), (rc.SLIPS, 0.1))
        self.assertAlmostEqual(b.vx, (0.5 - 0.3) * p.gravity * 0.1, 9)
        with self.assertRaises(rc.Error) as caught:
            rc.move(b, p, table, 0.1, stop=rc.DECIDED)
        self.assertEqual(caught.exception.status, rc.EARG)

    def test_a_blow_turns_and_moves_a_body(self):
        p, _ = chip()
        for b in (rc.body_from_state(rc.State(), p),
                  numpy.stack([rc.body_from_state(rc.State(), p)])[0]):
            rc.body_strike(b, p, [0, 0, 1e-3], [0, p.radius, 0])
            s = b.s if isinstance(b, rc.Body) else rc.State(*b["s"])
            vz = b.vz if isinstance(b, rc.Body) else b["vz"]
            self.assertAlmostEqual(vz, 1e-3 / p.mass, 12)
            self.assertAlmostEqual(s.wX, 1e-3 * p.radius / p.inertia_X, 9)
        before = bytes(b)
        with self.assertRaises(rc.Error) as caught:
            rc.body_strike(b, p, [1e30, 0, 0], [0, 0, 0])
        self.assertEqual(caught.exception.status, rc.ESTATE)
        self.assertEqual(bytes(b), before)
        self.assertRaises(ValueError, rc.body_strike, b, p, [1, 2], [0, 0, 0])

    def test_what_is_for_thin_coins_refuses_others(self):
        p, s = chip()[0], rc.State()
        for call in (lambda: rc.energy(s, p), lambda: rc.step(s, p, 1e-3),
                     lambda: rc.critical_roll(p), lambda: rc.orbit(s, p),
                     lambda: rc.energy(numpy.zeros(2, rc.State), p)):
            with self.assertRaisesRegex(rc.Error, "thickness of Params") as \
                    caught:
                call()
            self.assertEqual(caught.exception.status, rc.EPARAMS)

    def test_a_table_of_bodies_moves_as_one_by_one(self):
        p, _ = quarter()
        table = rc.Table(mu_static=0.5, mu_kinetic=0.4, restitution=0.6)
        bodies = numpy.zeros((2, 3), rc.Body)
        bodies["y"] = 0.1
        bodies["s"]["wX"] = numpy.arange(6).reshape(2, 3)
        wanted = [rc.Body.from_buffer_copy(b) for b in bodies.reshape(-1)]
        status, reached = rc.move(bodies, p, table, 0.3)
        for i, b in enumerate(wanted):
            one = rc.move(b, p, table, 0.3)
            self.assertEqual(one, (status.flat[i], reached.flat[i]))
            self.assertTrue(same(numpy.frombuffer(b, rc.Body)[0],
                                 bodies.reshape(-1)[i]))
        for name, *rest in (("energy",), ("reaction", table), ("contact",),
                            ("matrix",)):
            function = getattr(rc, "body_" + name)
            many = function(bodies, p, *rest)
            self.assertEqual(many.shape[:2], bodies.shape)
            alone = rc.Body.from_buffer_copy(bodies[1, 0])
            one = function(alone, p, *rest)
            if name == "reaction":
                one = numpy.frombuffer(one, rc.Force)[0]
            self.assertTrue(same(many[1, 0], one), name)
        row = bodies[1, 0]
        rc.move(row, p, table, 0.1)
        self.assertEqual(row["y"], bodies["y"][1, 0])
        self.assertNotEqual(row["y"], alone.y)
        bodies["y"][1, 1] = -1
        with self.assertRaises(rc.Error) as caught:
            rc.move(bodies, p, table, 0.3)
        self.assertEqual(caught.exception.index, 4)
        rc.move(bodies, p, table, 0.3, status=status)
        self.assertEqual(status[1, 1], rc.ESTATE)
        with self.assertRaises(TypeError):
            rc.move(numpy.zeros(2, rc.State), p, table, 0.3)
        with self.assertRaises(ValueError):
            rc.move(bodies[:, ::2], p, table, 0.3)

    def test_threads_that_share_a_table_give_the_same_bits(self):
        p, _ = quarter()
        table = rc.Table(mu_static=0.5, mu_kinetic=0.4, restitution=0.6)
        bodies = numpy.zeros((5, 9), rc.Body)
        bodies["y"] = 0.1
        bodies["s"]["wX"] = numpy.arange(45).reshape(5, 9)
        bodies["y"][3, 4] = -1
        states = numpy.zeros(7, rc.State)
        states["theta"] = 1.5 - 1e-3 * numpy.arange(7)  # goes on: rc.MORE
        for many, args, call in (
                (bodies, (table, math.inf, 1e-6), rc.move),
                (states, (rc.Losses(spin=1e-9), 1e4, 1e-9), rc.settle)):
            found = []
            for workers in (1, 2, 3, 100, -1):
                moved = many.copy()
                status = numpy.zeros(many.shape, numpy.int32)
                reached = call(moved, p, *args, status=status,
                               workers=workers)[1]
                found.append((moved.tobytes(), status.tobytes(),
                              reached.tobytes()))
            self.assertEqual(len(set(found)), 1)
            self.assertNotEqual(found[0][0], many.tobytes())
        with self.assertRaises(rc.Error) as caught:
            rc.move(bodies, p, table, 0.1, workers=2)
        self.assertEqual(caught.exception.index, 31)
        for workers in (0, -2):
            with self.assertRaisesRegex(ValueError, "workers: .* or more"):
                rc.move(bodies, p, table, 0.1, workers=workers)
        rc.move(bodies[:0], p, table, 0.1, workers=2)

    def test_long_work_of_threads_tells_a_terminal_how_far_it_is(self):
        program = ("import numpy, rollcoin as rc\n"
                   "table = numpy.zeros(3000, rc.State)\n"
                   "table['theta'], table['wZ'] = 0.3, 40\n"
                   "rc.advance(table, rc.disc(0.00567, 0.01213, 9.80665), "
                   "200, 1e-13, workers=2)\n")
        ours, theirs = pty.openpty()
        child = subprocess.Popen([sys.executable, "-c", program],
                                 stderr=theirs)
        os.close(theirs)
        try:
            said = os.read(ours, 100).decode()
        finally:
            child.kill()
            child.wait()
            os.close(ours)
        self.assertRegex(said, r"^\r[0-9]+ of 3000, [0-9]+ s to go")

    def test_the_maps_of_luck_are_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            drawn = pathlib.Path(folder) / "luck.png"
            argv, sys.argv = sys.argv, ["luck.py", str(drawn), "60"]
            try:
                made = runpy.run_path(PYTHON / "luck.py")
            finally:
                sys.argv = argv
            self.assertGreater(drawn.stat().st_size, 20000)
        cannot_stand = (made["heights"] + made["spins"][:, None]**2 / 8) < 1
        self.assertTrue(made["heads"][cannot_stand].all())
        self.assertGreater(cannot_stand.sum(), 10)
        source = (PYTHON / "luck.py").read_text()
        self.assertLessEqual(len(source.splitlines()), 40)
        for program, *rest, says in (
                ("luck.py", "usage: "), ("luck.py", "m.png", "-3", "usage: "),
                ("luck.py", "m.png", "0", "3 columns"),
                ("toss.py", "0", "0 coins, where 1 or more"),
                ("toss.py", "many", "many coins, where 1 or more")):
            told = subprocess.run([sys.executable, PYTHON / program, *rest],
                                  capture_output=True, text=True)
            self.assertEqual(told.returncode, 1)
            self.assertIn(says, told.stderr)
            self.assertEqual(len(told.stderr.splitlines()), 1)

    def test_the_page_on_luck_shows_a_line_of_toss_py(self):
        page = (PYTHON / ".." / ".." / "luck.md").read_text()
        shown = re.findall("```python\n(.*?)```", page, re.S)
        self.assertEqual(len(shown), 1)
        self.assertIn(shown[0], (PYTHON / "toss.py").read_text())

    def test_a_negative_thickness_is_named(self):
        p, _ = quarter()
        p.thickness = -1
        with self.assertRaisesRegex(rc.Error, "thickness of Params"):
            rc.move(numpy.zeros(2, rc.Body), p, rc.Table(), 1)

    def test_a_call_goes_on_to_its_time(self):
        """As the loop does that users of C write."""
        p, s = quarter()
        for call, coin, inputs, t in (
                (rc.advance, s, lambda t: (t, 1e-2), 4e4),
                (rc.settle, copy.copy(s),
                 lambda t: (rc.Losses(dry=1e-15), t, 1e-2), 2.5e4),
                (rc.move, rc.body_from_state(s, p),
                 lambda t: (rc.Table(INF), t, 1e-2, 0), 1000)):
            alone, part, left, calls = copy.copy(coin), ctypes.c_double(), t, 0
            while left > 0:
                getattr(rc.lib, "coin_" + call.__name__)(
                    alone, p, *inputs(left), ctypes.byref(part))
                left, calls = left - part.value, calls + 1
            self.assertGreater(calls, 1)
            said = call(coin, p, *inputs(t))
            reached = said if call is rc.advance else said.reached
            self.assertAlmostEqual(reached / t, 1, 14)
            if call is not rc.advance:
                self.assertEqual(said.status, 0)
            for one, other in zip(numpy.frombuffer(coin),
                                  numpy.frombuffer(alone)):
                self.assertAlmostEqual(one, other, 6)

    def test_rows_go_on_like_coins_and_an_infinite_time_has_an_end(self):
        """One rests at once, one rolls on, one leaves the range of psi."""
        p, s = quarter()
        bodies = numpy.zeros(3, rc.Body)
        bodies[:] = rc.body_from_state(s, p)
        bodies[0, ...] = rc.body_from_state(rc.State(), p)
        bodies["s"]["psi"][2] = 2.0**31 - 20000
        whole, rc._move.CALLS = rc._move.CALLS, 3
        try:
            for t, ends in ((1000, [rc.RESTS, rc.OK, rc.ERANGE]),
                            (INF, [rc.RESTS, rc.MORE, rc.ERANGE])):
                moved = bodies.copy()
                status = numpy.zeros(3, numpy.int32)
                said = rc.move(moved, p, rc.Table(INF), t, 1e-2, status=status)
                self.assertEqual(list(status), ends)
                self.assertGreater(said.reached[2], 400)
                low, high = (600, 800) if t == INF else (999, 1001)
                self.assertTrue(low < said.reached[1] < high)
                for row in (0, 1):
                    alone = rc.Body.from_buffer_copy(bodies[row])
                    self.assertEqual(
                        rc.move(alone, p, rc.Table(INF), t, 1e-2),
                        (status[row], said.reached[row]))
                    self.assertEqual(bytes(alone), moved[row].tobytes())
                with self.assertRaises(rc.Error) as caught:
                    rc.move(bodies[2].copy(), p, rc.Table(INF), t, 1e-2)
                self.assertEqual((caught.exception.status,
                                  caught.exception.done),
                                 (rc.ERANGE, said.reached[2]))
        finally:
            rc._move.CALLS = whole

    def test_floats_are_called_by_the_same_names(self):
        p, s = quarterf()
        pd, sd = quarter()
        self.assertEqual(rc.run(s, p, rc.RK4, 1e-3, 1000), 0)
        rc.run(sd, pd, rc.RK4, 1e-3, 1000)
        self.assertAlmostEqual(s.theta, sd.theta, 5)
        self.assertAlmostEqual(rc.energy(s, p) / rc.energy(sd, pd), 1, 5)
        self.assertEqual(rc.step(s, p, 1e-3), 0)
        self.assertAlmostEqual(rc.reaction(s, p).ratio,
                               rc.reaction(sd, pd).ratio, 2)
        table = random_table(20, rc.Statef)
        self.assertEqual(rc.energy(table, p).dtype, numpy.float32)
        self.assertEqual(rc.quaternion(table).shape, (20, 4))
        self.assertTrue(same(rc.center(table, p)[7],
                             numpy.float32(rc.center(table[7], p))))
        before = table.copy()
        self.assertRaises(TypeError, rc.run_batch, table, p, rc.RK4, 1e-3, 3)
        self.assertTrue(same(before, table))
        self.assertRaises(TypeError, rc.settle, s, pd, rc.Losses(), 0.5)
        self.assertRaises(TypeError, rc.advance, s, p, 1)
        self.assertRaises(TypeError, rc.losses_power, s, p, rc.Losses())
        self.assertRaises(TypeError, rc.energy, table, pd)
        self.assertRaises(TypeError, rc.energy, random_table(3), p)
        for make in (rc.ringf(1, 1, 0.5, 1), rc.bodyf(1, 1, 1, 0.25, 0.5)):
            rc.params_check(make)


class Tables(unittest.TestCase):
    READS = {"energy": (), "fastest_rate": (), "integrals": 2,
             "reaction": (), "rates": (), "center": 3, "velocity": 3,
             "losses_power": ()}

    def test_a_row_is_what_the_coin_itself_gives(self):
        p, _ = quarter()
        table = random_table(200)
        for name in ("energy", "fastest_rate", "integrals", "reaction",
                     "rates", "center", "velocity"):
            many = getattr(rc, name)(table, p)
            for k in (0, 63, 64, 199):
                one = getattr(rc, name)(table[k], p)
                if isinstance(one, ctypes.Structure):
                    one = numpy.frombuffer(one, type(one))[0]
                self.assertTrue(same(many[k], one), name)
        points, speeds = rc.contact(table, p)
        self.assertTrue(same((points[9], speeds[9]), rc.contact(table[9], p)))
        for name, width in (("quaternion", 4), ("axes", 9),
                            ("angular_velocity", 3)):
            many = getattr(rc, name)(table)
            self.assertEqual(many.shape, (200, width))
            self.assertTrue(same(many[5], getattr(rc, name)(table[5])))
        bits = rc.check(table, p, rc.RK4, 1e-3, 0.1)
        self.assertEqual(bits.dtype, numpy.int32)
        self.assertEqual(list(bits), [rc.check(row, p, rc.RK4, 1e-3, 0.1)
                                      for row in table])
        self.assertTrue(set(bits) - {0})

    def test_dtype_state_float64_and_flat_buffers_are_one(self):
        p, _ = quarter()
        table = random_table(12)
        numbers = table.view(numpy.float64)
        want = rc.energy(table, p)
        self.assertTrue(same(rc.energy(numbers, p), want))
        self.assertTrue(same(rc.energy(numbers.reshape(12, 8), p), want))
        self.assertTrue(same(rc.energy(array.array("d", numbers), p), want))
        self.assertTrue(same(rc.energy(bytearray(table.tobytes()), p), want))
        self.assertTrue(same(rc.energy(rc.states(table), p), want))
        self.assertTrue(same(rc.energy(memoryview(numbers), p), want))
        self.assertEqual(rc.energy(table.reshape(3, 4), p).shape, (3, 4))
        self.assertEqual(rc.quaternion(numbers.reshape(3, 4, 8)).shape,
                         (3, 4, 4))
        self.assertTrue(same(rc.energy(table[::2], p), want[::2]))
        self.assertTrue(same(rc.energy(table[::-1], p), want[::-1]))
        table.flags.writeable = False
        self.assertTrue(same(rc.energy(table, p), want))
        self.assertEqual(rc.energy(table[:0], p).shape, (0,))
        self.assertEqual(rc.energy(table[3], p), want[3])

    def test_another_dtype_or_shape_is_refused(self):
        p, s = quarter()
        other = numpy.dtype([(name, "f8") for name, _ in rc.State._fields_]
                            [::-1])
        floats = numpy.zeros(3, rc.Statef)
        wrong = [numpy.zeros((8, 8), complex), numpy.zeros(8, other),
                 numpy.zeros((8, 8), object), numpy.zeros((4, 16)),
                 numpy.zeros((8, 7)), numpy.zeros(7), numpy.zeros((8, 1)),
                 numpy.zeros(()), numpy.zeros(3, rc.Force),
                 numpy.ma.zeros((8, 8)), array.array("f", [0] * 64),
                 array.array("q", [0] * 64), bytearray(65), [s, p], [[1, 2]], [], "coins",
                 None, (rc.Statef * 3)(), floats]
        for bad in wrong:
            calls = [lambda: rc.energy(bad, p),
                     lambda: rc.run_batch(bad, p, rc.RK4, 1e-3, 1),
                     lambda: rc.advance(bad, p, 1e-3),
                     lambda: rc.sample(s, p, rc.RK4, 1e-3, 1, bad)]
            if not any(bad is some for some in wrong[-2:]):  # which states() would take
                calls.append(lambda: rc.states(bad))
            for call in calls:
                with self.assertRaises((TypeError, ValueError),
                                       msg=repr(bad)) as caught:
                    call()
                self.assertNotIsInstance(caught.exception, rc.Error)

    def test_a_table_complains_as_a_coin_does(self):
        p, s = quarter()
        for some in (s, numpy.zeros(2, rc.State)):
            for kind, words, function, *arguments in (
                    (TypeError, "^losses: int where a Losses belongs$",
                     rc.losses_power, some, p, 1),
                    (TypeError, "^method: 'str'", rc.check, some, p, "rk4", 1,
                     1),
                    (ValueError, "^method: .* is not in", rc.check, some, p,
                     1 << 32, 1, 1),
                    (TypeError, "^tol: a number", rc.advance, some, p, 1,
                     "1e-9")):
                with self.assertRaisesRegex(kind, words):
                    function(*arguments)
        for t in (1, [1]):
            with self.assertRaisesRegex(TypeError, "^o: State where a Orbit"):
                rc.orbit_at(s, t)

    def test_other_numbers_are_read_but_not_moved(self):
        p, _ = quarter()
        table = random_table(8)
        for name in rc.State._fields_:
            table[name[0]] = numpy.float32(table[name[0]])
        numbers = table.view(numpy.float64).reshape(8, 8)
        coins = [rc.State.from_buffer_copy(row) for row in table]
        want = rc.energy(table, p)
        for other, word in ((numbers.astype(numpy.float32), "astype"),
                            (numbers.astype(">f8"), "astype"),
                            (numbers.tolist(), "stack"), (coins, "stack"),
                            (tuple(coins), "stack"), (list(table), "stack")):
            self.assertTrue(same(rc.energy(other, p), want))
            with self.assertRaisesRegex(TypeError, word):
                rc.run_batch(other, p, rc.RK4, 1e-3, 1)
        for function in (rc.quaternion, rc.axes, rc.angular_velocity):
            for other in (coins, numbers.tolist(), numbers.astype(">f8"),
                          numbers.astype(numpy.float32)):
                self.assertTrue(same(function(other), function(table)))
            whole = numpy.arange(16).reshape(2, 8) // 8
            self.assertTrue(same(function(whole), function(whole * 1.0)))
        table[3, ...] = coins[5]
        self.assertEqual(table[3], table[5])

    def test_what_moves_needs_memory_of_its_own(self):
        p, s = quarter()
        table = random_table(8)
        before = table.copy()
        fixed = table.copy()
        fixed.flags.writeable = False
        for bad in (table[::2], fixed, bytes(64),
                    numpy.zeros((8, 16))[:, ::2]):
            with self.assertRaises((TypeError, ValueError)):
                rc.run_batch(bad, p, rc.RK4, 1e-3, 1)
            with self.assertRaises((TypeError, ValueError)):
                rc.sample(s, p, rc.RK4, 1e-3, 1, bad)
        with self.assertRaises(ValueError):
            rc.run(fixed[3], p, rc.RK4, 1e-3, 1)
        self.assertTrue(same(table, before))

    def test_a_row_is_moved_where_it_is(self):
        p, _ = quarter()
        table = random_table(3)
        alone = rc.State.from_buffer_copy(table[1])
        rc.run(table[1], p, rc.RK8, 1e-3, 10)
        rc.run(alone, p, rc.RK8, 1e-3, 10)
        self.assertEqual(table[1].tobytes(), bytes(alone))

    def test_rows_and_tables_of_any_making(self):
        p, _ = quarter()
        table = random_table(6)
        want = rc.energy(table, p)
        records = table.view(numpy.recarray)
        self.assertTrue(same(rc.energy(records, p), want))
        self.assertEqual(rc.energy(records[2], p), want[2])
        rc.step(table[::2][1], p, 1e-3)
        self.assertNotEqual(table["psi"][2], random_table(6)["psi"][2])
        self.assertTrue(same(table[[0, 1, 3]], random_table(6)[[0, 1, 3]]))
        odd = numpy.frombuffer(bytearray(1 + table.nbytes), rc.State, offset=1)
        odd[:] = random_table(6)
        self.assertTrue(same(rc.energy(odd, p), want))
        with self.assertRaises(ValueError):
            rc.step(odd[0], p, 1e-3)
        alone = table[0].copy()
        rc.step(alone, p, 1e-3)
        self.assertNotEqual(alone, table[0])
        with self.assertRaises(ValueError):
            rc.run_batch(odd, p, rc.RK4, 1e-3, 1)
        grid = numpy.asfortranarray(random_table(6).reshape(2, 3))
        self.assertTrue(same(rc.energy(grid, p), want))
        self.assertEqual(rc.energy(random_table(1).reshape(()), p).shape, ())

    def test_the_first_row_that_fails_is_named_or_all_in_status(self):
        p, _ = quarter()
        table = random_table(200)
        table["theta"][[70, 150]] = 2
        status = numpy.zeros(200, numpy.int32)
        for name in ("energy", "reaction", "center"):
            with self.assertRaises(rc.Error) as caught:
                getattr(rc, name)(table, p)
            self.assertEqual((caught.exception.status, caught.exception.index),
                             (rc.ESTATE, 70))
            self.assertRegex(str(caught.exception),
                             "^row 70: .*: theta of State")
            found = getattr(rc, name)(table, p, status=status)
            self.assertEqual(list(numpy.nonzero(status)[0]), [70, 150])
            numbers = found.view(numpy.float64).reshape(200, -1)
            self.assertEqual(list(numpy.nonzero(
                numpy.isnan(numbers).any(axis=1))[0]), [70, 150])
        with self.assertRaises(rc.Error) as caught:
            rc.energy(table, rc.Params())
        self.assertEqual((caught.exception.status, caught.exception.index),
                         (rc.EPARAMS, None))
        for bad in (numpy.zeros(199, numpy.int32), numpy.zeros(200), [0] * 200,
                    numpy.zeros(400, numpy.int32)[::2]):
            with self.assertRaises(TypeError):
                rc.energy(table, p, status=bad)
        status[:] = 1
        rc.state_check(table, p, status=status)
        self.assertEqual(list(numpy.nonzero(status)[0]), [70, 150])

    def test_a_table_advances_and_settles_row_by_row(self):
        p, _ = quarter()
        table = random_table(40)
        alone = table.copy()
        reached = rc.advance(table, p, 0.1, 1e-9)
        for k in range(40):
            self.assertEqual(rc.advance(alone[k], p, 0.1, 1e-9), reached[k])
        self.assertTrue(same(table, alone))
        losses = rc.Losses(dry=1e-6)
        said = rc.settle(table, p, losses, 0.5, 1e-6)
        for k in range(40):
            self.assertEqual(rc.settle(alone[k], p, losses, 0.5, 1e-6),
                             (said.status[k], said.reached[k]))
        self.assertTrue(same(table, alone))
        table = random_table(40)
        table["theta"][3] = 2
        with self.assertRaises(rc.Error) as caught:
            rc.advance(table, p, 0.1)
        self.assertEqual(caught.exception.index, 3)
        status = numpy.zeros(40, numpy.int32)
        rc.advance(table, p, 0.1, status=status)
        self.assertEqual(list(numpy.nonzero(status)[0]), [3])

    def test_a_row_that_fails_tells_how_far_it_came(self):
        """One falls flat, one leaves the range of psi, one is no state, and
        one rolls on."""
        ends = [rc.EFLAT, rc.ERANGE, rc.ESTATE, rc.OK]
        rests = [rc.RESTS, rc.ERANGE, rc.ESTATE, rc.OK]
        p = quarter()[0]
        for call, rest, statuses in (
                (rc.advance, (0.2,), ends),
                (rc.settle, (rc.Losses(dry=1e-9), 0.2), rests)):
            table = numpy.zeros(4, rc.State)
            table["theta"] = [0.3, 0.1, 2, 0.3]
            table["wZ"] = [0, 40, 0, 40]
            table["psi"][1] = 2.0**31 - 4
            alone, raising = table.copy(), table.copy()
            status = numpy.zeros(4, numpy.int32)
            said = call(table, p, *rest, status=status)
            reached = said if call is rc.advance else said.reached
            self.assertEqual(list(status), statuses)
            whole = reached.dtype.type(0.2)
            for time, end in zip(reached, statuses):
                self.assertEqual(time == whole, end == rc.OK)
                self.assertEqual(time == 0, end == rc.ESTATE)
            for k in numpy.flatnonzero(status < 0):
                with self.assertRaises(rc.Error) as caught:
                    call(alone[k], p, *rest)
                self.assertEqual(caught.exception.done, reached[k])
            with self.assertRaises(rc.Error) as caught:
                call(raising, p, *rest)
            first = int(numpy.argmax(status < 0))
            self.assertEqual((caught.exception.index, caught.exception.done),
                             (first, reached[first]))
            self.assertEqual(raising.tobytes(), table.tobytes())


class Buffers(unittest.TestCase):
    def test_a_trajectory_is_written_in_place(self):
        p, s = quarter()
        path = numpy.zeros(11, rc.State)
        self.assertIs(rc.sample(s, p, rc.RK8, 1e-2, 10, path), path)
        for k in range(11):
            p, s = quarter()
            rc.run(s, p, rc.RK8, 1e-2, 10 * k)
            self.assertEqual(path[k].tobytes(), bytes(s))
        table = numpy.zeros((11, 8))
        rc.sample(quarter()[1], p, rc.RK8, 1e-2, 10, table)
        self.assertEqual(table.tobytes(), path.tobytes())
        self.assertEqual(rc.sample(s, p, rc.RK4, 1e-3, 1, 5).dtype,
                         numpy.dtype(rc.State))
        sys.modules["numpy"] = None  # as if it were not installed
        try:
            self.assertEqual(len(rc.sample(s, p, rc.RK4, 1e-3, 1, 5)), 5)
        finally:
            sys.modules["numpy"] = numpy
        self.assertEqual(len(rc.sample(s, p, rc.RK4, 1e-3, 1, 0)), 0)
        self.assertEqual(rc.energy(path[3], p), rc.energy(path, p)[3])

    def test_the_launches_are_runs(self):
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            made = runpy.run_path(PYTHON / "launches.py")
        self.assertEqual(len(printed.getvalue().splitlines()), 13)
        for k, lean in enumerate(made["leans"]):
            s = rc.State(theta=lean, wZ=40)
            for frame in made["frames"]:
                self.assertEqual(frame[k].tobytes(), bytes(s))
                rc.run(s, made["quarter"], rc.RK8, 1 / 960, 8)

    def test_the_picture_is_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            drawn = pathlib.Path(folder) / "python.svg"
            argv, sys.argv = sys.argv, ["picture.py", str(drawn)]
            try:
                made = runpy.run_path(PYTHON / "picture.py")
            finally:
                sys.argv = argv
            self.assertIn("F/N", drawn.read_text())
            self.assertLess(drawn.stat().st_size, 40000)
        usage = subprocess.run([sys.executable, PYTHON / "picture.py"],
                               capture_output=True, text=True)
        self.assertEqual(usage.returncode, 1)
        self.assertRegex(usage.stderr, "^usage: .*\n$")
        p, s = made["quarter"], rc.State.from_buffer_copy(made["path"][-1])
        self.assertEqual(made["ratio"][-1], rc.reaction(s, p).ratio)
        self.assertTrue(same(made["contact"][-1],
                             1e3 * numpy.array(rc.contact(s, p)[0])))

    def test_a_batch_tells_of_each_coin_and_raises_if_it_touched_none(self):
        p, s = quarter()
        coins = numpy.zeros((3, 8))
        coins[:] = numpy.frombuffer(s)
        coins[1, 0] = 2
        self.assertEqual(list(rc.run_batch(coins, p, rc.RK4, 1e-3, 9)),
                         [0, rc.ESTATE, 0])
        self.assertEqual(list(rc.run_batch(coins, p, rc.RK4, 1e-2, 1)),
                         [rc.COARSE, rc.ESTATE, rc.COARSE])
        before = coins.tobytes()
        for bad, method in ((p, 99), (rc.Params(), rc.RK4)):
            self.assertRaises(rc.Error, rc.run_batch, coins, bad, method,
                              1e-3, 9)
        self.assertEqual(coins.tobytes(), before)
        self.assertEqual(rc.run_batch(coins[:0], p, rc.RK4, 1e-3, 1).shape,
                         (0,))

    def test_any_writable_buffer_will_do_and_no_other(self):
        numbers = array.array("d", [0.1] * 16)
        seen = rc.states(numbers)
        seen[1].wZ = 7
        self.assertEqual((len(seen), numbers[15]), (2, 7))
        with mmap.mmap(-1, 128) as mapped:
            mapped[:] = bytes(numbers)
            self.assertEqual(rc.energy(mapped, quarter()[0]).shape, (2,))
        self.assertRaises(TypeError, rc.states, bytes(64))


class LongRuns(unittest.TestCase):
    """Cut into parts, in the same places on every machine."""

    def setUp(self):
        self.whole = rc._move.SLICE
        rc._move.SLICE = 64

    def tearDown(self):
        rc._move.SLICE = self.whole

    def cut(self, s, p, method, steps):
        while steps:
            rc.lib.coin_run(s, p, method, 1e-3, min(64, steps), None)
            steps -= min(64, steps)
        return s

    def status(self, s, p, method, steps):
        try:
            return rc.run(s, p, method, 1e-3, steps)
        except rc.Error as error:
            return error.status

    def test_a_run_is_calls_of_slice_steps(self):
        for steps in (0, 1, 64, 65, 200):
            p, s = quarter()
            rc.run(s, p, rc.RK8, 1e-3, steps)
            self.assertEqual(s, self.cut(quarter()[1], p, rc.RK8, steps))

    def test_a_batch_of_any_length_has_the_bits_of_runs(self):
        p, _ = quarter()
        for steps in (1, 10, 64, 200):
            for count in (1, 7, 70):
                table = random_table(count)
                alone = table.copy()
                status = rc.run_batch(table, p, rc.RK4, 1e-3, steps)
                for k in range(count):
                    self.assertEqual(
                        self.status(alone[k], p, rc.RK4, steps), status[k])
                self.assertTrue(same(table, alone))

    def test_samples_are_cut_where_slice_steps_are_full(self):
        p, s = quarter()
        for apart, every in ((0, 64), (1, 64), (10, 6), (64, 1), (200, 1)):
            path = numpy.zeros(150, rc.State)
            rc.sample(s, p, rc.RK8, 1e-4, apart, path)
            self.assertEqual(path[0].tobytes(), bytes(s))
            if apart > 64:
                want = copy.copy(s)
                rc.run(want, p, rc.RK8, 1e-4, apart)
                self.assertEqual(path[1].tobytes(), bytes(want))
                continue
            for k in range(0, 150 - every, every):
                want = rc.State.from_buffer_copy(path[k])
                rc.lib.coin_run(want, p, rc.RK8, 1e-4, apart * every, None)
                self.assertEqual(path[k + every].tobytes(), bytes(want))

    def test_an_error_on_the_way_counts_all_parts(self):
        p = rc.body(1, 1, 1, 0.25, 0.5)
        path = numpy.zeros(1000, rc.State)
        with self.assertRaises(rc.Error) as caught:
            rc.sample(rc.State(theta=0.3), p, rc.RK8, 0.01, 1, path)
        done = int(caught.exception.done)
        self.assertGreater(done, 128)
        self.assertNotEqual(path[done - 1]["theta"], 0)
        self.assertEqual(path[done]["theta"], 0)
        s = rc.State(theta=0.3)
        with self.assertRaises(rc.Error) as caught:
            rc.run(s, p, rc.RK8, 0.01, 1000)
        self.assertGreater(caught.exception.done, 128)
        self.assertEqual(rc.State.from_buffer_copy(path[done - 1]).theta > 1,
                         True)


def heed_interrupts():
    """A shell starts what runs in the background with interrupts ignored."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def processor_seconds(pid):
    """What a process has used, which another load does not change."""
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().split(")")[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Interrupts(unittest.TestCase):
    PROGRAM = """
import numpy, time, rollcoin as rc
p = rc.disc(0.00567, 0.01213, 9.80665)
s = rc.State(theta=0.3, wY=5, wZ=40)
table = numpy.zeros(4000, rc.State)
table[:] = numpy.frombuffer(s, rc.State)
print("begins", flush=True)
try:
    {}
except KeyboardInterrupt:
    moved = s.theta != 0.3 or (table["theta"] != 0.3).any()
    print(int(moved), time.process_time(), flush=True)
"""
    CALLS = ("rc.run(s, p, rc.SYMPLECTIC4, 1e-3, 10**12)",
             "rc.run_batch(table, p, rc.SYMPLECTIC4, 1e-3, 10**9)",
             "rc.run_batch(table, p, rc.RK8, 1e-3, 200000)",
             "rc.advance(table, p, 1000, 1e-13)",
             "rc.advance(table, p, 1000, 1e-13, workers=3)",
             "rc.sample(s, p, rc.RK8, 1e-3, 10**6, table)")

    def test_ctrl_c_stops_a_long_call_within_a_second(self):
        for call in self.CALLS:
            child = subprocess.Popen(
                [sys.executable, "-c", self.PROGRAM.format(call)], text=True,
                stdout=subprocess.PIPE, preexec_fn=heed_interrupts)
            self.assertEqual(child.stdout.readline(), "begins\n")
            begun = processor_seconds(child.pid)
            while processor_seconds(child.pid) < begun + 0.7:
                time.sleep(0.01)
            before = processor_seconds(child.pid)
            child.send_signal(signal.SIGINT)
            try:
                moved, after = child.communicate(timeout=60)[0].split()
            finally:
                child.kill()
            self.assertEqual(moved, "1", call)
            self.assertLess(float(after) - before, 1, call)


if __name__ == "__main__":
    unittest.main()
