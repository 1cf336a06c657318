"""Asperities of a random surface."""

from __future__ import annotations

from pathlib import Path

import asperity
import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "asperity-inputs" / "examples"
PRESSURES = [1e7, 1e8, 1e9]


def area(scene: asperity.Scene, model: str) -> np.ndarray:
    return asperity.model(model).solve(scene, pressure=PRESSURES, quantities=["area"]).area


def test_random_asperities_differ_from_equal_ones() -> None:
    scene = asperity.Scene.from_toml(EXAMPLES / "ground-steel.toml")
    for model in ["gw", "ke", "jg"]:
        assert np.all(area(scene, f"{model}-random") != area(scene, model))


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
        for model in ("ke-random", "jg-random")
    )
    assert isinstance(ke, asperity.CorrectedCurve) and ke.model == "ke-random-corrected"
    np.testing.assert_allclose(ke.area, jg.area, rtol=1e-6)
    for quantity in asked:
        assert (ke.lower(quantity) < ke[quantity]).all()
        assert (ke[quantity] < ke.upper(quantity)).all()
    head = ke.to_csv().splitlines()[0]
    ends = "area_lower,area_upper,tangent_lower,tangent_upper"
    apart = "separation,separation_lower,separation_upper"
    assert head.endswith(f"{ends},{apart}"), head
    assert (ke.lower("separation") < ke.separation).all()
    assert (ke.separation < ke.upper("separation")).all()
    np.testing.assert_allclose(ke.separation, jg.separation, rtol=1e-6)
    plain = asperity.model("ke-random").solve(scene, pressure=pressures, quantities=asked)
    assert not np.allclose(plain.area, ke.area, rtol=1e-3)
    model = asperity.model("ke-random")
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
