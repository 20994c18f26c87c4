#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Derives the flight and the impact of docs/physics.md: (98), (99), (116),
the derivatives of (103), (117), (105)-(108), in natural units.

    toss.py
"""
import sympy as sp

done = []


def zero(number, *expressions):
    for e in expressions:
        e = sp.simplify(sp.expand_trig(sp.sympify(e).doit()))
        assert e == 0, (number, e)
    done.append(number)


t = sp.Symbol("t", positive=True)
IX, IZ = sp.symbols("I_X I_Z", positive=True)
theta, phi = sp.symbols("theta phi", real=True)
s, c, S, C = sp.sin(theta), sp.cos(theta), sp.sin(phi), sp.cos(phi)
E = sp.Matrix([[C, 0, -S], [s * S, c, s * C], [c * S, -s, c * C]])  # (7)
eX, eY, eZ = (E.row(i).T for i in range(3))
h, up = sp.Matrix([S, 0, C]), sp.Matrix([0, 1, 0])

# ---- flight: L = I omega is constant, and (98) is omega
wX, wY, wZ = sp.symbols("wX wY wZ", real=True)
L = IX * (wX * eX + wY * eY) + IZ * wZ * eZ
omega = L / IX + wZ * (1 - IZ / IX) * eZ
zero(98, *(omega - (wX * eX + wY * eY + wZ * eZ)))

# (99) solves v' = l x v for any unit vector k and any v
a, b = sp.symbols("a b", real=True)
k = sp.Matrix([sp.sin(a) * sp.cos(b), sp.cos(a), sp.sin(a) * sp.sin(b)])
rate = sp.Symbol("rate", positive=True)
v0 = sp.Matrix(sp.symbols("v1:4", real=True))
A = rate * t
v = v0 + sp.sin(A) * k.cross(v0) + (1 - sp.cos(A)) * k.cross(k.cross(v0))
zero(99, *(v.diff(t) - rate * k.cross(v)), *(v.subs(t, 0) - v0))

# (116): with the torque -b L the axis turns about k at rate exp(-b t)
damping = sp.Symbol("b", positive=True)
left = sp.exp(-damping * t)
slowed = v.subs(t, (1 - left) / damping)
zero(116, *(slowed.diff(t) - left * rate * k.cross(slowed)))

# ---- the gap: |n_h|^2 = 1 - n_y^2, n_y = P + D cos x of (103)
y, vy, P, D, x0 = sp.symbols("y v_y P D x_0", real=True)
height = y + vy * t - t**2 / 2
ny = P + D * sp.cos(rate * t + x0)
G = height**2 - (1 - ny**2)
x = rate * t + x0
speed = height.diff(t)
zero(103, G.diff(t, 2) - (2 * speed**2 - 2 * height - 2 * rate**2 * D *
                          (P * sp.cos(x) + D * sp.cos(2 * x))),
     G.diff(t, 3) - (-6 * speed + 2 * rate**3 * D *
                     (P * sp.sin(x) + 2 * D * sp.sin(2 * x))))

# (117): N = n_y^2 by the angle of (116), whose rate falls as exp(-b t)
angle = rate * (1 - left) / damping
N = (P + D * sp.cos(angle))**2
z = sp.Symbol("z")
by = [((P + D * sp.cos(z))**2).diff(z, i).subs(z, angle) for i in range(4)]
w = rate * left
zero(117, N.diff(t, 2) - (by[2] * w**2 - by[1] * damping * w),
     N.diff(t, 3) - (by[3] * w**3 - 3 * by[2] * damping * w**2 +
                     by[1] * damping**2 * w))

# ---- impact: an impulse p at -e_Y changes V, and I omega by -e_Y x p
pX, ph, py = sp.symbols("p_X p_h p_y", real=True)
p = pX * eX + ph * h + py * up
turn = -eY.cross(p)
kx, kz = 1 / IX, 1 / IZ
dwX, dwY, dwZ = (turn.dot(e) for e in (eX, eY, eZ))
zero(106, dwX * kx + kx * (c * ph - s * py), dwY, dwZ * kz - kz * pX)

V = sp.Matrix(sp.symbols("V1:4", real=True))
rim = V + (wX * eX + wY * eY + wZ * eZ).cross(-eY)
zero(105, rim.dot(eX) - (V.dot(eX) + wZ), rim.dot(h) - (V.dot(h) - wX * c),
     rim[1] - (V[1] + wX * s))

# W of (106) along X, h, y; the smooth and the sticking impulse of (107)
W = sp.Matrix([[1 + kz, 0, 0], [0, 1 + kx * c**2, -kx * c * s],
               [0, -kx * c * s, 1 + kx * s**2]])
u = sp.Matrix(sp.symbols("u_X u_h u_y", real=True))
e, f = sp.symbols("e f", real=True)
Wyy, o = W[2, 2], kx * c * s / W[2, 2]
n = -u[2] / Wyy
d = sp.Matrix([-u[0] / (1 + kz), -Wyy / (1 + kx) * (u[1] + o * u[2]), 0])
d[2] = o * d[1]
zero(107, *(W * (sp.Matrix([0, 0, n]) + d) + u))

# (108): u_y becomes -e u_y, and the energy falls by the sum of two squares
q = sp.Matrix([0, 0, (1 + e) * n]) + f * d
after = u + W * q
gain = (q.T * u)[0] + (q.T * W * q)[0] / 2
fall = (1 - e**2) * n**2 * Wyy + (1 - (1 - f)**2) * (d.T * W * d)[0]
zero(108, after[2] + e * u[2], gain + fall / 2)
print("holds: " + ", ".join(f"({i})" for i in sorted(set(done))))
