"""The check of a scene, and what is known best."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import floats, in_si, method_of, one_number, place
from asperity._asperity import Scene
from asperity._bem import BemContacts
from asperity._model import Model, as_model
from asperity._table import Table, aligned


class Answer(Table):
    """What is known best about a scene under loads; made by ``Scene.answer``.

    ``value``, ``lower`` and ``upper`` are numbers by quantity, arrays for several loads: ``area``
    [m^2], stiffnesses [N/m], ``mean-gap`` [m]. Without evidence the ends are NaN.
    """

    value: dict[str, Any]
    lower: dict[str, Any]
    upper: dict[str, Any]
    #: Models and solved surfaces behind the answer, and of what its intervals are.
    by: str
    #: The unknown of the surface that makes ranges wide, and the shares of all.
    widest: str
    #: Other models, each with its deviation from the answer.
    also: str
    #: The lines that the program prints: quantity, value, from, to, unit.
    lines: list[list[str]]

    def _numbers(self, quantity: str, head: str, end: str) -> Any:
        name = quantity.replace("-", "_")
        # Of curved bodies there are no ends.
        none = np.full(len(self), np.nan)
        column = self.columns.get(f"{name}{end}{head.removeprefix(name)}", none)
        return float(column[0]) if len(column) == 1 else column

    def __str__(self) -> str:
        behind = {"by": self.by, "widest": self.widest, "also": self.also}
        texts = [f"{name:<8}{text}" for name, text in behind.items() if text]
        return "\n".join([*aligned(self.lines), *texts, *map(str, self.findings)])

    def _repr_html_(self) -> str:
        head, *rows = [[escape(cell) for cell in line] for line in self.lines]
        cells = ["".join(f"<td>{cell}</td>" for cell in row) for row in rows]
        heads = "".join(f"<th>{cell}</th>" for cell in head)
        body = "".join(f"<tr>{row}</tr>" for row in cells)
        behind = "".join(f"<p>{escape(text)}</p>" for text in (self.by, self.widest, self.also) if text)
        return f"<table><tr>{heads}</tr>{body}</table>{behind}"


@method_of(Scene)
def answer(
    self: Scene,
    quantities: str | Sequence[str] | None = None,
    *,
    load: npt.ArrayLike | None = None,
    pressure: npt.ArrayLike | None = None,
    approach: npt.ArrayLike | None = None,
    rtol: float = 1e-10,
    solve: bool = False,
    solved: BemContacts | None = None,
) -> Answer:
    """What is known best about the scene under loads: by boundary elements on its scan, where that
    was solved; else as they are expected from solved surfaces, with an interval that holds nine
    of ten between these and without one beyond them; else, as with adhesion, by the first valid
    model. The model "best" gives the same numbers.

    ``solve=True`` solves the scan at the loads; ``solved`` takes what ``asperity.bem`` has
    solved. By default the quantities are area, tangent, unloading-stiffness and, as the scene
    has them, tangential-stiffness and thermal-conductance-per-area; the mean gap is always
    there. Curved bodies have an answer under loads or at approaches [m], by one model, without
    an interval.

    >>> import asperity
    >>> answer = asperity.Scene.parse(asperity.template()).answer(load="100 N")
    >>> answer.lower["area"] < answer.value["area"] < answer.upper["area"]
    True
    """
    axis, given = place(load=load, pressure=pressure, approach=approach)
    numbers = floats(given, axis).ravel().tolist()
    if solved is not None and getattr(solved, "scene", None) != self:
        needed = "asperity.bem(scene, ...) without boundary and elastic, which are options of the scene"
        raise ValueError(f"solved is not of this scene with its options: {needed}")
    solving: Any = solve if solved is None else _solved(solved)
    table, (behind, lines) = _asperity.best(self, (axis, numbers), quantities, rtol, solving)
    found = Answer(*table)
    own = {q: head for q, head in _columns().items() if head in found.columns and q != "pressure"}
    for name, end in {"value": "", "lower": "_lower", "upper": "_upper"}.items():
        vars(found)[name] = {q: found._numbers(q, head, end) for q, head in own.items()}
    vars(found).update(by=behind[0], widest=behind[1], also=behind[2], lines=lines)
    return found


@method_of(Scene)
def profile(self: Scene, load: float | str, model: str = "best", *, rtol: float = 1e-6) -> Table:
    """The patch of curved bodies under a load [N], by "best" or another model: at each point
    ``x_m``, ``y_m``, ``pressure_Pa`` beside ``hertz_pressure_Pa`` of smooth bodies,
    ``separation_m`` from the mean of the asperity heights, ``area_fraction``, and
    ``tangential_flexibility_m3_per_N`` of the rough layer, to be added to that of the bodies."""
    number = one_number("load", in_si(load, "N"))
    return Table(*_asperity.profile(self, number, model, rtol))


def _columns() -> dict[str, str]:
    """The heads of columns by the names of quantities, with the mean gap."""
    return {**_asperity.quantities(), "mean-gap": "mean_gap_m"}


def _solved(contacts: Table) -> tuple[list[tuple[float, dict[str, float]]], list[str]]:
    """The rows of ``bem`` as an input of an answer, and the codes of what there is to say."""
    known = {name: head for name, head in _columns().items() if head in contacts.columns}
    rows = [
        (float(pressure), {name: float(contacts[head][k]) for name, head in known.items()})
        for k, pressure in enumerate(contacts["pressure_Pa"])
    ]
    return rows, [finding.code for finding in contacts.findings]


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
