"""Random scenes against scipy.integrate, which shares only the laws with this project."""

from __future__ import annotations

import asperity
import numpy as np
import pytest
import scipy.integrate
import scipy.stats
from hypothesis import given, settings
from hypothesis import strategies as st

# Random scenes may be unusual.
pytestmark = pytest.mark.filterwarnings("ignore::asperity.ContactWarning")

# Where formulas of most models change, over the critical interference; quad finds the others.
KINKS = [1.0, 1.9, 6.0, 110.0, 170.0]


@st.composite
def random_scenes(draw: st.DrawFn, heights: str = "gaussian") -> asperity.Scene:
    interface = asperity.Interface(
        10.0 ** draw(st.floats(9.5, 11.7)),
        draw(st.floats(0.0, 0.49)),
        hardness=10.0 ** draw(st.floats(7.5, 9.3)),
        equivalent_shear_modulus=10.0 ** draw(st.floats(9.0, 11.0)),
    )
    surface = asperity.Surface(
        10.0 ** draw(st.floats(-6, -3)),
        10.0 ** draw(st.floats(7, 12)),
        10.0 ** draw(st.floats(-8, -5)),
    )
    area = 10.0 ** draw(st.floats(-6, -2))
    if heights == "gaussian":
        return asperity.Scene(interface, surface, area)
    return asperity.Scene(interface, surface, area, heights="exponential")


def integral(
    model: asperity.Model, scene: asperity.Scene, quantity: str, separation: float, heights: str
) -> float:
    """eta A_n INT q(w) g(d + w) dw, panel by panel."""
    sigma = scene.surface.asperity_height_std
    density = scipy.stats.norm.pdf if heights == "gaussian" else scipy.stats.expon.pdf
    critical = scene.asperity.critical_interference / sigma
    # Beyond, a Gaussian is below 1e-24 of its largest value and an exponential below 1e-19.
    far = max(-separation, 0.0) + (11.0 if heights == "gaussian" else 44.0)
    edges = [kink * critical for kink in KINKS if kink * critical < far]
    edges += [far * share for share in (0.0, 1e-3, 0.03, 0.1, 0.25, 0.5, 0.75, 1.0)]
    edges += [-separation] if 0.0 < -separation < far else []

    def integrand(t: float) -> float:
        law = model.law(scene, quantity, t * sigma)
        return float(law) * float(density(separation + t))

    total = 0.0
    for low, high in zip(sorted(edges), sorted(edges)[1:], strict=False):
        # t = low + width v^2: laws may begin with a square root.
        width = high - low
        total += scipy.integrate.quad(
            lambda v, low=low, width=width: 2.0 * width * v * integrand(low + width * v * v),
            0.0,
            1.0,
            epsabs=0.0,
            epsrel=1e-10,
            limit=400,
        )[0]
    return float(scene.asperities * total)


@pytest.mark.parametrize("heights", ["gaussian", "exponential"])
@pytest.mark.parametrize("name", ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af"])
def test_forces_and_areas_are_the_integrals_of_the_laws(name: str, heights: str) -> None:
    model = asperity.model(name)

    @settings(max_examples=6, deadline=None, derandomize=True)
    @given(random_scenes(heights), st.floats(-2.0, 4.0), st.sampled_from(["force", "area"]))
    def check(scene: asperity.Scene, separation: float, quantity: str) -> None:
        found = model.solve(scene, separation, quantity)[quantity]
        wanted = integral(model, scene, quantity, separation, heights)
        assert abs(found / wanted - 1.0) < 1e-8

    check()


@settings(max_examples=15, deadline=None, derandomize=True)
@given(random_scenes(), st.floats(-2.0, 4.0), st.sampled_from(["gw", "zmc", "ke", "jg"]))
def test_tangents_are_the_slopes_of_forces(
    scene: asperity.Scene, separation: float, name: str
) -> None:
    step = 1e-3
    at = separation + step * np.array([-2.0, -1.0, 1.0, 2.0])
    model = asperity.model(name)
    force = model.solve(scene, at, rtol=1e-14).force / scene.surface.asperity_height_std
    slope = (8.0 * (force[1] - force[2]) - (force[0] - force[3])) / (12.0 * step)
    tangent = model.solve(scene, separation, "tangent").tangent
    assert abs(tangent / slope - 1.0) < 1e-8


@settings(max_examples=15, deadline=None, derandomize=True)
@given(random_scenes(), st.floats(-3.0, 12.0), st.sampled_from(["gw", "ke", "etsion", "jg"]))
def test_separations_and_loads_lead_to_each_other(
    scene: asperity.Scene, separation: float, name: str
) -> None:
    model = asperity.model(name)
    load = model.solve(scene, separation).force
    found = model.separation_at(scene, load)
    assert found.shape == ()
    assert abs(found - separation) < 1e-11 * (1.0 + abs(separation))


@settings(max_examples=25, deadline=None, derandomize=True)
@given(st.lists(random_scenes(), min_size=2, max_size=5), st.floats(-2.0, 4.0))
def test_many_scenes_and_one_by_one_agree(scenes: list[asperity.Scene], separation: float) -> None:
    model = asperity.model("ke")
    together = model.solve(scenes, separation)
    alone = np.array([model.solve(scene, separation).force for scene in scenes])
    assert (np.abs(together.force / alone - 1.0) <= 2.0 * together.error("force")).all()
