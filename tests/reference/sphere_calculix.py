"""One asperity by the finite elements of CalculiX 2.20 (`ccx` of Debian): python sphere_calculix.py > ../../xtask/data/world/sphere-calculix.csv

A second set of points beside sphere.csv, by a program of other people: axisymmetric CAX4 elements (fully integrated
bricks in CalculiX), J2 plasticity with linear isotropic hardening, small strains, a body
whose top is -r^2/(2R) under a stiff plate, frictionless contact of nodes with a linear penalty. A quarter of an hour.
Unloading does not converge in it.
"""

import math
import os
import re
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
E, R = 1000.0, 1000.0  # the yield stress is 1: E/Y = 1000 has small slopes
ELEMENTS = 44  # on the contact radius at the largest interference
RUNS = [  # nu, E_t/E, largest w/w_c, number of loads
    (0.3, 0.0, 1.0, 8),
    (0.3, 0.0, 10.0, 14),
    (0.3, 0.0, 50.0, 14),
    (0.3, 0.0, 110.0, 14),
    (0.3, 0.02, 110.0, 14),
    (0.2, 0.0, 110.0, 10),
    (0.4, 0.0, 110.0, 10),
]


def radii(contact):
    """Equal steps up to 1.3 contact radii, then growing to 40."""
    step = contact / ELEMENTS
    r = [k * step for k in range(int(1.3 * ELEMENTS) + 1)]
    while r[-1] < 40 * contact:
        step *= 1.15
        r.append(r[-1] + step)
    return r


def deck(nu, hardening, contact, interferences):
    """The text of the input."""
    r = radii(contact)
    n, lines = len(r), ["*NODE"]
    node = lambda i, j: 1 + i + n * j
    for j in range(n):
        for i in range(n):
            top = min(r[i], 3 * contact) ** 2 / (2 * R) * math.exp(-r[j] / (10 * contact))
            lines.append(f"{node(i, j)},{r[i]:.9g},{-r[j] - top:.12g},0")
    plate, width, height = n * n, 1.6 * contact, 5 * contact / ELEMENTS
    for k, (x, z) in enumerate([(0, 0), (width, 0), (width, height), (0, height)]):
        lines.append(f"{plate + 1 + k},{x:.9g},{z:.9g},0")
    lines.append("*ELEMENT, TYPE=CAX4, ELSET=BODY")
    cells = [(i, j) for j in range(n - 1) for i in range(n - 1)]
    for k, (i, j) in enumerate(cells):
        lines.append(f"{k + 1},{node(i, j + 1)},{node(i + 1, j + 1)},{node(i + 1, j)},{node(i, j)}")
    lines += ["*ELEMENT, TYPE=CAX4, ELSET=PLATE"]
    lines += [f"{len(cells) + 1}," + ",".join(str(plate + k) for k in range(1, 5))]
    sets = {
        "TOP": [node(i, 0) for i in range(n) if r[i] <= 1.5 * contact],
        "BASE": [node(i, n - 1) for i in range(n)],
        "AXIS": [node(0, j) for j in range(n)],
        "PL": [plate + k for k in range(1, 5)],
    }
    for name, members in sets.items():
        lines += [f"*NSET, NSET={name}", *(f"{member}," for member in members)]
    slope = max(E * hardening / (1 - hardening), 1e-4)
    penalty = 2e3 * E * ELEMENTS / contact
    solid, step = (HERE / "sphere_calculix.inp").read_text().rstrip("\n").split("\n--\n")
    numbers = {"modulus": E, "nu": nu, "flow": 1 + 5 * slope, "stiff": 100 * E, "plate": len(cells) + 1, "penalty": penalty}
    lines.append(solid.format(**numbers))
    lines += [step.format(down=-w) for w in interferences]
    return "\n".join(lines) + "\n"


def solve(nu, hardening, largest, loads):
    s_h = 2.8 * (0.454 + 0.41 * nu)
    critical = (math.pi * s_h * (1 - nu * nu) / (2 * E)) ** 2 * R
    force, area = 2 / 3 * math.pi * R * critical * s_h, math.pi * R * critical
    contact = 1.02 * math.sqrt(largest * critical * R) * max(1.0, 1.05 * (largest / 1.9) ** 0.068)
    x = [largest * (k / loads) ** 1.5 for k in range(1, loads + 1)]
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/sphere.inp", "w") as file:
            file.write(deck(nu, hardening, contact, [at * critical for at in x]))
        one = {**os.environ, "OMP_NUM_THREADS": "1"}
        subprocess.run(["ccx", "sphere"], cwd=folder, stdout=subprocess.DEVNULL, env=one)
        text = open(f"{folder}/sphere.dat").read()
    for at, block in zip(x, re.split("total force", text)[1:]):
        head, springs = block.split("contact stress")
        # Of two degrees of the circle.
        load = -180 * float(head.split("\n")[2].split()[1])
        pressures = [float(line.split()[1]) for line in springs.split("\n")[1:] if re.match(r" *\d+ ", line)]
        held = sum(p > 0 for p in pressures)
        radius = (held - 0.5) * contact / ELEMENTS
        print(f"{nu},{hardening},{ELEMENTS},{largest},load,{at:.6g},{load / force:.6g},{math.pi * radius**2 / area:.6g}")


if __name__ == "__main__":
    print("# One asperity by the finite elements of CalculiX 2.20: sphere_calculix.py; columns of sphere.csv")
    print("nu,Et_over_E,elements,x_max,phase,x,force,area")
    for run in RUNS:
        solve(*run)
