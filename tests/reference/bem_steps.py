#!/usr/bin/env python3
"""Contacts of periodic maps with steps by ContactMechanics (writes bem_steps.csv).

A saw-tooth (height 0.01 X) and a square wave (height 0.01 where X < 0.5), X = 0 to 1 across a square of side 1 m; elastic, periodic. Lengths in m,
pressures in Pa. Needs numpy and ContactMechanics 1.8.3. Takes seconds.
"""
import csv

import numpy as np
from ContactMechanics import PeriodicFFTElasticHalfSpace
from ContactMechanics.Optimization import constrained_conjugate_gradients

N, MODULUS, PRESSURE, HEIGHT = 64, 1e9, 5e6, 0.01


def main():
    x = np.arange(N) / N
    shapes = {"saw-tooth": HEIGHT * x, "square": HEIGHT * (x < 0.5)}
    with open("bem_steps.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["shape", "n", "modulus", "height", "pressure", "pixel_area", "p_max"])
        for name, line in shapes.items():
            h = np.tile(line, (N, 1))
            half_space = PeriodicFFTElasticHalfSpace((N, N), MODULUS, (1.0, 1.0))
            found = constrained_conjugate_gradients(half_space, h, external_force=PRESSURE, pentol=1e-10 * h.std(), maxiter=20000)
            assert found.success, found.message
            p = found.jac * N**2
            row = [name, N, MODULUS, HEIGHT, PRESSURE, repr(float((p > 0).mean())), "%.12e" % p.max()]
            table.writerow(row)
            print(*row)


if __name__ == "__main__":
    main()
