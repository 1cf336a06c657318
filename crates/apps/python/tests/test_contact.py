"""The call of codes that step in time."""

from __future__ import annotations

import asperity
import numpy as np
import pytest


def test_floats_give_floats_and_arrays_give_arrays(scene: asperity.Scene) -> None:
    contact = asperity.model("ke").compile(scene, separation_unit="m")
    force, tangent = contact.force_and_tangent(2e-6)
    assert type(force) is type(tangent) is float
    for number in (0, np.float64(1e-6), np.float32(1e-6), np.int64(0)):
        assert type(contact.force(number)) is float  # type: ignore[comparison-overlap]
    gaps = np.linspace(0, 4e-6, 12).reshape(3, 4)
    forces, tangents = contact.force_and_tangent(gaps)
    assert forces.shape == tangents.shape == (3, 4) and forces.flags.c_contiguous
    np.testing.assert_array_equal(contact.force(gaps), forces)
    np.testing.assert_array_equal(contact.evaluate("tangent", gaps.tolist()), tangents)
    assert contact.force_and_tangent(gaps[1, 2]) == (forces[1, 2], tangents[1, 2])
    assert contact.force(np.zeros(())).shape == () and contact.force([]).shape == (0,)
    assert contact.quantities == ("force", "tangent") and contact.scene == scene


def test_a_prepared_contact_has_the_same_digits(scene: asperity.Scene) -> None:
    ready, lazy = (asperity.model("ke").compile(scene, separation_unit="m") for _ in range(2))
    ready.prepare("-1 um", 5e-6)
    gaps = np.linspace(-1e-6, 5e-6, 41)
    np.testing.assert_array_equal(ready.force(gaps), lazy.force(gaps))
    assert ready.force_and_tangent(2e-6) == lazy.force_and_tangent(2e-6)


@pytest.mark.parametrize("unit", ["asperity_height_std", "m"])
def test_it_is_what_solve_says_in_the_same_unit(scene: asperity.Scene, unit: str) -> None:
    for name in ("gw", "zmc", "ke", "jg"):
        model = asperity.model(name)
        separations = np.linspace(-1, 5, 50) * (1e-6 if unit == "m" else 1.0)
        curve = model.solve(scene, separations, ["force", "tangent"], separation_unit=unit)
        contact = model.compile(scene, separation_unit=unit)
        assert contact.separation_unit == unit
        forces, tangents = contact.force_and_tangent(separations)
        np.testing.assert_allclose(forces, curve.force, rtol=1e-13)
        np.testing.assert_allclose(tangents, curve.tangent, rtol=1e-13)
        assert contact.force(separations[7]) == pytest.approx(curve.force[7], rel=1e-13)


def test_loads_and_pressures_go_where_separations_go(scene: asperity.Scene) -> None:
    ke = asperity.model("ke")
    contact = ke.compile(scene, ["force", "area", "tangent"])
    separation = ke.separation_at(scene, 1200.0)
    area = contact.evaluate("area", load=1200.0)
    assert area == pytest.approx(contact.evaluate("area", separation), rel=1e-12)
    pressures = np.array([[1200.0], [12.0]]) / scene.nominal_area
    by_pressure = contact.evaluate("area", pressure=pressures)
    assert by_pressure.shape == (2, 1) and by_pressure[0, 0] == pytest.approx(area, rel=1e-12)
