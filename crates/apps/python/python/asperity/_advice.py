"""The check of a scene, the plan of a request, and a comparison of models."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import LOADS, Rows, one_scene, place
from asperity._asperity import Scene
from asperity._model import Model, as_model, as_models
from asperity._table import Table

@dataclass(frozen=True)
class Plan:
    """The integrals of a request; ``print`` it."""

    #: Of each integral the ``law``, the force's for the tangent, the ``quantities`` it yields, its
    #: ``method``, the fewest and most ``terms`` of a value that is a sum, and ``samples`` of the law.
    steps: tuple[dict[str, Any], ...]
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
    return Plan(tuple(found["steps"]), text.rstrip("\n"))


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
    >>> numbers = {"plasticity_index": 0.3, "roughness_parameter": 0.04}
    >>> smooth = asperity.Surface.of(**numbers, asperity_height_std=1e-7, interface=interface)
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
    model: str | Model | None = None,
    separation: float | str | None = None,
    *,
    load: float | str | None = None,
    pressure: float | str | None = None,
    separation_unit: str = "asperity_height_std",
) -> Table:
    """Derived numbers of the scene, and findings about unusual ones, with the unit that would
    explain them. At a separation, load [N] or pressure [Pa] also the numbers of the contact, and
    findings about the range of the model: by default "ke", or "gw" without a hardness. A surface
    that is known within ranges has columns for the ends of theirs, ``lower`` and ``upper``.

    >>> import asperity
    >>> interface = asperity.Interface(116, 0.31, hardness=1.12e9)
    >>> surface = asperity.Surface(3.6e-4, 1.1e8, 1e-6)
    >>> found = asperity.check(asperity.Scene(interface, surface, nominal_area=3e-5))
    >>> finding = found.findings[0]
    >>> finding.severity, finding.field, finding.message.split(": ")[-1]
    ('warning', 'equivalent_modulus', '116 looks like GPa; 116 GPa is 1.16e11 Pa')
    >>> round(found.numbers["roughness_parameter"], 4)
    0.0396
    """
    where = {"separation": separation, "load": load, "pressure": pressure}
    if all(number is None for number in where.values()):
        return Table(*_asperity.check(scene))
    axis, number = place(separation_unit, **where)
    return Table(*_asperity.check(scene, (as_model(model or scene._usual_reference()), axis, number)))
