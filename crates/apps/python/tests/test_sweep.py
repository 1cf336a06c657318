"""Sweeps: samples against scipy, values against one scene at a time, stores that are interrupted."""

from __future__ import annotations

import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Callable
from pathlib import Path

import asperity
import numpy as np
import numpy.typing as npt
import pytest
import xarray as xr
import zarr
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


@pytest.mark.parametrize("names", [("separation", "hardness", "asperity_height_std"), ("separation",)])
def test_no_digit_depends_on_the_size_of_parts(
    scene: asperity.Scene, names: tuple[str, ...]
) -> None:
    rows = {name: column for name, column in drawn(1024).items() if name in names}
    whole = asperity.sweep(scene, rows, "ke")
    for size in (1, 64, 333):
        assert asperity.sweep(scene, rows, "ke", part_size=size).identical(whole)


def test_separations_in_metres(scene: asperity.Scene) -> None:
    inputs = {"separation": [1e-6, 2e-6], "asperity_height_std": [0.5e-6, 1e-6]}
    result = asperity.sweep(scene, inputs, "ke", separation_unit="m")
    texts = asperity.sweep(scene, {**inputs, "separation": ["1 um", "2 um"]}, "ke")
    assert result.identical(texts) and result.separation.units == "m"
    over = asperity.model("ke").solve(scene.replace(asperity_height_std=0.5e-6), 2.0).force
    assert abs(result.force[0, 0] / over - 1.0) < 1e-9


def test_rows_that_are_refused_raise_or_are_masked(scene: asperity.Scene) -> None:
    inputs = {"separation": 1.0, "hardness": [1e9, 2e9, -1e9]}
    with pytest.raises(ValueError, match="hardness from 2: "):
        asperity.sweep(scene, inputs, "ke", part_size=1)
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


N, PART = 4096, 128


def swept(store: Path | None, hardness: float = 2e9) -> xr.Dataset:
    scene = asperity.Scene.parse(asperity.template()).replace(youngs_modulus=hardness * 100)
    return asperity.sweep(scene, drawn(N), ["ke", "gw"], store=store, part_size=PART)


def states(store: Path) -> Floats:
    return np.asarray(zarr.open_group(store, mode="r")["status"])


def test_a_store_has_the_digits_of_memory_and_refuses_another_sweep(tmp_path: Path) -> None:
    store = tmp_path / "sweep.zarr"
    result, wanted = swept(store), swept(None)
    assert result.compute().equals(wanted)
    assert (result.force.units, result.hardness.units) == ("N", "Pa")
    before = {path: path.stat().st_mtime_ns for path in store.rglob("*") if path.is_file()}
    swept(store)
    assert before == {path: path.stat().st_mtime_ns for path in store.rglob("*") if path.is_file()}
    with pytest.raises(ValueError, match="another sweep: scene"):
        swept(store, 1e9)
    scene = asperity.Scene.parse(asperity.template()).replace(youngs_modulus=2e11)
    with pytest.raises(ValueError, match="with other inputs"):
        asperity.sweep(scene, drawn(64), ["ke", "gw"], store=store)
    xr.Dataset({"a": 1.0}).to_zarr(tmp_path / "other.zarr", consolidated=False)
    with pytest.raises(ValueError, match="no store"):
        swept(tmp_path / "other.zarr")


def wait_for(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + 180.0
    while not condition():
        assert time.monotonic() < end, "timeout"
        time.sleep(0.05)


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_an_interrupted_sweep_goes_on(how: signal.Signals, tmp_path: Path) -> None:
    store = tmp_path / "sweep.zarr"
    script = f"""
        import sys
        sys.path.insert(0, {str(Path(__file__).parent)!r})
        import pathlib, test_sweep
        test_sweep.swept(pathlib.Path({str(store)!r}))
        """
    run = subprocess.Popen(
        [sys.executable, "-c", textwrap.dedent(script)], stderr=subprocess.PIPE, text=True
    )
    try:
        wait_for(lambda: store.exists() and (states(store) != 0).sum() >= 3 * PART)
        run.send_signal(how)
    except BaseException:
        run.kill()
        raise
    _, errors = run.communicate(timeout=120)
    assert run.returncode != 0
    assert ("KeyboardInterrupt" in errors) == (how == signal.SIGINT)
    done = states(store) != 0
    assert 3 * PART <= done.sum() < 2 * N
    first = np.asarray(zarr.open_group(store, mode="r")["force"])
    result = swept(store).compute()
    assert result.equals(swept(None)) and (result.force.values[done] == first[done]).all()
