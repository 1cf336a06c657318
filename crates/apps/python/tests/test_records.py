"""Bodies, interfaces, surfaces and scenes: arguments, units, equality, copies."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import asperity
import numpy as np
import pytest

STEEL = asperity.Body(210e9, 0.3, hardness=2e9)


def wrong(argument: object) -> Any:
    """An argument of a type that is not allowed."""
    return argument


def test_numbers_are_read_with_their_units_as_in_scene_files() -> None:
    aluminium = asperity.Body(
        "69 GPa",
        0.33,
        yield_strength="275 N/mm2",
        thermal_conductivity="1.67 W/(cm K)",
        electrical_resistivity="4 uohm cm",
    )
    assert aluminium == asperity.Body(
        69e9,
        0.33,
        yield_strength=275e6,
        thermal_conductivity=167.0,
        electrical_resistivity=4e-8,
    )
    pair = asperity.Interface.between(aluminium, STEEL, work_of_adhesion="50 mJ/m2")
    assert pair.work_of_adhesion == 0.05
    surface = asperity.Surface("0.2 mm", "200 1/mm2", "1 um")
    assert surface == asperity.Surface(2e-4, 2e8, 1e-6)
    assert surface == asperity.Surface(np.float32(2e-4), 2e8, 1e-6).replace(asperity_radius=2e-4)
    scene = asperity.Scene(pair, surface, "100 mm2")
    assert scene.nominal_area == 1e-4
    assert scene.replace(hardness="3 GPa").interface.hardness == 3e9
    assert asperity.check(scene, load="2 kN").numbers == asperity.check(scene, load=2000.0).numbers
    scenes = scene.vary(hardness=["1 GPa", "2 GPa"], nominal_area="1 cm2")
    assert [scenes[k].interface.hardness for k in range(2)] == [1e9, 2e9]
    text = """
        nominal_area = "100 mm2"
        rigid_counterface = true
        [[body]]
        youngs_modulus = "69 GPa"
        poissons_ratio = 0.33
        hardness = "770 MPa"
        [surface]
        sq = "1.1 um"
        spd = "200 1/mm2"
        spc = "5 1/mm"
    """
    by_file = asperity.Scene.parse(text)
    assert by_file.surface == asperity.Surface.of(sq="1.1 um", spd="200 1/mm2", spc="5 1/mm")
    assert by_file.surface == asperity.Surface.of(sq=1.1e-6, spd=2e8, spc=5e3)
    body = asperity.Body("69 GPa", 0.33, hardness="770 MPa")
    assert by_file.interface == asperity.Interface.against_rigid(body)
    # The peaks are the asperities, and sq belongs to the surface: std below sq.
    assert by_file.surface.asperity_radius == 2e-4 and by_file.surface.asperity_density == 2e8
    of_std: dict[str, Any] = {"asperity_radius": "0.2 mm", "surface_height_std": "1.1 um"}
    assert by_file.surface == asperity.Surface.of(**of_std, asperity_density=2e8)
    assert by_file.surface.asperity_height_std < 1.1e-6


def test_records_are_frozen_equal_hashable_and_copied() -> None:
    interface = asperity.Interface.between(STEEL, STEEL)
    surface = asperity.Surface(2e-4, 2e8, 1e-6)
    asperity_of = asperity.Scene(interface, surface, 1e-4).asperity
    for record in (STEEL, interface, surface, asperity_of):
        again = pickle.loads(pickle.dumps(record))
        assert again == copy.deepcopy(record) == record and hash(again) == hash(record)
        assert again.replace() == record and record != wrong(1.0)
        assert eval(repr(asperity_of.replace()), vars(asperity)) == asperity_of
    assert STEEL.replace(hardness="3 GPa", yield_strength=1e9) != STEEL
    assert STEEL.replace(hardness=None).hardness is None
    assert {STEEL: 1}[asperity.Body("210 GPa", 0.3, "2 GPa")] == 1
    with pytest.raises(AttributeError):
        STEEL.hardness = 1.0  # type: ignore[misc]
    with pytest.raises(TypeError, match="hardnes"):
        STEEL.replace(hardnes=1.0)
    with pytest.raises(TypeError):
        hash(asperity.Scene(interface, surface, 1e-4))
    no_plane = asperity.Scene(interface, surface, 1e-4, heights={"skewness": -0.5})
    assert no_plane.heights == {"skewness": -0.5}
    assert eval(repr(no_plane), vars(asperity)) == no_plane
