"""Results of a model divided by its expected ratio to boundary elements."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import AXES, LOADS, Aspect, Rows
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
    _separation: Floats

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
        name, found, apart, failures, no_separation = _asperity.corrected(
            engine, rows, separation_unit, names, rtol
        )
        reasons = rows.failed(failures, errors) | rows.failed(no_separation, "mask")
        shaped = [tuple(rows.shaped(v, np.isnan(v)) for v in column) for column in [*found, apart]]
        every = [*names, "separation"]
        columns = {q: column[0] for q, column in zip(names, shaped, strict=False)}
        curve = cls(engine, name, rows, rtol, separation_unit, columns, reasons)
        curve._ends = {q: (c[1], c[2]) for q, c in zip(every, shaped, strict=True)}
        curve._separation = shaped[-1][0]
        return curve

    def lower(self, quantity: str) -> Floats:
        """The lower ends of the intervals, which hold nine of ten surfaces; also of the
        ``separation``."""
        return self._end(quantity, 0)

    def upper(self, quantity: str) -> Floats:
        """The upper ends of the intervals, which hold nine of ten surfaces; also of the
        ``separation``."""
        return self._end(quantity, 1)

    def _end(self, quantity: str, end: int) -> Floats:
        if quantity != "separation":
            self[quantity]
        return self._ends[quantity.replace("_", "-")][end]

    @property
    def separation(self) -> Floats:
        """The separations of the model less its expected differences of mean gaps; masked where the
        solved surfaces do not determine them, with the reason in ``reasons``."""
        return self._separation

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
            head = AXES[self.separation_unit] if name == "separation" else name
            columns = dict(zip((f"{head}_lower", f"{head}_upper"), ends, strict=True))
            if name == "separation":
                columns = {head: self._separation, **columns}
            for column, values in columns.items():
                table[column.replace("-", "_")] = np.ma.filled(values, np.nan).ravel()
        return table
