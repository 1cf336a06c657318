"""Scenes varied by the numbers that gave them: bodies, moments, parameters of ISO 25178."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import asperity
import pytest

STEEL = asperity.Body(210e9, 0.3, hardness=2e9)
ALUMINIUM = asperity.Body(70e9, 0.33, hardness=1e9)
PAIR = asperity.Interface.between(STEEL, ALUMINIUM, work_of_adhesion=0.05)

FILE = """
nominal_area = "2500 mm2"
[[body]]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
yield_strength = "400 MPa"
[[body]]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
yield_strength = "400 MPa"
[surface]
m0 = "0.5 um2"
m2 = 0.02
m4 = 6e9
"""

WAYS: list[dict[str, Any]] = [
    {"m0": 1e-12, "m2": 1e-4, "m4": 5e4},
    {"sq": 1.1e-6, "spd": 2e8, "spc": 5e3},
    {"asperity_radius": 2e-4, "asperity_density": 2e8, "surface_height_std": 1.1e-6},
]


@pytest.mark.parametrize("numbers", WAYS)
def test_the_surface_is_made_again_from_its_own_numbers(numbers: dict[str, Any]) -> None:
    make = asperity.Surface.of
    scene = asperity.Scene(PAIR, make(**numbers), 1e-4)
    for name, value in numbers.items():
        wanted = make(**{**numbers, name: 1.1 * value})
        varied = scene.vary(**{name: [value, 1.1 * value]})
        assert varied[0].surface == scene.surface
        assert varied[1].surface == wanted != scene.surface
        for again in (varied[1], pickle.loads(pickle.dumps(varied[1])), copy.deepcopy(varied[1])):
            assert again.replace(**{name: value}).surface == scene.surface
        direct = asperity.model("gw").solve(asperity.Scene(PAIR, wanted, 1e-4), 1.0).force
        assert abs(asperity.model("gw").solve(varied, 1.0).force[1] / direct - 1.0) < 1e-9


# A yield strength alone is a range of hardnesses.
@pytest.mark.filterwarnings("ignore:taken-at: ")
def test_a_scene_file_varies_by_its_keys() -> None:
    scene = asperity.Scene.parse(FILE)
    moduli = [210e9, 70e9]
    varied = scene.vary(youngs_modulus=moduli, m0=[0.5e-12, 0.6e-12])
    found = asperity.model("ke").solve(varied, load=1000.0, quantities="tangent").tangent
    texts = [FILE, FILE.replace("210 GPa", "70 GPa").replace("0.5 um2", "0.6 um2")]
    for value, text in zip(found, texts, strict=True):
        alone = asperity.model("ke").solve(
            asperity.Scene.parse(text), load=1000.0, quantities="tangent"
        )
        assert abs(value / alone.tangent - 1.0) < 1e-9
    asperity.Scene.parse(varied[1].to_toml())
