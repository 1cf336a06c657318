#!/usr/bin/env python3
"""Contact with volumetric J2 plasticity (the rows of bem_j2.csv), beside which the cap of the boundary elements is tested.

Equations of tamaas 2.9.0 (EPIC: Polonsky & Keer's contact on a half-space whose upper layers yield, isotropic linear hardening, nu 0.3); the strain and the
contact are iterated together by Anderson mixing instead of one inside the other. E/(1 - nu^2) = 1, side 1, depth of the yielding layers 0.3.
Rough: the surfaces of asperity-bem (longest wave 1 per side, roll-off 2, shortest 4, Hurst 0.8, gradient g = 0.1); hardness and load over E g, yield
stress = hardness/2.8. Sphere: R = 1, yield stress 0.02, load over that of first yield. Hardening modulus over E of the body. Needs numpy, tamaas 2.9.0.
Residual: norm of the strain's residual over that of its increment (stops at 5e-4, or below 2.5e-3 if the area moved by less than 0.2 % over 12 evaluations,
or after 70). Run as (36 s to 6 min a row):
  bem_j2.py 64 24 "r:1:0.4:0.01:0.02/0.1 r:1:0.15:0.004:0.02/0.05 s:0:0:0.01:3/30" out.csv 5e-4
"""
import sys

import numpy as np
import tamaas
from tamaas.materials import IsotropicHardening

from bem_dense import edges, surface

DEPTH, MOST, MEMORY = 0.3, 70, 10
tamaas.set_log_level(tamaas.LogLevel.warning)


class Body:
    """A half-space with heights h whose upper layers yield."""

    def __init__(self, h, layers, yield_stress, hardening, nu=0.3):
        n = len(h)
        self.model = tamaas.ModelFactory.createModel(tamaas.model_type.volume_2d, [DEPTH, 1.0, 1.0], [layers, n, n])
        self.model.nu, self.model.E = nu, 1 - nu**2
        self.undeformed, self.heights = h - h.mean(), (h - h.mean()).copy()
        self.material = IsotropicHardening(self.model, sigma_y=yield_stress, hardening=hardening * self.model.E)
        self.residual = tamaas.Residual(self.model, self.material)
        self.contact = tamaas.PolonskyKeerRey(self.model, self.heights, 1e-10)
        self.contact.dump_freq = 10**9
        self.strain = np.zeros_like(self.residual.vector)

    def residual_at(self, strain, pressure):
        """Presses the surface that this strain leaves, and returns the residual of the strain."""
        self.residual.computeResidualDisplacement(strain)
        self.heights[:] = self.undeformed - self.model.displacement[0, :, :, 2]
        self.contact.solve(pressure)
        self.residual.computeResidual(strain)
        return self.residual.vector.copy()

    def solve(self, pressure, tolerance):
        """Anderson mixing; returns the relative residual and the number of evaluations."""
        strain, strains, residuals, last, areas = self.strain.copy(), [], [], None, []
        for count in range(1, MOST + 1):
            found = self.residual_at(strain, pressure)
            error = np.linalg.norm(found) / max(np.linalg.norm(strain), 1e-300)
            areas.append((self.model.traction[..., 2] > 0).mean())
            is_still = count > 31 and np.ptp(areas[-12:]) < 2e-3 * areas[-1] and error < 5 * tolerance
            if error < tolerance or is_still:
                break
            if last is not None:
                strains.append((strain - last[0]).ravel())
                residuals.append((found - last[1]).ravel())
                strains, residuals = strains[-MEMORY:], residuals[-MEMORY:]
            last = (strain.copy(), found)
            step = -found
            if residuals:
                products = np.array([[a @ b for b in residuals] for a in residuals])
                right = np.array([a @ found.ravel() for a in residuals])
                shares = np.linalg.lstsq(products, right, rcond=1e-12)[0]
                mixed = sum(g * (x - r) for g, x, r in zip(shares, strains, residuals))
                step = step - mixed.reshape(strain.shape)
            strain = strain + step
        self.strain = strain
        return error, count

    def keep(self):
        """Makes the plastic strain of the solution permanent."""
        self.residual.updateState(self.strain)
        self.strain = np.zeros_like(self.strain)


def rows(case, n, layers, tolerance):
    kind, seed, hardness, hardening, loads = case.split(":")
    if kind == "s":
        x = (np.arange(n) + 0.5) / n - 0.5
        h, yield_stress = -(x[:, None] ** 2 + x[None, :] ** 2) / 2, 0.02
        s_h = 1.615 * yield_stress
        critical = (np.pi * s_h / 2) ** 2
        unit = 2 / 3 * np.pi * critical * s_h
    else:
        h = surface(longest=1.0, roll_off=2.0, shortest=4.0, hurst=0.8, side=1.0, gradient=0.1, seed=int(seed), n=n)
        unit, yield_stress = 0.1, float(hardness) * 0.1 / 2.8
    body = Body(h, layers, yield_stress, float(hardening))
    for load in map(float, loads.split("/")):
        error, count = body.solve(load * unit, tolerance)
        pressures = body.model.traction[..., 2]
        touching, highest = pressures > 0, pressures.max() / yield_stress
        edge = edges(touching, True)
        area = (touching.sum() - (np.pi - 1 + np.log(2)) / 24 * edge) / touching.size
        # The surface alone, for the gap.
        body.contact.solve(load * unit)
        gap = body.model.displacement[0, :, :, 2] - body.heights
        gap = (gap - gap.min()).mean()
        body.keep()
        plastic = np.abs(body.model["plastic_strain"])
        bottom = plastic[-1].max() / max(plastic.max(), 1e-99)
        numbers = ["%.6g" % x for x in (area, gap, highest, error)]
        name = {"r": "rough", "s": "sphere"}[kind]
        yield [name, seed, n, layers, float(hardness), float(hardening), load, touching.sum(), edge, *numbers, count, "%.6g" % bottom, "%.6g" % plastic.max()]


if __name__ == "__main__":
    n, layers, cases, out, tolerance = sys.argv[1:]
    with open(out, "a") as file:
        for case in cases.split():
            for row in rows(case, int(n), int(layers), float(tolerance)):
                print(*row, sep=",", file=file, flush=True)
