"""Rough surfaces with adhesion, by mpmath (25 digits) from the printed equations alone: the integrals
over the heights run over the contact radius a, not over the interference. Writes adhesion.csv.

One asperity: DMT F = (4/3) E sqrt(R) w^1.5 - 2 pi w_a R; JKR w = a^2/R - sqrt(2 pi w_a a/E),
F = 4 E a^3/(3 R) - sqrt(8 pi w_a E a^3), from w = 0 on approach, from dw/da = 0 on separation.
E = 1e9 Pa, R = 1e-4 m, eta = 1e9 1/m2, sigma_z = 1e-7 m, A_n = 1e-6 m2.
"""

from pathlib import Path

from mpmath import cbrt, exp, mp, mpf, pi, quad, sqrt

mp.dps = 25
E, R, ETA, SIGMA, AREA = mpf("1e9"), mpf("1e-4"), mpf("1e9"), mpf("1e-7"), mpf("1e-6")


def laws(model, work):
    """w, dw/da, F of a, and where the contact begins; w = 0 at no contact for DMT."""
    if model == "dmt":
        return (
            lambda a: a * a / R,
            lambda a: 2 * a / R,
            lambda a: mpf(4) / 3 * E * a**3 / R - 2 * pi * work * R,
            mpf(0),
        )
    begin = cbrt(2 * pi * work * R**2 / E) if model == "jkr" else cbrt(pi * work * R**2 / (8 * E))
    return (
        lambda a: a * a / R - sqrt(2 * pi * work * a / E),
        lambda a: 2 * a / R - sqrt(pi * work / (2 * E * a)),
        lambda a: 4 * E * a**3 / (3 * R) - sqrt(8 * pi * work * E * a**3),
        begin,
    )


def density(heights, z):
    """g(z sigma) sigma and minus its derivative by z."""
    if heights == "gaussian":
        g = exp(-z * z / 2) / sqrt(2 * pi)
        return g, z * g
    g = exp(-z) if z >= 0 else mpf(0)
    return g, g


def answers(model, work, heights, s):
    w, slope, force, begin = laws(model, mpf(work))
    z = lambda a: s + w(a) / SIGMA
    # Radii of the heights that count: panels between them.
    def radius(target):
        low, high = begin, begin + sqrt(R * SIGMA)
        if z(low) >= target:
            return low
        while z(high) < target:
            high = 2 * high
        for _ in range(120):
            middle = (low + high) / 2
            low, high = (middle, high) if z(middle) < target else (low, middle)
        return high

    first = max(z(begin), mpf(0) if heights == "exponential" else mpf(-14))
    # Down to exp(-75) of the largest density; from the deepest heights on, panels of one sigma.
    steps = [0.25, 0.5, 1, 2, 4, 8, 16, 32, 50, 75]
    if heights == "exponential":
        ends = [first] + [first + t for t in steps]
    elif first >= 1:
        ends = [first] + [first + t / first for t in steps]
    else:
        ends = [first] + [mpf(u) for u in range(-13, 15) if u > first]
    ends = [radius(z) for z in ends]
    # quad's tolerance is absolute: integrands of about 1.
    largest = density(heights, max(first, mpf(0)))[0]

    def per(q, weight=lambda z: density(heights, z)[0] / largest):
        unit = abs(q(ends[len(ends) // 2]))
        term = lambda a: q(a) / unit * weight(z(a)) * slope(a) / SIGMA
        return ETA * AREA * largest * unit * quad(term, ends)

    found = {
        "force": per(force),
        "area": per(lambda a: pi * a * a),
        "contacts": per(lambda a: mpf(1)),
        "contact-radius-sum": per(lambda a: a),
    }
    if heights == "gaussian":
        found["tangent"] = per(force, lambda z: density(heights, z)[1] / largest) / SIGMA
    return found


with open(Path(__file__).parent / "adhesion.csv", "w") as out:
    out.write("model,work_of_adhesion,heights,separation_over_sigma,quantity,value\n")
    for heights, places in [("gaussian", [-4, -1, 0, 1, 2, 4, 7]), ("exponential", [-1, 0, 3])]:
        for model in ["dmt", "jkr", "jkr-separation"]:
            for work in ["1e-3", "0.3", "10"]:
                delta = cbrt((3 * pi * mpf(work) / (4 * E)) ** 2 * R) / SIGMA
                for s in places:
                    # Where the joint is nearly open, on separation.
                    s = mpf(s) + (round(mpf("0.9") * delta) if model == "jkr-separation" else 0)
                    for quantity, value in answers(model, work, heights, s).items():
                        out.write(f"{model},{work},{heights},{mp.nstr(s, 12)},{quantity},{mp.nstr(value, 17)}\n")
