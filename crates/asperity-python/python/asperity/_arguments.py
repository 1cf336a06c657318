"""Arguments broadcast by NumPy's rules, and answers in their shape."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from asperity import _asperity
from asperity._asperity import Engine, NotConverged, Scene, floats, in_si
from asperity._scene import Floats, Scenes

#: One scene, or many in any shape.
SceneLike: TypeAlias = Scene | Scenes | Sequence[Scene] | Sequence[Sequence[Any]] | npt.NDArray[Any]
Aspect: TypeAlias = Literal["value", "ln", "error"]
Failures: TypeAlias = list[tuple[int, BaseException]]

#: Meanings of numbers, with their column heads.
AXES = {
    "asperity_height_std": "separation",
    "m": "separation_m",
    "load": "load_N",
    "pressure": "pressure_Pa",
}
LOADS = ("load", "pressure")
ERRORS = ("raise", "mask")


def quantity_names(quantities: str | Iterable[str]) -> list[str]:
    """The names of quantities, each once, as the library spells them."""
    given = [quantities] if isinstance(quantities, str) else list(quantities)
    if not given:
        names = ", ".join(_asperity.quantities())
        raise ValueError(f"quantities is empty: one or more of {names} were required")
    return list(_asperity.quantities(given))


def checked_unit(separation_unit: str) -> str:
    """The unit of separations; ValueError if it is none."""
    if separation_unit not in ("asperity_height_std", "m"):
        raise ValueError(
            f"separation_unit is {separation_unit!r}: 'asperity_height_std' or 'm' was required"
        )
    return separation_unit


def place(
    separation: Any, load: Any, pressure: Any, separation_unit: str, name: str = "separation"
) -> tuple[str, Any]:
    """The meaning of the given numbers, and the numbers; TypeError unless one of the three is given."""
    unit = checked_unit(separation_unit)
    in_metres = in_si(separation, "m")
    if in_metres is not separation:
        separation, unit = in_metres, "m"
    given = {unit: separation, "load": in_si(load, "N"), "pressure": in_si(pressure, "Pa")}
    found = [(axis, numbers) for axis, numbers in given.items() if numbers is not None]
    if len(found) != 1:
        raise TypeError(f"exactly one of {name}, load and pressure was required")
    return found[0]


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
        name = axis if axis in LOADS else "separation"
        #: The numbers in their shape.
        self.given: Floats = floats(np.ma.getdata(numbers), name)
        #: The scenes as given.
        self.scenes = scenes
        if isinstance(scenes, Scene | Scenes):
            self._scenes_shape = getattr(scenes, "shape", ())
        else:
            array = np.asarray(scenes, dtype=object)
            self._scenes_shape = array.shape
            for k, scene in enumerate(array.ravel()):
                if not isinstance(scene, Scene):
                    raise TypeError(f"scene {k} is {scene!r}: a Scene was required")
        #: Shape of every answer.
        self.shape: tuple[int, ...] = self._broadcast(name)
        self._kept: npt.NDArray[np.bool_] | None = None
        if np.ma.isMaskedArray(numbers):
            self._kept = ~np.broadcast_to(np.ma.getmaskarray(numbers), self.shape).ravel()

    def _broadcast(self, name: str) -> tuple[int, ...]:
        scenes, numbers = self._scenes_shape, self.given.shape
        try:
            return np.broadcast_shapes(scenes, numbers)
        except ValueError:
            raise ValueError(
                f"scenes have the shape {scenes} and {name} {numbers}: shapes that broadcast were "
                "required, for example scenes.reshape(-1, 1)"
            ) from None

    @property
    def one(self) -> Scene | None:
        """The single scene; None if there are several."""
        return self.scenes if isinstance(self.scenes, Scene) else None

    @property
    def files(self) -> list[Scene]:
        """The scenes for the engine; the base scene if columns vary it."""
        if isinstance(self.scenes, Scenes):
            return [self.scenes._base]
        return list(np.asarray(self.scenes, dtype=object).ravel())

    @property
    def columns(self) -> dict[str, Floats]:
        """The numbers that vary between the scenes, by name."""
        columns = self.scenes._columns if isinstance(self.scenes, Scenes) else {}
        return {name: values.ravel() for name, values in columns.items()}

    @property
    def places(self) -> npt.NDArray[np.int64]:
        """The indices of the scenes, in their shape."""
        count = math.prod(self._scenes_shape)
        return np.arange(count, dtype=np.int64).reshape(self._scenes_shape)

    @property
    def index(self) -> npt.NDArray[np.int64]:
        """The index of each row's scene."""
        return self._rows(self.places)

    @property
    def numbers(self) -> Floats:
        """The number of each row."""
        return self._rows(self.given)

    def _rows(self, values: npt.NDArray[Any]) -> npt.NDArray[Any]:
        flat = np.ascontiguousarray(np.broadcast_to(values, self.shape)).ravel()
        return flat if self._kept is None else flat[self._kept]

    def without(self, missing: npt.NDArray[np.bool_]) -> Rows:
        """The rows without those that are missing in an answer of their shape."""
        rows = Rows(self.scenes, self.axis, self.given)
        rows._kept = ~missing.ravel()
        return rows

    def shaped(self, values: npt.NDArray[Any], missing: npt.NDArray[np.bool_]) -> Any:
        """Values of the rows in their shape; masked for rows that are masked or missing."""
        if self._kept is not None:
            whole, hidden = np.full(self._kept.shape, np.nan, values.dtype), ~self._kept
            whole[self._kept], hidden[self._kept] = values, missing
            values, missing = whole, hidden
        elif not missing.any():
            return values.reshape(self.shape)
        return np.ma.MaskedArray(values, missing).reshape(self.shape)

    def failed(self, failures: Failures, errors: str) -> dict[int, str]:
        """The reasons of failed rows by place in the order of memory; raises the first with "raise"."""
        for row, error in failures:
            if errors == "raise" or not isinstance(error, Exception):
                where = "" if self.one is not None else f"scene {self.index[row]}: "
                raise placed(where, error)
        places = range(len(self.numbers)) if self._kept is None else np.flatnonzero(self._kept)
        return {int(places[row]): reason(error) for row, error in failures}

    def answer(
        self,
        engine: Engine,
        names: list[str],
        rtol: float,
        aspect: Aspect,
        errors: str,
        checked: bool = False,
    ) -> tuple[dict[str, Floats], dict[int, str], list[str]]:
        """Quantities of the rows in their shape, the reasons of failures, and the texts of findings,
        with ``checked`` also those of the scenes."""
        arguments = self, names, rtol, aspect, errors == "raise", None, checked
        columns, failures, findings = _asperity.answer(engine, *arguments)
        reasons = self.failed(failures, errors)
        found = {q: self.shaped(v, np.isnan(v)) for q, v in zip(names, columns, strict=True)}
        return found, reasons, findings
