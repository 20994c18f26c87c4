#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The basis functions of the linear integrals: writes special.csv.

usage:  make_special.py [--out DIR]
needs:  python3-mpmath (Debian)

Pe, Po, We, Wo are hypergeometric functions of sin^2 theta, as in
make_reference.py; R one of v = (1 - |u|)/2.  The logarithmic solution S is
summed by the recurrence that its own differential equation gives, and checked
by the Wronskian R PS - S PR = -2.
"""
import argparse
import os

from mpmath import mp, mpf

from make_reference import fmt, phi_matrix

mp.dps = 60
HEAD = """\
# the linear basis at u=sin(theta) (u,b binary64 exact; kappa=4/(3+b^2), k1=2, \
k2=2/(3+b^2)): p=wY cos th=KY*Pe+k1*KZ*Po, wZ=KZ*We+k2*KY*Wo
# R,S: flat basis in v=(1-|u|)/2: wZ=alpha R+beta S, p=(alpha PR+beta PS)/k2; \
R=2F1(-nu,nu+1;1;v), S=R ln v+sum s_n v^n, s_0=0 (given for |u|)
b,u,kappa,Pe,Po,We,Wo,R,S,PR,PS
"""
LEANS = (0.0, 0.1, 0.25, 0.5, 0.6, 0.7, 0.75, 0.8, 0.9, 0.95, 0.99, 0.999,
         0.9999, 0.999999, -0.3, -0.85)


def flat(kappa, v):
    """R, S, -2 v (1 - v) R', -2 v (1 - v) S'."""
    r, s, n = mpf(1), mpf(0), 0
    R = vdR = sums = vds = mpf(0)
    while r > mpf(10) ** -(mp.dps + 5):
        R, vdR, sums, vds = R + r, vdR + n * r, sums + s, vds + n * s
        rho = (n * (n + 1) + kappa) / (n + 1) ** 2
        s = v * rho * (s + r * ((2 * n + 1) / (n * (n + 1) + kappa) -
                                mpf(2) / (n + 1)))
        r, n = v * rho * r, n + 1
    S, vdS = R * mp.log(v) + sums, R + vdR * mp.log(v) + vds
    return R, S, -2 * (1 - v) * vdR, -2 * (1 - v) * vdS


def row(b, u):
    kappa = 4 / (3 + mpf(b) ** 2)
    nu = (-1 + mp.sqrt(1 - 4 * mp.mpc(kappa))) / 2
    v = (1 - abs(mpf(u))) / 2
    R, S, PR, PS = flat(kappa, v)
    assert abs(mp.re(mp.hyp2f1(-nu, nu + 1, 1, v)) - R) < mpf('1e-50')
    assert abs(R * PS - S * PR + 2) < mpf('1e-45')
    return [kappa] + list(phi_matrix(kappa, mpf(u))) + [R, S, PR, PS]


def main():
    ap = argparse.ArgumentParser()
    ap.add_argument('--out', default=os.path.dirname(os.path.abspath(__file__)))
    with open(os.path.join(ap.parse_args().out, 'special.csv'), 'w') as f:
        f.write(HEAD)
        for b in (0.0, 0.5, 1.0):
            for u in LEANS:
                f.write(','.join([repr(b), repr(u)] +
                                 [fmt(v) for v in row(b, u)]) + '\n')


if __name__ == '__main__':
    main()
