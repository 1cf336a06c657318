"""Laws between two unlike rough surfaces: the offset r of two asperities and their interference v,
one within the other, as Greenwood & Tripp describe them, in 64-bit mantissas with the nodes of
Gauss' rule by mpmath. Writes pairs_unlike.csv.

The first surface has the asperities of models_scenes.csv, the second .4 of their radius, 1.7 of their
density and .8 of their height standard deviation; separations are over that of the sum.
"""

import csv
from pathlib import Path

import numpy as np
from mpmath import mp, mpf
from mpmath.calculus.quadrature import GaussLegendre
from numpy import exp, sqrt

from hard_cases import Scene, law

mp.dps = 25
HERE = Path(__file__).parent
REAL = np.longdouble
PI = REAL(str(mp.pi))
RADIUS, DENSITY, STD = REAL("0.4"), REAL("1.7"), REAL("0.8")


def real(number):
    return REAL(mp.nstr(mpf(number), 25))


def laws(model, scene):
    """Kinks [m], force [N] and area [m^2] of one contact at an interference v [m]."""
    (unit, *force), (_, *area) = (law(model, of_area, scene, np, real) for of_area in (False, True))

    def scaled(scale, pieces):
        # All of v are between two kinks.
        return lambda v: scale * [f for kink, f in pieces if kink * unit <= v.mean()][-1](v / unit)

    return [kink * unit for kink, _ in force[1][1:]], scaled(*force), scaled(*area)


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
        e, nu, hardness, factor = (mpf(scene[name]) for name in ("equivalent_modulus", "poissons_ratio", "hardness", "pressure_factor"))
        radius = mpf("0.4") / mpf("1.4") * mpf(scene["asperity_radius"])
        both = Scene(e, 0, nu, hardness, factor, radius, 0, 0, 0)
        # r = sqrt(2 (beta_1 + beta_2) u)
        over = [sqrt(2 * (one + two) * k * std) for k in (0, REAL(1) / 2, 1, 2, 4, 7, 12)]
        for model in ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af"]:
            kinks, force, area = laws(model, both)
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
