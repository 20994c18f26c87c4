#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Asserts what physics.md says of losses and rest.

usage:  python3 docs/proofs/losses.py         Eq. (64)-(70), (72), (73), (75), (95)
runs derivation.py first
"""
import sys

import sympy as sp
from sympy import Rational, diff, sqrt

sys.dont_write_bytecode = True
from derivation import (E, IX, IZ, J, K, M, T, a, accel, c, column, count, dX,
                        dY, dZ, eq14, eq15, eq16, euler, g, holds, s, th, up,
                        w, wX, wY, wZ)

count.clear()
Q, alpha, b, k, pace, f, df, m1 = sp.symbols('Q alpha b k pace f df m1')
roll = wZ + wY*T                                # psi'
turn = w.dot(up)                                # about the vertical

# ---- a torque on the body, (64)
tau = sp.Matrix(sp.symbols('tX tY tZ'))
slowed = (eq14 + tau[0]/J, eq15 + tau[1]/IX, eq16 + tau[2]/K)
holds(64, euler.subs(dict(zip((dX, dY, dZ), slowed))) - tau,
      sum(diff(E, v)*r for v, r in zip((wX, wY, wZ), slowed))
      + diff(E, th)*wX - tau.dot(w))            # dE/dt = tau.omega

# ---- contour friction: its virtual work is Q psi' for all rates, so that it
# is this torque alone, without a part along e_X
X, Z = column(1, 0, 0), column(0, 0, 1)
dth, dph, dps = sp.symbols('dth dph dps')
work = sp.expand(tau.dot(dth*X + dph*up + dps*Z) - Q*dps)
contour = sp.solve([work.coeff(r) for r in (dth, dph, dps)], list(tau))
contour = tau.subs(contour)
holds(65, contour - Q*(T*column(0, 1, 0) + Z), contour.dot(w) - Q*roll,
      contour.dot(contour) - (Q/c)**2)          # horizontal: e_y has no part

# ---- the other three, and all in Sundman's time, (66)-(69), (95);
# pace = |psi'|
damping = -alpha*pace*column(J*wX, IX*wY, K*wZ)
pivoting = -b*turn*up
holds(67, turn - (wY*c - wZ*s), pivoting - column(0, -b*turn*c, b*turn*s))
angular = -k*column(IX*wX, IX*wY, IZ*wZ)
holds(95, (eq16 + angular[2]/K).subs({wX: 0}) + k*IZ/K*wZ,   # upright roll
      (eq15 + angular[1]/IX).subs({wX: 0}) + k*wY)           # upright spin
every = contour + damping + pivoting + angular
u, au = c*roll, alpha*c*pace
holds(68, c*every[0]/J + au*wX + k*c*IX/J*wX,
      c*every[1]/IX - (Q*s - b*turn*c**2)/IX + au*wY + k*c*wY,
      c*every[2]/K - (Q*c + b*turn*s*c)/K + au*wZ + k*c*IZ/K*wZ)
holds(69, -c*every.dot(w) + Q*u
      - au*(J*wX**2 + IX*wY**2 + K*wZ**2) - b*turn**2*c
      - k*c*(IX*(wX**2 + wY**2) + IZ*wZ**2))

# ---- the reaction, (70)
more = sp.symbols('mX mY mZ')
moved = {dX: dX + more[0], dY: dY + more[1], dZ: dZ + more[2]}
holds(70, M*(accel.subs(moved, simultaneous=True) - accel)
      - M*a*column(-more[2], 0, more[0]))

# ---- the contact stopped, (72), (73): f = phi'
stopped = {wY: c*f, wZ: -s*f}
D = IX*c**2 + K*s**2
rest = contour + pivoting + angular
holds(72, (J*eq14 + angular[0] - M*g*a*s - (K - IX)*s*c*f**2
           + k*IX*wX).subs(stopped),
      roll.subs(stopped))
turns = [(-s*wX*f + c*df) - (eq15 + rest[1]/IX).subs(stopped),
         (-c*wX*f - s*df) - (eq16 + rest[2]/K).subs(stopped)]
held = sp.solve(turns, [df, Q])
holds(72, D*held[df] + diff(D, th)*wX*f
      + (b + k*(IX*c**2 + IZ*s**2))*f)
need = K*(2*IX - IZ) + c**2*IZ*(K - IX)
falls = held[Q].subs({b: 0, k: 0})
holds(73, (falls*D)**2 - (f*wX*c*need)**2,
      ((held[Q] - falls)*D)**2
      - (f*s*c**2*(b*(K - IX) + k*IX*(K - IZ)))**2)
# the same where a little roll, u = c psi', is to stay as it is; angular
# damping slows it by itself
stays = sp.Symbol('u')
moving = {wY: c*f + s*stays, wZ: -s*f + c*stays}
turns = [(-s*wX*f + c*df + c*wX*stays
          - (eq15 + rest[1]/IX)).subs(moving),
         (-c*wX*f - s*df - s*wX*stays
          - (eq16 + rest[2]/K)).subs(moving)]
kept = sp.solve(turns, [df, Q])[Q]
holds(73, ((kept - held[Q]).subs(k, 0)*D)**2
      - (wX*stays*s*(IX*K + c**2*IZ*(K - IX)))**2)

# ---- the laws of the end, (75), of a disc in natural units: E = (3/2) e,
# psi' = 2/sqrt(e), and 2 T_kin = e
e = sp.Symbol('e', positive=True)
rate = 2/sqrt(e)
powers = [(m1*rate, Rational(3, 2), -2*m1),
          (m1*rate**2, 2, -Rational(16, 3)*m1),
          (m1*rate**Rational(5, 2), Rational(9, 4), -6*sqrt(2)*m1),
          (m1*rate**2/e, 3, -8*m1),
          (m1*e*rate, Rational(1, 2), -Rational(2, 3)*m1)]
for power, n, law in powers:
    assert sp.simplify(diff(e**n, e)*(-power*Rational(2, 3)) - law) == 0, 75
    count[75] = count.get(75, 0) + 1
print('%d identities hold: %s' % (
    sum(count.values()), ' '.join(str(n) for n in count)))
