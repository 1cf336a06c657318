"""ln F of Greenwood & Williamson where F is nearly 1 N: the logarithms of scale and factor cancel.

python3 ln_force.py > ln_force.csv; needs mpmath. Every input is taken as the double that it is read as.
"""
import random
from math import exp

from mpmath import mp, mpf, pcfu, exp as mexp, gamma, log, pi, sqrt

mp.dps = 40
E, R, ETA, SIGMA = mpf(1e11), mpf(1e-4), mpf(1e9), mpf(1e-6)


def ln_force(s, nominal_area):
    # int_0^inf t^1.5 phi(s + t) dt = gamma(5/2) exp(-s^2/4) U(2, s) / sqrt(2 pi).
    s = mpf(s)
    integral = gamma(mpf(5) / 2) * mexp(-s * s / 4) * pcfu(2, s) / sqrt(2 * pi)
    unit = mpf(4) / 3 * E * sqrt(R) * SIGMA * sqrt(SIGMA)
    return log(ETA * mpf(nominal_area) * unit * integral)


random.seed(17)
print("separation,nominal_area,ln_force")
for _ in range(100):
    s = random.uniform(5, 30)
    nominal_area = exp(-float(ln_force(s, 1.0)) + random.uniform(-0.1, 0.1))
    print(f"{s!r},{nominal_area!r},{mp.nstr(ln_force(s, nominal_area), 20)}")
