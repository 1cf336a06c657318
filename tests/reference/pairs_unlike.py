"""Laws between two unlike rough surfaces, by mpmath (22 digits): the offset r of two asperities and
their interference v, one within the other, as Greenwood & Tripp describe them. Writes
pairs_unlike.csv.

The first surface has the asperities of models_scenes.csv, the second .4 of their radius, 1.7 of their
density and .8 of their height standard deviation; separations are over that of the sum.
"""

import csv
from pathlib import Path

from mpmath import exp, log, matrix, mp, mpf, pi, sqrt
from mpmath.calculus.quadrature import GaussLegendre

mp.dps = 22
HERE = Path(__file__).parent
RADIUS, DENSITY, STD = mpf(2) / 5, mpf(17) / 10, mpf(4) / 5


def laws(model, e, nu, hardness, factor, r):
    """Kinks [m], force [N] and area [m^2] of one contact of radius r at an interference v [m]."""
    wc = (pi * factor * hardness / (2 * e)) ** 2 * r
    unit = mpf(4) / 3 * e * sqrt(r) * wc**1.5

    def scaled(ends, forces, areas, w=wc, f=unit):
        def piece(pieces, x):
            return pieces[sum(x > end for end in ends)](x)

        return (
            [end * w for end in ends],
            lambda v: f * piece(forces, v / w),
            lambda v: pi * r * w * piece(areas, v / w),
        )

    hertz, plane = (lambda x: x * sqrt(x)), (lambda x: x)
    if model == "gw":
        return scaled([], [hertz], [plane])
    if model == "ceb":
        return scaled([1], [hertz, lambda x: 3 * x - mpf(3) / 2], [plane, lambda x: 2 * x - 1])
    if model == "ke":
        power = lambda c, p: lambda x: mpf(c) * x ** mpf(p)
        return scaled(
            [1, 6, 110],
            [hertz, power("1.03", "1.425"), power("1.4", "1.263"), lambda x: 3 / factor * x],
            [plane, power(".93", "1.136"), power(".94", "1.146"), lambda x: 2 * x],
        )
    if model == "etsion":
        return scaled(
            [1, 170],
            [hertz, lambda x: 1 + mpf("1.32") * (x - 1) ** mpf("1.27"), lambda x: 3 / factor * x],
            [plane, lambda x: 1 + mpf("1.19") * (x - 1) ** mpf("1.1"), lambda x: 2 * x],
        )
    if model == "af":
        k2 = 1 - wc / r
        return scaled(
            [1],
            [hertz, lambda x: x * sqrt(x) - sqrt(k2) * (x - 1) ** 1.5 + 3 * k2 * (x - 1)],
            [plane, lambda x: x + k2 * (x - 1)],
        )
    if model == "zmc":
        k, last = mpf(2) / 5, 54
        w1 = (3 * pi * k * hardness / (4 * e)) ** 2 * r
        t = lambda x: (x - 1) / (last - 1)
        area = lambda x: x * (1 + t(x) ** 2 * (3 - 2 * t(x)))
        pressure = lambda x: (1 - (1 - k) * log(last / x) / log(last)) / k
        force = lambda x: pressure(x) * area(x)
        return scaled(
            [1, last],
            [hertz, force, lambda x: 2 / k * x],
            [plane, area, lambda x: 2 * x],
            w1,
            k * hardness * pi * r * w1,
        )
    strength = hardness / mpf("2.8")
    c = mpf("1.295") * exp(mpf("0.736") * nu)
    strain = pi * c * strength / (2 * e)
    b, ends = mpf("0.14") * exp(23 * strength / e), [mpf("1.9")]
    area = lambda x: x * (x / ends[0]) ** b

    def force(x):
        limit = mpf("2.84") * (1 - exp(-mpf("0.82") * (strain * sqrt(area(x))) ** mpf("-0.7")))
        plastic = 4 * limit / c * (1 - exp(-(x ** (mpf(5) / 9)) / 25)) * x
        return exp(-(x ** (mpf(5) / 12)) / 4) * x * sqrt(x) + plastic

    w = strain**2 * r
    return scaled(ends, [hertz, force], [plane, area], w, mpf(4) / 3 * e * r * r * strain**3)


NODES = GaussLegendre(mp).calc_nodes(6, mp.prec)


def integral(f, ends, power=1):
    """Gauss' rule between these ends; with a power, cusps at the lower ends are smooth."""
    total = 0
    for a, b in zip(ends, ends[1:]):
        for u, weight in NODES:
            t = (1 + u) / 2
            total += (b - a) / 2 * weight * power * t ** (power - 1) * f(a + (b - a) * t**power)
    return total


def rows():
    for scene in csv.DictReader((HERE / "models_scenes.csv").open()):
        case = scene.pop("case")
        n = {key: mpf(value) for key, value in scene.items()}
        one, two = n["asperity_radius"], RADIUS * n["asperity_radius"]
        std = n["asperity_height_std"] * sqrt(1 + STD**2)
        pairs = 2 * pi * DENSITY * n["asperity_density"] ** 2 * n["nominal_area"]
        solid = (n["equivalent_modulus"], n["poissons_ratio"], n["hardness"], n["pressure_factor"])
        for model in ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af"]:
            kinks, force, area = laws(model, *solid, one * two / (one + two))
            for s in ["0", "1.5", "3.5"]:
                d = mpf(s) * std
                inner = sorted({k * std for k in (mpf(".3"), 1, 2, 4, 7)} | set(kinks))
                ends = [mpf(0)] + [v for v in inner if v < 12 * std] + [12 * std]
                # r = sqrt(2 (beta_1 + beta_2) u)
                over = [sqrt(2 * (one + two) * k * std) for k in (0, mpf(".5"), 1, 2, 4, 7, 12)]

                def found(v):
                    place = lambda r: (d + v + r * r / (2 * (one + two))) / std
                    density = lambda r: r * exp(-(place(r) ** 2) / 2) / (sqrt(2 * pi) * std)
                    met = pairs * integral(density, over)
                    q = [force(v), area(v), sqrt(area(v) / pi), mpf(1)]
                    return matrix([met * value for value in q])

                names = ["force", "area", "contact-radius-sum", "contacts"]
                for name, value in zip(names, integral(found, ends, 4)):
                    yield [case, model, s, name, mp.nstr(value, 16)]
                print(case, model, s, flush=True)


with (HERE / "pairs_unlike.csv").open("w", newline="") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["case", "model", "separation_over_sigma", "quantity", "value"])
    writer.writerows(rows())
