"""Scenes whose surface is known within ranges."""

from __future__ import annotations

import pickle
import subprocess
import sys
from pathlib import Path

import asperity
import numpy as np
import pytest

STEEL = asperity.Body(210e9, 0.3, hardness=2e9)
PAIR = asperity.Interface.between(STEEL, STEEL)
GROUND = {"ra": "0.8 um", "finish": "ground"}


def scene(**keys: object) -> asperity.Scene:
    return asperity.Scene(PAIR, {**GROUND, **keys}, nominal_area=1e-4)


def test_keys_are_kept_and_single_numbers_are_those_in_the_middle() -> None:
    ground = scene(counterface=GROUND)
    assert pickle.loads(pickle.dumps(ground)) == ground  # noqa: S301
    assert asperity.Scene.parse(ground.to_toml()) == ground
    assert 'finish = "ground"' in repr(ground)
    model = asperity.model("ke")

    def area(one: asperity.Scene) -> float:
        return float(model.solve(one, load=10.0, quantities="area").area)

    with pytest.warns(asperity.ContactWarning, match="taken-at: calculated in the middle"):
        middle = area(ground)
    assert middle == pytest.approx(area(ground.at("middle")), rel=1e-12)
    assert middle != pytest.approx(area(ground.at("lower")), rel=1e-3)
    assert ground.surface == ground.at("middle").surface


@pytest.mark.filterwarnings("ignore:undetermined", "ignore:limits")
def test_whoever_takes_the_middle_says_so() -> None:
    ground, ke = scene(counterface="smooth"), asperity.model("ke")
    data = {"load_N": [10.0, 100.0], "tangent_N_per_m": [1e8, 1e9]}
    for asked in (
        lambda: ke.compile(ground),
        lambda: ke.separation_at(ground, 1.0),
        lambda: ke.unloading(ground, load=10.0),
        lambda: asperity.export(ke, ground, load=(1.0, 10.0), nodes=3),
        lambda: asperity.fit(ground, data, "hardness", "ke"),
        lambda: asperity.sweep(ground, {"load": [1.0, 2.0]}, "ke"),
    ):
        with pytest.warns(asperity.ContactWarning, match="taken-at: calculated in the middle"):
            asked()


def test_a_contact_on_ranges_is_unpickled_at_the_top_of_a_program(tmp_path: Path) -> None:
    with pytest.warns(asperity.ContactWarning, match="taken-at"):
        contact = asperity.model("ke").compile(scene(counterface="smooth"))
    (tmp_path / "contact").write_bytes(pickle.dumps(contact))
    program = "import pickle, sys; print(pickle.load(open(sys.argv[1], 'rb')).force(1.0) > 0)"
    asked = [sys.executable, "-c", program, str(tmp_path / "contact")]
    found = subprocess.run(asked, capture_output=True, text=True, check=True)  # noqa: S603
    assert found.stdout.strip() == "True" and "taken-at" in found.stderr


def test_ranges_are_those_of_the_corners() -> None:
    ground, model = scene(counterface=GROUND), asperity.model("ke")
    pressures = np.array([1e6, 1e7])

    def area(one: asperity.Scene) -> object:
        return model.solve(one, pressure=pressures, quantities="area").area

    found = asperity.ranges(ground, area)
    assert found.middle.shape == (2,)
    assert np.all((found.lower < found.middle) & (found.middle < found.upper))
    assert np.allclose(sum(found.shares.values()), 1.0)
    checked = asperity.check(ground, "ke", pressure=1e6)
    index = asperity.ranges(ground, lambda one: one.plasticity_index)
    row = checked["name"].index("plasticity_index")
    ends = [checked[head][row] for head in ("value", "lower", "upper")]
    assert np.allclose(ends, [index.middle, index.lower, index.upper], rtol=1e-9)
    # A curve has the ends of answers.
    assert np.isnan(checked["lower"][checked["name"].index("area")])


def test_a_known_surface_has_no_ranges() -> None:
    known = asperity.Scene(PAIR, {"rq": "1 um", "rdq": 0.1, "bandwidth": 10.0}, nominal_area=1e-4)
    found = asperity.ranges(known, lambda one: one.plasticity_index)
    assert found.lower == found.upper == known.plasticity_index
    assert found.shares == {}


def test_any_number_of_a_text_may_be_a_range() -> None:
    text = asperity.template().replace("hardness = 2e9 ", "hardness = [1.8e9, 2.2e9] ", 1)
    known = asperity.Scene.parse(text)
    assert pickle.loads(pickle.dumps(known)) == known  # noqa: S301
    assert known != asperity.Scene.parse(asperity.template())
    found = asperity.ranges(known, lambda one: one.interface.hardness)
    assert found.lower == pytest.approx(1.8e9)
    # The other body has 2e9, and the softer one yields.
    assert found.upper == pytest.approx(2e9)
    assert known.at("lower").interface.hardness == pytest.approx(1.8e9)
    assert known.replace(body1_hardness=3e9) != known
