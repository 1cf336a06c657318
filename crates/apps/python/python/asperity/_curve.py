"""Results of a model."""

from __future__ import annotations

from dataclasses import dataclass
from difflib import get_close_matches
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import AXES, LOADS, Aspect, Floats, Rows, SceneLike
from asperity._asperity import Engine

if TYPE_CHECKING:
    import pandas as pd


def _text(table: dict[str, npt.NDArray[Any]]) -> str:
    """The text of a table with every digit, blank for missing values."""
    cells = (["" if v != v else str(v) for v in c.tolist()] for c in table.values())
    return "\n".join([",".join(table), *map(",".join, zip(*cells, strict=True))]) + "\n"


@dataclass(eq=False, repr=False)
class Curve:
    """Quantities of a contact at separations or under loads, in SI units; made by ``Model.solve``.

    A quantity is an attribute (``curve.force``, ``curve.mean_pressure``) or an item
    (``curve["mean-pressure"]``), in the shape of scenes and separations, broadcast. Logarithms,
    errors and shares are computed on request.

    >>> import asperity
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> curve = asperity.model("ke").solve(scene, separation=[0.0, 2.0, 30.0])
    >>> curve
    <asperity.Curve of KE: force at 3 separations from 0 to 30 asperity_height_std, rtol=1e-10>
    >>> curve.force.shape, round(float(curve.ln("force")[2]), 3)
    ((3,), -448.475)
    >>> {part: round(float(share[1]), 4) for part, share in curve.shares("force").items()}
    {'elastic': 0.0022, 'elastic-plastic': 0.1221, 'elastic-plastic 2': 0.8757, 'plastic': 0.0}
    """

    _engine: Engine
    #: Name of the model.
    model: str
    _rows: Rows
    #: Relative tolerance of every value.
    rtol: float
    #: ``"asperity_height_std"`` or ``"m"``.
    separation_unit: str
    _columns: dict[str, Floats]
    #: Why rows have no values, where ``errors="mask"``: by their place in the order of memory.
    failures: dict[int, str]

    @property
    def scene(self) -> SceneLike:
        """The scene, or the scenes, as they were given."""
        return self._rows.scenes

    @property
    def quantities(self) -> tuple[str, ...]:
        """The requested quantities."""
        return tuple(self._columns)

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of every array."""
        return self._rows.shape

    @property
    def separation(self) -> Floats:
        """The separations as they were given; under loads, those that carry them, in the shape of the
        curve, the largest where there are several."""
        rows = self._rows
        if rows.axis == self.separation_unit:
            return rows.given
        found: Floats = rows.separations(self._engine, self.separation_unit, self.rtol, "mask")
        return found

    def __getitem__(self, quantity: str) -> Floats:
        name = quantity.replace("_", "-")
        if name.replace("-", "_") == self._rows.axis and name not in self._columns:
            return self._rows.given
        if name not in self._columns:
            asked = ", ".join(self._columns)
            known = _asperity.quantities()
            if name not in known:
                near = get_close_matches(name, known, 1)
                hint = f" (the nearest is {near[0]})" if near else ""
                raise KeyError(f"{name} is not a quantity{hint}: the requested ones are {asked}")
            raise KeyError(f"{name} was not requested: add it to the quantities ({asked})")
        return self._columns[name]

    def __getattr__(self, name: str) -> Floats:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(*error.args) from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(name.replace("-", "_") for name in self._columns)]

    def _aspect(self, quantity: str, aspect: Aspect) -> Floats:
        self[quantity]
        _, found, _, _ = self._rows.answer(self._engine, quantity, self.rtol, aspect, "mask")
        return found[quantity.replace("_", "-")]

    def error(self, quantity: str) -> Floats:
        """A bound on the error of every value: relative, but a difference for logarithms and
        shares."""
        return self._aspect(quantity, "error")

    def ln(self, quantity: str) -> Floats:
        """The natural logarithm of every absolute value, also of values that underflow to 0."""
        return self._aspect(quantity, "ln")

    def shares(self, quantity: str) -> dict[str, Floats]:
        """The share of every part of the law in every value; shares sum to 1."""
        rows = self._rows
        missing = np.ma.getmaskarray(self[quantity])
        if missing.any():
            rows = rows.without(missing)
        found = _asperity.shares((self._engine, rows, quantity, self.rtol))
        return {name: rows.shaped(share) for name, share in found.items()}

    def _table(self) -> dict[str, npt.NDArray[Any]]:
        """Columns with units in their heads, a row for each value."""
        rows = self._rows
        table: dict[str, npt.NDArray[Any]] = {}
        places = np.broadcast_to(rows.places, rows.shape).ravel()
        if not rows.is_one:
            table["scene"] = places
        # What varies between the scenes.
        for name, values in rows.columns.items():
            table[_asperity.column_of(name)] = values[places]
        table[AXES[rows.axis][0]] = np.broadcast_to(rows.given, rows.shape).ravel()
        # Boundary elements would be solved again; of curved bodies the approach is a quantity.
        if rows.axis in LOADS and self._engine.id != "bem" and not rows.is_curved:
            table[AXES[self.separation_unit][0]] = np.ma.filled(self.separation, np.nan).ravel()
        heads = _asperity.quantities(self._columns)
        filled = {heads[q]: np.ma.filled(v, np.nan).ravel() for q, v in self._columns.items()}
        return table | filled

    def to_csv(self, path: str | PathLike[str] | None = None) -> str:
        """The text of a table with a row for each value and units in its head: every digit, blank for
        missing values; also written to ``path``, if given.

        >>> import asperity
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> print(asperity.model("gw").solve(scene, [1.0, 2.0]).to_csv(), end="")
        separation,force_N
        1.0,3292.64500634...
        2.0,289.290552625...
        """
        text = _text(self._table())
        if path is not None:
            Path(path).write_text(text, encoding="utf-8", newline="\n")
        return text

    def to_dataframe(self) -> pd.DataFrame:
        """A table with a row for each value, units in its head: the numbers that vary between the
        scenes, the load or separation and, at loads, the separation that carries it (NaN where a
        model has none); needs pandas.

        >>> import asperity
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> curve = asperity.model("gw").solve(scene, separation=[1, 2], quantities=["force", "area"])
        >>> list(curve.to_dataframe().columns)
        ['separation', 'force_N', 'area_m2']
        """
        import pandas as pd

        return pd.DataFrame(self._table())

    def __repr__(self) -> str:
        rows = self._rows
        numbers = rows.given
        _, axis, unit = AXES[rows.axis]
        where = f"{numbers.size} {axis}{'s' if numbers.size != 1 else ''}"
        if numbers.size > 1:
            where += f" from {numbers.min():g} to {numbers.max():g}"
        elif numbers.size == 1:
            where += f", {numbers.item():g}"
        shape = "" if rows.is_one else f" of shape {self.shape}, on many scenes,"
        return (
            f"<asperity.Curve of {self.model}: {', '.join(self.quantities)}{shape} at {where} "
            f"{unit}, rtol={self.rtol:g}>"
        )
