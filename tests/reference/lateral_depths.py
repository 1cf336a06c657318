#!/usr/bin/env python3
"""Reference values for Gao and AT far below all heights (writes lateral_depths.csv, in the columns of lateral_cases.csv).

Every asperity is pressed by about x = |s|/c, c = w_c/sigma, and the law of one asperity is smooth over the heights: the mean over the
heights is a Gauss-Hermite sum of
        q(x) = (1/x) INT_0^x (c0 + c2 y^2/x^2) <f(y, x, theta)>_theta dy,
by Gauss rules on fixed panels of y and theta, which end where a direction begins to slip and shrink towards both ends of a regime.
The last column is how far two partitions of different orders differ.
"""
import csv, math, os

import numpy as np

from hard_cases import law_pieces
from lateral_cases import HEADER, rule

FIRST, SECOND = (20, 16, 4.0, 8), (26, 20, 2.5, 11)  # nodes in y and in theta, ratio of panels, heights
SOFT = dict(E=162472160846.2948, G=25293029937.681816, nu=0.3, H=135501863.37537646, S=0.577, R=1.679024191853228e-5,
            eta=41055335.75293291, sigma=2.1912678913137764e-7, An=1e-4)
HARD = dict(E=116e9, G=41e9, nu=0.31, H=1.12e9, S=0.58, R=4e-5, eta=2e9, sigma=5e-7, An=3e-5)
ROWS = [(SOFT, "gao", -1000.0), (SOFT, "at-additive", -1000.0), (SOFT, "at", -1e5), (SOFT, "at-additive", -40.0),
        (HARD, "at-overlap", -300.0), (HARD, "gao", -2e4)]


def load(kind, y, gap, lam, S, B, s0, nodes):
    """The mean over theta of the contact force, and the tangential load over the friction limit."""
    N, _, _, r = law_pieces(kind, y, y - 1, S, B, s0)
    mu = 0.27 / np.tanh(0.27 * N ** 0.35)
    a = lam * r * np.sqrt(gap * (2 * y + gap)) / (mu * N)
    begins = np.where(a > math.sqrt(2), np.arcsin(1 / np.maximum(a, 1.4)), math.pi / 4)
    ends = np.where(a > 1, np.minimum(np.arccos(1 / np.maximum(a, 1)), math.pi / 4), 0.0)
    edges = [np.zeros_like(a), np.minimum(begins, ends), np.maximum(begins, ends), np.full_like(a, math.pi / 4)]
    t = lambda q: 1 - (1 - np.minimum(q, 1)) ** 1.5
    v, w = rule(nodes)
    total = 0.0
    for low, high in zip(edges, edges[1:]):
        theta = low[:, None] + (high - low)[:, None] * v
        q, p = a[:, None] * np.sin(theta), a[:, None] * np.cos(theta)
        total = total + (high - low) * (np.sqrt(1 + mu[:, None] ** 2 * (t(q) ** 2 + t(p) ** 2)) @ w)
    return N * total / (math.pi / 4), a


def angle_average(kind, x, low, high, lam, S, B, s0, config):
    """q(x) of one regime, low <= y <= min(high, x); gaps are counted from x, so that none cancels."""
    nodes, azimuths, ratio, _ = config
    high = min(high, x)
    if low >= high:
        return 0.0
    args = (lam, S, B, s0, azimuths)
    slip = lambda y: load(kind, np.array([y]), np.array([x - y]), *args)[1][0]
    # y - low rises and high - y falls by the ratio, from the middle.
    middle, ends = 0.5 * (low + high), []
    span = middle - low
    for k in range(1, int(math.log(1e16) / math.log(ratio))):
        ends += [("low", span * ratio ** -k), ("high", span * ratio ** -k)]
    for level in (1.0, math.sqrt(2)):
        a, b = low + 1e-12 * span, high - 1e-14 * span
        if (slip(a) - level) * (slip(b) - level) < 0:
            lo, hi = 1e-14 * span, high - a
            for _ in range(200):
                gap = math.sqrt(lo * hi)
                lo, hi = (gap, hi) if slip(high - gap) < level else (lo, gap)
            ends.append(("high", lo) if lo < span else ("low", high - lo - low))
    v, w = rule(nodes)
    total = 0.0
    c0, c2 = 1.25, -0.75
    for side in ("low", "high"):
        marks = sorted({0.0, span, *(value for name, value in ends if name == side)})
        for near, far in zip(marks, marks[1:]):
            offset = near + (far - near) * v
            y = low + offset if side == "low" else high - offset
            gap = x - y if side == "low" or high < x else offset
            force, _ = load(kind, y, gap, *args)
            total += (far - near) * np.dot(w, (c0 + c2 * (y / x) ** 2) * force)
    return total / x


def row(scene, model, s, config):
    E, G, H, S, R = (scene[key] for key in "EGHSR")
    critical = (math.pi * S * H / (2 * E)) ** 2 * R
    unit = 2 / 3 * math.pi * R * critical * S * H
    lam, B = 4 * G / E, 0.14 * math.exp(23 * H / 2.8 / E)
    s0 = 0.0 if model == "gao" else math.sqrt(critical / R)
    parts = {"gao": [("e", 0, 1, 1), ("ep", 1, 110, 1), ("p", 110, math.inf, 1)],
             "at": [("e", 0, 1, 1), ("ep", 1, 6, -1), ("ep", 6, 110, 1), ("p", 110, math.inf, 1)],
             "at-additive": [("e", 0, 1, 1), ("ep", 1, 6, 1), ("ep", 6, 110, 1), ("p", 110, math.inf, 1)],
             "at-overlap": [("e", 0, 6, 1), ("ep", 6, 110, 1), ("p", 110, math.inf, 1)]}[model]
    z, weights = np.polynomial.hermite_e.hermegauss(config[3])
    value = size = 0.0
    for height, weight in zip(z, weights / math.sqrt(2 * math.pi)):
        x = (height - s) * scene["sigma"] / critical
        for kind, low, high, sign in parts:
            one = weight * angle_average(kind, x, low, high, lam, S, B, s0, config)
            value, size = value + sign * one, size + one
    factor = scene["eta"] * scene["An"] * unit
    return factor * value, factor * size


if __name__ == "__main__":
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "lateral_depths.csv"), "w", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(HEADER)
        for scene, model, s in ROWS:
            (value, size), (other, _) = (row(scene, model, s, config) for config in (FIRST, SECOND))
            numbers = [scene[key] for key in ("E", "G", "nu", "H", "S", "R", "eta", "sigma", "An")]
            agreement = f"{max(abs(value / other - 1), 1e-13):.0e}"
            table.writerow([*map(repr, numbers), model, "force", "vertical", "clamped", -0.5, s, f"{other:.16e}", f"{size:.16e}",
                            agreement])
