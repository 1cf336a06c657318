"""Uncertain inputs and their distributions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from asperity._arguments import LOADS, Floats, Rows, place
from asperity._asperity import Scene


class HasPpf(Protocol):
    """A frozen distribution of scipy.stats: ``scipy.stats.norm(1e9, 1e8)``."""

    def ppf(self, q: npt.NDArray[np.float64], /) -> Any:
        """Quantiles at probabilities between 0 and 1."""


class HasIcdf(Protocol):
    """A distribution of SciPy's newer interface: ``scipy.stats.Normal(mu=1e9, sigma=1e8)``."""

    def icdf(self, p: npt.NDArray[np.float64], /) -> Any:
        """Quantiles at probabilities between 0 and 1."""


#: A distribution; (low, high) for a uniform distribution; or a constant.
Input: TypeAlias = HasPpf | HasIcdf | tuple[float, float] | float
#: An input, also as texts with a unit.
Given: TypeAlias = Input | tuple[str, str] | str

# The quantiles at these probabilities identify a distribution.
PROBES = np.array([0.001, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999])


class Space:
    """A scene with uncertain numbers, each with a distribution.

    Parameters
    ----------
    scene : Scene
        The scene of the other numbers.
    separation, load or pressure : distribution, (low, high) or float
        One of the three: a separation in the ``separation_unit`` of the sweep, a load [N], or a mean
        pressure on the nominal area [Pa].
    **inputs : distribution, (low, high) or float
        By the names of ``Scene.replace``, in SI units; of ``plasticity_index`` and
        ``roughness_parameter`` a missing one is that of the scene.

    A distribution is a frozen one of ``scipy.stats``, or anything with a ``ppf``; (low, high) is
    uniform. Numbers may be texts with a unit, as "2 kN". Inputs are independent of each other.

    Examples
    --------
    >>> import asperity, scipy.stats
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> asperity.Space(scene, load=(100.0, 200.0), hardness=scipy.stats.norm(2e9, 1e8))
    <asperity.Space: load=(100.0, 200.0), hardness=norm(2000000000.0, 100000000.0)>
    """

    def __init__(
        self,
        scene: Scene,
        separation: Given | None = None,
        *,
        load: Given | None = None,
        pressure: Given | None = None,
        **inputs: Given,
    ) -> None:
        if not isinstance(scene, Scene):
            raise TypeError(f"scene is {scene!r}: a Scene was required")
        numbers: dict[str, Input] = scene._inputs_in_si(inputs)
        axis, where = place(separation, load, pressure, "asperity_height_std")
        #: The scene of the other numbers.
        self.scene = scene
        #: The meaning of the places: "separation", "load" or "pressure".
        self.axis = axis if axis in LOADS else "separation"
        # Texts with a unit are converted to metres, for any unit of the sweep.
        self._in_metres = axis == "m"
        #: The inputs as given, the place first.
        self.inputs: dict[str, Input] = {self.axis: where, **numbers}
        for name, given in self.inputs.items():
            _check(name, given)
        if not self.names:
            raise ValueError("no input has a distribution: at least one was required")

    @property
    def names(self) -> tuple[str, ...]:
        """The inputs that vary, in order: one dimension of the samples each."""
        return tuple(name for name, given in self.inputs.items() if not _is_number(given))

    def columns(self, sample: Floats) -> dict[str, Floats]:
        """The inputs that vary, in order, for points of the unit cube, one row each."""
        places = zip(self.names, sample.T, strict=True)
        return {name: _quantiles(name, self.inputs[name], u) for name, u in places}

    def rows(self, columns: dict[str, Floats], separation_unit: str) -> Rows:
        """The rows of columns of inputs."""
        given: dict[str, Any] = {**self.inputs, **columns}
        where = given.pop(self.axis)
        unit = "m" if self._in_metres else separation_unit
        axis = unit if self.axis == "separation" else self.axis
        return Rows(self.scene.vary(**given), axis, where)

    def identity(self) -> dict[str, Any]:
        """The scene and its inputs, for JSON."""
        inputs: dict[str, Any] = {}
        for name, given in self.inputs.items():
            unit = " m" if self._in_metres and name == self.axis else ""
            inputs[name] = {"is": _description(given) + unit}
            if not _is_number(given):
                inputs[name]["quantiles"] = _quantiles(name, given, PROBES).tolist()
        interface, surface = self.scene.interface, self.scene.surface
        fields = self.scene._arguments()
        if isinstance(fields["surface"], dict):
            # Numbers that are written otherwise vary otherwise.
            fields["written"] = fields["surface"]
        fields |= {"interface": interface._numbers(), "surface": surface._numbers()}
        if interface._origin:
            fields["bodies"] = [body._numbers() for body in interface._origin]
        if surface._origin:
            fields["roughness"] = surface._origin
        return {**fields, "inputs": inputs}

    def __repr__(self) -> str:
        inputs = ", ".join(f"{name}={_description(given)}" for name, given in self.inputs.items())
        return f"<asperity.Space: {inputs}>"


def _is_number(given: Any) -> bool:
    return isinstance(given, int | float | np.number)


def _quantile_function(given: Any) -> Callable[[Floats], Any] | None:
    if isinstance(given, tuple):
        low, high = given
        return lambda u: low + (high - low) * u
    return getattr(given, "ppf", None) or getattr(given, "icdf", None)


def _check(name: str, given: Input) -> None:
    if isinstance(given, tuple):
        if len(given) != 2 or not all(_is_number(end) and np.isfinite(end) for end in given):
            raise ValueError(f"{name} is {given!r}: (low, high), two finite numbers, was required")
        if not given[0] < given[1]:
            raise ValueError(f"{name} is {given!r}: low must be below high")
    elif not _is_number(given) and _quantile_function(given) is None:
        raise TypeError(
            f"{name} is {given!r}: a distribution with a ppf, (low, high) or a number was required"
        )


def _quantiles(name: str, given: Input, u: Floats) -> Floats:
    function = _quantile_function(given)
    values = np.ascontiguousarray(function and function(u), dtype=np.float64)
    if values.shape != u.shape:
        raise ValueError(
            f"{name} has quantiles of shape {values.shape} at {u.size} probabilities: one number "
            "for each was required"
        )
    return values


def _description(given: Any) -> str:
    frozen = getattr(given, "dist", None)
    if frozen is not None and hasattr(given, "args") and hasattr(given, "kwds"):
        arguments = [repr(float(argument)) for argument in given.args]
        arguments += [f"{name}={float(value)!r}" for name, value in given.kwds.items()]
        return f"{frozen.name}({', '.join(arguments)})"
    text = repr(given)
    return type(given).__name__ if " object at 0x" in text else text
