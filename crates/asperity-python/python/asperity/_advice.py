"""The check of a scene, the plan of a request, and a comparison of models."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import LOADS, Rows, one_scene, place, record
from asperity._asperity import Engine, Scene
from asperity._model import Model, as_model, as_models

#: Name, value, ends of its range, unit and meaning.
Number = tuple[str, float, "tuple[float, float] | None", str, str]


@dataclass(frozen=True)
class Finding:
    """An unusual number of a scene or an answer."""

    #: The kind of finding: ``unusual-size``, ``crowded``.
    code: str
    #: ``refusal``: there is no value; ``warning``; ``note``.
    severity: str
    #: The name of the number in scene files.
    field: str
    #: Its value, in SI units.
    value: float
    #: The usual range; None for an open end.
    usual: tuple[float | None, float | None]
    #: The text with the advice.
    message: str

    def __str__(self) -> str:
        return f"{self.severity}[{self.code}]: {self.message}"


@dataclass(frozen=True)
class Check:
    """Derived numbers and findings of a scene and, at a load, of a model; ``print`` it."""

    #: Numbers by their names, in SI units; those on a surface that is known within ranges also have
    #: the ends of theirs, as ``area_lower`` and ``area_upper``.
    numbers: dict[str, float]
    #: Unusual numbers, most severe first.
    findings: tuple[Finding, ...]
    text: str = field(repr=False)

    @staticmethod
    def _of(numbers: list[Number], findings: list[dict[str, Any]]) -> Check:
        found = tuple(record(Finding, one) for one in findings)
        width = max(len(name) for name, *_ in numbers)
        lines, named = [], {}
        for name, value, ends, unit, meaning in numbers:
            named[name] = value
            between = ""
            if ends is not None:
                named[f"{name}_lower"], named[f"{name}_upper"] = ends
                between = f"({ends[0]:.6g} to {ends[1]:.6g}) "
            lines.append(f"{name:<{width}}  {value:<12.6g} {between}{unit:<5} {meaning}".rstrip())
        return Check(named, found, "\n".join([*lines, *map(str, found)]))

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class PlanStep:
    """One integral of a plan."""

    #: The integrated law: the force's for the tangent.
    law: str
    #: The quantities it yields.
    quantities: tuple[str, ...]
    #: The method of integration.
    method: str
    #: Fewest and most terms of a value, for values that are sums; else None.
    terms: tuple[int, int] | None
    #: Samples of the law.
    samples: int


@dataclass(frozen=True)
class Plan:
    """The integrals of a request; ``print`` it."""

    steps: tuple[PlanStep, ...]
    text: str = field(repr=False)

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class Recommendation:
    """Models compared with a reference; ``print`` it."""

    #: Id of the simplest valid model within the deviation; None if there is none.
    simplest: str | None
    #: Id of the reference model.
    reference: str
    #: Largest allowed relative deviation.
    within: float
    #: Largest relative deviation of each quantity that a model has, by model.
    deviations: dict[str, dict[str, float]]
    #: The reasons of models without a value, of all quantities or of some, by model.
    refused: dict[str, str]
    #: Evidence from boundary elements on solved surfaces: the nearest models, the expected
    #: deviations of the reference and of the simplest model, and the reason for none.
    evidence: str
    #: ``off`` place by place (24 of them if there are more), or the reason for no evidence.
    evidence_at: tuple[dict[str, dict[str, float | None]] | str, ...]
    #: Expected relative deviations of models from boundary elements, and half the width of their
    #: intervals: area, area_spread, stiffness, stiffness_spread, and if requested the same of
    #: unloading_stiffness (None otherwise), by model; the largest of all places
    #: with evidence.
    off: dict[str, dict[str, float | None]]
    text: str = field(repr=False)

    def __str__(self) -> str:
        return self.text


def plan(
    model: str | Model,
    scene: Scene,
    separation: npt.ArrayLike | None = None,
    quantities: str | Sequence[str] = ("force",),
    rtol: float = 1e-10,
    separation_unit: str = "asperity_height_std",
    *,
    load: npt.ArrayLike | None = None,
    pressure: npt.ArrayLike | None = None,
) -> Plan:
    """The integrals of a request, their terms and samples, and the regimes left out.

    >>> import asperity
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> print(asperity.plan("ke", scene, [0.0, 2.0]))
    ke, gaussian heights, 2 rows from a separation of 0 asperity_height_std to a separation of 2 asperity_height_std, relative tolerance 1e-10
      force from the force law: polynomials in the separation
        12 terms a value; 320 samples of the law, once
        elastic: sum of powers
        elastic-plastic: sum of powers
        elastic-plastic 2: sum of powers
        plastic: sum of powers
    """
    rows = Rows(one_scene(scene, "plan"), *place(separation, load, pressure, separation_unit))
    text, found = _asperity.plan((as_model(model), rows, quantities, rtol))
    steps = tuple(record(PlanStep, step) for step in found["steps"])
    return Plan(steps, text.rstrip("\n"))


def recommend(
    scene: Scene,
    separation: npt.ArrayLike | None = None,
    quantities: str | Sequence[str] | None = None,
    reference: str | Model | None = None,
    within: float = 0.05,
    rtol: float = 1e-4,
    separation_unit: str = "asperity_height_std",
    *,
    load: npt.ArrayLike | None = None,
    pressure: npt.ArrayLike | None = None,
    models: str | Model | Sequence[str | Model] | None = None,
) -> Recommendation:
    """Deviations of models from a reference, the simplest model within a relative deviation, and the
    expected deviations from boundary elements, interpolated between solved surfaces.

    By default area and, at separations, force are compared; at a load the force is the same. The
    default reference is ke, or gw without a hardness; ``within`` is a share, 0.05 for 5 %;
    ``models`` are those to compare, also of your own, by default all.

    >>> import asperity
    >>> interface = asperity.Interface(116e9, 0.31, hardness=7e9)
    >>> smooth = asperity.Surface.from_plasticity_index(0.3, 0.04, 1e-7, interface)
    >>> scene = asperity.Scene(interface, smooth, nominal_area=1e-4)
    >>> asperity.recommend(scene, [0, 1, 2, 3, 4]).simplest
    'gw'
    """
    axis, numbers = place(separation, load, pressure, separation_unit)
    rows = Rows(one_scene(scene, "recommend"), axis, numbers)
    if quantities is None:
        quantities = ("area",) if axis in LOADS else ("force", "area")
    against = as_model(reference or scene._usual_reference())
    engines = None if models is None else as_models(models)
    asked = against, rows, quantities, rtol
    simplest, compared, evidence, places, text = _asperity.recommend(asked, within, engines)
    deviations = {id: dict(known) for id, known, _, _ in compared if known}
    refused = {id: reason for id, _, reason, _ in compared if reason is not None}
    off = {id: off for id, _, _, off in compared if off is not None}
    found = deviations, refused, evidence, tuple(places), off, text
    return Recommendation(simplest, against.id, within, *found)


def check(
    scene: Scene,
    model: str | Engine | None = None,
    separation: float | str | None = None,
    *,
    load: float | str | None = None,
    pressure: float | str | None = None,
    separation_unit: str = "asperity_height_std",
) -> Check:
    """The result of ``Scene.check``."""
    given = [number for number in (separation, load, pressure) if number is not None]
    if len(given) > 1:
        raise TypeError("at most one of separation, load and pressure was expected")
    if not given:
        return Check._of(*_asperity.check(scene))
    axis, number = place(separation, load, pressure, separation_unit)
    engine = model if isinstance(model, Engine) else Engine(model or scene._usual_reference(), {})
    return Check._of(*_asperity.check(scene, (engine, axis, number)))
