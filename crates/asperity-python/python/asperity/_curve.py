"""What comes back from a model."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np

from asperity._arguments import UNITS, Floats, Many, SceneLike, Shape
from asperity._asperity import Contact, Engine

if TYPE_CHECKING:
    import pandas as pd

Aspect: TypeAlias = Literal["value", "ln_value", "error"]


class Curve:
    """Quantities of a contact at separations, in SI units; made by ``Model.solve``.

    Arrays have the shape of scenes and separations, broadcast. Logarithms, errors and shares are
    computed when they are asked for.

    >>> import asperity
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> curve = asperity.model("ke").solve(scene, separation=[0.0, 2.0, 60.0])
    >>> curve
    <asperity.Curve of KE: force at 3 separations from 0 to 60 asperity_height_std, rtol=1e-10>
    >>> curve.force.shape, float(curve.force[2]), round(float(curve.ln("force")[2]), 3)
    ((3,), 0.0, -1800.189)
    >>> {part: round(float(share[1]), 4) for part, share in curve.shares("force").items()}
    {'elastic': 0.0022, 'elastic-plastic': 0.1221, 'elastic-plastic 2': 0.8757, 'plastic': 0.0}
    """

    def __init__(
        self,
        engine: Engine,
        name: str,
        scene: SceneLike,
        many: Many,
        rtol: float,
        metres: bool,
        contact: Contact | None,
        columns: dict[str, Floats],
    ) -> None:
        self._engine, self._many, self._metres = engine, many, metres
        self._contact, self._columns = contact, columns
        #: Name of the model.
        self.model = name
        #: The scene, or the scenes, as they were given.
        self.scene = scene
        #: Relative tolerance of every value.
        self.rtol = rtol

    @property
    def quantities(self) -> tuple[str, ...]:
        """What was asked for."""
        return tuple(self._columns)

    @property
    def separation(self) -> Floats:
        """The separations as they were asked for, in ``separation_unit``."""
        return self._many.numbers

    @property
    def separation_unit(self) -> str:
        """``"asperity_height_std"`` or ``"m"``."""
        return "m" if self._metres else "asperity_height_std"

    @property
    def shape(self) -> Shape:
        """Shape of every array."""
        return self._many.shape

    def __getitem__(self, quantity: str) -> Floats:
        return self._column(quantity, KeyError)

    def _column(self, quantity: str, error: type[Exception]) -> Floats:
        if quantity not in self._columns:
            asked = ", ".join(self._columns)
            raise error(f"{quantity} was not requested: add it to the quantities ({asked})")
        return self._columns[quantity]

    @property
    def force(self) -> Floats:
        """Contact force [N]."""
        return self._column("force", AttributeError)

    @property
    def area(self) -> Floats:
        """Real area of contact [m^2]."""
        return self._column("area", AttributeError)

    @property
    def stiffness(self) -> Floats:
        """Stiffness as the model's paper defines it [N/m]."""
        return self._column("stiffness", AttributeError)

    @property
    def tangent(self) -> Floats:
        """-dF/dd [N/m], jumps of the law included."""
        return self._column("tangent", AttributeError)

    def _aspect(self, quantity: str, aspect: Aspect) -> Floats:
        self._column(quantity, ValueError)
        many = self._many
        if self._contact is not None:
            found, _ = self._contact._column(quantity, many.flat, self._metres, aspect)
        else:
            asked = [quantity], self.rtol, aspect
            columns, _ = self._engine.sweep(
                many.scenes, many.index, many.flat, self._metres, *asked
            )
            found = columns[0]
        return many.shaped(found)

    def error(self, quantity: str) -> Floats:
        """A bound on the relative error of every value."""
        return self._aspect(quantity, "error")

    def ln(self, quantity: str) -> Floats:
        """The natural logarithm of every absolute value, also where the value underflows to 0."""
        return self._aspect(quantity, "ln_value")

    def shares(self, quantity: str) -> dict[str, Floats]:
        """The share of every part of the law in every value; shares sum to 1."""
        self._column(quantity, ValueError)
        many = self._many
        if self._contact is not None:
            found = self._contact._shares(quantity, many.flat, self._metres)
            return {name: many.shaped(share) for name, _, share in found}
        shares: dict[str, Floats] = {}
        index, flat = many.index, many.flat
        order = np.argsort(index, kind="stable")
        starts = np.flatnonzero(np.diff(index[order], prepend=-1))
        for here in np.split(order, starts[1:]) if len(order) else []:
            scene = many.scene(int(index[here[0]]))
            contact = self._engine.compile(scene, [quantity], self.rtol)
            for name, _, share in contact._shares(quantity, flat[here], self._metres):
                shares.setdefault(name, np.zeros(len(flat)))[here] = share
        return {name: many.shaped(share) for name, share in shares.items()}

    def to_dataframe(self) -> pd.DataFrame:
        """A table with a row for each value, units in its head; needs pandas.

        >>> import asperity
        >>> scene = asperity.Scene.parse(asperity.template())
        >>> curve = asperity.model("gw").solve(scene, separation=[1, 2], quantities=["force", "area"])
        >>> list(curve.to_dataframe().columns)
        ['separation', 'force_N', 'area_m2']
        """
        import pandas as pd

        columns: dict[str, Any] = {}
        if self._many.one is None:
            columns["scene"] = self._many.index
        columns["separation_m" if self._metres else "separation"] = self._many.flat
        for quantity, values in self._columns.items():
            columns[f"{quantity}_{UNITS[quantity]}"] = values.ravel()
        return pd.DataFrame(columns)

    def __repr__(self) -> str:
        numbers = self._many.numbers
        where = f"{numbers.size} separation{'s' if numbers.size != 1 else ''}"
        if numbers.size > 1:
            where += f" from {numbers.min():g} to {numbers.max():g}"
        elif numbers.size == 1:
            where += f", {numbers.item():g}"
        shape = "" if self._many.one is not None else f" of shape {self.shape}, on many scenes,"
        return (
            f"<asperity.Curve of {self.model}: {', '.join(self.quantities)}{shape} at {where} "
            f"{self.separation_unit}, rtol={self.rtol:g}>"
        )
