#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Asserts what physics.md says of a coin that slips, from Newton and Euler in
the table's frame.

usage:  python3 docs/proofs/slip.py     Eq. (77)-(82), (85), (86), (88), (96)
"""
import sympy as sp
from sympy import Matrix, cos, diff, simplify, sin, sqrt, tan

t = sp.symbols('t')
M, a, g, IX, IZ, mu, b, k = sp.symbols('M a g I_X I_Z mu b k', positive=True)
N, FX, Fh, tY, tZ = sp.symbols('N F_X F_h tau_Y tau_Z')
th, ph, wY, wZ, vX, vh = (sp.Function(n)(t) for n in
                          ('theta', 'phi', 'wY', 'wZ', 'vX', 'vh'))
s, c, T = sin(th), cos(th), tan(th)
wX = diff(th, t)
checked = []


def holds(number, *residuals):
    """Each residual is 0, identically."""
    for residual in residuals:
        assert simplify(residual) == 0, (number, simplify(residual))
    checked.append(number)


# The coin's frame in the table's, Eq. (7), and e_h.
eX = Matrix([cos(ph), 0, -sin(ph)])
eY = Matrix([s*sin(ph), c, s*cos(ph)])
eZ = Matrix([c*sin(ph), -s, c*cos(ph)])
ey, eh = Matrix([0, 1, 0]), Matrix([sin(ph), 0, cos(ph)])
omega = wX*eX + wY*eY + wZ*eZ
v = vX*eX + vh*eh + diff(a*c, t)*ey
turn = {diff(ph, t): wY/c}                      # (18)

u = (v + omega.cross(-a*eY)).subs(turn)
holds(77, u.dot(eX) - (vX + a*wZ), u.dot(eh) - (vh - a*c*wX), u[1])

# Newton and Euler, with any force at the contact and the torques of losses.
force = N*ey + FX*eX + Fh*eh
L = IX*wX*eX + IX*wY*eY + IZ*wZ*eZ
euler = diff(L, t) - (-a*eY).cross(force) - tY*eY - tZ*eZ
newton = M*diff(v, t) - force + M*g*ey
rates = {diff(th, t, 2): sp.Symbol('dwX'), diff(wY, t): sp.Symbol('dwY'),
         diff(wZ, t): sp.Symbol('dwZ'), diff(vX, t): sp.Symbol('dvX'),
         diff(vh, t): sp.Symbol('dvh')}
at = sp.symbols('theta phi wX wY wZ vX vh')
functions = (diff(th, t), th, ph, wY, wZ, vX, vh)


def plain(expr):
    """Without functions of time."""
    expr = expr.subs(rates).subs(turn)
    for f, x in zip(functions, (at[2], at[0], at[1]) + at[3:]):
        expr = expr.subs(f, x)
    return expr


dwX, dwY, dwZ, dvX, dvh = sp.symbols('dwX dwY dwZ dvX dvh')
th, ph, wX, wY, wZ, vX, vh = at
s, c, T = sin(th), cos(th), tan(th)
of = [plain(sp.expand(e)) for e in
      (euler.dot(eX), euler.dot(eY), euler.dot(eZ), newton.dot(eX),
       newton.dot(eh), newton[1])]
gX = -wY*(IZ*wZ + IX*wY*T)/IX
gY = wX*(IZ*wZ + IX*wY*T)/IX
right = {dwX: gX + a*(N*s - Fh*c)/IX, dwY: gY + tY/IX, dwZ: (a*FX + tZ)/IZ,
         dvX: FX/M - wY/c*vh, dvh: Fh/M + wY/c*vX}
holds(78, *[simplify(e.subs(right)) for e in of[:3]])
holds(81, *[simplify(e.subs(right)) for e in of[3:5]])

lever, free = M*a**2/IX, M*(g - a*c*wX**2 - a*s*gX)
D = 1 + lever*s**2
N79 = (free + lever*s*c*Fh)/D
holds(79, of[5].subs(right).subs(N, N79))
damped = M*(g - a*c*wX**2 - a*s*(gX - k*wX))
holds(96, damped + M*a*(c*wX**2 - g/a - s*(wY*(IZ/IX*wZ + wY*T) + k*wX)))
nh = sp.Symbol('n_h')
N80 = free/(D + lever*mu*nh*s*c)
holds(80, (N - N79).subs(Fh, -mu*nh*N).subs(N, N80))

# The slope of the slip; sticking gives back the rolling coin's rates (14), (16).
uX_ = dvX + a*dwZ
uh_ = dvh - a*c*dwX + a*s*wX**2
sticks = sp.solve([uX_.subs(right), uh_.subs(right).subs(N, N79)], [FX, Fh])
rolling = {vX: -a*wZ, vh: a*c*wX, tY: 0, tZ: 0}
J, K = IX + M*a**2, IZ + M*a**2
w14 = (M*g*a*s - K*wY*wZ - IX*wY**2*T)/J
holds(82, right[dwX].subs(N, N79).subs(sticks).subs(rolling) - w14,
      right[dwZ].subs(sticks).subs(rolling) - M*a**2*wX*wY/K,
      diff(uX_.subs(right), FX)*M - (1 + M*a**2/IZ),
      diff(uh_.subs(right).subs(N, N79), Fh)*M - (1 + lever)/D)

E = (M*(vX**2 + vh**2 + a**2*s**2*wX**2) + IX*(wX**2 + wY**2) + IZ*wZ**2)/2 \
    + M*g*a*c
power = sum(diff(E, x)*d for x, d in (
    (th, wX), (wX, right[dwX]), (wY, right[dwY]), (wZ, right[dwZ]),
    (vX, right[dvX]), (vh, right[dvh])))
slip = FX*(vX + a*wZ) + Fh*(vh - a*c*wX) + tY*wY + tZ*wZ
holds(88, (power - slip).subs(N, N79))

# Painleve's bound: the least of 1 + (s^2 - mu s c)/k over the lean.
x = sp.Symbol('x', real=True)                   # 2 theta
least = 1 + ((1 - cos(x)) - mu*sin(x))/(2*k)
assert simplify(diff(least, x).subs(x, sp.atan(mu))) == 0
low = simplify(least.subs(x, sp.atan(mu)))
holds(86, low - (1 + (1 - sqrt(1 + mu**2))/(2*k)),
      low.subs(mu, 2*sqrt(k*(1 + k))).subs(sqrt(4*k*(k + 1) + 1), 2*k + 1))

# psi' = 0 held by a torque Q (T e_Y + e_Z) that does no work.
f, df, Q = sp.symbols('f df Q')                 # phi' and its slope
pair = {wY: c*f, wZ: -s*f}
w = sp.Symbol('b')*f                            # pivoting, about the vertical
ys = right[dwY].subs(tY, Q*T - w*c) - (c*df - s*wX*f)
zs = right[dwZ].subs(tZ, Q + w*s) - (-s*df - c*wX*f)
both = sp.solve([ys.subs(pair), zs.subs(pair)], [df, Q])
Dv = IX*c**2 + IZ*s**2
holds(85, both[df]*Dv + a*s*FX + (sp.Symbol('b') + 2*s*c*wX*(IZ - IX))*f,
      gX.subs(pair) - s*c*f**2*(IZ - IX)/IX)

print('hold:', *checked)
