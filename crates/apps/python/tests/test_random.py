"""Asperities of a random surface, in tables."""

from __future__ import annotations

from pathlib import Path

import asperity
import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[3] / "answer" / "scene" / "examples"
PRESSURES = [1e7, 1e8, 1e9]


def area(scene: asperity.Scene, model: str) -> np.ndarray:
    return asperity.model(model).solve(scene, pressure=PRESSURES, quantities=["area"]).area


def test_random_asperities_differ_from_equal_ones() -> None:
    scene = asperity.Scene.from_toml(EXAMPLES / "ground-steel.toml")
    for model in ["gw", "ke", "jg"]:
        assert np.all(area(scene, f"{model}-random") != area(scene, model))


def test_advice_comes_with_evidence() -> None:
    scene = asperity.Scene.from_toml(EXAMPLES / "ground-steel.toml")
    both = asperity.recommend(scene, pressure=[1e8, 1e9], quantities=["area"])
    off = both.of("ke-random")["area_off_bem"]
    assert (np.abs(off) < 0.5).all()
    assert both.results
    light = asperity.recommend(scene, pressure=100.0, quantities=["area"])
    assert np.isnan(light["area_off_bem"]).all()


def test_corrected_values_have_an_interval_or_a_reason() -> None:
    scene = asperity.Scene.from_toml(EXAMPLES / "ground-steel.toml")
    pressures, asked = [1e7, 1e8], ["area", "tangent"]
    tables = [
        asperity.model(model).corrected(scene, asked, pressure=pressures) for model in ("ke-random", "jg-random")
    ]
    ke, jg = tables[0].of("ke-random-corrected"), tables[1].of("jg-random-corrected")
    np.testing.assert_allclose(ke["area_m2"], jg["area_m2"], rtol=1e-6)
    np.testing.assert_allclose(ke["separation_m"], jg["separation_m"], rtol=1e-6)
    for name, unit in [("area", "_m2"), ("tangent", "_N_per_m"), ("separation", "_m")]:
        assert (ke[f"{name}_lower{unit}"] < ke[name + unit]).all()
        assert (ke[name + unit] < ke[f"{name}_upper{unit}"]).all()
    plain = asperity.model("ke-random").solve(scene, pressure=pressures, quantities=asked)
    np.testing.assert_allclose(tables[0].of("ke-random")["area_m2"], plain.area)
    assert not np.allclose(plain.area, ke["area_m2"], rtol=1e-3)
    with pytest.warns(asperity.ContactWarning):
        some = asperity.model("ke-random").corrected(scene, "area", pressure=[1e8, 1e10])
    assert "no-value" in {one.code for one in some.findings}
    assert np.isnan(some.of("ke-random-corrected")["area_m2"]).tolist() == [False, True]
    with pytest.raises(TypeError, match="load and pressure"):
        asperity.model("ke-random").corrected(scene, "area")
