"""Widths of answers on two like ground, turned, ... steel faces, in closed form: finishes_answers.csv.

finishes_scans.csv and finishes_rsm.csv are measured, not made here: mean slope of profiles across
the lay, bandwidth, Rz and RSm of the test files of open surface libraries (14 surfaces without a
documented finish; the finish is judged by the look of the surface), under Gaussian filters of ISO
16610-21 with these cut-offs; Rz and RSm as by ISO 4287.

Each row: Ra [um]; ends of the mean slope across the lay, 0.125 Rq^0.402 (um) times the range of the
finish; ends of the rms gradient of both faces; upper over lower end of the elastic area
2 p/(E g), of an area with yielding 1/H + 2/(E g), of the stiffness 1/Rq and of the plastic
conductance m/Rq, for E = 115 GPa.
"""

import csv
from math import pi, sqrt

E = 115e9
# Rq/Ra, m/(0.125 Rq^0.402), slope along over across the lay.
FINISHES = {
    "ground": ((1.19, 1.4), (0.4, 1.5), (0.25, 0.66)),
    "turned": ((1.1, 1.25), (0.3, 1.6), (0.1, 0.5)),
    "milled": ((1.15, 1.34), (0.3, 1.2), (0.5, 1)),
    "lapped": ((1.2, 1.4), (0.35, 1.25), (1, 1)),
    "polished": ((1.2, 2.6), (0.06, 0.7), (0.4, 1)),
    "honed": ((1.3, 1.65), (0.4, 1.2), (0.3, 1)),
    "blasted": ((1.2, 1.35), (0.55, 1.25), (1, 1)),
    "unknown": ((1.1, 1.65), (0.25, 1.8), (0.2, 1)),
}
CASES = [("ground", 0.8), ("ground", 0.2), ("turned", 1.6), ("milled", 1.6), ("lapped", 0.1)]
CASES += [("polished", 0.02), ("honed", 0.4), ("blasted", 3.2), ("unknown", 0.8)]
HEADS = "finish ra_um slope_lower slope_upper gradient_lower gradient_upper elastic_area "
HEADS += "yielding_area_2GPa yielding_area_7GPa stiffness plastic_conductance"

with open("finishes_answers.csv", "w", newline="") as file:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(HEADS.split())
    for finish, ra in CASES:
        heights, ratios, lay = FINISHES[finish]
        rq = [ra * ratio for ratio in heights]
        m = [0.125 * q**0.402 * ratio for q, ratio in zip(rq, ratios)]
        # Two faces, each with <z'^2> = pi m^2/2 across the lay.
        g = [s * sqrt(pi * (1 + k * k)) for s, k in zip(m, lay)]
        # Slope and Rq vary each by itself.
        slope_over_rq = [0.125 * q**-0.598 * ratio for q, ratio in zip(rq[::-1], ratios)]
        areas = [[1 / hardness + 2 / (E * one) for one in g] for hardness in (2e9, 7e9)]
        widths = [g[1] / g[0], *(one[0] / one[1] for one in areas)]
        widths += [rq[1] / rq[0], slope_over_rq[1] / slope_over_rq[0]]
        rows.writerow([finish, ra, *(f"{x:.6g}" for x in (*m, *g, *widths))])
