"""Sweeps: models on many scenes, as a dataset of xarray."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import Floats, Rows, checked_errors, floats, one_scene, place, unit_in
from asperity._asperity import Scene
from asperity._model import Model, as_models
from asperity._warn import warn

if TYPE_CHECKING:
    import xarray as xr

#: The meanings of places, with the unit of a load or pressure.
PLACES = {"separation": None, "load": "N", "pressure": "Pa", "approach": "m"}
#: The states of a row.
STATES = {"value": 1, "refused": 2}


def sample(points: npt.ArrayLike, **inputs: Any) -> dict[str, xr.DataArray]:
    """Inputs drawn from distributions, one row for each point of the unit cube; needs the extra
    ``asperity[sweep]``.

    ``points`` have a column for each input, as those of an engine of ``scipy.stats.qmc`` (Sobol
    points, Latin hypercubes). ``inputs`` are in SI units, by the names of ``Scene.replace``, or
    separation, load or pressure: frozen distributions of ``scipy.stats``, or anything with a ``ppf``,
    or (low, high) for a uniform one. Inputs are independent of each other.

    >>> import asperity
    >>> from scipy.stats import norm, qmc
    >>> points = qmc.Sobol(2, rng=1).random(4)
    >>> drawn = asperity.sample(points, separation=(1.0, 3.0), hardness=norm(2e9, 1e8))
    >>> drawn["separation"].values.round(2)
    array([1.57, 2.16, 2.68, 1.09])
    """
    import xarray as xr

    cube = floats(points, "points")
    if cube.ndim != 2 or cube.shape[1] != len(inputs):
        raise ValueError(f"points have the shape {cube.shape}: {len(inputs)} columns were required")
    # 0 and 1 have no finite quantile.
    cube = np.clip(cube, 2.0**-31, 1.0 - 2.0**-53)
    columns = zip(inputs.items(), cube.T, strict=True)
    drawn = {name: _quantiles(name, given, u) for (name, given), u in columns}
    return {name: xr.DataArray(column, dims="row") for name, column in drawn.items()}


def _quantiles(name: str, given: Any, u: Floats) -> Floats:
    if isinstance(given, tuple):
        low, high = map(float, given)
        if not -np.inf < low < high < np.inf:
            raise ValueError(f"{name} is {given!r}: (low, high), two finite numbers, was required")
        return low + (high - low) * u
    if not hasattr(given, "ppf"):
        raise TypeError(f"{name} is {given!r}: a distribution with a ppf or (low, high) was required")
    return floats(given.ppf(u), name)


def sweep(
    scene: Scene,
    inputs: Mapping[str, Any],
    model: str | Model | Sequence[str | Model],
    quantities: str | Sequence[str] = ("force",),
    rtol: float = 1e-10,
    separation_unit: str = "asperity_height_std",
    *,
    errors: str = "raise",
) -> xr.Dataset:
    """Quantities of models on many scenes; needs the extra ``asperity[sweep]``.

    Parameters
    ----------
    scene : Scene
        The scene of the other numbers.
    inputs : mapping
        Numbers by the names of ``Scene.replace``, and one of separation, load and pressure: a number,
        a sequence, which has a dimension of its own, or a ``DataArray``; all are broadcast by their
        dimensions. ``sample`` makes inputs that share the dimension "row". Texts with a unit, as
        "2 GPa", are converted to SI units.
    model : str, Model or a sequence of these
        Several models have the dimension "model".
    quantities, rtol, separation_unit
        As in ``Model.solve``.
    errors : "raise" or "mask"
        The treatment of a refused row, as with a negative hardness: it raises with its reason; or
        its values are NaN, and its ``status`` is 2.

    The result has the quantities with their units, by names with underscores, and ``status``: 1 for
    values, 2 for refused rows. The inputs are coordinates.

    >>> import asperity
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> inputs = {"load": [10.0, 100.0], "hardness": ["1 GPa", "2 GPa", "3 GPa"]}
    >>> result = asperity.sweep(scene, inputs, ["ke", "jg"], ["area", "tangent"])
    >>> dict(result.sizes), result.area.units
    ({'model': 2, 'load': 2, 'hardness': 3}, 'm2')
    """
    import xarray as xr

    axis, arrays = _arrays(scene, inputs, separation_unit)
    engines, heads = as_models(model), _asperity.quantities(quantities)
    whole = xr.broadcast(*arrays.values())
    dims, shape = whole[0].dims, whole[0].shape
    columns = {name: one.values.ravel() for name, one in zip(arrays, whole, strict=True)}
    where = columns.pop("separation" if axis not in PLACES else axis)
    rows = Rows(scene.vary(**columns), axis, where)
    told: dict[str, None] = {}
    checked_errors(errors)
    found = [_answer(rows, engine, list(heads), rtol, errors, told) for engine in engines]
    for message in told:
        warn(message, 1)
    coordinates: dict[str, Any] = {
        name: array.assign_attrs(units=_unit(name, axis)) for name, array in arrays.items()
    }
    if not isinstance(model, str | Model):
        dims, shape = ("model", *dims), (len(engines), *shape)
        coordinates["model"] = np.array([engine.id for engine in engines], dtype=object)
    about: dict[str, dict[str, Any]] = {
        q.replace("-", "_"): {"units": unit_in(head, q)} for q, head in heads.items()
    }
    about["status"] = {"flag_values": list(STATES.values()), "flag_meanings": " ".join(STATES)}
    values = {
        name: (dims, np.stack([of[name] for of in found]).reshape(shape), attributes)
        for name, attributes in about.items()
    }
    return xr.Dataset(values, coordinates)


def _unit(name: str, axis: str) -> str:
    """The unit of an input."""
    if name == "separation":
        return axis
    return PLACES[name] or "" if name in PLACES else unit_in(_asperity.column_of(name), name)


def _arrays(
    scene: Scene, inputs: Mapping[str, Any], separation_unit: str
) -> tuple[str, dict[str, xr.DataArray]]:
    """The meaning of the places, and the inputs with their dimensions."""
    import xarray as xr

    one_scene(scene, "sweep")
    known = {name: one for name, one in inputs.items() if one is not None}
    axis, numbers = place(separation_unit, **{name: known.get(name) for name in PLACES})
    others = scene._inputs_in_si({name: known[name] for name in known if name not in PLACES})
    found = {}
    for name in known:
        array = numbers if name in PLACES else others[name]
        if not isinstance(array, xr.DataArray):
            column = floats(array, name)
            if column.ndim > 1:
                raise ValueError(f"{name} has {column.ndim} dimensions: a DataArray was required")
            dims = (name,) if column.ndim else ()
            array = xr.DataArray(column, {name: column} if dims else None, dims)
        found[name] = array.astype(np.float64)
    return axis, found


def _answer(
    rows: Rows,
    engine: Model,
    quantities: list[str],
    rtol: float,
    errors: str,
    told: dict[str, None],
) -> dict[str, Floats | npt.NDArray[np.int8]]:
    """The quantities and states of rows by a model; messages are added to those told."""
    _, found, failures, messages = rows.answer(engine, quantities, rtol, "value", errors)
    told |= dict.fromkeys(messages)
    states = np.full(rows.shape, STATES["value"], np.int8)
    states[list(failures)] = STATES["refused"]
    values = {q.replace("-", "_"): np.ma.filled(column, np.nan) for q, column in found.items()}
    return values | {"status": states}
