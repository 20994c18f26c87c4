# SPDX-License-Identifier: MIT
"""High-order Taylor integration of any ODE built of + - * / power: fixed-point integers, coefficients scaled by h^k."""
from fractions import Fraction
from math import isqrt
PREC = 230          # bits after the point
ONE = 1 << PREC
def fx(v):
    """exact double or Fraction or int to fixed point"""
    f = Fraction(v); return (f.numerator << PREC) // f.denominator
def sqrtfx(u): return isqrt(u << PREC)
class Node:
    __slots__ = ('c','op','a','b','e','sy')
    def __init__(n, sy, op, a=None, b=None, e=None):
        n.c=[]; n.op=op; n.a=a; n.b=b; n.e=e; n.sy=sy; sy.nodes.append(n)
    def __add__(n,o): return n.sy.add(n,o)
    __radd__=__add__
    def __sub__(n,o): return n.sy.add(n, n.sy.scale(o,-1) if isinstance(o,Node) else -Fraction(o))
    def __rsub__(n,o): return n.sy.add(n.sy.scale(n,-1), o)
    def __neg__(n): return n.sy.scale(n,-1)
    def __mul__(n,o): return n.sy.mul(n,o)
    __rmul__=__mul__
    def __truediv__(n,o): return Node(n.sy,'div',n,o) if isinstance(o,Node) else n.sy.scale(n,Fraction(1)/Fraction(o))
    def pw(n,e): return Node(n.sy,'pow',n,None,Fraction(e))
class Raw:
    """a constant given in fixed point"""
    def __init__(s,v): s.v=v
class System:
    def __init__(s): s.nodes=[]; s.states=[]; s.rhs={}
    def state(s): n=Node(s,'state'); s.states.append(n); return n
    def scale(s,n,k):
        return Node(s,'scale',n,None,k if isinstance(k,Raw) else Raw(fx(k)))
    def add(s,n,o):
        if isinstance(o,Node): return Node(s,'add',n,o)
        return Node(s,'addc',n,None,o if isinstance(o,Raw) else Raw(fx(o)))
    def mul(s,n,o):
        if isinstance(o,Node): return Node(s,'mul',n,o)
        return s.scale(n,o)
    def series(s, vals, h, order):
        """coefficients times h^k of every state; h fixed point"""
        for n in s.nodes: n.c=[]
        for n,v in zip(s.states,vals): n.c=[v]
        P=PREC
        for k in range(order+1):
            for n in s.nodes:
                op=n.op
                if op=='state': continue
                a=n.a.c
                if op=='add': n.c.append(a[k]+n.b.c[k])
                elif op=='addc': n.c.append(a[k]+(n.e.v if k==0 else 0))
                elif op=='scale': n.c.append((a[k]*n.e.v)>>P)
                elif op=='mul':
                    b=n.b.c; n.c.append(sum(map(int.__mul__, a[:k+1], b[k::-1]))>>P)
                elif op=='div':
                    b=n.b.c; t=(a[k]<<P)-(sum(map(int.__mul__, b[1:k+1], n.c[k-1::-1])) if k else 0)
                    n.c.append(t//b[0])
                elif op=='pow':
                    if k==0:
                        p,q=n.e.numerator,n.e.denominator; u=a[0]; r=u
                        while q>1: r=sqrtfx(r); q//=2      # denominators 1,2,4
                        v=ONE
                        for _ in range(abs(p)): v=(v*r)>>P
                        n.c.append(v if p>=0 else (ONE<<P)//v)
                    else:
                        p,q=n.e.numerator,n.e.denominator
                        t=sum((p*j-q*(k-j))*a[j]*n.c[k-j] for j in range(1,k+1))
                        n.c.append(t//(k*q*a[0]))
            if k<order:
                for n in s.states: n.c.append((s.rhs[n].c[k]*h>>P)//(k+1))
        return [n.c for n in s.states]
def horner(c,x):
    r=0
    for a in reversed(c): r=((r*x)>>PREC)+a
    return r
def dhorner(c,x):
    r=0
    for k in range(len(c)-1,0,-1): r=((r*x)>>PREC)+k*c[k]
    return r
def dec(v,d=36):
    s='-' if v<0 else ''; v=abs(v); n=(v*10**d+(ONE>>1))>>PREC; t=str(n).rjust(d+1,'0')
    return s+t[:-d]+'.'+t[-d:]
