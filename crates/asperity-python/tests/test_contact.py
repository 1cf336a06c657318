"""The call of codes that step in time."""

from __future__ import annotations


import asperity
import numpy as np
import pytest


def test_floats_give_floats_and_arrays_give_arrays(scene: asperity.Scene) -> None:
    contact = asperity.model("ke").compile(scene)
    force, tangent = contact.force_and_tangent(2e-6)
    assert type(force) is type(tangent) is float
    assert type(contact.force(0)) is type(contact.force(np.float64(1e-6))) is float
    gaps = np.linspace(0, 4e-6, 12).reshape(3, 4)
    forces, tangents = contact.force_and_tangent(gaps)
    assert forces.shape == tangents.shape == (3, 4) and forces.flags.c_contiguous
    np.testing.assert_array_equal(contact.force(gaps), forces)
    np.testing.assert_array_equal(contact.evaluate("tangent", gaps.tolist()), tangents)
    assert contact.force_and_tangent(gaps[1, 2]) == (forces[1, 2], tangents[1, 2])
    assert contact.quantities == ("force", "tangent") and contact.scene == scene


def test_it_is_what_solve_says(scene: asperity.Scene) -> None:
    for name in ("gw", "zmc", "ke", "jg"):
        model = asperity.model(name)
        gaps = np.linspace(-1e-6, 5e-6, 50)
        curve = model.solve(scene, gaps, ["force", "tangent"], separation_unit="m")
        forces, tangents = model.compile(scene).force_and_tangent(gaps)
        np.testing.assert_allclose(forces, curve.force, rtol=1e-13)
        np.testing.assert_allclose(tangents, curve.tangent, rtol=1e-13)


def test_gaps_are_from_the_scenes_plane(scene: asperity.Scene) -> None:
    plane = asperity.Scene(
        scene.interface, scene.surface, scene.nominal_area, separation_from="surface-mean"
    )
    there, here = (asperity.model("ke").compile(s) for s in (plane, scene))
    offset = plane.separation_offset
    assert there.force(1e-6 + offset) == pytest.approx(here.force(1e-6), rel=1e-13)


def test_only_what_was_compiled_is_there(scene: asperity.Scene) -> None:
    contact = asperity.model("ke").compile(scene, "area")
    assert contact.evaluate("area", 1e-6) > 0.0
    with pytest.raises(ValueError, match="force was not requested"):
        contact.force(1e-6)
    with pytest.raises(ValueError, match="was not requested"):
        contact.force_and_tangent(1e-6)
    with pytest.raises(ValueError, match="separation is NaN"):
        contact.evaluate("area", float("nan"))
    with pytest.raises(TypeError):
        contact.evaluate("area", "far")
