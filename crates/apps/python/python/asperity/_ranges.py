"""Answers on a scene whose numbers are known within ranges."""

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
    """Numbers of a scene that is known within ranges; made by ``asperity.ranges``."""

    #: The numbers in the middle of the ranges.
    middle: Floats
    #: The smallest numbers, in the middle, at combinations of the ends and at 64 points inside.
    lower: Floats
    #: The largest numbers.
    upper: Floats
    #: The share of each unknown in the logarithm of ``upper / lower``, by its name, as
    #: ``counterface_rq``; NaN for numbers that are not positive.
    shares: dict[str, Floats]


def ranges(scene: Scene, of: Callable[[Scene], Any]) -> Ranges:
    """Numbers of a scene that is known within ranges, as by Ra and a finish: ``of`` a scene gives a
    number or an array, and is called in the middle of the ranges, at combinations of their ends (all
    of up to seven unknowns, 128 of more) and at 64 points inside.

    >>> import asperity
    >>> steel = asperity.Body(210e9, 0.3, hardness=2e9)
    >>> pair = asperity.Interface.between(steel, steel)
    >>> ground = {"ra": "0.8 um", "finish": "ground"}
    >>> scene = asperity.Scene(pair, {**ground, "counterface": ground}, nominal_area=1e-4)
    >>> model = asperity.model("persson")
    >>> area = lambda one: model.solve(one, pressure=1e6, quantities="area").area
    >>> found = asperity.ranges(scene, area)
    >>> round(float(found.upper / found.lower), 1), round(float(found.shares["mean_slope"]), 2)
    (4.7, 0.48)
    """
    points, uppers = one_scene(scene, "ranges")._points()
    found = np.stack([np.asarray(of(one), dtype=np.float64) for one in points])
    with np.errstate(divide="ignore", invalid="ignore"):
        logs = np.log(found[1:])
        # The first points are combinations of ends.
        upper = {name: np.array(ends) for name, ends in uppers.items()}
        effects = {
            name: np.abs(logs[: len(end)][end].mean(axis=0) - logs[: len(end)][~end].mean(axis=0))
            for name, end in upper.items()
        }
        shares = {name: effect / sum(effects.values()) for name, effect in effects.items()}
    return Ranges(found[0], found.min(axis=0), found.max(axis=0), shares)
