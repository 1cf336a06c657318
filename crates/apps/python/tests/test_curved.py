"""Curved bodies: places, arrays."""

from __future__ import annotations

import pickle
import re

import asperity
import numpy as np
import pytest
from laws import Hertz

pytestmark = pytest.mark.filterwarnings("ignore:patch: ")


@pytest.fixture
def ball() -> asperity.Scene:
    interface = asperity.Interface(115.4e9, 0.3, hardness=4e9, pressure_factor=0.577)
    surface = asperity.Surface(1e-4, 1e9, 5e-7)
    return asperity.Scene(interface, surface, curvature={"radius_x": 6.35e-3, "radius_y": 6.35e-3})


def test_arrays_of_loads_and_approaches_are_inverse(ball: asperity.Scene) -> None:
    ke = asperity.model("ke")
    loads = np.array([[1.0, 10.0], [20.0, 40.0]])
    contact = ke.compile(ball, ["approach", "force"], rtol=1e-6)
    approach = contact.evaluate("approach", load=loads)
    assert approach.shape == (2, 2) and (np.diff(approach.ravel()) > 0).all()
    assert contact.evaluate("force", approach=approach) == pytest.approx(loads, rel=1e-5)
    curve = ke.solve(ball, approach="1 um", quantities=["force", "approach"])
    assert curve.approach == pytest.approx(1e-6, rel=1e-6)
    assert curve.to_csv().startswith("approach_m,force_N")
    assert "separation" not in ke.solve(ball, load=10.0, quantities="area").to_csv()


def test_scenes_with_other_radii_are_solved_each_by_itself(ball: asperity.Scene) -> None:
    for id in ("ke", "best"):
        model = asperity.model(id)
        radii = np.array([5e-3, 7e-3])
        found = model.solve(ball.vary(radius_x=radii), load=10.0, quantities="axis-x")["axis-x"]
        for radius, axis in zip(radii, found, strict=True):
            alone = model.solve(ball.replace(radius_x=radius), load=10.0, quantities="axis-x")
            assert axis == pytest.approx(float(alone["axis-x"]), rel=1e-6)
    assert found[0] < found[1]
    flat = asperity.Scene(ball.interface, ball.surface, 1e-4)
    area = asperity.model("ke").solve([flat, ball], load=10.0, quantities="area").area
    each = [asperity.model("ke").solve(one, load=10.0, quantities="area").area for one in (flat, ball)]
    assert area == pytest.approx(np.array(each, float), rel=1e-6)


def test_a_model_in_python_is_one_between_curved_bodies(ball: asperity.Scene) -> None:
    own, gw = (
        asperity.model(one).solve(ball, load=10.0, quantities="peak-pressure")["peak-pressure"]
        for one in (Hertz, "gw")
    )
    assert own == pytest.approx(float(gw), rel=1e-6)


def test_the_patch_carries_the_load_and_the_answer_is_that_of_best(ball: asperity.Scene) -> None:
    patch = ball.profile("10 N")
    x, y, p = (patch[name] for name in ("x_m", "y_m", "pressure_Pa"))
    cell = np.diff(np.unique(x)).min() * np.diff(np.unique(y)).min()
    assert p.sum() * cell == pytest.approx(10.0, rel=1e-4)
    assert (patch["area_fraction"] >= 0).all() and len(patch["separation_m"]) == len(x)
    answer = ball.answer(load="10 N")
    assert answer.value["peak-pressure"] == pytest.approx(p.max(), rel=1e-6)
    names = list(answer.value)
    best = asperity.model("best").solve(ball, load=10.0, quantities=names)
    ke = asperity.model("ke").solve(ball, load=10.0, quantities=names)
    for name in names:
        assert answer.value[name] == float(best[name]) == float(ke[name]), name
    assert answer.by.startswith("ke, ") and np.isnan(answer.lower["area"])
    again = ball.answer("force", approach=answer.value["approach"])
    assert again.value["force"] == pytest.approx(10.0, rel=1e-5)


def test_a_scene_with_curved_bodies_is_written_copied_and_known_within_ranges(
    ball: asperity.Scene,
) -> None:
    assert asperity.Scene.parse(ball.to_toml()) == ball == pickle.loads(pickle.dumps(ball))
    assert ball.curvature == {"radius_x": 6.35e-3, "radius_y": 6.35e-3}
    text = re.sub("(?m)^radius_x = [^ \n]*", 'radius_x = ["6 mm", "8 mm"]', ball.to_toml())
    worn = asperity.Scene.parse(text)
    assert worn.at("upper").curvature == {"radius_x": 8e-3, "radius_y": 6.35e-3}
    assert asperity.Scene.parse(worn.to_toml()) == worn
