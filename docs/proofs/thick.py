#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Asserts what physics.md says of a coin with an edge, from Newton and Euler in
the table's frame, with M = a = g = 1.

    thick.py     Eq. (118)-(123), (125), (126), (128), (129), and what becomes
                 of (72), (73) and (105)-(107)

(124) are bounds, which tests/test_touch.c asserts.
"""
import sympy as sp
from sympy import Matrix, cos, diff, sin, sqrt, tan

t = sp.Symbol('t')
IX, IZ, mu, b, k = sp.symbols('I_X I_Z mu b k', positive=True)
eta, N, FX, Fh, gX, gh, AY, AZ, nh, Q = sp.symbols(
    'eta N F_X F_h g_X g_h A_Y A_Z n_h Q', real=True)
names = 'theta phi wY wZ vX vh'.split()
th, ph, wY, wZ, vX, vh = (sp.Function(n)(t) for n in names)
s, c, T = sin(th), cos(th), tan(th)
wX = diff(th, t)
plain = dict(zip((th, ph, wY, wZ, vX, vh), sp.symbols(names)))
rate = {diff(f, t): sp.Symbol('d' + str(x)) for f, x in plain.items()}
rate[diff(th, t, 2)] = sp.Symbol('dwX')
done = []


def constant(e):
    """Without functions of time."""
    return sp.sympify(e).subs(rate).subs(plain)


def zero(number, *expressions):
    """Each is 0, as a rational function of the half angles' tangents."""
    for e in expressions:
        e = constant(e)
        for angle in (plain[th], plain[ph]):
            u = sp.Symbol('u_' + angle.name)
            e = e.subs({tan(angle): 2*u/(1 - u*u), sin(angle): 2*u/(1 + u*u),
                        cos(angle): (1 - u*u)/(1 + u*u)})
        assert sp.numer(sp.together(e)).expand() == 0, (number, e)
    done.append(number)


# ---- geometry: the frames, (7), the rim d, and what it does
eX = Matrix([cos(ph), 0, -sin(ph)])
eY = Matrix([s*sin(ph), c, s*cos(ph)])
eZ = Matrix([c*sin(ph), -s, c*cos(ph)])
ey, eh = Matrix([0, 1, 0]), Matrix([sin(ph), 0, cos(ph)])
d = -eY + eta*eZ
P, Y = s - eta*c, c + eta*s
zero(118, d.dot(eX), d.dot(eh) + P, d.dot(ey) + Y, diff(Y, t) + wX*P,
     diff(P, t) - wX*Y, P**2 + Y**2 - 1 - eta**2)
zero(126, P.subs(th, sp.atan(eta)), Y.subs(th, sp.atan(eta)) - sqrt(1 + eta**2))

omega = wX*eX + wY*eY + wZ*eZ
rolls = {vX: -(wZ + eta*wY), vh: Y*wX}
v = vX*eX + vh*eh + diff(Y, t)*ey
rim = (v + omega.cross(d)).subs(diff(ph, t), wY/c)
zero(119, *rim.subs(rolls))
zero(122, rim.dot(eX) - (vX + wZ + eta*wY), rim.dot(eh) - (vh - wX*Y))

# ---- Newton and Euler, with the torques of losses I_X A_Y and I_Z A_Z
force = N*ey + FX*eX + Fh*eh
pull = gX*eX + gh*eh
L = IX*wX*eX + IX*wY*eY + IZ*wZ*eZ


def laws(velocity):
    """The six components that vanish, of frames that turn by (18)."""
    euler = diff(L, t) - d.cross(force) - IX*AY*eY - IZ*AZ*eZ
    newton = diff(velocity, t) - force - pull + ey
    parts = ([euler.dot(e) for e in (eX, eY, eZ)] +
             [newton.dot(e) for e in (eX, eh, ey)])
    turn = {sp.Symbol('dphi'): constant(wY/c)}
    return [constant(e).subs(turn) for e in parts]


dwX, dwY, dwZ, dvX, dvh = sp.symbols('dwX dwY dwZ dvX dvh')
k1, J = IZ/IX, IX + 1 + eta**2
D = 1 + 1/IZ + eta**2/IX
both = wZ + eta*wY
lean = (-wY*(IZ*wZ + IX*wY*T + Y/c*both) + P + gh*Y)/J
F120 = (wX*(wY - eta*k1*wZ) - gX)/D
F121 = -(AZ + eta*AY)/D
rolling = {dwX: lean, dwY: wX*(wY*T + k1*wZ) + eta*(F120 + F121)/IX + AY,
           dwZ: (F120 + F121)/IZ + AZ, FX: F120 + F121,
           N: 1 - Y*wX**2 - P*lean,
           Fh: Y*lean - P*wX**2 + wY/c*both - gh}
rolling = {x: constant(e) for x, e in rolling.items()}
of = laws(v.subs(rolls).doit())
lossless = {AY: 0, AZ: 0}
zero(120, *[e.subs(rolling).subs(lossless) for e in of])
zero(121, *[e.subs(rolling) for e in of])
E = (v.dot(v) + L.dot(omega))/2 + Y
zero(120, (constant(diff(E.subs(rolls).doit(), t) -
                    pull.dot(v.subs(rolls).doit()))
           .subs(sp.Symbol('dphi'), constant(wY/c))
           .subs(rolling).subs(lossless)))

# ---- a contact that slips, and one that is free
gX0 = -wY*(k1*wZ + wY*T)
N122 = (1 - Y*wX**2 - P*gX0)/(1 + P*(P + mu*nh*Y)/IX)
slips = {dwX: gX0 + (N*P - Fh*Y)/IX, dwY: wX*(wY*T + k1*wZ) + eta*FX/IX,
         dwZ: FX/IZ, dvX: FX + gX - wY/c*vh, dvh: Fh + gh + wY/c*vX}
of = [e.subs({x: constant(r) for x, r in slips.items()}).subs(lossless)
      for e in laws(v)]
zero(122, *of[:5], of[5].subs(Fh, -mu*nh*N).subs(N, constant(N122)))
y = sp.Function('y')(t)
gap = constant(diff(y - Y, t, 2).subs(diff(y, t, 2), -1))
zero(123, gap.subs(dwX, constant(gX0 - k*wX)) -
     constant(Y*wX**2 - 1 - P*(wY*(k1*wZ + wY*T) + k*wX)))

# ---- held, psi' = 0: it turns about a contact that is at rest
turn = diff(ph, t)
held = {wY: c*turn, wZ: -s*turn}
about = (L - d.cross(d.cross(omega))).subs(held).doit()
H = IX*c**2 + IZ*s**2 + P**2
W = s*c*(IZ - IX) + P*Y
zero(72, about.dot(eX) - J*wX, about.dot(ey) - H*turn,
     about.dot(eh) + W*turn, diff(H, t)/2 - W*wX)
torque = (-d).cross(pull - ey) - b*turn*ey - k*L.subs(held)
contour = Q*(T*eY + eZ)
zero(72, contour.dot(eX), contour.dot(ey))
rest = diff(about, t) - torque
ddphi = sp.Symbol('ddphi')
fall = constant((P + Y*gh + W*turn**2 - k*IX*wX)/J)
spin = constant((P*gX - (b + k*(IX*c**2 + IZ*s**2) + 2*W*wX)*turn)/H)


def going(e):
    return constant(e.subs(diff(ph, t, 2), ddphi)).subs({dwX: fall,
                                                         ddphi: spin})


zero(72, going(rest.dot(eX)), going(rest.dot(ey)))
G = IX*c + IZ*eta*s
V = ((IZ + 1)*(2*IX - IZ) + c**2*IZ*(IZ + 1 - IX) +
     IZ*(eta**2*(1 + s**2) + 2*eta*s*c))
Q73 = c/H*(gX*G + k*turn*P*G + b*turn*W - turn*wX*V)
zero(73, going((rest - contour).dot(eh).subs(Q, Q73)))

# ---- an impact at the lower rim: W of (106), D and 1 + kx (1 + h^2)
p = Matrix(sp.symbols('p_X p_h p_y', real=True))
jump = p[0]*eX + p[1]*eh + p[2]*ey
turned = d.cross(jump)
dw = Matrix([turned.dot(eX)/IX, turned.dot(eY)/IX, turned.dot(eZ)/IZ])
du = jump + (dw[0]*eX + dw[1]*eY + dw[2]*eZ).cross(d)
kx = 1/IX
mass = Matrix([[D, 0, 0], [0, 1 + kx*Y**2, -kx*P*Y],
               [0, -kx*P*Y, 1 + kx*P**2]])
zero(105, dw[1] - kx*eta*p[0])
zero(106, *(Matrix([du.dot(e) for e in (eX, eh, ey)]) - mass*p))
zero(107, mass[1:, 1:].det() - (1 + kx*(1 + eta**2)))

# ---- upright: the other rim comes down, sticks and does not bounce
h, w, after = sp.symbols('h w after', real=True)
up = {th: 0, ph: 0}
lower, other = (d.subs(eta, e).subs(up) for e in (h, -h))
axis = eX.subs(up)
before = -(w*axis).cross(lower)
zero(128, (before + (w*axis).cross(other)).dot(ey) - 2*h*w)
now = -(after*axis).cross(other)
change = IX*(after - w) - other.cross(now - before).dot(axis)
ratio, = sp.solve(constant(change), after)
zero(128, ratio - w*(IX + 1 - h**2)/(IX + 1 + h**2))
# What a coin that stands drops of what it takes to turn over.
drops = (h/100)**2*J.subs(eta, h)/2/(sqrt(1 + h**2) - 1)
cylinder = sp.Rational(1, 4) + h**2/3
assert all(drops.subs(IX, cylinder).subs(h, sp.Rational(n, 100)) < 1.3e-4
           for n in range(1, 18))

# ---- a pull in flight, and a blow, whose work is J times the mean velocity
x0, v0, g = sp.symbols('x_0 v_0 g', real=True)
x = x0 + v0*t + g*t**2/2
zero(125, diff(x, t) - (v0 + g*t), diff(x, t, 2) - g)
r, blow, V0, w0 = (Matrix(sp.symbols(f'{n}1:4', real=True)) for n in 'rJVw')
inertia = sp.diag(IX, IX, IZ)
V1, w1 = V0 + blow, w0 + inertia.inv()*r.cross(blow)
energy = [(a.dot(a) + o.dot(inertia*o))/2 for a, o in ((V0, w0), (V1, w1))]
mean = (V0 + w0.cross(r) + V1 + w1.cross(r))/2
zero(129, energy[1] - energy[0] - blow.dot(mean))
print('hold:', *sorted(set(done)))
