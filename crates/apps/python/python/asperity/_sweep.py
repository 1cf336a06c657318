"""Sweeps: models on many scenes, as a dataset of xarray, in memory or in a Zarr store."""

from __future__ import annotations

import hashlib
import inspect
import json
import os
from collections.abc import Iterator, Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._arguments import Floats, Rows, checked_errors, floats, one_scene, place, placed
from asperity._arguments import unit_in
from asperity._asperity import Scene
from asperity._model import Model, as_models
from asperity._warn import warn

if TYPE_CHECKING:
    import xarray as xr

#: The meanings of places, with the unit of a load or pressure.
PLACES = {"separation": None, "load": "N", "pressure": "Pa", "approach": "m"}
#: What was asked, as an attribute of the result, and the states of a row.
ASKED = "asperity_sweep"
STATES = {"missing": 0, "value": 1, "refused": 2}


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
    store: str | os.PathLike[str] | None = None,
    part_size: int = 2**17,
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
    store : path, optional
        A Zarr store, which is written part by part. Called again with the same arguments, an
        interrupted sweep computes the missing parts; the store of another sweep is an error. Only
        one run may use a store at a time.
    part_size : int
        Most rows that are computed at once, on all cores; no digit depends on it.

    The result has the quantities with their units, by names with underscores, and ``status``: 1 for
    values, 2 for refused rows. The inputs are coordinates. With a store, its arrays are those of
    Dask, which are read on request.

    >>> import asperity
    >>> scene = asperity.Scene.parse(asperity.template())
    >>> inputs = {"load": [10.0, 100.0], "hardness": ["1 GPa", "2 GPa", "3 GPa"]}
    >>> result = asperity.sweep(scene, inputs, ["ke", "jg"], ["area", "tangent"])
    >>> dict(result.sizes), result.area.units
    ({'model': 2, 'load': 2, 'hardness': 3}, 'm2')
    """
    import xarray as xr

    scene._warn_of_ranges()
    axis, arrays = _arrays(scene, inputs, separation_unit)
    engines, heads = as_models(model), _asperity.quantities(quantities)
    whole = xr.broadcast(*arrays.values())
    sizes = {str(name): int(size) for name, size in whole[0].sizes.items()}
    coordinates = {name: array.assign_attrs(units=_unit(name, axis)) for name, array in arrays.items()}
    names: dict[str, Any] = {}
    if not isinstance(model, str | Model):
        names = {"model": np.array([engine.id for engine in engines], dtype=object)}
        sizes = {"model": len(engines), **sizes}
    if not sizes:
        raise ValueError("no input varies: an array or several models were required")
    asked = json.dumps(_identity(scene, engines, heads, rtol, axis, checked_errors(errors)))
    parts = list(_parts(sizes, part_size))
    shape = tuple(sizes.values())

    def blank(value: float, dtype: Any) -> Any:
        if store is None:
            return np.full(shape, value, dtype)
        import dask.array

        # Chunks of the store are the parts.
        chunks = tuple(places.stop - places.start for places in parts[0].values())
        return dask.array.full(shape, value, dtype=dtype, chunks=chunks)

    values: dict[str, Any] = {
        q.replace("-", "_"): (tuple(sizes), blank(np.nan, np.float64), {"units": unit_in(head, q)})
        for q, head in heads.items()
    }
    flags = {"flag_values": list(STATES.values()), "flag_meanings": " ".join(STATES)}
    values["status"] = (tuple(sizes), blank(0, np.int8), flags)
    result = xr.Dataset(values, {**names, **coordinates}, {ASKED: asked})
    path = None if store is None else Path(store).absolute()
    group = None if path is None else _opened(path, result)
    told: dict[str, None] = {}
    for region in parts:
        places = tuple(region.values())
        if group is not None and group["status"][places].all():
            continue
        of_inputs = {name: place for name, place in region.items() if name != "model"}
        columns = {
            name: array.isel(of_inputs).values.ravel()
            for name, array in zip(arrays, whole, strict=True)
        }
        engine = engines[region["model"].start if "model" in region else 0]
        try:
            found = _answer(scene, engine, axis, columns, heads, rtol, errors, told)
        except Exception as error:
            where = ", ".join(f"{name} from {place.start}" for name, place in of_inputs.items())
            raise placed(f"{where}: ", error) from None
        # The states are the last: a part counts once they are written.
        for name, column in found.items():
            of_part = column.reshape([place.stop - place.start for place in places])
            (result[name].values if group is None else group[name])[places] = of_part
    for message in told:
        warn(message, 1)
    return result if path is None else xr.open_zarr(path, consolidated=False)


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


def _identity(
    scene: Scene, engines: list[Model], heads: dict[str, str], rtol: float, axis: str, errors: str
) -> dict[str, Any]:
    """What the values depend on beside the inputs, for JSON."""
    models = []
    for engine in engines:
        definition = engine._definition
        if not isinstance(definition, str):
            try:
                definition = inspect.getsource(definition)
            except (OSError, TypeError):
                definition = repr(definition)
        models.append([engine.id, repr(engine.options), definition])
    return {
        "asperity": version("asperity"),
        "scene": hashlib.sha256(scene._identity().encode()).hexdigest(),
        "models": models,
        "quantities": list(heads),
        "rtol": rtol,
        "axis": axis,
        "errors": errors,
    }


def _parts(sizes: dict[str, int], part_size: int) -> Iterator[dict[str, slice]]:
    """The regions of the parts: each of one model, cut along the longest dimension of the inputs."""
    if part_size < 1:
        raise ValueError(f"part_size is {part_size}: an integer from 1 was required")
    inputs = {name: size for name, size in sizes.items() if name != "model"}
    longest = max(inputs, key=inputs.__getitem__, default="")
    rows = int(np.prod(list(inputs.values())))
    step = max(1, part_size * inputs.get(longest, 1) // max(rows, 1))
    for model in range(sizes.get("model", 1)):
        for first in range(0, inputs.get(longest, 1), step):
            region = {name: slice(0, size) for name, size in sizes.items()}
            if "model" in sizes:
                region["model"] = slice(model, model + 1)
            if longest:
                region[longest] = slice(first, min(first + step, inputs[longest]))
            yield region


def _opened(path: Path, plan: xr.Dataset) -> Any:
    """The store of a sweep, which is made from its plan if it is new; ValueError for another's."""
    import xarray as xr
    import zarr

    if not path.exists():
        temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
        plan.to_zarr(temporary, mode="w", compute=False, consolidated=False)
        temporary.replace(path)
    known = xr.open_zarr(path, consolidated=False)
    if ASKED not in known.attrs:
        raise ValueError(f"{path} is no store of a sweep: another path was required")
    there, here = json.loads(known.attrs[ASKED]), json.loads(plan.attrs[ASKED])
    for name in there.keys() | here.keys():
        if there.get(name) != here.get(name):
            raise ValueError(
                f"{path} holds another sweep: {name} is {there.get(name)!r} there and "
                f"{here.get(name)!r} here; use another store"
            )
    if not known.coords.to_dataset().equals(plan.coords.to_dataset()):
        raise ValueError(f"{path} holds another sweep, with other inputs; use another store")
    return zarr.open_group(path, mode="r+")


def _answer(
    scene: Scene,
    engine: Model,
    axis: str,
    columns: dict[str, Floats],
    heads: dict[str, str],
    rtol: float,
    errors: str,
    told: dict[str, None],
) -> dict[str, Floats | npt.NDArray[np.int8]]:
    """The quantities and states of rows; messages are added to those told."""
    where = columns.pop("separation" if axis not in PLACES else axis)
    if not columns:
        # A single scene is integrated otherwise, with digits that depend on the other rows.
        name, value = next(iter((scene.curvature or {"nominal_area": scene.nominal_area}).items()))
        columns = {name: np.full(where.shape, value)}
    rows = Rows(scene.vary(**columns), axis, where)
    _, found, failures, messages = rows.answer(engine, list(heads), rtol, "value", errors)
    told |= dict.fromkeys(messages)
    states = np.full(where.shape, STATES["value"], np.int8)
    states[list(failures)] = STATES["refused"]
    values = {q.replace("-", "_"): np.ma.filled(column, np.nan) for q, column in found.items()}
    return values | {"status": states}
