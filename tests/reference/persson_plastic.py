"""Areas of persson-plastic by mpmath with 60 digits, at p over H and E g over H. Writes
persson_plastic.csv.

Pressures diffuse between two absorbing ends, 0 and H: V = (.45 + .55 A) (E g)^2/4 and
A_el = SUM_(n odd) 4/(n pi) sin(n pi p/H) e_n,    A_pl = p/H - SUM_n (-1)^(n+1) 2/(n pi) sin(n pi p/H) e_n,
e_n = exp(-(n pi)^2 V/(2 H^2)): summed as printed, with as many terms as those digits need, or by images
where those are fewer. A = A_el + A_pl is found by bisection of its sign and then the secant.
"""

from pathlib import Path

from mpmath import erf, erfc, exp, findroot, mp, mpf, pi, sin, sqrt

mp.dps = 60
PRESSURES = ["1e-9", "1e-6", "1e-3", "0.03", "0.2", "0.5", "0.8", "0.97", "0.999", "0.999999"]
PRESSURES += ["0.999999999"]
STRAINS = ["1e-3", "0.01", "0.1", "0.3", "0.5", "0.57", "0.65", "0.75", "0.84", "0.9", "1.2", "2"]
STRAINS += ["5", "30", "1e4"]
GAMMA = mpf("0.45")


def by_waves(x, v):
    elastic, plastic, n = mpf(0), x, 1
    while (decay := exp(-((n * pi) ** 2) * v / 2)) > mpf(10) ** -70:
        wave = 2 / (n * pi) * sin(n * pi * x) * decay
        elastic += 2 * wave if n % 2 else 0
        plastic -= wave if n % 2 else -wave
        n += 1
    return elastic, plastic


def by_images(x, v):
    s = sqrt(2 * v)
    plastic = sum(erfc((2 * k + 1 - x) / s) - erfc((2 * k + 1 + x) / s) for k in range(12))
    beside = sum(erfc((2 * k + 2 - x) / s) - erfc((2 * k + 2 + x) / s) for k in range(12))
    return erf(x / s) + beside - plastic, plastic


for x, v in [("0.3", "0.2"), ("0.999", "0.5"), ("1e-6", "0.05")]:
    both = [sum(form(mpf(x), mpf(v))) for form in (by_waves, by_images)]
    assert abs(both[0] / both[1] - 1) < mpf(10) ** -45, both

rows = ["p_over_H,Eg_over_H,area,plastic_area"]
for x_text in PRESSURES:
    for strain_text in STRAINS:
        # The numbers that a program reads, in double precision.
        x, full = mpf(float(x_text)), mpf(float(strain_text)) ** 2 / 4

        def parts(area):
            v = (GAMMA + (1 - GAMMA) * area) * full
            return by_images(x, v) if v < mpf("0.5") else by_waves(x, v)

        low, high = x, mpf(1)
        for _ in range(60):
            middle = sqrt(low * high)
            low, high = (middle, high) if middle < sum(parts(middle)) else (low, middle)
        ends = (low * (1 - mpf(10) ** -20), high * (1 + mpf(10) ** -20))
        area = findroot(lambda a: a - sum(parts(a)), ends, solver="secant", tol=mpf(10) ** -110)
        assert abs(area / low - 1) < mpf(10) ** -12
        numbers = [mp.nstr(number, 25) for number in (area, parts(area)[1])]
        rows.append(",".join([x_text, strain_text] + numbers))
Path(__file__).with_name("persson_plastic.csv").write_text("\n".join(rows) + "\n")
