#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints every number that physics.md tabulates.

usage:  python3 docs/proofs/tables.py         needs mpmath

Unit system: M = a = g = 1.
"""
from mpmath import cos, findroot, gamma, mp, mpf, pi, re, sin, sqrt, tan

mp.dps = 30


class Body:
    """A disc (b = 0) or ring of inner radius b; m = 1."""

    def __init__(self, b=0):
        self.IX = (1 + mpf(b)**2)/4
        self.IZ = 2*self.IX
        self.J, self.K = self.IX + 1, self.IZ + 1
        self.k1, self.k2 = self.IZ/self.IX, 1/self.K
        self.kap = self.k1*self.k2

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
    show('Falls from upright rest',
         'b/a | peak | F/N | F = 0 | N < 0 from | to',
         map(fall, ('0', '0.5', '1')))


main()
