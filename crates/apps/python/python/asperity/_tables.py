"""Contact tables for finite-element codes."""

from __future__ import annotations

from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path

from asperity import _asperity
from asperity._arguments import LOADS, Floats, one_scene, place, two_numbers
from asperity._asperity import Scene
from asperity._model import Model, as_model


@dataclass(frozen=True, eq=False)
class ContactTable:
    """Pressure over clearance at nodes; ``print`` it, or ``save`` its text."""

    #: Clearances from the scene's plane [m], ascending.
    clearance: Floats
    #: Pressures on the nominal area [Pa].
    pressure: Floats
    #: Their tangents, -dp/dclearance [Pa/m].
    tangent: Floats
    #: Largest relative errors between the nodes.
    pressure_error: float
    tangent_error: float
    #: The input text of the finite-element code.
    text: str = field(repr=False)

    def save(self, path: str | PathLike[str]) -> None:
        """Writes ``text`` to a file."""
        Path(path).write_text(self.text, encoding="utf-8", newline="\n")

    def __str__(self) -> str:
        return self.text


def export(
    model: str | Model,
    scene: Scene,
    format: str = "csv",
    *,
    separation: tuple[float, float] | tuple[str, str] | None = None,
    load: tuple[float, float] | tuple[str, str] | None = None,
    pressure: tuple[float, float] | tuple[str, str] | None = None,
    nodes: int | None = None,
    max_error: float | None = None,
    separation_unit: str = "asperity_height_std",
    rtol: float = 1e-10,
    conductance: bool = False,
    units: str = "SI",
) -> ContactTable:
    """Pressure over clearance for a finite-element code, from one separation, load [N] or pressure
    [Pa] to another: at ``nodes`` equally spaced clearances, or at as many as keep the pressure
    between them within a relative ``max_error``.

    The format is "csv" (for cubic interpolation), or "abaqus" or "calculix" (both for linear
    interpolation), to which ``conductance`` adds the thermal conductance against pressure. The text
    is in ``units`` "SI" or "mm-N-MPa" (also named "mm-tonne-s", with power in mW).

    >>> import asperity
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> table = asperity.export("ke", scene, "abaqus", load=(1, 1000), max_error=0.01)
    >>> "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR" in table.text
    True
    """
    if isinstance(model, Scene):
        raise TypeError("model is a Scene: export takes the model first, then the scene")
    scene = one_scene(scene, "export")
    axis, ends_given = place(
        separation_unit, separation=separation, load=load, pressure=pressure
    )
    ends = axis, *two_numbers(axis if axis in LOADS else "separation", ends_given)
    if nodes is None and max_error is None:
        raise TypeError("nodes or max_error was required")
    count = 2 if nodes is None else nodes
    spacing, form = (count, max_error, rtol), (format, units)
    found = _asperity.contact_table(as_model(model), scene, ends, spacing, form, conductance)
    columns, pressure_error, tangent_error, text = found
    clearance, pressures, tangent = columns.values()
    return ContactTable(clearance, pressures, tangent, pressure_error, tangent_error, text)
