#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints every number that physics.md tabulates.

usage:  python3 docs/proofs/tables.py         needs mpmath; about two minutes

No equation of motion is integrated: motions come from the reduced problem,
Eq. (33)-(35), (48), (55), with the hypergeometric functions of mpmath.  Unit
system: M = a = g = 1.
"""
from mpmath import (cos, findroot, gamma, hyp2f1, mp, mpf, pi, re, sin, sqrt,
                    tan)

mp.dps = 30


class Body:
    """A disc (b = 0) or ring of inner radius b; m = 1."""

    def __init__(self, b=0):
        self.IX = (1 + mpf(b)**2)/4
        self.IZ = 2*self.IX
        self.J, self.K = self.IX + 1, self.IZ + 1
        self.k1, self.k2 = self.IZ/self.IX, 1/self.K
        self.kap = self.k1*self.k2

    def basis(self, u):
        """Pe, Po, We, Wo of (35)."""
        nu = (-1 + sqrt(mpf(1) - 4*self.kap))/2
        half = mpf(1)/2
        return [re(f) for f in (
            hyp2f1(-(nu + 1)/2, nu/2, half, u*u),
            u*hyp2f1(-nu/2, (nu + 1)/2, 3*half, u*u),
            hyp2f1(-nu/2, (nu + 1)/2, half, u*u),
            u*hyp2f1((1 - nu)/2, (nu + 2)/2, 3*half, u*u))]

    def at_table(self):
        """Pe, Po at u = 1."""
        it = sqrt(mpf(1)/4 - self.kap)/2        # i tau/2
        return (re(sqrt(pi)/(gamma(.75 + it)*gamma(.75 - it))),
                re(sqrt(pi)/(gamma(1.25 + it)*gamma(1.25 - it)))/2)

    def window(self, th):
        """The ends of wZ/wY between which a circle is unstable."""
        T, m3 = tan(th), 3*self.IZ + 1
        B = self.K/T - m3*T
        D = sqrt(B*B - 4*self.K*self.k1*(3*self.IX*T*T + 1))
        return [(B + sign*D)/(2*self.K*self.k1) for sign in (-1, 1)]

    def tip(self):
        """theta* by the positive root of its quadratic."""
        A = (3*self.IZ + 1)**2 - 12*self.IZ*self.K
        B = -2*self.K*(3*self.IZ + 1 + 2*self.k1)
        return mp.atan(sqrt((-B - sqrt(B*B - 4*A*self.K**2))/(2*A)))

    def spin_rate(self, th, r):
        """wY of the circle with wZ = r wY."""
        return sqrt(sin(th)/(self.IX*tan(th) + self.K*r))


class Motion:
    """One motion by its integrals; theta swings between lo and hi."""

    def __init__(self, body, th, wX, wY, wZ):
        self.b = body
        th, wX, wY, wZ = map(mpf, (th, wX, wY, wZ))
        Pe, Po, We, Wo = body.basis(sin(th))
        p = wY*cos(th)
        self.KY, self.KZ = We*p - body.k1*Po*wZ, Pe*wZ - body.k2*Wo*p
        self.E = body.J*wX**2/2 + self.V(th)
        self.lo, self.hi = self.turning(th, wX, -1), self.turning(th, wX, 1)

    def pair(self, th):
        Pe, Po, We, Wo = self.b.basis(sin(th))
        return (self.KY*Pe + self.b.k1*self.KZ*Po,
                self.KZ*We + self.b.k2*self.KY*Wo)

    def V(self, th):
        p, wZ = self.pair(th)
        return self.b.IX*(p/cos(th))**2/2 + self.b.K*wZ**2/2 + cos(th)

    def turning(self, th, wX, side):
        """The end of the swing on one side; the start may be an end."""
        slope = (self.V(th + mpf('1e-12')) - self.V(th - mpf('1e-12')))*side
        if wX == 0 and slope > 0:
            return th
        step, inside = mpf('0.01'), th + side*mpf('1e-4')
        while self.V(inside) < self.E:
            wall = inside + side*step
            while abs(wall) >= pi/2:
                wall, step = (wall + inside)/2, step/2
            inside, last = wall, inside
        return findroot(lambda t: self.V(t) - self.E, (last, inside),
                        solver='anderson', tol=mpf('1e-40'))

    def swing(self, n):
        """(55) by the midpoint rule in alpha: period, d phi, d psi."""
        mid, half = (self.lo + self.hi)/2, (self.hi - self.lo)/2
        total = [mpf(0)]*3
        for k in range(n):
            al = pi*(k + mpf(1)/2)/n
            th = mid - half*cos(al)
            p, wZ = self.pair(th)
            w = half*sin(al)/sqrt(2*(self.E - self.V(th))/self.b.J)
            c2 = cos(th)**2
            for i, f in enumerate((1, p/c2, wZ + p*sin(th)/c2)):
                total[i] += 2*pi/n*f*w
        return total


def show(title, head, rows):
    print('\n' + title + '\n' + head)
    for row in rows:
        print(' | '.join(v if isinstance(v, str) else mp.nstr(v, 12)
                         for v in row))


def thresholds(b):
    o = Body(b)
    th = o.tip()
    r = sum(o.window(th*(1 - mpf('1e-25'))))/2
    wY = o.spin_rate(th, r)
    return (b, th, th*180/pi, tan(th)**2, r*wY, wY,
            sqrt(1/(o.K*o.k1)), sqrt(1/o.J))


def at_table(b):
    Pe, Po = Body(b).at_table()
    return b, Body(b).kap, Pe, Po, -2*Po/Pe, pi*sqrt(Body(b).J/Body(b).IX)


# name, b/a, (theta, wX, wY, wZ), points of the midpoint rule
SCENES = (('wobble', 0, (.1, 0, 0, 1), 60),
          ('generic', 0, (.5, .1, .8, 1.2), 60),
          ('ring', .9, (.5, .1, .8, 1.2), 60),
          ('tumble', 0, (1e-3, 0, 0, .3), 900),
          ('nearflat', 0, (.3, 0, .02, .02), 400))


def scene(name, b, start, n):
    m = Motion(Body(b), *start)
    return [name, m.lo, m.hi] + m.swing(n)


def fall(b):
    """From upright rest, (52): the first peak of F/N before F reverses, the
    lean of that reversal, and the leans between which N < 0; in degrees."""
    share = 1/Body(b).J

    def normal(th):
        c = cos(th)
        return 1 - share*(1 + 2*c - 3*c*c)

    def ratio(th):
        return share*sin(th)*(3*cos(th) - 2)/normal(th)

    peak = findroot(lambda th: mp.diff(ratio, th), mpf('0.6'))
    D = 1 - 3*(1/share - 1)
    ends = [mp.acos((1 + sign*sqrt(D))/3)*180/pi
            for sign in (1, -1)] if D >= 0 else ['none', 'none']
    return [b, peak*180/pi, ratio(peak), mp.acos(mpf(2)/3)*180/pi] + ends


def main():
    show('Thresholds', 'b/a | theta* | deg | tan^2 | wZ* | wY* | roll | spin',
         map(thresholds, ('0', '0.5', '0.9', '1')))
    show('At the table', 'b/a | kap | Pe(1) | Po(1) | KY/KZ to fall | turn',
         map(at_table, ('0', '0.5', '0.9', '1')))
    show('Swings', 'scene | lo | hi | T | dphi | dpsi',
         (scene(*row) for row in SCENES))
    show('Falls from upright rest',
         'b/a | peak | F/N | F = 0 | N < 0 from | to',
         map(fall, ('0', '0.5', '1')))


main()
