"""Results of a model divided by its expected ratio to boundary elements."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import LOADS, Aspect, Rows
from asperity._asperity import Engine
from asperity._curve import Curve
from asperity._scene import Floats


class CorrectedCurve(Curve):
    """Quantities under loads, each divided by the model's expected ratio to boundary elements; made
    by ``Model.solve`` with ``corrected=True``.

    >>> import asperity
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> curve = asperity.model("ke").solve(scene, load=100.0, quantities="area", corrected=True)
    >>> curve.model, bool(curve.lower("area") < curve.area < curve.upper("area"))
    ('ke-corrected', True)
    """

    _ends: dict[str, tuple[Floats, Floats]]

    @classmethod
    def of(
        cls,
        engine: Engine,
        rows: Rows,
        rtol: float,
        separation_unit: str,
        names: list[str],
        errors: str,
    ) -> CorrectedCurve:
        """The corrected quantities of rows."""
        if rows.axis not in LOADS:
            raise ValueError(
                "corrected=True needs load or pressure: models are compared with boundary elements "
                "at equal loads"
            )
        name, found, failures = _asperity.corrected(engine, rows, names, rtol)
        reasons = rows.failed(failures, errors)
        shaped = [tuple(rows.shaped(v, np.isnan(v)) for v in column) for column in found]
        columns = {q: column[0] for q, column in zip(names, shaped, strict=True)}
        curve = cls(engine, name, rows, rtol, separation_unit, columns, reasons)
        curve._ends = {q: (c[1], c[2]) for q, c in zip(names, shaped, strict=True)}
        return curve

    def lower(self, quantity: str) -> Floats:
        """The lower ends of the intervals, which hold nine of ten surfaces."""
        return self._end(quantity, 0)

    def upper(self, quantity: str) -> Floats:
        """The upper ends of the intervals, which hold nine of ten surfaces."""
        return self._end(quantity, 1)

    def _end(self, quantity: str, end: int) -> Floats:
        self[quantity]
        return self._ends[quantity.replace("_", "-")][end]

    @property
    def separation(self) -> Floats:
        """Not available: the separations of the model are not those of corrected values."""
        raise AttributeError("a corrected curve has no separations; solve without corrected=True")

    def _aspect(self, quantity: str, aspect: Aspect) -> Floats:
        raise TypeError(
            f"the {aspect} of corrected values is unknown; use lower and upper, or solve without "
            "corrected=True"
        )

    def shares(self, quantity: str) -> dict[str, Floats]:
        """Not available: boundary elements have no shares of regimes."""
        raise TypeError("shares of corrected values are unknown; solve without corrected=True")

    def _table(self) -> dict[str, npt.NDArray[Any]]:
        table = super()._table()
        for name, ends in self._ends.items():
            for end, values in zip(("lower", "upper"), ends, strict=True):
                column = f"{name}_{end}".replace("-", "_")
                table[column] = np.ma.filled(values, np.nan).ravel()
        return table
