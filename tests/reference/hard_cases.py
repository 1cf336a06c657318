#!/usr/bin/env python3
"""Reference values for hard cases of rough-surface contact models (writes hard_cases.csv); no Gauss rule with the law as weight.

gw ceb zmc ke etsion jg jg-cosine af: tanh-sinh in mpmath (45 digits) on panels that end at every kink of the law, with the
    Gaussian scaled by exp(s^2/2), s = d/sigma.  A row is dropped unless two partitions with different steps agree to 1e-30.
gao at at-additive at-overlap: with y = x u, u = 1/cosh v, c = w_c/sigma the height and angle average becomes
        I[f] = INT dy INT_0^inf dv tanh(v) psi(1/cosh v) <f(y, a)>_theta c phi(s + c y cosh v),
    because the slip variable is a = h(y) sinh v with h = r lam y/(mu N).  For fixed y the regime is fixed and the clamp corners
    are the two points a = 1 and a = sqrt 2, so every edge is the end of a panel.  All three integrals are tanh-sinh in float64.
    A row is dropped unless two partitions with different steps agree to 3e-14 of the sum of sizes of the parts e, ep1, ep2, p.
The tangent is INT q (s+t)/sigma phi dt, which holds the jump terms by itself.
"""
import argparse, csv, functools, itertools, math, sys, time, warnings
from collections import namedtuple

import numpy as np
from mpmath import mp, mpf
from scipy import integrate, optimize, special

mp.dps = 45
warnings.filterwarnings("ignore")
np.seterr(all="ignore")
HEADER = ("family,case,equivalent_modulus,equivalent_shear_modulus,poissons_ratio,hardness,pressure_factor,"
          "asperity_radius,asperity_density,asperity_height_std,nominal_area,heights,model,quantity,"
          "separation_over_sigma,value,ln_value,origin,naive,naive_failure").split(",")
Scene = namedtuple("Scene", "E G nu H S R eta sigma An")
SIMPLE = ["gw", "ceb", "zmc", "ke", "etsion", "jg", "jg-cosine", "af"]
LATERAL = ["gao", "at", "at-additive", "at-overlap"]
QUANTITIES = ["force", "area", "stiffness", "tangent"]

# ---------------------------------------------------------------- laws of one asperity against a flat

def coefficient(model, sc):
    """w_c / R of the model's own critical interference (mpf)."""
    E, H, S, nu = mpf(sc.E), mpf(sc.H), mpf(sc.S), mpf(sc.nu)
    if model == "zmc":
        return (3 * mp.pi * mpf("0.4") * H / (4 * E)) ** 2
    if model in ("jg", "jg-cosine"):
        return (mp.pi * mpf("1.295") * mp.exp(mpf("0.736") * nu) * H / mpf("2.8") / (2 * E)) ** 2
    return (mp.pi * S * H / (2 * E)) ** 2

def law(model, area, sc, m, number=float):
    """(w_c, scale, [(kink, f)]): F or A = scale f(w/w_c), f valid from its kink on; m is mp (exact) or np (numbers of a type)."""
    n = mpf if m is mp else number
    q = lambda text: n(mpf(text))
    E, H, S, R = n(sc.E), n(sc.H), n(sc.S), n(sc.R)
    wc = n(coefficient(model, sc)) * R
    rho, half, k0 = 1 - wc / R, n(1.5), q("1.9")
    Ac, Fc = n(mp.pi) * R * wc, n(4) / 3 * E * m.sqrt(R) * wc ** half
    power = lambda a, p: lambda x: q(a) * x ** q(p)
    offset = lambda a, p: lambda x: q(a) * (x - 1) ** q(p) + 1
    elastic = (0, (lambda x: x) if area else (lambda x: x ** half))
    plastic = (lambda x: 2 * x) if area else (lambda x: 3 / S * x)
    one, two = (("0.93", "1.136"), ("0.94", "1.146")) if area else (("1.03", "1.425"), ("1.40", "1.263"))
    shape = lambda x: x * (1 - 2 * ((x - 1) / 53) ** 3 + 3 * ((x - 1) / 53) ** 2)
    press = lambda x: 1 - q("0.6") * (m.log(n(54)) - m.log(x)) / m.log(n(54))
    hidden = lambda x: x ** half - m.sqrt(rho) * (x - 1) ** half + 3 * rho * (x - 1)
    pieces = {
        "gw": [elastic],
        "ceb": [elastic, (1, lambda x: (2 * x - 1) * (1 if area else half))],
        "zmc": [elastic if area else (0, power("0.4", "1.5")), (1, shape if area else lambda x: shape(x) * press(x)),
                (54, lambda x: 2 * x)],
        "ke": [elastic, (1, power(*one)), (6, power(*two)), (110, plastic)],
        "etsion": [elastic, (1, offset("1.19", "1.1") if area else offset("1.32", "1.27")), (170, plastic)],
        "af": [elastic, (1, (lambda x: x + rho * (x - 1)) if area else hidden)],
    }.get(model)
    if pieces is None:                                          # Jackson and Green with Sy = H/2.8
        C, Sy = q("1.295") * m.exp(q("0.736") * n(sc.nu)), H / q("2.8")
        B = q("0.14") * m.exp(23 * Sy / E)
        ratio = lambda x: m.sqrt(wc / R * x * (x / k0) ** B)    # a / R
        force = lambda hard: lambda x: (m.exp(-x ** (n(5) / 12) / 4) * x ** half
                                        + 4 * hard(x) / C * (1 - m.exp(-x ** (n(5) / 9) / 25)) * x)
        if area:
            pieces = [elastic, (k0, lambda x: x * (x / k0) ** B)]
        elif model == "jg":
            pieces = [elastic, (k0, force(lambda x: q("2.84") * (1 - m.exp(-q("0.82") * ratio(x) ** -q("0.7")))))]
        else:                                                   # the last piece: a >= R
            pieces = [elastic, (k0, force(lambda x: q("2.84") - q("0.92") * (1 - m.cos(n(mp.pi) * ratio(x))))),
                      (k0 * (R / (wc * k0)) ** (1 / (1 + B)), force(lambda x: q("2.84") - 2 * q("0.92")))]
    return wc, Ac if area else Ac * H if model == "zmc" else Fc, pieces

@functools.lru_cache(None)
def sinh_rule(per_unit, exact):
    """Tanh-sinh rule on [0, 1]: nodes (as distance from 0) and weights; mpf lists or float arrays."""
    edge = 4.2 if exact else 3.45
    grid = [mpf(k) / per_unit for k in range(-int(edge * per_unit), int(edge * per_unit) + 1)]
    x = [1 / (1 + mp.exp(-mp.pi * mp.sinh(g))) for g in grid]
    w = [v * (1 / (1 + mp.exp(mp.pi * mp.sinh(g)))) * mp.pi * mp.cosh(g) / per_unit for v, g in zip(x, grid)]
    return (x, w) if exact else (np.array(x, float), np.array(w, float))

def window(s, heights, L, m):
    """Range [lo, T] of t = w/sigma outside which the height density is below exp(-L) of its scale."""
    if heights == "exponential":
        return max(-s, s * 0), max(-s, s * 0) + L
    if s >= 0:
        return s * 0, 2 * L / (s + m.sqrt(s * s + 2 * L))
    return max(s * 0, -s - m.sqrt(2 * L)), -s + m.sqrt(2 * L)

def height_breaks(s, lo, T, heights, fine):
    """Break points in t that follow the height density."""
    if s >= 0 or heights == "exponential":
        return [lo + (T - lo) / p for p in ((30, 8, 2.5) if fine else (20, 6, 2))]
    return [-s + k for k in ((-8, -4, -1, 1, 4, 8) if fine else (-6, -2.5, 0, 2.5, 6))]

def scaled_density(t, s, heights, m):
    """sigma g(d + w) / exp(log_scale) at w = t sigma."""
    if heights == "exponential":
        return m.exp(-t) if s >= 0 else m.exp(-(s + t))
    return (m.exp(-t * (s + t / 2)) if s >= 0 else m.exp(-(s + t) ** 2 / 2)) / m.sqrt(2 * m.pi)

def log_scale(s, heights):
    return (-mpf(s) if heights == "exponential" else -mpf(s) ** 2 / 2) if s > 0 else mpf(0)

def simple_integral(sc, model, area, s, heights, moment, per_unit, fine, top=None):
    """INT f(t/c) (s+t)^moment g dt / exp(log_scale) in mpf; top is an upper limit for t."""
    s, (wc, _, pieces) = mpf(s), law(model, area, sc, mp)
    c, total = wc / mpf(sc.sigma), mpf(0)
    lo, T = window(s, heights, mpf(110), mp)
    T = T if top is None else min(T, top)
    step = mpf(7) if fine else mpf(12)
    decades = [(pieces[-1][0] + (1 if fine else 2) * step) * step ** k * c for k in range(30)]
    breaks = {lo, T, *(k * c for k, _ in pieces), *height_breaks(s, lo, T, heights, fine), *decades}
    for a, b in itertools.pairwise(sorted(b for b in breaks if lo <= b <= T)):
        f = [p for k, p in pieces if k * c <= a][-1]
        for u, w in zip(*sinh_rule(per_unit, True)):
            t = a + (b - a) * u
            total += (b - a) * w * f(t / c) * scaled_density(t, s, heights, mp) * ((s + t) if moment else 1)
    return total

def simple_reference(sc, model, quantity, s, heights):
    """(value, ln value, disagreement of two partitions, origin)."""
    area, slope, found = quantity == "area", quantity in ("stiffness", "tangent"), []
    wc, scale, pieces = law(model, area, sc, mp)
    pre = mpf(sc.eta) * mpf(sc.An) * scale
    for per_unit, fine in ((24, True), (28, False)):
        total = simple_integral(sc, model, area, s, heights, slope and heights == "gaussian", per_unit, fine)
        if slope and heights == "exponential" and s < 0:                # -dF/dd = F/sigma - q(-d) g(0)
            x = -mpf(s) * mpf(sc.sigma) / wc
            total -= [p for k, p in pieces if k <= x][-1](x)
        found.append(total * pre / (mpf(sc.sigma) if slope else 1))
    gap = abs(found[0] / found[1] - 1)
    e = log_scale(s, heights)
    origin = "mpmath 45 digits tanh-sinh split at kinks; two partitions agree to %s" % mp.nstr(max(gap, mpf("1e-40")), 1)
    return found[0] * mp.exp(e), mp.log(abs(found[0])) + e, gap, origin

# ---------------------------------------------------------------- lateral models
ROOT2 = math.sqrt(2)
Config = namedtuple("Config", "outer middle theta fine span")
FIRST, SECOND = Config(11, 11, 9, True, 2.0), Config(10, 9, 8, False, 1.5)

def law_pieces(kind, y, ym1, S, B, s0):
    """N, A*, K_n, r of one regime; ym1 = y - 1 without cancellation; s0 = 0 for Gao."""
    if kind == "e":
        return y ** 1.5, y, 1.5 * np.sqrt(y), np.sqrt(y)
    if kind == "ep":
        A = 1 + 1.19 * ym1 ** 1.1
        return 1.32 * ym1 ** 1.27 + 1, A, 1.6764 * ym1 ** 0.27, np.sqrt(A) - s0
    A = y * (y / 1.9) ** B
    return 3 * y / S, A, 3 / S + 0 * y, np.sqrt(A) - s0

def theta_mean(a, mu, Kn, b, per_unit):
    """Means over theta of sqrt(1 + (T1^2+T2^2)/N^2) and of K for an array of a = r lam x s/(mu N)."""
    g, w = sinh_rule(per_unit, False)           # by symmetry theta in [0, pi/4]; cos clamped below `corner`, both beyond `top`
    top = np.where(a > ROOT2, np.arcsin(1 / np.maximum(a, ROOT2)), math.pi / 4)
    corner = np.minimum(np.arccos(1 / np.maximum(a, 1)), top)
    f, k = (math.pi / 4 - top) * math.sqrt(1 + 2 * mu * mu), (math.pi / 4 - top) * Kn
    for lo, hi, clamped in ((0 * a, corner, True), (corner, top, False)):
        i = np.nonzero(hi > lo)[0]
        th, ai = lo[i, None] + (hi - lo)[i, None] * g, a[i, None]
        p1 = np.maximum(0, 1 - ai * np.sin(th))
        p2 = 0 * p1 if clamped else np.maximum(0, (1 - ai) + 2 * ai * np.sin(th / 2) ** 2)
        wt = (hi - lo)[i, None] * w
        f[i] += (wt * np.sqrt(1 + mu * mu * ((1 - p1 * np.sqrt(p1)) ** 2 + (1 - p2 * np.sqrt(p2)) ** 2))).sum(axis=1)
        k[i] += (wt * np.sqrt(Kn * Kn + b * b * (p1 + p2))).sum(axis=1)
    return f * 4 / math.pi, k * 4 / math.pi

def merge(hard, soft, lo, hi):
    """Panel ends in [lo, hi]: every hard break (an edge of the law), soft ones only where not next to another end."""
    out = [lo] + sorted(x for x in hard if lo < x < hi) + [hi]
    for b in soft:
        out += [b] if lo < b < hi and min(abs(b - p) for p in out) > 1e-3 * (b - lo) else []
    return sorted(out)

def middle(y, N, Kn, r, lam, c, s, win, tb, heights, cfg):
    """INT dv tanh v psi density {F/N-mean, 1, K-mean, F/N-mean (s+t)} for one y."""
    (lo, T), mu = win, 0.27 / math.tanh(0.27 * N ** 0.35)
    h, cy = r * lam * y / (mu * N), c * y
    v0, v1 = math.acosh(max(1.0, lo / cy)), math.acosh(max(1.0, T / cy))
    corner = math.asinh(ROOT2 / h)
    soft = [4 * corner, math.asinh(1 / (1.5 * mu * h)), 0.25 if cfg.fine else 0.6]
    points = merge([math.asinh(1 / h), corner], soft + [math.acosh(t / cy) for t in tb if t > cy], v0, v1)
    split = lambda p, q: np.linspace(p, q, 1 + math.ceil((q - p) / cfg.span))[1:]
    edges = np.concatenate([[v0], *(split(p, q) for p, q in itertools.pairwise(points))])
    g, w = sinh_rule(cfg.middle, False)
    v = (edges[:-1, None] + np.diff(edges)[:, None] * g).ravel()
    ch, t = np.cosh(v), cy * np.cosh(v)
    dens = scaled_density(t, s, heights, np) * (np.diff(edges)[:, None] * w).ravel() * np.tanh(v) * (1.25 - 0.75 / ch ** 2) * c
    f, k = theta_mean(h * np.sinh(v), mu, Kn, 1.5 * lam * r, cfg.theta)
    return np.array([(dens * f).sum(), dens.sum(), (dens * k).sum(), (dens * f * (s + t)).sum()])

@functools.lru_cache(None)
def lateral_parts(sc, s, heights, cfg):
    """{piece: [I[F], I[A*], I[K], I[F (s+t)], I[y]]} with exp(log_scale) taken out."""
    wc = coefficient("gao", sc) * mpf(sc.R)
    c, lam, s0 = float(wc / mpf(sc.sigma)), float(4 * mpf(sc.G) / mpf(sc.E)), float(mp.sqrt(wc / mpf(sc.R)))
    B = float(mpf("0.14") * mp.exp(23 * mpf(sc.H) / mpf("2.8") / mpf(sc.E)))
    lo, T = win = window(float(s), heights, 48.0, np)
    tb = [float(t) for t in height_breaks(s, lo, T, heights, cfg.fine)] + ([lo] if s < 0 else [])
    (g, w), parts = sinh_rule(cfg.outer, False), {}
    for name, kind, a, b, shift in (("e01", "e", 0, 1, 0), ("e16", "e", 1, 6, 0), ("g16", "ep", 1, 6, 0), ("g6", "ep", 6, 110, 0),
                                    ("gp", "p", 110, math.inf, 0), ("a16", "ep", 1, 6, s0), ("a6", "ep", 6, 110, s0),
                                    ("ap", "p", 110, math.inf, s0)):
        total = parts[name] = np.zeros(5)
        b = min(b, T / c)
        if b > a:
            def corner(y, k):                                   # x at which the clamp a = sqrt(k) sits
                N, _, _, r = law_pieces(kind, y, y - 1, sc.S, B, shift)
                return y * np.sqrt(1 + k * (0.27 * N / np.tanh(0.27 * N ** 0.35) / (r * lam * y)) ** 2)
            ratio = 10.0 if cfg.fine else 6.0
            soft = [t / c for t in tb] + [(b if a == 0 else a) * ratio ** k for k in range(-2, 20)]
            hard, grid = [lo / c], np.geomspace(max(a, b * 1e-9), b, 2000)
            for k in (1, 2) if s < 0 else ():                   # corner against the edge or the bump of the density
                for t in tb:
                    gap = corner(grid, k) - t / c
                    for i in np.nonzero(gap[:-1] * gap[1:] < 0)[0]:
                        (hard if t == lo else soft).append(optimize.brentq(lambda y: corner(y, k) - t / c, grid[i],
                                                                           grid[i + 1], xtol=1e-300, rtol=1e-15))
            for p, q in itertools.pairwise(merge(hard, soft, a, b)):
                for off, wt in zip((q - p) * g, (q - p) * w):
                    y = p + off
                    N, A, Kn, r = law_pieces(kind, y, (p - 1) + off, sc.S, B, shift)
                    m = middle(y, N, Kn, r, lam, c, float(s), win, tb, heights, cfg)
                    total += wt * np.array([N * m[0], A * m[1], m[2], N * m[3], y * m[1]])
    return parts

def lateral_reference(sc, model, quantity, s, heights):
    """(value, ln |value|, disagreement over the sum of sizes, origin)."""
    if quantity == "tangent" and heights == "exponential" and s < 0:
        return None
    col = 0 if quantity == "tangent" and heights == "exponential" else QUANTITIES.index(quantity)
    wc = coefficient("gao", sc) * mpf(sc.R)
    k = float(1 - wc / mpf(sc.R)) if col == 1 else 1.0
    sums = []
    for cfg in (FIRST, SECOND):
        parts = lateral_parts(sc._replace(eta=1.0, An=1.0), s, heights, cfg)
        p = {name: v[col] for name, v in parts.items()}
        ep1 = parts["a16"][4] if col == 1 else p["a16"]
        terms = [p["e01"]] + {"gao": [p["g16"], p["g6"], p["gp"]], "at": [-k * ep1, k * p["a6"], k * p["ap"]],
                              "at-additive": [k * ep1, k * p["a6"], k * p["ap"]],
                              "at-overlap": [p["e16"], k * (p["a16"] - ep1), k * p["a6"], k * p["ap"]]}[model]
        sums.append((math.fsum(terms), sum(map(abs, terms))))
    gap = abs(sums[0][0] - sums[1][0]) / sums[0][1]
    E, R = mpf(sc.E), mpf(sc.R)
    Fc = mpf(4) / 3 * E * mp.sqrt(R) * wc ** mpf(1.5)
    pre = mpf(sc.eta) * mpf(sc.An) * {"force": Fc, "area": mp.pi * R * wc, "stiffness": Fc / wc,
                                      "tangent": Fc / mpf(sc.sigma)}[quantity]
    e = log_scale(s, heights)
    full = mpf((sums[0][0] + sums[1][0]) / 2) * pre
    origin = "nested tanh-sinh in float64; two partitions agree to %.0e" % max(gap, 1e-16)
    if abs(sums[0][0]) < 0.9 * sums[0][1]:
        origin += " of the sum of sizes of the parts; |value| is %.3g of that sum" % (abs(sums[0][0]) / sums[0][1])
    return full * mp.exp(e), mp.log(abs(full)) + e, gap, origin

# ---------------------------------------------------------------- naive methods, in float64, measured
NAIVE_1D = ["gauss-legendre-64 on [d;d+8 sigma]", "trapezoid-1001 on [d;d+6 sigma]", "simpson-200 on [d;d+6 sigma]",
            "gauss-hermite-64", "unscaled quad(d;inf)", "fixed upper limit z=4 sigma", "erfc closed form",
            "full-range power sum", "stiffness without jump terms"]
NAIVE_3D = ["product rule over angles 20x64x64", "gauss-legendre-64 on [d;d+8 sigma] with 16x16 angles",
            "gauss-hermite-64 with 32x32 angles", "trapezoid-1001 on [d;d+6 sigma] with 12x12 angles",
            "stiffness taken for the tangent"]

def density(z, heights):
    return scaled_density(z, 0.0, heights, np) * ((z >= 0) | (heights == "gaussian"))

def rule(name, s, heights):
    """Nodes z/sigma and weights (with the unscaled density) of the one-dimensional naive rules."""
    if name.startswith("gauss-hermite"):
        x, w = special.roots_hermite(64)
        return (ROOT2 * x, w / math.sqrt(math.pi)) if heights == "gaussian" else special.roots_laguerre(64)
    if name.startswith(("trapezoid", "simpson")):
        n = 1001 if name.startswith("trapezoid") else 201
        x, w = np.linspace(0, 6, n), np.full(n, 0.006) if n == 1001 else np.tile([0.02, 0.04], 101)[:n]
        w[[0, -1]] /= 2
    else:
        x, w = special.roots_legendre(20 if name.startswith("product") else 64)
        x, w = 4 * x + 4, 4 * w
    return s + x, w * density(s + x, heights)

def naive_simple(name, sc, model, quantity, s, heights, value):
    """Result of a naive method in SI, or None where it does not apply; exponential slopes use F/sigma."""
    area, slope, gauss = quantity == "area", quantity in ("stiffness", "tangent"), heights == "gaussian"
    wc, scale, pieces = law(model, area, sc, np)
    pre, sig, c = sc.eta * sc.An, sc.sigma, wc / sc.sigma
    weight = lambda z: (z if gauss else 1) / sig if slope else 1.0

    def f(t):
        x = np.asarray(t, float) / c
        y = np.where(x > 0, pieces[0][1](np.maximum(x, 0)), 0.0)
        for k, p in pieces[1:]:
            y = np.where(x > k, p(np.maximum(x, k)), y)
        return scale * y
    if "quad" in name:                                          # in metres, as a script would
        g = lambda z: float(f(z / sig - s) * density(z / sig, heights) / sig * weight(z / sig))
        return pre * integrate.quad(g, (s if gauss else max(s, 0)) * sig, np.inf)[0]
    if name.startswith("fixed"):
        exact = simple_integral(sc, model, area, s, heights, slope and gauss, 12, True, 4 - mpf(s)) if s < 4 else mpf(0)
        return exact * mpf(pre * scale / (sig if slope else 1)) * mp.exp(log_scale(s, heights))
    one = lambda t: math.exp(-t * t / 2) / math.sqrt(2 * math.pi) - t * special.erfc(t / ROOT2) / 2
    rho = {"gw": 0, "ceb": 1, "af": 1 - wc / sc.R}.get(model)
    if name.startswith("erfc"):
        return pre * scale / c * (one(s) + rho * one(s + c)) if gauss and area and rho is not None else None
    if name.startswith("full-range"):
        g15 = lambda t: special.gamma(2.5) / math.sqrt(2 * math.pi) * math.exp(-t * t / 4) * special.pbdv(-2.5, t)[0] / c ** 1.5
        plastic = lambda: 3 * rho * one(s + c) / c - math.sqrt(rho) * g15(s + c) if rho else 0
        return pre * scale * (g15(s) + plastic()) if gauss and quantity == "force" and model in ("gw", "af") else None
    if name.startswith("stiffness"):
        wc, big, pieces = law(model, False, sc, mp)
        jumps = sum((p(k) - before(k)) * mp.npdf(mpf(s) + k * wc / mpf(sig)) for (_, before), (k, p) in itertools.pairwise(pieces))
        return value - mpf(pre) * big * jumps / mpf(sig) if gauss and slope and jumps else None
    z, w = rule(name, s, heights)
    return pre * float((f(z - s) * w * weight(z)).sum())

def naive_lateral(name, sc, model, quantity, s, heights, value):
    """Product rules over height and angles that do not know the regime edges, or None."""
    if name.startswith("stiffness"):
        return lateral_reference(sc, model, "stiffness", s, heights)[0] if quantity == "tangent" else None
    z, w = rule(name, s, heights)
    nu = nt = int(name.split("x")[-1].split()[0])
    wc = float(coefficient("gao", sc) * mpf(sc.R))
    lam, s0 = 4 * sc.G / sc.E, math.sqrt(wc / sc.R) if model != "gao" else 0.0
    B, rho = 0.14 * math.exp(23 * sc.H / 2.8 / sc.E), 1 - wc / sc.R if model != "gao" else 1.0
    z, w = z[z > s], w[z > s]
    x = ((z - s) * sc.sigma / wc)[:, None, None]
    u, wu = (special.roots_legendre(nu)[0] + 1) / 2, special.roots_legendre(nu)[1] / 2
    th = (np.arange(nt) + 0.5) * math.pi / 2 / nt
    y, slide = x * u[:, None], lam * x * np.sqrt(1 - u * u)[:, None]

    def column(kind):
        N, A, Kn, r = law_pieces(kind, y, np.maximum(y - 1, 0), sc.S, B, 0.0 if kind == "e" else s0)
        if quantity == "area":
            return A * (1 if kind == "e" else rho) + 0 * th
        mN = N * 0.27 / np.tanh(0.27 * N ** 0.35)
        q = [np.minimum(1, r * slide * t / mN) for t in (np.sin(th), np.cos(th))]
        if quantity == "stiffness":
            return np.sqrt(Kn ** 2 + (1.5 * lam * r) ** 2 * (2 - q[0] - q[1]))
        return np.sqrt(N ** 2 + sum((mN * (1 - (1 - p) ** 1.5)) ** 2 for p in q))
    e, ep, p = column("e"), column("ep"), column("p")
    near = ep if quantity != "area" or model == "gao" else rho * y + 0 * th
    near = {"gao": near, "at": -near, "at-additive": near, "at-overlap": e + (ep - near)}[model]
    f = np.where(y <= 1, e, np.where(y <= 6, near, np.where(y <= 110, ep, p)))
    Fc = 4 / 3 * sc.E * math.sqrt(sc.R) * wc ** 1.5
    pre = {"force": Fc, "area": math.pi * sc.R * wc, "stiffness": Fc / wc, "tangent": Fc / sc.sigma}[quantity]
    w = w * z if quantity == "tangent" and heights == "gaussian" else w
    return sc.eta * sc.An * pre * float(((f.mean(axis=2) * (1.25 - 0.75 * u ** 2)) @ wu * w).sum())

def measure_naive(start, prefer, *case):
    """(name, failure) of the first naive method, from a rotating start, that is wrong by more than 1e-9."""
    sc, model, quantity, s, heights, value = case
    names, run = (NAIVE_3D, naive_lateral) if model in LATERAL else (NAIVE_1D, naive_simple)
    start %= len(names)
    for name in [n for word in prefer.split() for n in names if word in n] + names[start:] + names[:start]:
        got = run(name, *case)
        if got is None:
            continue
        if heights == "exponential":
            name = name.replace("gauss-hermite", "gauss-laguerre")
            name += " of F/sigma" if quantity in ("stiffness", "tangent") and model in SIMPLE else ""
        if not mp.isfinite(got) or got == 0:
            return name, "returns 0" if got == 0 else "returns nan or inf"
        error = abs(mpf(got) / value - 1)
        if error > mpf("1e-9"):
            return name, "relative error " + mp.nstr(error, 2, min_fixed=0, max_fixed=0)
    return None

# ---------------------------------------------------------------- the cases
PAPER = Scene(116e9, 41e9, 0.31, 1.12e9, 0.58, 0.0003589894545150856, 111423885.84653844, 1e-6, 3e-5)
MILD = Scene(110e9, 44e9, 0.3, 2e9, 0.577, 0.0014729702994599895, 84862539.3504721, 4e-7, 1e-4)
SEVERE = Scene(116e9, 41e9, 0.31, 1.12e9, 0.58, 6.461810181271541e-05, 348199643.2704326, 2e-6, 1e-5)
SOFT = Scene(2.5e9, 1.1e9, 0.42, 4.5e8, 0.6262, 2e-5, 4e9, 5e-7, 1e-6)          # H/E = 0.18, w_c/R = 0.03
G, X = "gaussian", "exponential"
PREFER = {"near-kink": "jump", "af-cancellation": "full-range erfc", "far-tail": "erfc", "subnormal": "erfc full-range"}

def short(x, digits=9):
    return float("%.*g" % (digits, x))

def with_c(base, c, model="gao", **changes):
    """The scene with R (and eta R sigma = 0.04) such that the model's w_c/sigma is close to c."""
    sc = base._replace(**changes)
    R = short(c * sc.sigma / float(coefficient(model, sc)))
    return sc._replace(R=R, eta=short(0.04 / (R * sc.sigma)))

def spread(family, points, step=2, lateral=(), models=SIMPLE):
    """Rows over points (case, scene, s, heights): every step-th simple model, all lateral ones at the points listed."""
    rows, count = [], {}
    for i, (case, sc, s, heights) in enumerate(points):
        for m in [m for j, m in enumerate(models) if (i + j) % step == 0] + (LATERAL if i in lateral else []):
            k = count[m] = count.get(m, -1) + 1
            cycle = QUANTITIES[:3] if m in LATERAL and s < (-6 if heights == G else 0) else QUANTITIES
            rows.append((family, case, sc, heights, m, cycle[(k + (SIMPLE + LATERAL).index(m) + len(family)) % len(cycle)], s))
    return rows

def families():
    """{family: function that lists (family, case, scene, heights, model, quantity, s)}."""
    tiny, one, out = with_c(PAPER, 1e-6), with_c(MILD, 1.0), {}
    def add(name, points, *rest, **more):
        out[name] = lambda: spread(name, points, *rest, **more)
    def grid(name, scenes, separations, *rest, **more):         # every scene (c, base) at every separation
        model = more["models"][0] if more["models"][0].startswith("jg") else "gao"
        add(name, [("c=%g" % c, with_c(b, c, model), s, G) for c, b in scenes for s in separations], 1, *rest, **more)
    def lateral(name, table):                                   # table of (lam, c, s, base), lam = 4 G/E
        add(name, [("lam=%g c=%g" % (lam, c), with_c(b, c, G=short(lam * b.E / 4)), s, G) for lam, c, s, b in table],
            1, range(len(table)), models=[])

    add("far-tail", [("paper", PAPER, 6.0, G), ("mild", MILD, 9.5, G), ("severe", SEVERE, 14.0, G), ("soft", SOFT, 30.0, G),
                     ("c=1e-3", with_c(PAPER, 1e-3), 21.0, G), ("c=0.03", with_c(MILD, 0.03), 40.0, G)], 2, (0, 2, 3, 5))
    add("extreme-tail", [("paper", PAPER, 100.0, G), ("c=1e-6", tiny, 1e3, G), ("severe", SEVERE, 12345.5, G),
                         ("c=1e-6", tiny, 1e5, G), ("c=1e-6", tiny, 1e6, G), ("paper", PAPER, 1e6, G)], 2, (0, 1, 4))
    add("deep-overlap", [("paper", PAPER, -3.0, G), ("c=1", one, -5.5, G), ("severe", SEVERE, -8.0, G), ("soft", SOFT, -20.0, G),
                         ("c=10", with_c(PAPER, 10.0), -12.0, G), ("c=1", one, -40.0, G)], 2, (0, 1, 4, 5))
    add("wc-range", [("c=1e%d" % e, with_c((PAPER, MILD)[i % 2], 10.0 ** e, sigma=(1e-6, 1e-8, 1e-5)[i % 3]), s, G)
                     for i, (e, s) in enumerate(((-12, 0.0), (-9, 2.0), (-6, -1.5), (-4, 5.0), (-2, 1.0), (0, -2.5), (2, 3.0),
                                                 (4, 0.5), (6, -0.5), (9, 1.5), (12, 0.0)))], 2, (0, 2, 3, 6, 9))
    def near_kink():                                            # d + w_k = delta, or d = 2 and w_k = sigma
        rows, cycle, deltas = [], ("stiffness", "force", "area"), (1e-9, -1e-9, 1e-4, -1e-4)
        for i, (m, k) in enumerate((("ceb", 1), ("ke", 1), ("ke", 6), ("ke", 110), ("zmc", 1), ("zmc", 54), ("etsion", 1),
                                    ("etsion", 170), ("jg", 1.9), ("jg-cosine", 1.9), ("af", 1), ("gao", 6), ("at", 1))):
            for j, at in enumerate((-2.5, -0.6, 2.0)):
                sc = with_c((PAPER, MILD)[j % 2], (abs(at) if at < 0 else 1.0) / k, m)
                s = float(deltas[(i + j) % 4] - k * coefficient(m, sc) * mpf(sc.R) / mpf(sc.sigma)) if at < 0 else at
                todo = [(m, cycle[(i + j) % 3])] if m in SIMPLE else zip(LATERAL, np.roll(QUANTITIES, i + j).tolist())
                rows += [("near-kink", "%s kink %g near s=%g" % (m, k, at), sc, G, n, q, s) for n, q in todo]
        return rows
    out["near-kink"] = near_kink
    grid("jg-transient", ((1e-5, PAPER), (1e-8, MILD), (1e-10, SEVERE), (1e-12, SOFT)), (-3.0, 1.0, 12.0),
         models=["jg", "jg-cosine"])
    grid("etsion-power", ((0.03, PAPER), (0.3, MILD), (3.0, SEVERE)), (-1.0, 0.0, 2.5, 7.0, 25.0), (2, 8, 13), models=["etsion"])
    grid("af-cancellation", ((1e-2, SOFT), (1e-4, PAPER), (1e-6, SEVERE), (1e-7, MILD), (1e-8, PAPER), (1e-9, SOFT), (1e-10, MILD),
                             (1e-10, PAPER)), (-2.0, 0.5, 4.0), models=["af"])
    def at_cancellation():
        rows = []
        for i, (psi, s) in enumerate(((1.2, 0.0), (1.5, 0.0), (2.1, 0.0), (2.6, 0.0), (1.5, 2.0), (2.6, 2.0), (3.2, 2.0),
                                      (2.1, 4.0), (3.8, 4.0), (4.5, 4.0), (3.2, 6.0), (4.5, 6.0))):
            todo = [("at", q) for q in QUANTITIES] + [(m, QUANTITIES[(i + j) % 4]) for j, m in enumerate(LATERAL[2:])]
            rows += [("at-cancellation", "psi=%g" % psi, with_c(PAPER, psi ** -2), G, m, q, s) for m, q in todo]
        return rows
    out["at-cancellation"] = at_cancellation
    lateral("grazing-angles", ((0.01, 0.03, 0.0, PAPER), (0.1, 1.0, 0.0, MILD), (1.0, 10.0, 0.0, PAPER), (10.0, 100.0, 0.0, MILD),
                               (10.0, 0.03, 3.0, PAPER), (1.0, 1e4, 3.0, SOFT), (0.1, 10.0, 3.0, MILD), (10.0, 1.0, -2.0, SOFT),
                               (0.01, 3.0, -3.0, PAPER), (3.0, 0.3, 1.0, MILD)))
    lateral("clamp-corner", ((0.05, 0.3, 0.0, PAPER), (0.1, 0.03, 1.0, PAPER), (0.2, 0.1, 0.5, MILD), (0.27, 1.0, -1.0, MILD),
                             (0.35, 0.02, 2.0, SEVERE), (0.5, 0.5, 3.0, SOFT), (0.8, 0.005, 0.0, PAPER), (1.5, 0.2, -2.0, SOFT)))
    add("near-incompressible", [("nu=%r" % nu, b._replace(nu=nu, S=0.454 + 0.41 * nu), s, G) for nu, b, s in (
        (0.5, PAPER, 0.0), (0.4999999, MILD, 3.0), (0.0, SEVERE, 1.5), (-0.9, PAPER, 2.0), (0.5, SOFT, 5.0), (-0.9, MILD, -2.0))],
        2, (0, 1, 3))
    add("si-scales", [("sigma=%g m E=%g Pa" % (u, E), Scene(E, short(0.36 * E), 0.3, short(0.012 * E), 0.577, short(300 * u),
                       short(0.04 / (300 * u * u)), u, short(1e4 * u * u)), 1.25, G) for u, E in (
        (1e-9, 1e3), (1e-9, 1e13), (1e-6, 1e6), (1e-6, 2e11), (1e-3, 1e3), (1e-3, 1e13), (1.0, 1e9), (1.0, 1e13))], 3, (0, 4, 7))
    add("exponential", [("paper", PAPER, 0.0, X), ("mild", MILD, 1.0, X), ("severe", SEVERE, 5.0, X), ("soft", SOFT, -1.0, X),
                        ("paper", PAPER, 40.0, X), ("mild", MILD, 800.0, X), ("severe", SEVERE, -5.0, X), ("soft", SOFT, -30.0, X)],
        2, (1, 4, 6, 7))
    def subnormal():                                            # A_n such that the value lies near a given power of ten
        rows, table = [], ((37.0, -301), (37.5, -305), (38.0, -309), (38.3, -314), (38.5, -319), (38.6, -322.6))
        for _, case, sc, _, m, q, s in spread("subnormal", [("near 1e%g" % e, (PAPER, MILD)[i % 2], s, G)
                                                               for i, (s, e) in enumerate(table)], 2, (1, 4)):
            ln = (simple_reference if m in SIMPLE else lateral_reference)(sc._replace(An=1.0), m, q, s, G)[1]
            An = short(mp.exp(mpf(case[7:]) * mp.log(10) - ln), 3)
            rows.append(("subnormal", case, sc._replace(An=An), G, m, q, s))
        return rows
    out["subnormal"] = subnormal
    return out

def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--families", default=",".join(families()), metavar="A,B", help="comma separated; all when not given")
    parser.add_argument("--output", default="hard_cases.csv")
    args = parser.parse_args()
    with open(args.output, "w", newline="") as handle:
        out = csv.writer(handle, lineterminator="\n")
        out.writerow(HEADER)
        for name in args.families.split(","):
            start, kept, worst = time.time(), 0, {True: 0.0, False: 0.0}
            for index, (family, case, sc, heights, model, quantity, s) in enumerate(families()[name]()):
                simple = model in SIMPLE
                found = (simple_reference if simple else lateral_reference)(sc, model, quantity, s, heights)
                good = found is not None and found[2] < (1e-30 if simple else 3e-14)
                naive = measure_naive(index, PREFER.get(name, ""), sc, model, quantity, s, heights, found[0]) if good else None
                if naive is None:
                    print("  dropped (%s): %s %s %s s=%r" % ("no naive method fails" if good else "reference %s" % (
                        found and mp.nstr(found[2], 3)), case, model, quantity, s), file=sys.stderr)
                    continue
                value, ln, gap, origin = found
                worst[simple], kept = max(worst[simple], gap), kept + 1
                out.writerow([family, case, *map(repr, sc), heights, model, quantity, repr(s),
                              mp.nstr(value, 30 if simple else 15, min_fixed=0, max_fixed=0),
                              mp.nstr(ln, 42 if simple else 32, min_fixed=-10, max_fixed=40), origin, *naive])
            print("%-20s %3d rows, %5.1f s, partitions agree to %s (1-D) and %s (lateral)" % (
                name, kept, time.time() - start, mp.nstr(worst[True], 2), mp.nstr(worst[False], 2)), file=sys.stderr)

if __name__ == "__main__":
    main()
