#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Reference trajectories of the rolling coin, far beyond double precision.

usage:  make_reference.py [--only NAME[,NAME..]] [--digits 60] [--order 72] [--out DIR]
needs:  python3-mpmath (Debian).  python3-gmpy2, when present, only makes it faster.
Then:   add_amp.py CSV..   appends the last column, amp (needs python3-scipy).

Method: high-order Taylor series (default order 72, 60 significant digits), adaptive step, dense to the exact
output times.  Every initial value, parameter and output time is an IEEE binary64 number taken EXACTLY, so a
double-precision program can start from precisely the same state (C hex floats are in the CSV header).
Unknowns of the series: theta, wX, wY, wZ, phi, psi, x, z, with the auxiliaries
  s=sin th, c=cos th, q=phi'=wY/c, sf=sin phi, cf=cos phi.
Equations: see physics.md.  Output format: the '#' lines at the head of every CSV.
"""
import sys, os, math, time, argparse
import mpmath
from mpmath import mp, mpf
from operator import mul
try:
    import gmpy2
    from gmpy2 import mpfr
    HAVE = True
except ImportError:
    HAVE = False

HERE = os.path.dirname(os.path.abspath(__file__))
# ----------------------------------------------------------------------------------------------- scenes
# name: (set, M, a, b, g, theta, wX, wY, wZ, times, note).  Times in the scene's own units.
NAT = [0, 0.125, 1, 2.5, 5, 10, 20, 50, 100]
def f_plus(wZ, th, b=0.0, sign=1):             # steady state (M=a=g=1), rounded to double by the caller
    IX = mpf(1 + mpf(b)**2)/4; IZ = 2*IX; A = (IZ+1)*mpf(wZ); th = mpf(th)
    return float((-A + sign*mp.sqrt(A*A + 4*IX*mp.tan(th)*mp.sin(th)))/(2*IX*mp.tan(th)))
def scenes():
    mp.dps = 60
    S = {}
    def add(name, where, M, a, b, g, th, wX, wY, wZ, times, note):
        S[name] = (where, float(M), float(a), float(b), float(g), float(th), float(wX), float(wY), float(wZ), [float(t) for t in times], note)
    # --- the scenes that every chart shows
    add('wobble',  '', 1,1,0,1, 0.1,0,0,1.0, NAT, 'upright fast roll, disturbed')
    add('generic', '', 1,1,0,1, 0.5,0.1,0.8,1.2, NAT, 'generic')
    add('spin',    '', 1,1,0,1, 0.6,0,float(2*mp.sqrt(mp.cos(mpf(0.6)))),0, NAT, 'steady state 2 (wY rounded to double)')
    add('circle',  '', 1,1,0,1, 0.4,0,f_plus(1.0,0.4),1.0, NAT, 'steady state 3, f+ (wY rounded to double)')
    add('tumble',  '', 1,1,0,1, 1e-3,0,0,0.3, NAT, 'unstable upright roll, falls low and recovers')
    add('nearflat','', 1,1,0,1, 0.3,0,0.02,0.02, NAT, 'falls almost flat: a fast pass near theta=pi/2')
    add('ring',    '', 1,1,0.9,1, 0.5,0.1,0.8,1.2, NAT, "generic's state, ring b=0.9a")
    QT = [0, 0.00390625, 0.03125, 0.125, 0.25, 0.5, 1, 2, 3.5]
    add('quarter', '', 5.67e-3,12.13e-3,0,9.80665, 0.3,0,5,40, QT, 'US quarter, SI units')
    # --- further ones
    add('ring_b05','', 1,1,0.5,1, 0.2,-0.3,-0.5,0.9, NAT, 'ring b=0.5a, negative rates')
    add('negative','', 1,1,0,1, -0.4,0.2,0.6,-1.5, NAT, 'negative theta and wZ')
    add('flat3',   '', 1,1,0,1, 0.5,0,-0.2947,0.3, NAT, 'very near flat: min(pi/2-|theta|) about 1e-3')
    add('si_washer','', 12.3e-3,20e-3,8e-3,9.81, 0.25,-2,6,30, [0,0.00390625,0.0625,0.25,0.5,1,2,5], 'steel washer b=0.4a, SI units')
    return S

# ----------------------------------------------------------------------------------------------- arithmetic
class Num:
    """gmpy2.mpfr when available, mpmath.mpf otherwise: the same few operations."""
    def __init__(self, digits):
        self.digits = digits
        mp.dps = digits
        if HAVE:
            gmpy2.get_context().precision = int(digits*3.3219281) + 8
    def __call__(self, v):
        if HAVE:
            return mpfr(v) if isinstance(v, (int, float)) else mpfr(mpmath.nstr(mpf(v), self.digits+3, min_fixed=1, max_fixed=0))
        return mpf(v)
    def out(self, v):            # -> mpf
        if HAVE:
            return mpf(v.__format__('.%de' % (self.digits+2)))
        return v
    def sin(self, v): return gmpy2.sin(v) if HAVE else mp.sin(v)
    def cos(self, v): return gmpy2.cos(v) if HAVE else mp.cos(v)
    def dot(self, u, v):
        return sum(map(mul, u, v)) if HAVE else mp.fdot(u, v)

def series(N, y, par, K):
    """Taylor coefficients (orders 0..K) of the eight unknowns at state y."""
    IX, IZ, m, a, Mga, k1, k2, J = par
    th, wX, wY, wZ, ph, ps, x, z = [[v] for v in y]
    s, c = [N.sin(th[0])], [N.cos(th[0])]
    sf, cf = [N.sin(ph[0])], [N.cos(ph[0])]
    q = [wY[0]/c[0]]
    qs, YZ, XY, XA, qsY = [], [], [], [], []     # q*s, wY*wZ, wX*wY, wX*(q s + k1 wZ), q*s*wY
    A, Xc = [], []                               # q s + k1 wZ ;  wX*c
    dth, dph = [], []                            # (j+1) th_{j+1}, (j+1) phi_{j+1}
    dot = N.dot
    for k in range(K):
        n = k + 1
        rv = lambda v: v[k::-1]
        r_s, r_wY, r_wZ, r_c = rv(s), rv(wY), rv(wZ), rv(c)
        qs.append(dot(q, r_s))
        YZ.append(dot(wY, r_wZ)); XY.append(dot(wX, r_wY)); qsY.append(dot(qs, r_wY))
        A.append(qs[k] + k1*wZ[k]); XA.append(dot(wX, A[k::-1])); Xc.append(dot(wX, r_c))
        r_sf, r_cf = rv(sf), rv(cf)
        dx = a*(dot(Xc, r_sf) - dot(wZ, r_cf)); dz = a*(dot(Xc, r_cf) + dot(wZ, r_sf))
        dth.append(wX[k]); dph.append(q[k])
        wX.append((Mga*s[k] - (IZ+m)*YZ[k] - IX*qsY[k])/J/n)
        wY.append(XA[k]/n); wZ.append(k2*XY[k]/n)
        th.append(dth[k]/n); ph.append(q[k]/n); ps.append((wZ[k] + qs[k])/n)
        x.append(dx/n); z.append(dz/n)
        s.append(dot(dth, r_c)/n); c.append(-dot(dth, r_s)/n)
        sf.append(dot(dph, r_cf)/n); cf.append(-dot(dph, r_sf)/n)
        q.append((wY[n] - dot(c[1:], q[k::-1]))/c[0])
    return th, wX, wY, wZ, ph, ps, x, z

def horner(co, h):
    r = co[-1]
    for v in co[-2::-1]:
        r = r*h + v
    return r

def setup(N, sc):
    where, M, a, b, g, th, wX, wY, wZ, times, note = sc
    M, a, b, g = [N(v) for v in (M, a, b, g)]
    IX = M*(a*a+b*b)/4; IZ = M*(a*a+b*b)/2; m = M*a*a
    par = (IX, IZ, m, a, M*g*a, IZ/IX, m/(IZ+m), IX+m)
    return par, [N(th), N(wX), N(wY), N(wZ), N(0), N(0), N(0), N(0)]

def integrate(sc, digits=60, order=72, times=None, y0=None, turns=None, safety=0.9, maxturns=400):
    """-> list of 8-lists (gmpy2.mpfr or mpf) at the times; turns collects (t,theta,phi,psi) where wX=0."""
    N = Num(digits)
    par, y = setup(N, sc)
    if y0 is not None: y = y0
    times = sc[9] if times is None else times
    t = N(0); out = []; K = order
    eps = 10.0**(-(digits-4)) if digits < 300 else 0
    nsteps = 0
    for target in times:
        T = N(target)
        while t < T:
            S = series(N, y, par, K)
            # step from the last two coefficients, relative to the size of each unknown (max(|y|, 1e-3 of rate scale))
            h = None
            for u in S:
                scale = max(abs(float(u[0])), 1e-6)
                for kk in (K-1, K):
                    cf = abs(u[kk])
                    if cf > 0:
                        l = float((math.log(eps*scale) - log_abs(cf, N))/kk)
                        hh = math.exp(l)
                        h = hh if h is None else min(h, hh)
            h = safety*h
            h = N(h)
            last = t + h >= T
            if last: h = T - t
            yn = [horner(u, h) for u in S]
            if turns is not None and len(turns) < maxturns:
                w0, w1 = y[1], yn[1]
                if (w0 > 0) != (w1 > 0) or w1 == 0:
                    lo, hi = N(0), h                 # bisection to start, then Newton
                    for _ in range(40):
                        mid = (lo+hi)/2
                        if (horner(S[1], mid) > 0) == (w0 > 0) and w0 != 0: lo = mid
                        elif w0 == 0 and (horner(S[1], mid) > 0) != (w1 > 0): lo = mid
                        else: hi = mid
                    r = (lo+hi)/2; d = [kk*v for kk, v in enumerate(S[1])][1:]
                    for _ in range(6): r = r - horner(S[1], r)/horner(d, r)
                    if 0 < r <= h*(1+N(1e-30)) and not (t == 0 and float(r) < 1e-12):
                        turns.append([N.out(t+r)] + [N.out(horner(S[i], r)) for i in (0, 4, 5, 6, 7)])
            y = yn
            t = T if last else t + h
            nsteps += 1
        out.append(list(y))
    integrate.steps = nsteps
    return out

SERIES = 'theta wX wY wZ phi psi x z'.split()
def motion(start, times, digits=30, order=34, turns=None):
    """The states at the times, by name, of a ring b with M = a = g = 1 and the pose 0 that starts with theta, wX, wY, wZ."""
    N = Num(digits)
    ys = integrate(('', 1.0, 1.0, start[0], 1.0, *start[1:], times, ''), digits, order, turns=turns)
    return [dict(zip(SERIES, map(N.out, y))) for y in ys]

def motion_twice(start, times, names, again=True):
    """The same; if again, by a series of other order and digits too, which must agree to 1e-18."""
    rows = motion(start, times)
    if again:
        others = motion(start, times, 34, 39)
        assert max(abs(a[n] - b[n]) for a, b in zip(rows, others) for n in names) < 1e-18
    return rows

def log_abs(v, N):
    if HAVE:
        m, e = gmpy2.frexp(v)[1], gmpy2.frexp(v)[0]
        return math.log(abs(float(m))) + e*math.log(2.0)
    return float(mp.log(abs(v)))

# ----------------------------------------------------------------------------------------------- derived quantities
def phi_matrix(kap, u):
    """Pe, Po, We, Wo at u=sin theta (see physics.md): p = p0 Pe + k1 wZ0 Po,  wZ = wZ0 We + k2 p0 Wo."""
    nu = (-1 + mp.sqrt(1 - 4*mp.mpc(kap)))/2
    al, be = -(nu+1)/2, nu/2                        # even p: 2F1(al,be;1/2;u^2), al+be=-1/2, al*be=kap/4
    re = lambda v: mp.re(v)
    u2 = u*u
    Pe = re(mp.hyp2f1(al, be, mpf(1)/2, u2));            Po = u*re(mp.hyp2f1(al+mpf(1)/2, be+mpf(1)/2, mpf(3)/2, u2))
    We = re(mp.hyp2f1(-nu/2, (nu+1)/2, mpf(1)/2, u2));   Wo = u*re(mp.hyp2f1((1-nu)/2, (nu+2)/2, mpf(3)/2, u2))
    return Pe, Po, We, Wo

def derived(sc, y, dps):
    where, M, a, b, g = sc[:5]
    M, a, b, g = map(mpf, (M, a, b, g))
    th, wX, wY, wZ, ph, ps, x, z = y
    IX = M*(a*a+b*b)/4; IZ = 2*IX; m = M*a*a; k1 = IZ/IX; k2 = m/(IZ+m)
    s, c = mp.sin(th), mp.cos(th); T = s/c; sf, cf = mp.sin(ph), mp.cos(ph)
    dX = (M*g*a*s - (IZ+m)*wY*wZ - IX*wY*wY*T)/(IX+m); dZ = k2*wX*wY
    E = m*(wX**2+wZ**2)/2 + (IX*(wX**2+wY**2)+IZ*wZ**2)/2 + M*g*a*c
    p1 = dZ - wX*wY; p2 = wX**2 - wY*wZ*T; p3 = dX + wY*wZ
    Rx = M*a*(-p1*cf - p2*s*sf + p3*c*sf); Ry = M*a*(-p2*c - p3*s) + M*g; Rz = M*a*(p1*sf - p2*s*cf + p3*c*cf)
    F = mp.sqrt(Rx*Rx + Rz*Rz)
    Pe, Po, We, Wo = phi_matrix(k1*k2, s)
    p = wY*c
    wY0 = We*p - k1*Po*wZ; wZ0 = Pe*wZ - k2*Wo*p
    C1, S1, C2, S2, C3, S3 = mp.cos(ph/2), mp.sin(ph/2), mp.cos(th/2), mp.sin(th/2), mp.cos(ps/2), mp.sin(ps/2)
    q = [C1*C2*C3+S1*S2*S3, C1*S2*C3+S1*C2*S3, S1*C2*C3-C1*S2*S3, C1*C2*S3-S1*S2*C3]
    return [E, wY0, wZ0, Rx, Ry, Rz, F, x - a*s*sf, z - a*s*cf] + q

COLS = ('t theta phi psi x z wX wY wZ E KY KZ Rx Ry Rz F xc zc q0 q1 q2 q3').split()
HEAD = """# rolling coin reference trajectory, scene %(name)s: %(note)s
# params (binary64, exact): M=%(M)r (%(Mh)s) a=%(a)r (%(ah)s) b=%(b)r (%(bh)s) g=%(g)r (%(gh)s); I_X=M(a^2+b^2)/4, I_Z=2 I_X
# state at t=0 (binary64, exact): theta=%(th)r (%(thh)s) wX=%(wX)r (%(wXh)s) wY=%(wY)r (%(wYh)s) wZ=%(wZ)r (%(wZh)s); phi=psi=x=z=0
# every t is an exact binary64 number. 17 significant digits are printed (60-digit arithmetic).
# Units: those of the parameters; angles in rad. R: force of the floor on the coin, F=hypot(Rx,Rz).
# KY,KZ: the two linear integrals = wY and wZ carried along the orbit to theta=0 (physics.md).
# xc,zc: contact point. q0..q3: orientation quaternion (1,i,j,k), q=q_y(phi) q_x(theta) q_z(psi).
"""
def number(v, digits=17):
    return mpmath.nstr(v, digits, min_fixed=1, max_fixed=0)

def fmt(v):
    """The same with an exponent always."""
    if v == 0: return '0'
    m, _, e = number(v).partition('e')
    return m + 'e' + (e or '+0')

def main():
    ap = argparse.ArgumentParser()
    ap.add_argument('--only'); ap.add_argument('--digits', type=int, default=60); ap.add_argument('--order', type=int, default=72)
    ap.add_argument('--out', default=os.path.dirname(os.path.abspath(__file__)))
    o = ap.parse_args()
    S = scenes()
    for name in (o.only.split(',') if o.only else S):
        sc = S[name]; t0 = time.time(); turns = []
        times = sorted(set(sc[9] + EXTRA.get(name, [])))
        ys = integrate(sc, o.digits, o.order, times, turns=turns); st = integrate.steps
        N = Num(o.digits); mp.dps = o.digits
        d = os.path.join(o.out, sc[0]); os.makedirs(d, exist_ok=True)
        hx = dict(zip(('M','a','b','g','th','wX','wY','wZ'), sc[1:9])); hx.update({k+'h': float(v).hex() for k, v in list(hx.items())})
        with open(os.path.join(d, name + '.csv'), 'w') as f:
            f.write(HEAD % dict(hx, name=name, note=sc[10])); f.write(','.join(COLS) + '\n')
            for t, y in zip(times, ys):
                y = [N.out(v) for v in y]
                th, wX, wY, wZ, ph, ps, x, z = y
                row = [mpf(t), th, ph, ps, x, z, wX, wY, wZ] + derived(sc, y, o.digits)
                f.write(','.join(fmt(v) for v in row) + '\n')
        with open(os.path.join(d, name + '.turns.csv'), 'w') as f:
            f.write('# scene %s: the turning points (wX=0, theta at an extreme) after t=0, first 40, to 30+ digits\n' % name)
            f.write('t,theta,phi,psi,x,z\n')
            for turn in turns[:40]:
                f.write(','.join(map(fmt, turn)) + '\n')
        dm = min([mp.pi/2-abs(r[1]) for r in turns] or [mpf(9)])
        print('%-13s %6d steps %6.1fs  min delta %.3g' % (name, st, time.time()-t0, float(dm)), flush=True)

# further output times at and around the first flat pass
EXTRA = {'nearflat': [2.6875, 345/128, 2.703125], 'flat3': [1.9375, 2013/1024, round(1.96629405*2**14)/2**14, 1.96875]}
if __name__ == '__main__':
    main()
