"""Asperities of two rough surfaces, and laws that depend on the density."""

from __future__ import annotations

import math

import asperity
import numpy as np
import pytest
from laws import Hertz

INTERFACE = asperity.Interface(116e9, 0.31, hardness=1.12e9)
SURFACE = asperity.Surface(3.6e-4, 1.1e8, 1e-6)
UNITS = ("asperity_height_std", "m")
SCENE = asperity.Scene(INTERFACE, SURFACE, 3e-5)


def force(scene: asperity.Scene, model: str, separation: float) -> float:
    return float(asperity.model(model).solve(scene, separation).force)


def test_separations_of_pairs_are_those_of_both_surfaces_on_one_scene_and_on_several() -> None:
    std = math.sqrt(2) * SURFACE.asperity_height_std
    ke = asperity.model("ke-pairs")
    sigmas, metres = (ke.separation_at(SCENE, load=1.0, separation_unit=u) for u in UNITS)
    assert float(metres) == pytest.approx(std * float(sigmas), rel=1e-12)
    varied = SCENE.vary(hardness=[1.12e9, 1.12e9 * (1 + 1e-9)])
    found = ke.separation_at(varied, load=1.0, separation_unit="m")
    assert np.asarray(found) == pytest.approx(float(metres), rel=1e-6)


class Plain(Hertz):
    """Hertz' law, which does not know the density."""

    def __init__(self, one: asperity.Asperity) -> None:
        assert one.density is None
        super().__init__(one)


class Scaled(Hertz):
    """Hertz' law times the density."""

    uses_density = True

    def __init__(self, one: asperity.Asperity) -> None:
        assert one.density is not None
        super().__init__(one)
        self.unit *= one.density


def test_a_law_of_your_own_knows_the_density_if_it_says_so() -> None:
    for density in (1e8, 2e8):
        scene = SCENE.replace(asperity_density=density)
        laws = [asperity.model(Scaled), asperity.model(Plain)]
        scaled, plain = (float(law.solve(scene, 1.0).force) for law in laws)
        assert scaled / plain == pytest.approx(density, rel=1e-10)
