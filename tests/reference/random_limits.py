"""GW on random asperities where the spectrum is as narrow as can be, or very broad, by mpmath (25
digits): the hard cases of averages over heights and radii. Writes random_limits.csv.

Per nominal area, at separations h from the mean plane in sqrt(m0); m0 = 1e-12, m2 = 1e-4 and
m4 = alpha 1e4, E = 1e11 Pa. From the density of summits (Nayak) with the integrals over heights (parabolic
cylinder functions) and over k, below k_m, in closed form (1F1); that over k_m numerically.
"""

from pathlib import Path

from mpmath import exp, gamma, hyp1f1, mp, mpf, pcfd, pi, quad, sqrt

mp.dps = 25
E, M0, M2 = mpf("1e11"), mpf("1e-12"), mpf("1e-4")
BEYOND = ["1.5000001", "1.50001", "1.6", "1000", "1000000"]


def over_heights(n, a):
    """INT_0^oo w^n phi(a + w) dw."""
    return gamma(n + 1) * exp(-a * a / 4) * pcfd(-n - 1, a) / sqrt(2 * pi)


def value(alpha, quantity, h):
    m4 = alpha * M2**2 / M0
    s2, mu = m4 / 3, 3 * M2 / (2 * m4)
    sc = sqrt(M0 * (1 - 3 / (2 * alpha)))
    # Of w and of k in the law: F = 4/3 E k^(-1/2) w^(3/2), A = pi w/k.
    n, power, factor = {
        "force": (mpf(3) / 2, mpf(1) / 2, mpf(4) / 3 * E),
        "area": (mpf(1), mpf(1), pi),
    }[quantity]
    c = (4 - power) / 2  # k^(3 - power) dk = .. t^(c - 1) dt, t = k^2/(2 s2)

    def over_means(u):
        x = u * u
        over_radii = (2 * s2) ** (1 - power / 2) * x**c / c * hyp1f1(1, c + 1, -x)
        a = (h * sqrt(M0) - mu * sqrt(2 * s2) * u) / sc
        return exp(-x / 2) / sqrt(2 * pi) * over_radii * over_heights(n, a)

    # k_m = sqrt(2 s2) u; heights are met from u = middle on, over the width sc.
    unit = mu * sqrt(2 * s2)
    middle, width = h * sqrt(M0) / unit, sc / unit
    ends = {mpf(0), mpf(1), mpf(2), mpf(4), mpf(8), mpf(14)}
    ends |= {middle + k * width for k in (-12, -8, -5, -3, -1, 0, 1, 3, 5, 8, 12)}
    ends = sorted(u for u in ends if 0 <= u <= 14)
    return factor / (2 * pi * M2) * sc**n * quad(over_means, ends, maxdegree=7)


rows = ["alpha,mean_plane_separation_over_rms,quantity,value_per_nominal_area"]
for alpha in BEYOND:
    for quantity in ["force", "area"]:
        for h in ["-2", "0.5", "3", "5.5"]:
            found = value(mpf(alpha), quantity, mpf(h))
            rows.append(f"{alpha},{h},{quantity},{mp.nstr(found, 16)}")
            print(rows[-1], flush=True)
Path(__file__).with_name("random_limits.csv").write_text("\n".join(rows) + "\n")
