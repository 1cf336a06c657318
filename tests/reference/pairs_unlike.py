"""Laws between two unlike rough surfaces: the offset r of two asperities and their interference v,
one within the other, as Greenwood & Tripp describe them, in 64-bit mantissas with the nodes of
Gauss' rule by mpmath. Writes pairs_unlike.csv.

The first surface has the asperities of models_scenes.csv, the second .4 of their radius, 1.7 of their
density and .8 of their height standard deviation; separations are over that of the sum.
"""

import csv
from pathlib import Path

import numpy as np
from mpmath import mp
from mpmath.calculus.quadrature import GaussLegendre
from numpy import exp, log, sqrt

mp.dps = 25
HERE = Path(__file__).parent
REAL = np.longdouble
PI = REAL(str(mp.pi))
RADIUS, DENSITY, STD = REAL("0.4"), REAL("1.7"), REAL("0.8")


def laws(model, e, nu, hardness, factor, r):
    """Kinks [m], force [N] and area [m^2] of one contact of radius r at an interference v [m]."""
    wc = (PI * factor * hardness / (2 * e)) ** 2 * r
    unit = REAL(4) / 3 * e * sqrt(r) * wc * sqrt(wc)

    def scaled(ends, forces, areas, w=wc, f=unit):
        def piece(pieces, x):
            # All of x are between two kinks.
            return pieces[sum(x.mean() > end for end in ends)](x)

        return (
            [end * w for end in ends],
            lambda v: f * piece(forces, v / w),
            lambda v: PI * r * w * piece(areas, v / w),
        )

    hertz, plane = (lambda x: x * sqrt(x)), (lambda x: x)
    if model == "gw":
        return scaled([], [hertz], [plane])
    if model == "ceb":
        return scaled([1], [hertz, lambda x: 3 * x - REAL(3) / 2], [plane, lambda x: 2 * x - 1])
    if model == "ke":
        power = lambda c, p: lambda x: REAL(c) * x ** REAL(p)
        return scaled(
            [1, 6, 110],
            [hertz, power("1.03", "1.425"), power("1.4", "1.263"), lambda x: 3 / factor * x],
            [plane, power(".93", "1.136"), power(".94", "1.146"), lambda x: 2 * x],
        )
    if model == "etsion":
        return scaled(
            [1, 170],
            [hertz, lambda x: 1 + REAL("1.32") * (x - 1) ** REAL("1.27"), lambda x: 3 / factor * x],
            [plane, lambda x: 1 + REAL("1.19") * (x - 1) ** REAL("1.1"), lambda x: 2 * x],
        )
    if model == "af":
        k2 = 1 - wc / r
        return scaled(
            [1],
            [hertz, lambda x: x * sqrt(x) - sqrt(k2) * (x - 1) * sqrt(x - 1) + 3 * k2 * (x - 1)],
            [plane, lambda x: x + k2 * (x - 1)],
        )
    if model == "zmc":
        k, last = REAL(2) / 5, 54
        w1 = (3 * PI * k * hardness / (4 * e)) ** 2 * r
        t = lambda x: (x - 1) / (last - 1)
        area = lambda x: x * (1 + t(x) ** 2 * (3 - 2 * t(x)))
        pressure = lambda x: (1 - (1 - k) * log(last / x) / log(last)) / k
        force = lambda x: pressure(x) * area(x)
        return scaled(
            [1, last],
            [hertz, force, lambda x: 2 / k * x],
            [plane, area, lambda x: 2 * x],
            w1,
            k * hardness * PI * r * w1,
        )
    strength = hardness / REAL("2.8")
    c = REAL("1.295") * exp(REAL("0.736") * nu)
    strain = PI * c * strength / (2 * e)
    b, ends = REAL("0.14") * exp(23 * strength / e), [REAL("1.9")]
    area = lambda x: x * (x / ends[0]) ** b

    def force(x):
        limit = REAL("2.84") * (1 - exp(-REAL("0.82") * (strain * sqrt(area(x))) ** REAL("-0.7")))
        plastic = 4 * limit / c * (1 - exp(-(x ** (REAL(5) / 9)) / 25)) * x
        return exp(-(x ** (REAL(5) / 12)) / 4) * x * sqrt(x) + plastic

    w = strain**2 * r
    return scaled(ends, [hertz, force], [plane, area], w, REAL(4) / 3 * e * r * r * strain**3)


def nodes(degree):
    rule = GaussLegendre(mp).calc_nodes(degree, mp.prec)
    # From 0 to 1.
    return np.array([[REAL(str((1 + u) / 2)), REAL(str(weight / 2))] for u, weight in rule]).T


U, WEIGHTS = nodes(6)


def places(a, b, power=1):
    """Places between a and b, and their weights; with a power, cusps at a are smooth."""
    return a + (b - a) * U**power, (b - a) * WEIGHTS * power * U ** (power - 1)


def rows():
    for scene in csv.DictReader((HERE / "models_scenes.csv").open()):
        case = scene.pop("case")
        n = {key: REAL(value) for key, value in scene.items()}
        one, two = n["asperity_radius"], RADIUS * n["asperity_radius"]
        std = n["asperity_height_std"] * sqrt(1 + STD**2)
        pairs = 2 * PI * DENSITY * n["asperity_density"] ** 2 * n["nominal_area"]
        solid = (n["equivalent_modulus"], n["poissons_ratio"], n["hardness"], n["pressure_factor"])
        # r = sqrt(2 (beta_1 + beta_2) u)
        over = [sqrt(2 * (one + two) * k * std) for k in (0, REAL(1) / 2, 1, 2, 4, 7, 12)]
        for model in ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af"]:
            kinks, force, area = laws(model, *solid, one * two / (one + two))
            for s in ["0", "1.5", "3.5"]:
                d = REAL(s) * std
                inner = sorted({k * std for k in (REAL("0.3"), 1, 2, 4, 7)} | set(kinks))
                ends = [REAL(0)] + [v for v in inner if v < 12 * std] + [12 * std]
                found = np.zeros(4, REAL)
                for v, weights in (places(a, b, 4) for a, b in zip(ends, ends[1:])):
                    met = 0
                    for r, share in (places(a, b) for a, b in zip(over, over[1:])):
                        z = (d + v[:, None] + r * r / (2 * (one + two))) / std
                        met = met + (share * r * exp(-z * z / 2)).sum(axis=1)
                    met = met * pairs * weights / (sqrt(2 * PI) * std)
                    values = [force(v), area(v), sqrt(area(v) / PI), np.ones_like(v)]
                    found += [(met * value).sum() for value in values]
                names = ["force", "area", "contact-radius-sum", "contacts"]
                for name, value in zip(names, found):
                    digits = np.format_float_scientific(value, 16, unique=False)
                    yield [case, model, s, name, digits]


with (HERE / "pairs_unlike.csv").open("w", newline="") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["case", "model", "separation_over_sigma", "quantity", "value"])
    writer.writerows(rows())
