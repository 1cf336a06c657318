"""Models compared with boundary elements on a scan."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, TypedDict

import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import checked_errors, place
from asperity._asperity import Scene
from asperity._bem import Boundary


class TruthRow(TypedDict):
    """One model at one pressure, compared with boundary elements."""

    load: float
    pressure: float
    model: str
    area_fraction: float | None
    area_deviation: float | None
    mean_gap: float | None
    mean_gap_deviation: float | None
    stiffness: float | None
    stiffness_deviation: float | None


class TruthRows(list[TruthRow]):
    """Rows of ``truth``."""

    #: The models nearest to boundary elements, in a sentence; None if none was compared.
    nearest: str | None = None
    #: How far the usual reference model is from boundary elements on this scan, and whether solved
    #: surfaces would have said the same, a sentence for each quantity; or why they say nothing.
    solved_surfaces: tuple[str, ...] = ()
    #: The reasons of models without a row or with blanks, by model.
    refused: Mapping[str, str] = MappingProxyType({})
    #: What lies beyond the edges of the scan: "periodic", "periodic-part" or "free".
    boundary: str = "periodic"
    #: The reasons of pressures without rows with ``errors="mask"``, by place.
    failures: Mapping[int, str] = MappingProxyType({})

    def __str__(self) -> str:
        """A table of the rows, and the nearest models."""
        heads = list(TruthRow.__annotations__)
        table = [heads, *([_cell(value) for value in row.values()] for row in self)]
        widths = [max(map(len, column)) for column in zip(*table, strict=True)]
        cells = (zip(line, widths, strict=True) for line in table)
        lines = ["  ".join(f"{cell:<{width}}" for cell, width in line).rstrip() for line in cells]
        return "\n".join([*lines, *([self.nearest] if self.nearest else []), *self.solved_surfaces])


def _cell(value: Any) -> str:
    if value is None:
        return ""
    return value if isinstance(value, str) else f"{value:.4g}"


def truth(
    scene: Scene,
    *,
    pressure: npt.ArrayLike | None = None,
    load: npt.ArrayLike | None = None,
    elastic: bool = False,
    boundary: Boundary | None = None,
    models: Sequence[str] | None = None,
    refine: bool = False,
    errors: str = "raise",
) -> TruthRows:
    """Models compared with boundary elements on a scan.

    The file of the scene names a scan ([surface] file = ...). Every pressure has a row for "bem" and
    one for every model: all that the scene allows, or the named ones. Deviations are relative to
    bem; that of the mean gap is over the rms height of the scan. A quantity that a model lacks is
    None, with a warning, and so are all numbers of a model that needs more than the nominal area, or
    a pressure above 1.5 times the hardness. ``rows.refused`` has the reasons, also for models that
    the scene does not allow. ``pandas.DataFrame(rows)`` makes a table, ``rows.nearest`` names the
    nearest models, ``rows.solved_surfaces`` says whether the table behind ``recommend`` agrees, and
    with ``refine`` the rows "bem-half-grid" show the effect of the grid. A pressure without a
    solution raises or, with ``errors="mask"``, has no rows and a reason in ``rows.failures``.
    """
    if (pressure is None) == (load is None):
        raise TypeError("exactly one of pressure and load was required")
    name, value = place(None, load, pressure, "m")
    pressures = _asperity.floats(value, name).ravel()
    if name == "load":
        pressures = pressures / scene.nominal_area
    ids = None if models is None else list(models)
    refine_and_mask = refine, checked_errors(errors) == "mask"
    found, (nearest, beside), refused, failures, used = _asperity.truth(
        scene, pressures.tolist(), elastic, boundary, ids, refine_and_mask
    )
    names = TruthRow.__annotations__
    rows = TruthRows(TruthRow(**dict(zip(names, row, strict=True))) for row in found)  # type: ignore[typeddict-item]
    rows.nearest, rows.refused, rows.failures = nearest, refused, failures
    rows.boundary, rows.solved_surfaces = used, tuple(beside)
    return rows
