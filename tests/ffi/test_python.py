#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Errors become exceptions, outputs results, buffers are used in place.
The library is ROLLCOIN_LIBRARY, the module is on PYTHONPATH."""
import array
import contextlib
import copy
import io
import math
import pathlib
import runpy
import unittest

import numpy
import rollcoin as rc


def quarter():
    return (rc.disc(0.00567, 0.01213, 9.80665),
            rc.State(theta=0.3, wY=5, wZ=40))


class Errors(unittest.TestCase):
    def status(self, function, *arguments):
        with self.assertRaises(rc.Error) as caught:
            function(*arguments)
        text = rc.lib.coin_status_string(caught.exception.status)
        self.assertEqual(str(caught.exception), text.decode())
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

    def test_a_number_that_is_none_is_raised(self):
        p, s = quarter()
        s.theta = 2
        self.assertRaises(ValueError, rc.energy, s, p)
        self.assertEqual(self.status(rc.reaction, s, p), rc.ESTATE)
        self.assertEqual(self.status(rc.center, s, p), rc.ESTATE)

    def test_the_types_of_arguments_are_checked(self):
        p, s = quarter()
        self.assertRaises(Exception, rc.lib.coin_step, p, s, 1e-3)
        self.assertRaises(Exception, rc.lib.coin_step, s, p, "1e-3")


class Results(unittest.TestCase):
    def test_they_are_those_of_the_pointers(self):
        p, s = quarter()
        self.assertEqual(rc.center(s, p)[0], s.x)
        self.assertEqual(rc.center(s, p)[1], p.radius * math.cos(s.theta))
        self.assertEqual(len(rc.velocity(s, p)), 3)
        self.assertEqual(len(rc.integrals(s, p)), 2)
        self.assertAlmostEqual(sum(q * q for q in rc.quaternion(s)), 1, 15)
        self.assertEqual(rc.check(s, p, rc.RK4, 1e-3, 0.01), rc.SLIPS)
        self.assertEqual(rc.run(s, p, rc.RK4, 1e-2, 1), rc.COARSE)
        self.assertEqual(rc.advance(s, p, 0.01), 0.01)

    def test_a_state_shows_its_members_and_copies(self):
        s = rc.State(theta=0.5, wZ=2)
        other = copy.copy(s)
        other.theta = 0.25
        self.assertEqual(s.theta, 0.5)
        self.assertIn("theta=0.5", repr(s))
        self.assertIn("reserved=[0.0, 0.0, 0.0]", repr(rc.Params()))

    def test_every_function_of_the_library_is_declared(self):
        for name in rc.PROTOTYPES:
            self.assertIsNotNone(getattr(rc.lib, name).argtypes)


class Buffers(unittest.TestCase):
    def test_a_trajectory_is_written_in_place(self):
        p, s = quarter()
        path = numpy.zeros(11, rc.State)
        rc.sample(s, p, rc.RK8, 1e-2, 10, path)
        for k in range(11):
            p, s = quarter()
            rc.run(s, p, rc.RK8, 1e-2, 10 * k)
            self.assertEqual(path[k].tobytes(), bytes(s))
        table = numpy.zeros((11, 8))
        rc.sample(quarter()[1], p, rc.RK8, 1e-2, 10, table)
        self.assertEqual(table.tobytes(), path.tobytes())
        self.assertEqual(len(rc.sample(s, p, rc.RK4, 1e-3, 1, 5)), 5)

    def test_the_launches_are_runs(self):
        folder = pathlib.Path(rc.__file__).parent
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            made = runpy.run_path(folder / "launches.py")
        self.assertEqual(len(printed.getvalue().splitlines()), 13)
        for k, lean in enumerate(made["leans"]):
            s = rc.State(theta=lean, wZ=40)
            for frame in made["frames"]:
                self.assertEqual(frame[k].tobytes(), bytes(s))
                rc.run(s, made["quarter"], rc.RK8, 1 / 960, 8)

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

    def test_any_writable_buffer_will_do_and_no_other(self):
        numbers = array.array("d", [0.1] * 16)
        seen = rc.states(numbers)
        seen[1].wZ = 7
        self.assertEqual((len(seen), numbers[15]), (2, 7))
        self.assertRaises(ValueError, rc.states, bytearray(65))
        self.assertRaises(TypeError, rc.states, bytes(64))
        self.assertRaises((TypeError, ValueError, BufferError), rc.states,
                          numpy.zeros((8, 8))[:, ::2])


if __name__ == "__main__":
    unittest.main()
