#!/usr/bin/env python3
"""Contact with volumetric J2 plasticity (the rows of bem_j2.csv), beside which the cap of the boundary elements is tested.

Equations of tamaas 2.9.0 (EPIC: Polonsky & Keer's contact on a half-space whose upper layers yield, isotropic linear hardening, nu 0.3); the strain and the
contact are iterated together by Anderson mixing instead of one inside the other. E/(1 - nu^2) = 1, side 1, depth of the yielding layers 0.3.
Rough: the surfaces of asperity-bem (longest wave 1 per side, roll-off 2, shortest 4, Hurst 0.8, gradient g = 0.1); hardness and load over E g, yield
stress = hardness/2.8. Sphere: R = 1, yield stress 0.02, load over that of first yield. Hardening modulus over E of the body. Needs numpy, tamaas 2.9.0.
Residual: norm of the strain's residual over that of its increment (stops at 5e-4, or below 2.5e-3 if the area moved by less than 0.2 % over 12 evaluations,
or after 70). Run as (36 s to 6 min a row):
  bem_j2.py 64 24 "r:1:0.4:0.01:0.02/0.1 r:1:0.15:0.004:0.02/0.05 s:0:0:0.01:3/30" out.csv 5e-4
"""
import sys
import time, numpy as np, tamaas as tm
from tamaas.materials import IsotropicHardening
tm.set_log_level(tm.LogLevel.warning)


class Body:
    def __init__(s, h, depth, nz, sy, hard, nu=0.3, memory=10, mix=1.0):
        n = len(h)
        s.m = m = tm.ModelFactory.createModel(tm.model_type.volume_2d, [depth, 1.0, 1.0], [nz, n, n])
        m.nu, m.E = nu, 1 - nu**2
        s.h0, s.h = h - h.mean(), (h - h.mean()).copy()
        s.mat = IsotropicHardening(m, sigma_y=sy, hardening=hard * m.E)
        s.res = tm.Residual(m, s.mat)
        s.cs = tm.PolonskyKeerRey(m, s.h, 1e-10)
        s.cs.dump_freq = 10**9
        s.x = np.zeros_like(s.res.vector)
        s.mem, s.mix, s.evals = memory, mix, 0

    def step(s, x, p):
        s.res.computeResidualDisplacement(x)
        s.up = s.m.displacement[0, :, :, 2].copy()
        s.h[:] = s.h0 - s.up
        s.cs.solve(p)
        s.res.computeResidual(x)
        s.evals += 1
        return s.res.vector.copy()

    def solve(s, p, tol, most=150, say=False):
        t = time.time(); e0 = s.evals
        x = s.x.copy(); X, R = [], []; old = None; areas = []
        for it in range(most):
            r = s.step(x, p)
            err = np.linalg.norm(r) / max(np.linalg.norm(x), 1e-300)
            area = (s.m.traction[..., 2] > 0).mean(); areas.append(area)
            if say: print(it, err, area, flush=True)
            if err < tol: break
            if it > 30 and np.ptp(areas[-12:]) < 2e-3 * areas[-1] and err < 5 * tol: break
            if old is not None:
                X.append((x - old[0]).ravel()); R.append((r - old[1]).ravel())
                X, R = X[-s.mem:], R[-s.mem:]
            old = (x.copy(), r)
            new = x - s.mix * r
            if X:
                M = np.array([[a @ b for b in R] for a in R]); b = np.array([a @ r.ravel() for a in R])
                g = np.linalg.lstsq(M, b, rcond=1e-12)[0]
                d = sum(gi * (xi - s.mix * ri) for gi, xi, ri in zip(g, X, R))
                new = new - d.reshape(x.shape)
            x = new
        s.x = x
        return err, it + 1, time.time() - t

    def commit(s):
        s.res.updateState(s.x)
        s.x = np.zeros_like(s.x)


from bem_dense import surface, edges
from bem_dense import surface, edges
# Command line.
n,nz=int(sys.argv[1]),int(sys.argv[2]); what=sys.argv[3]; out=sys.argv[4]; tol=float(sys.argv[5])
def write(*row):
    print(*row,file=open(out,'a'),sep=',')
for case in what.split():
    kind,seed,H,hard,loads=case.split(':'); seed=int(seed); H=float(H); hard=float(hard); loads=[float(x) for x in loads.split('/')]
    if kind=='s':
        x=(np.arange(n)+.5)/n-.5; h=-(x[:,None]**2+x[None,:]**2)/2; sy=.02; Hc=2.8*sy; S=1.615/2.8
        wc=(np.pi*S*Hc/2)**2; unit=2/3*np.pi*wc*S*Hc
    else:
        h=surface(longest=1.,roll_off=2.,shortest=4.,hurst=.8,side=1.,gradient=.1,seed=seed,n=n); unit=.1; sy=H*.1/2.8
    b=Body(h,.3,nz,sy,hard)
    for f in loads:
        err,its,t=b.solve(f*unit,tol,70)
        p=b.m.traction[...,2]; c=p>0; e=edges(c,True)
        area=(c.sum()-(np.pi-1+np.log(2))/24*e)/c.size
        b.cs.solve(f*unit)
        gap=b.m.displacement[0,:,:,2]-b.h; gap=gap-gap.min(); 
        b.commit(); ps=b.m['plastic_strain']; bot=np.abs(ps[-1]).max()/max(np.abs(ps).max(),1e-99)
        write({"r": "rough", "s": "sphere"}[kind],seed,n,nz,H,hard,f,c.sum(),e,*["%.6g" % v for v in (area,gap.mean(),p.max()/sy,err)],its,"%.6g" % bot,"%.6g" % np.abs(ps).max())
