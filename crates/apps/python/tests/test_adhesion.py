"""Adhesion and skewed heights."""

import asperity
import numpy as np
import pytest

RUBBER = asperity.Body(1e6, 0.5)
SURFACE = asperity.Surface(1e-4, 1e9, 1e-6)


def scene(work: float | None, heights: str | dict[str, float] = "gaussian") -> asperity.Scene:
    interface = asperity.Interface.against_rigid(RUBBER, work_of_adhesion=work)
    return asperity.Scene(interface, SURFACE, 1e-4, heights)


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
