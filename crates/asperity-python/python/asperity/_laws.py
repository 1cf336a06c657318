"""Laws of one asperity written in Python, for the engine."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from asperity._records import Asperity
from asperity._scene import Floats


class AsperityLaws(Protocol):
    """The laws of one asperity: the protocol of a model written in Python.

    The class is called with an ``Asperity``. ``w`` is an array of interferences [m], all above 0;
    the laws return forces [N] and areas [m^2], one for each.

    Optional: ``stiffness(w)`` [N/m], if it is not the tangent of the force; ``kinks``, the
    interferences [m] at which a formula changes, jumps, bends or has a cusp (a sequence, or a dict
    of sequences by quantity); ``regimes``, a name for each range between the kinks, for shares; and
    on the class ``name``, and ``force_monotone = False`` if the force may fall as ``w`` grows:
    without it ``Model.check`` reports such a force.

    Declare every kink. Values with an undeclared kink take more time, and mostly keep the tolerance;
    but a jump, kink or cusp between the sampled interferences escapes the bounds of
    ``Curve.error``, and the error may exceed the tolerance. ``Model.check`` finds most undeclared
    kinks.
    """

    def force(self, w: Floats, /) -> npt.ArrayLike:
        """Force [N] at interferences [m]."""

    def area(self, w: Floats, /) -> npt.ArrayLike:
        """Real area [m^2] at interferences [m]."""


LawsOfAsperity: TypeAlias = Callable[[Asperity], AsperityLaws]
Law: TypeAlias = Callable[[Floats], Floats]


class Laws:
    """The laws of a class: checked functions, with their kinks and regimes."""

    def __init__(self, factory: LawsOfAsperity) -> None:
        if not (callable(factory) and hasattr(factory, "force")):
            raise ValueError(
                f"{factory!r} is no model: an id, or a class with force(w) and area(w), was required"
            )
        self.factory = factory
        name = getattr(factory, "name", None) or getattr(factory, "__name__", "")
        self.name = str(name)
        self.own_stiffness = hasattr(factory, "stiffness")
        self.force_monotone = bool(getattr(factory, "force_monotone", True))

    def __call__(self, one: Asperity, quantity: str) -> tuple[Law, list[float], list[str]]:
        """The law of an asperity, its kinks [m], ascending, and the names of the ranges between them."""
        laws = self.factory(one)
        kinks: Any = getattr(laws, "kinks", None)
        kinks = kinks() if callable(kinks) else kinks
        kinks = kinks.get(quantity) if isinstance(kinks, Mapping) else kinks
        numbers = {float(kink) for kink in (() if kinks is None else kinks)}
        within = sorted(kink for kink in numbers if 0.0 < kink < np.inf)
        regimes = list(getattr(laws, "regimes", None) or ())
        if regimes and len(regimes) != len(within) + 1:
            raise ValueError(
                f"regimes has {len(regimes)} names: one more than the {len(within)} kinks was required"
            )
        return self._checked(getattr(laws, quantity), quantity), within, regimes

    def findings(self, one: Asperity) -> list[str]:
        """Exceptions of the laws for an array of interferences, which the engine passes."""
        found = []
        for quantity in ("force", "area", "stiffness")[: 2 + self.own_stiffness]:
            try:
                law, _, _ = self(one, quantity)
                law(one.radius * np.array([1e-6, 1e-4, 1e-2]))
            except Exception as error:
                raised = f"{type(error).__name__}: {error}"
                found.append(f"{quantity}: {raised}; a law must accept an array of interferences")
        return found

    def _checked(self, law: Callable[[Floats], npt.ArrayLike], quantity: str) -> Law:
        call = f"{self.name}.{quantity}(w)"

        def checked(w: Floats) -> Floats:
            found = np.asarray(law(w))
            if found.dtype.kind not in "fiub":
                raise ValueError(f"{call} has values of type {found.dtype}: real numbers were required")
            if found.shape != w.shape:
                raise ValueError(
                    f"{call} has shape {found.shape} for {w.size} interferences: one value for each "
                    "was required"
                )
            bad = np.flatnonzero(~np.isfinite(found))
            if bad.size:
                raise ValueError(
                    f"{call} is {found[bad[0]]} at w = {w[bad[0]]:e} m: a finite number was required"
                )
            return np.ascontiguousarray(found, dtype=np.float64)

        return checked
