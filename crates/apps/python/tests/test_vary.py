"""Scenes varied by the numbers that gave them: bodies, moments, parameters of ISO 25178."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import asperity
import numpy as np
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
    {"sdq": 0.058, "sq": 1.1e-6, "spd": 2e8},
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


def test_the_interface_is_made_again_from_its_bodies() -> None:
    scene = asperity.Scene(PAIR, asperity.Surface(2e-4, 2e8, 1e-6), 1e-4)
    softer = asperity.Body(100e9, 0.3, hardness=2e9)
    wanted = asperity.Interface.between(softer, ALUMINIUM, work_of_adhesion=0.05)
    varied = scene.vary(body1_youngs_modulus=["210 GPa", "100 GPa"])
    assert [varied[k].interface for k in range(2)] == [PAIR, wanted]
    # The work of adhesion belongs to the pair, not to a body.
    both = scene.replace(work_of_adhesion=0.1, body2_hardness=3e9)
    harder = ALUMINIUM.replace(hardness=3e9)
    assert both.interface == asperity.Interface.between(STEEL, harder, work_of_adhesion=0.1)
    kept = pickle.loads(pickle.dumps(scene.replace(work_of_adhesion=0.1)))
    assert kept.replace(body2_hardness=3e9).interface == both.interface
    rigid = asperity.Interface.against_rigid(STEEL)
    scene = asperity.Scene(rigid, asperity.Surface(2e-4, 2e8, 1e-6), 1e-4)
    half = asperity.Interface.against_rigid(STEEL.replace(youngs_modulus=105e9))
    assert scene.replace(youngs_modulus="105 GPa").interface == half


def test_numbers_of_both_bodies_and_of_one_are_edits_of_the_file() -> None:
    text = FILE.replace("yield_strength = \"400 MPa\"", "hardness = 2e9")
    scene = asperity.Scene.parse(text)
    both = scene.vary(hardness=[2e9, 2.2e9], youngs_modulus=[210e9, 200e9])[1]
    edited = text.replace("hardness = 2e9", "hardness = 2.2e9").replace("210 GPa", "200 GPa")
    assert both.interface == asperity.Scene.parse(edited).interface
    # The softer body yields, whichever is varied.
    assert scene.replace(body1_hardness=2.2e9).interface.hardness == 2e9
    assert scene.replace(body1_hardness=1.8e9).interface.hardness == 1.8e9
    one = scene.replace(hardness=2.2e9, body1_youngs_modulus=200e9)
    assert one == scene.replace(body1_youngs_modulus=200e9, hardness=2.2e9)


def test_a_plasticity_index_stays_where_it_was_written() -> None:
    surface = "plasticity_index = 2.0\nroughness_parameter = 0.04\nasperity_height_std = {:e}\n"
    head = FILE.partition("[surface]")[0] + "[surface]\n"
    scene = asperity.Scene.parse(head + surface.format(1e-6))
    kept = pickle.loads(pickle.dumps(scene))
    for scene in (scene, kept, copy.deepcopy(scene)):
        varied = scene.vary(asperity_height_std=[1e-6, 0.5e-6])
        assert varied[1].surface == asperity.Scene.parse(head + surface.format(0.5e-6)).surface


def test_a_counterface_stays_where_numbers_of_the_first_surface_change() -> None:
    text = FILE + "[surface.counterface]\nasperity_radius = 1e-4\nasperity_density = 1e9\n"
    text = 'accept = ["gaussian-moments"]\n' + text + "asperity_height_std = 4e-7\n"
    scene = asperity.Scene.parse(text)
    wanted = asperity.Scene.parse(text.replace("0.5 um2", "0.6 um2"))
    for scene in (scene, pickle.loads(pickle.dumps(scene))):
        varied = scene.replace(m0=0.6e-12)
        found = [
            asperity.model("ke-pairs").solve(one, load=1000.0, quantities="tangent").tangent
            for one in (varied, wanted)
        ]
        assert found[0] == found[1]


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


def test_a_sweep_varies_the_numbers_that_gave_the_scene() -> None:
    scene = asperity.Scene.parse(FILE)
    inputs = {"load": 1000.0, "m2": [0.015, 0.025], "youngs_modulus": ["190 GPa", "210 GPa"]}
    result = asperity.sweep(scene, inputs, "ke", "tangent")
    alone = scene.replace(m2=0.025, youngs_modulus=190e9)
    wanted = asperity.model("ke").solve(alone, load=1000.0, quantities="tangent").tangent
    assert abs(result.tangent.sel(m2=0.025, youngs_modulus=190e9) / wanted - 1.0) < 1e-9


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"sq": 1e-6}, "^sq "),
        (
            {"equivalent_modulus": 1e11, "youngs_modulus": 1e11},
            "^equivalent_modulus .*youngs_modulus",
        ),
        (
            {"hardness": 1e9, "body1_hardness": 1e9},
            "^hardness .*body1_hardness",
        ),
        (
            {"m0": 1e-12, "asperity_radius": 1e-4},
            "^asperity_radius .*m0",
        ),
        ({"m0": -1.0}, "m0 is -1"),
        ({"body1_youngs_modulus": -1.0}, "youngs_modulus is -1"),
    ],
)
def test_numbers_that_do_not_fit_the_scene_are_refused(
    given: dict[str, float], message: str
) -> None:
    scene = asperity.Scene(PAIR, asperity.Surface.of(m0=1e-12, m2=1e-4, m4=5e4), 1e-4)
    with pytest.raises(ValueError, match=message):
        scene.replace(**given)


def test_a_scene_without_bodies_says_that_youngs_modulus_needs_them() -> None:
    interface = asperity.Interface(116e9, 0.31, hardness=1.12e9)
    scene = asperity.Scene(interface, asperity.Surface(2e-4, 2e8, 1e-6), 1e-4)
    with pytest.raises(ValueError, match="^youngs_modulus "):
        scene.vary(youngs_modulus=np.array([1e11, 2e11]))


def test_the_second_surface_has_names_of_its_own() -> None:
    text = FILE.split("[surface]")[0] + "[surface]\nm0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\n"
    other = "counterface = { m0 = 4e-13, m2 = 2e-5, m4 = 3e4 }\n"
    scene = asperity.Scene.parse(text + other).replace(counterface_m0=5e-13)
    assert scene == asperity.Scene.parse(text + other.replace("4e-13", "5e-13"))
    assert scene != asperity.Scene.parse(text + other)
