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
    advice = asperity.recommend(scene, pressure=[1e8, 1e9], quantities=["area"])
    assert "boundary elements" in advice.evidence
    off = advice.off["ke-random"]["area"]
    assert off is not None and abs(off) < 0.5
    both = asperity.recommend(scene, pressure=[100.0, 1e9], quantities=["area"])
    none, near = both.evidence_at
    assert isinstance(none, str) and none.startswith("no boundary-element solution is close: less")
    assert isinstance(near, dict) and near == both.off and "persson-fudge" in near
    first, second, *others = both.evidence.splitlines()
    assert first.startswith("no boundary") and " nearest to boundary elements in area " in second
    # Only what was asked for.
    assert "stiffness" not in both.evidence and "gap" not in both.evidence
    tangent = asperity.recommend(scene, pressure=[1e8, 1e9], quantities=["tangent"]).evidence
    assert " in stiffness in first loading " in tangent and "the area" not in tangent
    assert others[0].startswith("ke") and "the area" in others[0] and "; boundary" in others[0]
    light = asperity.recommend(scene, pressure=100.0, quantities=["area"])
    assert light.evidence.startswith("no boundary-element solution is close") and light.off == {}


def test_corrected_values_have_an_interval_or_a_reason() -> None:
    scene = asperity.Scene.from_toml(EXAMPLES / "ground-steel.toml")
    pressures, asked = [1e7, 1e8], ["area", "tangent"]
    ke, jg = (
        asperity.model(model).solve(scene, pressure=pressures, quantities=asked, corrected=True)
        for model in ("ke", "jg")
    )
    assert isinstance(ke, asperity.CorrectedCurve) and ke.model == "ke-corrected"
    np.testing.assert_allclose(ke.area, jg.area, rtol=1e-6)
    for quantity in asked:
        assert (ke.lower(quantity) < ke[quantity]).all()
        assert (ke[quantity] < ke.upper(quantity)).all()
    # Options that are given are asked for, those of the scene are not.
    for given in ({"jg_hardness": "cosine"}, {"asperities": "random"}):
        named = asperity.model("jg", **given)
        found = named.solve(scene, pressure=1e8, quantities="area", corrected=True)
        assert found.model == f"{named.id}-corrected" != "jg-corrected"
    head = ke.to_csv().splitlines()[0]
    ends = "area_lower,area_upper,tangent_lower,tangent_upper"
    apart = "separation,separation_lower,separation_upper"
    assert head.endswith(f"{ends},{apart}"), head
    assert (ke.lower("separation") < ke.separation).all()
    assert (ke.separation < ke.upper("separation")).all()
    np.testing.assert_allclose(ke.separation, jg.separation, rtol=1e-6)
    plain = asperity.model("ke").solve(scene, pressure=pressures, quantities=asked)
    assert not np.allclose(plain.area, ke.area, rtol=1e-3)
    model = asperity.model("ke")
    with pytest.raises(ValueError, match="^no boundary-element solution is close"):
        model.solve(scene, load=1e9, quantities="area", corrected=True)
    with pytest.raises(ValueError, match="contacts has no counterpart"):
        model.solve(scene, load=1e4, quantities="contacts", corrected=True)
    with pytest.raises(ValueError, match="corrected=True needs load or pressure"):
        model.solve(scene, 2.0, corrected=True)
    some = model.solve(
        scene, pressure=[1e8, 1e12], quantities="area", corrected=True, errors="mask"
    )
    assert np.ma.getmaskarray(some.area).tolist() == [False, True]
    assert "p/(E g)" in some.failures[1]
    # Without a Hurst exponent persson has areas and no separation, which is no failure of a row.
    template, persson = asperity.Scene.parse(asperity.template()), asperity.model("persson")
    found = persson.solve(template, pressure=[1e6, 1e7], quantities="area", corrected=True)
    assert not found.failures and not np.ma.getmaskarray(found.area).any()
    assert sorted(found.separation_failures) == [0, 1]
    with pytest.raises(TypeError, match="use lower and upper"):
        ke.error("area")
