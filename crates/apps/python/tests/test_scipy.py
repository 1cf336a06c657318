"""Random scenes against scipy.integrate, which shares only the laws with this project."""

from __future__ import annotations

import asperity
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
    return float(scene.surface.asperity_density * scene.nominal_area * total)


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
