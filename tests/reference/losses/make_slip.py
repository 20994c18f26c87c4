#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reference: a coin that slips with Coulomb friction until it rolls.  Natural units M=a=g=1.  Taylor order 46 in t.
usage: make_slip.py [NAME..]"""
import sys,time
from decimal import Context
import jets
from jets import *
from make_losses import sincos_fx, agree, ORDER
import mpmath as mpm
P=jets.PREC
KEEP=Context(prec=18)
def sig(v): return format(KEEP.create_decimal(dec(v,30)).normalize(KEEP),'f')
N_=['wX','wY','wZ','vX','vh','s','c','sf','cf','th','phi','psi','x','z','W']
ix={k:i for i,k in enumerate(N_)}
def slip_system(b,mu):
    b=Fraction(b); mu=Fraction(mu); IX=(1+b*b)/4; IZ=2*IX
    S=System(); wX,wY,wZ,vX,vh,s,c,sf,cf,th,phi,psi,x,z,W=[S.state() for _ in range(15)]
    q=(c*0+1)/c; r=wY*q; T=s*q
    uX=vX+wZ; uh=vh-wX*c
    if mu:
        rho=(uX*uX+uh*uh); ir=rho.pw(Fraction(-1,2)); nX=uX*ir; nh=uh*ir
    else: rho=(uX*uX+uh*uh); nX=nh=uX*0
    gy=-((wY*wZ)*(IZ/IX))-(wY*wY)*T          # wX' without forces
    num=(-((wX*wX)*c)-(s*gy))+1
    den=(s*(s+(nh*c)*mu))*(1/IX)+1
    N=num/den
    FX=-(N*nX)*mu; Fh=-(N*nh)*mu
    dwX=gy+(N*s-Fh*c)*(1/IX)
    S.rhs={wX:dwX,wY:wX*(wY*T+wZ*(IZ/IX)),wZ:FX*(1/IZ),vX:FX-r*vh,vh:Fh+r*vX,s:c*wX,c:-(s*wX),sf:r*cf,cf:-(r*sf),th:wX*1,phi:r*1,psi:wZ+wY*T,
           x:vX*cf+vh*sf, z:vh*cf-vX*sf, W:-(FX*uX+Fh*uh)}
    S.N=N; S.u=(uX,uh); return S
def roll_system(b):
    b=Fraction(b); IX=(1+b*b)/4; IZ=2*IX; J=IX+1;K=IZ+1
    S=System(); wX,wY,wZ,vX,vh,s,c,sf,cf,th,phi,psi,x,z,W=[S.state() for _ in range(15)]
    q=(c*0+1)/c; r=wY*q; T=s*q
    dX=s*(1/J)-(wY*wZ)*(K/J)-(wY*wY)*T*(IX/J); dZ=(wX*wY)*(1/K)
    # vX=-wZ, vh=wX c
    S.rhs={wX:dX,wY:wX*(wY*T+wZ*(IZ/IX)),wZ:dZ,vX:-dZ,vh:dX*c-(wX*wX)*s,s:c*wX,c:-(s*wX),sf:r*cf,cf:-(r*sf),th:wX*1,phi:r*1,psi:wZ+wY*T,x:vX*cf+vh*sf,z:vh*cf-vX*sf,W:c*0}
    S.N=-(dX*s+(wX*wX)*c)+1
    S.FX=-(dZ-wX*wY); S.Fh=-((wX*wX)*s-dX*c-r*wZ)
    return S
def energy(b,v):
    b=Fraction(b); IX=(1+b*b)/4; IZ=2*IX; f=lambda k:v[ix[k]]; sq=lambda a:(a*a)>>P; mul=lambda a,r:a*r.numerator//r.denominator
    return (sq(f('vX'))+sq(f('vh'))+sq((f('wX')*f('s'))>>P)+mul(sq(f('wX'))+sq(f('wY')),IX)+mul(sq(f('wZ')),IZ))//2+f('c')
def umag(v):
    a=v[ix['vX']]+v[ix['wZ']]; h=v[ix['vh']]-((v[ix['wX']]*v[ix['c']])>>P); return isqrt(a*a+h*h),a,h
def go(b,mu,v,times,tolbits):
    S=slip_system(b,mu) ; times=list(times); t=0; h=fx(Fraction(1,8)); out=[]; steps=0; tevent=None; mode='slip'; Nmin=None; fr=None
    while times:
        while True:
            cc=S.series(v,h,ORDER); tail=max(abs(q[ORDER])+abs(q[ORDER-1]) for q in cc)
            if tail.bit_length()<=P-tolbits:
                if mode=='slip' and mu:      # a straight slip would be carried through zero: go half way instead
                    r0,a0,h0=umag(v); w=[sum(q) for q in cc]; r1,a1,h1=umag(w)
                    if (a0*a1+h0*h1)<0: h=h*15//16; continue
                break
            h=h*3//4
        steps+=1
        n0=S.N.c[0]; Nmin=n0 if Nmin is None else min(Nmin,n0)
        hh=h
        while times and fx(times[0])<=t+h:
            xx=((fx(times[0])-t)<<P)//h; w=[horner(q,xx) for q in cc]; out.append((mode,times.pop(0),None,w))
        v=[sum(q) for q in cc]; t+=h
        if mode=='slip' and mu:
            r,a,hh_=umag(v)
            # rate of |u| at the new point
            c2=S.series(v,fx(Fraction(1,1<<40)),2)
            # stop when |u| < 1e-30: linear end
            if r < (ONE//10**30):
                # |u|' from the last step's slope: u(t)~ rho (t*-t): use derivative of uX,uh
                d=[((S.rhs[n].c[0])) for n in S.states]
                duX=d[ix['vX']]+d[ix['wZ']]; duh=d[ix['vh']]-((d[ix['wX']]*v[ix['c']])>>P)+((((v[ix['wX']]*v[ix['wX']])>>P)*v[ix['s']])>>P)
                rate=(a*duX+hh_*duh)//r     # d|u|/dt
                dt=-(r<<P)//rate; v=[p+((q*dt)>>P) for p,q in zip(v,d)]; t+=dt; tevent=t
                out.append(('event',None,t,list(v)))
                # rolling from here: project the velocity
                v[ix['vX']]=-v[ix['wZ']]; v[ix['vh']]=(v[ix['wX']]*v[ix['c']])>>P
                S=roll_system(b); mode='roll'; h=fx(Fraction(1,8))
                S.series(v,h,1); fr=(S.FX.c[0],S.Fh.c[0],S.N.c[0])
                continue
        if tail.bit_length()<P-tolbits-12: h=h*5//4
    return out,steps,Nmin,tevent,fr
def scene(name,note,b,mu,th,wX,wY,wZ,vX,vh,times):
    t0=time.time(); sn,cs=sincos_fx(th)
    v=[fx(q) for q in (wX,wY,wZ,vX,vh)]+[sn,cs,0,ONE,fx(th),0,0,0,0,0]
    o1,n1,_,_,_=go(b,mu,list(v),times,112); o2,n2,Nm,te,fr=go(b,mu,list(v),times,122)
    e0=energy(b,v); f=open(name+'.csv','w')
    f.write('# %s: %s\n# natural units M=a=g=1; ring b=%s; Coulomb mu=%r (%s, static = kinetic), exact doubles\n'%(name,note,b,mu,float(mu).hex()))
    f.write('# t=0: theta=%r wX=%r wY=%r wZ=%r vX=%r vh=%r (centre velocity along e_X and e_h=(sin phi,0,cos phi); phi=psi=x=z=0)\n'%(th,wX,wY,wZ,vX,vh))
    f.write('# rolls: 0 while it slips, 1 from where the slip ends on (the first such row, if any, is that moment).  W = energy lost.  digits = agreement of two step sizes (absolute, worst member)\n')
    f.write('rolls,t,theta,phi,psi,x,z,wX,wY,wZ,vX,vh,E,W,digits\n'); worst=99; bal=0
    for (m,t,tt,w),(m2,t2,tt2,w2) in zip(o1,o2):
        dg=min(agree(p,q) for p,q in zip(w,w2));
        if tt is not None: dg=min(dg,agree(tt,tt2))
        worst=min(worst,dg); E=energy(b,w2); bal=max(bal,abs(E+w2[ix['W']]-e0))
        f.write(','.join(['0' if m2=='slip' else '1',sig(tt2) if tt2 is not None else sig(fx(t2))]+[sig(w2[ix[k]]) for k in ('th','phi','psi','x','z','wX','wY','wZ','vX','vh')]+[sig(E),sig(w2[ix['W']]),'%.1f'%dg])+'\n')
    f.close()
    fl=lambda q:float(mpm.mpf(q)/ONE)
    print('%s: steps %d/%d agreement 1e-%.1f balance %.1e Nmin %.4f t_event %s F/N at rolling %s  %.1f s'%(name,n1,n2,worst,fl(bal),fl(Nm),dec(te,30) if te else None,'%.6f'%(((fl(fr[0])**2+fl(fr[1])**2)**.5)/fl(fr[2])) if fr else None,time.time()-t0)); sys.stdout.flush()
SC={
'slip_upright':('upright, sliding: rolls after v0 k3/(mu g (1+k3)) with v0/(1+k3)',0,0.25,0.0,0.0,0.0,0.0,1.5,0.0,[0.5,1,1.5,2.5,5]),
'slip_lean':('leaning, thrown with side slip, starts to roll',0,0.5,0.3,0.0,0.5,-0.5,1.0,0.4,[0.125,0.25,0.5,0.75,0.8125]),
'slip_free':('no friction at all: five integrals',0,0,0.3,0.1,0.8,0.5,0.3,-0.2,[0.5,1,2,5,10,20]),
}
if __name__=='__main__':
    for n in (sys.argv[1:] or SC): scene(n,*SC[n])
