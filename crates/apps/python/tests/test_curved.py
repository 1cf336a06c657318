"""Curved bodies: numbers of an independent solver and of Hertz, places, arrays, refusals."""

from __future__ import annotations

import csv
import pickle
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import asperity
import numpy as np
import pytest

REFERENCE = Path(__file__).parents[4] / "tests" / "reference" / "curved.csv"
#: Columns of the reference by the names of quantities, with lengths relative to sigma at least.
LENGTHS = {
    "approach": "approach",
    "approach-beyond-hertz": "extra_approach",
    "central-separation": "center_separation",
}
OTHERS = {
    "peak-pressure": "peak_pressure",
    "axis-x": "axis_x",
    "area": "real_area",
    "tangent": "stiffness",
    "unloading-stiffness": "unloading_stiffness",
    "central-area-fraction": "center_area_fraction",
}
pytestmark = pytest.mark.filterwarnings("ignore:patch: ")


def scene(row: dict[str, Any]) -> asperity.Scene:
    of = {name: float(value) for name, value in row.items() if value and name not in ("shape", "model")}
    interface = asperity.Interface(
        of["E"], of["poissons_ratio"], hardness=of["hardness"], pressure_factor=of["pressure_factor"]
    )
    surface = asperity.Surface(of["asperity_radius"], of["asperity_density"], of["asperity_height_std"])
    of_line = {"length": 1.0, "reference_length": of.get("reference_length", 0.0)}
    bodies = {"radius_x": of["Rx"]} | ({"radius_y": of["Ry"]} if "Ry" in of else of_line)
    return asperity.Scene(interface, surface, curvature=bodies)


@pytest.fixture
def rows() -> list[dict[str, str]]:
    with REFERENCE.open() as file:
        return list(csv.DictReader(file))


@pytest.fixture
def ball(rows: list[dict[str, str]]) -> asperity.Scene:
    return scene(rows[12])


@pytest.mark.parametrize("k", [9, 13, 30, 32])
def test_models_give_the_numbers_of_another_solver(rows: list[dict[str, str]], k: int) -> None:
    row, one = rows[k], scene(rows[k])
    names = [*LENGTHS, *OTHERS, "peak-pressure-ratio"]
    found = asperity.model(row["model"]).solve(one, load=float(row["load"]), quantities=names)
    sigma = float(row["asperity_height_std"])
    for columns, least in [(LENGTHS, sigma), (OTHERS, 0.0)]:
        for name, column in columns.items():
            right = float(row[column])
            assert abs(found[name] - right) < 1e-6 * max(abs(right), least), name
    # Hertz' peak pressure and approach, of spheres in closed form.
    if row["shape"] == "sphere":
        load, modulus, radius = (float(row[name]) for name in ("load", "E", "Rx"))
        peak = (6 * load * modulus**2 / (np.pi**3 * radius**2)) ** (1 / 3)
        approach = (9 * load**2 / (16 * radius * modulus**2)) ** (1 / 3)
        assert found["peak-pressure"] / found["peak-pressure-ratio"] == pytest.approx(peak, rel=1e-12)
        beyond = found["approach"] - found["approach-beyond-hertz"]
        assert beyond == pytest.approx(approach, rel=1e-12)


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
    class Hertz:
        force_monotone = True

        def __init__(self, one: asperity.Asperity) -> None:
            self.one = one

        def force(self, w: Any) -> Any:
            return 4 / 3 * self.one.equivalent_modulus * self.one.radius**0.5 * w**1.5

        def area(self, w: Any) -> Any:
            return np.pi * self.one.radius * w

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
    assert repr(ball).endswith("curvature={'radius_x': 0.00635, 'radius_y': 0.00635})")
    text = re.sub("(?m)^radius_x = [^ ]*", 'radius_x = ["6 mm", "8 mm"]', ball.to_toml())
    worn = asperity.Scene.parse(text)
    assert worn.at("upper").curvature == {"radius_x": 8e-3, "radius_y": 6.35e-3}
    assert asperity.Scene.parse(worn.to_toml()) == worn


def test_what_flat_bodies_alone_have_is_refused(ball: asperity.Scene) -> None:
    ke, surface = asperity.model("ke"), ball.surface
    flat = asperity.Scene(ball.interface, surface, 1e-4)
    calls: list[Callable[[], Any]] = [
        lambda: ball.nominal_area,
        lambda: ke.solve(ball, 2.0),
        lambda: ke.solve(ball, film=1e-6),
        lambda: ke.solve(ball, pressure=1e6),
        lambda: ke.solve(ball, load=1.0, quantities="pressure"),
        lambda: ke.solve(flat, approach=1e-6),
        lambda: ke.compile(ball).force(1.0),
        lambda: ke.unloading(ball, load=1.0),
        lambda: ke.joint_table(ball, -1.0, 4.0),
        lambda: asperity.export("ke", ball, "csv", load=(1.0, 10.0), nodes=9),
        lambda: asperity.bem(ball, pressure=1e6),
        lambda: ball.flow_factors([3.0]),
        lambda: ball.replace(nominal_area=1.0),
        lambda: ball.replace(length=1.0),
        lambda: flat.replace(radius=1.0),
        lambda: flat.profile(1.0),
        lambda: asperity.Scene(ball.interface, surface),
        lambda: asperity.Scene(ball.interface, surface, 1e-4, curvature={"radius": 0.01}),
    ]
    for refused in calls:
        with pytest.raises(ValueError):
            refused()
