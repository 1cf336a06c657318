#!/usr/bin/env python3
"""Reference contacts by other people's codes (writes bem_codes.csv): tamaas (elastic) and ContactMechanics (elastic, and with a hardness).

Surfaces: the random surfaces of asperity-bem, made by bem_dense.py from their documentation alone. Periodic; both codes iterate to tolerances far below
what is compared. Pressures and hardness in Pa, gaps in m. Needs numpy, tamaas 2.9.0, ContactMechanics 1.8.3. Takes a minute.
"""
import csv

import numpy as np
import tamaas
from ContactMechanics import PeriodicFFTElasticHalfSpace
from ContactMechanics.Optimization import constrained_conjugate_gradients

from bem_dense import MODULUS, SURFACE, edges, surface

SIDE, UNIT = SURFACE["side"], MODULUS * SURFACE["gradient"]
CASES = [  # seed, n, shortest wave per side
    (5, 128, 8.0),
    (6, 96, 12.0),
]
HEAD = "code seed n shortest hardness pressure pixels plastic edges area mean_gap".split()


def by_tamaas(h, pressure, _):
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [SIDE, SIDE], list(h.shape))
    model.E, model.nu = MODULUS, 0.0
    solver = tamaas.PolonskyKeerRey(model, h, 1e-12)
    solver.max_iter, solver.dump_freq = 100000, 10**9
    solver.solve(pressure)
    # Displacements know no mean: nothing lies below the contact.
    gap = model.displacement - h
    return model.traction.copy(), gap - gap.min()


def by_contact_mechanics(h, pressure, hardness):
    half_space = PeriodicFFTElasticHalfSpace(h.shape, MODULUS, (SIDE, SIDE))
    pixel = (SIDE / len(h)) ** 2
    found = constrained_conjugate_gradients(
        half_space, h, hardness=None if hardness is None else hardness * pixel, external_force=pressure * SIDE**2, pentol=1e-9 * h.std(), maxiter=20000
    )
    assert found.success, found.message
    return found.jac / pixel, found.x - h - found.offset


def main():
    with open("bem_codes.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(HEAD)
        for seed, n, shortest in CASES:
            h = surface(**{**SURFACE, "shortest": shortest}, seed=seed, n=n)
            h = h - h.mean()
            for code, solve, hardnesses in (("tamaas", by_tamaas, [None]), ("ContactMechanics", by_contact_mechanics, [None, 0.4 * UNIT, 0.15 * UNIT])):
                for hardness in hardnesses:
                    for pressure in (0.003 * UNIT, 0.02 * UNIT, 0.1 * UNIT):
                        p, gap = solve(h, pressure, hardness)
                        c = p > 0
                        plastic = 0 if hardness is None else (p >= hardness * (1 - 1e-9)).sum()
                        perimeter = edges(c, True)
                        # Yastrebov's correction of the counted area, as in tamaas' documentation.
                        area = (c.sum() - (np.pi - 1 + np.log(2)) / 24 * perimeter) / c.size
                        row = [code, seed, n, shortest, "" if hardness is None else repr(hardness), repr(pressure)]
                        row += [c.sum(), plastic, perimeter, "%.15e" % area, "%.15e" % gap.mean()]
                        table.writerow(row)
                        file.flush()
                        print(*row)


if __name__ == "__main__":
    main()
