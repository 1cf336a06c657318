"""Asperities of a random surface, by the scene and by name."""

from __future__ import annotations

from pathlib import Path

import asperity
import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "asperity-inputs" / "examples"
PRESSURES = [1e7, 1e8, 1e9]


def area(scene: asperity.Scene, model: str) -> np.ndarray:
    return asperity.model(model).solve(scene, pressure=PRESSURES, quantities=["area"]).area


def test_the_scene_the_option_and_the_name_are_the_same() -> None:
    scene = asperity.Scene.from_toml(EXAMPLES / "ground-steel.toml")
    assert scene.options == {"asperities": "random"}
    assert scene.models()[0] == "gw-random"
    given = scene.interface, scene.surface, scene.nominal_area
    equal, random = asperity.Scene(*given), asperity.Scene(*given, options=scene.options)
    for model in ["gw", "ke", "jg"]:
        found = area(scene, model)
        np.testing.assert_array_equal(found, area(random, model))
        np.testing.assert_array_equal(found, area(equal, f"{model}-random"))
        assert np.all(found != area(equal, model))
    assert asperity.Scene.parse(scene.to_toml()).options == scene.options


def test_models_without_random_asperities_give_the_reason() -> None:
    scene = asperity.Scene.from_toml(EXAMPLES / "ground-steel.toml")
    with pytest.raises(ValueError, match="asperities of a random surface"):
        area(scene, "gao")
    equal = asperity.Scene(scene.interface, scene.surface, scene.nominal_area)
    # Persson's theory describes the whole surface, without asperities.
    with pytest.warns(asperity.ContactWarning, match="persson ignores yielding"):
        np.testing.assert_array_equal(area(scene, "persson"), area(equal, "persson"))


def test_advice_comes_with_evidence() -> None:
    scene = asperity.Scene.from_toml(EXAMPLES / "ground-steel.toml")
    both = asperity.recommend(scene, pressure=[1e8, 1e9], quantities=["area"])
    off = both.of("ke-random")["area_off_bem"]
    assert (np.abs(off) < 0.5).all()
    assert "evidence" in {one.code for one in both.findings}
    light = asperity.recommend(scene, pressure=100.0, quantities=["area"])
    assert np.isnan(light["area_off_bem"]).all()


def test_corrected_values_have_an_interval_or_a_reason() -> None:
    scene = asperity.Scene.from_toml(EXAMPLES / "ground-steel.toml")
    pressures, asked = [1e7, 1e8], ["area", "tangent"]
    tables = [
        asperity.model(model).corrected(scene, asked, pressure=pressures) for model in ("ke", "jg")
    ]
    ke, jg = tables[0].of("ke-corrected"), tables[1].of("jg-corrected")
    np.testing.assert_allclose(ke["area_m2"], jg["area_m2"], rtol=1e-6)
    np.testing.assert_allclose(ke["separation_m"], jg["separation_m"], rtol=1e-6)
    for name, unit in [("area", "_m2"), ("tangent", "_N_per_m"), ("separation", "_m")]:
        assert (ke[f"{name}_lower{unit}"] < ke[name + unit]).all()
        assert (ke[name + unit] < ke[f"{name}_upper{unit}"]).all()
    plain = asperity.model("ke").solve(scene, pressure=pressures, quantities=asked)
    np.testing.assert_allclose(tables[0].of("ke")["area_m2"], plain.area)
    assert not np.allclose(plain.area, ke["area_m2"], rtol=1e-3)
    # Options that are given are asked for, those of the scene are not.
    for given in ({"jg_hardness": "cosine"}, {"asperities": "random"}):
        named = asperity.model("jg", **given)
        found = named.corrected(scene, "area", pressure=1e8)
        assert found["model"] == [named.id, f"{named.id}-corrected"] != ["jg", "jg-corrected"]
    with pytest.warns(asperity.ContactWarning):
        some = asperity.model("ke").corrected(scene, "area", pressure=[1e8, 1e10])
    assert "no-value" in {one.code for one in some.findings}
    assert np.isnan(some.of("ke-corrected")["area_m2"]).tolist() == [False, True]
    with pytest.raises(TypeError, match="load and pressure"):
        asperity.model("ke").corrected(scene, "area")
