"""What varies, and how."""

from __future__ import annotations

from typing import Any, Protocol, TypeAlias, runtime_checkable

import numpy as np
import numpy.typing as npt

from asperity._arguments import Floats
from asperity._asperity import Scene, Scenes


@runtime_checkable
class HasPpf(Protocol):
    """A frozen distribution of scipy.stats: ``scipy.stats.norm(1e9, 1e8)``."""

    def ppf(self, q: npt.NDArray[np.float64], /) -> Any:
        """Quantiles at probabilities between 0 and 1."""


@runtime_checkable
class HasIcdf(Protocol):
    """A distribution of SciPy's newer kind: ``scipy.stats.Normal(mu=1e9, sigma=1e8)``."""

    def icdf(self, p: npt.NDArray[np.float64], /) -> Any:
        """Quantiles at probabilities between 0 and 1."""


#: A distribution; (low, high) for a uniform one; or one number, which does not vary.
Input: TypeAlias = HasPpf | HasIcdf | tuple[float, float] | float

ROUGHNESS = ("plasticity_index", "roughness_parameter")
# Probabilities at which a distribution is written down, to tell it from another.
PROBES = np.array([0.001, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999])


class Space:
    """A scene some of whose numbers are uncertain, each by a distribution of its own.

    Parameters
    ----------
    scene : Scene
        Says everything that is not given here.
    separation : distribution, (low, high) or float
        Where it is evaluated, in the ``separation_unit`` of the sweep.
    **inputs : distribution, (low, high) or float
        By the names of ``Scene.replace``, in SI units; or ``plasticity_index`` and
        ``roughness_parameter`` in the place of ``asperity_radius`` and ``asperity_density``
        (where one of the two is missing, it is that of the scene).

    A distribution is a frozen one of ``scipy.stats``, or anything with a ``ppf``; (low, high) is
    uniform. Inputs are independent of each other.

    Examples
    --------
    >>> import asperity, scipy.stats
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> asperity.Space(scene, separation=(1.0, 3.0), hardness=scipy.stats.norm(2e9, 1e8))
    <asperity.Space: separation=(1.0, 3.0), hardness=norm(2000000000.0, 100000000.0)>
    """

    def __init__(self, scene: Scene, separation: Input, **inputs: Input) -> None:
        if not isinstance(scene, Scene):
            raise TypeError(f"scene is {scene!r}: a Scene was required")
        #: What is not given by an input.
        self.scene = scene
        #: What was given, separation first.
        self.inputs: dict[str, Input] = {"separation": separation, **inputs}
        for name, given in self.inputs.items():
            _check(name, given)
            if name != "separation" and name not in ROUGHNESS:
                scene.vary(**{name: np.empty(0)})  # refuses names that there are not
        both = [name for name in ("asperity_radius", "asperity_density") if name in inputs]
        if both and any(name in inputs for name in ROUGHNESS):
            raise ValueError(
                f"{both[0]} is given beside {' or '.join(ROUGHNESS)}: the one follows from the "
                "others, leave it out"
            )
        if not self.names:
            raise ValueError("no input has a distribution: at least one was required")

    @property
    def names(self) -> tuple[str, ...]:
        """The inputs that vary, in order: one dimension of the samples each."""
        return tuple(name for name, given in self.inputs.items() if not _is_number(given))

    def columns(self, sample: Floats) -> dict[str, Floats]:
        """The inputs for points of the unit cube, one row each; those that vary, in order."""
        places = zip(self.names, sample.T, strict=True)
        return {name: _quantiles(name, self.inputs[name], u) for name, u in places}

    def all_columns(self, varying: dict[str, Floats]) -> dict[str, Floats]:
        """The same with those that do not vary."""
        size = len(next(iter(varying.values())))
        return {
            name: varying[name] if name in varying else np.full(size, float(given))  # type: ignore[arg-type]
            for name, given in self.inputs.items()
        }

    def scenes(self, columns: dict[str, Floats]) -> tuple[Scenes, tuple[Floats, Floats] | None]:
        """The scenes of columns; with their plasticity index and roughness parameter, if given."""
        plain = {
            name: values
            for name, values in columns.items()
            if name != "separation" and name not in ROUGHNESS
        }
        size = len(columns["separation"])
        if not plain:
            plain["nominal_area"] = np.full(size, self.scene.nominal_area)
        scenes = self.scene.vary(**plain)
        if not any(name in columns for name in ROUGHNESS):
            return scenes, None
        index = columns.get("plasticity_index")
        parameter = columns.get("roughness_parameter")
        if index is None:
            index = np.full(size, self.scene.plasticity_index)
        if parameter is None:
            parameter = np.full(size, self.scene.surface.roughness_parameter)
        return scenes, (index, parameter)

    def identity(self) -> dict[str, Any]:
        """What makes it this space and no other, for JSON."""
        scene = self.scene
        interface, surface = scene.interface, scene.surface
        heights: Any = scene.heights
        if not isinstance(heights, str):
            heights = [column.tolist() for column in heights]
        inputs: dict[str, Any] = {}
        for name, given in self.inputs.items():
            inputs[name] = {"is": _words(given)}
            if not _is_number(given):
                inputs[name]["quantiles"] = _quantiles(name, given, PROBES).tolist()
        return {
            "interface": list(interface.__getnewargs__()),
            "surface": list(surface.__getnewargs__()),
            "nominal_area": scene.nominal_area,
            "heights": heights,
            "separation_from": scene.separation_from,
            "options": scene.options,
            "inputs": inputs,
        }

    def __repr__(self) -> str:
        inputs = ", ".join(f"{name}={_words(given)}" for name, given in self.inputs.items())
        return f"<asperity.Space: {inputs}>"


def _is_number(given: Input) -> bool:
    return isinstance(given, int | float | np.number)


def _check(name: str, given: Input) -> None:
    if isinstance(given, tuple):
        if len(given) != 2 or not all(_is_number(end) and np.isfinite(end) for end in given):
            raise ValueError(f"{name} is {given!r}: (low, high), two finite numbers, was required")
        if not given[0] < given[1]:
            raise ValueError(f"{name} is {given!r}: low below high was required")
    elif not _is_number(given) and not isinstance(given, HasPpf | HasIcdf):
        raise TypeError(
            f"{name} is {given!r}: a distribution with a ppf, (low, high) or a number was required"
        )


def _quantiles(name: str, given: Input, u: Floats) -> Floats:
    if isinstance(given, tuple):
        low, high = given
        return np.asarray(low + (high - low) * u)
    found = given.ppf(u) if isinstance(given, HasPpf) else given.icdf(u)  # type: ignore[union-attr]
    values = np.ascontiguousarray(found, dtype=np.float64)
    if values.shape != u.shape:
        raise ValueError(
            f"{name} has quantiles of shape {values.shape} at {u.size} probabilities: one number "
            "for each was required"
        )
    return values


def _words(given: Any) -> str:
    frozen = getattr(given, "dist", None)
    if frozen is not None and hasattr(given, "args") and hasattr(given, "kwds"):
        arguments = [repr(float(argument)) for argument in given.args]
        arguments += [f"{name}={float(value)!r}" for name, value in given.kwds.items()]
        return f"{frozen.name}({', '.join(arguments)})"
    words = repr(given)
    return type(given).__name__ if " object at 0x" in words else words
