"""Values of the reference table of the Rust tests, within the bounds on their errors."""

from __future__ import annotations

import csv
from collections import defaultdict
from pathlib import Path

import asperity
import numpy as np
import pytest

TABLES = Path(__file__).resolve().parents[4] / "tests" / "reference"
RTOL = 1e-12

def rows(name: str) -> list[dict[str, str]]:
    with (TABLES / name).open(newline="", encoding="utf-8") as table:
        return list(csv.DictReader(table))


def scenes() -> dict[str, asperity.Scene]:
    found = {}
    for row in rows("models_scenes.csv"):
        value = {key: float(number) for key, number in row.items() if key != "case"}
        interface = asperity.Interface(
            value["equivalent_modulus"],
            value["poissons_ratio"],
            hardness=value["hardness"],
            equivalent_shear_modulus=value["equivalent_shear_modulus"],
            pressure_factor=value["pressure_factor"],
        )
        surface = asperity.Surface(
            value["asperity_radius"], value["asperity_density"], value["asperity_height_std"]
        )
        found[row["case"]] = asperity.Scene(interface, surface, value["nominal_area"])
    return found


def curves() -> dict[tuple[str, str, str], list[tuple[float, float]]]:
    found = defaultdict(list)
    for row in rows("models.csv"):
        point = float(row["separation_over_sigma"]), float(row["value"])
        found[row["case"], row["model"], row["quantity"]].append(point)
    return dict(found)


@pytest.mark.parametrize("model", ["gw", "ke"])
def test_reference_values_are_met_within_the_reported_bound(model: str) -> None:
    known = scenes()
    for (case, name, quantity), points in curves().items():
        if name == model:
            separation, wanted = np.array(points).T
            curve = asperity.model(model).solve(known[case], separation, quantity, rtol=RTOL)
            error = np.abs(curve[quantity] / wanted - 1.0)
            assert (error <= curve.error(quantity) + 1e-13).all(), f"{case} {quantity}"


def test_many_scenes_meet_the_same_values() -> None:
    known = scenes()
    wanted: list[float] = []
    chosen: list[asperity.Scene] = []
    separations: list[float] = []
    for (case, name, quantity), points in curves().items():
        if (name, quantity) == ("ke", "force"):
            for separation, value in points:
                chosen.append(known[case])
                separations.append(separation)
                wanted.append(value)
    curve = asperity.model("ke").solve(chosen, separations, rtol=RTOL)
    assert len(wanted) > 10
    assert (np.abs(curve.force / np.array(wanted) - 1.0) <= curve.error("force") + 1e-13).all()
