"""Many scenes at once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from asperity._asperity import Scene, floats

Floats: TypeAlias = npt.NDArray[np.float64]
Options: TypeAlias = Mapping[str, str | float | Mapping[str, float]]


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
