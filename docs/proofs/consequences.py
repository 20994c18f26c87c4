#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Asserts what physics.md concludes from the equations of motion.

usage:  python3 docs/proofs/consequences.py   Eq. (33)-(54), (56)-(58), (93), (94)
runs derivation.py first
"""
import sys

import sympy as sp
from sympy import diff, sqrt

sys.dont_write_bytecode = True
from derivation import (E, IX, IZ, J, K, M, R, Rh, T, D, a, c, count, eq14,
                        eq15, eq16, g, holds, k1, k2, m, s, th, wX, wY, wZ)

count.clear()
N = 7                                           # series are checked to e^N
u, e, lnv, kp, h, l, x = sp.symbols('u e lnv kp h l x')


def powers(expr, var, order):
    """The coefficients of var^0 ... var^order."""
    poly = sp.Poly(sp.expand(expr), var)
    return [poly.coeff_monomial(var**n) for n in range(order + 1)]


def legendre(f, q, d):
    """(1 - q^2) f'' - 2 q f' - kp f, the derivative d being by q."""
    return d((1 - q*q)*d(f)) - kp*f


# ---- the linear pair and its series, (33)-(38)
p = wY*c
holds(33, D(p) - k1*wZ*D(s), D(wZ) - k2*p/(1 - s**2)*D(s))
A = sp.symbols('a0:%d' % (N + 1))               # any coefficients of e^n
f = sum(t*e**n for n, t in enumerate(A))
for n, rest in enumerate(powers(
        legendre(f, u + e, lambda f: diff(f, e)), e, N - 2)):
    holds(34, rest.subs(A[n + 2], (
        2*u*(n + 1)**2*A[n + 1] + (n*(n + 1) + kp)*A[n])
        / ((1 - u*u)*(n + 1)*(n + 2))))
for n, rest in enumerate(powers(
        (1 - e*e)*diff(f, e, 2) - kp*f, e, N - 2)):     # p, about u = 0
    holds(34, rest.subs(A[n + 2], A[n]*(n*(n - 1) + kp)/((n + 1)*(n + 2))))
Pe, Po, We, Wo = sp.symbols('Pe Po We Wo')
KY, KZ = sp.symbols('KY KZ', positive=True)
P_, W_ = KY*Pe + k1*KZ*Po, KZ*We + k2*KY*Wo
det = Pe*We - k1*k2*Po*Wo                       # 1 at u = 0, and constant
holds(35, We*P_ - k1*Po*W_ - det*KY, Pe*W_ - k2*Wo*P_ - det*KZ)
dPe, dPo, dWe, dWo = kp*Wo, We, Po*kp/(1 - u*u), Pe/(1 - u*u)
holds(35, dPe*We + Pe*dWe - kp*(dPo*Wo + Po*dWo))

rn, sn = [sp.Integer(1)], [sp.Integer(0)]
for n in range(N):
    lam = n*(n + 1) + kp
    sn.append(sp.cancel(lam/(n + 1)**2*(
        sn[n] + rn[n]*((2*n + 1)/lam - sp.Rational(2, n + 1)))))
    rn.append(sp.expand(lam/(n + 1)**2*rn[n]))
Rv, sv = (sum(t*e**n for n, t in enumerate(f)) for f in (rn, sn))


def by_v(f):
    return diff(f, e) + diff(f, lnv)/e          # v = e, lnv = ln v


Sv = Rv*lnv + sv
for f in (Rv, Sv):                              # Legendre in v = (1 - u)/2
    rest = sp.expand(by_v(e*(1 - e)*by_v(f)) - kp*f)
    for k in (0, 1):
        holds(36, *powers(rest.coeff(lnv, k), e, N - 1))
PR, PS = (sp.expand(-2*e*(1 - e)*by_v(f)) for f in (Rv, Sv))
holds(37, *powers(Rv*PS - Sv*PR + 2, e, N - 1))
al, be, R_, S_, PS_ = sp.symbols('al be R_ S_ PS_')
PR_ = (R_*PS_ + 2)/S_                           # by (37)
W_, P_ = al*R_ + be*S_, al*PR_ + be*PS_         # wZ and k2 p
holds(38, (P_*S_ - W_*PS_)/2 - al, (PR_*W_ - P_*R_)/2 - be)

# ---- steady motions and their stability, (39)-(46), (53)
steady = K*wY*wZ + IX*wY**2*T - M*g*a*s
at_rest = {g: sp.solve(steady, g)[0]}
holds(39, J*eq14 + steady)
root, Q = sp.symbols('root Q')                  # the square root of (40)
by_root = {g: (root**2 - K**2*wZ**2)/(4*IX*M*a*s*T)}
for f in ((-K*wZ + root)/(2*IX*T), (-K*wZ - root)/(2*IX*T)):
    holds(40, steady.subs({wY: f, **by_root}))
holds(41, ((-K*wZ + root)/(2*IX*T) - 2*M*g*a*s/(K*wZ + root)).subs(by_root))
holds(42, steady.subs(wZ, 0) - IX*T*(wY**2 - M*g*a*c/IX))
radius = sp.Symbol('radius', positive=True)
turned = wY*(K*radius/a + IX*s)/c - M*g*a*s/wY          # (93)
holds(93, steady.subs(wZ, radius*wY/(a*c)) - wY*turned)
speed = sp.Symbol('speed', positive=True)
lean = T - IX*speed**2/(M*g*a*radius**2)*s - K*speed**2/(M*g*a*a*radius)
holds(94, steady.subs({wY: c*speed/radius, wZ: speed/a}) + M*g*a*c*lean)
t_ = sp.Symbol('t_', positive=True)
by_tan = t_ - l*t_/sqrt(1 + t_**2)
holds(94, diff(by_tan, t_) - (1 - l*(1/sqrt(1 + t_**2))**3),
      diff(by_tan, t_, 2) - 3*l*t_/(1 + t_**2)**sp.Rational(5, 2))
holds(53, (R[1] - M*g).subs(wX, 0).subs(at_rest),
      (Rh - M*a*wY*wZ/c).subs(wX, 0).subs(at_rest))
ph0, time = sp.symbols('ph0 time')               # (56) moves as (20), wX = 0
half = wY*time/(2*c)
chord = a*wZ*time*sp.sin(half)/half
for moved, rate in ((-chord*sp.cos(ph0 + half), -a*wZ*sp.cos(ph0 + 2*half)),
                    (chord*sp.sin(ph0 + half), a*wZ*sp.sin(ph0 + 2*half))):
    holds(56, sp.simplify(sp.expand_trig(diff(moved, time) - rate)))
field = sp.Matrix([wX, eq14, eq15, eq16])
A = field.jacobian([th, wX, wY, wZ]).subs(wX, 0)
JL = (M*g*a*c - (IX*(1 + 3*T**2) + m)*wY**2 - (3*IZ + m)*T*wY*wZ
      - K*k1*wZ**2)
holds(44, (l*sp.eye(4) - A).det('berkowitz') - l**2*(l**2 - JL/J))
by_ratio = -(3*IX*T**2 + m) + (K/T - (3*IZ + m)*T)*l - K*k1*l**2
holds('window', (JL - by_ratio*wY**2).subs(at_rest).subs(wZ, l*wY))
tip = ((3*IZ + m)**2 - 12*IZ*K)*Q**2 - 2*K*(3*IZ + m + 2*k1*m)*Q + K**2
holds('tip', (K - (3*IZ + m)*Q)**2 - 4*K*k1*(3*IX*Q + m)*Q - tip,
      tip.subs({IX: m/4, IZ: m/2}).subs(Q, (18*sqrt(5) - 39)/11))
upright = {th: 0, wX: 0}
holds(45, JL.subs(upright).subs(wY, 0) - (M*g*a - K*k1*wZ**2))
holds(46, JL.subs(upright).subs(wZ, 0) - (M*g*a - J*wY**2))

# ---- criticality: V to the fourth order in theta at both thresholds
kap = k1*k2
Pe, We = 1 + kap*u**2/2 + kap*(2 + kap)*u**4/24, (
    1 + kap*u**2/2 + kap*(6 + kap)*u**4/24)
Po, Wo = u + kap*u**3/6, u + (2 + kap)*u**3/6
V = (IX*(KY*Pe + k1*KZ*Po)**2*(1 + u**2 + u**4)/2
     + K*(KZ*We + k2*KY*Wo)**2/2 + M*g*a*(1 - u**2/2 - u**4/8))
v0, v1, v2, v3, v4 = powers(V, u, 4)            # in u = theta - theta^3/6
for number, spin, none, c2, c4 in (
        (45, KZ, KY, (IZ*K*KZ**2/IX - M*g*a)/2,
         M*g*a*(9*IX*IZ + 3*IX*m + 4*IZ*m)/(24*IX*K)),
        (46, KY, KZ, (J*KY**2 - M*g*a)/2,
         M*g*a*(9*IX**2*IZ + 9*IX**2*m + 11*IX*IZ*m + 5*IX*m**2
                + 4*IZ*m**2)/(24*IX*J*K))):
    holds(number, *(t.subs(none, 0) for t in (v2 - c2, v1, v3)))
    critical = {none: 0, spin: sp.solve(c2, spin)[0]}
    holds(number, (v4 - v2/3).subs(critical) - c4)

# ---- the reduced problem and the split step, (48), (50)


def along(f):
    """d/dtheta on a leaf of fixed K_Y, K_Z: the pair follows (33)."""
    return diff(f, th) + diff(f, wY)*(wY*T + k1*wZ) + diff(f, wZ)*k2*wY


V = IX*p**2/(2*c**2) + K*wZ**2/2 + M*g*a*c
holds(48, E - J*wX**2/2 - V, along(V) + J*eq14, along(along(V)) + JL)
holds(50, along(eq14) - JL/J)
co = sp.symbols('co0:5')                        # any F, x = 0 at the start
F = sum(k*x**n for n, k in enumerate(co))
X, Y = sp.Integer(0), wX
for force, kick, drift in (
        (F, h/6, h/2), (F*(1 + h**2/24*diff(F, x)), 2*h/3, h/2), (F, h/6, 0)):
    Y += sum(t*h**n for n, t in enumerate(
        powers(kick*force.subs(x, X), h, 4)))
    X = sp.expand(X + drift*Y)
flow, exact = sp.Matrix([x, wX]), sp.zeros(2, 1)
for n in range(5):
    exact += flow.subs(x, 0)*h**n/sp.factorial(n)
    flow = diff(flow, x)*wX + diff(flow, wX)*F
for got, want in zip((X, Y), exact):
    holds(50, *powers(got - want, h, 4))        # order 4

# ---- any time from half a period, (57) and (58); w = e^(i b)
path = {wX: -wX, x: -x}                         # t, wX, phi -> -: x' is even
rate_z, rate_x = wX*c*sp.cos(x) + wZ*sp.sin(x), (
    -wZ*sp.cos(x) + wX*c*sp.sin(x))             # (20) with phi = x
holds(57, (eq14 - eq14.subs(wX, -wX)), (eq15 + eq15.subs(wX, -wX)),
      rate_z + rate_z.subs(path, simultaneous=True),
      rate_x - rate_x.subs(path, simultaneous=True))
w, zB, xB, n = sp.symbols('w zB xB n', positive=True)
L = (xB*(w + 1/w) - zB*(w - 1/w)/sp.I)          # 2 (xB cos b - zB sin b)
once = (zB + sp.I*xB) - w**2*(zB - sp.I*xB)     # B is where -B was carried
moved = [sp.I*L*(w**k - w**-k)/(w - 1/w)*w**k for k in range(6)]
holds(58, moved[1] - once,
      *(moved[k + 1] - (once + w**2*moved[k]) for k in range(5)),
      (zB - xB*sp.I*(w + 1/w)/(w - 1/w))*(1 - w**2) - once)

# ---- falls: the nearly flat pass, from rest, the landing: (51), (52), (54)
t, d, vf, c0, c1, c2 = sp.symbols('t d vf c0 c1 c2', positive=True)
p_flat = d*vf*sqrt(J/IX)
delta = sqrt(d**2 + vf**2*t**2)
holds(51, diff(delta, t, 2) - IX*p_flat**2/J/delta**3, sp.simplify(
    2*sp.integrate(p_flat/delta**2, (t, 0, sp.oo)) - sp.pi*sqrt(J/IX)))
fall = {wY: 0, wZ: 0, wX: sqrt(2*M*g*a*(c0 - c)/J)}
holds(52, (R[1]/(M*g) - 1 + m/J*(1 + 2*c0*c - 3*c**2)).subs(fall),
      (Rh/(M*g) + m/J*s*(2*c0 - 3*c)).subs(fall))
k, n = IX/m, sp.Symbol('n')                     # n for cos theta
press = (k - 2*n + 3*n**2)/(1 + k)              # N/(M g), from upright
holds('lift-off', (R[1]/(M*g)).subs(fall).subs(c0, 1) - press.subs(n, c),
      diff(press, n).subs(n, sp.Rational(1, 3)),
      press.subs(n, sp.Rational(1, 3)) - (3*IX - m)/(3*J),
      *(press.subs(n, (1 + sign*sqrt(1 - 3*k))/3) for sign in (1, -1)),
      *(press.subs(IX, m/4).subs(n, n0)         # 60 degrees, 80.41
        for n0 in (sp.Rational(1, 2), sp.Rational(1, 6))),
      R[1].subs({th: 0}) - M*g + M*a*wX**2)     # upright, any wY, wZ, body
ratio2 = (1 - n**2)*(2 - 3*n)**2/(k - 2*n + 3*n**2)**2      # (F/N)^2
peak = (6*k + 9)*n**2 - (2*k + 12)*n + 4 - 3*k
holds('slip', (Rh/R[1]).subs(fall).subs(c0, 1)**2 - ratio2.subs(n, c),
      diff(ratio2, n) + 2*(3*n - 2)*peak/(k - 2*n + 3*n**2)**3)
n0 = (25 + sqrt(79))/42                         # 36.21 degrees
holds('slip', peak.subs(IX, m/4).subs(n, n0))
assert abs(sqrt(ratio2.subs(IX, m/4).subs(n, n0)).evalf(20)
           - sp.Float('0.421574466749')) < 1e-12
assert abs(sp.deg(sp.acos(n0)).evalf(20) - sp.Float('36.2095584929')) < 1e-10
tau = t/c0 - c1*t**2/(2*c0**2) + t**3*(2*c1**2 - c0*c2)/(6*c0**3)
holds(54, *powers(sp.series(
    diff(tau, t) - 1/(c0 + c1*t + c2*t**2/2), t, 0, 3).removeO(), t, 2))
print('%d identities hold: %s' % (
    sum(count.values()), ' '.join(str(n) for n in count)))
