"""Results of a model divided by its expected ratio to boundary elements."""

from __future__ import annotations

from collections.abc import Sequence
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

    _ends: tuple[dict[str, Floats], dict[str, Floats]]
    _separation: Floats

    @classmethod
    def of(
        cls,
        engine: Engine,
        rows: Rows,
        rtol: float,
        separation_unit: str,
        quantities: str | Sequence[str],
        errors: str,
    ) -> CorrectedCurve:
        """The corrected quantities of rows."""
        if rows.axis not in LOADS:
            raise ValueError(
                "corrected=True needs load or pressure: models are compared with boundary elements "
                "at equal loads"
            )
        asked = engine, rows, quantities, rtol
        name, found, failures, no_separation = _asperity.corrected(asked, separation_unit)
        reasons = rows.failed(failures, errors) | rows.failed(no_separation, "mask")
        columns, lower, upper = (
            {q: rows.shaped(ends[k]) for q, ends in found.items()} for k in range(3)
        )
        separation = columns.pop("separation")
        curve = cls(engine, name, rows, rtol, separation_unit, columns, reasons)
        curve._ends, curve._separation = (lower, upper), separation
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
        return self._ends[end][quantity.replace("_", "-")]

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
        (lower, upper), columns = self._ends, {}
        for name in lower:
            head = name.replace("-", "_")
            if name == "separation":
                head = AXES[self.separation_unit]
                columns[head] = self._separation
            columns |= {f"{head}_lower": lower[name], f"{head}_upper": upper[name]}
        filled = {head: np.ma.filled(v, np.nan).ravel() for head, v in columns.items()}
        return super()._table() | filled
