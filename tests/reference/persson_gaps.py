"""Mean gaps and stiffnesses of Persson's theory on power-law surfaces, by mpmath (17 digits) from the
elastic energy over wave numbers, as it is printed. Writes persson_gaps.csv.

C = q^(-2(1+H)) from 1 to qs, <h^2> = 2 pi INT q C dq, P(q) = erf(w p/E), w = (pi INT^q q^3 C)^(-1/2),
U = (pi E/2) INT q^2 C P (G + (1-G) P^2) dq, -du/dp = dU/dp / p, u = INT_p^oo (-du/dp) dp.
Columns: gap over sqrt(m0), stiffness -dp/du sqrt(m0)/(E g), at p over E g; moments m2 = g^2/2,
m4 = (3/4) pi INT q^5 C dq, alpha = m0 m4/m2^2.
"""

from pathlib import Path

from mpmath import e1, erf, exp, expm1, findroot, log1p, mp, mpf, pi, quad, sqrt

mp.dps = 17
LOADS = ["1e-8", "1e-3", "1e-1", "2"]
CASES = [("0.8", 8), ("0.8", 2), ("0.5", 40), ("1", 100)]


def integral(n, hurst, ln_qs):
    """INT_1^qs q^n C dq, without cancellation."""
    power = n - 1 - 2 * hurst
    return ln_qs if power == 0 else expm1(power * ln_qs) / power


def tail(t, share):
    """INT_t^oo [G + 3(1-G) erf^2 s] exp(-s^2) ds/s."""
    found = share / 2 * e1(t * t)
    if share < 1:
        ends = [t, t + 1, t + 2, t + 4, t + 7]
        touching = lambda s: erf(s) ** 2 * exp(-s * s) / s
        found += 3 * (1 - share) * quad(touching, ends, method="gauss-legendre", maxdegree=4)
    return found


rows = ["hurst,alpha,p_over_Eg,share,gap_over_sq,stiffness"]
for hurst_text, alpha in CASES:
    hurst = mpf(hurst_text)

    def bandwidth(ln_qs):
        one, three, five = (integral(n, hurst, ln_qs) for n in (1, 3, 5))
        return mpf(3) / 2 * one * five / three**2

    ln_qs = findroot(lambda x: bandwidth(x) - alpha, (mpf("0.5"), mpf(6)), solver="anderson")
    sq, gradient = (sqrt(2 * pi * integral(n, hurst, ln_qs)) for n in (1, 3))
    for load_text in LOADS:
        p = mpf(load_text) * gradient  # E = 1
        for share in (mpf(1), mpf("0.45")):

            def waves(x):
                """q^2 C w dq/dx and w p, with q = 1 + x^2: w is infinite at q = 1."""
                ln_q = log1p(x * x)
                w = 1 / sqrt(pi * integral(3, hurst, ln_q))
                return 2 * x * exp(-2 * hurst * ln_q) * w, w * p

            def gap_of(x):
                weight, t = waves(x)
                return weight * tail(t, share) if t < 12 else mpf(0)

            def fall_of(x):
                weight, t = waves(x)
                return weight * (share + 3 * (1 - share) * erf(t) ** 2) * exp(-t * t)

            last = sqrt(expm1(ln_qs))
            ends = [mpf(0)] + [last * mpf(2) ** (k - 34) for k in range(35)]
            gap = sqrt(pi) * quad(gap_of, ends, method="gauss-legendre", maxdegree=4)
            fall = sqrt(pi) / p * quad(fall_of, ends, method="gauss-legendre", maxdegree=5)
            numbers = [gap / sq, sq / fall / gradient]
            rows.append(
                ",".join([hurst_text, str(alpha), load_text, mp.nstr(share, 3)])
                + ","
                + ",".join(mp.nstr(x, 14) for x in numbers)
            )
            print(rows[-1], flush=True)
Path(__file__).with_name("persson_gaps.csv").write_text("\n".join(rows) + "\n")
