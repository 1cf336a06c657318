"""Sweeps: samples against scipy, values against one scene at a time."""

from __future__ import annotations

import asperity
import numpy as np
import numpy.typing as npt
import pytest
import xarray as xr
from laws import Hertz
from scipy import stats
from scipy.stats import qmc

Floats = npt.NDArray[np.float64]

HARDNESS, HEIGHT_STD = stats.norm(2e9, 1e8), stats.lognorm(0.2, scale=1e-6)


def drawn(n: int) -> dict[str, xr.DataArray]:
    points = qmc.Sobol(3, rng=np.random.default_rng(5)).random(n)
    place: tuple[float, float] = (0.5, 3.0)
    return asperity.sample(
        points, separation=place, hardness=HARDNESS, asperity_height_std=HEIGHT_STD
    )


def test_samples_are_the_points_through_the_distributions() -> None:
    u = qmc.Sobol(3, rng=np.random.default_rng(5)).random(256)
    sample = drawn(256)
    assert np.allclose(sample["separation"], 0.5 + 2.5 * u[:, 0], rtol=1e-15)
    assert (sample["hardness"] == HARDNESS.ppf(u[:, 1])).all()
    assert (sample["asperity_height_std"] == HEIGHT_STD.ppf(u[:, 2])).all()
    ends = asperity.sample([[0.0], [1.0]], hardness=HARDNESS)
    assert np.isfinite(ends["hardness"]).all()


def test_every_row_is_the_value_of_its_scene(scene: asperity.Scene) -> None:
    rows, quantities = drawn(64), ["force", "mean-pressure"]
    result = asperity.sweep(scene, rows, "ke", quantities, rtol=1e-12)
    assert dict(result.sizes) == {"row": 64} and (result.status == 1).all()
    assert (result.hardness == rows["hardness"]).all()
    assert (result.force.units, result.hardness.units) == ("N", "Pa")
    for k in range(0, 64, 7):
        numbers = {name: float(rows[name][k]) for name in ("hardness", "asperity_height_std")}
        where = float(rows["separation"][k])
        alone = asperity.model("ke").solve(scene.replace(**numbers), where, quantities, rtol=1e-12)
        assert abs(result.force[k] / alone.force - 1.0) < 2e-12
        assert abs(result.mean_pressure[k] / alone.mean_pressure - 1.0) < 2e-12


def test_grids_have_a_dimension_for_each_input(scene: asperity.Scene) -> None:
    inputs = {"load": ["10 N", "1 kN"], "hardness": [1e9, 2e9, 3e9], "youngs_modulus": "200 GPa"}
    result = asperity.sweep(scene, inputs, ["ke", "jg"], "area")
    assert dict(result.sizes) == {"model": 2, "load": 2, "hardness": 3}
    found = result.area.sel(model="jg", load=1000.0, hardness=3e9).item()
    alone = scene.replace(hardness=3e9, youngs_modulus=200e9)
    wanted = asperity.model("jg").solve(alone, load=1000.0, quantities="area").area
    assert abs(found / wanted - 1.0) < 1e-9
    # Rows and a grid together.
    rows = asperity.sample(qmc.LatinHypercube(1, rng=1).random(8), hardness=HARDNESS)
    both = asperity.sweep(scene, {**rows, "load": [10.0, 100.0]}, "ke", "area")
    assert dict(both.sizes) == {"row": 8, "load": 2}
    assert both.area.quantile([0.05, 0.95], "row").shape == (2, 2)


def test_separations_in_metres(scene: asperity.Scene) -> None:
    inputs = {"separation": [1e-6, 2e-6], "asperity_height_std": [0.5e-6, 1e-6]}
    result = asperity.sweep(scene, inputs, "ke", separation_unit="m")
    texts = asperity.sweep(scene, {**inputs, "separation": ["1 um", "2 um"]}, "ke")
    assert result.identical(texts) and result.separation.units == "m"
    over = asperity.model("ke").solve(scene.replace(asperity_height_std=0.5e-6), 2.0).force
    assert abs(result.force[0, 0] / over - 1.0) < 1e-9


def test_rows_that_are_refused_raise_or_are_masked(scene: asperity.Scene) -> None:
    inputs = {"separation": 1.0, "hardness": [1e9, 2e9, -1e9]}
    with pytest.raises(ValueError, match="scene 2: "):
        asperity.sweep(scene, inputs, "ke")
    result = asperity.sweep(scene, inputs, "ke", errors="mask")
    assert list(result.status) == [1, 1, 2]
    assert list(np.isnan(result.force)) == [False, False, True]


class Hard(Hertz):
    """Fails on soft asperities."""

    def __init__(self, one: asperity.Asperity) -> None:
        if (one.hardness or 0.0) < 1.5e9:
            raise ZeroDivisionError("too soft")
        super().__init__(one)


def test_a_model_written_in_python(scene: asperity.Scene) -> None:
    inputs = {"separation": 1.0, "hardness": [1e9, 2e9]}
    mine = asperity.model(Hard)
    result = asperity.sweep(scene, inputs, mine, errors="mask")
    wanted = asperity.model("gw").solve(scene, 1.0).force
    assert list(result.status) == [2, 1] and abs(result.force[1] / wanted - 1.0) < 1e-9
    with pytest.raises(ZeroDivisionError, match="too soft"):
        asperity.sweep(scene, inputs, mine)
