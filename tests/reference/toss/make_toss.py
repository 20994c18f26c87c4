# SPDX-License-Identifier: MIT
"""make_toss.py SEED OUT PART: flights (flights.csv touches.csv), impacts or tosses; inputs are exact doubles; natural units (M = a = g = 1)"""
import sys, random, os, math
from newton import *
part = sys.argv[3]; rnd = random.Random(sys.argv[1]+part); out = sys.argv[2]; U = rnd.random; V = lambda a: a*(2*U()-1)
g17 = lambda x: ('%.17g' % x) if not isinstance(x, mpf) else mp.nstr(x, 30, strip_zeros=False, min_fixed=-4, max_fixed=8)
row = lambda f, *a: f.write(','.join(x if isinstance(x, str) else g17(x) for x in a)+'\n')
STATE = 'theta,phi,psi,x,z,wX,wY,wZ,y,vx,vy,vz'.split(',')
def body():
    k = rnd.choice(['disc', 'ring', 'body'])
    if k == 'disc': return .25, .5
    if k == 'ring': b = U(); i = (1+b*b)/4; return i, 2*i
    i = .1+.4*U(); return i, i*(.3+1.7*U())
def state(spin, high, th=None):
    w = [V(1), V(1), V(1)]; n = sum(x*x for x in w)**.5; w = [x/n*spin for x in w]
    th = V(1.5) if th is None else th
    return [th, V(3), V(3), V(1), V(1)]+w+[1+high, V(2), V(3), V(2)]
def special():
    import math; k = lambda x: x*(1+.1*V(1))
    return [
     ('tumble', .25, .5, state(8, 3)), ('fast', .25, .5, state(60, 5)), ('slow', .3, .5, state(.4, .5)), ('still', .25, .5, [k(.3), 1., 2., 0., 0., 0., 0., 0., k(2.), .5, k(.3), -.2]),
     ('flip', .25, .5, [k(.2), .7, .1, 0., 0., k(9.), 0., 0., k(3.), .2, k(2.), .1]),            # e_Z passes the vertical
     ('nearflip', .25, .5, [k(.2), .7, .1, 0., 0., k(9.), k(1e-7), k(1e-7), 3., .2, k(2.), .1]),
     ('axis', .25, .5, [k(.8), -2., 1., 0., 0., 0., 0., k(7.), k(4.), 1., 1., 1.]),            # spins about its axis
     ('upright', .25, .5, [0., .5, 0., 0., 0., 0., k(6.), 0., k(2.5), 0., k(1.), 0.]),
     ('flat', .25, .5, [1.5707, 1., 0., 0., 0., k(.2), k(.3), k(3.), k(1.5), .1, 0., 0.]),
     ('wobbler', .25, .5, [1.45, .3, 0., 0., 0., k(2.), k(1.), k(30.), k(3.), .1, k(2.), .1]),       # a nearly flat spinning throw
     ('hoop', .5, 1., state(12, 8)), ('hop', .25, .5, None)]
def hop():   # starts on the table, moving up
    s = state(4, 0); import math; s[8] = math.cos(s[0]); s[10] = abs(s[5])*1.0+1.5
    return s
if part == 'flights':
    with open(out+'/flights.csv', 'w') as f, open(out+'/touches.csv', 'w') as h:
        f.write('# a thin coin in the air, M = a = g = 1: after t the state with a suffix 1; phi1, psi1 in (-pi, pi]\n'); row(f, 'I_X', 'I_Z', 't', *STATE, *[x+'1' for x in STATE])
        h.write('# the first touch: its time, the rim\'s normal speed then (u_y) and the state then\n'); row(h, 'I_X', 'I_Z', *STATE, 't_touch', 'u_y', *[x+'1' for x in STATE])
        for name, IX, IZ, s in special():
            if s is None: s = hop()
            b = Body(IX, IZ, s)
            t, c = b.touch(mpf(40), mpf(10)**-3 if name == 'hop' else mpf(0)); row(h, IX, IZ, *s, t, c.rim()[1], *c.state()); print(name, mp.nstr(t, 20), mp.nstr(c.gap(), 3), flush=True)
            for x in (float(t)*(.1+.3*U()), float(t)*(.6+.39*U())): row(f, IX, IZ, x, *s, *b.fly(x).state())
        for i in range(8):
            IX, IZ = body(); s = state(10**(U()*1.3), 5*U()); s[8] += .1; b = Body(IX, IZ, s); t = float(b.touch(mpf(40))[0])*(.3+.65*U()); row(f, IX, IZ, t, *s, *b.fly(t).state())
if part == 'impacts':
    with open(out+'/impacts.csv', 'w') as f:
        f.write('# impacts: the state has gap 0; after it sticks (1) or slips (0), velocities with a suffix 1\n'); row(f, 'I_X', 'I_Z', 'mu_static', 'mu_kinetic', 'e', *STATE, 'sticks', 'wX1', 'wY1', 'wZ1', 'vx1', 'vy1', 'vz1'); n = 0
        import math
        while n < 50:
            IX, IZ = body(); s = state(10**(U()*1.5-.3), 0, V(1.57)); s[8] = math.cos(s[0]); s[9], s[11] = V(3), V(3); b = Body(IX, IZ, s)
            if b.rim()[1] > -.01: continue
            k = n % 5; mus, muk, e = [(math.inf, .3, 0.), (0., 0., .6), (1.2*.3, .3, .5), (.9, .8, .9), (.2, .2, 0.)][k]
            if k >= 2: muk = min(.1+.8*U(), 1.8*(IX*(1+IX))**.5); mus = muk*(1+.2*U()); e = [0, 0, U(), 1., 0.][k]
            a, st = b.impact(mpf(e), mp.inf if mus == math.inf else mpf(mus), mpf(muk)); q = a.state()
            assert a.energy() <= b.energy()+mpf(10)**-35
            row(f, IX, IZ, mus, muk, e, *s, '%d' % st, q[5], q[6], q[7], q[9], q[10], q[11]); n += 1
if part == 'tosses':
    with open(out+'/tosses.csv', 'w') as f:
        f.write('# tosses with 3 impacts, each of which bounces; the state at t_end, in the air\n'); row(f, 'I_X', 'I_Z', 'mu_static', 'mu_kinetic', 'e', 't_end', *STATE, 't1', 't2', 't3', *[x+'1' for x in STATE]); n = 0
        while n < 8:
            IX, IZ = body(); s = state(6*U(), 4*U()); mus, muk, e = [(math.inf, .3), (0., 0.), (.6, .5), (math.inf, .4)][n % 4]+(.6+.3*U(),); b = Body(IX, IZ, s); T = mpf(0); ts = []; ok = 1
            if b.gap() < 0: continue
            for i in range(3):
                t, c = b.touch(mpf(30), mpf(10)**-6 if i else mpf(0))
                if t is None: ok = 0; break
                T += t; ts.append(T)
                if c.rim()[1] > -.05: ok = 0; break
                b, _ = c.impact(mpf(e), mp.inf if mus == math.inf else mpf(mus), mpf(muk))
            if not ok: continue
            t4, _ = b.touch(mpf(30), mpf(10)**-6); dt = float(T+t4/2); b = b.fly(mpf(dt)-T); row(f, IX, IZ, mus, muk, e, dt, *s, *ts, *b.state()); print('toss', n, [mp.nstr(t, 8) for t in ts], flush=True); n += 1
