#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Observables at exact binary64 states, by a formulation of their own.

usage:  make_observables.py [--out DIR]
needs:  python3-mpmath (Debian)

Writes observables.csv, circles.csv, motions.csv and sincos.csv.  Every input
is a binary64 number; every result is computed with 60 digits and rounded to
one, the scale of a test's tolerance to 6 digits.

Nothing here uses the library's equations of motion.  The accelerations and
the reaction come from one linear solve of Newton's and Euler's laws in the
table's frame together with the no-slip condition; the angles' rates from
resolving the angular velocity along the three axes of rotation; frames and
quaternions from products of rotations; stability from the eigenvalue of a
Jacobian by differences.  Only the two linear integrals use a closed form, the
hypergeometric functions that make_reference.py uses.
"""
import argparse
import os
import random

from mpmath import mp, mpf, matrix

from make_reference import phi_matrix

mp.dps = 60
HALF_PI = float(mp.pi / 2)  # the double just below pi/2


# ------------------------------------------------------------ small vectors
def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0]]


def comb(*terms):
    """Sum of factor * vector."""
    return [sum(f * v[i] for f, v in terms) for i in range(3)]


def rotation(axis, angle):
    """The matrix that turns by angle about x, y or z (0, 1, 2)."""
    c, s = mp.cos(angle), mp.sin(angle)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    r = mp.eye(3)
    r[j, j] = r[k, k] = c
    r[k, j], r[j, k] = s, -s
    return r


UP = [mpf(0), mpf(1), mpf(0)]


class Coin:
    """A body at a state: everything follows from rotations and vectors."""

    def __init__(self, params, state):
        self.M, self.a, self.g, self.IX, self.IZ = map(mpf, params)
        th, ph, ps, self.x, self.z, wX, wY, wZ = map(mpf, state)
        self.angles = th, ph, ps
        frame = rotation(1, ph) * rotation(0, th)
        self.e = [[frame[i, k] for i in range(3)] for k in range(3)]
        eX, eY, eZ = self.e
        self.omega = comb((wX, eX), (wY, eY), (wZ, eZ))
        # omega = theta' e_X + phi' up + psi' e_Z
        columns = [eX, UP, eZ]
        A = matrix(3, 3)
        for k, column in enumerate(columns):
            for i in range(3):
                A[i, k] = column[i]
        self.angle_rates = list(mp.lu_solve(A, matrix(self.omega)))
        dth, dph, _ = self.angle_rates
        self.turn = comb((dth, eX), (dph, UP))     # of the coin's frame
        self.arm = comb((-self.a, eY))             # centre to contact
        self.v = comb((-1, cross(self.omega, self.arm)))
        self.solve()

    def solve(self):
        """Newton, Euler and no slip: 3 accelerations, 3 forces."""
        eZ, om, IX, dI = self.e[2], self.omega, self.IX, self.IZ - self.IX
        deZ = cross(om, eZ)
        A, rhs = matrix(6, 6), matrix(6, 1)
        darm = cross(self.turn, self.arm)
        gyro = comb((dI * dot(om, eZ), deZ))
        centripetal = comb((-1, cross(om, darm)))
        for k in range(6):
            unit = [mpf(i == k % 3) for i in range(3)]
            if k < 3:                              # angular acceleration
                force = comb((-self.M, cross(unit, self.arm)))
                torque = comb((IX, unit), (dI * dot(unit, eZ), eZ))
            else:                                  # reaction
                force = comb((-1, unit))
                torque = comb((-1, cross(self.arm, unit)))
            for i in range(3):
                A[i, k], A[3 + i, k] = force[i], torque[i]
        for i in range(3):
            rhs[i] = -self.M * self.g * UP[i] - self.M * centripetal[i]
            rhs[3 + i] = -gyro[i]
        u = mp.lu_solve(A, rhs)
        self.alpha, self.R = list(u[:3]), list(u[3:])

    def spin_rates(self):
        """d/dt of omega's components along the moving axes."""
        return [dot(self.alpha, e) + dot(self.omega, cross(self.turn, e))
                for e in self.e]

    def energy(self):
        eZ = self.e[2]
        L = comb((self.IX, self.omega),
                 ((self.IZ - self.IX) * dot(self.omega, eZ), eZ))
        height = self.a * mp.cos(self.angles[0])
        return (self.M * dot(self.v, self.v) / 2 + dot(self.omega, L) / 2 +
                self.M * self.g * height)

    def integrals(self):
        m = self.M * self.a ** 2
        k1, k2 = self.IZ / self.IX, m / (self.IZ + m)
        u, p = mp.sin(self.angles[0]), dot(self.omega, self.e[1])
        wZ = dot(self.omega, self.e[2])
        p *= mp.cos(self.angles[0])
        Pe, Po, We, Wo = phi_matrix(k1 * k2, u)
        assert abs(Pe * We - k1 * k2 * Po * Wo - 1) < mpf('1e-25')
        return We * p - k1 * Po * wZ, Pe * wZ - k2 * Wo * p

    def quaternion(self):
        th, ph, ps = self.angles
        q = [mpf(1), mpf(0), mpf(0), mpf(0)]
        for axis, angle in ((1, ph), (0, th), (2, ps)):
            h = [mp.cos(angle / 2), mpf(0), mpf(0), mpf(0)]
            h[1 + axis] = mp.sin(angle / 2)
            v = comb((q[0], h[1:]), (h[0], q[1:]), (1, cross(q[1:], h[1:])))
            q = [q[0] * h[0] - dot(q[1:], h[1:])] + v
        return q

    def fastest_rate(self):
        """From the height of the centre, and the turn along and across the
        axis of the coin."""
        height = -self.arm[1]
        along = dot(self.omega, self.e[2])
        across = cross(self.omega, self.e[2])
        return mp.sqrt(dot(across, across) * (self.a / height) ** 2 +
                       along ** 2 + self.g / height)

    def contact(self):
        r = comb((1, [self.x, mpf(0), self.z]), (1, self.arm))
        v = comb((1, self.v), (1, cross(self.turn, self.arm)))
        return r, v


# ------------------------------------------------------------------ writing
def number(v):
    return '0' if v == 0 else repr(float(v))


def rough(v):
    return float(mp.nstr(v, 6))


def write(path, comment, columns, rows):
    with open(path, 'w') as f:
        f.write('# ' + comment + '\n' + ','.join(columns) + '\n')
        for row in rows:
            assert len(row) == len(columns)
            f.write(','.join(number(v) for v in row) + '\n')


# -------------------------------------------------------------- observables
def disc(M, a, g):
    return M, a, g, M * a * a / 4, M * a * a / 2


BODIES = [disc(1.0, 1.0, 1.0),
          (1.0, 1.0, 1.0, 0.4525, 0.905),           # ring, b = 0.9
          (1.0, 1.0, 1.0, 0.5, 1.0),                # hoop
          disc(0.00567, 0.01213, 9.80665),          # US quarter
          (2.5, 0.75, 3.7, 0.9, 0.013),             # nearly a needle
          (3.0e5, 40.0, 1.62, 1.7e8, 3.3e8)]        # a wheel on the Moon


def states(rng, natural_time):
    """Generic, far turned, upright, tiny, resting, fast and near flat."""
    def rate(size=2.0):
        return rng.uniform(-size, size) / natural_time

    def pose(turns=3.0):
        return [rng.uniform(-turns, turns) for _ in range(4)]
    yield [rng.uniform(-1.4, 1.4)] + pose() + [rate(), rate(), rate()]
    yield [rng.uniform(-1.4, 1.4)] + pose(1e6) + [rate(), rate(), rate()]
    yield [0.0] + pose() + [rate(), rate(), rate()]
    yield [rng.choice((-1, 1)) * 1e-9] + pose() + [rate(), rate(), rate()]
    yield [rng.uniform(-1.4, 1.4), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    yield [rng.uniform(-1.4, 1.4)] + pose() + [rate(300), rate(300), rate(300)]
    for digits in (2, 5, 10):
        gap = 10 ** -(digits + rng.random())
        th = rng.choice((-1, 1)) * (HALF_PI - gap)
        faster = rng.choice((gap, min(1 / gap, 3e5)))
        yield [th] + pose() + [rate(), rate() * faster, rate()]


PARAMS = 'mass radius gravity inertia_X inertia_Z'.split()
STATE = 'theta phi psi x z wX wY wZ'.split()
RESULT = (['d' + s for s in STATE] + 'E KY KZ Rx Ry Rz F y vx vy vz'.split() +
          'xc zc vxc vzc'.split() + ['e%s%s' % (u, v) for u in 'XYZ'
                                     for v in 'xyz'] +
          'q0 q1 q2 q3 ox oy oz W'.split())


def observables(params, state):
    c = Coin(params, state)
    dth, dph, dps = c.angle_rates
    r, v = c.contact()
    assert abs(r[1] + c.a * mp.cos(c.angles[0])) < mpf('1e-50') * c.a
    return (list(params) + list(state) +
            [dth, dph, dps, c.v[0], c.v[2]] + c.spin_rates() +
            [c.energy()] + list(c.integrals()) + c.R +
            [mp.hypot(c.R[0], c.R[2]), c.a * mp.cos(c.angles[0])] + c.v +
            [r[0], r[2], v[0], v[2]] + sum(c.e, []) + c.quaternion() + c.omega +
            [c.fastest_rate()])


# ------------------------------------------------------------ steady circles
def lean_rates(params, lean):
    th, wX, wY, wZ = lean
    c = Coin(params, [th, 0, 0, 0, 0, wX, wY, wZ])
    return [c.angle_rates[0]] + c.spin_rates()


def jacobian_lambda2(params, lean):
    """The double root 0 aside, lambda^2 = trace(A^2)/2."""
    h = mpf('1e-20')
    A = matrix(4, 4)
    for k in range(4):
        up, down = list(lean), list(lean)
        up[k] += h
        down[k] -= h
        for i, (a, b) in enumerate(zip(lean_rates(params, up),
                                       lean_rates(params, down))):
            A[i, k] = (a - b) / (2 * h)
    B = A * A
    return sum(B[i, i] for i in range(4)) / 2


def closed_lambda2(params, lean):
    """The linearised equations' closed form, and its terms' size."""
    M, a, g, IX, IZ = map(mpf, params)
    th, _, wY, wZ = map(mpf, lean)
    m, T = M * a * a, mp.tan(th)
    terms = [M * g * a * mp.cos(th), -(IX * (1 + 3 * T * T) + m) * wY ** 2,
             -(3 * IZ + m) * T * wY * wZ, -((IZ + m) * IZ / IX) * wZ ** 2]
    return sum(terms) / (IX + m), sum(map(abs, terms)) / (IX + m)


def steady_wY(params, th, wZ, branch):
    """Newton on the angular acceleration about e_X."""
    M, a, g, IX, IZ = map(mpf, params)
    T, K = mp.tan(th), IZ + M * a * a
    root = mp.sqrt((K * wZ) ** 2 + 4 * IX * M * g * a * mp.sin(th) * T)
    wY = (-K * wZ + branch * root) / (2 * IX * T)
    f = lambda w: lean_rates(params, [mpf(th), mpf(0), w, mpf(wZ)])[1]
    scale = abs(wY)
    h = scale * mpf('1e-20')
    step = f(wY) * 2 * h / (f(wY + h) - f(wY - h))
    assert abs(step) < scale * mpf('1e-35')
    return wY


def circle(params, th, wZ, branch):
    th, wZ = mpf(th), mpf(wZ)
    wY = steady_wY(params, th, wZ, branch)
    exact = [th, mpf(0), wY, wZ]
    L, _ = closed_lambda2(params, exact)
    size = abs(L) + mpf(params[2]) / mpf(params[1])
    assert abs(jacobian_lambda2(params, exact) - L) < size * mpf('1e-15')
    rounded = float(wY)
    lambda2, terms = closed_lambda2(params, [th, 0, rounded, wZ])
    coin = Coin(params, [th, 0, 0, 0, 0, 0, rounded, wZ])
    dphi, v, vc = coin.angle_rates[1], coin.v, coin.contact()[1]
    return [wY, rounded, lambda2, rough(terms),
            mp.hypot(v[0], v[2]) / abs(dphi), mp.hypot(vc[0], vc[2]) /
            abs(dphi)]


CIRCLE = (PARAMS + ['theta', 'wZ', 'branch', 'wY', 'wY_double', 'lambda2',
                    'lambda2_terms', 'R_G', 'R_C'])


def circles(rng):
    for params in BODIES:
        natural = (params[1] / params[2]) ** 0.5
        for k in range(6):
            th = rng.choice((-1, 1)) * 10 ** rng.uniform(-3, 0.15)
            wZ = rng.choice((-1, 1)) * 10 ** rng.uniform(-2, 0.7) / natural
            branch = 1 - 2 * (k % 2)
            yield (list(params) + [th, wZ, float(branch)] +
                   circle(params, th, wZ, branch))


# ------------------------------------------------------------------ motions
MOTION = ('w qx qy qz ox oy oz theta phi psi wX wY wZ '
          'theta_q phi_q psi_q wX_q wY_q wZ_q').split()


def from_motion(q, omega):
    """Angles out of the rotation matrix of q, omega along its frame."""
    w, v = q[0], q[1:]
    n = sum(c * c for c in q)

    def turn(r):                                  # q r q*/|q|^2
        return comb(((w * w - dot(v, v)) / n, r), (2 * dot(v, r) / n, v),
                    (2 * w / n, cross(v, r)))
    X, Z = turn([1, 0, 0]), turn([0, 0, 1])
    eX = cross(UP, Z)
    c = mp.sqrt(dot(eX, eX))
    eX = [e / c for e in eX]
    eY = cross(Z, eX)
    theta, phi = mp.atan2(-Z[1], c), mp.atan2(Z[0], Z[2])
    psi = mp.atan2(dot(X, eY), dot(X, eX))
    return [theta, phi, psi] + [dot(omega, e) for e in (eX, eY, Z)]


def sensitivity(q, omega):
    """Per result, the sum over q of |d result/d q_i| |q_i|."""
    base, total = from_motion(q, omega), [mpf(0)] * 6
    for i in range(4):
        h = mpf('1e-25')
        moved = list(q)
        moved[i] += h * abs(q[i])
        for k, v in enumerate(from_motion(moved, omega)):
            total[k] += mp.fmod(abs(v - base[k]), 2 * mp.pi) / h
    return map(rough, total)


def motions(rng):
    for k in range(24):
        q = [rng.gauss(0, 1) for _ in range(4)]
        size = 1.0 if k % 3 == 0 else 10.0 ** rng.uniform(-3, 3)
        n = sum(c * c for c in q) ** 0.5
        q = [c / n * size for c in q]
        omega = [rng.uniform(-2, 2) for _ in range(3)]
        Q, O = [mpf(c) for c in q], [mpf(c) for c in omega]
        yield [*q, *omega, *from_motion(Q, O), *sensitivity(Q, O)]


# ------------------------------------------------------------- sine, cosine
def angles(rng):
    yield 0.0
    for k in range(12):
        yield rng.uniform(-0.785, 0.785)
    for k in range(24):
        yield rng.choice((-1, 1)) * 2 ** rng.uniform(-1, 20)
    for k in range(12):
        yield rng.choice((-1, 1)) * 2 ** rng.uniform(20, 31)
    for bits in range(1, 31):                     # near multiples of pi/2
        n = rng.randrange(2 ** (bits - 1), 2 ** bits)
        yield float(n * mp.pi / 2)
    yield HALF_PI
    yield -HALF_PI
    yield 5e-324
    yield 1e-160
    yield 2.0 ** 31


def split(v):
    """The nearest double, and the rest."""
    return [float(v), v - mpf(float(v))]


def main():
    ap = argparse.ArgumentParser()
    ap.add_argument('--out', default=os.path.dirname(os.path.abspath(__file__)))
    out = ap.parse_args().out
    rng = random.Random(20260101)
    exact = 'inputs are exact binary64 numbers; see make_observables.py'
    rows = [observables(b, s) for b in BODIES
            for s in states(rng, (b[1] / b[2]) ** 0.5)]
    write(os.path.join(out, 'observables.csv'), exact,
          PARAMS + STATE + RESULT, rows)
    write(os.path.join(out, 'circles.csv'), exact, CIRCLE, circles(rng))
    write(os.path.join(out, 'motions.csv'), exact, MOTION, motions(rng))
    write(os.path.join(out, 'sincos.csv'), exact + '; sin + sin_low is exact',
          ['x', 'sin', 'sin_low', 'cos', 'cos_low'],
          ([x] + split(mp.sin(mpf(x))) + split(mp.cos(mpf(x)))
           for x in angles(rng)))


if __name__ == '__main__':
    main()
