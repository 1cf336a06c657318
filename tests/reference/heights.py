#!/usr/bin/env python3
"""Reference values for heights that are not Gaussian (writes heights.csv), by tanh-sinh in mpmath, 28 digits.

Force and area are eta A_n INT q(w) g(d + w) dw, on panels that end at every kink of the law (those of hard_cases.py) and of the
density, poles included: tanh-sinh absorbs powers of the distance to the ends. The tangent is a difference of order 4 of the
force at steps of 1e-7 standard deviations: no derivative of law or density is used.
With names of densities, their rows are printed and nothing is written. A row is dropped unless two partitions agree to 1e-17 in force and area.
Densities have the mean 0 and the standard deviation 1e-6 m, and are named as in statrs; separations are multiples of 1e-6 m.
"""
import csv, pathlib, sys

from mpmath import mp, mpf

from hard_cases import Scene, law

mp.dps = 28
EXACT = mpf(10) ** -17
SCENE = Scene(E=116e9, G=41e9, nu=0.31, H=1.12e9, S=None, R=3.6e-4, eta=1.1e8, sigma=1e-6, An=3e-5)
SCENE = SCENE._replace(S=mpf("0.454") + mpf("0.41") * mpf("0.31"))
SCENE = Scene(*[mpf(repr(x)) if isinstance(x, float) else x for x in SCENE])


class Density:
    """A density on its own axis: mean, variance, support, and places where it is split for quadrature."""

    def __init__(self, pdf, mean, variance, low, high, places=()):
        self.pdf, self.mean, self.std = pdf, mpf(mean), mp.sqrt(variance)
        self.low, self.high = mpf(low), mpf(high)
        self.places = sorted(mpf(p) for p in places)


def beta(a, b):
    a, b = mpf(a), mpf(b)
    return Density(lambda x: x ** (a - 1) * (1 - x) ** (b - 1) / mp.beta(a, b), a / (a + b),
                   a * b / ((a + b) ** 2 * (a + b + 1)), 0, 1, ["0.05", "0.4", "0.8", "0.97"])


def gamma(k, rate):
    k, rate = mpf(k), mpf(rate)
    return Density(lambda x: rate ** k * x ** (k - 1) * mp.exp(-rate * x) / mp.gamma(k), k / rate, k / rate ** 2, 0, mp.inf,
                   [x / rate for x in (mpf("0.1"), 1, 3, 10, 25, 60)])


def weibull(k, scale):
    k, s = mpf(k), mpf(scale)
    one, two = mp.gamma(1 + 1 / k), mp.gamma(1 + 2 / k)
    return Density(lambda x: k / s * (x / s) ** (k - 1) * mp.exp(-(x / s) ** k), s * one, s * s * (two - one ** 2), 0, mp.inf,
                   [s * p for p in (mpf("0.1"), mpf("0.5"), 1, mpf("1.5"), 2, 3, 5, 10, 40)])


def log_normal(m, s):
    m, s = mpf(m), mpf(s)
    return Density(lambda x: mp.exp(-((mp.log(x) - m) / s) ** 2 / 2) / (x * s * mp.sqrt(2 * mp.pi)) if x > 0 else mpf(0),
                   mp.exp(m + s * s / 2), mp.expm1(s * s) * mp.exp(2 * m + s * s), 0, mp.inf,
                   [mp.exp(m + s * k) for k in range(-9, 19)])


def students_t(nu):
    nu = mpf(nu)
    c = mp.gamma((nu + 1) / 2) / (mp.sqrt(nu * mp.pi) * mp.gamma(nu / 2))
    return Density(lambda x: c * (1 + x * x / nu) ** (-(nu + 1) / 2), 0, nu / (nu - 2), -mp.inf, mp.inf,
                   [-30, -8, -3, -1, 0, 1, 3, 8, 30, 200])


def inverse_gamma(a, b):
    a, b = mpf(a), mpf(b)
    return Density(lambda x: b ** a / mp.gamma(a) * x ** (-a - 1) * mp.exp(-b / x) if x > 0 else mpf(0), b / (a - 1),
                   b * b / ((a - 1) ** 2 * (a - 2)), 0, mp.inf, [b * x for x in (mpf("0.01"), mpf("0.03"), mpf("0.1"), mpf("0.3"), 1, 3, 10, 100)])


def pareto(scale, a):
    s, a = mpf(scale), mpf(a)
    return Density(lambda x: a * s ** a / x ** (a + 1), a * s / (a - 1), s * s * a / ((a - 1) ** 2 * (a - 2)), s, mp.inf,
                   [s * x for x in (mpf("1.3"), 2, 5, 20, 300)])


def triangular(low, high, mode):
    low, high, mode = mpf(low), mpf(high), mpf(mode)
    return Density(lambda x: 2 / (high - low) * ((x - low) / (mode - low) if x < mode else (high - x) / (high - mode)),
                   (low + high + mode) / 3, (low ** 2 + high ** 2 + mode ** 2 - low * high - low * mode - high * mode) / 18,
                   low, high, [mode])


DENSITIES = {
    "normal": Density(lambda x: mp.exp(-x * x / 2) / mp.sqrt(2 * mp.pi), 0, 1, -mp.inf, mp.inf, [-8, -4, -1, 1, 3, 5, 8, 12]),
    "uniform(1,2)": Density(lambda x: mpf(1), "1.5", mpf(1) / 12, 1, 2),
    "triangular(0,3,1)": triangular(0, 3, 1),
    "laplace(0,1)": Density(lambda x: mp.exp(-abs(x)) / 2, 0, 2, -mp.inf, mp.inf, [-20, -5, 0, 2, 6, 15, 40]),
    "gumbel(0,1)": Density(lambda x: mp.exp(-x - mp.exp(-x)), mp.euler, mp.pi ** 2 / 6, -mp.inf, mp.inf, [-5, -3, -1, 0, 1, 3, 8, 20, 50]),
    "beta(2,3)": beta(2, 3),
    "beta(0.5,0.5)": beta("0.5", "0.5"),
    "gamma(2,1)": gamma(2, 1),
    "gamma(0.5,1)": gamma("0.5", 1),
    "weibull(2.5,3)": weibull("2.5", 3),
    "weibull(0.8,1)": weibull("0.8", 1),
    "log_normal(0,1)": log_normal(0, 1),
    "log_normal(0,2)": log_normal(0, 2),
    "log_normal(0,3)": log_normal(0, 3),
    "students_t(3)": students_t(3),
    "inverse_gamma(5,1)": inverse_gamma(5, 1),
    "pareto(1,4)": pareto(1, 4),
}
# Next to their ends and where slopes were lost; the others are looked at everywhere.
EXTRA = {
    "beta(2,3)": ["2.994"], "gamma(2,1)": ["-2.6", "12"], "log_normal(0,1)": ["-2.34"], "log_normal(0,2)": ["-2.99", "-0.136"],
    "log_normal(0,3)": ["-0.0110"], "students_t(3)": ["40", "1000"], "normal": ["9", "25"], "laplace(0,1)": ["30"],
    "beta(0.5,0.5)": ["1.414", "-1.41421"], "gamma(0.5,1)": ["-0.70711", "-0.7071"], "weibull(0.8,1)": ["-0.8975"],
}
SEPARATIONS = ["-3.1", "-1", "0", "1.7"]


def integral(q, kinks, density, d, fine):
    """INT q(x) g dz over x = (z - d)/w_c, z in standard deviations; d is one, too."""
    z = lambda place: (place - density.mean) / density.std
    low, high = max(z(density.low), d), z(density.high)
    if low >= high:
        return mpf(0)
    points = [z(p) for p in density.places] + [d + k for k in kinks]
    near = ("1e-6", "1e-3", "0.05", "0.3", "0.8", "2", "4") if fine else ("1e-5", "0.01", "0.1", "0.5", "1.2", "2.5", "5")
    points += [low + mpf(step) for step in near]
    if low < 0 and d < -20:
        points += [mpf(-2), mpf(2)]
    points = sorted({p for p in points if low < p < high} | {low, high})
    total = mpf(0)
    for a, b in zip(points, points[1:]):
        x = (a + b) / 2 if b != mp.inf else a + 1
        piece = max(k for k in range(len(kinks)) if d + kinks[k] < x)
        # Distances from the nearer end, so that poles keep their digits.
        f = lambda t: q[piece](t - d) * density.pdf(density.mean + density.std * t) * density.std
        if mp.isinf(b):
            total += mp.quad(f, [a, b])
            continue
        m = (a + b) / 2
        at_low = a == z(density.low)
        at_high = b == z(density.high)
        up = lambda u: q[piece](a + u - d) * density.pdf((density.low if at_low else density.mean + density.std * a) + density.std * u)
        down = lambda u: q[piece](b - u - d) * pdf_below(density, b, at_high, u)
        total += density.std * (mp.quad(up, [0, m - a]) + mp.quad(down, [0, b - m]))
    return total


def pdf_below(density, b, at_high, u):
    if at_high and density.high == 1 and density.low == 0:
        return BELOW_ONE[density](density.std * u)
    return density.pdf((density.high if at_high else density.mean + density.std * b) - density.std * u)


def values(name, density, model, d):
    force, area = ([quantity(model, area, density, d, fine) for fine in (False, True)] for area in (False, True))
    if any(abs(a - b) > EXACT * abs(b) for a, b in (force, area)):
        print(f"dropped: {name} {model} {d}: {force} {area}", file=sys.stderr)
        return None
    h = mpf(10) ** -7
    beside = [quantity(model, False, density, d + k * h, True) for k in (-2, -1, 1, 2)]
    slope = (8 * (beside[1] - beside[2]) - (beside[0] - beside[3])) / (12 * h) / SCENE.sigma
    return force[1], area[1], slope


def quantity(model, area, density, d, fine):
    unit, scale, pieces = law(model, area, SCENE, mp)
    c = unit / SCENE.sigma
    q = [lambda t, f=f: f(t / c) for _, f in pieces]
    return SCENE.eta * SCENE.An * scale * integral(q, [k * c for k, _ in pieces], density, d, fine)


BELOW_ONE = {}
for text in ("2,3", "0.5,0.5"):
    a, b = (mpf(x) for x in text.split(","))
    BELOW_ONE[DENSITIES[f"beta({text})"]] = lambda u, a=a, b=b: (1 - u) ** (a - 1) * u ** (b - 1) / mp.beta(a, b)


def main():
    path = pathlib.Path(__file__).with_name("heights.csv")
    names = sys.argv[1:] or list(DENSITIES)
    with path.open("w", newline="") if len(sys.argv) == 1 else sys.stdout as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["heights", "model", "separation", "force", "area", "tangent"])
        for name in names:
            density = DENSITIES[name]
            for d in SEPARATIONS + EXTRA.get(name, []):
                for model in ("gw", "ke", "jg") if d in SEPARATIONS else ("gw",):
                    found = values(name, density, model, mpf(d))
                    if found and found[0] > 0:
                        table.writerow([name, model, d] + [mp.nstr(v, 18, min_fixed=0, max_fixed=0) for v in found])
            file.flush()
            print(name, file=sys.stderr)


if __name__ == "__main__":
    main()
