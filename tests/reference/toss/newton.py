# SPDX-License-Identifier: MIT
"""A thin coin in the air and at impact by Newton-Euler, not by closed forms: Euler's equations in axes fixed to the
body + quaternion, Taylor series of order N in steps; touches by dense sampling + bisection on the series; impacts by
the 9x9 linear system (6 of Newton-Euler, 3 of the law).  Natural units.  mpmath."""
from mpmath import mp, mpf, matrix, lu_solve, sin, cos, sqrt, atan2, pi, hypot
mp.dps = 42
N = 36
def quat(th, ph, ps):
    C1, S1, C2, S2, C3, S3 = cos(ph/2), sin(ph/2), cos(th/2), sin(th/2), cos(ps/2), sin(ps/2)
    return [C1*C2*C3+S1*S2*S3, C1*S2*C3+S1*C2*S3, S1*C2*C3-C1*S2*S3, C1*C2*S3-S1*S2*C3]
def rot(q):
    n = sum(x*x for x in q); w, x, y, z = q
    return [[(w*w+x*x-y*y-z*z)/n, 2*(x*y-w*z)/n, 2*(x*z+w*y)/n], [2*(x*y+w*z)/n, (w*w-x*x+y*y-z*z)/n, 2*(y*z-w*x)/n], [2*(x*z-w*y)/n, 2*(y*z+w*x)/n, (w*w-x*x-y*y+z*z)/n]]
def axes(th, ph):
    s, c, sf, cf = sin(th), cos(th), sin(ph), cos(ph)
    return [[cf, mpf(0), -sf], [s*sf, c, s*cf], [c*sf, -s, c*cf]]
def mv(A, v): return [sum(A[i][j]*v[j] for j in range(3)) for i in range(3)]
def tv(A, v): return [sum(A[j][i]*v[j] for j in range(3)) for i in range(3)]
def cross(a, b): return [a[1]*b[2]-a[2]*b[1], a[2]*b[0]-a[0]*b[2], a[0]*b[1]-a[1]*b[0]]
class Body:
    """state: q (body to table), w (in body axes), r, v"""
    def __init__(self, IX, IZ, s=None):
        self.IX, self.IZ = mpf(IX), mpf(IZ)
        if s is not None:
            th, ph, ps, x, z, wX, wY, wZ, y, vx, vy, vz = [mpf(a) for a in s]
            self.q = quat(th, ph, ps); E = axes(th, ph)
            w = [wX*E[0][i]+wY*E[1][i]+wZ*E[2][i] for i in range(3)]   # table frame
            self.w = tv(rot(self.q), w); self.r = [x, y, z]; self.v = [vx, vy, vz]
    def copy(self):
        b = Body(self.IX, self.IZ); b.q, b.w, b.r, b.v = self.q[:], self.w[:], self.r[:], self.v[:]; return b
    def state(self):
        """theta phi psi x z wX wY wZ y vx vy vz; phi, psi in (-pi, pi]"""
        R = rot(self.q); n = [R[i][2] for i in range(3)]; th = atan2(-n[1], hypot(n[0], n[2])); ph = atan2(n[0], n[2]); E = axes(th, ph)
        X = [R[i][0] for i in range(3)]  # the body's x axis
        ps = atan2(sum(X[i]*E[1][i] for i in range(3)), sum(X[i]*E[0][i] for i in range(3)))
        w = mv(R, self.w); om = [sum(w[i]*E[k][i] for i in range(3)) for k in range(3)]
        return [th, ph, ps, self.r[0], self.r[2], om[0], om[1], om[2], self.r[1], self.v[0], self.v[1], self.v[2]]
    def series(self):
        IX, IZ = self.IX, self.IZ; a1 = (IX-IZ)/IX; q = [[x] for x in self.q]; w = [[x] for x in self.w]
        cv = lambda a, b, k: sum(a[j]*b[k-j] for j in range(k+1))
        for k in range(N):
            f = mpf(1)/(k+1)
            d = [a1*cv(w[1], w[2], k), -a1*cv(w[0], w[2], k), mpf(0)]
            p = [[cv(q[i], w[j], k) for j in range(3)] for i in range(4)]
            # q' = q (0, w)/2, w in body axes
            dq = [-p[1][0]-p[2][1]-p[3][2], p[0][0]+p[2][2]-p[3][1], p[0][1]+p[3][0]-p[1][2], p[0][2]+p[1][1]-p[2][0]]
            for i in range(3): w[i].append(f*d[i])
            for i in range(4): q[i].append(f*dq[i]/2)
        return q, w
    def at(self, S, h):
        b = Body(self.IX, self.IZ); ev = lambda c: _horner(c, h)
        b.q = [ev(c) for c in S[0]]; b.w = [ev(c) for c in S[1]]
        n = sqrt(sum(x*x for x in b.q)); b.q = [x/n for x in b.q]
        b.r = [self.r[0]+self.v[0]*h, self.r[1]+self.v[1]*h-h*h/2, self.r[2]+self.v[2]*h]; b.v = [self.v[0], self.v[1]-h, self.v[2]]
        return b
    def step(self):
        return mpf(1)/(2*(sqrt(sum(x*x for x in self.w))+mpf(1)/4))
    def gap(self):
        R = rot(self.q); return self.r[1]-sqrt(R[1][0]**2+R[1][1]**2)
    def fly(self, t):
        b = self; t = mpf(t)
        while t > 0:
            h = min(b.step(), t); b = b.at(b.series(), h); t -= h
        return b
    def touch(self, tmax, skip=mpf(0)):
        """first zero of the gap after skip"""
        b, t = self, mpf(0)
        while t < tmax:
            h = b.step()
            if min(b.r[1], b.r[1]+b.v[1]*h-h*h/2) > 1: b = b.at(b.series(), h); t += h; continue   # no rim reaches down that far
            S = b.series(); n = 20; old = mpf(0) if t > 0 or skip == 0 else skip; g0 = b.at(S, old).gap()
            for i in range(1, n+1):
                x = h*i/n
                if x <= old: continue
                g = b.at(S, x).gap()
                if g < 0 <= g0:
                    lo, hi = old, x
                    for _ in range(12): m = (lo+hi)/2; lo, hi = (m, hi) if b.at(S, m).gap() >= 0 else (lo, m)
                    x0, x1 = lo, hi; g0, g1 = b.at(S, x0).gap(), b.at(S, x1).gap()
                    for _ in range(12):   # secant
                        if g1 == g0: break
                        x0, x1, g0 = x1, x1-g1*(x1-x0)/(g1-g0), g1
                        g1 = b.at(S, x1).gap()
                        if abs(x1-x0) < mpf(10)**-38: break
                    return t+x1, b.at(S, x1)
                old, g0 = x, g
            b = b.at(S, h); t += h
        return None, None
    def low(self):
        """from the centre to the lowest point of the rim"""
        R = rot(self.q); n = [R[i][2] for i in range(3)]; d = [n[1]*n[0], n[1]*n[1]-1, n[1]*n[2]]; m = sqrt(sum(x*x for x in d)); return [x/m for x in d]
    def rim(self):
        R = rot(self.q); w = mv(R, self.w); c = cross(w, self.low()); return [self.v[i]+c[i] for i in range(3)]
    def energy(self):
        return sum(x*x for x in self.v)/2+self.r[1]+(self.IX*(self.w[0]**2+self.w[1]**2)+self.IZ*self.w[2]**2)/2
    def solve(self, rows):
        """unknowns dV, dw (table frame), P: dV = P; I dw = r x P; 3 rows of the law: each (coefficients of dV, dw, P; right side)"""
        R = rot(self.q); D = [self.IX, self.IX, self.IZ]; I = [[sum(R[i][k]*D[k]*R[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
        r = self.low(); A = matrix(9, 9); b = matrix(9, 1)
        for i in range(3):
            A[i, i] = 1; A[i, 6+i] = -1
            for j in range(3): A[3+i, 3+j] = I[i][j]
        rx = [[0, -r[2], r[1]], [r[2], 0, -r[0]], [-r[1], r[0], 0]]
        for i in range(3):
            for j in range(3): A[3+i, 6+j] = -rx[i][j]
        for k, (row, rhs) in enumerate(rows):
            for j in range(9): A[6+k, j] = row[j]
            b[6+k] = rhs
        x = lu_solve(A, b); return [x[i] for i in range(9)]
    def impact(self, e, mus, muk):
        u = self.rim(); r = self.low()
        def du(i):  # the change of u_i: dV + dw x r
            row = [mpf(0)]*9; row[i] = mpf(1); j, k = (i+1) % 3, (i+2) % 3; row[3+j] += r[k]; row[3+k] -= r[j]; return row
        only = lambda i: [mpf(1) if j == 6+i else mpf(0) for j in range(9)]
        one = self.solve([(only(0), 0), (only(2), 0), (du(1), -u[1])])   # frictionless, plastic
        two = self.solve([(du(i), -u[i]) for i in range(3)])             # sticking, plastic
        mix = lambda f: [(1+e)*a+f*(b-a) for a, b in zip(one, two)]
        over = lambda x, mu: hypot(x[6], x[8])-mu*x[7]
        x = mix(mpf(1)); stick = mus == mp.inf or over(x, mus) <= 0
        if not stick:
            lo, hi = mpf(0), mpf(1)
            for _ in range(145): m = (lo+hi)/2; lo, hi = (m, hi) if over(mix(m), muk) < 0 else (lo, m)
            x = mix((lo+hi)/2)
        b = self.copy(); R = rot(self.q); dw = tv(R, x[3:6])
        b.v = [self.v[i]+x[i] for i in range(3)]; b.w = [self.w[i]+dw[i] for i in range(3)]
        return b, stick
def _horner(c, h):
    r = c[-1]
    for a in reversed(c[:-1]): r = r*h+a
    return r
