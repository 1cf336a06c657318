"""Adhesion and skewed heights."""

import asperity
import numpy as np
import pytest

RUBBER = asperity.Body(1e6, 0.5)
SURFACE = asperity.Surface(1e-4, 1e9, 1e-6)


def scene(work: float | None, heights: str | dict[str, float] = "gaussian") -> asperity.Scene:
    interface = asperity.Interface.against_rigid(RUBBER, work_of_adhesion=work)
    return asperity.Scene(interface, SURFACE, 1e-4, heights)


@pytest.mark.filterwarnings("ignore:.*tabor_parameter is")
def test_adhesive_models_have_tensile_forces_and_tend_to_gw_without_adhesion() -> None:
    d = np.array([0.5, 1.5, 2.5])
    gw = asperity.model("gw").solve(scene(None), d).force
    for model in ("dmt", "jkr"):
        without = asperity.model(model).solve(scene(0.0), d).force
        np.testing.assert_allclose(without, gw, rtol=1e-9)
        with pytest.warns(asperity.ContactWarning, match="negative"):
            assert asperity.model(model).solve(scene(0.05), d).force[2] < 0.0


def test_ignored_adhesion_and_large_tabor_parameters_are_warned_of() -> None:
    with pytest.warns(asperity.ContactWarning, match="^sticks: "):
        asperity.model("gw").solve(scene(0.05), 1.0)
    with pytest.warns(asperity.ContactWarning, match="^tabor: dmt: "):
        asperity.model("dmt").solve(scene(0.05), -3.0)


def test_the_pull_off_is_the_minimum_of_the_force() -> None:
    model = asperity.model("jkr-separation")
    found = model.pull_off(scene(0.05))
    assert found is not None
    force, separation = found
    with pytest.warns(asperity.ContactWarning):
        around = model.solve(scene(0.05), separation + np.linspace(-0.1, 0.1, 21)).force
    assert around.min() == pytest.approx(force, rel=1e-9) and np.argmin(around) == 10
    there = model.pull_off(scene(0.05), separation_unit="m")
    assert there is not None and there[1] == pytest.approx(separation * 1e-6, rel=1e-12)
    assert asperity.model("dmt").pull_off(scene(0.0)) is None
    with pytest.raises(ValueError, match="work_of_adhesion is missing"):
        model.pull_off(scene(None))


def test_a_missing_work_of_adhesion_is_named_and_a_given_one_reads_back() -> None:
    with pytest.raises(ValueError, match="work_of_adhesion"):
        asperity.model("jkr").solve(scene(None), 1.0)
    with pytest.raises(ValueError, match="work_of_adhesion"):
        scene(-1.0)
    given = scene(0.05)
    assert asperity.Scene.parse(given.to_toml()) == given
    assert given.replace(work_of_adhesion=0.02).interface.work_of_adhesion == 0.02


def test_a_skewness_of_two_is_exponential_and_follows_the_deviation() -> None:
    d = np.array([-0.5, 1.0, 3.0])
    skewed = scene(None, heights={"skewness": 2.0})
    gw = asperity.model("gw")
    wanted = gw.solve(scene(None, heights="exponential"), d + 1.0).force
    np.testing.assert_allclose(gw.solve(skewed, d).force, wanted, rtol=1e-9)
    twice = gw.solve(skewed.replace(asperity_height_std=2e-6), d).force
    np.testing.assert_allclose(twice, 2.0**1.5 * wanted, rtol=1e-9)
    assert asperity.Scene.parse(skewed.to_toml()) == skewed
    for wrong in ({"skewness": 9.0}, {"kurtosis": 3.0}):
        with pytest.raises(ValueError, match="skewness"):
            scene(None, heights=wrong)
