#!/usr/bin/env python3
"""Reference values for Gao and AT with options drawn at random (writes lateral_cases.csv).

With y = x u, u = 1/cosh v and c = w_c/sigma, the average over heights, angles and azimuths is
        INT dy INT_0^inf dv tanh(v) psi(1/cosh v) <f(y, v, theta)>_theta c phi(s + c y cosh v),
three integrals one inside the other, each by Gauss rules on fixed panels: they end where a direction begins to slip, and shrink
geometrically towards every scale that the integrand has.  The last column is how
far two partitions of different orders differ, in units of the sum of sizes of the parts; rows above 1e-11 are dropped.
"""
import argparse, csv, functools, itertools, math, multiprocessing, sys, time
from collections import namedtuple

import numpy as np

from hard_cases import Scene, law_pieces

np.seterr(all="ignore")
HEADER = ("equivalent_modulus,equivalent_shear_modulus,poissons_ratio,hardness,pressure_factor,asperity_radius,"
          "asperity_density,asperity_height_std,nominal_area,model,quantity,displacement,stick,a20,"
          "separation_over_sigma,scaled,size,agreement").split(",")
Options = namedtuple("Options", "model quantity displacement stick a20")
Config = namedtuple("Config", "outer middle theta ratio")
FIRST, SECOND = Config(24, 38, 18, 12.0), Config(22, 34, 16, 20.0)
QUARTER = math.pi / 4


@functools.lru_cache(None)
def rule(count):
    """Gauss-Legendre in v with x = v^3 (10 - 15 v + 6 v^2) on [0, 1]: fractional powers at both ends become high ones."""
    v, w = np.polynomial.legendre.leggauss(count)
    v, w = (v + 1) / 2, w / 2
    return v ** 3 * (10 - 15 * v + 6 * v * v), w * 30 * (v * (1 - v)) ** 2


def part_of_octant(a, b, mu, kn, shear, quantity, count):
    """INT over theta in [0, pi/4] of f with q = a sin, p = b cos (arrays a, b)."""
    def f(q, p):
        q, p = np.minimum(q, 1), np.minimum(p, 1)
        if quantity == "stiffness":
            return np.sqrt(kn * kn + shear * ((1 - q) + (1 - p)))
        t = lambda q: q * (3 + q * (q - 3)) / (1 + (1 - q) * np.sqrt(1 - q))
        tangential = t(q) ** 2 + t(p) ** 2
        return mu * np.sqrt(tangential) if quantity == "vertical-force" else np.sqrt(1 + mu * mu * tangential)
    q_end = np.where(a > math.sqrt(2), np.arcsin(1 / np.maximum(a, 1.4)), QUARTER)
    p_end = np.clip(np.arccos(1 / np.maximum(b, 1)), 0, QUARTER)
    # Scales: q against 1/mu and against p; 1 - q against K_n^2 and against 1 - p.
    t_of_p = 1.5 * np.minimum(b, 1)
    grade = [q_end * share for share in (0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-5)]
    floor = np.hypot(t_of_p, 1 / mu if quantity != "vertical-force" else 0) / np.maximum(a, 1e-300)
    if quantity == "stiffness":
        near = [q_end * (1 - share) for share in (0.1, 1e-2, 1e-3, 1e-5, 1e-7, 1e-9)]
        grade = [np.where(shear * share > 0.01 * kn * kn, x, q_end) for x, share in zip(near, (0.1, 1e-2, 1e-3, 1e-5, 1e-7, 1e-9))]
    else:
        grade = [np.where(x > 0.01 * floor, x, q_end) for x in grade]
    ends = np.sort(np.stack([0 * a, q_end, p_end, *grade, 0 * a + QUARTER]).clip(0, QUARTER), axis=0)
    g, w = rule(count)
    total = 0 * a
    for low, high in itertools.pairwise(ends):
        i = np.nonzero(high > low)[0]
        if not len(i):
            continue
        ai, bi, lo, width = a[i, None], b[i, None], low[i, None], (high - low)[i, None]
        flat = (lo >= q_end[i, None]) & (lo + width <= p_end[i, None])
        th = lo + width * g
        # 1 - p next to the angle at which p sticks is a difference of nearly equal numbers: from the angle instead.
        pe = p_end[i, None]
        p = bi * np.cos(th)
        p = np.where((pe > 0) & (pe < QUARTER), 1 - 2 * bi * np.sin((th - pe) / 2) * np.sin((th + pe) / 2), p)
        qe = q_end[i, None]
        q = np.where(qe < QUARTER, 1 + 2 * ai * np.sin((th - qe) / 2) * np.cos((th + qe) / 2), ai * np.sin(th))
        total[i] += np.where(flat[:, 0], f(np.ones(1), np.ones(1)) * width[:, 0], (f(q, p) * w * width).sum(axis=1))
    return total


def azimuth_mean(a, mu, kn, shear, quantity, clamped, count):
    """Mean over theta of the force over N (or its horizontal part over N), or of K; a = pushes over mu N, two arrays."""
    if not clamped:
        g, w = rule(2 * count)
        if quantity == "stiffness":
            return np.full_like(a[0], math.sqrt(kn * kn + 2 * shear))
        base, total = (0.0 if quantity == "vertical-force" else 1.0), 0
        for a1, a2 in (a, a[::-1]):
            floor = np.hypot(1.5 * mu * a2, base) / np.maximum(1.5 * mu * a1, 1e-300)
            ends = [0 * a1] + [np.clip(floor * k, 0, QUARTER) for k in (0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5)] + [0 * a1 + QUARTER]
            for low, high in itertools.pairwise(ends):
                th = low[:, None] + (high - low)[:, None] * g
                squares = (1.5 * mu * a1[:, None] * np.sin(th)) ** 2 + (1.5 * mu * a2[:, None] * np.cos(th)) ** 2
                total = total + (np.sqrt(base + squares) * w * (high - low)[:, None]).sum(axis=1)
        return total * 2 / math.pi
    one = part_of_octant(a[0], a[1], mu, kn, shear, quantity, count)
    two = one if a[0] is a[1] else part_of_octant(a[1], a[0], mu, kn, shear, quantity, count)
    return (one + two) * 2 / math.pi


def panels(points, low, high, ratio):
    """Ends from low to high at the points, none more than `ratio` times further from low's zero than the one before."""
    ends = [low] + sorted({p for p in points if low < p < high}) + [high]
    out = [ends[0]]
    for p, q in itertools.pairwise(ends):
        if p > 0 and q / p > ratio:
            n = math.ceil(math.log(q / p) / math.log(ratio))
            out += [p * (q / p) ** (k / n) for k in range(1, n)]
        out.append(q)
    # Two points that rounding alone tells apart are one.
    return [out[0]] + [b for a, b in itertools.pairwise(out) if b - a > 1e-13 * b or b == out[-1]]


def scaled_density(t, s):
    return np.exp(-t * (s + t / 2) if s >= 0 else -(s + t) ** 2 / 2) / math.sqrt(2 * math.pi)


def window(s, depth=46.0):
    high = 2 * depth / (s + math.sqrt(s * s + 2 * depth)) if s >= 0 else math.sqrt(2 * depth) - s
    return max(0.0, -s - math.sqrt(2 * depth)), high


def middle(y, law, lam, c, s, options, clamped, cfg):
    """INT dv for one y: the quantity and, for the tangent, its first moment."""
    N, _, kn, r = law
    mu = 0.27 / math.tanh(0.27 * N ** 0.35)
    (low, high), cy = window(s), c * y
    vertical = options.displacement == "vertical"
    slope = (lam * y, lam * y) if vertical else options.displacement
    pull = [r * k / (mu * N) for k in slope]
    reach = [1 / k if k > 0 else math.inf for k in pull]
    inverse = math.asinh if vertical else (lambda z: math.atanh(z) if z < 1 else math.inf)
    v0, v1 = (math.acosh(max(1.0, t / cy)) for t in (low, high))
    points = [inverse(z) for z in (*reach, math.hypot(*reach)) if math.isfinite(z)]
    soft = [inverse(z * k) for z in reach if math.isfinite(z) for k in (0.2, 1 / (1.5 * mu), 0.2 / mu, 4.0, 15.0)] + [1e-3, 0.03, 0.3, 1.0]
    soft += [math.acosh(t / cy) for t in edges(s, low, high, cfg) if t > cy]
    ends = panels(points + [p for p in soft if all(abs(p - q) > 0.02 * q for q in points)], v0, v1, cfg.ratio)
    fine = [ends[0]]
    for p, q in itertools.pairwise(ends):
        n = math.ceil((q - p) / 1.5)
        fine += [p + (q - p) * k / n for k in range(1, n + 1)]
    ends = np.array(fine)
    g, w = rule(cfg.middle)
    v = (ends[:-1, None] + np.diff(ends)[:, None] * g).ravel()
    ch, t = np.cosh(v), cy * np.cosh(v)
    c0, c2 = 1 - 0.5 * options.a20, 1.5 * options.a20
    weight = scaled_density(t, s) * (np.diff(ends)[:, None] * w).ravel() * np.tanh(v) * (c0 + c2 / ch ** 2) * c
    reached = np.sinh(v) if vertical else np.tanh(v)
    a = [pull[0] * reached] * 2 if pull[0] == pull[1] else [k * reached for k in pull]
    shear = 2.25 * (lam * r) ** 2
    quantity = "force" if options.quantity == "tangent" else options.quantity
    f = azimuth_mean(a, mu, kn, shear, quantity, clamped, cfg.theta)
    if quantity == "vertical-force":
        f = 1 / ch + np.tanh(v) * f
    f = f if quantity == "stiffness" else N * f
    return (weight * f * ((s + t) if options.quantity == "tangent" else 1)).sum()


def edges(s, low, high, cfg):
    shares = (0.03, 0.12, 0.4) if cfg is FIRST else (0.05, 0.17, 0.5)
    return [low + (high - low) * k for k in shares] if s >= 0 else [-s + k for k in ((-8, -4, -1, 1, 4, 8) if cfg is FIRST else (-6, -2.5, 0, 2.5, 6))]


def integral(sc, options, terms, s, cfg):
    strain = math.pi * sc.S * sc.H / (2 * sc.E)
    c, lam, s0 = strain ** 2 * sc.R / sc.sigma, 4 * sc.G / sc.E, strain if options.model != "gao" else 0.0
    B = 0.14 * math.exp(23 * sc.H / 2.8 / sc.E)
    (low, high), (g, w), sums = window(s), rule(cfg.outer), []
    for sign, kind, a, b, loss, limited in terms:
        total, b, loss = 0.0, min(b, high / c), loss * s0
        clamped = limited or options.stick == "clamped"
        if b > a:
            at = lambda y: law_pieces(kind, y, y - 1, sc.S, B, loss)
            grip = lambda y: (lambda N, _, __, r: 0.27 / math.tanh(0.27 * N ** 0.35) * N / r)(*at(y))
            points, origin = [t / c for t in (low, *edges(s, low, high, cfg))], 0.0 if kind != "ep" else 1.0
            # Where a given push no longer reaches the limit, and where slip begins at the window's near end.
            targets = options.displacement if options.displacement != "vertical" else ()
            grid = origin + np.geomspace(max(a - origin, 1e-9 * (b - origin)), b - origin, 3000)
            for z in targets:
                side = np.array([grip(y) - z for y in grid])
                points += [float(grid[i]) for i in np.nonzero(side[:-1] * side[1:] < 0)[0]]
            ends = panels([p - origin for p in points], a - origin, b - origin, cfg.ratio)
            if a == origin:
                first = ends[1]
                ends = [0.0] + [first * cfg.ratio ** -k for k in range(6, 0, -1)] + ends[1:]
            for p, q in itertools.pairwise(ends):
                for off, wt in zip((q - p) * g, (q - p) * w):
                    ym1 = p + off
                    y = origin + ym1
                    if y * c < high:
                        law = law_pieces(kind, y, ym1 if origin else y - 1, sc.S, B, loss)
                        total += wt * middle(y, law, lam, c, s, options, clamped, cfg)
        sums.append((sign * total, total))
    return sum(t for t, _ in sums), sum(abs(t) for _, t in sums)


def terms_of(model):
    inf, ep, p = math.inf, "ep", ("p", 110.0, math.inf)
    plastic = (1.0, *p, 1, False)
    if model == "gao":
        return [(1.0, "e", 0.0, 1.0, 0, False), (1.0, ep, 1.0, 110.0, 0, True), (1.0, *p, 0, False)]
    first = (1.0 if model == "at-additive" else -1.0, ep, 1.0, 6.0, 1, False)
    overlap = model == "at-overlap"
    return [(1.0, "e", 0.0, 6.0 if overlap else 1.0, 0, False), first, (1.0, ep, 1.0 if overlap else 6.0, 110.0, 1, True), plastic]


def compute(job):
    sc, options, s = job
    start = time.time()
    sums = [integral(sc, options, terms_of(options.model), s, cfg) for cfg in (FIRST, SECOND)]
    gap = abs(sums[0][0] - sums[1][0]) / sums[0][1]
    strain = math.pi * sc.S * sc.H / (2 * sc.E)
    wc = strain ** 2 * sc.R
    force = 4 / 3 * sc.E * math.sqrt(sc.R) * wc ** 1.5
    unit = {"stiffness": force / wc, "tangent": force / sc.sigma}.get(options.quantity, force)
    mean = [0.5 * (p + q) * sc.eta * sc.An * unit for p, q in zip(*sums)]
    return job, mean, gap, time.time() - start


def cases(count):
    rng = np.random.default_rng(9)
    pick = lambda *words: words[rng.integers(len(words))]
    for k in range(count):
        E = 116e9
        lam = float("%.6g" % 10 ** rng.uniform(-2, 1))
        H = float("%.6g" % (E * 10 ** rng.uniform(-2.5, -0.8)))
        S, sigma = 0.58, 1e-6
        c = float("%.6g" % 10 ** rng.uniform(-2.5, 1.5))
        R = float("%.9g" % (c * sigma / (math.pi * S * H / (2 * E)) ** 2))
        sc = Scene(E, lam * E / 4, 0.31, H, S, R, float("%.9g" % (0.04 / (R * sigma))), sigma, 3e-5)
        displacement = "vertical"
        if rng.random() < 0.7:
            size = lambda: pick(0.0, 1e-6, 1e6, *(float("%.3g" % 10 ** rng.uniform(-2, 2)) for _ in range(9)))
            displacement = (size(), size())
        options = Options(("gao", "at", "at-additive", "at-overlap")[k % 4],
                          ("force", "stiffness", "vertical-force", "force", "tangent")[k % 5],
                          displacement, pick("clamped", "clamped", "unlimited"), pick(-0.5, -0.5, -1.0, 2.0, 0.7))
        yield sc, options, round(float(rng.uniform(-3, 6)), 3)
    # A case that 16 azimuths got wrong by 5e-8, and a few more of its kind.
    strain = (math.pi * 0.58 * 1.12e9 / (2 * 116e9)) ** 2
    for model, quantity, d, given, c in (("gao", "force", 3.0, (0.1, 10.0), 5.0), ("at", "force", 3.0, (10.0, 0.1), 5.0),
                                         ("gao", "vertical-force", 1.0, (0.1, 10.0), 5.0), ("gao", "tangent", 0.0, (1e-3, 50.0), 0.5)):
        R = c * 1e-6 / strain
        sc = Scene(116e9, 41e9, 0.31, 1.12e9, 0.58, R, 0.04 / (R * 1e-6), 1e-6, 3e-5)
        for stick in ("unlimited", "clamped"):
            yield sc, Options(model, quantity, given, stick, -0.5), d


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=8)
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--output", default="lateral_cases.csv", help="some 8 s a row")
    args = parser.parse_args()
    jobs = list(cases(args.count))
    with open(args.output, "w", newline="") as handle, multiprocessing.Pool(args.processes) as pool:
        out = csv.writer(handle, lineterminator="\n")
        out.writerow(HEADER)
        for (sc, o, s), (value, size), gap, seconds in pool.imap(compute, jobs):
            good = gap < 1e-11
            print("%s %s d=%g: agree to %.0e in %.0f s%s" % (o, "lam=%.3g" % (4 * sc.G / sc.E), s, gap, seconds, "" if good else "  DROPPED"),
                  file=sys.stderr, flush=True)
            if good:
                displacement = o.displacement if o.displacement == "vertical" else "%r %r" % o.displacement
                out.writerow([*map(repr, sc), o.model, o.quantity, displacement, o.stick, repr(o.a20), repr(s),
                              "%.16e" % value, "%.16e" % size, "%.0e" % gap])
                handle.flush()


if __name__ == "__main__":
    main()
