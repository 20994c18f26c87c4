#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Sliding flat: the forces by integration over the face, by closed forms; the slide by quadrature (30 digits) and by a direct ODE whose
forces come from the face. Writes flat_slides.csv. Only mpmath is needed.  make_flat_slides.py [tables]"""
import sys, math
import mpmath as mp
mp.mp.dps = 40
M = mp.mpf
# ---- closed forms (disc of radius 1, hoop of radius 1; e = v/w)
def disc(e):
    if e == 0: return M(0), M(2)/3
    if e == 1: return 8/(3*mp.pi), 8/(9*mp.pi)
    m = e*e if e < 1 else 1/(e*e)
    K, E = mp.ellipk(m), mp.ellipe(m)
    if e < 1: return 4/(3*mp.pi)*((1+m)*E-(1-m)*K)/e, 4/(9*mp.pi)*((4-2*m)*E-(1-m)*K)
    return 4/(3*mp.pi)*((e*e+1)*E-(e*e-1)*K), 4/(9*mp.pi)*e*((4-2*e*e)*E+(2*e*e-5+3*m)*K)
def hoop(e):
    if e == 0: return M(0), M(1)
    if e == 1: return 2/mp.pi, 2/mp.pi
    m = e*e if e < 1 else 1/(e*e); x = mp.sqrt(m)
    K, E = mp.ellipk(m), mp.ellipe(m)
    A, B = 2/mp.pi*E, 2/mp.pi*(E-(1-m)*K)/x
    return (B, A) if e < 1 else (A, B)
def law(e, k):
    B = 2*k-1
    if B <= 0: return disc(e)
    if B >= 1: return hoop(e)
    r = mp.sqrt(B); f, t = disc(e); g, u = disc(e/r)
    return (f-B*g)/(1-B), (t-B*r*u)/(1-B)
# ---- the face itself: polar coordinates about the centre of rotation, trapezoid (periodic)
def face_disc(d, n, mm=math):
    s = u = 0
    for i in range(n):
        a = mm.pi*(i+.5)/n if mm is math else mp.pi*(i+M(1)/2)/n
        S, C = mm.sin(a), mm.cos(a)
        if d < 1:   # upper half twice
            r = d*C+mm.sqrt(1-d*d*S*S); s += C*r*r; u += 2*r**3/3
        else:       # sin(phi) = S/d, a over a whole period of S
            c = mm.sqrt(1-S*S/(d*d)); s += 2*c*C*C; u += C*C*(6*d*d*c*c+2*C*C)/(3*d*c)
    return s/n, u/n-d*s/n
def face_hoop(d, n, mm=math):
    s = u = 0
    for i in range(n):
        a = mm.pi*(i+.5)/n if mm is math else mp.pi*(i+M(1)/2)/n
        C = mm.cos(a); q = mm.sqrt(1+d*d+2*d*C); s += (d+C)/q; u += (1+d*C)/q
    return s/n, u/n
def npts(d):
    x = d if d < 1 else 1/d
    return int(min(6000, 16+40/max(1e-3, -math.log(x))))
def face(e, k):
    B = 2*k-1
    if B <= 0: return face_disc(e, npts(e))
    if B >= 1: return face_hoop(e, npts(e))
    r = math.sqrt(B); f, t = face_disc(e, npts(e)); g, u = face_disc(e/r, npts(e/r))
    return (f-B*g)/(1-B), (t-B*r*u)/(1-B)
# ---- p = v/(v+w), R = v+w, mu dt = R dsigma: p' = -h, (ln R)' = -g
def gh(p, k):
    e = p/(1-p); f, t = law(e, k); t = t/k
    return f+t, (1-p)*f-p*t
def star(k):
    if 2*k-1 >= 1: return M(1)/2 if k == 1 else None
    return mp.findroot(lambda p: gh(p, k)[1], (M('.3'), M('.49')), solver='anderson', tol=1e-60)
NG = 20
XS = None
def nodes():
    global XS, WI, WT
    if XS: return
    P = [c for c in mp.polyroots(mp.taylor(lambda x: mp.legendre(NG, x), 0, NG)[::-1], maxsteps=400, extraprec=400)]
    XS = sorted([(1+mp.re(c))/2 for c in P])
    # integrals of the Lagrange polynomials from 0 to x_i, and to 1 (by the Vandermonde system)
    V = mp.matrix(NG, NG)
    for i in range(NG):
        for j in range(NG): V[i, j] = XS[i]**j
    old = mp.mp.dps; mp.mp.dps = 60; Vi = V**-1; mp.mp.dps = old
    def w(x): return [sum(x**(j+1)/(j+1)*Vi[j, i] for j in range(NG)) for i in range(NG)]
    WI = [w(x) for x in XS]; WT = w(M(1))
def panel(a, b, st, F):
    """one panel in xi: state (lnR, th, X, Ph) -> state at b"""
    h = b-a; g = [F(a+h*x) for x in XS]             # (rate of ln R, 1/H, p)
    L = [st[0]+h*sum(WI[i][j]*g[j][0] for j in range(NG)) for i in range(NG)]
    R = [mp.exp(x) for x in L]
    return (st[0]+h*sum(WT[j]*g[j][0] for j in range(NG)), st[1]+h*sum(WT[j]*R[j]*g[j][1] for j in range(NG)),
            st[2]+h*sum(WT[j]*R[j]**2*g[j][2]*g[j][1] for j in range(NG)), st[3]+h*sum(WT[j]*R[j]**2*(1-g[j][2])*g[j][1] for j in range(NG)))
def slide(k, mu, v0, w0, D=M(1)/2):
    """time, distance, turn, and v, w, distance, turn at half of the time"""
    k, mu, v0, w0 = M(k), M(mu), M(v0), M(w0); sg = -1 if w0 < 0 else 1; w0 = abs(w0); S = v0+w0
    if w0 == 0: T = v0/mu; return T, v0*T/2, M(0), v0/2, M(0), v0*T*3/8, M(0)
    if v0 == 0:
        B = max(0, min(1, 2*k-1)); t0 = (1-B*mp.sqrt(B))/(1-B)*2/3 if B < 1 else M(1); T = k*w0/(mu*t0)
        return T, M(0), sg*w0*T/2, M(0), sg*w0/2, M(0), sg*w0*T*3/8
    nodes(); ps = star(k); p0 = v0/S
    P = lambda xi: ps+(p0-ps)*mp.exp(-xi)
    def F(xi):
        p = P(xi); g, h = gh(p, k); H = h/(p-ps); return -g/H, 1/H, p
    cuts = []; B = 2*k-1                             # where the rim (or the hole's rim) holds the centre of rotation
    for pc in [M(0), M(1), M(1)/2]+([mp.sqrt(B)/(1+mp.sqrt(B))] if 0 < B < 1 else []):
        if abs(pc-ps) > 1e-25 and (pc-ps)/(p0-ps) > 0:
            xi = -mp.log((pc-ps)/(p0-ps));
            if xi > -3: cuts.append(xi)
    st = (M(0), M(0), M(0), M(0)); hist = [(M(0), st)]; a = M(0); done = False
    hits = sorted(c for c in cuts if c > 0)
    while not done:
        near = min([abs(c-a) for c in cuts]+[M(9)]); nxt = [c for c in hits if c > a+M(10)**-14]
        b = a+min(D, max(near*M('.4'), M(10)**-13) if near else M(10)**-13)
        if nxt and b > nxt[0]-M(10)**-12: b = nxt[0]
        st = panel(a, b, st, F); a = b; hist.append((a, st)); R = mp.exp(st[0])
        done = R < M(10)**-26 or abs(P(a)-ps) < M(10)**-20 or a > 60
    p = P(a); g = gh(ps, k)[0]; left = R/g; T = st[1]+left; X = st[2]+left*R*p/2; Ph = st[3]+left*R*(1-p)/2
    half = T/2
    for i in range(len(hist)-1):
        if hist[i+1][1][1] >= half: break
    (a, s0), (b, s1) = hist[i], hist[i+1]; x = (half-s0[1])/(s1[1]-s0[1])*(b-a)+a if s1[1] > half else b
    if s1[1] > half:
        lo, hi = a, b
        for _ in range(60):
            s = panel(a, x, s0, F); g = F(x); d = (half-s[1])/(mp.exp(s[0])*g[1])
            if d > 0: lo = x
            else: hi = x
            if abs(d) < 1e-30: break
            x = x+d if lo <= x+d <= hi else (lo+hi)/2
        s = panel(a, x, s0, F); p = P(x); R = mp.exp(s[0]); X2, P2 = s[2], s[3]
    else:
        s = hist[-1][1]; R0 = mp.exp(s[0]); u = half-s[1]; q = u/left; p = ps; R = R0*(1-q); X2 = s[2]+R0*p*(u-u*q/2); P2 = s[3]+R0*(1-p)*(u-u*q/2)
    return S*T/mu, S*S*X/mu, sg*S*S*Ph/mu, S*R*p, sg*S*R*(1-p), S*S*X2/mu, sg*S*S*P2/mu
# ---- direct: Dormand-Prince 5(4) in time, doubles, forces from the face
DP = [[1/5], [3/40, 9/40], [44/45, -56/15, 32/9], [19372/6561, -25360/2187, 64448/6561, -212/729], [9017/3168, -355/33, 46732/5247, 49/176, -5103/18656], [35/384, 0, 500/1113, 125/192, -2187/6784, 11/84]]
DE = [71/57600, 0, -71/16695, 71/1920, -17253/339200, 22/525, -1/40]
def direct(k, mu, v0, w0, t):
    sg = -1 if w0 < 0 else 1; y = [v0, abs(w0), 0., 0.]; S = v0+abs(w0); s = 0.; h = .01*S/mu; n = 0
    def rhs(y):
        f, tq = face(y[0]/y[1], k); return [-mu*f, -mu*tq/k, y[0], y[1]]
    while s < t:
        h = min(h, t-s); K = [rhs(y)]
        for r in DP: K.append(rhs([y[i]+h*sum(c*q[i] for c, q in zip(r, K)) for i in range(4)]))
        e = max(abs(h*sum(c*q[i] for c, q in zip(DE, K)))/(S if i < 2 else S*S/mu) for i in range(4)); n += 1
        if e < 3e-12 or h < 1e-9*t: y = [y[i]+h*sum(c*q[i] for c, q in zip(DP[5], K)) for i in range(4)]; s = t if t-s <= h else s+h
        h *= min(3, max(.2, .9*(3e-12/max(e, 1e-18))**.2))
    return y[0], sg*y[1], y[2], sg*y[3]
PUB = [(.25,.5,.3,1.,2.,"disc"), (.25,.5,.2,5.,1.,"disc; slides faster than it turns"), (.25,.5,.5,.05,4.,"disc; turns fast"), (.3125,.625,.3,2.,3.,"ring b/a = .5"), (.4525,.905,.25,1.5,-1.,"ring b/a = .9; turns back"), (.5,1.,.3,.7,1.5,"hoop"), (.25,.5,.3,2.,0.,"disc; no turn"), (.2,.4,.4,1.,1.5,"body lighter at the rim: pressure of a disc")]
if __name__ == '__main__':
    print("closed form against the face (40 digits), f and t:")
    for e in ['.01', '.3', '.653', '.9', '1.2', '4', '100']:
        e = M(e); x = min(e, 1/e); n = int(110/-mp.log(x))+20; a, b = disc(e), face_disc(e, n, mp); c, d = hoop(e), face_hoop(e, n, mp)
        print("  eps %-7s disc %.1e %.1e  hoop %.1e %.1e" % (mp.nstr(e, 4), abs(a[0]-b[0]), abs(a[1]-b[1]), abs(c[0]-d[0]), abs(c[1]-d[1])))
    print("eps*, and lambda = (dh/dp)/g there (p - p* goes as R^lambda):")
    for b in ['0', '.5', '.9', '.99', '.999', '1']:
        b = M(b); k = (1+b*b)/2; p = star(k); l = mp.diff(lambda q: gh(q, k)[1], p)/gh(p, k)[0] if b < 1 else mp.inf
        print("  b/a = %-5s I_Z = %-9s eps* = %s  lambda = %s  end: t = %s (v+w)/mu" % (mp.nstr(b, 4), mp.nstr(k, 7), mp.nstr(p/(1-p), 16), mp.nstr(l, 8), mp.nstr(1/gh(p, k)[0], 12)))
    for k in ['.24', '.3', '.4']: p = star(M(k)) if float(k) > .25 else None; print("  disc's pressure, I_Z = %s: eps* = %s" % (k, mp.nstr(p/(1-p), 12) if p else "infinity"))
    for name, rows in (('.', PUB),):
        out = open(name+'/flat_slides.csv', 'w'); out.write("# a coin that slides flat: natural units (M = a = g = 1); the inputs are doubles; turn about the vertical, signed as w; half: at half of the time. make_flat_slides.py\n")
        out.write("I_X,I_Z,mu,v0,w0,time,distance,turn,v_half,w_half,distance_half,turn_half\n")
        for IX, IZ, mu, v, w, what in rows:
            r = slide(IZ, mu, v, w); out.write(",".join([repr(x) for x in (IX, IZ, mu, v, w)]+[mp.nstr(x, 17) for x in r])+"\n"); out.flush()
            line = "%-9s %-34s T %s" % (name, what, mp.nstr(r[0], 12))
            if v and w:
                S = v+abs(w); q = slide(IZ, mu, v, w, M(1)/4); line += "  panels halved: %.0e" % max(abs(a-b) for a, b in zip(r, q))
                d = direct(IZ, mu, v, w, float(r[0]/2)); line += "  direct from the face: %.1e" % max(abs(a-b)/c for a, b, c in zip(d, r[3:], (S, S, S*S/mu, S*S/mu)))
            print(line, flush=True)
