"""Sweeps in memory: samples against scipy and SALib, values against one scene at a time,
statistics against NumPy, indices against closed forms."""

from __future__ import annotations

from typing import Any

import asperity
import numpy as np
import numpy.typing as npt
import pytest
import scipy.stats
from asperity._sweep.design import Design
from SALib.sample import sobol as salib_sobol

Floats = npt.NDArray[np.float64]


@pytest.fixture
def space(scene: asperity.Scene) -> asperity.Space:
    return asperity.Space(
        scene,
        separation=(0.5, 3.0),
        hardness=scipy.stats.norm(2e9, 1e8),
        asperity_height_std=scipy.stats.lognorm(0.2, scale=1e-6),
    )


def test_samples_are_scipys_sobol_points_through_the_distributions(space: asperity.Space) -> None:
    result = asperity.sweep(space, "ke", n=256, seed=5)
    sobol = scipy.stats.qmc.Sobol(3, rng=np.random.default_rng(5))
    u = sobol.random(256) + 2.0**-31
    assert result.inputs == ("separation", "hardness", "asperity_height_std")
    assert np.allclose(result["separation"], 0.5 + 2.5 * u[:, 0], rtol=1e-15)
    assert (result["hardness"] == scipy.stats.norm(2e9, 1e8).ppf(u[:, 1])).all()
    wanted = scipy.stats.lognorm(0.2, scale=1e-6).ppf(u[:, 2])
    assert (result["asperity_height_std"] == wanted).all()


def test_every_row_is_the_value_of_its_scene(
    scene: asperity.Scene, space: asperity.Space
) -> None:
    result = asperity.sweep(space, "ke", ["force", "area"], n=64, seed=2, rtol=1e-12)
    for k in range(64):
        alone = scene.replace(
            hardness=result["hardness"][k], asperity_height_std=result["asperity_height_std"][k]
        )
        curve = asperity.model("ke").solve(
            alone, result["separation"][k], ["force", "area"], rtol=1e-12
        )
        assert abs(result["force"][k] / curve.force - 1.0) < 2e-12
        assert abs(result["area"][k] / curve.area - 1.0) < 2e-12


@pytest.mark.parametrize("design", ["sobol", "saltelli", "saltelli-pairs"])
def test_no_digit_depends_on_the_size_of_parts(space: asperity.Space, design: str) -> None:
    whole = asperity.sweep(space, "ke", n=1000, seed=3, design=design)
    for size in (1, 64, 333):
        parts = asperity.sweep(space, "ke", n=1000, seed=3, design=design, part_size=size)
        assert parts.rows == whole.rows
        for column in (*whole.inputs, "force"):
            assert (parts[column] == whole[column]).all()


def test_latin_hypercubes_fill_every_stratum_of_every_part(scene: asperity.Scene) -> None:
    space = asperity.Space(scene, separation=(0.0, 1.0), nominal_area=(1e-4, 2e-4))
    result = asperity.sweep(space, "gw", n=250, seed=4, design="latin-hypercube", part_size=100)
    sizes = []
    for part in result.parts():
        size = len(part)
        sizes.append(size)
        strata = np.floor(part.inputs["separation"] * size).astype(int)
        assert sorted(strata) == list(range(size))
    assert sizes == [100, 100, 50]
    other = asperity.sweep(space, "gw", n=250, seed=5, design="latin-hypercube", part_size=100)
    assert (other["separation"] != result["separation"]).all()


@pytest.mark.parametrize(("design", "pairs"), [("saltelli", False), ("saltelli-pairs", True)])
def test_saltellis_scheme_has_the_rows_of_salib(design: str, pairs: bool) -> None:
    drawn = Design(design, n=16 * (8 if pairs else 5), seed=6, dimensions=3, part_size=20)
    problem = {"num_vars": 3, "names": ["a", "b", "c"], "bounds": [[0.0, 1.0]] * 3}
    wanted = salib_sobol.sample(problem, 16, calc_second_order=pairs, seed=np.random.default_rng(6))
    rows = np.concatenate([drawn.sample(part) for part in drawn.parts])
    assert rows.shape == wanted.shape
    assert np.abs(rows - 2.0**-31 - wanted).max() < 1e-15


def test_saltellis_rows_are_rounded_up_to_a_power_of_two() -> None:
    def rows(n: int) -> int:
        return Design("saltelli", n, seed=0, dimensions=3, part_size=1000).rows

    assert [rows(n) for n in (1, 5, 6, 10, 11, 20, 21)] == [5, 5, 10, 10, 20, 20, 40]


def test_statistics_are_numpys(space: asperity.Space) -> None:
    result = asperity.sweep(space, "ke", n=3000, seed=1, part_size=700)
    force = result["force"]
    assert result.mean("force") == pytest.approx(force.mean(), rel=1e-13)
    assert result.std("force") == pytest.approx(force.std(ddof=1), rel=1e-13)
    probabilities = np.array([[0.0, 0.05, 0.5], [0.77, 0.95, 1.0]])
    found = result.quantile("force", probabilities)
    assert found.shape == (2, 3)
    assert np.allclose(found, np.quantile(force, probabilities), rtol=1e-14)


def test_indices_are_those_of_a_product(scene: asperity.Scene) -> None:
    """The force is in proportion to area and density: closed forms for their product."""
    space = asperity.Space(
        scene, separation=1.5, nominal_area=(1e-4, 3e-4), asperity_density=(1e8, 2e8)
    )
    result = asperity.sweep(space, "ke", n=2**14, seed=1, design="saltelli-pairs")
    # Squared coefficients of variation of uniform distributions.
    area, density = (2e-4**2 / 12) / 2e-4**2, (1e8**2 / 12) / 1.5e8**2
    whole = (1.0 + area) * (1.0 + density) - 1.0
    found = result.sensitivity("force")
    assert found.first["nominal_area"] == pytest.approx(area / whole, abs=0.005)
    assert found.first["asperity_density"] == pytest.approx(density / whole, abs=0.005)
    assert found.total["nominal_area"] == pytest.approx(area * (1 + density) / whole, abs=0.005)
    pair = found.second["nominal_area", "asperity_density"]
    assert pair == pytest.approx(area * density / whole, abs=0.005)
    mean = asperity.model("ke").solve(scene.replace(nominal_area=2e-4, asperity_density=1.5e8), 1.5)
    assert result.mean("force") == pytest.approx(float(mean.force), rel=1e-4)
    # The logarithm of a product is a sum without an effect of pairs.
    logarithm = result.sensitivity("force", transform=np.log)
    assert sum(logarithm.first.values()) == pytest.approx(1.0, abs=0.005)
    table = logarithm.to_dataframe()
    assert list(table.index) == ["nominal_area", "asperity_density"]


def test_plasticity_index_and_roughness_parameter_determine_the_surface(
    scene: asperity.Scene,
) -> None:
    space = asperity.Space(
        scene, separation=1.0, plasticity_index=(0.5, 4.0), hardness=(1e9, 2e9)
    )
    result = asperity.sweep(space, "gw", n=16, seed=1)
    for k in range(16):
        interface = scene.replace(hardness=result["hardness"][k]).interface
        surface = asperity.Surface.from_plasticity_index(
            result["plasticity_index"][k],
            scene.surface.roughness_parameter,
            scene.surface.asperity_height_std,
            interface,
        )
        alone = asperity.Scene(interface, surface, scene.nominal_area)
        wanted = asperity.model("gw").solve(alone, 1.0).force
        assert abs(result["force"][k] / wanted - 1.0) < 1e-9
    with pytest.raises(ValueError, match="is given beside .*, which describes the surface in another way"):
        asperity.Space(scene, 1.0, plasticity_index=(1.0, 2.0), asperity_radius=(1e-4, 2e-4))


def test_separations_in_metres(scene: asperity.Scene) -> None:
    space = asperity.Space(scene, separation=(1e-6, 2e-6), asperity_height_std=(0.5e-6, 1e-6))
    result = asperity.sweep(space, "ke", n=32, seed=1, separation_unit="m")
    over = asperity.model("ke").solve(
        scene.vary(asperity_height_std=result["asperity_height_std"]),
        result["separation"] / result["asperity_height_std"],
    )
    assert np.allclose(result["force"], over.force, rtol=1e-9)


def test_a_row_that_is_refused_ends_the_sweep_with_its_number(scene: asperity.Scene) -> None:
    space = asperity.Space(scene, separation=1.0, hardness=(-1e9, 9e9))
    hardness = asperity.sweep(space, "ke", n=64, seed=1, errors="mask")["hardness"]
    first = int(np.flatnonzero(hardness <= 0)[0])
    with pytest.raises(ValueError, match=rf"^row {first} \(.*hardness=-\d.*\): hardness is -"):
        asperity.sweep(space, "ke", n=64, seed=1, part_size=10)


def test_rows_that_are_refused_are_masked(scene: asperity.Scene) -> None:
    space = asperity.Space(scene, separation=1.0, hardness=(-1e9, 9e9))
    result = asperity.sweep(space, "ke", n=500, seed=1, errors="mask", part_size=100)
    bad = np.flatnonzero(result["hardness"] <= 0)
    failures = dict(result.failures())
    assert sorted(failures) == list(bad) and 30 < len(bad) < 70
    assert all(why.startswith("hardness is -") for why in failures.values())
    force = result["force"]
    assert isinstance(force, np.ma.MaskedArray)
    assert (np.flatnonzero(np.ma.getmaskarray(force)) == bad).all()
    with pytest.warns(asperity.ContactWarning, match=f"{len(bad)} of 500 rows failed"):
        assert result.mean("force") == pytest.approx(force.compressed().mean(), rel=1e-13)
    table = result.to_dataframe()
    assert (table["error"].notna() == table["force_N"].isna()).all()
    assert table["force_N"].isna().sum() == len(bad)


def test_indices_need_every_row(scene: asperity.Scene, space: asperity.Space) -> None:
    bad = asperity.Space(scene, separation=1.0, hardness=(-1e9, 9e9))
    result = asperity.sweep(bad, "ke", n=64, design="saltelli", errors="mask")
    with pytest.raises(ValueError, match="rows failed: every row is required"):
        result.sensitivity("force")
    with pytest.raises(ValueError, match="the design is 'sobol'"):
        asperity.sweep(space, "ke", n=64).sensitivity("force")


class Hertz:
    """A model that fails on soft asperities."""

    def __init__(self, asperity: asperity.Asperity) -> None:
        if (asperity.hardness or 0.0) < 1.5e9:
            raise ZeroDivisionError("too soft")
        self.asperity = asperity

    def force(self, w: Floats) -> Floats:
        one = self.asperity
        return np.asarray(4 / 3 * one.equivalent_modulus * one.radius**0.5 * w**1.5)

    def area(self, w: Floats) -> Floats:
        return np.pi * self.asperity.radius * w


def test_a_model_written_in_python(scene: asperity.Scene) -> None:
    space = asperity.Space(scene, separation=1.0, hardness=(1e9, 2e9))
    mine = asperity.model(Hertz)
    result = asperity.sweep(space, mine, n=16, seed=1, errors="mask")
    failures = dict(result.failures())
    assert sorted(failures) == list(np.flatnonzero(result["hardness"] < 1.5e9))
    assert all("too soft" in why for why in failures.values())
    wanted = asperity.model("gw").solve(scene, 1.0).force
    assert np.allclose(np.ma.compressed(result["force"]), wanted, rtol=1e-9)
    with pytest.raises(ZeroDivisionError, match="too soft"):
        asperity.sweep(space, mine, n=16, seed=1)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"separation": (2.0, 1.0)}, "low must be below high"),
        ({"separation": (2.0, np.inf)}, "two finite numbers"),
        ({"separation": 1.0}, "no input has a distribution"),
        ({"separation": (0, 1), "asperity_radiu": 1.0}, "asperity_radiu is not an input"),
        ({"separation": "1.0"}, "give a number, or a text with its unit"),
        ({"separation": [1.0, 2.0]}, "a distribution with a ppf"),
    ],
)
def test_spaces_that_are_refused(
    scene: asperity.Scene, arguments: dict[str, Any], message: str
) -> None:
    with pytest.raises((ValueError, TypeError), match=message):
        asperity.Space(scene, **arguments)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"n": 0}, "n is 0: an integer from 1"),
        ({"n": 10.5}, "n is 10.5"),
        ({"seed": -1}, "seed is -1: an integer from 0"),
        ({"n": 2**30 + 1}, "at most 2\\^30"),
        ({"part_size": 0}, "part_size is 0"),
        ({"design": "halton"}, "design is 'halton': one of sobol"),
        ({"errors": "ignore"}, "errors is 'ignore'"),
        ({"quantities": []}, "quantities is empty"),
        ({"quantities": "weight"}, "weight"),
        ({"rtol": 2.0}, "tolerance"),
        ({"client": object()}, "without a folder"),
    ],
)
def test_sweeps_that_are_refused(
    space: asperity.Space, arguments: dict[str, Any], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        asperity.sweep(space, "ke", **arguments)


def test_columns_that_are_not_there(space: asperity.Space) -> None:
    result = asperity.sweep(space, "ke", n=8)
    with pytest.raises(KeyError, match="area was not requested"):
        result.mean("area")
    with pytest.raises(KeyError, match="hardnes is no column"):
        result["hardnes"]
    with pytest.raises(ValueError, match="from 0 to 1"):
        result.quantile("force", 1.5)
