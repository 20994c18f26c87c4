#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Derives the equations of motion of physics.md again and asserts each.

usage:  python3 docs/proofs/derivation.py     Eq. (1)-(32), (90);
                                              needs sympy >= 1.9
then:   docs/proofs/consequences.py           Eq. (33)-(54), after this one

The start is Newton-Euler and the no-slip condition in the table's frame; the
equations of motion are what solves them, and the solution is unique.  `holds`
decides an identity exactly: sines and cosines become rational functions of
the half-angle tangent, and the numerator must expand to 0.  A failure raises
AssertionError with the number of the equation.
"""
import sympy as sp
from sympy import cos, diff, sin, tan

th, ph, ps, x, z, wX, wY, wZ, dX, dY, dZ = sp.symbols(
    'th ph ps x z wX wY wZ dX dY dZ')
M, a, g, IX, IZ = sp.symbols('M a g IX IZ', positive=True)
m = M*a*a
J, K, k1, k2 = IX + m, IZ + m, IZ/IX, m/(IZ + m)
s, c, T = sin(th), cos(th), tan(th)
count = {}


def holds(number, *claims):
    """Asserts that every claim, an expression or a matrix, is 0."""
    for e in (e for claim in claims for e in sp.Matrix([claim])):
        for angle in (th, ph, ps):
            t = sp.Symbol('t_' + angle.name)
            e = sp.sympify(e).subs({
                tan(angle): 2*t/(1 - t*t), sin(angle): 2*t/(1 + t*t),
                cos(angle): (1 - t*t)/(1 + t*t)})
        assert sp.numer(sp.together(e)).expand() == 0, number
        count[number] = count.get(number, 0) + 1


def column(*entries):
    return sp.Matrix(entries)


def turn(axis, t):
    """The rotation by t about the axis 0, 1 or 2."""
    i, j = {0: (1, 2), 1: (2, 0), 2: (0, 1)}[axis]
    R = sp.eye(3)
    R[i, i] = R[j, j] = cos(t)
    R[j, i], R[i, j] = sin(t), -sin(t)
    return R


def spin(R):
    """The angular velocity of a rotation R(t), along the table's axes."""
    W = D(R)*R.T
    return column(W[2, 1], W[0, 2], W[1, 0])


def D(e):
    """The time derivative of an expression in the state."""
    return sum((diff(e, v)*r for v, r in rate.items()), 0*e)


# ---- frames, (6)-(9) and (17)-(19).  The rates of the angles are unknown yet.
rate = dict(zip((th, ph, ps), sp.symbols('dth dph dps')))
frame = turn(1, ph)*turn(0, th)                 # columns e_X, e_Y, e_Z
eX, eY, eZ = (frame.col(i) for i in range(3))
ey = column(0, 1, 0)
holds(6, ey.cross(eZ) - c*eX, eZ.cross(eX) - eY)
holds(7, frame.T - sp.Matrix([[cos(ph), 0, -sin(ph)],
                              [s*sin(ph), c, s*cos(ph)],
                              [c*sin(ph), -s, c*cos(ph)]]))
W = frame.T*spin(frame)                         # of the frame, along X, Y, Z
w = frame.T*spin(frame*turn(2, ps))             # of the body
holds(8, W - column(rate[th], rate[ph]*c, -rate[ph]*s))
holds(9, w - W - column(0, 0, rate[ps]))
known = {rate[th]: wX, rate[ph]: wY/c, rate[ps]: wZ + wY*T}
holds('17-19', w.subs(known) - column(wX, wY, wZ))
W = column(wX, wY, -wY*T)
holds(8, frame.T*spin(frame).subs(known) - W)
rate = {angle: known[r] for angle, r in rate.items()}
rate.update({wX: dX, wY: dY, wZ: dZ})

# ---- Newton-Euler and no slip in the table's frame, (1)-(5), (14)-(16)
omega = frame*column(wX, wY, wZ)
L = frame*column(IX*wX, IX*wY, IZ*wZ)           # (4)
v = a*omega.cross(eY)                           # (3)
R = M*D(v) + M*g*ey                             # (1)
euler = frame.T*(D(L) + a*eY.cross(R))          # (2), (5)
eq14 = (-K*wY*wZ - IX*wY**2*T + M*g*a*s)/J
eq15 = (IX*wX*wY*T + IZ*wZ*wX)/IX
eq16 = m*wX*wY/K
holds('14-16', euler.subs({dX: eq14, dY: eq15, dZ: eq16}))
holds('14-16', euler.jacobian([dX, dY, dZ]).det() - IX*J*K)     # unique

# ---- the same in the coin's frame, as the text does it, (10)-(13)
w, dw, up = column(wX, wY, wZ), column(dX, dY, dZ), column(0, c, -s)
Y, Lc = column(0, 1, 0), column(IX*wX, IX*wY, IZ*wZ)
holds(10, frame.T*D(L) - column(IX*dX, IX*dY, IZ*dZ) - W.cross(Lc))
accel = a*(dw.cross(Y) + W.cross(w.cross(Y)))
holds(11, frame.T*D(v) - accel,
      accel - a*column(-dZ + wX*wY, -wX**2 + wY*wZ*T, dX + wY*wZ))
left = column(IX*dX, IX*dY, IZ*dZ) + m*(dw - Y*dY)
right = -W.cross(Lc) + m*wY*w.cross(Y) - M*g*a*Y.cross(up)
holds(12, euler - left + right)
holds(13, right - column(J*eq14, IX*eq15, K*eq16))
printed = right - 2*m*wY*w.cross(Y)             # with the source's wrong sign
holds('errata', printed - right - column(2*m*wY*wZ, 0, -2*m*wX*wY))
rate.update({wX: eq14, wY: eq15, wZ: eq16, x: v[0], z: v[2]})

# ---- what follows at a given state, (20)-(28), (30)
holds(20, D(a*c) - v[1], v - a*column(-wZ*cos(ph) + wX*c*sin(ph), -wX*s,
                                      wZ*sin(ph) + wX*c*cos(ph)))
contact = column(x, a*c, z) - a*eY
holds(21, contact - column(x - a*s*sin(ph), 0, z - a*s*cos(ph)))
holds(22, D(contact) + a*rate[ps]*eX)
E = (m*(wX**2 + wZ**2) + IX*(wX**2 + wY**2) + IZ*wZ**2)/2 + M*g*a*c
holds(23, E - (M*v.dot(v) + L.dot(omega))/2 - M*g*a*c, D(E))
R = M*D(v) + M*g*ey
eh = column(sin(ph), 0, cos(ph))
RX = M*a*wX*wY*IZ/K
Rh = -M*a*(wX**2*s - eq14*c - wY*wZ/c)
holds('25-27', R.dot(eX) - RX, R.dot(eh) - Rh,
      R[1] - M*g + M*a*(wX**2*c + eq14*s))
holds(24, frame.T*R - M*g*up - M*a*column(
    -(eq16 - wX*wY), -(wX**2 - wY*wZ*T), eq14 + wY*wZ))
holds(28, R[0] - RX*cos(ph) - Rh*sin(ph), R[2] + RX*sin(ph) - Rh*cos(ph),
      R[0]**2 + R[2]**2 - RX**2 - Rh**2)
rho, b = sp.symbols('rho b', positive=True)
disc_to = sp.integrate(rho**2*rho, rho)*2       # I_Z of unit density, over pi
ring = disc_to.subs(rho, a) - disc_to.subs(rho, b)
holds(29, M*ring/(a**2 - b**2) - M*(a**2 + b**2)/2)
(C1, S1), (C2, S2), (C3, S3) = ((cos(t), sin(t)) for t in (ph, th, ps))
quaternion = sp.Quaternion(                     # of the doubled angles
    C1*C2*C3 + S1*S2*S3, C1*S2*C3 + S1*C2*S3,
    S1*C2*C3 - C1*S2*S3, C1*C2*S3 - S1*S2*C3)
twice = [turn(i, 2*t).applyfunc(sp.expand_trig)
         for i, t in ((1, ph), (0, th), (2, ps))]
holds(30, sp.Matrix(quaternion.to_rotation_matrix())
      - twice[0]*twice[1]*twice[2])
rolled = frame*turn(2, ps)
holds(90, rolled.col(0) - cos(ps)*eX - sin(ps)*eY,
      rolled.col(1) - cos(ps)*eY + sin(ps)*eX, rolled.col(2) - eZ)

# ---- the forms without sines and cosines to call, (31), (32)
C, S, r = cos(ph), sin(ph), wY/c
holds(31, D(s) - c*wX, D(c) + s*wX, D(1/c) - s*wX/c**2, D(S) - r*C,
      D(C) + r*S, D(ps) - wZ - r*s,
      J*eq14 - M*g*a*s + wY*(K*wZ + IX*r*s), eq15 - wX*(r*s + k1*wZ))
holds(32, c*J*eq14 - s*(M*g*a*c - IX*wY**2) + K*wY*wZ*c,
      c*eq15 - wX*(wY*s + k1*wZ*c), c*D(ps) - wZ*c - wY*s, c*D(S) - wY*C,
      c*D(contact[0]) + a*C*(c*wZ + wY*s),
      c*D(contact[2]) - a*S*(c*wZ + wY*s))
print('%d identities hold: %s' % (
    sum(count.values()), ' '.join(str(n) for n in count)))
