"""Fits of scenes to measurements."""

from __future__ import annotations

from pathlib import Path

import asperity
import numpy as np
import pytest
from laws import Hertz

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


def test_a_model_written_in_python_is_fitted() -> None:
    data = {name: values for name, values in made("gw", asperity_height_std=2e-6).items()}
    del data["unloading_stiffness_N_per_m"]
    with pytest.warns(asperity.ContactWarning) as recorded:
        found = asperity.fit(SCENE, data, "asperity_height_std", asperity.model(Hertz)).best
    texts = [str(one.message) for one in recorded]
    assert any("Hertz: " in one and "would yield" in one for one in texts), texts
    assert any("asperities touch" in one for one in texts), texts
    assert abs(found["asperity_height_std"] / 2e-6 - 1) < 1e-8
