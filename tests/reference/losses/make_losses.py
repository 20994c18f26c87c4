#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reference trajectories of the coin with losses: natural units M=a=g=1 (disc or ring), Sundman time, Taylor order 46.
usage: make_losses.py [NAME..]   writes NAME.csv.   All inputs are exact doubles.  Two step sizes are run; digits = agreement."""
import sys, time
import jets
from jets import *
import mpmath as mpm
ORDER=46
def sincos_fx(v):
    mpm.mp.prec=jets.PREC+40; x=mpm.mpf(v)
    f=lambda t:int(mpm.nint(mpm.ldexp(t,jets.PREC)))
    return f(mpm.sin(x)),f(mpm.cos(x))
def build(b,L):
    """L: dict alpha,m1,sig,m2,m25,m4,mr,spin"""
    b=Fraction(b); IX=(1+b*b)/4; IZ=2*IX; J=IX+1; K=IZ+1
    S=System(); wX,wY,wZ,s,c,sf,cf,t,th,phi,psi,x,z,W=[S.state() for _ in range(14)]
    m=c*wX; n=c*wZ; e=wY*s; u=n+e; cm=c*m
    q=None
    def plus(a,b_): return b_ if a is None else a+b_
    g=None                                    # Q = -g u
    if L.get('m1') or L.get('mr'):
        sg=Fraction(L['sig']); r=(u*u+(c*c)*(sg*sg)).pw(Fraction(-1,2))
        if L.get('m1'): g=plus(g,r*Fraction(L['m1']))
        if L.get('mr'): g=plus(g,r*c*Fraction(L['mr']))
    if L.get('m2') or L.get('m25') or L.get('m4'): q=(c*0+1)/c
    if L.get('m2'): g=plus(g,q*Fraction(L['m2']))
    if L.get('m25'):
        au=u if L.get('usign',1)>0 else -u
        g=plus(g,(au*q).pw(Fraction(1,2))*q*Fraction(L['m25']))
    if L.get('m4'): g=plus(g,q*q*Fraction(L['m4']))
    A=s*(c*(1/J)-(wY*wY)*(IX/J))-(wY*n)*(K/J)
    B=wX*(e+n*(IZ/IX)); D=(wY*m)*(1/K); P=None
    if g is not None:
        Q=-(g*u); B=B+(Q*s)*(1/IX); D=D+(Q*c)*(1/K); P=-(Q*u)
    if L.get('alpha'):
        au=(u if L.get('usign',1)>0 else -u)*Fraction(L['alpha'])
        A=A-au*wX; B=B-au*wY; D=D-au*wZ
        P=plus(P,au*((wX*wX)*J+(wY*wY)*IX+(wZ*wZ)*K))
    if L.get('spin'):
        oy=(wY*c-wZ*s)*Fraction(L['spin']); occ=oy*c
        B=B-(occ*c)*(1/IX); D=D+(occ*s)*(1/K); P=plus(P,occ*(wY*c-wZ*s))
    S.rhs={wX:A,wY:B,wZ:D,s:cm,c:-(s*m),sf:wY*cf,cf:-(wY*sf),t:c*1,th:m*1,phi:wY*1,psi:u*1,x:c*(m*sf-wZ*cf),z:c*(wZ*sf+m*cf),W:P if P is not None else c*0}
    S.u=u; return S,(IX,IZ,J,K)
NAMES=['wX','wY','wZ','s','c','sf','cf','t','th','phi','psi','x','z','W']
ix={k:i for i,k in enumerate(NAMES)}
def run(b,L,th0,wX,wY,wZ,times,levels,tolbits,cstop=None):
    S,I=build(b,L); sn,cs=sincos_fx(th0)
    v=[fx(wX),fx(wY),fx(wZ),sn,cs,0,ONE,0,fx(th0),0,0,0,0,0]
    out=[]; times=list(times); levels=list(levels); steps=0
    h=fx(Fraction(1,4))
    def state(cc,xx): return [horner(q,xx) for q in cc]
    while times or levels:
        while True:
            cc=S.series(v,h,ORDER)
            # size of the last two terms of the dynamic variables and the pose
            tail=max(abs(q[ORDER])+abs(q[ORDER-1]) for q in cc)
            if tail.bit_length()<=jets.PREC-tolbits: break
            h=h*3//4
        steps+=1
        t=cc[ix['t']]; tend=sum(t); c=cc[ix['c']]; cend=sum(c)
        # events inside this step
        ev=[]
        while times and fx(times[0])<=tend:
            T=fx(times.pop(0)); xx=ONE*(T-v[ix['t']])//max(1,tend-v[ix['t']]) if tend>v[ix['t']] else 0
            for _ in range(60):
                d=dhorner(t,xx); dx=((horner(t,xx)-T)<<jets.PREC)//d; xx-=dx
                if abs(dx)<16: break
            ev.append(('t',T,xx))
        while levels and fx(levels[0])>=cend:
            l=fx(levels.pop(0)); lo,hi=0,ONE
            for _ in range(40):
                mid=(lo+hi)>>1
                if horner(c,mid)>l: lo=mid
                else: hi=mid
            xx=lo
            for _ in range(40):
                d=dhorner(c,xx); dx=((horner(c,xx)-l)<<jets.PREC)//d; xx-=dx
                if abs(dx)<16: break
            ev.append(('c',l,xx))
        for k,val,xx in sorted(ev,key=lambda e:e[2]): out.append((k,val,state(cc,xx)))
        v=[sum(q) for q in cc]
        if tail.bit_length()<jets.PREC-tolbits-12: h=h*5//4
    return out,steps,I
def E_of(I,v):
    IX,IZ,J,K=I; f=lambda k:v[ix[k]]
    sq=lambda a:(a*a)>>jets.PREC
    mul=lambda a,r:a*r.numerator//r.denominator
    return (mul(sq(f('wX')),J)+mul(sq(f('wY')),IX)+mul(sq(f('wZ')),K))//2+f('c')
def agree(a,b):
    d=abs(a-b);
    return 99 if d==0 else -float(mpm.log10(mpm.mpf(d)/ONE))
def scene(name,note,b,L,th0,wX,wY,wZ,times,levels):
    t0=time.time()
    o1,n1,I=run(b,L,th0,wX,wY,wZ,times,levels,112)
    o2,n2,_=run(b,L,th0,wX,wY,wZ,times,levels,122)
    f=open(name+'.csv','w')
    f.write('# %s: %s\n# natural units M=a=g=1; ring b=%s; losses %s (exact doubles)\n'%(name,note,b,', '.join('%s=%r (%s)'%(k,v,float(v).hex()) for k,v in L.items())))
    f.write('# t=0: theta=%r wX=%r wY=%r wZ=%r (exact doubles), phi=psi=x=z=0\n'%(th0,wX,wY,wZ))
    f.write('# rows at times, and where cos(theta) first equals a round value; W = energy lost so far; digits = agreement of two step sizes (worst member, absolute)\n')
    f.write('t,theta,phi,psi,x,z,wX,wY,wZ,cos_theta,E,W,digits\n')
    worst=99; bal=0
    for (k,val,v),(k2,val2,w) in zip(o1,o2):
        dg=min(agree(p,q) for p,q in zip(v,w)); worst=min(worst,dg)
        E=E_of(I,w);
        if not bal: E0=None
        f.write(','.join([dec(w[ix[q]],32) for q in ('t','th','phi','psi','x','z','wX','wY','wZ','c')]+[dec(E,32),dec(w[ix['W']],32),'%.1f'%dg])+'\n')
    f.close()
    # energy balance from the start
    S,I=build(b,L); sn,cs=sincos_fx(th0); v0=[fx(wX),fx(wY),fx(wZ),sn,cs,0,ONE,0,fx(th0),0,0,0,0,0]
    e0=E_of(I,v0); worstE=max(abs(E_of(I,v)+v[ix['W']]-e0) for _,_,v in o2)
    print('%s: steps %d/%d, worst agreement 1e-%.1f, energy balance %.1e, %.1f s'%(name,n1,n2,worst,float(mpm.mpf(worstE)/ONE),time.time()-t0)); sys.stdout.flush()
SC={}
def add(n,*a): SC[n]=a
add('alpha_generic',"Nakanishi's alpha on the scene generic",0,dict(alpha=0.05),0.5,0.1,0.8,1.2,[0.125,1,2.5,5,10,20,40],[])
add('dry_spin','dry contour friction, nutating spin: exponent 2/3',0,dict(m1=0.002,sig=0.0009765625),1.25,0.05,1.125,0.0,[0.125,1,5,20,40],[0.1,0.05,0.02])
add('visc_spin','viscous contour friction, nutating spin to nearly flat: exponent 1/2',0,dict(m2=0.0005),1.25,0.05,1.125,0.0,[0.125,1,5,20,40],[0.1,0.03,0.01,0.003,0.001])
add('layer_spin','boundary layer law |psi\'|^1.5: exponent 4/9',0,dict(m25=0.00025),1.25,0.05,1.125,0.0,[1,5,20],[0.1,0.03,0.01,0.003])
add('mixed_ring','ring b=0.5, all losses at once, rolling on a curve and falling over',0.5,dict(alpha=0.01,m1=0.004,sig=0.0009765625,m2=0.002,m25=0.001,m4=0.0005,spin=0.01),0.3,0.0,0.25,1.0,[0.125,1,5,10,20,40],[])
if __name__=='__main__':
    for n in (sys.argv[1:] or SC): scene(n,*SC[n])
