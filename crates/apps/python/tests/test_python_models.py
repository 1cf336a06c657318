"""Models written in Python: the engine, bounds and speed of other models."""

from __future__ import annotations

import threading
import time
from typing import Any

import asperity
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

SEPARATIONS = np.linspace(-1.0, 5.0, 61)
QUANTITIES = ["force", "area", "stiffness", "tangent"]


class KogutEtsion:
    """KE, by the table of its paper."""

    force_monotone = True
    regimes = ("elastic", "elastic-plastic", "elastic-plastic 2", "plastic")

    def __init__(self, one: asperity.Asperity) -> None:
        self.one, self.unit = one, one.critical_interference
        self.kinks = [self.unit, 6 * self.unit, 110 * self.unit]
        self.calls = 0

    def pick(self, w: Any, *values: Any) -> Any:
        x = w / self.unit
        return np.select([x < 1, x < 6, x < 110], [v(x) for v in values[:3]], values[3](x))

    def force(self, w: Any) -> Any:
        self.calls += 1
        plastic = 3 / self.one.pressure_factor
        return self.one.critical_force * self.pick(
            w,
            lambda x: x**1.5,
            lambda x: 1.03 * x**1.425,
            lambda x: 1.4 * x**1.263,
            lambda x: plastic * x,
        )

    def area(self, w: Any) -> Any:
        return (
            np.pi
            * self.one.radius
            * self.unit
            * self.pick(
                w,
                lambda x: x,
                lambda x: 0.93 * x**1.136,
                lambda x: 0.94 * x**1.146,
                lambda x: 2 * x,
            )
        )


class Undeclared(KogutEtsion):
    """KE without declared kinks."""

    regimes = None  # type: ignore[assignment]

    def __init__(self, one: asperity.Asperity) -> None:
        super().__init__(one)
        del self.kinks


class OwnStiffness(KogutEtsion):
    """With a stiffness that is not the tangent of the force."""

    def stiffness(self, w: Any) -> Any:
        return self.force(w) / w


@pytest.mark.parametrize("heights", ["gaussian", "exponential"])
@pytest.mark.parametrize("own", [KogutEtsion, Undeclared])
def test_the_same_laws_give_the_same_values(
    own: type[KogutEtsion], heights: str, scene: asperity.Scene
) -> None:
    scene = asperity.Scene(scene.interface, scene.surface, scene.nominal_area, heights=heights)
    # From 0 on, values of an exponential density differ by a factor only.
    at = SEPARATIONS[::20] if heights == "exponential" else SEPARATIONS
    mine = asperity.model(own).solve(scene, at, QUANTITIES, rtol=1e-12)
    theirs = asperity.model("ke").solve(scene, at, QUANTITIES, rtol=1e-12)
    for quantity in QUANTITIES:
        error = np.abs(mine[quantity] / theirs[quantity] - 1.0)
        bound = mine.error(quantity) + theirs.error(quantity)
        assert (error <= bound).all() and bound.max() < 1e-11, quantity
    if own is KogutEtsion:
        for part, share in theirs.shares("force").items():
            np.testing.assert_allclose(mine.shares("force")[part], share, rtol=1e-9)
    else:
        assert list(mine.shares("force")) == ["law"]


@settings(max_examples=40, deadline=None, derandomize=True)
@given(
    st.lists(st.floats(-3.0, 0.6), min_size=1, max_size=4, unique=True),
    st.lists(st.floats(-0.2, 0.5), min_size=4, max_size=4),
    # A number next to 0 causes a warning.
    st.floats(-2.0, 4.0).filter(lambda d: abs(d) > 1e-3),
    st.sampled_from([1e-6, 1e-10, 1e-13]),
)
def test_undeclared_jumps_anywhere_keep_the_tolerance(
    places: list[float], jumps: list[float], separation: float, rtol: float
) -> None:
    scene = asperity.Scene.parse(asperity.template())
    at = [scene.surface.asperity_height_std * 10.0**place for place in sorted(places)]

    class WithoutKinks:
        def __init__(self, one: asperity.Asperity) -> None:
            self.unit = one.equivalent_modulus * one.radius**0.5

        def force(self, w: Any) -> Any:
            factor = 1.0 + sum(jump * (w >= kink) for kink, jump in zip(at, jumps, strict=False))
            return self.unit * factor * w**1.5

        def area(self, w: Any) -> Any:
            return w

    class WithKinks(WithoutKinks):
        kinks = at

    for quantity in ("force", "tangent"):
        try:
            bare, declared = (
                asperity.model(laws).solve(scene, separation, quantity, rtol=tolerance)
                for laws, tolerance in ((WithoutKinks, rtol), (WithKinks, 1e-14))
            )
        except asperity.NotConverged:
            # Two jumps of which each hides the other are refused.
            continue
        error = abs(bare[quantity] / declared[quantity] - 1.0)
        # A jump hides from the bound in the narrowest piece, whose share is about the tolerance: of
        # 0.07 at 0.019 standard deviations, 1.01 times the tolerance was found.
        assert error <= max(1.1 * rtol, bare.error(quantity)) + declared.error(quantity)  # type: ignore[operator]
        # The factor is at least 0.2: cancellation enlarges a bound no more than some times.
        assert bare.error(quantity) < 10.0 * rtol + 1e-12


def test_once_built_a_python_model_is_never_called(scene: asperity.Scene) -> None:
    laws: list[KogutEtsion] = []

    def made(one: asperity.Asperity) -> KogutEtsion:
        laws.append(KogutEtsion(one))
        return laws[-1]

    made.force = None  # type: ignore[attr-defined]
    mine, theirs = (asperity.model(m).compile(scene) for m in (made, "ke"))
    gaps = np.linspace(-1, 4, 100_000)
    np.testing.assert_allclose(mine.force(gaps), theirs.force(gaps), rtol=1e-10)
    calls = sum(one.calls for one in laws)
    assert 0 < calls < 1000
    mine.force(gaps)
    assert sum(one.calls for one in laws) == calls


def test_a_stiffness_of_its_own_is_integrated(scene: asperity.Scene) -> None:
    curve = asperity.model(OwnStiffness).solve(scene, [0.0, 1.0], QUANTITIES)
    assert (np.abs(curve.stiffness / curve.tangent - 1.0) > 0.1).all()
    w = scene.surface.asperity_height_std
    law = asperity.model(OwnStiffness).law(scene, "stiffness", [w, 2 * w])
    force = asperity.model("ke").law(scene, "force", [w, 2 * w])
    np.testing.assert_allclose(law, force / [w, 2 * w], rtol=1e-14)


def test_many_scenes_share_integrals(scene: asperity.Scene) -> None:
    scenes = scene.vary(asperity_height_std=np.linspace(0.5e-6, 2e-6, 2000))
    mine = asperity.model(KogutEtsion).solve(scenes, 1.0, QUANTITIES[:2])
    theirs = asperity.model("ke").solve(scenes, 1.0, QUANTITIES[:2])
    np.testing.assert_allclose(mine.force, theirs.force, rtol=2e-10)
    np.testing.assert_allclose(mine.area, theirs.area, rtol=2e-10)


def test_the_check_finds_undeclared_kinks_and_wrong_areas(scene: asperity.Scene) -> None:
    class Wrong(KogutEtsion):
        kinks = ()  # type: ignore[assignment]
        regimes = None  # type: ignore[assignment]

        def __init__(self, one: asperity.Asperity) -> None:
            self.one, self.unit, self.calls = one, one.critical_interference, 0

        def area(self, w: Any) -> Any:
            return super().area(w) + self.one.radius**2

    assert asperity.model(KogutEtsion).check(scene) == []
    findings = asperity.model(Wrong).check(scene)
    kinks = [finding for finding in findings if "undeclared kink" in finding]
    critical = scene.asperity.critical_interference
    for finding in kinks:
        place = float(finding.split("(w = ")[1].split(" m)")[0])
        assert any(place == pytest.approx(k * critical, rel=2e-3) for k in (1.0, 6.0, 68.0, 110.0))
    assert kinks
    assert any("law of area" in finding for finding in findings)


class Scalars:
    """Laws without arrays."""

    def __init__(self, one: asperity.Asperity) -> None:
        self.one = one

    def force(self, w: Any) -> Any:
        if w < self.one.critical_interference:
            return self.one.equivalent_modulus * self.one.radius**0.5 * w**1.5
        return self.one.critical_force

    def area(self, w: Any) -> Any:
        return float(self.one.radius) * max(w, 0.0)


def test_the_check_finds_laws_without_arrays(scene: asperity.Scene) -> None:
    findings = asperity.model(Scalars).check(scene)
    assert [finding.split(":")[0] for finding in findings] == ["force", "area"]
    for finding in findings:
        assert "ValueError" in finding
        assert "array of interferences" in finding
    assert asperity.model("ke").check(scene) == []
    assert asperity.model("jg").check(scene) == []


class Broken:
    """With the fault ``what``."""

    what: Any = None

    def __init__(self, one: asperity.Asperity) -> None:
        if self.what == "init":
            raise LookupError("no such asperity")

    @property
    def kinks(self) -> Any:
        return ["one"] if self.what == "kinks" else []

    def force(self, w: Any) -> Any:
        if isinstance(self.what, Exception):
            raise self.what
        return {"scalar": 1.0, "shape": w[1:], "nan": w * np.nan, "text": ["a"] * len(w)}.get(
            str(self.what), w
        )

    def area(self, w: Any) -> Any:
        return w


@pytest.mark.parametrize(
    ("what", "error", "message"),
    [
        ("init", LookupError, "no such asperity"),
        ("kinks", (TypeError, ValueError), None),
        ("scalar", ValueError, r"Broken.force\(w\) has shape \(\)"),
        ("shape", ValueError, r"has shape \(\d+,\)"),
        ("nan", ValueError, r"Broken.force\(w\) is nan"),
        ("text", ValueError, r"Broken.force\(w\) .*<U1"),
        (ZeroDivisionError("mine"), ZeroDivisionError, "mine"),
    ],
)
def test_exceptions_of_laws_are_raised_by_the_call(
    what: Any, error: Any, message: str | None, scene: asperity.Scene
) -> None:
    model = asperity.model(type("Broken", (Broken,), {"what": what}))
    with pytest.raises(error, match=message):
        model.solve(scene, np.linspace(0, 1, 3))
    with pytest.raises(error, match=message):
        model.solve([scene, scene], 1.0)
    with pytest.raises(error, match=message):
        model.separation_at(scene, 1.0)


def test_a_contact_recovers_from_an_exception(scene: asperity.Scene) -> None:
    class Moody(KogutEtsion):
        good = False

        def force(self, w: Any) -> Any:
            if not Moody.good:
                raise KeyboardInterrupt
            return super().force(w)

    contact = asperity.model(Moody).compile(scene)
    for _ in range(2):
        with pytest.raises(KeyboardInterrupt):
            contact.force(1.0)
    Moody.good = True
    wanted = asperity.model("ke").compile(scene).force(1.0)
    assert contact.force(1.0) == pytest.approx(wanted, rel=1e-10)


def test_threads_build_one_model_without_a_deadlock(
    scene: asperity.Scene,
) -> None:
    class Slow(KogutEtsion):
        def force(self, w: Any) -> Any:
            time.sleep(1e-4)
            return super().force(w)

    contact = asperity.model(Slow).compile(scene)
    found: list[float] = []
    threads = [
        threading.Thread(target=lambda: found.append(contact.force(1.0)), daemon=True)
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=20)
    assert len(found) == 4 and len(set(found)) == 1
