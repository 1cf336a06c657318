"""Arguments as NumPy broadcasts them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from asperity._asperity import Scene, Scenes

Floats: TypeAlias = npt.NDArray[np.float64]
Shape: TypeAlias = tuple[int, ...]
#: One scene, or many in any shape.
SceneLike: TypeAlias = Scene | Scenes | Sequence[Scene] | Sequence[Sequence[Any]] | npt.NDArray[Any]

UNITS = {"force": "N", "area": "m2", "stiffness": "N_per_m", "tangent": "N_per_m"}
SEPARATION_UNITS = ("asperity_height_std", "m")


def quantity_names(quantities: str | Sequence[str]) -> list[str]:
    """One name or several, each once; the engine knows which there are."""
    names = [quantities] if isinstance(quantities, str) else list(quantities)
    if not names:
        raise ValueError(f"quantities is empty: some of {', '.join(UNITS)} were required")
    return list(dict.fromkeys(names))


def in_metres(separation_unit: str) -> bool:
    """Whether separations are in metres."""
    if separation_unit not in SEPARATION_UNITS:
        known = " or ".join(repr(unit) for unit in SEPARATION_UNITS)
        raise ValueError(f"separation_unit is {separation_unit!r}: {known} was required")
    return separation_unit == "m"


def floats(values: npt.ArrayLike) -> Floats:
    """A contiguous array of doubles; complex numbers and texts are refused."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiub":
        raise TypeError(f"numbers of type {array.dtype} were given: real ones were required")
    # ascontiguousarray makes one dimension of none.
    return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)


class Many:
    """Scenes, broadcast against numbers."""

    def __init__(self, scenes: SceneLike, numbers: npt.ArrayLike) -> None:
        self.numbers = floats(numbers)
        self.one: Scene | None = None
        self._scenes_shape: Shape = ()
        self.scenes: Scenes | list[Scene]
        if isinstance(scenes, Scene):
            self.one, self.scenes = scenes, [scenes]
        elif isinstance(scenes, Scenes):
            self.scenes, self._scenes_shape = scenes, scenes.shape
        else:
            array = np.asarray(scenes, dtype=object)
            self.scenes, self._scenes_shape = list(array.ravel()), array.shape
            for k, scene in enumerate(self.scenes):
                if not isinstance(scene, Scene):
                    raise TypeError(f"scene {k} is {scene!r}: a Scene was required")
        self.shape: Shape = np.broadcast_shapes(self._scenes_shape, self.numbers.shape)

    @property
    def index(self) -> npt.NDArray[np.int64]:
        """Which scene each value is of, flat."""
        places = np.arange(int(np.prod(self._scenes_shape)), dtype=np.int64)
        spread = np.broadcast_to(places.reshape(self._scenes_shape), self.shape)
        return np.ascontiguousarray(spread).ravel()

    @property
    def flat(self) -> Floats:
        """The numbers, flat."""
        return np.ascontiguousarray(np.broadcast_to(self.numbers, self.shape)).ravel()

    def scene(self, place: int) -> Scene:
        """One scene, by its place in the order of memory."""
        if isinstance(self.scenes, list):
            return self.scenes[place]
        return self.scenes.reshape(-1)[place]

    def shaped(self, values: Floats) -> Floats:
        """Flat values in the shape of scenes and numbers."""
        return values.reshape(self.shape)
