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
from asperity._table import Finding, Table

#: Name, value, ends of its range, unit and meaning.
Number = tuple[str, float, "tuple[float, float] | None", str, str]


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


class Recommendation(Table):
    """Models compared with a reference and with boundary elements; ``print`` it.

    For each model the largest relative deviation of each quantity from the reference
    (``area_deviation``), whether it is the ``simplest`` valid one within the limit, and its expected
    deviations from boundary elements on solved surfaces, with half the width of their intervals
    (``area_off_bem``, ``area_off_bem_spread``). Results have the verdict and the evidence.
    """

    @property
    def simplest(self) -> str | None:
        """Id of the simplest valid model within the deviation; None if there is none."""
        rows = zip(self["model"], self["simplest"], strict=True)
        return next((model for model, word in rows if word.startswith("yes")), None)


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
    rows = Rows(one_scene(scene, "plan"), *place(separation_unit, separation=separation, load=load, pressure=pressure))
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
    axis, numbers = place(
        separation_unit, separation=separation, load=load, pressure=pressure
    )
    rows = Rows(one_scene(scene, "recommend"), axis, numbers)
    if quantities is None:
        quantities = ("area",) if axis in LOADS else ("force", "area")
    against = as_model(reference or scene._usual_reference())
    engines = None if models is None else as_models(models)
    return Recommendation(*_asperity.recommend((against, rows, quantities, rtol), within, engines))



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
    axis, number = place(
        separation_unit, separation=separation, load=load, pressure=pressure
    )
    engine = model if isinstance(model, Engine) else Engine(model or scene._usual_reference(), {})
    return Check._of(*_asperity.check(scene, (engine, axis, number)))
