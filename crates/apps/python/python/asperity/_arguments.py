"""Arguments and scenes broadcast by NumPy's rules, and answers in their shape."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields
from typing import Any, Literal, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._asperity import Engine, NotConverged, Scene

Floats: TypeAlias = npt.NDArray[np.float64]
Method = TypeVar("Method", bound=Callable[..., Any])
Options: TypeAlias = Mapping[str, str | float | Mapping[str, float]]


def method_of(kind: type) -> Callable[[Method], Method]:
    """Gives a compiled class a method that is written in Python."""

    def add(method: Method) -> Method:
        setattr(kind, method.__name__, method)
        return method

    return add


def in_si(numbers: Any, si: str, key: str = "") -> Any:
    """Texts with a unit, "100 nm" or a sequence of them, in an SI unit; numbers as they are. With
    the key of a hardness, texts may be test results, "200 HV"."""

    def one(given: Any) -> float:
        if isinstance(given, str):
            return _asperity.quantity(given, si, key)
        raise TypeError(f"{given!r} has no unit: give every value a unit, or no value")

    if isinstance(numbers, str):
        return one(numbers)
    texts = isinstance(numbers, list | tuple) and any(isinstance(given, str) for given in numbers)
    return tuple(map(one, numbers)) if texts else numbers


def floats(values: npt.ArrayLike, name: str) -> Floats:
    """A contiguous array of doubles. Masked arrays, whose masks would be lost, and complex numbers,
    booleans and texts are refused."""
    if np.ma.isMaskedArray(values):
        raise ValueError(
            f"{name} is a masked array: an array without a mask was required; use its filled() or "
            "compressed()"
        )
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} has values of type {array.dtype}: real numbers were required")
    # ascontiguousarray returns one dimension for a scalar.
    return np.ascontiguousarray(array, np.float64).reshape(array.shape)


class Scenes:
    """Many scenes that differ from one in some of its numbers; made by ``Scene.vary``.

    They may replace a scene, and are broadcast against separations and loads.

    Examples
    --------
    >>> import asperity
    >>> interface = asperity.Interface(116e9, 0.31, hardness=1.12e9)
    >>> scene = asperity.Scene(interface, asperity.Surface(3.6e-4, 1.1e8, 1e-6), nominal_area=3e-5)
    >>> scenes = scene.vary(asperity_height_std=[1e-6, 2e-6, 3e-6])
    >>> scenes
    <asperity.Scenes of shape (3,), asperity_height_std varies>
    >>> asperity.model("gw").solve(scenes, separation=1.0).force.shape
    (3,)
    """

    def __init__(self, base: Scene, columns: Mapping[str, npt.ArrayLike]) -> None:
        given = base._inputs_in_si(dict(columns))
        arrays = np.broadcast_arrays(*(floats(values, name) for name, values in given.items()))
        self._base = base
        self._columns = {
            name: floats(values, name) for name, values in zip(columns, arrays, strict=True)
        }
        #: Shape of the columns, broadcast.
        self.shape: tuple[int, ...] = arrays[0].shape if arrays else ()

    def reshape(self, *shape: int) -> Scenes:
        """The same scenes in another shape; -1 stands for the remaining length."""
        columns = {name: values.reshape(shape) for name, values in self._columns.items()}
        return Scenes(self._base, columns)

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("len() of one scene")
        return self.shape[0]

    def __getitem__(self, index: int | tuple[int, ...]) -> Scene:
        numbers = {name: values[index] for name, values in self._columns.items()}
        if any(np.ndim(number) for number in numbers.values()):
            raise IndexError("one index for each axis was required: slices of scenes are not supported")
        return self._base.replace(**numbers)

    def __repr__(self) -> str:
        names = ", ".join(self._columns) or "nothing"
        verb = "vary" if len(self._columns) > 1 else "varies"
        return f"<asperity.Scenes of shape {self.shape}, {names} {verb}>"


@method_of(Scene)
def vary(self: Scene, **columns: npt.ArrayLike) -> Scenes:
    """Many scenes that differ in some numbers: the names of ``replace`` with arrays, which are
    broadcast."""
    return Scenes(self, columns)


#: One scene, or many in any shape.
SceneLike: TypeAlias = Scene | Scenes | Sequence[Scene] | Sequence[Sequence[Any]] | npt.NDArray[Any]
Aspect: TypeAlias = Literal["value", "ln", "error"]
Record = TypeVar("Record")
Failures: TypeAlias = list[tuple[int, BaseException]]

#: Meanings of numbers, with their column heads, names and units.
AXES = {
    "asperity_height_std": ("separation", "separation", "asperity_height_std"),
    "m": ("separation_m", "separation", "m"),
    "approach": ("approach_m", "approach", "m"),
    "load": ("load_N", "load", "N"),
    "pressure": ("pressure_Pa", "pressure", "Pa"),
    "film": ("film_m", "film", "m"),
    "lambda_ratio": ("lambda", "film", "surface_height_std"),
}
LOADS = ("load", "pressure")
ERRORS = ("raise", "mask")


def unit_in(head: str, name: str) -> str:
    """The unit in the head of a column, "N/m" in "tangent_N_per_m"; empty for pure numbers."""
    return head[len(name) :].strip("_").replace("_per_", "/")


def checked_unit(separation_unit: str) -> str:
    """The unit of separations; ValueError if it is none."""
    if separation_unit not in ("asperity_height_std", "m"):
        raise ValueError(
            f"separation_unit is {separation_unit!r}: 'asperity_height_std' or 'm' was required"
        )
    return separation_unit


def place(separation_unit: str = "m", **given: Any) -> tuple[str, Any]:
    """The meaning of the one that is given, and its numbers; TypeError unless it is one."""
    unit = checked_unit(separation_unit)
    found = {name: numbers for name, numbers in given.items() if numbers is not None}
    if len(found) != 1:
        *names, last = given
        raise TypeError(f"exactly one of {', '.join(names)} and {last} was required")
    ((name, numbers),) = found.items()
    si = in_si(numbers, {"load": "N", "pressure": "Pa"}.get(name, "m"))
    if name in ("separation", "closest"):
        # Texts have a unit of their own.
        name = unit if si is numbers else "m"
    return name, si


def one_number(name: str, given: Any) -> float:
    """One number; TypeError for an array or a text, with the name of the argument."""
    if np.ndim(given) == 0 and not isinstance(given, str):
        try:
            return float(given)
        except (TypeError, ValueError):
            pass
    raise TypeError(f"{name} is {_short(given)}: one number was required")


def two_numbers(name: str, given: Any) -> tuple[float, float]:
    """The two numbers of a range; TypeError for others."""
    if np.shape(given) != (2,):
        raise TypeError(f"{name} is {_short(given)}: two numbers, (first, last), were required")
    first, last = given
    return one_number(name, first), one_number(name, last)


def one_scene(scene: Any, use: str) -> Scene:
    """One scene; TypeError for many scenes, or for another object."""
    if isinstance(scene, Scene):
        return scene
    if isinstance(scene, Scenes | list | tuple | np.ndarray):
        advice = "scene.replace(...) gives one scene with other numbers, scenes[k] one of many"
        raise TypeError(f"{use} takes one scene, not many: {advice}")
    raise TypeError(f"scene is {_short(scene)}: a Scene was required")


def _short(given: Any) -> str:
    """The text of an object; its type, if the text is long."""
    text = repr(given)
    if len(text) <= 60 and "\n" not in text:
        return text
    shape = np.shape(given) if isinstance(given, np.ndarray | list | tuple) else ()
    return f"a {type(given).__name__}" + (f" of shape {shape}" if shape else "")


def record(kind: type[Record], found: Mapping[str, Any]) -> Record:
    """The fields of a dataclass from a dict that has more, with tuples in the place of lists."""
    given = {one.name: found[one.name] for one in fields(kind)}  # type: ignore[arg-type]
    return kind(**{name: tuple(v) if isinstance(v, list) else v for name, v in given.items()})


def checked_errors(errors: str) -> str:
    """The treatment of rows that fail: "raise" or "mask"."""
    if errors not in ERRORS:
        raise ValueError(f"errors is {errors!r}: 'raise' or 'mask' was required")
    return errors


def placed(where: str, error: BaseException) -> BaseException:
    """A refusal with its place in the message; an exception of the user's code unchanged."""
    if type(error) in (ValueError, NotConverged):
        return type(error)(f"{where}{error}")
    return error


def reason(error: BaseException) -> str:
    """The message of a refusal; for an exception of the user's code, its type and message."""
    if isinstance(error, ValueError | NotConverged):
        return str(error)
    return f"{type(error).__name__}: {error}"


class Rows:
    """Scenes and numbers, broadcast: row after row in the order of memory.

    Rows whose number is masked are left out.
    """

    def __init__(self, scenes: SceneLike, axis: str, numbers: npt.ArrayLike) -> None:
        #: The meaning of the numbers.
        self.axis = axis
        name = axis if axis in (*LOADS, "approach") else "separation"
        #: The numbers in their shape.
        self.given: Floats = floats(np.ma.getdata(numbers), name)
        #: The scenes as given.
        self.scenes = scenes
        #: The numbers that vary between the scenes, by name.
        self.columns: dict[str, Floats] = {}
        if isinstance(scenes, Scenes):
            many, self.files = scenes.shape, [scenes._base]
            self.columns = {name: values.ravel() for name, values in scenes._columns.items()}
        else:
            array = np.asarray(scenes, dtype=object)
            many, self.files = array.shape, list(array.ravel())
            for k, scene in enumerate(self.files):
                if not isinstance(scene, Scene):
                    raise TypeError(f"scene {k} is {scene!r}: a Scene was required")
        try:
            #: Shape of every answer.
            self.shape: tuple[int, ...] = np.broadcast_shapes(many, self.given.shape)
        except ValueError:
            raise ValueError(
                f"scenes have the shape {many} and {name} {self.given.shape}: shapes that broadcast "
                "were required, for example scenes.reshape(-1, 1)"
            ) from None
        #: The index of each scene, in the shape of the scenes.
        self.places = np.arange(math.prod(many), dtype=np.int64).reshape(many)
        mask = np.ma.getmask(numbers)
        self._kept = None if mask is np.ma.nomask else ~np.broadcast_to(mask, self.shape).ravel()

    @property
    def is_one(self) -> bool:
        """Whether there is a single scene."""
        return isinstance(self.scenes, Scene)

    @property
    def is_curved(self) -> bool:
        """Whether the bodies of the scenes are curved."""
        return any(file.curvature is not None for file in self.files)

    @property
    def index(self) -> npt.NDArray[np.int64]:
        """The index of each row's scene; empty for a single scene."""
        return self.places.ravel()[:0] if self.is_one else self._flat(self.places)

    @property
    def numbers(self) -> Floats:
        """The number of each row."""
        return self._flat(self.given)

    def _flat(self, values: npt.NDArray[Any]) -> npt.NDArray[Any]:
        flat = np.ascontiguousarray(np.broadcast_to(values, self.shape)).ravel()
        return flat if self._kept is None else flat[self._kept]

    def without(self, missing: npt.NDArray[np.bool_]) -> Rows:
        """The rows without those that are missing in an answer of their shape."""
        given = np.broadcast_to(self.given, self.shape)
        return Rows(self.scenes, self.axis, np.ma.MaskedArray(given, missing))

    def shaped(self, values: npt.NDArray[Any], missing: npt.NDArray[np.bool_] | None = None) -> Any:
        """Values of the rows in their shape; masked for rows that are masked or missing, by default
        NaN."""
        missing = np.isnan(values) if missing is None else missing
        if self._kept is None and not missing.any():
            return values.reshape(self.shape)
        kept = slice(None) if self._kept is None else self._kept
        whole = np.full(math.prod(self.shape), np.nan, values.dtype)
        hidden = np.ones(whole.size, dtype=bool)
        whole[kept], hidden[kept] = values, missing
        return np.ma.MaskedArray(whole, hidden).reshape(self.shape)

    def failed(self, failures: Failures, errors: str) -> dict[int, str]:
        """The reasons of failed rows by place in the order of memory; raises the first with "raise"."""
        for row, error in failures:
            if errors == "raise" or not isinstance(error, Exception):
                where = "" if self.is_one else f"scene {self.index[row]}: "
                raise placed(where, error)
        places = range(len(self.numbers)) if self._kept is None else np.flatnonzero(self._kept)
        return {int(places[row]): reason(error) for row, error in failures}

    def answer(
        self,
        engine: Engine,
        quantities: str | Iterable[str],
        rtol: float,
        aspect: Aspect,
        errors: str,
        checked: bool = False,
    ) -> tuple[str, dict[str, Floats], dict[int, str], list[str]]:
        """The model's name on these scenes, quantities of the rows in their shape, the reasons of
        failures, and the texts of findings, with ``checked`` also those of the scenes."""
        asked, stop = (engine, self, quantities, rtol), errors == "raise"
        name, columns, failures, findings = _asperity.answer(asked, aspect, stop, checked)
        reasons = self.failed(failures, errors)
        return name, {q: self.shaped(v) for q, v in columns.items()}, reasons, findings

    def separations(
        self, engine: Engine, unit: str, rtol: float, errors: str, all: bool = False
    ) -> Any:
        """The separations of the loads in their shape: the largest of each, or arrays of all."""
        asked = engine, self, "force", rtol
        found, failures = _asperity.separations(asked, unit, all, errors == "raise")
        self.failed(failures, errors)
        values = np.fromiter(found, object if all else float, len(found))
        missing = np.isin(np.arange(len(found)), [row for row, _ in failures])
        return self.shaped(values, missing)
