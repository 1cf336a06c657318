"""Answers on a surface that is known within ranges."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from asperity._arguments import one_scene
from asperity._asperity import Scene

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Ranges:
    """Numbers on a surface that is known within ranges; made by ``asperity.ranges``."""

    #: The numbers in the middle of the ranges of the surface.
    middle: Floats
    #: The smallest numbers, in the middle and at every combination of the ends.
    lower: Floats
    #: The largest numbers.
    upper: Floats
    #: The share of each unknown of the surface in the logarithm of ``upper / lower``, by its name;
    #: NaN for numbers that are not positive.
    shares: dict[str, Floats]


def ranges(scene: Scene, of: Callable[[Scene], Any]) -> Ranges:
    """Numbers of a scene that is known within ranges, as by Ra and a finish: ``of`` a scene gives a
    number or an array, and is called in the middle of the ranges and at each combination of their
    ends.

    >>> import asperity
    >>> steel = asperity.Body(210e9, 0.3, hardness=2e9)
    >>> pair = asperity.Interface.between(steel, steel)
    >>> ground = {"ra": "0.8 um", "finish": "ground"}
    >>> scene = asperity.Scene(pair, {**ground, "counterface": ground}, nominal_area=1e-4)
    >>> model = asperity.model("persson")
    >>> area = lambda one: model.solve(one, pressure=1e6, quantities="area").area
    >>> found = asperity.ranges(scene, area)
    >>> round(float(found.upper / found.lower), 1), round(float(found.shares["mean_slope"]), 2)
    (4.7, 0.96)
    """
    middle, corners, names = one_scene(scene, "ranges")._corners()
    found = np.stack([np.asarray(of(one), dtype=np.float64) for one in (middle, *corners)])
    with np.errstate(divide="ignore", invalid="ignore"):
        logs = np.log(found[1:])
        # Bit k of the place of a corner is 1 at the upper end of unknown k.
        bits = [(np.arange(len(corners)) >> k) & 1 == 1 for k in range(len(names))]
        effects = [np.abs(logs[bit].mean(axis=0) - logs[~bit].mean(axis=0)) for bit in bits]
        shares = {name: effect / sum(effects) for name, effect in zip(names, effects, strict=True)}
    return Ranges(found[0], found.min(axis=0), found.max(axis=0), shares)
