#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Appends (or renews) the column amp of reference CSVs: how strongly rounding errors made on the way are amplified.
amp(t) = max over s<=t, over theta,wX,wY,wZ at s, of |d Y(t)/d y_j(s)| * |y_j(s)|, Y the largest of theta,phi,psi,x/a,z/a,w sqrt(a/g).
Double-precision variational equations (complex step), good to a few per cent: an order of magnitude, not a reference value.
A double-precision run should be expected at about (1..20) * amp * 1.1e-16 * sqrt(steps), never below amp*1e-16."""
import csv, sys, numpy as np
from scipy.integrate import solve_ivp
def one(fn):
    L = open(fn).read().splitlines(); par = {}
    for l in L[:3]:
        for w in l.split():
            if '=' in w and not w.startswith('I_'):
                k, v = w.split('=', 1)
                try: par[k] = float(v)
                except ValueError: pass
    L = [l for l in L if not l.startswith('# amp')]
    hd = [l for l in L if l[0] == '#']; rows = list(csv.reader(l for l in L if l[0] != '#'))
    n = len(rows[0]) - (rows[0][-1] == 'amp'); rows = [r[:n] for r in rows]
    D = np.array([[float(v) for v in r[:9]] for r in rows[1:]]); M, a, b, g = [par[k] for k in 'Mabg']
    tn = (a/g)**.5; B = b/a; IX = (1+B*B)/4; IZ = 2*IX; J = IX+1
    def f(y):                                             # natural units
        th, X, Y, Z, ph, ps, x, z = y; s, c = np.sin(th), np.cos(th); T = s/c
        return np.array([X, (-(IZ+1)*Y*Z - IX*Y*Y*T + s)/J, X*Y*T + IZ/IX*Z*X, X*Y/(IZ+1), Y/c, Z+Y*T, -Z*np.cos(ph)+X*c*np.sin(ph), Z*np.sin(ph)+X*c*np.cos(ph)])
    def F(t, w):
        y = w[:8]; P = w[8:].reshape(8, 4); S = y[:, None] + 1e-30j*P     # directional complex steps: f'(y) P
        G = f(S).imag*1e30
        return np.concatenate([f(y), G.ravel()])
    t = D[:, 0]/tn; y0 = np.array([D[0,1], D[0,6]*tn, D[0,7]*tn, D[0,8]*tn, 0, 0, 0, 0])
    P0 = np.zeros((8, 4)); P0[:4] = np.eye(4)
    ev = lambda q, w: w[1]
    so = solve_ivp(F, (0, t[-1]), np.concatenate([y0, P0.ravel()]), method='DOP853', rtol=1e-10, atol=1e-13, dense_output=True, events=ev)
    ss = np.unique(np.concatenate([np.linspace(0, t[-1], 400), t, so.t_events[0]]))
    W = so.sol(ss); ys = W[:8].T; Ps = W[8:].T.reshape(-1, 8, 4)
    inv = np.linalg.inv(Ps[:, :4]); A = inv*np.abs(ys[:, None, :4])        # columns: scaled unit perturbation at s, carried to 0
    zs = ys[:, 7] + 1j*ys[:, 6]; dphs = np.einsum('sj,sjk->sk', Ps[:, 4], A); dpss = np.einsum('sj,sjk->sk', Ps[:, 5], A)
    dzs = np.einsum('sj,sjk->sk', Ps[:, 7] + 1j*Ps[:, 6], A)
    amp = []
    for q in t:
        w = so.sol(q); P = w[8:].reshape(8, 4); k = ss <= q*(1+1e-15)
        dd = np.abs(np.einsum('ij,sjk->sik', P[:4], A[k])).max()
        dph = np.abs(P[4] @ A[k] - dphs[k]).max(); dps = np.abs(P[5] @ A[k] - dpss[k]).max()
        zt = w[7] + 1j*w[6]; dz = (P[7] + 1j*P[6]) @ A[k] - dzs[k] - 1j*dphs[k]*(zt - zs[k])[:, None]
        amp.append(max(dd, dph, dps, np.abs(dz).max()))
    with open(fn, 'w') as o:
        o.write('\n'.join(hd) + "\n# amp: amplification of relative rounding errors made before t (order of magnitude; see add_amp.py); double precision reaches about amp*1e-15\n")
        o.write(','.join(rows[0] + ['amp']) + '\n')
        for r, v in zip(rows[1:], amp): o.write(','.join(r) + ',%.2g\n' % v)
    print('%-34s' % fn, ' '.join('%.3g:%.1e' % (p, v) for p, v in zip(D[:, 0], amp)), flush=True)
for fn in sys.argv[1:]: one(fn)
