"""Loads and pressures in the place of separations; failed rows; masks."""

from __future__ import annotations

import warnings
from typing import Any

import asperity
import numpy as np
import pytest


def test_separations_of_loads_are_in_the_unit_and_from_the_plane(scene: asperity.Scene) -> None:
    plane = asperity.Scene(
        scene.interface, scene.surface, scene.nominal_area, separation_from="surface-mean"
    )
    ke, std = asperity.model("ke"), scene.surface.asperity_height_std
    offset = scene.surface.mean_plane_offset
    here = ke.separation_at(scene, 100.0)
    assert ke.separation_at(plane, 100.0) == pytest.approx(here + offset / std, rel=1e-12)
    for scenes in (plane, [plane], plane.vary(hardness=[2e9])):
        metres = ke.separation_at(scenes, 100.0, separation_unit="m")
        np.testing.assert_allclose(metres, here * std + offset, rtol=1e-12)
        curve = ke.solve(scenes, load=[100.0], quantities="area", separation_unit="m")
        np.testing.assert_allclose(curve.separation, metres, rtol=1e-12)


def test_rows_that_no_separation_carries_are_masked_with_their_reasons(
    scene: asperity.Scene,
) -> None:
    ke = asperity.model("ke")
    loads = [1.0, 1e30, 100.0, -1.0, 10.0]
    for scenes in (scene, [scene], scene.vary(hardness=[2e9])):
        curve = ke.solve(scenes, load=loads, quantities=["area", "force"], errors="mask")
        assert np.ma.getmaskarray(curve.area).tolist() == [False, True, False, True, False]
        assert not np.isnan(curve.area.compressed()).any()  # type: ignore[attr-defined]
        assert sorted(curve.failures) == [1, 3]
        assert curve.failures[1].startswith("load is 1e30 N")
        assert curve.failures[3].startswith("load is -1: ")
        good = ke.solve(scenes, load=loads[::2], quantities="area")
        np.testing.assert_allclose(curve.area.compressed(), good.area, rtol=1e-12)  # type: ignore[arg-type, attr-defined]
        for values in (curve.error("area"), curve.ln("force"), curve.separation):
            assert np.ma.getmaskarray(values).tolist() == [False, True, False, True, False]
        shares = curve.shares("force")
        np.testing.assert_allclose(sum(shares.values()).compressed(), 1.0, rtol=1e-12)  # type: ignore[union-attr]
        found = ke.separation_at(scenes, loads, errors="mask")
        np.testing.assert_allclose(found, curve.separation)


def test_what_fails_of_one_quantity_does_not_take_the_others_with_it() -> None:
    # Nothing is higher than 1 um: beyond, the force is 0 and its logarithm is nothing.
    table = (np.array([-1e-6, 1e-6]), np.array([5e5, 5e5]))
    scene = asperity.Scene(
        asperity.Interface(116e9, 0.31, 1e9), asperity.Surface(3.6e-4, 1.1e8, 6e-7), 3e-5, table
    )
    ke = asperity.model("ke")
    for scenes in (scene, [scene]):
        with pytest.warns(asperity.ContactWarning, match="no asperity touches"):
            curve = ke.solve(
                scenes, [0.5, 3.0], ["force", "ln-force", "mean-pressure"], errors="mask"
            )
        assert curve.force[1] == 0.0 and not np.ma.getmaskarray(curve.force).any()
        assert np.ma.getmaskarray(curve.mean_pressure).tolist() == [False, True]
        assert "no asperity" in curve.failures[1]
        with pytest.raises(ValueError, match="ln-force has no"):
            ke.solve(scenes, [0.5, 3.0], ["force", "ln-force"])


def test_all_crossings_are_given_where_they_are_asked_for(soft_steel: asperity.Scene) -> None:
    printed = asperity.model("at")
    load = 1e-4
    scenes: Any
    for scenes in (soft_steel, [soft_steel]):
        largest = printed.separation_at(scenes, load)
        everything = printed.separation_at(scenes, load, all=True)
        found = np.asarray(everything).item()
        assert len(found) == 3 and (np.diff(found) > 0.0).all()  # type: ignore[arg-type]
        assert float(np.asarray(largest).item()) == pytest.approx(found[-1], rel=1e-12)  # type: ignore[index]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        back = printed.solve(soft_steel, found).force
    np.testing.assert_allclose(back, load, rtol=1e-6)
    ke = asperity.model("ke")
    some = ke.separation_at(soft_steel, [[1.0], [1e30]], all=True, errors="mask")
    assert some.shape == (2, 1) and np.ma.getmaskarray(some).tolist() == [[False], [True]]
    assert some[0, 0].tolist() == [pytest.approx(float(ke.separation_at(soft_steel, 1.0)))]


def test_masked_in_is_masked_out(scene: asperity.Scene) -> None:
    ke = asperity.model("ke")
    separation = np.ma.masked_array([0.0, 1.0, np.nan, 2.0], [False, False, True, False])
    for scenes in (scene, [scene]):
        curve = ke.solve(scenes, separation, ["force", "area"])
        for values in (curve.force, curve.area, curve.error("force"), curve.shares("area")["plastic"]):
            assert np.ma.getmaskarray(values).tolist() == [False, False, True, False]
        plain = ke.solve(scenes, [0.0, 1.0, 2.0])
        np.testing.assert_array_equal(curve.force.compressed(), plain.force)  # type: ignore[attr-defined]
        assert curve.failures == {}
        found = ke.separation_at(scenes, np.ma.masked_less([-1.0, 1.0], 0.0))
        assert np.ma.getmaskarray(found).tolist() == [True, False]
        failing = np.ma.masked_array([1.0, -1.0, 1e30], [True, False, False])
        curve = ke.solve(scenes, load=failing, errors="mask")
        assert sorted(curve.failures) == [1, 2]


def test_every_quantity_of_the_library_is_there(scene: asperity.Scene) -> None:
    # Flows belong to models of their own, and patches to curved bodies.
    every = asperity._asperity.quantities()
    others = ("-factor", "-gap", "gap-", "joint-", "approach", "peak-", "axis-", "effective-", "central-", "leak")
    names = [name for name in every if not any(part in name for part in others)]
    assert len(names) >= 20
    scene = scene.replace(thermal_conductivity=45.0, electrical_resistivity=2e-7)
    for scenes in (scene, [scene]):
        curve = asperity.model("ke").solve(scenes, [0.0, 2.0], names)
        assert list(curve.quantities) == names
        np.testing.assert_allclose(curve.pressure, curve.force / scene.nominal_area, rtol=1e-14)
        np.testing.assert_allclose(curve["area_fraction"], curve.area / scene.nominal_area)
        # A conductance k and one of 1/rho are of the same radii.
        thermal, electrical = curve["thermal-conductance"], curve["electrical-conductance"]
        np.testing.assert_allclose(thermal / electrical, 45.0 * 2e-7, rtol=1e-12)
        np.testing.assert_allclose(curve.mean_pressure, curve.force / curve.area, rtol=1e-12)
        np.testing.assert_allclose(curve.ln_force, np.log(curve.force), rtol=1e-13)
        shares = curve.elastic_share + curve.elastic_plastic_share + curve.plastic_share
        np.testing.assert_allclose(shares, 1.0, rtol=1e-12)
        assert "mean_pressure" in dir(curve)


def test_texts_may_say_their_unit(scene: asperity.Scene) -> None:
    ke = asperity.model("ke")
    wanted = ke.solve(scene, load=[2000.0, 3000.0], quantities="area").area
    np.testing.assert_array_equal(
        ke.solve(scene, load=["2 kN", "3kN"], quantities="area").area, wanted
    )
    np.testing.assert_array_equal(
        ke.solve(scene, "1 um").force, ke.solve(scene, 1e-6, separation_unit="m").force
    )
    for text in ("5 MPa", "5 N/mm2"):
        assert ke.separation_at(scene, pressure=text) == ke.separation_at(scene, pressure=5e6)
