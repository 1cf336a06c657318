"""Fits of scenes to measurements."""

from __future__ import annotations

from pathlib import Path

import asperity
import numpy as np
import pytest

SCENE = asperity.Scene.parse(asperity.template())
PRESSURES = np.geomspace(1e5, 3e7, 8)
QUANTITIES = ["area", "unloading-stiffness"]


def made(model: str = "ke", /, **numbers: float) -> dict[str, np.ndarray]:
    curve = asperity.model(model).solve(
        SCENE.replace(**numbers), pressure=PRESSURES, quantities=QUANTITIES
    )
    return {
        "pressure_Pa": PRESSURES,
        "area_m2": curve.area,
        "unloading_stiffness_N_per_m": curve.unloading_stiffness,
    }


def test_the_numbers_of_a_scene_come_back() -> None:
    truth = {"asperity_height_std": 1.7e-6, "hardness": 1.3e9}
    with pytest.warns(asperity.ContactWarning, match="^undetermined: gw: hardness"):
        found = asperity.fit(SCENE, made(**truth), list(truth), ["gw", "ke"])
    assert [fit.model for fit in found] == ["ke", "gw"]
    best = found.best
    for name, value in truth.items():
        assert abs(best[name] / value - 1) < 1e-8, name
        estimate = best.parameters[name]
        assert estimate.bounds[0] < estimate.value < estimate.bounds[1]
    assert best.scene.surface.asperity_height_std == best["asperity_height_std"]
    assert best.converged and best.rms is not None and best.rms < 1e-9
    assert best.correlation.shape == (2, 2) and len(best.residuals) == 16
    assert found[1].rms is not None and found[1].rms > 1e-3


def test_a_file_and_a_table_give_the_same(tmp_path: Path) -> None:
    columns = made(asperity_height_std=0.6e-6)
    columns["area_m2"][3] = np.nan
    path = tmp_path / "data.csv"
    rows = zip(*columns.values(), strict=True)
    lines = [",".join("" if np.isnan(x) else repr(float(x)) for x in row) for row in rows]
    path.write_text("\n".join([",".join(columns), *lines]))
    bounds = {"asperity_height_std": ("0.1 um", "10 um")}
    ours = asperity.fit(SCENE, columns, bounds)
    assert ours == asperity.fit(SCENE, path, bounds)
    assert ours == asperity.fit(SCENE, columns, {"asperity_height_std": (1e-7, 1e-5)})
    assert abs(ours.best["asperity_height_std"] / 0.6e-6 - 1) < 1e-8


def doubts(fit: asperity.Fit) -> list[tuple[str, str]]:
    codes = ("not-converged", "limits", "undetermined")
    return [(one.code, one.field) for one in fit.findings if one.code in codes]


@pytest.mark.filterwarnings("ignore::asperity.ContactWarning")
def test_doubts_have_a_code_and_a_parameter() -> None:
    target = {"pressure_Pa": 5e6, "area_fraction": 0.001}
    found = asperity.fit(SCENE, target, "asperity_height_std").best
    assert doubts(found) == [("limits", "asperity_height_std")]
    assert found.rms is not None and found.rms > 0.1
    data = {name: values for name, values in made("gw").items() if name != "area_m2"}
    free = ["asperity_radius", "asperity_density"]
    found = asperity.fit(SCENE, data, free, "gw").best
    assert doubts(found) == [("undetermined", name) for name in free]
    assert found.condition is None and np.isnan(found.correlation[0, 1])
    found = asperity.fit(SCENE, data, {"asperity_height_std": ("2 um", "9 um")}, "gw").best
    assert doubts(found) == [("limits", "asperity_height_std")]
    assert {one.code for one in found.findings} >= {"yields"}


def test_a_model_written_in_python_is_fitted() -> None:
    class Hertz:
        def __init__(self, asperity: asperity.Asperity) -> None:
            self.asperity = asperity

        def force(self, w: np.ndarray) -> np.ndarray:
            e, r = self.asperity.equivalent_modulus, self.asperity.radius
            # Laws are asked up to the largest numbers, whose powers overflow.
            with np.errstate(over="ignore"):
                return np.asarray(4 / 3 * e * r**0.5 * w**1.5)

        def area(self, w: np.ndarray) -> np.ndarray:
            return np.asarray(np.pi * self.asperity.radius * w)

    data = {name: values for name, values in made("gw", asperity_height_std=2e-6).items()}
    del data["unloading_stiffness_N_per_m"]
    with pytest.warns(asperity.ContactWarning) as recorded:
        found = asperity.fit(SCENE, data, "asperity_height_std", asperity.model(Hertz)).best
    texts = [str(one.message) for one in recorded]
    assert any("Hertz: " in one and "would yield" in one for one in texts), texts
    assert any("asperities touch" in one for one in texts), texts
    assert abs(found["asperity_height_std"] / 2e-6 - 1) < 1e-8


@pytest.mark.parametrize(
    ("data", "free", "message"),
    [
        ({"load": [1.0]}, "hardness", 'column "load" is not known .the nearest is "load_N".'),
        ({"load_N": [1.0]}, "hardness", "no measured quantity"),
        ({"area_m2": [1.0]}, "hardness", "no load or"),
        ({"load_N": [-1.0], "area_m2": [1e-9]}, "hardness", "row 1: load_N is -1"),
        ({"load_N": [1.0], "area_m2": [1e-9, 2e-9]}, "hardness", "load_N has 1 value"),
        ({"load_N": [1.0], "area_m2": [1e-9]}, "hardnes", "^hardnes .*hardness"),
        ({"load_N": [1.0], "area_m2": [1e-9]}, [], "free parameters"),
        ({"load_N": [1.0], "area_m2": [1e-9]}, {"hardness": 1e9}, "hardness is 1000000000.0: .low"),
        ({"load_N": [1.0], "area_m2": [1e-9]}, {"hardness": ("1 GPa", 2.0)}, "bounds a unit"),
        ({"load_N": [1.0], "area_m2": [1e-9]}, {"hardness": (2e9, 1e9)}, "the smaller first"),
        ({"load_N": [1.0], "area_m2": [1e-9]}, {"hardness": ("1 N", "2 N")}, "number in Pa"),
        ({"load_N": [1.0], "area_m2": [[1e-9]]}, "hardness", "area_m2 has 2 dimensions"),
        ("none.csv", "hardness", "none.csv"),
    ],
)
def test_bad_data_and_parameters_are_refused(data: object, free: object, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        asperity.fit(SCENE, data, free)  # type: ignore[arg-type]


def test_an_implausible_scene_is_told() -> None:
    wrong = SCENE.replace(asperity_height_std=1.0)
    with pytest.warns(asperity.ContactWarning) as recorded:
        asperity.fit(wrong, made("ke"), "hardness")
    assert any(str(one.message).startswith("unusual-size: ") for one in recorded)
