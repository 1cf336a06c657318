"""Laws of one asperity written in Python, as the engine takes them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from asperity._asperity import Asperity
from asperity._scene import Floats


class AsperityLaws(Protocol):
    """The laws of one asperity: the protocol of a model written in Python.

    The class is called with an ``Asperity``. ``w`` is an array of interferences in metres, all
    above 0; forces come back in N, areas in m^2, one for each.

    Optional: ``stiffness(w)`` in N/m, where it is not the tangent of the force; ``kinks``, the
    interferences [m] where a formula changes, jumps, bends or has a cusp (a sequence, or a dict of
    them by quantity); ``regimes``, a name for each range between the kinks, for shares; and on the
    class ``name``, and ``force_monotone = False`` where the force may fall as ``w`` grows:
    ``Model.check`` reports a force that falls otherwise.

    Declare every kink. Values with an undeclared kink mostly keep the tolerance and only take more
    time; but a jump, kink or cusp between the sampled interferences escapes the bounds of
    ``Curve.error``, which are then too small, and the error may exceed the tolerance.
    ``Model.check`` finds most undeclared kinks.
    """

    def force(self, w: Floats, /) -> npt.ArrayLike:
        """Force [N] at interferences [m]."""

    def area(self, w: Floats, /) -> npt.ArrayLike:
        """Real area [m^2] at interferences [m]."""


LawsOfAsperity: TypeAlias = Callable[[Asperity], AsperityLaws]
Law: TypeAlias = Callable[[Floats], Floats]


class Laws:
    """The laws of a class: functions that are checked, with their kinks and regimes."""

    def __init__(self, made_for: LawsOfAsperity) -> None:
        if not (callable(made_for) and hasattr(made_for, "force")):
            raise ValueError(
                f"{made_for!r} is no model: an id, or a class with force(w) and area(w), was required"
            )
        self.made_for = made_for
        name = getattr(made_for, "name", None) or getattr(made_for, "__name__", "")
        self.name = str(name)
        self.own_stiffness = hasattr(made_for, "stiffness")
        self.force_monotone = bool(getattr(made_for, "force_monotone", True))

    def __call__(self, one: Asperity, quantity: str) -> tuple[Law, list[float], list[str]]:
        """The law of an asperity, its kinks [m], ascending, and names of the ranges they bound."""
        laws = self.made_for(one)
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
        """Exceptions of the laws for an array of interferences: the engine passes arrays only."""
        found = []
        for quantity in ("force", "area", "stiffness")[: 2 + self.own_stiffness]:
            try:
                law, _, _ = self(one, quantity)
                law(one.radius * np.array([1e-6, 1e-4, 1e-2]))
            except Exception as error:
                raised = f"{type(error).__name__}: {error}"
                found.append(f"{quantity}: {raised}; a law is called with an array of interferences")
        return found

    def _checked(self, law: Callable[[Floats], npt.ArrayLike], quantity: str) -> Law:
        what = f"{self.name}.{quantity}(w)"

        def checked(w: Floats) -> Floats:
            found = np.asarray(law(w))
            if found.dtype.kind not in "fiub":
                raise ValueError(f"{what} has values of type {found.dtype}: numbers were required")
            if found.shape != w.shape:
                raise ValueError(
                    f"{what} has shape {found.shape} for {w.size} interferences: one value for each "
                    "was required"
                )
            bad = np.flatnonzero(~np.isfinite(found))
            if bad.size:
                raise ValueError(
                    f"{what} is {found[bad[0]]} at w = {w[bad[0]]:e} m: a finite number was required"
                )
            return np.ascontiguousarray(found, dtype=np.float64)

        return checked
