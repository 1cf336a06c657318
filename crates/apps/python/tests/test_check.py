"""Checks of scenes and answers."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from typing import Any

import pytest

import asperity


@pytest.fixture(autouse=True)
def show_every_warning() -> Iterator[None]:
    with warnings.catch_warnings():
        warnings.simplefilter("always")
        yield


def warning_texts(scene: asperity.Scene | asperity.Scenes, model: str = "ke", **place: object) -> list[str]:
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        asperity.model(model).solve(scene, quantities="area", **place)  # type: ignore[arg-type]
    assert {warning.filename for warning in seen} <= {__file__}
    return [str(warning.message) for warning in seen]


def test_numbers_and_findings_of_a_scene_and_of_a_load(scene: asperity.Scene) -> None:
    check = asperity.check(scene)
    assert check.findings == ()
    assert check.numbers["plasticity_index"] == pytest.approx(scene.plasticity_index)
    at_load = asperity.check(scene, load=100.0)
    assert at_load.numbers["load"] == pytest.approx(100.0)
    area = asperity.model("ke").solve(scene, load=100.0, quantities="area").area
    assert at_load.numbers["area"] == pytest.approx(float(area), rel=1e-5)
    assert set(check.numbers) < set(at_load.numbers)
    (yields,) = asperity.check(scene, "gw", load=100.0).findings
    assert (yields.code, yields.severity) == ("yields", "warning")
    assert yields.usual == (0.0, 0.02) and yields.field
    assert asperity.check(scene, asperity.model("gw"), pressure=1e6).findings[0].code == "yields"


def test_numbers_in_other_units_are_named(scene: asperity.Scene) -> None:
    assert warning_texts(scene, load=100.0) == []
    in_micrometres = scene.replace(asperity_height_std=1.0)
    (text,) = [w for w in warning_texts(in_micrometres, separation=3.0) if "like um" in w]
    assert text.startswith("unusual-size: asperity_height_std")
    many = scene.vary(asperity_height_std=[1e-6, 1.0, 2.0])
    text, *others = warning_texts(many, separation=3.0)
    assert text.startswith("unusual-size: 2 of 3 scenes: ")
    assert all(other.startswith("area-above-nominal: ") for other in others)
    both = warning_texts([scene, in_micrometres], separation=[3.0, 3.0])  # type: ignore[arg-type]
    assert sum("like um" in text for text in both) == 1


def test_a_scene_without_an_answer_is_explained(scene: asperity.Scene) -> None:
    # A modulus in GPa: no separation carries the pressure.
    interface = asperity.Interface(116.0, 0.3, hardness=2e9)
    soft = asperity.Scene(interface, scene.surface, nominal_area=1e-4)
    places: list[dict[str, Any]] = [{"pressure": 1e8}, {"load": 1e4}, {"separation": 2.0}]
    for place in places:
        check = asperity.check(soft, **place)
        assert check.findings[0].severity == "refusal"
        assert any("116 looks like GPa" in str(finding) for finding in check.findings), place
        assert check.numbers["equivalent_modulus"] == 116.0


def test_warnings_name_the_worst_value_and_where(scene: asperity.Scene) -> None:
    (few,) = warning_texts(scene, load=[10.0, 1e-3, 1.0])
    assert few.startswith("few-contacts: ") and "0.001 N" in few
    there = asperity.check(scene, load=1e-3).numbers["contacts"]
    assert float(few.split()[3]) == pytest.approx(there, rel=1e-3)
    (crowded,) = warning_texts(scene, load=[1e3, 3e5])
    assert "ke: " in crowded and "300000 N" in crowded


def test_accepted_codes_are_silent_and_unknown_ones_refused(scene: asperity.Scene) -> None:
    given = scene.interface, scene.surface, scene.nominal_area
    quiet = asperity.Scene(*given, accept=["few-contacts", "beyond-full-contact"])
    assert warning_texts(quiet, load=[1e-3, 3e5]) == []
    assert quiet.accept == ("few-contacts", "beyond-full-contact") and quiet != scene
    read = asperity.Scene.parse(quiet.to_toml(), accept=["deep"])
    assert read.accept == ("few-contacts", "beyond-full-contact", "deep")


def test_accepted_codes_are_silent_in_other_answers(scene: asperity.Scene) -> None:
    given = scene.interface, scene.surface, scene.nominal_area
    loud = asperity.Scene(*given)
    quiet = asperity.Scene(*given, accept=["energy-gain", "interpolation-error"])
    for one, counted in ((loud, 1), (quiet, 0)):
        joint = asperity.model("af").unloading(one, load=100.0, law="brake")
        with warnings.catch_warnings(record=True) as seen:
            warnings.simplefilter("always")
            joint.dissipated()
        found = [text for one in seen if (text := str(one.message)).startswith("energy-gain")]
        assert len(found) == counted, found


def test_a_loop_has_one_warning_also_where_others_change_the_filters(
    scene: asperity.Scene,
) -> None:
    ke = asperity.model("ke")
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("default")
        for load in (1e-5, 2e-4, 3e-3):
            ke.solve(scene, load=load, quantities="area")
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DeprecationWarning)
    few = [str(one.message) for one in seen if "few-contacts" in str(one.message)]
    assert len(few) == 1, few
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for _ in range(2):
            with pytest.raises(asperity.ContactWarning, match="few-contacts"):
                ke.solve(scene, load=1e-5, quantities="area")
