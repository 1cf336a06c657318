"""Numbers of a scene from measurements."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import Floats, floats, one_scene, record
from asperity._asperity import Scene
from asperity._model import Model, as_models
from asperity._table import Finding


@dataclass(frozen=True)
class Estimate:
    """A fitted parameter."""

    #: The value of the least squares.
    value: float
    #: Lower end of the 95 % interval; None if the data do not fix it within the bounds.
    lower: float | None
    #: Upper end of the 95 % interval.
    upper: float | None
    #: The SI unit; empty for pure numbers.
    unit: str
    #: The bounds within which it was varied.
    bounds: tuple[float, float]


@dataclass(frozen=True)
class Fit:
    """A model fitted to measurements."""

    #: The model's id.
    model: str
    #: Whether the search ended at a minimum.
    converged: bool
    #: Root mean square of ln(fitted/measured); None if no value has a logarithm.
    rms: float | None
    #: Sum of squares over the degrees of freedom, with standard deviations.
    reduced_chi_squared: float | None
    #: Bayesian information criterion: lower is better, on the same data.
    bic: float | None
    #: The free parameters by name.
    parameters: dict[str, Estimate]
    #: Correlation of the parameters, in their order; NaN for those that the data do not fix.
    correlation: Floats = field(repr=False)
    #: Condition number of the residuals' derivatives; None if a combination has no effect.
    condition: float | None
    #: Doubts about the fit, each with its parameter (``not-converged``, ``limits`` at a bound,
    #: ``undetermined``), and results outside the range of the model.
    findings: tuple[Finding, ...] = field(repr=False)
    #: Row and column of the data, and the measured value, the fitted one and the residual of each.
    residuals: tuple[dict[str, Any], ...] = field(repr=False)
    #: The scene with the fitted numbers.
    scene: Scene = field(repr=False)

    def __getitem__(self, name: str) -> float:
        """The value of a parameter."""
        return self.parameters[name].value


class Fits(tuple[Fit, ...]):
    """Models fitted to the same measurements.

    Models are ordered by BIC, lowest first, or by rms where one of them has no BIC; those whose law
    does not hold where data were measured come last.
    """

    @property
    def best(self) -> Fit:
        """The first model."""
        return self[0]


def fit(
    scene: Scene,
    data: str | os.PathLike[str] | Mapping[str, npt.ArrayLike],
    free: str | Sequence[str] | Mapping[str, tuple[float, float] | tuple[str, str] | None],
    model: str | Model | Sequence[str | Model] | None = None,
) -> Fits:
    """Numbers of a scene from measurements, with 95 % intervals, by one model or several.

    Parameters
    ----------
    scene : Scene
        The scene of the other numbers; its values are the start of the search.
    data : path, or mapping of columns
        A csv, or columns as of a DataFrame: ``load_N``, ``pressure_Pa`` or ``separation_m``, and any
        quantities by their columns (``area_m2``, ``unloading_stiffness_N_per_m``), each with
        ``<column>_std`` if known. Missing values are NaN. Without standard deviations the residuals
        are ln(fitted/measured). ``closure_m`` is the approach, above 0 where the surfaces are closer
        than at its zero, as that of the first reading; ``separation_offset`` is then free, too.
    free : str, sequence of str, or mapping of bounds
        The free parameters: names of ``Scene.replace``, ``separation_offset`` and
        ``series_compliance``; bounds are numbers or texts with a unit, by default a factor 30 either
        way.
    model : str, Model or a sequence of these, optional
        By default ke, or gw without a hardness.

    A ``ContactWarning`` names parameters at a bound, parameters that the data do not determine,
    searches that did not converge, and results outside the range of a model. A fit that misses the
    data has a large ``rms``.

    >>> import asperity
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> ultrasonic = {"pressure_Pa": [1e5, 1e6, 1e7], "unloading_stiffness_N_per_m": [1.3e8, 1.2e9, 1.1e10]}
    >>> found = asperity.fit(scene, ultrasonic, {"asperity_height_std": ("0.1 um", "10 um")})
    >>> found.best.converged
    True

    One value and one parameter answer the inverse question:

    >>> wanted = {"pressure_Pa": 5e6, "area_fraction": 0.004}
    >>> smooth = asperity.fit(scene, wanted, "asperity_height_std").best.scene
    >>> curve = asperity.model("ke").solve(smooth, pressure=5e6, quantities="area_fraction")
    >>> round(float(curve.area_fraction), 9)
    0.004
    """
    scene = one_scene(scene, "fit")
    engines = as_models(scene._usual_reference() if model is None else model)
    if not engines:
        raise ValueError("model is empty: at least one model was required")
    found = _asperity.fit(scene, _columns(data), _free(free), engines)
    return Fits(_fit(one, scene) for one in found)


def _columns(data: Any) -> str | list[tuple[str, list[float | None]]]:
    if isinstance(data, str | os.PathLike):
        return os.fspath(data)
    columns = []
    for name in data:
        values = np.atleast_1d(np.asarray(floats(data[name], str(name))))
        if values.ndim > 1:
            raise ValueError(f"{name} has {values.ndim} dimensions: a column was required")
        columns.append((str(name), [None if np.isnan(one) else float(one) for one in values]))
    return columns


def _free(free: Any) -> list[str]:
    if isinstance(free, Mapping):
        return [_bounded(name, bounds) for name, bounds in free.items()]
    return [free] if isinstance(free, str) else list(free)


def _bounded(name: str, bounds: Any) -> str:
    """A free parameter as the library reads it."""
    if bounds is None:
        return name
    try:
        low, high = bounds
    except (TypeError, ValueError):
        raise ValueError(f"{name} is {bounds!r}: (low, high) or None was required") from None
    low, high = (one if isinstance(one, str) else repr(float(one)) for one in (low, high))
    return f"{name}={low}:{high}"


def _fit(found: dict[str, Any], scene: Scene) -> Fit:
    parameters = {one["name"]: record(Estimate, one) for one in found["parameters"]}
    rig = ("separation_offset", "series_compliance")
    numbers = {name: one.value for name, one in parameters.items() if name not in rig}
    correlation = np.array(found["correlation"], dtype=np.float64)
    made = {"correlation": correlation, "parameters": parameters, "scene": scene.replace(**numbers)}
    made["findings"] = [record(Finding, one) for one in found["findings"]]
    return record(Fit, found | made)
